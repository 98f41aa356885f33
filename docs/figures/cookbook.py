#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the commands of pages and copies the figures that they name to docs/figures.
Call: docs/figures/cookbook.py PROGRAM [PAGE ...]"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PAGES = ("first_run.md", "cookbook.md", "crossing.md", "plasticity.md")
HERE = pathlib.Path(__file__).resolve().parent
RECIPE = re.compile(r"```sh\n((?:(?!```).)*)```\n\n<!-- figure (\S+) -->\n!\[[^]]*\]\(figures/(\S+)\)", re.S)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(program, f"{folder}/rollfem")
        os.symlink(HERE.parent.parent / "cases", f"{folder}/cases")
        pages = [(HERE.parent / page).read_text(encoding="utf-8") for page in sys.argv[2:] or PAGES]
        for commands, drawn, kept in RECIPE.findall("".join(pages)):
            subprocess.run(["sh", "-ec", commands], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"})
            (HERE / kept).parent.mkdir(exist_ok=True)
            shutil.copyfile(f"{folder}/{drawn}", HERE / kept)


if __name__ == "__main__":
    main()
