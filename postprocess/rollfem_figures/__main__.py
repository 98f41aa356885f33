"""python3 -m rollfem_figures DIR: draws DIR/figures/*.svg and writes DIR/report.html; compare.html,
study.html or table.html in the folder of a comparison, a study or a table.
--profile NAME.csv: draws NAME.svg of a wheel or rail profile; --pair NAME.csv: of a wheel on its rail;
--wheelset NAME.csv: radii, angles and conicity over the lateral shift;
--stress DIR: draws what rollfem stress wrote to DIR, to DIR/figures."""
import argparse
import os
import sys


def main():
    parser = argparse.ArgumentParser(prog="rollfem_figures", description=__doc__)
    parser.add_argument("directory", nargs="?", help="a result folder of rollfem run, compare, study or table")
    parser.add_argument("--profile", metavar="NAME.csv", help="draw this table of a profile instead")
    parser.add_argument("--pair", metavar="NAME.csv", help="draw this table of wheel and rail instead")
    parser.add_argument("--wheelset", metavar="NAME.csv", help="draw this table of rollfem wheelset instead")
    parser.add_argument("--stress", metavar="DIR", help="draw this folder of rollfem stress instead")
    options = parser.parse_args()
    given = (options.directory, options.profile, options.pair, options.wheelset, options.stress)
    if sum(o is not None for o in given) != 1:
        parser.error("one of DIR, --profile, --pair, --wheelset and --stress is needed")
    try:
        from .reader import ResultError
    except ImportError as error:
        sys.exit(f"figures need numpy and h5py: {error}\napt install python3-numpy python3-h5py")
    try:
        _draw(options)
    except (ResultError, OSError) as error:
        sys.exit(str(error))


def _draw(options):
    """Loads and runs what the call asks for: the user waits for every module."""
    if options.profile:
        from .profile import draw
        draw(options.profile)
    elif options.pair:
        from .places import draw_pair_file
        draw_pair_file(options.pair)
    elif options.wheelset:
        from .wheelset import draw as draw_wheelset
        draw_wheelset(options.wheelset)
    elif options.stress:
        from .stress_page import build as build_stress
        build_stress(options.stress)
    elif os.path.exists(os.path.join(options.directory, "compare.json")):
        from .compare import build_comparison
        build_comparison(options.directory)
    elif os.path.exists(os.path.join(options.directory, "study.json")):
        from .study import build_study
        build_study(options.directory)
    elif os.path.exists(os.path.join(options.directory, "table.h5")):
        from .table import build as build_table
        build_table(options.directory)
    else:
        from .build import build
        build(options.directory)


if __name__ == "__main__":
    main()
