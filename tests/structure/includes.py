#!/usr/bin/env python3
"""Checks that includes between the folders run one way (design.md section 2).

contact <- halfspace <- fem; meshes knows contact's case and grid only; wheelset, which balances
loads and rotation over the patches that meshes finds, knows halfspace too; postprocess knows results,
never solvers; app knows all; deal.II is seen in fem only. Call: includes.py SOURCE_DIR
"""

import pathlib
import re
import sys

# What each folder may include of the others; None: everything.
VALUES = {"case", "grid", "geometry", "errors", "progress", "height_curve", "patch_geometry",
          "track"}
ALLOWED = {
    "contact": {},
    "halfspace": {"contact": None},
    "meshes": {"contact": VALUES},
    "postprocess": {"contact": VALUES | {"result", "stress_measures", "checkpoint", "record"}},
    "wheelset": {"contact": None, "halfspace": None, "meshes": None},
    "fem": {"contact": None, "halfspace": None, "meshes": None},
    "app": {"contact": None, "halfspace": None, "meshes": None, "wheelset": None,
            "postprocess": None,
            "fem": {"model", "mesh_report"}},
}
HEAVY = re.compile(r"^(deal\.II|mpi\.h|p4est|Epetra|ml_)")


def problems(root):
    for folder, allowed in ALLOWED.items():
        files = sorted(p for p in (root / folder).glob("*.[ch]pp"))
        if not files:
            yield f"{folder}: no source files found in {root / folder}"
        for path in files:
            text = path.read_text(encoding="utf-8")
            for number, line in enumerate(text.splitlines(), 1):
                match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if not match:
                    continue
                wrong = judge(folder, allowed, *match.groups())
                if wrong:
                    yield f"{path.relative_to(root)}:{number}: {line.strip()}: {wrong}"


def judge(folder, allowed, bracket, name):
    if HEAVY.match(name) and folder != "fem":
        return "finite-element and MPI libraries are known to fem only"
    other, _, header = name.partition("/")
    if bracket == '"' and not header:
        return "include by folder"
    if other not in ALLOWED or other == folder:
        return None
    if other not in allowed:
        return f"{folder} must not know {other}"
    names = allowed[other]
    if names is not None and pathlib.Path(header).stem not in names:
        return f"{folder} knows only {', '.join(sorted(names))} of {other}"
    return None


def self_test():
    """A checker that cannot fail would be worse than none."""
    def verdict(folder, line):
        return judge(folder, ALLOWED[folder], line[0], line[1:])

    assert verdict("contact", '"halfspace/hertz.hpp')
    assert verdict("halfspace", '"fem/body.hpp')
    assert verdict("postprocess", '"contact/normal.hpp')
    assert verdict("meshes", '"contact/tangential.hpp')
    assert verdict("app", '"fem/body.hpp')
    assert verdict("app", "<deal.II/base/mpi.h")
    assert verdict("fem", '"body.hpp')
    assert not verdict("fem", "<deal.II/base/mpi.h")
    assert not verdict("halfspace", '"contact/normal.hpp')
    assert not verdict("app", '"fem/model.hpp')


def main():
    self_test()
    found = list(problems(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "includes run one way")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
