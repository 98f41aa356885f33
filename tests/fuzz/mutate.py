#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutates case files, profiles, lattices and input files of CONTACT and looks for what must not happen: a signal, a
hang, an 'internal error', an exit status other than 0, 1 and 2, a result that cannot be.

    tests/fuzz/mutate.py --build build-halfspace                     the figures of docs/developing.md
    tests/fuzz/mutate.py --build build-halfspace --cases 1000 --profiles 0 --lattices 0 --inputs 0 --runs 0 --checks 0

Inputs are made from the cases and profiles of the source by a seeded generator. Most go through the fuzz
targets in one process (fuzz_*_replay --records), some through `rollfem check` and `rollfem run`. What fails is
kept in a folder, with the seed and the number that make it again. Exit status: 0 nothing failed, 1 something did."""
import argparse
import collections
import math
import os
import pathlib
import random
import re
import select
import shutil
import subprocess
import sys
import time

from sound import unsound

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "robustness"))
from campaign import call, fault, work_of

try:
    import tomllib
except ImportError:  # before Python 3.11: the grammar is not compared
    tomllib = None

LIMIT = 5.0  # s of its own processor time, as the machine may be shared
PATIENCE = 60.0  # s in all
NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
EXTREMES = [b"0", b"-0.0", b"1", b"-1", b"1e-320", b"1e-300", b"-1e-12", b"1e-6", b"1e-3", b"0.5", b"1.6", b"7", b"100", b"1e4", b"1e6", b"1e9",
            b"-1e9", b"1e12", b"1e300", b"1e400", b"inf", b"-inf", b"nan", b"2147483647", b"2147483648", b"-2147483649",
            b"9223372036854775807", b"9223372036854775808", b"0x7fffffff", b"true", b'""', b"[]", b"[[1]]", b"{}",
            b"1979-05-27", b"1_000", b"0.1e-7", b'"1:40"', b"3.14159265358979"]
PIECES = [b"[", b"]", b"[[", b"]]", b"{", b"}", b"=", b".", b",", b"#", b'"', b"'", b'"""', b"\\", b"\x00", b"\x07", b"\xc2\x85", b"\xc3\xa9",
          b"\xff", b"\xef\xbb\xbf", b"\r", b"\n", b"\t", b"\xe2\x80\xa8", b"\\u00e9", b"\x7f", b" "]


def swap_number(rng, text, pool):
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    at = rng.choice(found)
    kind = rng.randrange(4)
    if kind == 0:
        new = rng.choice(EXTREMES)
    elif kind == 1:
        new = rng.choice(found).group()
    elif kind == 2:
        new = b"-" + at.group().lstrip(b"+-") if not at.group().startswith(b"-") else at.group()[1:]
    else:
        new = b"%.6g" % (float(at.group()) * 10.0 ** rng.uniform(-6, 6))
    return text[:at.start()] + new + text[at.end():]


def change_bytes(rng, text, pool):
    data = bytearray(text)
    for _ in range(rng.choice((1, 1, 2, 8))):
        if not data:
            break
        at = rng.randrange(len(data))
        kind = rng.randrange(3)
        if kind == 0:
            data[at] = rng.randrange(256)
        elif kind == 1:
            del data[at:at + rng.choice((1, 1, 3, 40))]
        else:
            data[at:at] = rng.choice(PIECES)
    return bytes(data)


def change_lines(rng, text, pool):
    lines = text.split(b"\n")
    a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
    kind = rng.randrange(6)
    if kind == 0:
        lines[a], lines[b] = lines[b], lines[a]
    elif kind == 1:
        lines.insert(b, lines[a])
    elif kind == 2:
        del lines[a]
    elif kind == 3:
        other = rng.choice(pool).split(b"\n")
        lines.insert(a, rng.choice(other))
    elif kind == 4:
        del lines[min(a, b):max(a, b)]
    else:
        other = rng.choice(pool).split(b"\n")
        c = rng.randrange(len(other))
        lines[a:a] = other[c:c + rng.choice((2, 5, 20))]
    return b"\n".join(lines)


def value_of_another_key(rng, text, pool):
    lines = text.split(b"\n")
    given = [k for k, line in enumerate(lines) if b"=" in line]
    others = [line for line in rng.choice(pool).split(b"\n") if b"=" in line]
    if not given or not others:
        return text
    at = rng.choice(given)
    value = rng.choice(others).split(b"=", 1)[1] if rng.random() < 0.7 else b" " + rng.choice(EXTREMES)
    lines[at] = lines[at].split(b"=", 1)[0] + b"=" + value
    return b"\n".join(lines)


