# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks what a release says of itself: every source file names the licence at its top, and CITATION.cff and the
changelog have the version of CMakeLists.txt and one date."""

import re

LICENCE = "SPDX-License-Identifier: LGPL-2.1-or-later"
CODE = {".c", ".cmake", ".cpp", ".h", ".hpp", ".in", ".py", ".sh"}
NAMED = {"CMakeLists.txt", "Containerfile", "pyproject.toml", "rollfem", "run"}
MADE = ("build", "results", "__pycache__", ".git", ".cache")


def sources(folder):
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.name.startswith(MADE):
            yield from sources(path)
        elif path.is_file() and (path.suffix in CODE or path.name in NAMED):
            yield path


def unlicensed(root):
    for path in sources(root):
        # The first line may name the interpreter.
        if not any(LICENCE in line for line in path.read_text(encoding="utf-8").split("\n", 2)[:2]):
            yield f"{path.relative_to(root)} names no licence; do: begin with the comment {LICENCE}"


def contradictions(root):
    version = re.search(r"^project\(rollfem VERSION (\S+)", (root / "CMakeLists.txt").read_text(), re.M)[1]
    citation, changes = ((root / name).read_text() for name in ("CITATION.cff", "CHANGELOG.md"))
    date = re.search(r"^date-released: (\S+)", citation, re.M)[1]
    if f"\nversion: {version}\n" not in citation:
        yield f"CITATION.cff has another version than CMakeLists.txt, {version}"
    if f"\n## {version}, {date}\n" not in changes:
        yield f"CHANGELOG.md has no heading '## {version}, {date}', the version and date of CITATION.cff"


def problems(root):
    return [*unlicensed(root), *contradictions(root)]
