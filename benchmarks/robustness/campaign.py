#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damages files and kills the program, and checks its reaction.

    campaign.py damage --program build/app/rollfem --kind results --count 500
    campaign.py kill --program build/app/rollfem --command run --count 200

damage: meshes (rollfem mesh; needs finite elements), results (stress, figures), records (run --resume). Wrong is a
signal, more than 5 s of CPU time, "internal error", a status other than 0, 1, 2, and a damaged result or record that is
used. kill: run, compare, study or book, ended by SIGKILL at random moments, with its children or alone; wrong is a
result after --resume (for the book: the same call) that is not identical to the last bit, except for times, the call
and its checksum. Every file and moment follows from --seed. Status 1 if anything went wrong; failures are kept in
--folder."""
import argparse
import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

LIMIT = 5  # s of CPU time, so that a busy machine does not count against the program
WAITING = 120  # s
CASE = """title = "robustness"
models = ["halfspace"]
[load]
normal_force = 50e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 405.0
transverse_radius = inf
{wheel}
[rail]
transverse_radius = 2000.0
[rolling]
longitudinal_creepage = [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004]
spin = 1e-4
[contact_grid]
elements_across = {across}
[fem]
cell_size = 1.88
"""
NUMBERS = [b"-1", b"0", b"2147483648", b"-2147483649", b"4294967297", b"18446744073709551616", b"1e308", b"nan"]
TIMES = {"seconds", "started", "command", "case_file", "checksum", "host", "date", "time", "timestamp", "choice"}
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CHAPTERS = ["hertz", "carter"]  # runs and a test, one second in all


def damaged(data, chance):
    """Damaged bytes: bits flipped, truncated, blocks zeroed, moved, lost or doubled, numbers replaced."""
    out = bytearray(data)
    while out == data:
        at, kind = chance.randrange(len(out)), chance.randrange(7)
        length = 1 + chance.randrange(1 + chance.randrange(600))
        other = chance.randrange(len(out))
        if kind == 0:
            for _ in range(1 + chance.randrange(8)):
                out[chance.randrange(len(out))] ^= 1 << chance.randrange(8)
        elif kind == 1:
            del out[at:]
        elif kind == 2:
            out[at:at + length] = bytes(len(out[at:at + length]))
        elif kind == 3:
            out[at:at + length] = out[other:other + length]
        elif kind == 4:
            del out[at:at + length]
        elif kind == 5:
            out[at:at] = out[other:other + length]
        else:
            end = at
            while end < len(out) and out[end:end + 1] in b"0123456789.-e":
                end += 1
            out[at:end] = chance.choice(NUMBERS)
        out = out or bytearray(b"\0")
    return bytes(out)


def call(command, folder, limit=LIMIT):
    """(status, output); status None beyond the limit, negative for a signal."""
    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, check=False,
                              timeout=WAITING + 10 * limit, preexec_fn=bound)
    except subprocess.TimeoutExpired:
        return None, ""
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None, ""
    return done.returncode, (done.stdout + done.stderr).decode("utf-8", "replace")


def fault(status, said, may_succeed):
    """What is wrong with the end of a call; empty if nothing."""
    if status is None:
        return f"more than {LIMIT} s"
    if status < 0 or status >= 128:
        return f"signal, status {status}"
    if status not in (0, 1, 2):
        return f"status {status}"
    for sign in ("internal error", "Traceback"):
        if sign in said:
            return sign
    return "" if may_succeed or status != 0 else "damaged, but status 0"


def write(path, data):
    with open(path, "wb" if isinstance(data, bytes) else "w") as file:
        file.write(data)


def read(path):
    with open(path, "rb") as file:
        return file.read()


class Meshes:
    """Meshes written by the program, in text, as [wheel] mesh."""
    may_succeed = True  # a coordinate, a box or a blank may change without harm

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        write(os.path.join(folder, "a.toml"), CASE.format(wheel="", across=20))
        call([program, "mesh", "a.toml", "-o", "made"], folder, 300)
        self.sound = read(os.path.join(folder, "made", "wheel.msh"))
        write(os.path.join(folder, "b.toml"), CASE.format(wheel='mesh = "damaged.msh"', across=20))

    def trial(self, chance):
        write(os.path.join(self.folder, "damaged.msh"), damaged(self.sound, chance))
        return call([self.program, "mesh", "b.toml", "-o", "out"], self.folder)


class Results:
    """results.h5, read by `stress` and alternately by the reader of the figures."""
    may_succeed = False

    def __init__(self, program, folder):
        self.program, self.folder, self.turn = program, folder, 0
        write(os.path.join(folder, "a.toml"), CASE.format(wheel="", across=20))
        call([program, "run", "a.toml", "-o", "r", "--no-report"], folder, 300)
        self.sound = read(os.path.join(folder, "r", "results.h5"))
        self.source = os.path.join(ROOT, "postprocess")

    def trial(self, chance):
        write(os.path.join(self.folder, "r", "results.h5"), damaged(self.sound, chance))
        self.turn += 1
        if self.turn % 10 == 0:
            script = (f"import sys; sys.path.insert(0, {self.source!r})\n"
                      "from rollfem.reader import read_result, FileError\n"
                      "try: read_result('r')\nexcept FileError: sys.exit(2)")
            return call(["/usr/bin/python3", "-c", script], self.folder)
        return call([self.program, "stress", "r", "--no-figures", "-o", "s"], self.folder)


class Records:
    """One record of a killed run is damaged or replaced by another; the program must report it, and the result must
    equal that of an uninterrupted run."""
    may_succeed = True

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        write(os.path.join(folder, "a.toml"), CASE.format(wheel="", across=70))
        self.command = [program, "run", "a.toml", "-o", "r", "--no-report"]
        call([*self.command[:4], "whole", "--no-report"], folder, 300)
        self.kept = os.path.join(folder, "r.unfinished")
        with subprocess.Popen(self.command, cwd=folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as child:
            while child.poll() is None and len(self.records()) < 6:
                time.sleep(0.002)
            child.kill()
        shutil.copytree(self.kept, self.kept + ".sound")

    def records(self):
        return sorted(n for n in os.listdir(self.kept) if n.endswith(".point")) if os.path.isdir(self.kept) else []

    def trial(self, chance):
        shutil.rmtree(self.kept, ignore_errors=True)
        shutil.rmtree(os.path.join(self.folder, "r"), ignore_errors=True)
        shutil.copytree(self.kept + ".sound", self.kept)
        names = self.records()
        victim = chance.choice(names)
        if chance.randrange(4) == 0:
            shutil.copy(os.path.join(self.kept, chance.choice([n for n in names if n != victim])),
                        os.path.join(self.kept, victim))
        else:
            path = os.path.join(self.kept, victim)
            write(path, damaged(read(path), chance))
        status, said = call([*self.command, "--resume"], self.folder)
        if status == 0:
            different = differences(os.path.join(self.folder, "whole"), os.path.join(self.folder, "r"))
            if different or "is damaged, or belongs to another load point" not in said:
                return 99, f"taken up: {different} {said}"
        return status, said


def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k not in TIMES}
    return [without_times(v) for v in value] if isinstance(value, list) else value


def fields(path):
    """{name: bytes} of all datasets except times."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and "seconds" not in name and not name.startswith("provenance"):
            values = item[()]
            found[name] = values.tobytes() if getattr(values, "dtype", np.dtype(object)) != object else str(values)
    with h5py.File(path, "r") as file:
        file.visititems(visit)
    return found


