#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The limit of finite elements as reference for the hybrid, by cells of a/4 and smaller and by both mesh families.

    benchmarks/hybrid_limits.py run --program build/app/rollfem --folder /tmp/limits -o benchmarks/hybrid_limits.json
    benchmarks/hybrid_limits.py show benchmarks/hybrid_limits.json

`run` computes the runs missing in the folder (--only 'f/*': a part of them; all take an hour) and writes the record;
rows of an existing record without runs in the folder stay. A force or pressure of finite elements has two errors: from
the cells, and from the contact grid with elements of the same size. A half-space on the same elements shares the second
one. So the limit is

    half-space on more and more elements + (finite elements - half-space on the same elements) on smaller and smaller cells,

minus the same difference where it should vanish: for bodies a hundred times larger under a hundredth of the force,
which have a patch of the same size and are nearly half-spaces. `show` also prints the plain extrapolation of the finite
elements. For bodies conforming across, the elements cannot be identical: those of finite elements are equal in y, those
of the half-space along the common surface. They agree at the edge of the patch; the change of the half-space by rows
1.5 % wider or narrower is added to the uncertainty.
"""
import argparse
import fnmatch
import json
import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CREEPAGES = (0.0, 0.001, 0.003)
QUANTITIES = ("max_pressure", "semi_axis_x", "semi_axis_y", "approach", "normal_force", "traction_coefficient")
FILES = {"s1002_left": "s1002_uic60_left", "s1002_right": "s1002_uic60_right", "groove": "conformal_groove",
         "corner": "conformal_corner", **{letter: f"thesis_{letter}" for letter in "abcdef"}}
# Cells in mm, the coarse ones first: a/4 and a/8 of the smaller semi-axis (in a to f those of the case files), some a/12.
STRUCTURED = {"a": (0.948091, 0.47, 0.316), "b": (1.22708, 0.6), "c": (0.618218, 0.31), "d": (0.618218, 0.31),
              "e": (0.948091, 0.47), "f": (0.948084, 0.47, 0.316), "s1002_left": (1.586, 0.793),
              "s1002_right": (1.87, 0.935), "groove": (0.725, 0.3625, 0.242), "corner": (1.356, 0.678, 0.452)}
GMSH = {"a": (0.948091, 0.47), "f": (0.948084, 0.47)}
ACROSS = (40, 80)  # elements across for the half-space's limit
CURVED = {"e": 102.56, "f": 50.633, "groove": 10.125, "corner": 10.1}  # mm, radius of the common surface across
LARGER = 100  # scale of the larger bodies, nearly half-spaces
PATCH_OF = {"a": "a", "b": "b", "c": "c", "d": "c", "e": "a", "f": "a"}  # cases with an equal patch on larger bodies
FLAT = "abcd"  # cases whose common surface is a plane or nearly one
WIDER = 0.015


def larger(text):
    """The case with bodies LARGER times as large and the same patch."""
    for key in ("rolling_radius", "transverse_radius"):
        text = re.sub(rf"(?m)^{key} = (-?[\d.]+)", lambda found: f"{found[0].split('=')[0]}= {LARGER * float(found[1])!r}", text)
    text = re.sub(r"(?m)^normal_force = ([\d.e]+)", lambda found: f"normal_force = {float(found[1]) / LARGER!r}", text)
    creepages = [xi / LARGER for xi in CREEPAGES]
    return re.sub(r"(?m)^longitudinal_creepage = .*", f"longitudinal_creepage = {creepages}", text)


def case_text(letter, settings):
    """The case of the study at CREEPAGES; `settings`: {section: lines}, replaces existing keys."""
    text = (ROOT / "cases" / f"{FILES[letter]}.toml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^longitudinal_creepage = .*", f"longitudinal_creepage = {list(CREEPAGES)}", text)
    for section, lines in settings.items():
        for key in [line.split(" = ")[0] for line in lines] + ["elements_across"] * (section == "contact_grid"):
            text = re.sub(rf"(?m)^{key} = .*\n", "", text)
        if f"[{section}]" in text:
            text = text.replace(f"[{section}]", "\n".join([f"[{section}]", *lines]))
        else:
            text += "\n".join(["", f"[{section}]", *lines, ""])
    return text


def elements_of(folder):
    """(dx, dy, nx, ny) of the contact grid of a run of finite elements."""
    import h5py
    with h5py.File(folder / "results.h5") as file:
        grid = next(iter(file["models"].values()))["grid"]  # for the only model and patch
        return float(grid.attrs["dx"]), float(grid.attrs["dy"]), len(grid["x"]), len(grid["y"])


def stretches(letter, row):
    """Width of the half-space's rows over those of finite elements: equal, and varied both ways if they are not
    identical."""
    if letter not in CURVED:
        return [1.0] if letter in FLAT else [1.0, 1 - WIDER, 1 + WIDER]
    turn = math.asin(row["points"][0]["semi_axis_y"] / CURVED[letter])
    exact = turn / math.sin(turn)
    return [exact, exact * (1 - WIDER), exact * (1 + WIDER)]


class Runs:
    """Runs in a folder, each once."""

    def __init__(self, program, folder, only):
        self.program, self.folder, self.only = program, folder, only
        folder.mkdir(parents=True, exist_ok=True)

    def row(self, letter, name, model, settings, **words):
        """A row of the record; None if the run is neither requested nor stored."""
        folder = self.folder / f"{letter}_{name}"
        if not (folder / "summary.json").exists():
            if not fnmatch.fnmatch(f"{letter}/{name}", self.only):
                return None
            case = Path(f"{folder}.toml")
            text = case_text(letter, settings)
            case.write_text(larger(text) if words.get("larger") else text, encoding="utf-8")
            print(f"{letter}/{name}", flush=True)
            done = subprocess.run([self.program, "run", str(case), "--model", model, "--quiet", "--no-report", "-o",
                                   str(folder)], check=False, capture_output=True, text=True)
            if done.returncode:
                print(done.stderr.strip().splitlines()[-1])
                return None
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        result = next(m for m in summary["models"] if m["name"] == model)
        points = [{"longitudinal_creepage": xi, **{q: point[q] for q in QUANTITIES if q in point}} for xi in CREEPAGES
                  for point in result["points"]
                  if abs(point.get("longitudinal_creepage", 0.0) * words.get("larger", 1) - xi) < 1e-12]
        return {"case": letter, "model": model, **words, "commit": summary["program"]["commit"],
                "unknowns": result["unknowns"], "points": points}, folder

    def finite_elements(self, letter, mesh, cell, **words):
        """Rows of finite elements and of the half-space on their contact grid. `larger`: for larger bodies."""
        output = ["fields = false", 'body_fields = "none"', "stress_maxima = false"]
        fem = [f"cell_size = {cell}", f'mesh = "{mesh}"'][:1 if mesh == "structured" else 2]
        name = f"{mesh}{'_larger' * bool(words)}_{cell:g}"
        found = self.row(letter, f"fem_{name}", "fem", {"fem": fem, "output": output}, mesh=mesh, cell=cell, **words)
        if not found:
            return []
        row, folder = found
        dx, dy, nx, ny = elements_of(folder)
        rows = [row]
        for stretch in stretches(letter, row):
            # One more element on every side, for a slightly larger patch and a whole number of elements.
            grid = [f"cell_size = [{dx}, {stretch * dy!r}]",
                    f"extent = [{(nx + 2) * dx * (1 + 1e-7)!r}, {stretch * (ny + 2) * dy * (1 + 1e-7)!r}]"]
            same = self.row(letter, f"halfspace_{name}_{stretch:.4f}", "halfspace",
                            {"contact_grid": grid, "halfspace": ['surface = "curved"']}, mesh=mesh, cell=cell, **words)
            rows += [same[0]] if same else []
        return rows

    def half_space(self, letter, across):
        found = self.row(letter, f"halfspace_{across}", "halfspace",
                         {"contact_grid": [f"elements_across = {across}"], "halfspace": ['surface = "curved"']},
                         across=across)
        return [found[0]] if found else []


def fitting(rows, **words):
    return [row for row in rows if all(row.get(word) == value for word, value in words.items())]


def extrapolated(sizes, values, order):
    """(limit, distance of the last value from it) from the last two values."""
    if len(values) < 2:
        return values[-1], math.nan
    beyond = (values[-1] - values[-2]) / ((sizes[-2] / sizes[-1]) ** order - 1)
    return values[-1] + beyond, abs(beyond)


def own_excess(rows, letter, index, quantity, mesh):
    """Difference of finite elements from half-spaces on nearly half-space bodies, from one size of cells; proportional
    for pressures, 0 without such a run."""
    runs = fitting(rows, case=PATCH_OF.get(letter), mesh=mesh, larger=LARGER)
    if quantity not in ("max_pressure", "traction_coefficient") or len(runs) != 2:
        return 0.0
    by_elements, by_half_space = (run["points"][index][quantity] for run in sorted(runs, key=lambda run: run["model"]))
    if quantity == "traction_coefficient":
        return by_elements - by_half_space
    curved = next(row for row in rows if row["case"] == letter and "across" in row)["points"][index][quantity]
    return curved * (by_elements / by_half_space - 1)


def limit(rows, letter, index, quantity, mesh="structured"):
    """{"limit", "uncertain", "plain", "differences", "beyond_grid"} of a quantity at CREEPAGES[index]; None if runs are
    missing. `beyond_grid`: error of the half-space with ACROSS[-1] elements.

    Orders are assumed: 2 for pressure, size and approach, 1.5 for forces (docs/counts.md).
    """
    order = 1.5 if quantity == "traction_coefficient" else 2.0
    mine = [r for r in rows if r["case"] == letter and "larger" not in r]
    def value(row):
        return row["points"][index][quantity]
    half = sorted((r for r in mine if "across" in r), key=lambda r: r["across"])
    fem = sorted((r for r in mine if r["model"] == "fem" and r["mesh"] == mesh), key=lambda r: -r["cell"])
    if not half or not fem or index >= len(fem[0]["points"]) or quantity not in fem[0]["points"][index]:
        return None
    same = {cell: [value(r) for r in mine if r["model"] == "halfspace" and r.get("mesh") == mesh and r["cell"] == cell]
            for cell in (r["cell"] for r in fem)}
    if not all(same.values()):
        return None
    cells = list(same)
    differences = [value(r) - same[r["cell"]][0] for r in fem]
    rows_off = max(abs(v - same[cells[-1]][0]) for v in same[cells[-1]])
    most, left = extrapolated([1 / r["across"] for r in half], [value(r) for r in half], order)
    more, change = extrapolated(cells, differences, order)
    plain, _ = extrapolated(cells, [value(r) for r in fem], order)
    return {"limit": most + more - own_excess(rows, letter, index, quantity, mesh),
            "uncertain": change + left / 3 + rows_off, "plain": plain, "differences": differences,
            "beyond_grid": most - value(half[-1])}


def show(record):
    """Tables of the limits and of the underlying differences."""
    rows = record["rows"]
    print("| case, xi | p0 MPa | plain | p0 less half-space, by cells | -F_x/F_z | plain | less half-space, by cells |")
    print("|---|---|---|---|---|---|---|")
    for mesh in ("structured", "gmsh"):
        for letter in STRUCTURED:
            for index, xi in enumerate(CREEPAGES):
                pressure = limit(rows, letter, index, "max_pressure", mesh)
                force = limit(rows, letter, index, "traction_coefficient", mesh)
                if pressure and force:
                    print(f"| {letter}, {100 * xi:g} %{', gmsh' * (mesh == 'gmsh')} | {pressure['limit']:.2f} +- "
                          f"{pressure['uncertain']:.2f} | {pressure['plain']:.2f} | "
                          f"{', '.join(f'{d:.3f}' for d in pressure['differences'])} | {force['limit']:.5f} +- "
                          f"{force['uncertain']:.5f} | {force['plain']:.5f} | "
                          f"{', '.join(f'{d:.5f}' for d in force['differences'])} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    make = verbs.add_parser("run", help="compute missing runs and write the record")
    make.add_argument("--program", required=True, help="the program rollfem, built with finite elements")
    make.add_argument("--folder", type=Path, required=True, help="folder of the runs")
    make.add_argument("--only", default="*", help="pattern case/run; other missing runs are not computed")
    make.add_argument("-o", "--output", type=Path, required=True, help="the record (JSON)")
    verbs.add_parser("show", help="print limits").add_argument("record", type=Path)
    options = parser.parse_args()
    if options.verb == "show":
        show(json.loads(options.record.read_text(encoding="utf-8")))
        return
    earlier = json.loads(options.output.read_text(encoding="utf-8"))["rows"] if options.output.exists() else []
    runs = Runs(options.program, options.folder, options.only)
    rows = []
    for letter, cells in STRUCTURED.items():
        for mesh, sizes in (("structured", cells), ("gmsh", GMSH.get(letter, ()))):
            for cell in sizes:
                rows += runs.finite_elements(letter, mesh, cell) or [
                    row for row in fitting(earlier, case=letter, mesh=mesh, cell=cell) if "larger" not in row]
        if letter in PATCH_OF.values():
            rows += runs.finite_elements(letter, "structured", cells[0], larger=LARGER) or fitting(
                earlier, case=letter, larger=LARGER)
        for across in ACROSS:
            rows += runs.half_space(letter, across) or fitting(earlier, case=letter, across=across)
    lines = ",\n  ".join(json.dumps(row) for row in rows)
    options.output.write_text('{"made_by": "benchmarks/hybrid_limits.py run",\n "rows": [\n  ' + lines + "]}\n",
                              encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
