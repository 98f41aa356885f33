# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the real program as a user does, in a folder of its own: arguments in; exit status, stdout, stderr and files out.

CTest names the program. For one test by hand: ROLLFEM_PROGRAM=build-halfspace/app/rollfem pytest tests/cli -k NAME."""

import contextlib
import csv
import dataclasses
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("ROLLFEM_PROGRAM", SOURCE / "build/app/rollfem")).resolve()
assert PROGRAM.exists(), f"{PROGRAM}: there is no such program; do: name it by ROLLFEM_PROGRAM"
BUILD = PROGRAM.parents[1]
TOY_PROGRAM = BUILD / "tests/toy_program"
FEM = any((BUILD / "fem").glob("librollfem_fem*"))
needs_fem = pytest.mark.skipif(not FEM, reason="a build without finite elements")

SMALL = {"load.normal_force": 50e3, "friction.coefficient": 0.55, "wheel.rolling_radius": 405.0,
         "wheel.transverse_radius": math.inf, "rail.transverse_radius": 2000.0}
# The left wheel of a wheelset in the middle of the track.
WHEEL_ON_RAIL = {"load.vertical_force": 100e3, "friction.coefficient": 0.55, "wheel.rolling_radius": 450.0,
                 "wheel.profile": "S1002", "rail.profile": "UIC60-manchester", "track.inclination": "1:40"}
# Two wheels in two positions. Beyond the middle the left wheel touches with a larger model error than the others.
TWO_POSITIONS = WHEEL_ON_RAIL | {"wheelset.side": "both", "wheelset.lateral_shift": [0.0, 2.0], "wheelset.roll": 0.0,
                                 "rolling.longitudinal_creepage": 0.001, "output.fields": False}


def rolling(creepages, across):
    """Keys of rolling with these creepages on this many elements across."""
    return {"rolling.longitudinal_creepage": creepages, "contact_grid.elements_across": across}


def toml(keys):
    """The text of a case file with these {"section.key": value}; None leaves a key out."""
    def value(given):
        if isinstance(given, (list, tuple)):
            return "[" + ", ".join(map(value, given)) + "]"
        if isinstance(given, dict):
            return "{" + ", ".join(f"{key} = {value(entry)}" for key, entry in given.items()) + "}"
        return repr(given) if isinstance(given, float) else json.dumps(given, ensure_ascii=False)

    sections = {"": []}
    for name, given in keys.items():
        section, _, key = name.rpartition(".")
        if given is not None:
            sections.setdefault(section, []).append(f"{key} = {value(given)}\n")
    return "".join((f"[{section}]\n" if section else "") + "".join(lines) for section, lines in sections.items())


@dataclasses.dataclass
class Outcome:
    status: int  # 128 + signal when a signal ended it
    out: str
    err: str


def says(text, *parts):
    """Holds that a text contains all of these parts."""
    missing = [part for part in parts if part not in text]
    assert not missing, f"no {missing} in:\n{text[:4000]}"


def refused(outcome, part):
    """Holds that a call ended with status 2, nothing on stdout and one line on stderr that has this part."""
    assert outcome.status == 2 and outcome.out == "" and outcome.err.startswith("rollfem: "), outcome
    says(outcome.err, part, "do: ")
    assert outcome.err.count("\n") == 1, outcome.err


class Folder:
    """The fixture `rollfem`. The program works in `work`, empty at first; cases stand beside it."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.work = self.path / "work"
        self.work.mkdir()

    def file(self, name, content):
        """Writes a file beside `work` (or in it, "work/a") and returns its path; a dictionary is a case."""
        path = self.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        text = toml(content) if isinstance(content, dict) else content
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)

    def case(self, keys, name="case.toml"):
        return self.file(name, keys)

    def execute(self, *command, watch=None, **environment):
        """A command in `work`, without a cache unless `environment` names one. `watch` is called every few
        milliseconds until it returns a signal, which is sent once."""
        environment = os.environ | {"ROLLFEM_CACHE": "", "ROLLFEM_PROGRESS": "lines"} | environment
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = subprocess.Popen(command, cwd=self.work, env=environment, stdin=subprocess.DEVNULL,
                                       stdout=out, stderr=err)
            while watch and process.poll() is None:
                if sent := watch():
                    process.send_signal(sent)
                    break
                time.sleep(0.002)
            status = process.wait()
            texts = [(stream.seek(0), stream.read().decode(errors="replace"))[1] for stream in (out, err)]
        return Outcome(status if status >= 0 else 128 - status, *texts)

    def call(self, *arguments, processes=1, program=PROGRAM, watch=None, **environment):
        """rollfem with these arguments."""
        parallel = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(processes)] if processes > 1 else []
        return self.execute(*parallel, program, *arguments, watch=watch, **environment)

    def done(self, *arguments, **how):
        """rollfem, which must succeed."""
        outcome = self.call(*arguments, **how)
        assert outcome.status == 0, outcome
        return outcome

    def refuses(self, *arguments, says, **how):
        """rollfem refuses the call with a message that has this part."""
        refused(self.call(*arguments, **how), says)

    def text(self, name):
        return (self.work / name).read_text("utf-8")

    def json(self, name):
        return json.loads(self.text(name))

    def rows(self, name):
        """Lines of a CSV file, each cell under its heading without the unit."""
        lines = list(csv.reader(self.text(name).splitlines()))
        names = [heading.partition(" [")[0] for heading in lines[0]]
        return [dict(zip(names, line, strict=True)) for line in lines[1:]]

    def models(self, result):
        return self.json(f"{result}/summary.json")["models"]

    def point(self, result):
        """The first load point of the first model of a result."""
        return self.models(result)[0]["points"][0]

    def holds(self, name):
        return (self.work / name).exists()

    def made(self):
        """Everything the program left, sorted, relative to `work`."""
        return sorted(str(path.relative_to(self.work)) for path in self.work.rglob("*"))


@contextlib.contextmanager
def folder():
    """A Folder that is removed at the end, for fixtures that several tests share."""
    with tempfile.TemporaryDirectory(prefix="rollfem_test_") as path:
        yield Folder(path)


def interrupt_after(seconds):
    """A `watch` that sends the signal of Ctrl-C."""
    end = time.monotonic() + seconds
    return lambda: signal.SIGINT if time.monotonic() > end else 0


def package():
    """The Python package of this build, for what it reads better than a test would."""
    sys.path.insert(0, str(BUILD / "python"))
    return pytest.importorskip("rollfem")


def solved(keys, model):
    """The model's result of a case with these keys, solved in this process."""
    core = package()._core
    from rollfem.result import models_of
    return models_of(core.solve(core.parse_case(toml(keys), "case.toml"), [model], None, False)[0])[0]
