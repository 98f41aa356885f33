#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the Python blocks of a page of docs, one after the other in one session, as a reader would, in a folder of its own
beside a copy of the cases. Call: documented.py PAGE SOURCE_FOLDER; rollfem is found by PYTHONPATH."""
import os
import pathlib
import re
import sys
import tempfile

import matplotlib

matplotlib.use("agg")


def blocks(text):
    """(first line, code) of every block."""
    for match in re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S):
        yield text.count("\n", 0, match.start(1)) + 1, match[1]


def main():
    page, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    found = list(blocks(page.read_text(encoding="utf-8")))
    assert found, f"{page} has no blocks of Python"
    session = {}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        os.symlink(root / "cases", "cases")
        for line, code in found:
            # Lines of a traceback are those of the page.
            exec(compile("\n" * (line - 1) + code, str(page), "exec"), session)
        os.chdir(root)
    print(f"{page.name}: {len(found)} blocks")


if __name__ == "__main__":
    main()
