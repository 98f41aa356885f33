# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steel that yields under a moving line contact, by CalculiX (`ccx`): the numbers that
tests/verification/plasticity/fem_calculix.cpp holds.

A block in plane strain (CPE8R) with Prager's hardening, clamped at bottom and ends; Hertz's pressure, half-width 1 mm,
with friction everywhere, is moved step by step over it. Prints, below the middle of the block after each pass, depth,
plastic strain xz, residual stress xx and yy over p0, means over cells:

    python3 benchmarks/calculix/rolled_line.py --friction 0.2 > line.csv

Without NLGEOM, CalculiX 2.20 changes the back stress with the wrong sign (incplas_lin.f), so that one element in
monotonic shear softens. With NLGEOM it hardens as it should, but strains are finite. Theory has small ones, so moduli
are STIFFER times as large here and strains as small.
"""

import argparse
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

YOUNG, POISSON, SHEAR_YIELD = 210e3, 0.3, 300.0
HARDENING = YOUNG / 20.0
STIFFER = 100.0


def outward(first, fine, extent, growth=1.3):
    """Distances from 0: equal steps as far as `fine`, then growing ones."""
    equal = round(fine / first)
    count = 1
    while sum(first * growth**(k + 1) for k in range(count)) < extent - fine:
        count += 1
    low, high = 1.0, growth
    for _ in range(60):
        ratio = 0.5 * (low + high)
        total = sum(first * ratio**(k + 1) for k in range(count))
        low, high = (ratio, high) if total < extent - fine else (low, ratio)
    return np.concatenate([[0.0], np.cumsum([first] * equal + [first * ratio**(k + 1) for k in range(count)])])


class Block:
    """Nodes of 8-node quadrilaterals on a lattice of half cells; x from the middle, z = -depth."""

    def __init__(self, cell, travel, extent, rows=()):
        """`rows`: heights of thinner rows at the surface."""
        half = outward(cell, travel + 1.5, extent)
        self.x = np.concatenate([-half[:0:-1], half])
        below = np.cumsum([0.0, *rows])
        self.depth = np.concatenate([below, below[-1] + outward(cell, 2.0 - below[-1], extent - below[-1])[1:]])
        self.fine = len(rows) + round((2.0 - below[-1]) / cell)
        self.cell = cell

    def number(self, i, k):
        """Of the node at half cells i along and k down."""
        return 1 + i + (2 * len(self.x) - 1) * k

    def deck_of_mesh(self):
        between = lambda p: np.interp(np.arange(2 * len(p) - 1) / 2, np.arange(len(p)), p)
        x, depth = between(self.x), between(self.depth)
        yield "*NODE, NSET=ALL"
        for k, d in enumerate(depth):
            for i, place in enumerate(x):
                if i % 2 == 0 or k % 2 == 0:
                    yield f"{self.number(i, k)}, {place:.10g}, {-d:.10g}, 0."
        yield "*ELEMENT, TYPE=CPE8R, ELSET=SOLID"
        for k in range(len(self.depth) - 1):
            for i in range(len(self.x) - 1):
                a, b = 2 * i, 2 * k
                nodes = [(a, b + 2), (a + 2, b + 2), (a + 2, b), (a, b), (a + 1, b + 2), (a + 2, b + 1), (a + 1, b),
                         (a, b + 1)]
                yield ", ".join(map(str, [1 + i + (len(self.x) - 1) * k, *(self.number(*n) for n in nodes)]))
        yield "*NSET, NSET=FIXED"
        last, bottom = 2 * len(self.x) - 2, 2 * len(self.depth) - 2
        for k in range(bottom + 1):
            yield f"{self.number(0, k)}, {self.number(last, k)},"
        for i in range(1, last):
            yield f"{self.number(i, bottom)},"

    def middle(self):
        """Elements of the column right of the middle, fine ones only, from the surface down."""
        column = len(self.x) // 2
        return [1 + column + (len(self.x) - 1) * k for k in range(self.fine)]

    def forces(self, centre, p0, friction):
        """{node on the surface: (force along, force upwards)}: means over elements, consistent with their shape."""
        below = lambda x: 0.5 * (x * math.sqrt(1 - x * x) + math.asin(x))
        force = {}
        for i, (left, right) in enumerate(zip(self.x, self.x[1:])):
            ends = [min(max(end - centre, -1.0), 1.0) for end in (left, right)]
            total = p0 * (below(ends[1]) - below(ends[0]))
            for node, share in ((2 * i, 1 / 6), (2 * i + 1, 2 / 3), (2 * i + 2, 1 / 6)):
                force[node] = force.get(node, 0.0) + share * total
        return {self.number(node, 0): (friction * f, -f) for node, f in force.items()}


def deck(block, args):
    p0 = args.load * SHEAR_YIELD
    yield from block.deck_of_mesh()
    yield from ["*ELSET, ELSET=MIDDLE", *(f"{e}," for e in block.middle())]
    stress = math.sqrt(3.0) * SHEAR_YIELD
    yield from ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{STIFFER * YOUNG}, {POISSON}", "*PLASTIC, HARDENING=KINEMATIC",
                f"{stress:.10g}, 0.", f"{stress + STIFFER * HARDENING:.10g}, 1.",
                "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL", "1.", "*BOUNDARY", "FIXED, 1, 2"]
    steps = round(2 * args.travel / (args.step * block.cell))
    before = set()
    for _ in range(args.passes):
        for k in range(steps + 2):
            centre = -args.travel + k * args.step * block.cell
            forces = block.forces(centre, p0, args.friction) if k <= steps else {}
            now = {n for n, f in forces.items() if f[1] != 0.0}
            # More iterations before an increment is halved: plastic zones that move take them.
            yield from ["*STEP, INC=50, NLGEOM", "*STATIC", "1., 1.", "*CONTROLS, PARAMETERS=TIME INCREMENTATION",
                        "12, 16, 18, 30, 10, 4, , 8", "*CLOAD"]
            for node in sorted(now | before):
                along, up = forces.get(node, (0.0, 0.0))
                yield f"{node}, 1, {along:.10g}"
                yield f"{node}, 2, {up:.10g}"
            before = now
            done = k == steps + 1
            yield from ["*NODE PRINT, NSET=ALL, FREQUENCY=0", "U"]
            # A large frequency prints the last increment of the step alone.
            yield from [f"*EL PRINT, ELSET=MIDDLE, FREQUENCY={1000 if done else 0}", "S, E", "*END STEP"]


def printed(path):
    """Blocks of the .dat file: [{(element, point): six values}], stress and strain in turn."""
    blocks = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] in ("stresses", "strains"):
                blocks.append({})
            elif len(words) == 8 and blocks:
                blocks[-1][int(words[0]), int(words[1])] = np.array([float(w) for w in words[2:]])
    return blocks


def rows(block, args, blocks):
    """(pass, depth, plastic strain xz, residual xx / p0, residual yy / p0), y across, means over the cells."""
    p0, shear = args.load * SHEAR_YIELD, YOUNG / (2 + 2 * POISSON)
    for number in range(args.passes):
        stress, strain = blocks[2 * number], blocks[2 * number + 1]
        for k, element in enumerate(block.middle()):
            s, e = (np.mean([v for (of, _), v in values.items() if of == element], axis=0)
                    for values in (stress, strain))
            # CalculiX: x along, y up, z across; order xx yy zz xy xz yz.
            plastic = STIFFER * e[3] - s[3] / (2 * shear)
            yield number + 1, 0.5 * (block.depth[k] + block.depth[k + 1]), plastic, s[0] / p0, s[2] / p0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    for name, value in (("load", 3.9), ("friction", 0.0), ("travel", 6.0), ("extent", 20.0), ("step", 0.5)):
        parser.add_argument(f"--{name}", type=float, default=value)
    parser.add_argument("--passes", type=int, default=1)
    parser.add_argument("--cells", type=int, default=8, help="per half-width")
    parser.add_argument("--rows", type=float, nargs="*", default=[], help="heights of rows at the surface, half-widths")
    parser.add_argument("--folder", help="keeps the deck and the output")
    args = parser.parse_args()
    block = Block(1.0 / args.cells, args.travel, args.extent, args.rows)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(args.folder or temporary)
        (folder / "line.inp").write_text("\n".join(deck(block, args)) + "\n", encoding="utf-8")
        with open(folder / "line.log", "w", encoding="utf-8") as log:
            subprocess.run(["ccx", "line"], cwd=folder, stdout=log, stderr=log, check=True)
        writer = csv.writer(sys.stdout)
        writer.writerow(["pass", "depth", "plastic_xz", "xx", "yy"])
        for row in rows(block, args, printed(folder / "line.dat")):
            writer.writerow([row[0], *(f"{v:.6g}" for v in row[1:])])


if __name__ == "__main__":
    main()
