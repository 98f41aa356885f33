# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that imports inside the Python package run one way, and that what a report loads does without the compiled module,
for which it would wait: everything up to `figures`. Imports within functions, on first use, are not counted."""

import ast

# Each module may import those before it.
ORDER = ("errors", "files", "frames", "stresses", "shakedown", "heat", "node", "point", "plot", "result", "outputs", "reader", "tables",
         "figures", "_core", "commands", "case", "solving", "sweeping", "track", "wear", "api", "__main__")
FIGURES = ("labels", "styles", "figure", "published", "page", "load_points", "maps", "tables", "stresses", "curves", "temperatures", "profiles",
           "yielding", "positions", "answer", "report", "table", "study", "compare")
COMMANDS = ("refinement", "levels", "comparing", "benching", "subsurface", "line")


def imported(text):
    """(level, module) of the imports of a module's first lines and classes from its own package."""
    for node in ast.parse(text).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            for name in [node.module.split(".")[0]] if node.module else [alias.name for alias in node.names]:
                yield node.level, name


def problems(root):
    assert list(imported("from . import a, b\nfrom ..c.d import e\ndef f():\n    from .g import h\n")) == [
        (1, "a"), (1, "b"), (2, "c")]
    package = root / "postprocess/rollfem"
    for folder, order in ((package, ORDER), (package / "figures", FIGURES), (package / "commands", COMMANDS)):
        for path in sorted(folder.glob("*.py")):
            name, where = path.stem, path.relative_to(root)
            if name == "__init__":
                continue
            if name not in order:
                yield f"{where}: has no place in the order of modules; do: give it one in tests/structure/package.py"
                continue
            for level, other in imported(path.read_text(encoding="utf-8")):
                inside = level == 1
                allowed = order[:order.index(name)] if inside else ORDER[:ORDER.index(folder.name)]
                if other not in allowed:
                    yield f"{where}: imports {other}; allowed: {', '.join(allowed)}; do: import it on first use, or move it"
