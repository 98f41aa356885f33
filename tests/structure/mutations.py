# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every mutation of tests/mutations finds its text exactly once, and its suspects are test programs."""

import re
import sys


def problems(root):
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(root / "tests/mutations"))
    from mutations import MUTATIONS

    programs = {f"{group}_{path.stem.removeprefix('test_')}"
                for group in ("unit", "verification", "hard", "cli")
                for pattern in ("*.cpp", "test_*.py") for path in (root / "tests" / group).rglob(pattern)}
    programs |= {f"python_{path.stem}" for path in (root / "tests/python").glob("*.py")}
    chapters = re.findall(r"^set\(chapters_(\w+)", (root / "tests/CMakeLists.txt").read_text(), re.MULTILINE)
    programs |= {f"book_{part}" for part in chapters}
    for mutation in MUTATIONS:
        text = (root / mutation.file).read_text() if (root / mutation.file).is_file() else ""
        if text.count(mutation.find) != 1:
            yield (f"{mutation.name}: its text occurs {text.count(mutation.find)} times in {mutation.file}; "
                   "allowed: once; do: take the text that is there now")
        if mutation.find == mutation.put:
            yield f"{mutation.name}: it changes nothing"
        for suspect in mutation.suspects:
            if suspect.split(":")[0] not in programs:
                yield (f"{mutation.name}: {suspect} is no test program; allowed: GROUP_NAME of "
                       "tests/GROUP/**/NAME.cpp, or book_PART of the book's chapters (tests/CMakeLists.txt)")
    names = [mutation.name for mutation in MUTATIONS]
    yield from (f"{name}: twice in the list" for name in {n for n in names if names.count(n) > 1})
