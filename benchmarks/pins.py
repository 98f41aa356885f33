#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pins the numbers of the program, to show that a change of its structure changes none of them.

usage: benchmarks/pins.py record --program PATH -o FILE.json [--cases FOLDER] [--only PATTERN]
       benchmarks/pins.py compare BEFORE.json AFTER.json [--reasons FILE] [--only PATTERN] [--brief]
       benchmarks/pins.py list

record runs the cases of pin_cases.py with the program, one model at a time and without a report, and stores every
scalar of summary.json except times and iteration counts under case/model/place/point/quantity. compare lists numbers
that differ by more than 1e-9 (1e-7 for finite-element solvers of finite accuracy), relative to the value or, if that
vanishes, to the scale of the quantity (scale_of). Every difference is looked up in a table, pattern < largest
difference: reason (pin_reasons.txt beside this file); a difference without a reason ends compare with status 1.
"""
import argparse
import fnmatch
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import pin_cases

HERE = pathlib.Path(__file__).resolve().parent
TOLERANCE = {"fem": 1e-7}
TOLERANCE_OF_OTHERS = 1e-9
# Scalars that are not numbers of the solution.
LEFT_OUT = {"iterations", "residual", "seconds", "format"}
VANISHES = 1e-6  # relative to the scale


# --- what a number is compared to where it vanishes ---------------------------------------------------

def scale_of(name, numbers):
    """Typical magnitude of a vanishing quantity, from the others of the load point."""
    point, quantity = name.rsplit("/", 1)

    def of(key):
        return abs(numbers.get(f"{point}/{key}", 0.0))

    if point.count("/") < 3:  # for a place: mm, rad
        return 1.0
    estimate, quantity = quantity.startswith("error_estimate."), quantity.split("error_estimate.")[-1]
    quantity = quantity.removeprefix("richardson.")
    length = math.sqrt(of("semi_axis_x") * of("semi_axis_y"))
    if quantity.startswith("stress_maxima."):
        return length if ".place." in quantity else of("max_pressure")
    size = {
        "longitudinal_force": of("normal_force"), "lateral_force": of("normal_force"),
        "spin_moment": of("normal_force") * length, "traction_coefficient": 1.0,
        "longitudinal_creepage": 1e-3, "lateral_creepage": 1e-3, "spin": 1e-4,
        "longitudinal_shift": of("approach"), "lateral_shift": of("approach"),
        "max_traction": of("max_pressure"), "max_traction_x": of("max_pressure"),
        "adhesion_area": of("contact_area"), "patch_x_middle": length, "patch_y_middle": length,
        # per rolled length: a force times a creepage
        "frictional_work": 1e-3 * of("normal_force"), "creepage_work": 1e-3 * of("normal_force"),
    }.get(quantity, 0.0)
    return size or of(quantity) if estimate else size  # an estimate may vanish although its quantity does not


# --- record -------------------------------------------------------------------------------------------

def scalars(value, name=""):
    """(name, number) of all numbers below value."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in LEFT_OUT:
                # The place of a quantity in the file must not matter.
                yield from scalars(inner, name if key == "derived" else f"{name}.{key}" if name else key)
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            named = isinstance(inner, dict) and "measure" in inner
            yield from scalars(inner, f"{name}.{inner['body']}.{inner['measure']}" if named else f"{name}.{i}")
    elif isinstance(value, (bool, int, float)):
        yield name, float(value)


def numbers_of(summary, case):
    """name -> value of a summary.json."""
    found = {}
    for model in summary["models"]:
        place = model.get("place", {})
        where = "-".join(str(place.get(key, 0)) for key in ("wheel", "position", "patch")) if place else "plane"
        head = f"{case}/{model['name']}/{where}"
        for key in ("unknowns", "contact_elements"):
            found[f"{head}/{key}"] = float(model[key])
        for name, value in scalars({key: v for key, v in place.items() if key not in ("position", "patch")}):
            found[f"{head}/{name}"] = value
        for i, point in enumerate(model["points"]):
            for name, value in scalars(point):
                found[f"{head}/{i}/{name}"] = value
    return found


