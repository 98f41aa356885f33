# SPDX-License-Identifier: LGPL-2.1-or-later
"""What rollfem writes, and the module that draws it: of a folder with `read` (of its path), `captioned` ((file name, caption,
function that makes a Figure or returns None) of all figures), `page` (the arguments of page.write_page) and PAGE (its
file); of a table NAME.csv with `of_table`."""
import importlib
import os

from .reader import ResultError, read_rows

# (kind, a characteristic file of the folder, module).
FOLDERS = (("result", "results.h5", "report"), ("table", "table.h5", "table"), ("study", "study.json", "study"),
           ("compare", "compare.json", "compare"), ("stress", "stress.json", "stress_page"))
# (characteristic column of a table, module).
TABLES = (("part", "profiles"), ("conicity_wave", "positions"), ("curvature", "profiles"))


def _module(name):
    """Loads only the modules of the call, because the user waits for each of them."""
    return importlib.import_module(f".{name}", __package__)


def _row(path):
    """The row of FOLDERS of a folder, or of a file of it."""
    if os.path.isdir(path):
        return next((row for row in FOLDERS if os.path.exists(os.path.join(path, row[1]))), FOLDERS[0])
    return next((row for row in FOLDERS if row[1] == os.path.basename(path)), FOLDERS[0])


def kind_of(path):
    """What rollfem has written at a path: a folder, or a file of it."""
    return _row(path)[0]


def figures(path):
    """{name: function that returns the Figure, or None where there is no data for it} of a folder of results, of a
    comparison, a study, a table or stresses. Raises ResultError and OSError as the readers do."""
    module = _module(_row(path)[2])
    return {name.removesuffix(".svg"): draw for name, _, draw in module.captioned(module.read(path))}


def build(path):
    """Draws what lies at a path: the figures and the page of a folder, or NAME.svg of a table NAME.csv."""
    if not path.endswith(".csv"):
        _module("page").build(_module(_row(path)[2]), path)
        return
    columns = next(iter(read_rows(path)[1]), ())
    if not (name := next((module for column, module in TABLES if column in columns), None)):
        raise ResultError(f"{path}: no figure exists for this table; allowed: tables of rollfem profile and rollfem wheelset")
    _module(name).of_table(path).save(os.path.splitext(path)[0] + ".svg")
