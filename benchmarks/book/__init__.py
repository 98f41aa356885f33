# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verification book: every benchmark recomputed and compared with its closed form or source.

    ./rollfem book                       all of it, to docs/book
    ./rollfem book --only carter -o DIR  one chapter, elsewhere

A chapter is a function that takes a Bench (runs.py), asks it for runs of the program or of a test, and returns a
Chapter (chapter.py). Reference values are computed here in Python, independent of the program's code (closed_forms.py),
or quoted with their source (published.py). No value is checked against itself.
"""
