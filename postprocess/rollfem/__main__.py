# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m rollfem PATH [OVERLAY.csv ...]: draws what rollfem has written to PATH.

A result folder gets figures/*.svg and report.html; the folder of a comparison, a study or a table compare.html,
study.html or table.html; stress.json of `rollfem stress` stress.html and figures beside it; the table NAME.csv of a
profile, of a wheel on its rail or of a wheelset NAME.svg. Tables OVERLAY.csv of measured creep curves are drawn over those of a
result.

The program runs its commands study, compare, bench and stress as python3 -m rollfem COMMAND OPTIONS."""
import sys

from .figures.page import build


def main() -> None:
    if sys.argv[1:2] in (["study"], ["compare"], ["bench"], ["stress"]) and len(sys.argv) == 3:
        try:
            from .commands.line import main as command
        except ImportError as error:
            advice = "" if "do: " in str(error) else "; do: install python3-numpy and python3-h5py"
            sys.stderr.write(f"rollfem: {sys.argv[1]}: {error}{advice}\n")
            sys.exit(2)
        command(*sys.argv[1:])
        return
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    try:
        build(sys.argv[1], sys.argv[2:])
    except OSError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
