#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the fenced blocks of pages, page by page from top to bottom as a reader would, in a folder of its own beside the
cases and examples. Indented blocks are formulas, output and files, and hold no commands. Commands within a sentence are
not run, but their options, cases and keys must exist. A comment above a block says how it is run:

    <!-- file NAME -->           the block is that file
    <!-- into CASE -->           toml: keys that CASE gets in addition; checked, not solved
    <!-- with OPTIONS -->        sh: options that its rollfem commands get in addition
    <!-- check -->               sh: `rollfem check` in place of run, table, study and wheelset
    <!-- needs PROGRAM -->       sh: left out where that is not installed
    <!-- prints -->              every line is printed by the sh block before it; `...` stands for any further words
    <!-- not run: REASON -->

Call: documented.py SOURCE_FOLDER PROGRAM C_LIBRARY CXX_LIBRARY PAGE...; rollfem (Python) is found by PYTHONPATH."""
import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

import matplotlib

matplotlib.use("agg")
FENCE = re.compile(r"^(?:<!-- (?P<how>[^\n]+) -->\n)?```(?P<language>\w*)\n(?P<code>.*?)^```$", re.M | re.S)
COMMAND = re.compile(r"^ {4}(?:\$ |\./rollfem|rollfem |pip |cmake |ctest |cc |mpirun |import |from \w+ import|#include|/usr/bin/python)", re.M)


SPOKEN = re.compile(r"`rollfem ([a-z-]+)((?:\s[^`]+)?)`")


class Fault(Exception):
    """A block that does not do what its page says."""


def blocks(text, language="python"):
    """(first line, code) of every block in a language."""
    return [(line, code) for line, _, kind, code in fences(text) if kind == language]


def fences(text):
    """(first line, how, language, code) of every fenced block."""
    for match in FENCE.finditer(text):
        yield text.count("\n", 0, match.start("code")) + 1, match["how"] or "", match["language"], match["code"]


def call(command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                          timeout=120, **options)
    if done.returncode:
        raise Fault(f"ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


class Reader:
    """Somebody who works through a page."""

    def __init__(self, root, libraries):
        libraries = ":".join(os.path.dirname(name) for name in libraries)
        self.environment = {
            **os.environ, "PATH": os.getcwd() + ":" + os.environ["PATH"], "LIBRARY_PATH": libraries,
            "LD_LIBRARY_PATH": libraries + ":" + os.environ.get("LD_LIBRARY_PATH", ""),
            "CPATH": ":".join([f"{root}/bindings/capi", f"{root}/bindings/interface", str(root), "/usr/include/eigen3"])}
        self.session, self.printed = {}, ""

    def sh(self, code, how):
        if how == "check":
            code = re.sub(r"\brollfem (?:run|table|study|wheelset) (\S+)(.*)$", lambda line: " ".join(
                ["rollfem check", line[1], *re.findall(r"--set \S+", line[2])]), code, flags=re.M)
        if how.startswith("with "):
            code = re.sub(r"((?<!\w)rollfem [^#\n]*)", lambda line: f"{line[1].rstrip()} {how[5:]} ", code)
        self.printed = call(["sh", "-ec", code], env=self.environment)

    def python(self, code, line, page):
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), self.session)  # lines of a traceback are the page's

    def toml(self, code, how):
        import rollfem
        rollfem.Case(re.fullmatch(r"into (\S+)", how)[1], **tomllib.loads(code))

    def prints(self, code):
        lines = [line.split() for line in self.printed.splitlines()]
        for line in code.splitlines():
            words = line.split()
            wanted = words[:-1] if words[-1:] == ["..."] else words
            if not any(words == there or (wanted is not words and wanted == there[:len(wanted)]) for there in lines):
                raise Fault(f"does not print\n{line}\nbut\n{self.printed}")

    def spoken(self, command, words):
        """A command within a sentence."""
        known = call(["./rollfem", command, "--help"])
        for option in re.findall(r"\s(--?[a-z][a-z-]*)", words):
            if not re.search(rf"[ ,]{option}[, \n]", known):
                raise Fault(f"rollfem {command} has no option {option}")
        for case in re.findall(r"\s(cases/\S+\.toml)", words):
            call(["./rollfem", "check", case, *" ".join(re.findall(r"--set\s+\S+", words)).split()])

    def read(self, line, how, language, code, page):
        if how.startswith("not run: ") or (how.startswith("needs ") and not shutil.which(how[6:])):
            return
        if how.startswith("file "):
            pathlib.Path(how[5:]).parent.mkdir(parents=True, exist_ok=True)
            pathlib.Path(how[5:]).write_text(code, encoding="utf-8")
        elif how == "prints":
            self.prints(code)
        elif language == "python":
            self.python(code, line, page)
        elif language == "sh":
            self.sh(code, how)
        elif language == "toml":
            self.toml(code, how)
        else:
            raise Fault(f"is in no language that is run ({language!r}); do: one of python, sh, toml, or a file")


def work_through(page, root, program, libraries):
    """Faults of a page."""
    text = page.read_text(encoding="utf-8")
    prose = re.sub(r"^```.*?^```$", lambda fence: "\n" * fence[0].count("\n"), text, flags=re.M | re.S)
    for match in COMMAND.finditer(prose):
        yield f"{page}: an indented block has the command {match[0].strip()}; do: fence it"
    begin, count = time.time(), 0
    with tempfile.TemporaryDirectory() as folder, open(os.devnull, "w", encoding="utf-8") as nowhere:
        os.chdir(folder)
        reader = Reader(root, libraries)
        for name in ("cases", "examples", "benchmarks"):
            os.symlink(root / name, name)
        os.symlink(program, "rollfem")
        for match in SPOKEN.finditer(prose):
            try:
                reader.spoken(match[1], match[2])
            except Fault as fault:
                yield f"{page}:{prose.count(chr(10), 0, match.start()) + 1}: {fault}"
        for line, how, language, code in fences(text):
            count += not how.startswith("not run")
            try:
                with contextlib.redirect_stdout(nowhere):
                    reader.read(line, how, language, code, page)
            except Exception as error:  # pylint: disable=broad-except
                yield f"{page}:{line}: {error if isinstance(error, Fault) else repr(error)}"
        os.chdir(root)
    print(f"{page.name}: {count} blocks, {time.time() - begin:.1f} s", flush=True)


def main():
    root, program, *libraries = (pathlib.Path(name).resolve() for name in sys.argv[1:5])
    found = [fault for page in sys.argv[5:]
             for fault in work_through(pathlib.Path(page).resolve(), root, program, [str(name) for name in libraries])]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
