# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verification book: every benchmark computed again and laid beside its closed form or its source.

    ./rollfem book                       all of it, to docs/book
    ./rollfem book --only carter -o DIR  one chapter, elsewhere

A chapter is a function that takes a Bench (runs.py), asks it for runs of the program or of a test, and
returns a Chapter (chapter.py). Reference values are computed here, in Python and apart from the
program's own code (closed_forms.py), or quoted with their source (published.py). Nothing here computes
what it checks.
"""
