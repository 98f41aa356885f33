#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved patches by CalculiX, without friction: the effect of their curvature.

usage: benchmarks/calculix/curved_patch.py [--pair f|groove] [--cell 0.95] [--program build/app/rollfem] [-o FOLDER]
       [--store FILE]

Two cases with the same Hertzian ellipse; in the second one it lies on curved surfaces. Cases a and f of the 2012 study
(f: a rail of 50 mm under a concave wheel), or a wheel of 10 mm in a groove of 10.05 mm beside its equivalent on a flat
rail. Their meshes are one mesh, mapped onto two shapes, so that errors of discretisation cancel in the difference:
quarter bodies of 60 mm, bricks with incompatible modes (C3D8I), the far faces clamped and brought together, small
displacements, and between opposite nodes one gap element each, whose clearance is the undeformed distance by formula
along the mean normal. Pressure is the force of a gap element over its node's share of the surface. rollfem's pressures
are fitted in the same way. The book quotes the output of --store (benchmarks/book/calculix.json).
"""
import argparse
import dataclasses
import json
import math
import os
import re
import shutil
import subprocess
import sys

import numpy as np



@dataclasses.dataclass
class Case:
    """Lengths in mm, N, MPa; radii across the track are > 0 where the surface falls to both sides."""

    name: str
    rail: float
    wheel: float
    radius: float = 405.0
    force: float = 50e3
    young: float = 210e3
    poisson: float = 0.3
    hertz: tuple = (3.79236, 10.87295, 578.967)  # a, b, p0
    approach: float = 0.0445  # of the far faces: a first guess


GROOVE = {"radius": 420.0, "force": 10e3, "young": 204.8e3, "poisson": 0.28, "hertz": (2.2872, 6.4259, 324.86),
          "approach": 0.0195}
PAIRS = {"f": (Case("a", 2000.0, math.inf), Case("f", 50.0, 51.282)),
         "groove": (Case("flat", math.inf, -2010.0, **GROOVE), Case("groove", -10.05, -10.0, **GROOVE))}
REACH = 60.0  # size of the quarter bodies, along, across and down, mm
ROUND_TO = 0.7  # circles end at this fraction of their radius and continue straight
PENALTY = 3e6  # penalty stiffness of the contact, N/mm^3: some 0.2 um of overlap under p0
OVERLAP_FORCE = 1e-3  # N, force of a wide-open gap element (CalculiX's default)
NEAR = 0.01  # relative to the force; p0 ~ F^(1/3) corrects the rest
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def graded(fine, count, end):
    """Places 0, fine, ..., count*fine and on to `end` with a constant ratio near 1.35."""
    start = fine * count
    cells = max(2, round(math.log(1 + (end - start) * 0.35 / (1.35 * fine)) / math.log(1.35)))
    low, high = 1.0, 3.0
    for _ in range(80):
        ratio = 0.5 * (low + high)
        total = fine * sum(ratio**(k + 1) for k in range(cells))
        low, high = (ratio, high) if start + total < end else (low, ratio)
    steps = [fine] * count + [fine * ratio**(k + 1) for k in range(cells)]
    return np.concatenate([[0.0], np.cumsum(steps)])


def across(arc, radius):
    """y of a circle at arc length `arc` from its top, straight beyond ROUND_TO."""
    if math.isinf(radius):
        return arc
    last, size = math.asin(ROUND_TO), abs(radius)
    angle = np.minimum(arc / size, last)
    return size * np.sin(angle) + np.maximum(arc - size * last, 0.0) * math.cos(last)


def drop_at(y, radius):
    """(drop, slope) of the same curve at a place y."""
    if math.isinf(radius):
        return 0 * y, 0 * y
    inner, sign = np.minimum(y, ROUND_TO * abs(radius)), math.copysign(1.0, radius)
    slope = inner / np.sqrt(radius**2 - inner**2)
    return sign * (abs(radius) - np.sqrt(radius**2 - inner**2) + slope * (y - inner)), sign * slope


class Bodies:
    """Quarter (x > 0, y > 0) of rail and wheel on one grid of (along, arc length across, depth)."""

    def __init__(self, case, cell):
        self.case = case
        a, b, _ = case.hertz
        self.x = graded(cell, math.ceil(1.7 * a / cell), REACH)
        self.arc = graded(cell, math.ceil(1.25 * b / cell), REACH)
        self.depth = graded(cell, math.ceil(1.0 * a / cell), REACH)
        self.shape = (len(self.x), len(self.arc), len(self.depth))
        y = across(self.arc, case.rail)
        rail, rail_slope = drop_at(y, case.rail)
        wheel, wheel_slope = drop_at(y, case.wheel)
        rim = case.radius + wheel  # rolling radius at y
        height = np.sqrt(rim**2 - self.x[:, None]**2)
        self.y, self.rail, self.wheel = y, -rail[None, :] + 0 * height, case.radius - height
        slope_x = 0.5 * self.x[:, None] / height
        slope_y = -0.5 * (rail_slope + wheel_slope * rim / height)
        length = np.sqrt(1 + slope_x**2 + slope_y**2)
        self.normal = np.stack([-slope_x / length, -slope_y / length, 1 / length], axis=-1)
        self.gap = (self.wheel - self.rail) * self.normal[..., 2]
        half = [np.gradient(p) for p in (self.x, self.arc)]
        for p, h in zip((self.x, self.arc), half):
            h[0], h[-1] = 0.5 * (p[1] - p[0]), 0.5 * (p[-1] - p[-2])
        self.area = half[0][:, None] * half[1][None, :]

    def number(self, body, i, j, k):
        """Number of a node; body 0 is the rail, 1 the wheel."""
        nx, ny, nz = self.shape
        return 1 + i + nx * (j + ny * (k + nz * body))

    def nodes(self):
        for body, (top, sign) in enumerate(((self.rail, -1.0), (self.wheel, 1.0))):
            for k, depth in enumerate(self.depth):
                for j, y in enumerate(self.y):
                    for i, x in enumerate(self.x):
                        yield f"{self.number(body, i, j, k)}, {x:.9g}, {y:.9g}, {top[i, j] + sign * depth:.9g}"

    def cells(self):
        nx, ny, nz = self.shape
        for body in (0, 1):
            for k in range(nz - 1):
                low, high = (k + 1, k) if body == 0 else (k, k + 1)
                for j in range(ny - 1):
                    for i in range(nx - 1):
                        yield [self.number(body, i + di, j + dj, level) for level in (low, high)
                               for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]

    def contacts(self):
        """(i, j) of node pairs that may touch."""
        a, b, _ = self.case.hertz
        return [(i, j) for j, s in enumerate(self.arc) for i, x in enumerate(self.x)
                if (x / a)**2 + (s / b)**2 < 1.6]


def _set(name, numbers, kind="NSET"):
    numbers = list(numbers)
    lines = [", ".join(map(str, numbers[k:k + 12])) for k in range(0, len(numbers), 12)]
    return [f"*{kind}, {kind}={name}"] + [line + "," for line in lines]


def deck(bodies, approach):
    """CalculiX's input: bricks with incompatible modes, one gap element per pair of opposite nodes."""
    nx, ny, nz = bodies.shape
    number = bodies.number
    lines = ["*NODE, NSET=ALL", *bodies.nodes(), "*ELEMENT, TYPE=C3D8I, ELSET=SOLID"]
    count = 0
    for count, cell in enumerate(bodies.cells(), 1):
        lines.append(", ".join(map(str, [count, *cell])))
    # An unreachable yield stress makes the step iterative; otherwise gap elements stay open or closed.
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{bodies.case.young}, {bodies.case.poisson}", "*PLASTIC", "1e9, 0.",
              "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL"]
    pairs = bodies.contacts()
    for place, (i, j) in enumerate(pairs, 1):
        n = bodies.normal[i, j]
        lines += [f"*ELEMENT, TYPE=GAPUNI, ELSET=G{place}",
                  f"{count + place}, {number(0, i, j, 0)}, {number(1, i, j, 0)}", f"*GAP, ELSET=G{place}",
                  f"{bodies.gap[i, j]:.9g}, {n[0]:.9g}, {n[1]:.9g}, {n[2]:.9g}, , "
                  f"{PENALTY * bodies.area[i, j]:.9g}, {OVERLAP_FORCE}"]
    layer = lambda i, j, k: (number(body, p, q, r) for body in (0, 1) for p in i for q in j for r in k)
    lines += _set("MIDDLEX", layer([0], range(ny), range(nz))) + _set("MIDDLEY", layer(range(nx), [0], range(nz)))
    for name, body in (("BOTTOM", 0), ("TOP", 1)):
        lines += _set(name, (number(body, i, j, nz - 1) for i in range(nx) for j in range(ny)))
    lines += _set("FACES", (number(body, i, j, 0) for body in (0, 1) for i, j in pairs))
    lines += ["*BOUNDARY", "MIDDLEX, 1, 1", "MIDDLEY, 2, 2", "BOTTOM, 1, 3", "TOP, 1, 2", "*STEP, INC=100", "*STATIC",
              "0.5, 1.", "*BOUNDARY", f"TOP, 3, 3, {-approach}", "*NODE PRINT, NSET=FACES", "U",
              "*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(lines) + "\n"


def printed(path):
    """({node: displacement}, reaction) of the last increment in a .dat file."""
    moved, reaction, kind = {}, None, ""
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] in ("displacements", "total"):
                kind = words[0]
            elif kind == "displacements" and len(words) == 4:
                moved[int(words[0])] = np.array([float(w) for w in words[1:]])
            elif kind == "total" and len(words) == 3:
                reaction = np.array([float(w) for w in words])
    return moved, reaction


