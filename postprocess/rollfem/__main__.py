# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m rollfem PATH: draws what rollfem has written to PATH.

A result folder gets figures/*.svg and report.html; the folder of a comparison, a study or a table compare.html,
study.html or table.html; stress.json of `rollfem stress` stress.html and figures beside it; the table NAME.csv of a
profile, of a wheel on its rail or of a wheelset NAME.svg."""
import argparse
import sys

from .figures.catalogue import build


def main() -> None:
    parser = argparse.ArgumentParser(prog="rollfem", description=__doc__)
    parser.add_argument("path", help="a folder, stress.json or NAME.csv written by rollfem")
    try:
        build(parser.parse_args().path)
    except OSError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
