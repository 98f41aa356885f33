# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program and of its tests for the chapters; stored, so that a second call reuses them."""
import ctypes
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import time

from rollfem.outputs import Comparison, Study
from rollfem.reader import read_result

from . import style


def read_run(folder):
    """The result of a run, with its labels of models for tables and figures."""
    result = read_result(folder)
    style.know(result.labels)
    return result


class BookError(Exception):
    """The book cannot be written, for a reason in one sentence."""


class RunFailed(BookError):
    """A run of the program or of a test ended with an error."""


def with_settings(text, settings):
    """The text of a case file with changed values: {"contact_grid.elements_across": 80, ...}.

    Keys must exist, so that misspelt ones are detected. Values are TOML text or numbers. "+" holds sections to append
    as text.
    """
    settings = dict(settings)
    added = settings.pop("+", "")
    lines = text.split("\n")
    for name, value in settings.items():
        section, key = name.rsplit(".", 1) if "." in name else ("", name)
        at, found = "", None
        for number, line in enumerate(lines):
            header = re.match(r"\[([^\[\]]+)\]", line)
            if header:
                at = header[1]
            elif at == section and re.match(rf"{re.escape(key)}\s*=", line):
                found = number
        if found is None:
            raise BookError(f"the case file has no {name} to change")
        lines[found] = f"{key} = {value}"
    return "\n".join(lines) + added


def _read(path):
    """The text of a file; None if it does not exist."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError:
        return None


def _write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _end_with_the_book():
    """In a child process: ends it with a killed book, whose next call would otherwise find the result locked."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


def _remove(path):
    if os.path.isdir(path):
        shutil.rmtree(path)
    elif os.path.exists(path):
        os.remove(path)