def mutant(rng, pool):
    text = rng.choice(pool)
    ways = (swap_number, swap_number, change_bytes, change_lines, value_of_another_key)
    for _ in range(rng.choice((1, 1, 2, 3, 6))):
        text = rng.choice(ways)(rng, text, pool)
    return text


def kind_of(line):
    if line == "ok":
        return "taken"
    return "no solution" if line.startswith("no solution") else "refused"


class Replay:
    """A fuzz target that is given inputs one by one; started again when one ended it."""

    def __init__(self, program):
        self.program, self.process = program, None

    def outcome(self, data):
        """(kind, text): taken, refused, no solution, signal, hang, odd"""
        if self.process is None:
            self.process = subprocess.Popen([self.program, "--records"], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            self.process.stdin.write(len(data).to_bytes(4, "little") + data)
            self.process.stdin.flush()
            begin, used = time.monotonic(), work_of(self.process.pid)
            while not select.select([self.process.stdout], [], [], 0.5)[0]:
                if work_of(self.process.pid) - used > LIMIT or time.monotonic() - begin > PATIENCE:
                    return self.ended("hang", f"no answer in {LIMIT:g} s")
            line = self.process.stdout.readline().decode("utf-8", "replace")
        except BrokenPipeError:
            line = ""
        if not line:
            return self.ended("signal", "")
        line = line.rstrip("\n")
        if line != "ok" and "do: " not in line:
            return self.ended("odd", line)  # a message of several lines would be taken for the next ones
        return kind_of(line), line

    def ended(self, kind, text):
        self.process.kill()
        text += self.process.stderr.read().decode("utf-8", "replace")[-2000:]
        status = self.process.wait()
        self.process = None
        return kind, f"{text} (status {status})"


class Program:
    """`rollfem check` or `run`, a process for each input, in a folder with the files that cases name."""

    def __init__(self, program, folder, command, limit):
        self.call = [str(program), command]
        self.folder, self.command, self.limit = folder, command, limit

    def outcome(self, data):
        case = self.folder / "mutant.toml"
        case.write_bytes(data)
        result = self.folder / "result"
        shutil.rmtree(result, ignore_errors=True)
        command = self.call + [str(case)]
        if self.command == "run":
            command += ["--quiet", "-o", str(result), "--model", "halfspace"]
        status, said = call(command, self.folder, math.ceil(self.limit))
        if status is None:
            return "hang", f"no end in {self.limit:g} s of processor time"
        if wrong := fault(status, said, True):
            return ("signal" if status < 0 else "odd"), f"{wrong}: {said[-2000:]}"
        if status == 0 and self.command == "run":
            wrong = unsound(result)
            if wrong:
                return "odd", f"status 0 with {wrong}"
        return ("taken", "no solution", "refused")[status], said


def grammar_differs(data, kind, line):
    """Whether Python's reader of TOML takes what ours refuses, other than numbers beyond 64 bits and deep nesting."""
    if tomllib is None or "not valid TOML" not in line:
        return False
    try:
        tomllib.loads(data.decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError, ValueError):
        return False
    return not any(known in line for known in ("nested more than", "64 bits", "as a value"))


class Campaign:
    def __init__(self, seed, keep):
        self.seed, self.keep = seed, keep
        self.failures = 0

    def run(self, name, count, tester, pool, suffix, compare=None):
        if count == 0:
            return
        rng = random.Random(f"{self.seed} {name}")
        kinds, slowest, begin = collections.Counter(), 0.0, time.monotonic()
        for number in range(count):
            data = mutant(rng, pool)
            before = time.monotonic()
            kind, line = tester.outcome(data)
            slowest = max(slowest, time.monotonic() - before)
            if compare and compare(data, kind, line):
                kind = "grammar"
            kinds[kind] += 1
            if kind not in ("taken", "refused", "no solution"):
                self.failures += 1
                self.keep.mkdir(parents=True, exist_ok=True)
                stem = f"{name.replace(' ', '_')}_{self.seed}_{number}"
                (self.keep / (stem + suffix)).write_bytes(data)
                (self.keep / (stem + ".said")).write_text(f"{kind}: {line}\n")
                print(f"  {kind}: {stem}{suffix}: {line[:300]}", flush=True)
        told = ", ".join(f"{number} {kind}" for kind, number in sorted(kinds.items()))
        print(f"{name}: {count} in {time.monotonic() - begin:.0f} s, the longest {slowest:.2f} s: {told}", flush=True)


def read_all(folder, patterns):
    return [path.read_bytes() for pattern in patterns for path in sorted(folder.rglob(pattern)) if path.stat().st_size < 40000]


def small(case):
    """The same case on a coarse grid, so that a run takes a moment."""
    text = re.sub(rb"(?m)^elements_across *=.*$", b"elements_across = 10", case)
    return re.sub(rb"(?m)^cell_size *= *\[.*$", b"elements_across = 10", text)


def lattices(columns):
    made = []
    for separator in (b" ", b", ", b";"):
        rows = [b"# x y values"] + [separator.join([b"%.6g" % x, b"%.6g" % y] + [b"%.8g" % (1e-3 * (x * x + y * y))] * columns)
                                     for y in (-3, -1.5, 0, 1.5, 3) for x in (-2, -1, 0, 1, 2, 3)]
        made.append((b"2" if columns == 2 else b"1") + b"\n".join(rows) + b"\n")
    return made


def profiles():
    made = []
    keys = ("", " flip", " mirror reverse", " sort drop_duplicates", " drop_zigzag smoothing", " rounding kinks thinning", " inch", " m sort kinks")
    arc = [(0.5 * k, 0.002 * k * k) for k in range(-60, 61)]
    wheel = [(y, 25.0 if y < -45 else 25.0 * (-20 - y) / 25 if y < -20 else 0.0) for y in range(-60, 60, 2)]
    for body, points in (("rail", arc), ("wheel", wheel)):
        rows = "".join(f"{y:.4f} {z:.4f}\n" for y, z in points)
        for name, text in (("p.txt", rows), ("p.csv", "y,z\n" + rows.replace(" ", ",")), ("p.whl", "ColumnDef=X,Y\nDate=1\n\n" + rows),
                           ("p.prr" if body == "rail" else "p.prw", "header.begin\ntype = " + str(int(body == "wheel")) +
                            "\nheader.end\nspline.begin\npoint.dist.min = 0\nshift.y = 0\nrotate = 0\nbound.y.min = 0\nbound.y.max = 0\n"
                            "mirror.y = 0\nunits.len.f = 1000\nunits.ang.f = 1\npoint.begin\n" + rows + "point.end\nspline.end\n")):
            made += [f"{body} {name}{mend}\n{text}".encode() for mend in keys]
    made += [b"wheel p.csv\n" + text for text in read_all(ROOT / "cases" / "profiles", ["*.csv", "*.txt"])]
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path, help="build folder with the replay programs and rollfem")
    parser.add_argument("--seed", type=int, default=1)
    for name, count in (("cases", 100000), ("profiles", 10000), ("lattices", 10000), ("inputs", 10000), ("checks", 2000), ("runs", 1000)):
        parser.add_argument("--" + name, type=int, default=count, metavar="N")
    parser.add_argument("--run-limit", type=float, default=30.0, help="s for a run, which may be asked for much")
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("results/mutants"), help="folder for what fails")
    options = parser.parse_args()
    os.environ.update(ROLLFEM_PYTHON="/bin/true", OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    cases = read_all(ROOT / "cases", ["*.toml"]) + [
        subprocess.run([options.build / "app" / "rollfem", "new-case"], capture_output=True, check=True).stdout]
    tests = options.build / "tests" / "fuzz"
    campaign = Campaign(options.seed, options.keep)
    print(f"seed {options.seed}, {len(cases)} cases to begin with", flush=True)
    campaign.run("cases", options.cases, Replay(tests / "fuzz_case_file_replay"), cases, ".toml", grammar_differs)
    campaign.run("profiles", options.profiles, Replay(tests / "fuzz_profile_replay"), profiles(), ".txt")
    campaign.run("lattices", options.lattices, Replay(tests / "fuzz_lattice_replay"), lattices(1) + lattices(2), ".csv")
    campaign.run("inputs", options.inputs, Replay(tests / "fuzz_contact_input_replay"),
                 read_all(ROOT / "tests" / "fuzz" / "corpus" / "contact_input", ["*.inp"]), ".inp")
    folder = (options.keep / "work").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copytree(ROOT / "cases", folder, dirs_exist_ok=True)
    program = (options.build / "app" / "rollfem").resolve()
    campaign.run("checks", options.checks, Program(program, folder, "check", LIMIT), cases, ".toml")
    campaign.run("runs", options.runs, Program(program, folder, "run", options.run_limit), [small(case) for case in cases], ".toml")
    shutil.rmtree(folder, ignore_errors=True)
    print("nothing failed" if campaign.failures == 0 else f"{campaign.failures} failed; kept in {options.keep}")
    return 1 if campaign.failures else 0


if __name__ == "__main__":
    sys.exit(main())
