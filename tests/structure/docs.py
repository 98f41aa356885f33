# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds README, changelog and docs to the tree: tests that are named exist, links lead to a file and a
heading, and a section with a table of measured numbers says how to get them again: by a command, a test,
the book, or where they are from."""

import re

TEST_NAME = re.compile(r"`(?:unit|verification|hard|cli|fuzz|install|structure)\.([A-Za-z0-9_/]+)")
DECLARED = re.compile(r"TEST(?:_F|_P)?\(\s*(\w+)")
INSTANCE = re.compile(r"INSTANTIATE_TEST_SUITE_P\(\s*(\w+),\s*(\w+)")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
MEASURED = re.compile(r"\d\.\d\d|\de-\d|\d %")
REFERENCE = {"case-file.md", "troubleshooting.md"}  # bounds of keys, symptoms: nothing measured
AGAIN = re.compile(
    r"rollfem |benchmark_|benchmarks/|ctest|campaign\.py|mutate\.py|book\b|"
    r"`(?:unit|verification|hard|cli)\.|Source:", re.I)


def declared_tests(root):
    names = set()
    for path in (root / "tests").rglob("*.cpp"):
        text = path.read_text()
        names.update(DECLARED.findall(text))
        names.update(f"{prefix}/{suite}" for prefix, suite in INSTANCE.findall(text))
        names.add(path.stem)
    for path in (root / "tests").rglob("*.py"):
        names.add(path.stem.removeprefix("test_"))
    return names | {"consumer"}


def sections(text):
    """(heading, text) of each heading of the page."""
    parts = re.split(r"^(#+ .*)$", text, flags=re.M)
    yield from zip(["top", *parts[1::2]], [parts[0], *parts[2::2]])


def places(text):
    """Anchors of the headings of a page."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
            for heading in re.findall(r"^#+ (.*)$", prose, flags=re.M)}


def faults(path, root, tests):
    text = path.read_text()
    for name in TEST_NAME.findall(text):
        if not any(test == name or test.startswith(name) for test in tests):
            yield f"names the test `{name}`, which does not exist"
    for link, place in LINK.findall(text):
        if "://" in link:
            continue
        target = path.parent / link if link else path
        if not target.exists():
            yield f"links to {link}, which does not exist"
        elif place and target.suffix == ".md" and place not in places(target.read_text()):
            yield f"links to {link}#{place}, and there is no such heading"
    for heading, body in sections(text):
        rows = [line for line in body.splitlines() if line.startswith("|")]
        numbers = sum(len(MEASURED.findall(row)) > 1 for row in rows)
        if numbers > 2 and path.name not in REFERENCE and not AGAIN.search(body):
            yield f"'{heading}' has a table of numbers and says nothing of how to get them again"


def problems(root):
    tests = declared_tests(root)
    return [f"{path.relative_to(root)}: {fault}"
            for path in [*root.glob("*.md"), *(root / "docs").rglob("*.md")] for fault in faults(path, root, tests)]
