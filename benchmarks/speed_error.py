#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws error against seconds on benchmark 9 and writes the tables of docs/benchmarks.md.

usage: benchmarks/speed_error.py BENCHMARK_PROGRAM OUTPUT_FOLDER [--from RESULTS.json]

Runs BENCHMARK_PROGRAM (built as benchmark_halfspace), or reads the results of an earlier run in
OUTPUT_FOLDER/speed_error.json or RESULTS.json, and writes speed_error.svg, .png and .json there.
"""
import argparse
import json
import os
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Converged values, bracketed by two schemes at 320 elements across (docs/theory.md): the fitted edge converges from
# above (10 251.0 N, 1173.2 N mm), second order everywhere from below (10 245.0 N, 1161.5 N mm).
FX, MZ = 10250.0, -1168.0

# CONTACT rev 2707 on the same problem (gfortran 12 -O3, FFTW, one thread), in one run with rollfem on two quiet
# cores of the same kind, where rollfem took 0.037, 0.121 and 0.46 s on 40, 80 and 160 across: contact elements,
# user seconds with GDsteady, F_x, M_z.
CONTACT = [
    (1264, 0.14, 10400.0, -1592.0),
    (5024, 0.62, 10320.0, -1364.0),
    (11348, 2.22, 10290.0, -1289.0),
]

SERIES = [
    ("steady_rolling/fitted_edge", "rollfem, fitted leading edge (default)", "#0b5394", "o-"),
    ("steady_rolling/second_order", "rollfem, second order everywhere", "#6fa8dc", "s--"),
    ("steady_rolling/first_order", "rollfem, first order", "#999999", "^--"),
    ("fastsim", "FASTSIM", "#38761d", "v-"),
    ("strip", "strip model", "#b45f06", "D-"),
]


def measured(program, folder, given):
    """Medians of the benchmark's rows: name -> list of (n, seconds, counters)."""
    path = given or os.path.join(folder, "speed_error.json")
    if not given:
        subprocess.run(
            [program, "--benchmark_filter=normal_problem|steady_rolling|fastsim|strip",
             "--benchmark_out=" + path, "--benchmark_out_format=json"], check=True)
    with open(path, encoding="utf-8") as file:
        rows = json.load(file)["benchmarks"]
    table = {}
    for row in rows:
        name, n = row["name"].rsplit("/", 1)
        table.setdefault(name, []).append((int(n), row["cpu_time"] / 1e3, row))
    return table


def error(value, exact):
    return 100.0 * abs(value / exact - 1.0)


def draw(table, folder):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.9), sharex=True)
    for axis, counter, exact, name, target in (
            (axes[0], "Fx", FX, "longitudinal force", 0.5), (axes[1], "Mz", MZ, "spin moment", 5.0)):
        for key, label, colour, style in SERIES:
            rows = table.get(key, [])
            axis.loglog([s for _, s, _ in rows], [error(r[counter], exact) for _, _, r in rows],
                        style, color=colour, label=label, markersize=5, linewidth=1.4)
        column = 2 if counter == "Fx" else 3
        axis.loglog([row[1] for row in CONTACT], [error(row[column], exact) for row in CONTACT],
                    "*", color="#cc0000", markersize=11, label="CONTACT, GDsteady")
        axis.axhline(target, color="#bbbbbb", linewidth=0.8, linestyle=":")
        axis.set_xlabel("CPU seconds, one core")
        axis.set_ylabel(f"error of the {name}, %")
        axis.grid(True, which="major", color="#e6e6e6", linewidth=0.7)
    figure.suptitle("Combined creepage and spin on a circular patch (benchmark 9): error against time",
                    fontsize=11)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, fontsize=9, frameon=False, loc="lower center", ncol=3)
    figure.tight_layout(rect=(0.0, 0.1, 1.0, 1.0))
    figure.savefig(os.path.join(folder, "speed_error.svg"), metadata={"Date": None})
    figure.savefig(os.path.join(folder, "speed_error.png"), dpi=110)


def print_tables(table):
    print("| scheme | n | contact elements | CPU s | F_x N | error | M_z N mm | error |")
    print("|---|---|---|---|---|---|---|---|")
    for key, label, _, _ in SERIES:
        for n, seconds, row in table.get(key, []):
            elements = f"{row['elements']:.0f}" if "elements" in row else ""
            print(f"| {label} | {n} | {elements} | {seconds:.4f} | {row['Fx']:.1f} | "
                  f"{error(row['Fx'], FX):.2f} % | {row['Mz']:.0f} | {error(row['Mz'], MZ):.1f} % |")
    for elements, seconds, fx, mz in CONTACT:
        print(f"| CONTACT, GDsteady | | {elements} | {seconds} | {fx:.0f} | {error(fx, FX):.2f} % | "
              f"{mz:.0f} | {error(mz, MZ):.1f} % |")
    print("\n| normal problem, n | contact elements | CPU s | iterations | error of p0 |")
    print("|---|---|---|---|---|")
    for n, seconds, row in table.get("normal_problem", []):
        print(f"| {n} | {row['elements']:.0f} | {seconds:.4f} | {row['iterations']:.0f} | "
              f"{100 * row['p0_error']:.4f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built benchmark_halfspace")
    parser.add_argument("folder", help="folder for the figure")
    parser.add_argument("--from", dest="given", help="results of an earlier run (JSON)")
    arguments = parser.parse_args()
    if not arguments.given and not os.access(arguments.program, os.X_OK):
        sys.exit(f"{arguments.program}: not a program; build the target benchmark_halfspace")
    os.makedirs(arguments.folder, exist_ok=True)
    table = measured(arguments.program, arguments.folder, arguments.given)
    draw(table, arguments.folder)
    print_tables(table)


if __name__ == "__main__":
    main()