def contact_forces(bodies, moved):
    """(x, arc length, force along the normal, area) of the pairs: CalculiX's law of a gap element."""
    rows = []
    for i, j in bodies.contacts():
        step = moved[bodies.number(1, i, j, 0)] - moved[bodies.number(0, i, j, 0)]
        overlap = -(bodies.gap[i, j] + step @ bodies.normal[i, j])
        stiffness = PENALTY * bodies.area[i, j]
        soft = math.pi * OVERLAP_FORCE / stiffness
        rows.append((bodies.x[i], bodies.arc[j], stiffness * overlap * (0.5 + math.atan(overlap / soft) / math.pi),
                     bodies.area[i, j]))
    return np.array(rows)


def fitted(case, x, arc, pressure):
    """(p0, a, b) of p^2 = p0^2 (1 - x^2/a^2 - s^2/b^2), by least squares inside half the patch."""
    inside = (x / case.hertz[0])**2 + (arc / case.hertz[1])**2 < 0.25
    columns = np.stack([np.ones(inside.sum()), -x[inside]**2, -arc[inside]**2], axis=1)
    c = np.linalg.lstsq(columns, pressure[inside]**2, rcond=None)[0]
    return math.sqrt(c[0]), math.sqrt(c[0] / c[1]), math.sqrt(c[0] / c[2])


