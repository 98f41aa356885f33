#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs one check of the tree, a file of this folder whose `problems` yields a sentence of each fault. Call:
check.py CHECK SOURCE_DIR PROGRAM"""

import pathlib
import runpy
import sys

name, root, program = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
problems = runpy.run_path(str(pathlib.Path(__file__).with_name(f"{name}.py")))["problems"]
found = sorted(problems(root, program) if name == "schema" else problems(root))
print("\n".join(found) or f"{name}: nothing is wrong")
sys.exit(bool(found))
