# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid ball pressed into steel that yields and hardens, and taken away, by CalculiX (`ccx`): the numbers that
tests/verification/plasticity/fem_pressed.cpp holds.

CalculiX gets the pressure of rollfem's steps as a load, means over rings, on an axisymmetric mesh of its own (CAX8R, small
strains; isotropic hardening Q (1 - exp(-b p)) on a yield stress), so that everything below the surface, and the surface
itself, is computed twice. Both let the pressure grow linearly from step to step. Prints, from both, below the middle
plastic strain p of the largest load, and residual stress, radial and axial, and the displacement of the surface that is
left without load (relative to that of the outermost point, because the far boundaries differ):

    PYTHONPATH=build/python python3 benchmarks/calculix/pressed_ball.py
"""

import argparse
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import rollfem
from rolled_line import outward

YOUNG, POISSON, YIELD, RISE, RATE, RADIUS = 210e3, 0.3, 300.0, 300.0, 20.0, 100.0


def solved(forces, cell):
    """rollfem's result of its finite elements."""
    return rollfem.solve(rollfem.Case(
        title="ball", friction={"coefficient": 0.0},
        wheel={"rolling_radius": RADIUS, "transverse_radius": RADIUS, "young_modulus": math.inf},
        rail={"transverse_radius": math.inf, "young_modulus": YOUNG, "poisson_ratio": POISSON},
        rail_plasticity={"yield_stress": YIELD, "isotropic_rise": RISE, "isotropic_rate": RATE},
        rolling={"problem": "frictionless"}, history={"normal_force": forces}, fem={"cell_size": cell}), model="fem")["fem"]


def on_rings(model, point, edges):
    """Mean pressure between radii, MPa."""
    h, parts = model.x[1] - model.x[0], 40
    inside = (np.arange(parts) + 0.5) / parts - 0.5
    x, y = np.meshgrid((model.x[:, None] + h * inside).ravel(), (model.y[:, None] + h * inside).ravel())
    pressure = np.kron(point.pressure, np.ones((parts, parts)))
    force = np.histogram(np.hypot(x, y), edges, weights=pressure * (h / parts)**2)[0]
    return force / (math.pi * np.diff(np.square(edges)))


class Lattice:
    """Nodes of 8-node quadrilaterals on a lattice of half cells, outwards and down."""

    def __init__(self, places):
        self.places, self.cells = places, len(places) - 1

    def node(self, i, k):
        return 1 + i + (2 * self.cells + 1) * k

    def element(self, i, k):
        return 1 + i + self.cells * k

    def deck(self):
        half = np.interp(np.arange(2 * self.cells + 1) / 2, np.arange(self.cells + 1), self.places)
        yield "*NODE, NSET=ALL"
        for k, depth in enumerate(half):
            for i, r in enumerate(half):
                if i % 2 == 0 or k % 2 == 0:
                    yield f"{self.node(i, k)}, {r:.10g}, {-depth:.10g}, 0."
        yield "*ELEMENT, TYPE=CAX8R, ELSET=STEEL"
        for k in range(self.cells):
            for i in range(self.cells):
                a, b = 2 * i, 2 * k
                corners = [(a, b + 2), (a + 2, b + 2), (a + 2, b), (a, b), (a + 1, b + 2), (a + 2, b + 1), (a + 1, b), (a, b + 1)]
                yield ", ".join(map(str, [self.element(i, k), *(self.node(*of) for of in corners)]))
        last = 2 * self.cells
        yield from ["*NSET, NSET=FIXED", *(f"{self.node(i, last)}, {self.node(last, i)}," for i in range(last)),
                    f"{self.node(last, last)},", "*NSET, NSET=AXIS", *(f"{self.node(0, k)}," for k in range(last + 1)),
                    "*NSET, NSET=TOP", *(f"{self.node(i, 0)}," for i in range(last + 1))]