def by_calculix(case, cell, folder):
    """CalculiX's result for a case: p0, a, b of the fit, sum of p dA over the force, cost."""
    bodies = Bodies(case, cell)
    stem = os.path.join(folder, f"calculix_{case.name}")
    before, approach, vertical = os.times().children_user, case.approach, 0.0
    while abs(vertical / case.force - 1) > NEAR:
        approach *= (case.force / vertical)**0.7 if vertical else 1.0
        with open(stem + ".inp", "w", encoding="utf-8") as file:
            file.write(deck(bodies, approach))
        done = subprocess.run(["ccx", "-i", os.path.basename(stem)], cwd=folder, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
        if "Job finished" not in done.stdout:
            sys.exit(f"error: ccx did not finish case {case.name}:\n{done.stdout[-1500:]}")
        moved, reaction = printed(stem + ".dat")
        vertical = 4 * abs(reaction[2])
    x, arc, force, area = contact_forces(bodies, moved).T
    p0, a, b = fitted(case, x, arc, force / area)
    scale = (case.force / vertical)**(1 / 3)
    return {"p0": p0 * scale, "a": a * scale, "b": b * scale, "sum_over_force": 4 * force.sum() / vertical,
            "unknowns": 6 * math.prod(bodies.shape), "cpu_seconds": round(os.times().children_user - before)}


def case_text(case, friction):
    """The case file of rollfem at xi = 0."""
    name = "conformal_groove" if case.force == GROOVE["force"] else f"thesis_{case.name}"
    with open(os.path.join(ROOT, "cases", name + ".toml"), encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"longitudinal_creepage = \[.*\]", "longitudinal_creepage = 0.0", text)
    text = re.sub(r"\ncoefficient = [\d.]+", f"\ncoefficient = {friction}", text)
    if name == "conformal_groove":
        text = text.replace("transverse_radius = 10.0 ", f"transverse_radius = {-case.wheel} ")
        text = text.replace("transverse_radius = -10.25", f"transverse_radius = {case.rail}")
    return text


def by_rollfem(case, friction, program, folder):
    """{model: p0, a, b and p0 of the fit, sum of p dA over the force} at xi = 0 with this coefficient of friction."""
    sys.path.insert(0, os.path.join(ROOT, "postprocess"))
    from rollfem.reader import read_result
    target = os.path.join(folder, f"rollfem_{case.name}_{friction:g}")
    with open(target + ".toml", "w", encoding="utf-8") as file:
        file.write(case_text(case, friction))
    subprocess.run([program, "run", target + ".toml", "--model", "halfspace,hybrid", "--quiet", "--no-report", "-o",
                    target], check=True)
    found = {}
    for model in read_result(target).models:
        point = model.points[0]
        pressure = point.fields["pressure"]
        x, arc = np.meshgrid(model.x, model.y)
        p0, a, b = fitted(case, x.ravel(), arc.ravel(), pressure.ravel())
        area = (model.x[1] - model.x[0]) * (model.y[1] - model.y[0])
        found[model.name] = {"p0": point["max_pressure"], "a": a, "b": b, "p0_of_fit": p0,
                             "sum_over_force": float(pressure.sum()) * area / case.force}
    return found


def compared(pair, cell, program, folder):
    """[{"by", "friction", case: ...}]: a line each for CalculiX, half-space and hybrid; cases a and f with friction too."""
    cases = PAIRS[pair]
    lines = [{"by": f"CalculiX, {cell:g} mm", "friction": 0.0, **{c.name: by_calculix(c, cell, folder) for c in cases}}]
    for friction in ((0.0, 0.55) if pair == "f" else (0.0,)) if program else ():
        found = {c.name: by_rollfem(c, friction, program, folder) for c in cases}
        lines += [{"by": model, "friction": friction, **{c.name: found[c.name][model] for c in cases}}
                  for model in found[cases[0].name]]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pair", choices=PAIRS, default="f", help="the curved case: f, or the groove of 10.05 mm")
    parser.add_argument("--cell", type=float, default=0.95, help="in the patch, mm; 0.95: 25 CPU s a case, 0.63: 130")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "app", "rollfem"), help="the program rollfem; '' for none")
    parser.add_argument("-o", "--output", default="results/calculix", help="folder of the decks and results")
    parser.add_argument("--store", metavar="FILE", help="JSON file to append the lines to")
    options = parser.parse_args()
    if not shutil.which("ccx"):
        sys.exit("error: ccx not found; do: apt install calculix-ccx")
    os.makedirs(options.output, exist_ok=True)
    lines = compared(options.pair, options.cell, options.program, options.output)
    first, second = (case.name for case in PAIRS[options.pair])
    print(f"{'':22}{'mu':>5}" + "".join(f"{f'{what}({name})':>12}" for what in ("p0", "b") for name in (first, second, "change"))
          + f"{'sum p dA/F':>12}")
    for line in lines:
        a, f = line[first], line[second]
        fit = "p0_of_fit" if "p0_of_fit" in f else "p0"
        print(f"{line['by']:22}{line['friction']:5g}{a[fit]:12.2f}{f[fit]:12.2f}{f[fit] - a[fit]:+12.2f}{a['b']:12.3f}"
              f"{f['b']:12.3f}{f['b'] - a['b']:+12.3f}{f['sum_over_force']:12.5f}")
    if options.store:
        known = []
        if os.path.exists(options.store):
            with open(options.store, encoding="utf-8") as file:
                known = json.load(file)
        new = {(line["by"], line["friction"]) for line in lines}
        same = [k for k in known if (k["by"], k["friction"]) in new and second in k]
        with open(options.store, "w", encoding="utf-8") as file:
            json.dump([k for k in known if k not in same] + lines, file, indent=1)
            file.write("\n")


if __name__ == "__main__":
    main()