class Bench:
    """The program, its tests and a folder for their results.

    `build`: the build tree; `folder`: stores results by name; they are reused if program (version, commit) and case
    file are the same and `fresh` is not set.
    """

    def __init__(self, root, build, folder, fresh=False, say=lambda text: None):
        self.root, self.build, self.folder, self.fresh, self.say = root, build, folder, fresh, say
        self.program = os.path.join(build, "app", "rollfem")
        if not os.access(self.program, os.X_OK):
            raise BookError(f"{self.program} does not exist; do: ./rollfem build")
        self.version = self._version()
        self.figures, self.png = folder, None  # folders of figures and their bitmaps
        self.small = False  # as a test: fewer numbers, no figures
        self.built_with_fem = os.path.exists(os.path.join(build, "fem", "librollfem_fem.so"))
        self.has_fem = self.built_with_fem  # whether chapters that do without have rows of finite elements
        os.makedirs(folder, exist_ok=True)

    def _version(self):
        return subprocess.run([self.program, "--version"], check=True, capture_output=True,
                              text=True).stdout.splitlines()[0]


    def case_text(self, case, settings=None):
        with open(os.path.join(self.root, case), encoding="utf-8") as file:
            return with_settings(file.read(), settings or {})

    def _call(self, name, command, made):
        """Runs a command in the source folder and checks its status and output. Returns its CPU seconds."""
        def spent():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime
        begin, before = time.time(), spent()
        done = subprocess.run(command, cwd=self.root, capture_output=True, text=True, check=False,
                              env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "ROLLFEM_CACHE": ""},
                              preexec_fn=_end_with_the_book)
        if done.returncode != 0:
            last = (done.stderr or done.stdout).strip().split("\n")[-1]
            raise RunFailed(f"{name}: {' '.join(command)} ended with {done.returncode}: {last}")
        if not os.path.exists(made):
            raise RunFailed(f"{name}: {' '.join(command)} left no {made}")
        self.say(f"  {name}: {time.time() - begin:.1f} s")
        return spent() - before

    def _stamped(self, target, stamp, command, resumable=False):
        """Makes `target` by the command unless it exists with the same stamp; resumes an interrupted one."""
        if not self.fresh and _read(target + ".stamp") == stamp and os.path.exists(target):
            self.say(f"  {os.path.basename(target)}: kept")
            return
        if resumable and not self.fresh and _read(target + ".begun") == stamp:
            command = [*command, "--resume"]
        else:
            for old in (target, target + ".unfinished", target + ".stamp"):
                _remove(old)
        _write(target + ".begun", stamp)
        _write(target + ".cpu", f"{self._call(os.path.basename(target), command, target):.3f}\n")
        _write(target + ".stamp", stamp)
        _remove(target + ".begun")

    def _program(self, verb, name, cases, settings, options):
        """One call of the program; returns the folder of its results."""
        target = os.path.join(self.folder, name)
        files, texts = [], []
        for case in cases:
            text = self.case_text(case, settings)
            texts.append(text)
            if settings:
                own = f"{target}.toml"
                _write(own, text)
                files.append(own)
            else:
                files.append(case)
        command = [self.program, verb, *files, *options, "--quiet", "-o", target]
        stamp = "\n".join([self.version, verb, *options, *texts])
        self._stamped(target, stamp, command, resumable=True)
        return target

    def cpu_seconds(self, name):
        """CPU time of a stored result over all threads, which unlike wall time is the same on a busy machine."""
        return float(_read(os.path.join(self.folder, name + ".cpu")) or "nan")

    def save(self, figure, name):
        """Writes a figure of the book; returns its file name."""
        if not self.small:
            style.save(figure, os.path.join(self.figures, name + ".svg"), self.png)
        return name + ".svg"

    def run(self, name, case, models=(), settings=None):
        """`rollfem run` of a case, with changed settings if given; returns its Result."""
        options = ["--model", ",".join(models)] if models else []
        return read_run(self._program("run", name, [case], settings, [*options, "--no-report"]))

    def run_text(self, name, text, models=()):
        """The same of a case given as text."""
        return self.run(name, self.text_file(name + "_case.toml", text), models)

    def text_file(self, name, text):
        """Writes a file beside the results; returns its path."""
        path = os.path.join(os.path.abspath(self.folder), name)
        _write(path, text)
        return path

    def study(self, name, case, options=(), settings=None):
        """`rollfem study` of a case; returns study.json as a dict."""
        folder = self._program("study", name, [case], settings, [*options, "--no-report", "--reference-seconds", "0"])
        found = Study.read(folder)
        style.know(found.labels)
        return found.with_numbers

    def compare(self, name, cases, models):
        """`rollfem compare` of cases; returns (compare.json, {case name: Result})."""
        folder = self._program("compare", name, cases, None,
                               ["--model", ",".join(models), "--no-report"])
        comparison = Comparison.read(folder)
        style.know(comparison.labels)
        return comparison.data, {c["name"]: read_run(os.path.join(folder, c["name"]))
                                 for c in comparison.data["cases"]}

    def test(self, name):
        """Runs one test, e.g. "verification_fem:PerssonPin.Touches...", and returns its records.

        The numbers are floats by name (RecordProperty of GoogleTest), with "seconds" of the test. Raises RunFailed if
        the test does not pass.
        """
        program, test = name.split(":")
        path = os.path.join(self.build, "tests", program)
        if not os.access(path, os.X_OK):
            raise BookError(f"{path} does not exist; do: ./rollfem build")
        target = os.path.join(self.folder, re.sub(r"[^A-Za-z0-9]+", "_", test) + ".json")
        command = [path, f"--gtest_filter={test}", f"--gtest_output=json:{target}"]
        self._stamped(target, f"{self.version}\n{os.path.getmtime(path)}\n{test}", command)
        with open(target, encoding="utf-8") as file:
            suites = json.load(file)["testsuites"]
        cases = [case for suite in suites for case in suite["testsuite"]]
        if not cases:
            raise RunFailed(f"{path} has no test {test}")
        known = {"name", "file", "line", "status", "result", "timestamp", "time", "classname",
                 "type_param", "value_param"}
        numbers = {key: float(value) for key, value in cases[0].items() if key not in known}
        numbers["seconds"] = float(cases[0]["time"].rstrip("s"))
        return numbers