def lines(path):
    """The bytes of a file; for a page without times."""
    timed = ("Made by `", "| [", "Cost: ") if path.endswith(".md") else ()
    text = read(path).decode("utf-8", "replace")
    return [line for line in text.split("\n") if not any(sign in line for sign in timed)]


def left_over(folder):
    """Files that a finished call must not leave in or beside its result."""
    beside = [name for name in os.listdir(folder) if name.startswith("r.")]
    return beside + [name for _, folders, names in os.walk(os.path.join(folder, "r")) for name in folders + names
                     if name.endswith((".unfinished", ".lock", ".begun")) or ".partial-" in name]


def differences(one, other):
    """Files of two result folders with differences other than times."""
    found = []
    for base, _, names in os.walk(one):
        for name in names:
            first = os.path.join(base, name)
            second = os.path.join(other, os.path.relpath(first, one))
            if not os.path.exists(second):
                found.append(second)
            elif name.endswith(".json"):
                a, b = (without_times(json.loads(read(p))) for p in (first, second))
                if a != b:
                    found.append(second)
            elif name == "results.h5":
                if fields(first) != fields(second):
                    found.append(second)
            elif name.startswith("path_") or name.endswith((".md", ".svg")):
                if lines(first) != lines(second):
                    found.append(second)
    return found


def damage(options, folder):
    kind = {"meshes": Meshes, "results": Results, "records": Records}[options.kind](options.program, folder)
    wrong, counts = [], {}
    for number in range(1, options.count + 1):
        chance = random.Random(f"{options.seed} {number}")
        status, said = kind.trial(chance)
        counts[status] = counts.get(status, 0) + 1
        text = fault(status, said, kind.may_succeed)
        if text:
            wrong.append(f"{options.kind} {number}: {text}: {said.strip()[-300:]}")
            keep = os.path.join(options.folder, f"{options.kind}_{number}")
            shutil.copytree(folder, keep, dirs_exist_ok=True)
        if number % 10 == 0 or number == options.count:
            print(f"{number} {options.kind}: status and how often: {dict(sorted(counts.items(), key=str))}, "
                  f"{len(wrong)} wrong", flush=True)
    return wrong


