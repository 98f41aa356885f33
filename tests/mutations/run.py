#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Breaks the program on purpose, one line at a time, and checks that the tests detect it.

    tests/mutations/run.py --build /tmp/mutations                      the half-space's mutations
    tests/mutations/run.py --build /tmp/mutations-fem --fem --only 'fem_*'

Every mutation of mutations.py goes into a copy of the sources, BUILD, which is built incrementally in
BUILD/build; the tree itself is never changed. First the suspects of the mutation run,
then, where they see nothing, all tests, unit and verification first. Status 0: all were caught; 1: one
survives; 2: nothing to be learned (the unmutated copy fails, a mutation does not compile).
"""

import argparse
import fnmatch
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from mutations import MUTATIONS

ROOT = Path(__file__).resolve().parents[2]
LABELS = ("unit", "verification", "hard", "cli")
OPEN_MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def run(command, **options):
    return subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**OPEN_MPI, **os.environ}, **options)


def write_changed(path, data):
    """Leaves identical files untouched to avoid recompiling them."""
    if path.is_file() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def copy_sources(copy):
    """Copies the files known to git from the work tree and removes others."""
    listed = run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"])
    names = {name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file()}
    for name in sorted(names):
        write_changed(copy / name, (ROOT / name).read_bytes())
        shutil.copymode(ROOT / name, copy / name)
    for folder in {name.split("/")[0] for name in names if "/" in name}:
        for path in list((copy / folder).rglob("*")):
            if path.is_file() and str(path.relative_to(copy)) not in names:
                path.unlink()


class Workshop:
    """The copy of the sources, its build and its tests."""

    def __init__(self, args):
        self.source = args.build.resolve()
        self.build = self.source / "build"
        self.jobs = args.jobs
        self.tests = args.tests
        copy_sources(self.source)
        configured = run(["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build,
                          "-DCMAKE_BUILD_TYPE=Mutation", "-DCMAKE_CXX_FLAGS_MUTATION=-O1",
                          f"-DROLLFEM_FEM={'ON' if args.fem else 'OFF'}", *args.cmake])
        if configured.returncode != 0:
            sys.exit(f"run.py: cmake fails; do: read what it says\n{configured.stdout}")

    def compile(self, targets):
        """The compiler's errors; empty if there are none."""
        made = run(["ninja", "-C", self.build, f"-j{self.jobs}", *targets])
        return "" if made.returncode == 0 else made.stdout[-3000:]

    def program(self, suspect):
        """The program of the suspect's folder; tests of the command line call that of the user."""
        group, name = suspect.split(":")[0].split("_", 1)
        if group in ("cli", "python"):
            return "rollfem_program"
        if group == "book":
            return "book_tests"
        room = next((ROOT / "tests" / group).rglob(f"{name}.cpp")).parent.relative_to(ROOT / "tests")
        program = "_".join(room.parts)
        return f"{program}_fem" if name.startswith("fem_") and "_fem" not in program else program

    def pattern(self, suspect):
        """GoogleTest's filter for the tests of the suspect's file, or the one that it names."""
        name, _, pattern = suspect.partition(":")
        if pattern:
            return pattern
        group, name = name.split("_", 1)
        text = next((ROOT / "tests" / group).rglob(f"{name}.cpp")).read_text()
        suites = set(re.findall(r"^TEST(?:_[FP])?\((\w+),", text, re.MULTILINE))
        return ":".join(f"*{suite}.*" for suite in sorted(suites))

    def first_failure(self, suspect):
        """Name of the first test of a program that fails, or None."""
        if suspect.startswith(("cli_", "python_", "book_")):
            test = suspect.replace("_", ".", 1)
            return None if self.passes(test) else test
        ran = run([self.build / "tests" / self.program(suspect), "--gtest_fail_fast", "--gtest_brief=1",
                   f"--gtest_filter={self.pattern(suspect)}"], cwd=self.build)
        if ran.returncode == 0:
            return None
        found = re.search(r"\[  FAILED  \] (\w+\.\w+)", ran.stdout)
        return f"{suspect.split('_')[0]}.{found[1]}" if found else f"{suspect} ends early"

    def first_of_all(self):
        """The same by CTest over all tests, or those that --tests names."""
        for label in LABELS:
            command = ["ctest", "--test-dir", self.build, "-L", f"^{label}$", "--stop-on-failure",
                       f"-j{self.jobs}"] + (["-R", self.tests] if self.tests else [])
            ran = run(command)
            found = re.search(r"- (\S+) \((?:Failed|SEGFAULT|Timeout|.*Exception)", ran.stdout)
            if ran.returncode != 0 and found:
                return found[1]
        return None

    def passes(self, test):
        return run(["ctest", "--test-dir", self.build, "-R", f"^{re.escape(test)}$"]).returncode == 0

    def examine(self, mutation, quick):
        """(word, test): caught, survived or broken."""
        path = self.source / mutation.file
        sound = path.read_bytes()
        try:
            path.write_text(sound.decode().replace(mutation.find, mutation.put))
            for suspect in mutation.suspects:
                said = self.compile([self.program(suspect)])
                if said:
                    return "broken", said
                failed = self.first_failure(suspect)
                if failed:
                    return "caught", failed
            if quick:
                return "survived", "its suspects"
            said = self.compile([])
            if said:
                return "broken", said
            failed = self.first_of_all()
        finally:
            path.write_bytes(sound)
        if not failed:
            return "survived", "all tests"
        self.compile([])
        if not self.passes(failed):
            return "broken", f"{failed} fails without the mutation, too"
        return "caught", failed


def chosen(args):
    wanted = [m for m in MUTATIONS if m.fem == args.fem]
    return [m for m in wanted if not args.only or any(fnmatch.fnmatch(m.name, p) for p in args.only)]


def sound_suspects(workshop, mutations):
    """Suspects that fail without a mutation prove nothing."""
    suspects = sorted({s for m in mutations for s in m.suspects})
    said = workshop.compile(sorted({workshop.program(s) for s in suspects}))
    if said:
        sys.exit(f"run.py: the sources do not compile; do: build them first\n{said}")
    return [f"{s}: {failed}" for s in suspects if (failed := workshop.first_failure(s))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=Path, required=True, help="scratch folder, made where absent")
    parser.add_argument("--fem", action="store_true", help="the mutations of fem/, built with deal.II")
    parser.add_argument("--only", action="append", metavar="NAME", help="pattern of names; repeatable")
    parser.add_argument("--tests", metavar="REGEX", help="of all tests only these, as ctest -R")
    parser.add_argument("--suspects-only", action="store_true", help="not all tests where these see nothing")
    parser.add_argument("--trust", action="store_true", help="do not run the suspects unmutated first")
    parser.add_argument("--cmake", action="append", default=[], metavar="ARG", help="for cmake; repeatable")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    mutations = chosen(args)
    if not mutations:
        sys.exit("run.py: no mutation has such a name; do: look into mutations.py")
    workshop = Workshop(args)
    if not args.trust and (failing := sound_suspects(workshop, mutations)):
        print("run.py: fail without any mutation:", *failing, sep="\n  ")
        return 2
    words = []
    for mutation in mutations:
        begin = time.monotonic()
        word, test = workshop.examine(mutation, args.suspects_only)
        words.append(word)
        print(f"{mutation.name:28} {word:9} {test}  ({time.monotonic() - begin:.0f} s)", flush=True)
    print(", ".join(f"{words.count(w)} {w}" for w in ("caught", "survived", "broken")))
    return 2 if "broken" in words else 1 if "survived" in words else 0


if __name__ == "__main__":
    sys.exit(main())
