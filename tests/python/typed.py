#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""mypy on the package, on the notebooks and on the examples of its page, as an editor sees them. Status 77 (skipped)
without mypy. Call, with rollfem of a build on PYTHONPATH: typed.py SOURCE_FOLDER"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(os.path.dirname(os.path.abspath(__file__)))


# The package as strictly as mypy has it, but for the element type of arrays; users as loosely as they like.
SETTINGS = """[mypy]
ignore_missing_imports = True
[mypy-rollfem.*]
disallow_untyped_defs = True
disallow_incomplete_defs = True
disallow_untyped_calls = True
warn_return_any = True
no_implicit_reexport = True
[mypy-rollfem.figures.*]
ignore_errors = True
"""


def main():
    from documented import blocks
    from notebooks import cells
    root = pathlib.Path(sys.argv[1]).resolve()
    package = pathlib.Path(importlib.util.find_spec("rollfem").origin).parent
    pages = {"page": "".join(code for _, code in blocks((root / "docs/python.md").read_text(encoding="utf-8")))}
    for path in sorted((root / "examples/notebooks").glob("*.ipynb")):
        pages[path.stem] = "\n".join(code for _, code in cells(path))
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "settings").write_text(SETTINGS, encoding="utf-8")
        for name, code in pages.items():
            pathlib.Path(folder, f"{name}.py").write_text(code, encoding="utf-8")
        return subprocess.run(["mypy", "--config-file", f"{folder}/settings", "--cache-dir", f"{folder}/cache",
                               package, *(f"{folder}/{name}.py" for name in pages)],
                              env={**os.environ, "MYPYPATH": str(package.parent)}, check=False).returncode


if __name__ == "__main__":
    try:
        subprocess.run(["mypy", "--version"], check=True)
    except FileNotFoundError:
        sys.exit(77)
    sys.exit(main())
