#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kalker's creepage coefficients to five digits, with error bars: the source of
halfspace/closed_forms/kalker.cpp.

Uses the series of benchmarks/book/linear_theory.py, at the ratios of the C++ table or at given ones.
"""
import argparse
import csv
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
from book.linear_theory import coefficients  # noqa: E402

SHORT = [0.01, 0.02, 0.05, *(k / 10 for k in range(1, 11))]
RATIOS = SHORT + [1 / r for r in SHORT[-2::-1]]
POISSON = [0.0, 0.125, 0.25, 0.375, 0.5]
NAMES = ("C11", "C22", "C23", "C33")


def computed(ratios, degree, store):
    """{ratio: {nu: {name: (value, bar)}}}; values in the file `store` are reused."""
    known = {}
    if store and os.path.exists(store):
        with open(store, encoding="utf-8") as file:
            known = json.load(file)
    for ratio in ratios:
        key = f"{ratio:.6f}"
        if key not in known:
            known[key] = {f"{nu:g}": c for nu, c in coefficients(ratio, POISSON, degree).items()}
            print(f"a/b = {ratio:g}", file=sys.stderr, flush=True)
            if store:
                with open(store, "w", encoding="utf-8") as file:
                    json.dump(known, file)
    return {ratio: {nu: known[f"{ratio:.6f}"][f"{nu:g}"] for nu in POISSON} for ratio in ratios}


def rows_of_cpp(table):
    """The initialiser of the table: one row per ratio, one entry per Poisson's ratio."""
    for ratio, row in table.items():
        entries = ["{" + ", ".join(f"{row[nu][name][0]:.6g}" for name in NAMES) + "}" for nu in POISSON]
        yield f"    {{{ratio:.9g}, {{{{{', '.join(entries)}}}}}}},"


def compared(table, path):
    """A line for every printed value (csv: a_over_b, nu, C11, ...) whose error exceeds its last digit."""
    with open(path, encoding="utf-8") as file:
        for line in csv.DictReader(row for row in file if not row.startswith("#")):
            ratio = min(table, key=lambda r: abs(r / float(line["a_over_b"]) - 1))
            for name in NAMES:
                value, bar = table[ratio][float(line["nu"])][name]
                digits = len(line[name].partition(".")[2])
                if abs(float(line[name]) - value) > 0.5 * 10**-digits + bar:
                    yield (f"a/b = {ratio:<8.4g} nu = {line['nu']:<5} {name}: printed {line[name]:>6}, computed "
                           f"{value:.5g} +- {bar:.1g} ({100 * (float(line[name]) / value - 1):+.2f} %)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ratio", type=float, nargs="+", default=RATIOS, help="a/b (default: those of the table)")
    parser.add_argument("--degree", type=int, default=14, help="degree of the series; the bar is the change from a degree lower by 4")
    parser.add_argument("--store", metavar="FILE", help="JSON file of computed values, reused by the next call")
    parser.add_argument("--cpp", action="store_true", help="print the rows of kalker.cpp")
    parser.add_argument("--against", metavar="CSV", help="list the printed values with errors")
    options = parser.parse_args()
    table = computed(options.ratio, options.degree, options.store)
    if options.cpp:
        print("\n".join(rows_of_cpp(table)))
    elif options.against:
        print("\n".join(compared(table, options.against)))
    else:
        print("a/b       nu     " + "".join(f"{name:<21}" for name in NAMES) + "C23 + C32")
        for ratio, row in table.items():
            for nu in POISSON:
                print(f"{ratio:<9.5g} {nu:<6g} " + "".join(f"{v:<9.5g} +- {bar:<8.1g}" for v, bar in
                                                          (row[nu][name] for name in NAMES))
                      + f"{row[nu]['C23'][0] + row[nu]['C32'][0]:+.1g}")


if __name__ == "__main__":
    main()
