#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that what is installed of the headers (bindings/interface/public_headers.txt) is just what rollfem/rollfem.hpp includes, by
itself or through others. Call: public.py SOURCE_DIR"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def included(root, header, found):
    """All headers that one includes, by their paths from the root."""
    for name in INCLUDE.findall((root / header).read_text(encoding="utf-8")):
        if name not in found:
            found.add(name)
            included(root, name, found)
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    listed = set((root / "bindings/interface/public_headers.txt").read_text(encoding="utf-8").split())
    needed = included(root, "bindings/interface/rollfem/rollfem.hpp", set())
    wrong = [f"{name}: is included and not installed; do: add it to bindings/interface/public_headers.txt, or include less"
             for name in sorted(needed - listed)]
    wrong += [f"{name}: is installed and not included; do: take it off bindings/interface/public_headers.txt"
              for name in sorted(listed - needed)]
    print("\n".join(wrong) or f"{len(listed)} public headers, all included by rollfem/rollfem.hpp")
    return 1 if wrong or not needed else 0


if __name__ == "__main__":
    sys.exit(main())