def deck(body, pressures, fine):
    yield from body.deck()
    yield from ["*ELSET, ELSET=MIDDLE", *(f"{body.element(0, k)}," for k in range(fine))]
    yield from ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG}, {POISSON}", "*PLASTIC"]
    for p in (*np.linspace(0.0, 0.02, 41), *np.linspace(0.021, 0.3, 60), 1.0):
        yield f"{YIELD + RISE * (1 - math.exp(-RATE * p)):.10g}, {p:.6g}"
    yield from ["*SOLID SECTION, ELSET=STEEL, MATERIAL=STEEL", "*BOUNDARY", "FIXED, 1, 2", "AXIS, 1, 1"]
    for pressure in pressures:
        yield from ["*STEP, INC=200", "*STATIC", "0.1, 1., 1e-5, 0.1", "*DLOAD"]
        yield from (f"{body.element(i, 0)}, P3, {p:.10g}" for i, p in enumerate(pressure))
        yield from ["*NODE PRINT, NSET=TOP, FREQUENCY=1000", "U", "*EL PRINT, ELSET=MIDDLE, FREQUENCY=1000", "S, PEEQ",
                    "*END STEP"]


def printed(path):
    """[{kind: rows of numbers}] of the steps in the .dat file."""
    steps, rows = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words and words[0] in ("displacements", "stresses", "equivalent"):
            if words[0] == "displacements":
                steps.append({})
            rows = steps[-1].setdefault(words[0], [])
        elif words:
            rows.append([float(w) for w in words])
    return [{kind: np.array(rows) for kind, rows in step.items()} for step in steps]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--forces", type=float, nargs="+", default=[1e3, 2e3, 4e3, 0.0], help="N; the largest before the last")
    parser.add_argument("--cell", type=float, default=0.25, help="mm, of rollfem")
    parser.add_argument("--finer", type=int, default=4, help="cells of CalculiX in one of those")
    parser.add_argument("--extent", type=float, default=30.0, help="mm, of CalculiX")
    parser.add_argument("--folder", help="keeps the deck and the output")
    args = parser.parse_args()
    model = solved(args.forces, args.cell)
    fine = round(3.0 / args.cell) * args.finer
    body = Lattice(outward(args.cell / args.finer, 3.0, args.extent))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(args.folder or temporary)
        pressures = [on_rings(model, point, body.places) for point in model.points]
        (folder / "ball.inp").write_text("\n".join(deck(body, pressures, fine)) + "\n", encoding="utf-8")
        with open(folder / "ball.log", "w", encoding="utf-8") as log:
            subprocess.run(["ccx", "ball"], cwd=folder, stdout=log, stderr=log, check=True)
        steps = printed(folder / "ball.dat")
    stress, strain = (np.array([step[kind][step[kind][:, 0] == body.element(0, k)][:, 2:].mean(axis=0) for k in range(fine)])
                      for step, kind in ((steps[-1], "stresses"), (steps[-2], "equivalent")))
    depth = 0.5 * (body.places[:-1] + body.places[1:])[:fine]
    most, left = (model.points[k].yielded["rail"] for k in (-2, -1))
    middle = int(np.abs(left["y"][0]).argmin())
    writer = csv.writer(sys.stdout)
    writer.writerow(["depth", "p", "p by CalculiX", "radial", "radial by CalculiX", "axial", "axial by CalculiX"])
    for k, at in enumerate(left["depth"][:, middle]):
        pairs = ((most["accumulated"][k, middle], strain[:, 0]), (left["stress"][k, middle, 0], stress[:, 0]),
                 (left["stress"][k, middle, 2], stress[:, 1]))
        writer.writerow([f"{at:.4g}", *(f"{v:.6g}" for here, there in pairs for v in (here, np.interp(at, depth, there)))])
    places, height = (0.5 * np.arange(2 * body.cells + 1), steps[-1]["displacements"][:, 2])
    r = np.interp(places, np.arange(body.cells + 1), body.places)
    there = np.interp(left["surface_y"], r, height)
    writer.writerow(["r", "left", "left by CalculiX"])
    for at, one, other in zip(left["surface_y"], left["groove"] - left["groove"][-1], there - there[-1]):
        writer.writerow([f"{at:.4g}", f"{one:.6g}", f"{other:.6g}"])


if __name__ == "__main__":
    main()
