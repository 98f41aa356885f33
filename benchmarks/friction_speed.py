#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What friction laws cost: CPU seconds of a creep curve over those of Coulomb's law.

usage: benchmarks/friction_speed.py PROGRAM [--rounds 5] [--models halfspace,hybrid,fem] [--before OLDER_PROGRAM]

Runs a curve of 30 creepages on the ellipse of cases/falling_friction.toml (40 elements across; hybrid and fem: 20, and
8 creepages), in rounds that take all laws in turn, and prints the least CPU seconds (user and system, start of the
program included) and Newton steps. --before also runs Coulomb's law with a program from before there were laws.
"""
import argparse
import json
import os
import resource
import subprocess
import tempfile

CASE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cases", "falling_friction.toml")
LAW = ["kinetic_coefficient", "half_velocity", "memory_distance", "memory_velocity"]


def case_of(law, creepages, across):
    """The text of the case with that part of its friction."""
    keep = {"constant": [], "nothing falls": LAW[:2], "falling": LAW[:2]}.get(law, LAW)
    lines, section = [], ""
    for line in open(CASE, encoding="utf-8"):
        key = line.split("=")[0].strip()
        section = line.split("]")[0][1:] if line.startswith("[") else section
        if section == "layer" and law != "falling, memory, layer":
            continue
        if section == "friction" and (key in LAW and key not in keep or key == "law" and not keep):
            continue
        if key == "kinetic_coefficient" and law == "nothing falls":
            line = "kinetic_coefficient = 0.33\n"
        if key == "longitudinal_creepage":
            line = f"longitudinal_creepage = {creepages}\n"
        lines.append(f"elements_across = {across}\n" if key == "elements_across" else line)
    return "".join(lines)


def run(program, text, model):
    """CPU seconds and Newton steps."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([program, "run", path, "-m", model, "-q", "--no-report", "-o", os.path.join(folder, "out")],
                       check=True, env={**os.environ, "OMP_NUM_THREADS": "1", "ROLLFEM_CACHE": ""})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
            points = json.load(file)["models"][0]["points"]
    return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            sum(point["iterations"] for point in points))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--models", default="halfspace,hybrid,fem")
    parser.add_argument("--before")
    asked = parser.parse_args()
    laws = ["constant", "nothing falls", "falling", "falling, memory", "falling, memory, layer"]
    calls = [(law, asked.program) for law in laws] + ([("before", asked.before)] if asked.before else [])
    print("| model | friction | CPU s | over constant | Newton steps |\n|---|---|---|---|---|")
    for model in asked.models.split(","):
        count, across = (30, 40) if model == "halfspace" else (8, 20)
        creepages = [float(f"{0.001 * 250 ** (k / (count - 1)):.4g}") for k in range(count)]
        found = {}
        for _ in range(asked.rounds):
            for law, program in calls:
                text = case_of("constant" if law == "before" else law, creepages, across)
                found[law] = min(found.get(law, (1e30, 0)), run(program, text, model))
        for law, (seconds, steps) in found.items():
            print(f"| {model} | {law} | {seconds:.3g} | {seconds / found['constant'][0]:.2f} | {steps:.0f} |", flush=True)


if __name__ == "__main__":
    main()
