# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that every source has a header of its name beside it, and that no two headers have one name. Sources of some
kinds have none of their own: their functions are entries of a table, which one header declares."""

import collections
import pathlib
import re

MODULES = ("base", "case", "scene", "result", "contact", "halfspace", "theories", "profiles", "track", "meshes", "fem",
           "hybrid", "modelling", "tables", "convert", "app", "bindings")
# Programs and entry points; sections of a case file (case_keys.hpp); formats of profiles (profile_format.hpp);
# commands (app/frame/commands.hpp); parts of the modules of Python and C (bindings.hpp, rollfem.h).
ENTRIES = re.compile(r"(^|/)main\.cpp$|^hybrid/correction/entry\.cpp$|^case/keys/keys_\w+\.cpp$"
                     r"|^profiles/\w+_format\.cpp$|^app/(input|results|run|study)/\w+\.cpp$|^bindings/")


def judge(sources, headers):
    """Sentences about paths relative to the root."""
    for path in sources:
        alone = path.with_suffix(".hpp") not in headers and not ENTRIES.search(path.as_posix())
        if alone:
            yield f"{path} has no header of its name; do: move its declarations into {path.stem}.hpp, or the source into the file whose header declares it"
    for name, count in sorted(collections.Counter(path.name for path in headers).items()):
        if count > 1:
            yield f"{count} headers are called {name}; do: name each after what it declares"


def problems(root):
    self_test()
    files = [path.relative_to(root) for module in MODULES for path in (root / module).rglob("*.[ch]pp")]
    yield from judge([path for path in files if path.suffix == ".cpp"], {path for path in files if path.suffix == ".hpp"})


def self_test():
    """Tests the checker itself, because one that cannot fail is useless."""
    def count(*names):
        paths = [pathlib.PurePosixPath(name) for name in names]
        return len(list(judge([p for p in paths if p.suffix == ".cpp"], {p for p in paths if p.suffix == ".hpp"})))

    assert count("fem/mesh/a.cpp") == 1 and count("fem/mesh/a.cpp", "fem/linear/a.hpp") == 1
    assert count("fem/mesh/a.cpp", "fem/mesh/a.hpp") == 0 and count("profiles/a_format.cpp") == 0
    assert count("fem/mesh/a.hpp", "fem/linear/a.hpp") == 1