class Command:
    """A command of the program that is killed and resumed with --resume."""

    def __init__(self, options, folder):
        write(os.path.join(folder, "a.toml"), CASE.format(wheel="", across=options.across))
        write(os.path.join(folder, "b.toml"), CASE.format(wheel="", across=options.across - 2))
        command = {"run": ["run", "a.toml"], "compare": ["compare", "a.toml", "b.toml", "-m", "hertz", "halfspace"],
                   "study": ["study", "a.toml", "--levels", "4"]}[options.command]
        self.command, self.again = [options.program, *command, "--no-report"], ["--resume"]

    def into(self, name):
        return [*self.command, "-o", name]

    def took_up(self, said):
        return "solutions of an earlier run" in said or "was already done" in said


class Book:
    """The verification book, which resumes with the same call."""

    def __init__(self, options, folder):
        build = os.path.dirname(os.path.dirname(options.program))
        os.environ["PYTHONPATH"] = os.pathsep.join(os.path.join(ROOT, name) for name in ("benchmarks", "postprocess"))
        os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
        self.command = ["/usr/bin/python3", "-m", "book", "--root", ROOT, "--build", build, "--only", *CHAPTERS]
        self.again = []

    def into(self, name):
        return [*self.command, "--results", os.path.join(name, "results"), "-o", os.path.join(name, "book")]

    def took_up(self, said):
        return ": kept" in said


def work_of(process):
    """CPU time of a process, its children and those it has waited for, s."""
    try:
        ticks = sum(int(field) for field in read(f"/proc/{process}/stat").rsplit(b")", 1)[1].split()[11:15])
        children = read(f"/proc/{process}/task/{process}/children").split()
    except OSError:
        return 0.0
    return ticks / os.sysconf("SC_CLK_TCK") + sum(work_of(int(child)) for child in children)


def kill_at(command, folder, work, alone):
    """Kills a call after a given CPU time, with its children as at the end of a session, or `alone`. Returns the CPU
    time of the call if it ended before, otherwise None."""
    step = 0.01  # s, resolution of the CPU clock
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          start_new_session=True) as child:
        used = work_of(child.pid)
        while used < work:
            time.sleep(0.5 * step)
            if os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT):
                return work_of(child.pid)
            used = work_of(child.pid)
        time.sleep(work % step)
        child.kill() if alone else os.killpg(child.pid, signal.SIGKILL)
    return None


def kill(options, folder):
    kind = (Book if options.command == "book" else Command)(options, folder)
    status, said = call(kind.into("whole"), folder, 600)
    if status != 0:
        sys.exit(f"the undisturbed call ended with {status}: {said}")
    lasts = kill_at(kind.into("r"), folder, math.inf, False)
    wrong, killed, taken, ended, number = [], 0, 0, 0, 0
    while killed < options.count:
        number += 1
        chance = random.Random(f"{options.seed} {number}")
        for name in os.listdir(folder):
            if name.startswith("r") and os.path.isdir(os.path.join(folder, name)):
                shutil.rmtree(os.path.join(folder, name))
        if kill_at(kind.into("r"), folder, chance.uniform(0.0, lasts), chance.randrange(2)) is not None:
            ended += 1
            continue
        killed += 1
        status, said = call([*kind.into("r"), *kind.again], folder, 600)
        taken += kind.took_up(said)
        text = fault(status, said, True) or ("" if status == 0 else f"status {status}")
        different = differences(os.path.join(folder, "whole"), os.path.join(folder, "r")) if not text else []
        left = left_over(folder)
        if text or different or left:
            wrong.append(f"{options.command} {number}: {text} {different} {left} {said.strip()[-300:]}")
            print(wrong[-1], flush=True)
        if killed % 10 == 0 or killed == options.count:
            print(f"{killed} kills of {options.command} ({lasts:.2f} s of CPU time): {taken} took up work, {ended} calls had ended "
                  f"before, {len(wrong)} wrong", flush=True)
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["damage", "kill"])
    parser.add_argument("--program", required=True)
    parser.add_argument("--kind", choices=["meshes", "results", "records"], default="results")
    parser.add_argument("--command", choices=["run", "compare", "study", "book"], default="run")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--across", type=int, default=70, help="elements across of the killed run; work of the first "
                        "half second is not stored")
    parser.add_argument("--folder", default="robustness_faults", help="folder for failures")
    options = parser.parse_args()
    options.program = os.path.abspath(options.program)
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                      OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    with tempfile.TemporaryDirectory() as folder:
        wrong = damage(options, folder) if options.what == "damage" else kill(options, folder)
    for text in wrong:
        print(f"wrong: {text}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
