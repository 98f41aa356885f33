# SPDX-License-Identifier: LGPL-2.1-or-later
"""What rollfem writes, and the module that draws it: of a folder with `read` (of its path), of an object of the package with
`of`; `captioned` ((file name, caption, function that makes a Figure or returns None) of all figures), `page` (the arguments
of page.write_page) and PAGE (its file); of a table NAME.csv with `of_table`."""
import importlib
import os
from types import ModuleType
from typing import Any

from ..errors import FileError
from ..files import read_rows
from ..reader import kind_of

# By the kinds of reader.KINDS.
MODULES = {"result": "report", "table": "table", "study": "study", "compare": "compare", "stress": "stress_page"}
# (characteristic column of a table, module).
TABLES = (("part", "profiles"), ("conicity_wave", "positions"), ("curvature", "profiles"))


def _module(name):
    """Loads only the modules of the call, because the user waits for each of them."""
    return importlib.import_module(f".{name}", __package__)


def drawing(kind: str) -> ModuleType:
    """The module that draws a kind of folder."""
    return _module(MODULES[kind])


def draw(thing: Any, folder: str) -> None:
    """Draws the figures and the page of an object of the package to a folder."""
    module = drawing(thing.kind)
    _module("page").draw(module, module.of(thing), folder)


def build(path: str) -> None:
    """Draws what lies at a path: the figures and the page of a folder, or NAME.svg of a table NAME.csv."""
    if not path.endswith(".csv"):
        _module("page").build(drawing(kind_of(path)), path)
        return
    columns = next(iter(read_rows(path)[1]), ())
    if not (name := next((module for column, module in TABLES if column in columns), None)):
        raise FileError(f"{path}: no figure exists for this table; allowed: tables of rollfem profile and rollfem wheelset")
    _module(name).of_table(path).save(os.path.splitext(path)[0] + ".svg")
