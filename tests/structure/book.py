# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks the verification book: that every test it names is there, and that docs/book holds every chapter
with no number beyond what is allowed, unless the page gives the reason."""

import json
import re


def tests_of(root):
    """Names as CTest prints them, parameters left out."""
    names = set()
    for group in ("unit", "verification", "hard"):
        for path in (root / "tests" / group).rglob("*.cpp"):
            names.add(f"{group}.{path.stem}")
            program = "_".join(path.parent.relative_to(root / "tests").parts)
            if path.stem.startswith("fem_") and "_fem" not in program:
                program += "_fem"
            for suite, test in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", path.read_text("utf-8"), re.M):
                names.add(f"{group}.{suite}.{test}")
                names.add(f"{program}:{suite}.{test}")
    return names


def page_of(root):
    return (root / "docs" / "book" / "README.md").read_text("utf-8")


def problems(root):
    known = tests_of(root)
    named = 0
    for path in sorted((root / "benchmarks" / "book" / "chapters").glob("*.py")):
        text = re.sub(r'"\s*\n\s*"', "", path.read_text("utf-8"))  # one string over two lines
        for name in re.findall(r'"((?:unit|verification|hard)[._][\w.:]+)"', text):
            named += 1
            if not name.endswith(".") and name not in known:
                yield f"{path.name}: there is no test {name}"
    if named < 40:
        yield f"only {named} tests are named: the pattern of book.py has lost them"
    chapters = re.search(r"ALL = \[(.*?)\]", (root / "benchmarks/book/chapters/__init__.py").read_text("utf-8"), re.S)
    wanted = [name.strip().replace("_", "-") for name in chapters[1].split(",")]
    book = json.loads((root / "docs" / "book" / "book.json").read_text("utf-8"))
    there = [chapter["name"] for chapter in book["chapters"]]
    if wanted != there:
        yield f"docs/book has the chapters {there}, the source {wanted}: do: ./rollfem book"
    pages = {path.stem for path in (root / "docs" / "book").glob("*.md")} - {"README"}
    if pages != set(there):
        yield f"docs/book has pages of other chapters or lacks some: {sorted(pages ^ set(there))}"
    explained = re.findall(r'^\| \d+ \| ([^|(]+?) \([^|]*\|[^|]*\|[^|]*\*\*beyond\*\* \| [^| ]', page_of(root), re.M)
    for chapter in book["chapters"]:
        for row in chapter["rows"]:
            if not row["holds"] and row["quantity"] not in explained:
                yield (f"docs/book: {chapter['title']}: {row['quantity']} is beyond what is allowed, for no reason that "
                       "the page gives (SPENT in benchmarks/book/tolerances.py)")
