#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Differences between rollfem and CONTACT on CONTACT's own examples: converts, runs and compares.

    /usr/bin/python3 benchmarks/contact_agreement.py EXAMPLES --program build/app/rollfem [-o DIR]

EXAMPLES is a folder with NAME.inp and NAME.ref_out from CONTACT's open-source distribution (and the profiles for module
1). Prints the table of docs/coming_from_contact.md: the largest difference over the cases of each kind. CONTACT prints
four digits. With -o, case files and results stay there and are reused.
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import tempfile

import h5py
import numpy

NAMES = ["cattaneo", "spence35", "catt_to_cart", "fastsim", "tractcurv", "mbench_a22_left",
         "carter2d", "bentall", "veldep_fric"]
ADHESION = 1  # in `state` of results.h5; 2 is slip, 0 outside
NUMBER = r"[-+]?[0-9]*\.?[0-9]+(?:[eE][-+]?[0-9]+)?\.?"


def numbers(line):
    return [float(word) for word in re.findall(NUMBER, line)]


def printed_cases(path):
    """Case number -> values printed by CONTACT."""
    text = path.read_text(errors="replace")
    cases = {}
    for part in re.split(r"^ Case +", text, flags=re.M)[1:]:
        lines = part.splitlines()
        found = {}
        for at, line in enumerate(lines):
            if re.match(r" +FN +FX +F[YS] +M[ZN]", line):
                found.update(zip(("fn", "fx", "fy", "mz"), numbers(lines[at + 1])))
            elif re.match(r" +FN/G ", line):
                names = re.findall(r"(?:SHIFT|CREEP) [XY]|\S+", line)
                found.update(zip(names, numbers(lines[at + 1])))
            elif re.match(r" +NPOT +(MAXC +)?NCON", line):
                found.update(zip(("npot", "contact", "adhesion"), numbers(lines[at + 1])))
        cases[int(lines[0])] = found
    return cases


def run(program, case_file, folder):
    if not (folder / "summary.json").exists():
        subprocess.run([program, "run", case_file, "-o", folder, "--no-report",
                        "--set", "output.grid_fields=\"all\""], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    model = json.loads((folder / "summary.json").read_text())["models"][0]
    points = model.get("points") or [p for patch in model["patches"] for p in patch["points"]]
    return model, points


def case_numbers(text):
    """Case numbers in convert's comment: "1, 3 to 5"."""
    found = []
    words = re.search(r"^# Made by rollfem convert of .*, cases? (\d+(?:(?:, | to )\d+)*)", text, re.M)
    for part in words[1].split(", "):
        first, _, last = part.partition(" to ")
        found += range(int(first), int(last or first) + 1)
    return found


def states(folder, model, point):
    """Elements in contact and in adhesion, if the model has them."""
    with h5py.File(folder / "results.h5") as file:
        state = numpy.array(file[f"models/{model}/points/{point:04d}/state"])
        return int((state > 0).sum()), int((state == ADHESION).sum())


class Largest:
    """Largest difference of each quantity over the cases of a kind, in percent of its scale."""

    def __init__(self):
        self.values, self.cases = {}, 0

    def add(self, quantity, ours, printed, scale):
        if scale:
            off = 100.0 * abs(ours - printed) / abs(scale)
            self.values[quantity] = max(off, self.values.get(quantity, 0.0))


def compare(largest, point, printed, mu, text, counts):
    """Adds one load point of the case file `text`."""
    fn = printed["fn"]
    bound = mu * fn
    on_rail = "[wheelset]" in text  # module 1 states forces on the rail
    turned = "half a turn" in text  # CHI = 180
    parabolic = 'bound = "parabolic"' in text
    sign_x = -1.0 if turned or on_rail else 1.0
    sign_y = -1.0 if turned else 1.0
    largest.cases += 1
    if not parabolic:  # there CONTACT prints the bound's peak, 4/3 of Hertz's
        largest.add("p0", point["max_pressure"], printed["PMAX"], printed["PMAX"])
    largest.add("approach", point["approach"], printed["APPROACH"], printed["APPROACH"])
    largest.add("F_n", point["normal_force"], fn, fn)
    largest.add("F_x", sign_x * point["longitudinal_force"], printed["fx"], bound)
    largest.add("F_y", sign_y * point["lateral_force"], printed["fy"], bound)
    radius = math.sqrt(point["contact_area"] / math.pi)
    largest.add("M_z", point["spin_moment"], printed["mz"], bound * radius)
    for name, key in (("SHIFT X", "longitudinal_shift"), ("CREEP X", "longitudinal_creepage")):
        if name in printed and point.get(key):
            ours = -point[key] if turned else point[key]
            largest.add("creepage, shift", ours, printed[name], printed[name])
    if counts and "contact" in printed:
        largest.add("contact", counts[0], printed["contact"], printed["contact"])
        largest.add("adhesion", counts[1], printed["adhesion"], printed["contact"])


def compare_file(program, case_file, folder, printed, results):
    text = case_file.read_text()
    mu = float(re.search(r"^coefficient = (\S+)", text, re.M)[1])
    model, points = run(program, case_file, folder)
    kind = {"fastsim": "FASTSIM", "fastrip": "FaStrip"}.get(model["name"])
    if kind is None:
        kind = "shift" if 'problem = "shift"' in text else (
            "frictionless" if "frictionless" in text else
            "transient" if "transient" in text else "steady")
    for k, (number, point) in enumerate(zip(case_numbers(text), points)):
        if "fn" not in printed[number]:
            continue  # CONTACT printed nothing for this case
        counts = None
        if model["name"] == "halfspace" and kind != "frictionless":
            counts = states(folder, "halfspace", k) if "[wheelset]" not in text else None
        compare(results.setdefault(kind, Largest()), point, printed[number], mu, text, counts)


COLUMNS = ["F_n", "p0", "approach", "F_x", "F_y", "M_z", "creepage, shift", "contact", "adhesion"]


def table(rows):
    print("| example | cases | " + " | ".join(COLUMNS) + " |")
    print("|" + "---|" * (len(COLUMNS) + 2))
    for name, kind, largest in rows:
        cells = [f"{largest.values[c]:.3f}" if c in largest.values else "" for c in COLUMNS]
        print(f"| {name}, {kind} | {largest.cases} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("examples", type=pathlib.Path)
    parser.add_argument("--program", required=True, type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", default=NAMES)
    call = parser.parse_args()
    output = call.output or pathlib.Path(tempfile.mkdtemp())
    rows = []
    for name in call.only:
        cases = output / f"{name}_cases"
        if not cases.exists():
            subprocess.run([call.program.resolve(), "convert", call.examples / f"{name}.inp", "-o",
                            cases, "--partial"], check=True, stdout=subprocess.DEVNULL)
        printed = printed_cases(call.examples / f"{name}.ref_out")
        results = {}
        for case_file in sorted(cases.glob("*.toml")):
            compare_file(call.program.resolve(), case_file, output / case_file.stem, printed,
                         results)
        rows += [(name, kind, largest) for kind, largest in results.items()]
    table(rows)


if __name__ == "__main__":
    main()
