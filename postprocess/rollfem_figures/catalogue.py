# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of what rollfem has written, by name, each drawn when it is asked for."""
import os

from . import compare, report, stress_page, styles, study, table
from .reader import read_result
from .stress_reader import read_stress


# What a folder holds, by the file that tells.
KINDS = {"results.h5": "result", "table.h5": "table", "study.json": "study", "compare.json": "compare",
         "stress.json": "stress", "wheelset.csv": "wheelset"}


def kind_of(path):
    """What rollfem has written at a path: a folder, or a file of it."""
    if os.path.isdir(path):
        return next((kind for name, kind in KINDS.items() if os.path.exists(os.path.join(path, name))), "result")
    return KINDS.get(os.path.basename(path), "result")


def _know(models):
    styles.know({model.name: model.label for model in models})


def figures(path):
    """{name: function that returns the Figure, or None where there is no data for it} of a folder of results, of a
    comparison, a study, a table or stresses. Raises ResultError and OSError as the readers do."""
    kind, folder = kind_of(path), path if os.path.isdir(path) else os.path.dirname(os.path.abspath(path))
    if kind == "study":
        captioned = study.captioned(study.read_study(folder))
    elif kind == "compare":
        captioned = compare.captioned(compare.read_comparison(folder))
    elif kind == "table":
        captioned = table.figures(table.read_table(folder))
    elif kind == "stress":
        found = read_stress(folder)
        _know(found.models)
        captioned = stress_page.figures(found)
    else:
        result = read_result(path)
        _know(result.models)
        captioned = report.all_captions(result)
    return {name.removesuffix(".svg"): draw for name, _, draw in captioned}
