#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks benchmarks/pins.py: a file of numbers agrees with itself; one number changed is named, and is without a
reason until a pattern has one. Call: pins.py SOURCE_DIR"""

import json
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1])
BENCHMARKS = SOURCE / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))
import pin_cases  # noqa: E402
import pins  # noqa: E402

SUMMARY = {"models": [
    {"name": "halfspace", "seconds": {"total": 1.0}, "unknowns": 3816, "contact_elements": 1272,
     "points": [{"normal_force": 5e4, "longitudinal_force": -8e3, "lateral_force": 7e-5, "iterations": 4,
                 "seconds": 0.1, "converged": True, "error_estimate": {"longitudinal_force": 4e-3},
                 "derived": {"elastic_energy": 1232.8},
                 "stress_maxima": [{"body": "rail", "measure": "tresca", "value": 500.0,
                                    "place": [0.1, 0.0, -2.0]}]}]},
    {"name": "fem", "seconds": {}, "unknowns": 60000, "contact_elements": 120,
     "place": {"wheel": "left", "position": 1, "patch": 0, "contact_angle": 0.02},
     "points": [{"normal_force": 5e4, "approach": 0.05}]}]}

# name of the number, factor, whether that is a change
CHANGES = [
    ("case/halfspace/plane/0/longitudinal_force", 1.0 + 1e-8, True),
    ("case/halfspace/plane/0/longitudinal_force", 1.0 + 1e-10, False),
    ("case/halfspace/plane/0/lateral_force", 1.1, False),  # 7e-6 N of 50 kN
    ("case/halfspace/plane/0/lateral_force", 3.0, True),
    ("case/fem/left-1-0/0/approach", 1.0 + 1e-8, False),
    ("case/fem/left-1-0/0/approach", 1.0 + 1e-6, True),
]


def written(folder, name, numbers):
    path = folder / name
    path.write_text(json.dumps({"numbers": numbers, "failed": {}}), "utf-8")
    return str(path)


def compared(*arguments):
    run = subprocess.run([sys.executable, str(BENCHMARKS / "pins.py"), "compare", *arguments], text=True,
                         capture_output=True, check=False)
    return run.returncode, run.stdout + run.stderr


def check(holds, what):
    if not holds:
        sys.exit(f"pins: {what}")


def check_names(found):
    wanted = {"plane/unknowns", "plane/contact_elements", "plane/0/normal_force", "plane/0/longitudinal_force",
              "plane/0/lateral_force", "plane/0/converged", "plane/0/error_estimate.longitudinal_force",
              "plane/0/elastic_energy", "plane/0/stress_maxima.rail.tresca.value",
              *(f"plane/0/stress_maxima.rail.tresca.place.{i}" for i in range(3))}
    names = {name.removeprefix("case/halfspace/") for name in found if "/halfspace/" in name}
    check(names == wanted, f"names of the numbers: {sorted(names ^ wanted)}")
    check("case/fem/left-1-0/contact_angle" in found, "the place of a patch is not kept")


def check_comparison(folder, numbers):
    before = written(folder, "before.json", numbers)
    none = folder / "none.txt"  # those of the day are not the test's
    none.write_text("", "utf-8")
    status, text = compared(before, before, "--reasons", str(none))
    check(status == 0 and " 0 changed" in text, f"a file differs from itself: {text}")
    for name, factor, changed in CHANGES:
        after = written(folder, "after.json", {**numbers, name: numbers[name] * factor})
        status, text = compared(before, after, "--reasons", str(none))
        check(status == (1 if changed else 0), f"{name} times {factor}: {text}")
        if changed:
            check(name.split("/", 2)[2] in text and "NO REASON" in text, f"{name} is not named: {text}")
            reasons = folder / "reasons.txt"
            reasons.write_text(f"# why\n*/{name.split('/')[-1]}: it was wrong\n", "utf-8")
            status, text = compared(before, after, "--reasons", str(reasons))
            check(status == 0 and "it was wrong" in text, f"the reason is not found: {text}")
            reasons.write_text("* < 1e-9: it was wrong\n", "utf-8")
            status, text = compared(before, after, "--reasons", str(reasons))
            check(status == 1 and "NO REASON" in text, f"the reason holds too far: {text}")
    fewer = {name: value for name, value in numbers.items() if not name.endswith("approach")}
    after = written(folder, "after.json", fewer)
    status, text = compared(before, after)
    check(status == 1 and "1 are gone" in text, f"a number that is gone: {text}")
    status, text = compared(before, after, "--only", "*/halfspace")
    check(status == 0, f"a part that did not change: {text}")


def check_cases():
    names = [case.name for case in pin_cases.ALL]
    check(len(names) == len(set(names)), "two cases have one name")
    text = pin_cases.with_keys("[load]\na = 1\n\n[history]\nb = [\n  1,\n  2,\n]\nc = 3\n",
                               {"history.b": "[4]", "load.a": None, "accuracy": "0.1", "output.fields": "false"})
    check(text == "accuracy = 0.1\n[load]\n\n[history]\nb = [4]\nc = 3\n\n[output]\nfields = false\n",
          f"keys of a case file: {text}")
    for case in pin_cases.ALL:
        check(all(case.texts(SOURCE / "cases")), f"{case.name} has no text")


with tempfile.TemporaryDirectory() as temporary:
    found = pins.numbers_of(SUMMARY, "case")
    check_names(found)
    check_comparison(pathlib.Path(temporary), found)
check_cases()
print("pins: a change is seen, and its reason")
