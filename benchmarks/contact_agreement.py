#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Differences between rollfem and CONTACT on CONTACT's inputs: converts, runs and compares.

    contact_agreement.py FOLDER... --program build/app/rollfem [--only NAME...] [--count]

Each FOLDER holds NAME.inp with NAME.ref_out, the output of CONTACT, beside a folder profiles. Prints the table of
docs/coming_from_contact.md, the largest difference over the cases of each input in percent (CONTACT prints four digits),
and why cases were refused. With --count it only converts and checks. tests/python/peers.py uses the same functions."""
import argparse
import collections
import dataclasses
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

COLUMNS = ["F_n", "p0", "approach", "F_x", "F_y", "M_z", "creepage, shift"]
NUMBER = r"[-+]?[0-9]*\.?[0-9]+(?:[eE][-+]?[0-9]+)?\.?"
SMALL = 0.1  # part of the force of a wheel below which the pressure of a patch is not compared


def values(line):
    return [float(word) for word in re.findall(NUMBER, line)]


def numbers(text):
    """[1, 3, 4, 5] of "1, 3 to 5"."""
    return [number for first, last in re.findall(r"(\d+)(?: to (\d+))?", text)
            for number in range(int(first), int(last or first) + 1)]


def printed_cases(path):
    """Case number -> its patches, from the largest force on, with the values that CONTACT printed."""
    parts = re.split(r"^ Case +", path.read_text(errors="replace"), flags=re.M)[1:]
    named = [int(re.match(r"\d+", part)[0]) for part in parts]
    unique = len(set(named)) == len(named)  # several result elements count anew
    cases = {}
    for k, part in enumerate(parts):
        lines, patches = part.splitlines(), []
        for at, line in enumerate(lines[:-1]):
            if re.match(r" +(?:BAR_)?FN +(?:BAR_)?FX +(?:BAR_)?F[YS] +M[ZN]", line):
                patches.append(dict(zip(("fn", "fx", "fy", "mz"), values(lines[at + 1]))))
            elif re.match(r" +(?:FN/G|TILDE_FN) ", line) and patches:
                patches[-1].update(zip(re.findall(r"(?:SHIFT|CREEP) [XY]|\S+", line), values(lines[at + 1])))
        cases[named[k] if unique else k + 1] = sorted(patches, key=lambda patch: -patch["fn"])
    return cases


def place(source, folder):
    """The input in a folder from which it finds its profiles; some name them from the folder above."""
    work = folder / "inputs" / "x"
    work.mkdir(parents=True)
    for found in (*source.parent.glob("*.pr[rw]"), *source.parent.parent.glob("*.pr[rw]")):
        (work / found.name).symlink_to(found)
    for target in (work / "profiles", work.parent / "profiles"):
        target.symlink_to(source.parent / "profiles")
    return shutil.copy(source, work)


@dataclasses.dataclass
class Measured:
    """What became of an input."""
    cases: int = 0
    converted: int = 0
    run: int = 0
    apart: int = 0  # run with other numbers of patches
    refused: collections.Counter = dataclasses.field(default_factory=collections.Counter)
    failed: list = dataclasses.field(default_factory=list)
    largest: dict = dataclasses.field(default_factory=dict)  # quantity -> percent, case

    def add(self, quantity, case, ours, printed, scale):
        if scale:
            off = 100.0 * abs(ours - printed) / abs(scale)
            self.largest[quantity] = max((off, case), self.largest.get(quantity, (0.0, 0)))


def compare(made, case, ours, printed, text):
    """Adds the patches of a case, both from the largest force on."""
    mu = max(values(re.search(r"^coefficient = (.*?)(?:#|$)", text, re.M)[1]))
    on_rail = "[wheelset]" in text  # module 1 states forces on the rail
    turned = "half a turn" in text  # CHI = 180
    sign_x, sign_y = -1.0 if turned or on_rail else 1.0, -1.0 if turned else 1.0
    whole = sum(patch["fn"] for patch in printed)
    bound = mu * whole
    if len(ours) != len(printed):  # other parts: the whole wheel
        made.apart += 1
        made.add("F_n", case, sum(patch["normal_force"] for patch in ours), whole, whole)
        made.add("F_x", case, sign_x * sum(patch["longitudinal_force"] for patch in ours),
                 sum(patch["fx"] for patch in printed), bound)
        return
    for got, wanted in zip(ours, printed):
        of = lambda key, there=got: there.get(key) or 0.0
        fn = wanted["fn"]
        made.add("F_n", case, of("normal_force"), fn, whole)
        made.add("F_x", case, sign_x * of("longitudinal_force"), wanted["fx"], bound)
        made.add("F_y", case, sign_y * of("lateral_force"), wanted["fy"], bound)
        if min(fn, of("normal_force")) < SMALL * whole:
            continue
        # With a parabolic bound CONTACT prints the peak of the bound, 4/3 of Hertz's.
        if "PMAX" in wanted and 'bound = "parabolic"' not in text:
            made.add("p0", case, got["max_pressure"], wanted["PMAX"], wanted["PMAX"])
        if "APPROACH" in wanted:
            made.add("approach", case, of("approach"), wanted["APPROACH"], wanted["APPROACH"])
        if not on_rail:
            made.add("M_z", case, of("spin_moment"), wanted["mz"], bound * math.sqrt(of("contact_area") / math.pi))
        for name, key in (("SHIFT X", "longitudinal_shift"), ("CREEP X", "longitudinal_creepage")):
            if name in wanted and got.get(key):
                made.add("creepage, shift", case, -got[key] if turned else got[key], wanted[name], wanted[name])


def convert(program, source, folder, cases=""):
    """(case files with their cases, reasons of the cases refused, with their number)."""
    done = subprocess.run([program, "convert", source, "--partial", "-o", folder] + (["--cases", cases] if cases else []),
                          capture_output=True, text=True, check=False)
    files, refused, seen = {}, collections.Counter(), set()
    for line in (done.stdout + done.stderr).splitlines():
        if found := re.match(r"(\S+\.toml): cases? (.*)$", line):
            files[found[1]] = numbers(found[2])
        elif (found := re.match(r"cases? ([\d, to]+): no equivalent: (.*)", line)) and found[1] not in seen:
            seen.add(found[1])  # one reason for each case, the first
            reason = re.sub(r"\S+\.(?:toml|prr|prw|ban|whl|slcs|slcw)\S*", "...", found[2]).split(";")[0]
            refused[reason[:90]] += len(numbers(found[1]))
    if not files and not refused:
        refused[f"not read: {done.stderr.strip()[-90:]}"] += 1
    return files, refused


def run(program, path, cases, printed, made):
    """Runs a case file and compares its cases; the error of a run that fails."""
    folder = pathlib.Path(path).with_suffix("")
    done = subprocess.run([program, "run", path, "-o", folder, "--no-report", "--set", "output.fields=false", "--set",
                           'output.grid_fields="none"'], capture_output=True, text=True, check=False)
    if done.returncode:
        return done.stderr.strip()[-300:]
    patches = collections.defaultdict(list)
    for model in json.loads((folder / "summary.json").read_text())["models"]:
        position = int((model.get("place") or {}).get("position", 1))
        for k, point in enumerate(model["points"]):
            patches[k if len(model["points"]) == len(cases) else position - 1].append(point)
    made.run += len(cases)
    text = pathlib.Path(path).read_text()
    for k, case in enumerate(cases):
        if printed.get(case):  # where CONTACT printed something
            ours = sorted(patches[k], key=lambda point: -point["normal_force"])
            compare(made, case, ours, printed[case], text)
    return ""


def measure(program, source, last=None, count=False):
    """Converts an input and runs it, up to case `last`; `count`: checks the case files instead."""
    made = Measured()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        placed = place(source, folder)
        files, made.refused = convert(program, placed, folder / "all" / "cases")
        made.converted = sum(map(len, files.values()))
        made.cases = made.converted + sum(made.refused.values())
        for path, cases in files.items() if count else ():
            check = subprocess.run([program, "check", path], capture_output=True, text=True, check=False)
            made.failed += [f"cases {cases}: {check.stderr.strip()[-300:]}"] if check.returncode else []
        if count or last == 0:
            return made
        output = source.with_suffix(".ref_out")
        printed = printed_cases(output) if output.exists() else {}
        if last is not None:
            files, _ = convert(program, placed, folder / "first" / "cases", f"1-{last}")
        for path, cases in files.items():
            if not (wrong := run(program, path, cases, printed, made)):
                continue
            if len(cases) == 1:
                made.failed.append(f"case {cases[0]}: {wrong}")
            for case in cases if len(cases) > 1 else ():  # those that run by themselves
                for alone in convert(program, placed, folder / str(case) / "cases", str(case))[0]:
                    if wrong := run(program, alone, [case], printed, made):
                        made.failed.append(f"case {case}: {wrong}")
    return made


def row(name, made):
    cells = [f"{made.largest[c][0]:.3f}" if c in made.largest else "" for c in COLUMNS]
    return f"| {name} | {made.cases} | {made.converted} | {made.run} | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", type=pathlib.Path, nargs="+")
    parser.add_argument("--program", required=True, type=pathlib.Path)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--count", action="store_true", help="convert and check only")
    call = parser.parse_args()
    whole = Measured()
    print("| input | cases | converted | run | " + " | ".join(COLUMNS) + " |\n" + "|---" * (len(COLUMNS) + 4) + "|")
    for source in sorted(path.resolve() for folder in call.folders for path in folder.glob("*.inp")):
        if call.only and source.stem not in call.only:
            continue
        made = measure(call.program.resolve(), source, count=call.count)
        print(row(source.stem, made), flush=True)
        for text in made.failed:
            print(f"{source.stem}: {text}", file=sys.stderr)
        for key in ("cases", "converted", "run", "refused", "failed"):
            setattr(whole, key, getattr(whole, key) + getattr(made, key))
    print(row("all", whole) + "\n")
    for reason, count in whole.refused.most_common():
        print(f"{count:5} {reason}")
    return 1 if whole.failed else 0


if __name__ == "__main__":
    sys.exit(main())
