#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Are model errors right? For cases a to f, true profiles and random curved bodies: a half-space's estimate of its
model error against its difference from the hybrid, and a theory's against its difference from the half-space.

    benchmarks/model_error.py --program build/app/rollfem -o /tmp/model_error

A difference counts if it exceeds both error bars and 1e-6 of the reference of percentages in docs/results.md: the
value, mu F_z, mu, mu F_z sqrt(ab). Existing runs are reused.
"""

import math
import statistics

import scene_sets

THEORIES = ["hertz", "linear", "vermeulen-johnson", "polach", "carter", "fastsim", "fastrip", "strip"]
QUANTITIES = ["max_pressure", "semi_axis_x", "semi_axis_y", "contact_area", "approach", "traction_coefficient",
              "lateral_force", "spin_moment", "max_traction", "elastic_energy"]

ROUNDING = 1e-4  # percent


def runs(options, scene):
    """Pairs of runs: one whose model errors are checked, and its reference."""
    def run(model, **keys):
        keys = {"contact_grid__elements_across": str(options.across), **keys}
        return scene_sets.run(options.program, options.output, f"{scene.name}_{model}", scene.with_keys(**keys), "--model",
                          model)

    half = run("halfspace", halfspace__model_error="true")
    if options.theories:
        return [(run(name), half) for name in THEORIES]
    return [(half, run("hybrid"))]


def whole_of(point, quantity):
    """Reference of percentages of the quantity (docs/results.md)."""
    bound = point["friction"] * point["normal_force"]
    if quantity in ("lateral_force", "longitudinal_force"):
        return bound
    if quantity == "traction_coefficient":
        return point["friction"]
    if quantity == "spin_moment":
        return bound * math.sqrt(point["semi_axis_x"] * point["semi_axis_y"])
    if quantity == "max_traction":
        return point["friction"] * point["max_pressure"]
    return abs(point[quantity])


def friction_of(scene):
    lines = scene.text.split("[friction]")[1].splitlines()
    return float(next(line for line in lines if line.startswith("coefficient")).split("=")[1].split("#")[0])


def differences(scene, asked, other):
    """Per load point and quantity: (quantity, model, estimate, difference, noise), numbers in percent."""
    rows = []
    friction = friction_of(scene)
    for model in asked["models"]:
        for number, (point, better) in enumerate(zip(model["points"], other["models"][0]["points"])):
            better = {**better, "friction": friction}
            for quantity in QUANTITIES:
                estimate = point.get("model_error", {}).get(quantity)
                if estimate is None or quantity not in better:
                    continue
                part = 100 / whole_of(better, quantity)
                noise = math.hypot(point["error_estimate"].get(quantity, 0.0), better["error_estimate"][quantity])
                rows.append({"scene": scene.name, "kind": scene.kind, "point": number, "quantity": quantity,
                             "model": model["name"], "estimate": part * estimate,
                             "difference": part * (better[quantity] - point[quantity]), "noise": part * noise})
    return rows


def counts(row, least):
    return abs(row["difference"]) > max(row["noise"], ROUNDING, least)


def short(number):
    return f"{number:.2g}" if number < 100 else f"{number:.0f}"


def line(name, rows, least):
    counted = [row for row in rows if counts(row, least)]
    if not counted:
        return f"| {name} | {len(rows)} | 0 | | | | | |"
    ratios = sorted(row["estimate"] / abs(row["difference"]) for row in counted)
    within = sum(0.5 <= ratio <= 2 for ratio in ratios)
    enough = sum(ratio >= 0.5 for ratio in ratios)
    sizes = [abs(row["difference"]) for row in counted]
    return (f"| {name} | {len(rows)} | {len(ratios)} | {100 * within / len(ratios):.0f} | {100 * enough / len(ratios):.0f} | "
            f"{statistics.median(ratios):.2f} | {short(ratios[0])} to {short(ratios[-1])} | "
            f"{short(statistics.median(sizes))}, {short(max(sizes))} |")


HEAD = ("| numbers | above the bars | within a factor of 2, % | at least half, % | median of estimate / difference | from, to | "
        "difference, %: median, largest |\n|---|---|---|---|---|---|---|---|")


def print_tables(rows, theories, least=0.0):
    groups = [("quantity", lambda row: row["quantity"]), ("scenes", lambda row: row["kind"])]
    if theories:
        groups.append(("theory", lambda row: row["model"]))
    for title, key in groups:
        print(f"| {title} {HEAD}")
        names = list(dict.fromkeys(key(row) for row in rows))
        for name in names:
            print(line(name, [row for row in rows if key(row) == name], least))
        print(line("all", rows, least))
        print()


def print_worst(rows, count):
    """Estimates wrong by more than a factor of two, the largest differences first."""
    off = [row for row in rows if counts(row, 0.0)
           and not 0.5 <= row["estimate"] / abs(row["difference"]) <= 2]
    for row in sorted(off, key=lambda row: -max(abs(row["difference"]), row["estimate"]))[:count]:
        print(f"{row['scene']} {row['model']} {row['point'] + 1} {row['quantity']}: estimate {row['estimate']:.3g} %, "
              f"difference {row['difference']:.3g} %, noise {row['noise']:.2g} %")


def main():
    parser = scene_sets.parser(__doc__)
    parser.add_argument("--randoms", type=int, default=40, help="number of random scenes beside the 20 fixed ones")
    parser.add_argument("--across", type=int, default=80)
    parser.add_argument("--theories", action="store_true", help="theories against the half-space")
    parser.add_argument("--least", type=float, default=0.0, help="percent; ignore smaller differences")
    parser.add_argument("--worst", type=int, default=0, help="number of wrong estimates to show")
    options = parser.parse_args()
    scene_sets.prepare(options.output)
    rows = []
    for scene in scene_sets.scenes(options.seed, options.randoms):
        for asked, other in runs(options, scene):
            failed = [run["failed"] for run in (asked, other) if "failed" in run]
            if failed and not options.theories:
                print(f"{scene.name}: {failed[0]}")
            if not failed:  # a theory may refuse a scene
                rows += differences(scene, asked, other)
    print_tables(rows, options.theories, options.least)
    print_worst(rows, options.worst)


if __name__ == "__main__":
    main()
