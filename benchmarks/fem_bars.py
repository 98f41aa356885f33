#!/usr/bin/env python3
"""Do the error bars of finite elements hold? Random contacts from a seed, each solved with cells of a part of its
smaller semi-axis and again with cells of half that size: how often a quantity's bar covers the change, and how much
larger it is.

    benchmarks/fem_bars.py --program build/app/rollfem --seed 1 --count 40 --parts 8 -o /tmp/fem_bars

Runs that are there already are read again, so that more can be added later.
"""

import argparse
import json
import math
import random
import statistics
import subprocess
from pathlib import Path


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def random_case(seed, number):
    """A case as text but for [fem]; curvatures along and across differ by a factor of 6 at most."""
    draw = random.Random(1000003 * seed + number)
    while True:
        wheel, rail = draw.uniform(300, 500), log_uniform(draw, 60, 2000)
        across = draw.choice(["inf", "convex", "concave"])
        radii = {"inf": math.inf, "convex": log_uniform(draw, 150, 2000), "concave": -draw.uniform(1.3, 6) * rail}
        side = radii[across]
        along, beside = 1 / wheel, 1 / rail + 1 / side
        if 1 / 6 < along / beside < 6:
            break
    young = [210e3, 210e3 if draw.random() < 0.8 else 70e3]
    creepage = [log_uniform(draw, 2e-4, 5e-3) * draw.choice([-1, 1]), 0.0, 0.0]
    if draw.random() < 0.5:
        creepage[1:] = [draw.uniform(-2e-3, 2e-3), draw.uniform(-3e-4, 3e-4)]
    text = f"""title = "random contact {number} of seed {seed}"
[load]
normal_force = {log_uniform(draw, 5e3, 100e3):.6g}
[friction]
coefficient = {draw.uniform(0.1, 0.6):.4f}
[wheel]
rolling_radius = {wheel:.6g}
transverse_radius = {side:.6g}
young_modulus = {young[0]:g}
poisson_ratio = {draw.uniform(0.2, 0.4):.3f}
[rail]
transverse_radius = {rail:.6g}
young_modulus = {young[1]:g}
poisson_ratio = {draw.uniform(0.2, 0.4):.3f}
[rolling]
longitudinal_creepage = {creepage[0]:.5g}
lateral_creepage = {creepage[1]:.5g}
spin = {creepage[2]:.5g}
[output]
fields = false
"""
    return text


def smaller_semi_axis(program, text, folder):
    run(program, text, "hertz", folder)
    point = point_of(folder)
    return min(point["semi_axis_x"], point["semi_axis_y"])


def run(program, text, model, folder):
    if (folder / "summary.json").exists():
        return
    case = folder.with_suffix(".toml")
    case.write_text(text)
    subprocess.run([program, "run", str(case), "--model", model, "-o", str(folder)], check=True, capture_output=True)


def point_of(folder):
    return json.loads((folder / "summary.json").read_text())["models"][0]["points"][0]


def compare(options):
    ratios = {}
    for number in range(options.first, options.first + options.count):
        text = random_case(options.seed, number)
        name = options.output / f"{options.seed}_{number}"
        try:
            size = smaller_semi_axis(options.program, text, Path(f"{name}_hertz"))
            points = []
            for parts in (options.parts, 2 * options.parts):
                folder = Path(f"{name}_{parts:g}")
                mesh = f"[fem]\ncell_size = {size / parts:.6g}\nextent = {options.extent * size:.6g}\n"
                run(options.program, text + mesh, "fem", folder)
                points.append(point_of(folder))
        except subprocess.CalledProcessError as error:
            print(f"contact {number}: {error.stderr.decode().strip().splitlines()[-1]}")
            continue
        for quantity, bar in points[0]["error_estimate"].items():
            if quantity in points[0] and quantity in points[1]:
                change = abs(points[0][quantity] - points[1][quantity])
                if bar > 0 or change > 0:
                    ratios.setdefault(quantity, []).append(bar / change if change > 0 else math.inf)
        print(f"contact {number} done", flush=True)
    print("| quantity | contacts | covered, % | median bar over change | least |\n|---|---|---|---|---|")
    for quantity, of in sorted(ratios.items()):
        covered = 100 * sum(ratio >= 1 for ratio in of) / len(of)
        print(f"| {quantity} | {len(of)} | {covered:.0f} | {statistics.median(of):.2g} | {min(of):.2g} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="the program rollfem, built with finite elements")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first contact")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--parts", type=float, default=8, help="cells to the smaller semi-axis; twice in the finer run")
    parser.add_argument("--extent", type=float, default=12, help="of the segments, in smaller semi-axes")
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    compare(options)


if __name__ == "__main__":
    main()
