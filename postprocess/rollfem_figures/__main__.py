# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m rollfem_figures PATH: draws the output of rollfem in PATH.

A result folder gets figures/*.svg and report.html; the folder of a comparison, a study or a table compare.html,
study.html or table.html; stress.json of `rollfem stress` stress.html and figures beside it; the table NAME.csv of a
profile, of a wheel on its rail or of a wheelset NAME.svg."""
import argparse
import importlib
import os
import sys

from .reader import ResultError, read_rows

# Module whose build(path) draws, by a characteristic file of the folder, and by a characteristic column of the table.
OF_FOLDER = (("compare.json", "compare"), ("study.json", "study"), ("table.h5", "table"), ("", "report"))
OF_TABLE = (("part", "profiles"), ("conicity_wave", "positions"), ("curvature", "profiles"))


def main():
    parser = argparse.ArgumentParser(prog="rollfem_figures", description=__doc__)
    parser.add_argument("path", help="a folder, stress.json or NAME.csv written by rollfem")
    path = parser.parse_args().path
    try:
        # Loads only the modules of the call, because the user waits for each of them.
        importlib.import_module(f".{_module_of(path)}", __package__).build(path)
    except (ResultError, OSError) as error:
        sys.exit(str(error))


def _module_of(path):
    """The module that draws the content of a path."""
    if os.path.basename(path) == "stress.json":
        return "stress_page"
    if not path.endswith(".csv"):
        return next(module for name, module in OF_FOLDER if os.path.exists(os.path.join(path, name)) or not name)
    columns = next(iter(read_rows(path)[1]), ())
    for column, module in OF_TABLE:
        if column in columns:
            return module
    raise ResultError(f"{path}: no figure exists for this table; allowed: tables of rollfem profile and rollfem wheelset")


if __name__ == "__main__":
    main()
