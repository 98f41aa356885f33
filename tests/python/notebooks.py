#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the code cells of notebooks as their users would, one after the other in one session, in a copy of the folder. What
a cell ends with is shown, as by a notebook. Call: notebooks.py SOURCE_FOLDER; rollfem is found by PYTHONPATH."""
import ast
import json
import os
import pathlib
import shutil
import sys
import tempfile

import matplotlib

matplotlib.use("agg")


def cells(path):
    """(name, code) of the code cells."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    assert notebook["nbformat"] == 4, path
    for number, cell in enumerate(notebook["cells"], 1):
        assert not cell.get("outputs"), f"{path}: cell {number} holds outputs; do: clear them"
        if cell["cell_type"] == "code":
            yield f"{path.name}, cell {number}", "".join(cell["source"])


def shown(value):
    """What a notebook would show of a value."""
    for kind in ("svg", "html"):
        if hasattr(value, f"_repr_{kind}_"):
            text = getattr(value, f"_repr_{kind}_")()
            assert "</" in text, value
            return text
    return repr(value)


def execute(name, code, session):
    """Runs a cell and shows its last expression."""
    body = ast.parse(code, name).body
    last = body.pop() if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), name, "exec"), session)
    return last is not None and shown(eval(compile(ast.Expression(last.value), name, "eval"), session))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = sorted((root / "examples/notebooks").glob("*.ipynb"))
    assert len(found) == 2, found
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder, "examples", "notebooks")
        here.mkdir(parents=True)
        shutil.copytree(root / "cases", pathlib.Path(folder, "cases"))
        os.chdir(here)
        for path in found:
            session, figures = {"__name__": "__main__"}, 0
            for name, code in cells(path):
                figures += "</svg>" in (execute(name, code, session) or "")
            assert figures >= 2, f"{path}: {figures} figures"
            print(f"{path.name}: {figures} figures")
        os.chdir(root)


if __name__ == "__main__":
    main()
