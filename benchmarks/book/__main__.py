# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m book: writes the verification book. Called by `./rollfem book`, which builds first."""
import argparse
import contextlib
import datetime
import json
import os
import platform
import sys
import time

from .owner import Owned, owner


def _parser():
    parser = argparse.ArgumentParser(
        prog="./rollfem book", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Recomputes every benchmark and writes the verification book: README.md, its\n"
                    "figures (.svg) and book.json.",
        epilog="example: ./rollfem book --only carter cattaneo -o /tmp/book\n"
               "Exit status: 0 all numbers are within their tolerances; 1 one is not, or a run failed;\n"
               "2 the call is wrong.")
    parser.add_argument("-o", "--output", metavar="DIR",
                        help="folder for the book (default: docs/book of the source; with --only "
                             "results/book_only)")
    parser.add_argument("--only", nargs="+", metavar="CHAPTER",
                        help="these chapters only (see --list), as a book of their own")
    parser.add_argument("--list", action="store_true", help="list the chapters and exit")
    parser.add_argument("--results", metavar="DIR",
                        help="folder of the runs (default: results/book). Existing runs of the "
                             "same program and case are reused")
    parser.add_argument("--fresh", action="store_true", help="recompute existing runs")
    parser.add_argument("--png", metavar="DIR", help="folder for additional bitmaps of the figures")
    parser.add_argument("--check", action="store_true",
                        help="as a test: judge numbers only, without finite elements where a chapter does without, and "
                             "write neither pages nor figures")
    parser.add_argument("--quiet", action="store_true", help="print the verdict only")
    parser.add_argument("--root", help=argparse.SUPPRESS)
    parser.add_argument("--build", help=argparse.SUPPRESS)
    return parser


def _wanted(parser, options, known):
    names = [chapter.__name__.replace("_", "-") for chapter in known]
    for name in options.only or []:
        if name not in names:
            parser.error(f"--only {name}: unknown chapter; allowed: {', '.join(names)}")
    return [c for c, name in zip(known, names) if not options.only or name in options.only]


def _folder(parser, options, root, wanted):
    """The folder of the book. A part of the book must not replace one that has other chapters."""
    place = ["docs", "book"] if not options.only else ["results", "book_only"]
    directory = os.path.abspath(options.output or os.path.join(root, *place))
    if options.only and options.output:
        try:
            with open(os.path.join(directory, "book.json"), encoding="utf-8") as file:
                there = {chapter["name"] for chapter in json.load(file)["chapters"]}
        except (OSError, ValueError, KeyError):
            there = set()
        lost = len(there - {chapter.__name__.replace("_", "-") for chapter in wanted})
        if lost:
            parser.error(f"--only would remove the other chapters ({lost}) of the book in {directory}; "
                         "do: name another folder with -o, or omit --only")
    return directory


def _machine():
    """Cores and processor, needed to interpret the cost of a run."""
    model = platform.processor() or platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            model = next((line.split(":")[1].strip() for line in file if line.startswith("model name")), model)
    except OSError:
        pass
    return f"{len(os.sched_getaffinity(0))} cores of {model}"


def _make(bench, chapters, say):
    """Returns (chapters, [(name, why left out)], [failure message])."""
    from .runs import BookError
    made, left_out, failures = [], [], []
    for function in chapters:
        name = function.__name__.replace("_", "-")
        if getattr(function, "needs_fem", False) and not bench.built_with_fem:
            left_out.append((name, "needs finite elements, which this build lacks"))
            continue
        say(f"chapter {name}")
        try:
            made.append(function(bench))
        except BookError as error:
            failures.append(f"{name}: {error}")
            left_out.append((name, "its run failed"))
    return made, left_out, failures


def main():
    parser = _parser()
    options = parser.parse_args()
    root = os.path.abspath(options.root or os.path.join(os.path.dirname(__file__), "..", ".."))
    try:
        from . import chapters as all_chapters, page
        from .runs import Bench, BookError
        from . import style
    except ImportError as error:
        sys.exit(f"the book needs numpy, matplotlib and h5py: {error}; do: apt install python3-matplotlib "
                 "python3-h5py")
    if options.list:
        for chapter in all_chapters.ALL:
            print(f"{chapter.__name__.replace('_', '-'):22} {chapter.__doc__.strip().splitlines()[0]}")
        return 0
    wanted = _wanted(parser, options, all_chapters.ALL)
    directory = _folder(parser, options, root, wanted)
    say = (lambda text: None) if options.quiet else (lambda text: print(text, flush=True))
    begin = time.time()
    results = os.path.abspath(options.results or os.path.join(root, "results", "book"))
    owned = contextlib.ExitStack()
    try:
        for folder in sorted({results} if options.check else {directory, results}):
            owned.enter_context(owner(folder, " ".join(["./rollfem book", *sys.argv[1:]])))
        if not options.check:
            os.makedirs(directory, exist_ok=True)
        bench = Bench(root, options.build or os.path.join(root, "build"), results, options.fresh, say)
        style.use()
        bench.figures, bench.png, bench.small = directory, options.png, options.check
        bench.has_fem = bench.built_with_fem and not options.check
        done, left_out, failures = _make(bench, wanted, say)
        made = {"command": "./rollfem book" + (f" --only {' '.join(options.only)}" if options.only else ""),
                "version": bench.version, "host": _machine(), "date": datetime.date.today().isoformat(),
                "seconds": sum(c.seconds for chapter in done for c in chapter.cost)}
        if not options.check:
            page.write_book(directory, done, left_out, made)
    except Owned as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except (BookError, OSError) as error:
        sys.exit(f"error: {error}")
    finally:
        owned.close()
    beyond = [f"{c.title}: {row.quantity} {row.by}: {page.percent(row.difference)}, allowed "
              f"{page.percent(row.allowed)[1:]}" for c in done for row in c.rows if not row.holds]
    for text in failures + beyond:
        print(f"error: {text}", file=sys.stderr)
    judged = sum(row.allowed is not None for c in done for row in c.rows)
    print(f"{judged} numbers are judged, {len(beyond) or 'none'} beyond their tolerances; "
          f"{time.time() - begin:.0f} s" + ("" if options.check else f"\nbook: {os.path.join(directory, 'README.md')}"))
    return 1 if failures or beyond else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("interrupted: finished runs are kept; the same command resumes", file=sys.stderr)
        sys.exit(130)