def run_one(program, case, model, folder, cases):
    """numbers of a case with a model, and the first line of the program's message if it refused the case. A case may be
    written in several ways, for programs with other keys: the first readable one counts."""
    said = ""
    for text in case.texts(cases):
        path = pathlib.Path(folder) / f"{case.name}.toml"
        path.write_text(text, encoding="utf-8")
        output = pathlib.Path(folder) / "result"
        run = subprocess.run(
            [program, "run", str(path), "-m", model, "--no-report", "-q", "-o", str(output)], text=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"})
        if run.returncode == 0:
            return numbers_of(json.loads((output / "summary.json").read_text("utf-8")), case.name), ""
        said = said or run.stderr.replace(str(folder) + "/", "").strip().split("\n")[0]
        if run.returncode != 2:
            break
    return {}, said or f"exit status {run.returncode}"


def record(arguments):
    numbers, failed = {}, {}
    version = subprocess.run([arguments.program, "--version"], text=True, capture_output=True, check=True).stdout.splitlines()[0]
    for case in pin_cases.ALL:
        for model in case.models:
            if not fnmatch.fnmatch(f"{case.name}/{model}", arguments.only):
                continue
            start = time.monotonic()
            with tempfile.TemporaryDirectory() as folder:
                pin_cases.write_files(pathlib.Path(folder), arguments.cases)
                found, said = run_one(arguments.program, case, model, folder, arguments.cases)
            if said:
                failed[f"{case.name}/{model}"] = said
            numbers.update(found)
            print(f"{case.name}/{model}: {said or f'{len(found)} numbers'}, {time.monotonic() - start:.1f} s",
                  flush=True)
    result = {"program": version.strip(), "numbers": numbers, "failed": failed}
    pathlib.Path(arguments.output).write_text(json.dumps(result, indent=0) + "\n", encoding="utf-8")
    print(f"{len(numbers)} numbers in {arguments.output}; {len(failed)} cases refused or failed")
    return 0


# --- compare ------------------------------------------------------------------------------------------

def difference(before, after, scale):
    """Relative to the value, or to the scale if both vanish."""
    size = max(abs(before), abs(after))
    if size < VANISHES * scale:
        size = scale
    return abs(after - before) / size if before != after else 0.0


def read_reasons(path):
    """[(pattern, largest difference, reason)] of lines `pattern < 1e-6: reason`; # starts a comment."""
    rules = []
    for number, line in enumerate(path.read_text("utf-8").splitlines(), 1):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        found = re.fullmatch(r"(\S+)(?:\s+<\s+([\d.e+-]+))?: +(\S.*)", line)
        if not found:
            sys.exit(f"{path}:{number}: not a pattern and a reason; do: pattern: reason, or pattern < 1e-6: reason")
        rules.append((found[1], float(found[2] or "inf"), found[3]))
    return rules


def reason_for(name, relative, rules):
    return next((reason for pattern, largest, reason in rules
                 if fnmatch.fnmatchcase(name, pattern) and relative <= largest), None)


def differences(before, after):
    """(name, before, after, relative difference); None if a program has no such number."""
    for name, old in before["numbers"].items():
        new = after["numbers"].get(name)
        if new is None:
            yield name, old, None, math.inf
            continue
        model = name.split("/")[1]
        relative = difference(old, new, scale_of(name, before["numbers"]))
        if not relative <= TOLERANCE.get(model, TOLERANCE_OF_OTHERS):
            yield name, old, new, relative


def print_group(head, reason, rows, said, brief):
    largest = max(row[3] for row in rows)
    missing = sum(row[2] is None for row in rows)
    words = [f"{len(rows) - missing} differ, at most by {largest:.1e}"] if missing == 0 else \
        [f"{len(rows) - missing} differ", f"{missing} are gone"]
    print(f"{head}: {', '.join(words)}: {reason or 'NO REASON'}" + (f" (the program says: {said})" if said else ""))
    for name, old, new, relative in [] if brief or missing == len(rows) and said else rows:
        new_text = "gone" if new is None else f"{new:.15g}  {relative:.1e}"
        print(f"  {name.split('/', 2)[2]:<48} {old:.15g}  {new_text}")


def compare(arguments):
    before, after = (json.loads(pathlib.Path(path).read_text("utf-8"))
                     for path in (arguments.before, arguments.after))
    for side in (before, after):
        side["numbers"] = {name: value for name, value in side["numbers"].items()
                           if fnmatch.fnmatch("/".join(name.split("/")[:2]), arguments.only)}
    rules = read_reasons(pathlib.Path(arguments.reasons))
    groups = {}
    for row in differences(before, after):
        head = "/".join(row[0].split("/")[:2])
        groups.setdefault((head, reason_for(row[0], row[3], rules)), []).append(row)
    for (head, reason), rows in groups.items():
        print_group(head, reason, rows, after["failed"].get(head), arguments.brief)
    changed = sum(len(rows) for rows in groups.values())
    unexplained = sum(len(rows) for (_, reason), rows in groups.items() if reason is None)
    new = len(after["numbers"].keys() - before["numbers"].keys())
    print(f"{len(before['numbers'])} numbers: {changed} changed, {unexplained} without a reason; {new} are new")
    return 1 if unexplained else 0


def show(_):
    for case in pin_cases.ALL:
        print(f"{case.name}: {', '.join(case.models)}: {case.meaning}")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("record", help="run the cases and store their numbers")
    one.add_argument("--program", required=True, help="the rollfem to run (build/app/rollfem)")
    one.add_argument("-o", "--output", required=True, help="file for the numbers (.json)")
    one.add_argument("--cases", type=pathlib.Path, default=HERE.parent / "cases", help="folder of case files")
    one.add_argument("--only", default="*", help="pattern of case/model to run")
    one.set_defaults(do=record)
    two = commands.add_parser("compare", help="list the numbers that changed, with the reasons")
    two.add_argument("before")
    two.add_argument("after")
    two.add_argument("--reasons", default=HERE / "pin_reasons.txt", help="lines `pattern < 1e-6: reason`")
    two.add_argument("--only", default="*", help="pattern of case/model to compare")
    two.add_argument("--brief", action="store_true", help="one line per case and model")
    two.set_defaults(do=compare)
    commands.add_parser("list", help="describe the cases").set_defaults(do=show)
    arguments = parser.parse_args()
    return arguments.do(arguments)


if __name__ == "__main__":
    sys.exit(main())
