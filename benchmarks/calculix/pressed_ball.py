# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid ball pressed into steel that yields and hardens, and taken away, by CalculiX (`ccx`): the numbers that
tests/verification/plasticity/fem_pressed.cpp holds.

Axisymmetric (CAX8R), small strains, isotropic hardening Q (1 - exp(-b p)) on a yield stress; the ball, whose nodes all
move alike, sinks in steps and rises again, in frictionless contact by a penalty. Prints for every step the sinking and
the force; of the deepest step and of the last, without load, plastic strain p and stress below the middle, means over
cells; and the surface that is left:

    python3 benchmarks/calculix/pressed_ball.py > ball.csv
"""

import argparse
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from rolled_line import outward

YOUNG, POISSON, YIELD, RISE, RATE, RADIUS = 210e3, 0.3, 300.0, 300.0, 20.0, 100.0


class Lattice:
    """Numbers of nodes and elements of 8-node quadrilaterals on r by z, from given numbers on."""

    def __init__(self, r, z, first_node, first_element):
        self.r, self.z, self.node, self.element = r, z, first_node, first_element

    def number(self, i, k):
        """Of the node at half cells i along r and k along z."""
        return self.node + i + (2 * len(self.r) - 1) * k

    def deck(self, name, height):
        """`height`(r, z): of a node."""
        half = lambda p: np.interp(np.arange(2 * len(p) - 1) / 2, np.arange(len(p)), p)
        yield f"*NODE, NSET={name}"
        for k, z in enumerate(half(self.z)):
            for i, r in enumerate(half(self.r)):
                if i % 2 == 0 or k % 2 == 0:
                    yield f"{self.number(i, k)}, {r:.10g}, {height(r, z):.12g}, 0."
        yield f"*ELEMENT, TYPE=CAX8R, ELSET={name}"
        for k in range(len(self.z) - 1):
            for i in range(len(self.r) - 1):
                a, b = 2 * i, 2 * k
                nodes = [(a, b), (a + 2, b), (a + 2, b + 2), (a, b + 2), (a + 1, b), (a + 2, b + 1), (a + 1, b + 2), (a, b + 1)]
                yield ", ".join(map(str, [self.element + i + (len(self.r) - 1) * k, *(self.number(*n) for n in nodes)]))


def deck(body, ball, sinking, args):
    yield from body.deck("BODY", lambda r, z: z)
    yield from ball.deck("BALL", lambda r, z: z + RADIUS - math.sqrt(RADIUS**2 - r * r))
    columns, rows = len(body.r) - 1, len(body.z) - 1
    yield from ["*NSET, NSET=FIXED", *(f"{body.number(i, 0)}," for i in range(2 * columns + 1)),
                *(f"{body.number(2 * columns, k)}," for k in range(1, 2 * rows + 1)),
                "*NSET, NSET=AXIS", *(f"{body.number(0, k)}," for k in range(2 * rows + 1)),
                "*NSET, NSET=TOP", *(f"{body.number(i, 2 * rows)}," for i in range(2 * args.fine + 1))]
    yield from ["*ELSET, ELSET=MIDDLE", *(f"{body.element + columns * k}," for k in range(rows - args.fine, rows))]
    yield from ["*SURFACE, NAME=UPPER", *(f"{body.element + i + columns * (rows - 1)}, S3" for i in range(args.fine + 4)),
                "*SURFACE, NAME=LOWER", *(f"{ball.element + i}, S1" for i in range(len(ball.r) - 1))]
    yield from ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG}, {POISSON}", "*PLASTIC"]
    for p in (*np.linspace(0.0, 0.02, 41), *np.linspace(0.021, 0.3, 60), 1.0):
        yield f"{YIELD + RISE * (1 - math.exp(-RATE * p)):.10g}, {p:.6g}"
    yield from ["*MATERIAL, NAME=HARD", "*ELASTIC", f"{YOUNG}, {POISSON}", "*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL",
                "*SOLID SECTION, ELSET=BALL, MATERIAL=HARD", "*SURFACE INTERACTION, NAME=TOUCH",
                "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{args.penalty:.6g}, 0.1",
                "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "UPPER, LOWER",
                "*BOUNDARY", "FIXED, 1, 2", "AXIS, 1, 1", "BALL, 1, 1"]
    for depth in sinking:
        yield from ["*STEP, INC=200", "*STATIC", "0.5, 1., 1e-4, 1.", "*BOUNDARY", f"BALL, 2, 2, {-depth:.8g}",
                    "*NODE PRINT, NSET=BALL, TOTALS=ONLY, FREQUENCY=1000", "RF", "*NODE PRINT, NSET=TOP, FREQUENCY=1000", "U",
                    "*EL PRINT, ELSET=MIDDLE, FREQUENCY=1000", "S, PEEQ", "*END STEP"]


def printed(path):
    """[{kind: rows of numbers}] of the steps in the .dat file."""
    steps, rows = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] in ("total", "displacements", "stresses", "equivalent"):
            if words[0] == "total":
                steps.append({})
            rows = steps[-1].setdefault(words[0], [])
        else:
            rows.append([float(w) for w in words])
    return steps


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--cell", type=float, default=0.05, help="mm")
    parser.add_argument("--fine", type=int, default=40, help="cells of this size along r and z")
    parser.add_argument("--extent", type=float, default=30.0, help="mm")
    parser.add_argument("--sinking", type=float, default=0.012, help="mm, the deepest")
    parser.add_argument("--steps", type=int, default=12, help="down; as many up")
    parser.add_argument("--penalty", type=float, default=1e7, help="MPa/mm")
    parser.add_argument("--folder", help="keeps the deck and the output")
    args = parser.parse_args()
    out = outward(args.cell, args.cell * args.fine, args.extent)
    body = Lattice(out, -out[::-1], 1, 1)
    ball = Lattice(args.cell * np.arange(args.fine + 1), np.array([0.0, 0.5]), 1000001, 1000001)
    down = args.sinking * np.arange(1, args.steps + 1) / args.steps
    # At zero force the ball still touches the imprint: it rises to where it cannot any more.
    sinking = np.concatenate([down, args.sinking * np.array([0.9, 0.8, 0.7, 0.0])])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(args.folder or temporary)
        (folder / "ball.inp").write_text("\n".join(deck(body, ball, sinking, args)) + "\n", encoding="utf-8")
        with open(folder / "ball.log", "w", encoding="utf-8") as log:
            subprocess.run(["ccx", "ball"], cwd=folder, stdout=log, stderr=log, check=True)
        steps = printed(folder / "ball.dat")
    writer = csv.writer(sys.stdout)
    writer.writerow(["sinking", "force"])
    for depth, step in zip(sinking, steps):
        writer.writerow([f"{depth:.6g}", f"{-step['total'][0][1]:.6g}"])
    writer.writerow(["step", "depth", "p", "radial", "axial"])
    for number in (args.steps - 1, len(steps) - 1):
        stress, strain = (np.array(steps[number][kind]) for kind in ("stresses", "equivalent"))
        for k, element in enumerate(np.unique(stress[:, 0])[::-1]):
            s, p = (values[values[:, 0] == element][:, 2:].mean(axis=0) for values in (stress, strain))
            writer.writerow([number + 1, f"{(k + 0.5) * args.cell:.4g}", *(f"{v:.6g}" for v in (p[0], s[0], s[1]))])
    writer.writerow(["r", "left"])
    for node, _, height, *_ in steps[-1]["displacements"]:
        writer.writerow([f"{0.5 * args.cell * (node - body.number(0, 2 * len(body.z) - 2)):.4g}", f"{height:.6g}"])


if __name__ == "__main__":
    main()
