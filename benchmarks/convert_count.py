#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts the cases of CONTACT's inputs that `rollfem convert` converts, and why it refuses the others.

    convert_count.py FOLDER --program build/app/rollfem

Every *.inp of FOLDER is converted into a temporary folder (with --partial), and `rollfem check` is run on every case file.
Prints the table of docs/coming_from_contact.md. Status 1 if a case file does not pass."""
import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile


def numbers(text):
    """How many cases "1, 3 to 30" are."""
    return sum(int(last or first) - int(first) + 1 for first, last in re.findall(r"(\d+)(?: to (\d+))?", text))


def convert(program, source, folder):
    """(cases converted, {reason: cases refused}, files that fail `check`)."""
    done = subprocess.run([program, "convert", str(source), "--partial", "-o", str(folder)], capture_output=True,
                          text=True, check=False)
    made, refused, failing = 0, collections.Counter(), []
    for line in done.stdout.splitlines():
        if found := re.match(r"(\S+\.toml): cases? (.*)$", line):
            made += numbers(found[2])
            check = subprocess.run([program, "check", found[1]], capture_output=True, text=True, check=False)
            if check.returncode:
                failing.append(f"{found[1]}: {check.stderr.strip()}")
    seen = set()
    for line in (done.stdout + done.stderr).splitlines():
        if found := re.match(r"cases? ([\d, to]+): (no equivalent: )?(.*)", line):
            if found[1] in seen:
                continue  # one reason for each case, the first
            seen.add(found[1])
            reason = re.sub(r"'[^']*'|\S+\.(?:toml|prr|prw|ban|whl|slcs|slcw)[:\d]*", "...", found[3]).split(";")[0]
            refused[reason[:90]] += numbers(found[1])
    if not made and not refused:
        refused[f"not read: {done.stderr.strip().split(': ', 2)[-1][:90]}"] += 1
    return made, refused, failing


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", default="build/app/rollfem")
    options = parser.parse_args()
    reasons, failing = collections.Counter(), []
    total = refused_cases = 0
    print("| input | converted | refused |\n|---|---|---|")
    for source in sorted(options.folder.glob("*.inp")):
        with tempfile.TemporaryDirectory() as folder:
            made, refused, wrong = convert(options.program, source, pathlib.Path(folder))
        print(f"| {source.stem} | {made} | {sum(refused.values()) or ''} |", flush=True)
        total, refused_cases, reasons, failing = (total + made, refused_cases + sum(refused.values()),
                                                  reasons + refused, failing + wrong)
    print(f"| all | {total} | {refused_cases} |\n")
    for reason, count in reasons.most_common():
        print(f"{count:5} {reason}")
    for text in failing:
        print(f"does not pass check: {text}", file=sys.stderr)
    return 1 if failing else 0


if __name__ == "__main__":
    sys.exit(main())
