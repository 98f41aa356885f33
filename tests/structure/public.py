# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that what is installed of the headers (bindings/interface/public_headers.txt) is just what rollfem/rollfem.hpp includes, by
itself or through others."""
import re

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def included(root, header, found):
    """All headers that one includes, by their paths from the root."""
    for name in INCLUDE.findall((root / header).read_text(encoding="utf-8")):
        if name not in found:
            found.add(name)
            included(root, name, found)
    return found


def problems(root):
    listed = set((root / "bindings/interface/public_headers.txt").read_text(encoding="utf-8").split())
    needed = included(root, "bindings/interface/rollfem/rollfem.hpp", set())
    if not needed:
        yield "bindings/interface/rollfem/rollfem.hpp includes nothing"
    for name in needed - listed:
        yield f"{name}: is included and not installed; do: add it to bindings/interface/public_headers.txt, or include less"
    for name in listed - needed:
        yield f"{name}: is installed and not included; do: take it off bindings/interface/public_headers.txt"
