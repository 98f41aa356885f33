# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads what rollfem has written into the types that computing returns."""
import os
import tomllib
from types import SimpleNamespace
from typing import Any

from rollfem_figures.files import regular
from rollfem_figures.reader import ResultError, read_json, read_result

from . import _core
from .case import Case
from .model import ModelResult
from .result import Result
from .studies import Comparison, Stress, Study
from .tables import Table

FILES = {"study": Study, "compare": Comparison, "stress": Stress}


def _text(folder: str, name: str) -> str:
    with open(os.path.join(folder, name), encoding="utf-8", opener=regular) as file:
        return file.read()


def read(path: str | os.PathLike[str]) -> Any:
    """Whatever rollfem has written to a folder.

    Args:
        path: The folder of `rollfem run`, `table`, `study`, `compare` or `stress`, or of `write` of what is returned
            here; or its results.h5, table.h5, study.json, compare.json, stress.json.
    Returns:
        A Result, Table, Study, Comparison or Stress.
    Raises:
        FileError: There is nothing of this kind, or it is damaged.
        ImportError: Without h5py.

    >>> rollfem.read("results/thesis_a")["halfspace"].max_pressure
    """
    name = os.fspath(path)
    from rollfem_figures.catalogue import kind_of
    try:
        kind = kind_of(name)
        if kind == "table":
            return Table(name)
        if kind in FILES:
            return _files(kind, name if os.path.isdir(name) else os.path.dirname(name) or ".")
        stored = read_result(name, ModelResult)
    except (ResultError, OSError) as error:
        raise _core.FileError(str(error)) from error
    for point in (point for model in stored.models for point in model.points):
        point.bodies = dict(point.bodies)  # the file may go
    case = StoredCase(stored.case_file, str(stored.title), str(stored.case_text))
    return Result(case, stored.models, provenance=stored.provenance, folder=stored.directory,
                  verdict=stored.verdict)


def _files(kind: str, folder: str) -> Study | Comparison | Stress:
    found: type[Study | Comparison | Stress] = FILES[kind]
    if found is not Stress:  # which reads all of its own
        read_json(folder, kind)  # which knows checksums
    made = found({name: _text(folder, name) for name in (found.json, found.table)}, folder=folder)
    if isinstance(made, Comparison):
        for case in made.data["cases"]:
            if case["complete"] and isinstance(stored := read(os.path.join(folder, case["name"])), Result):
                made.results[case["name"]] = stored
    return made


class StoredCase(Case):
    """The case of a stored result. It is parsed only if more than title and text is needed, because missing files of
    the case must not prevent showing the result."""

    def __init__(self, file: str, title: str, text: str) -> None:
        self._file, self._data, self._read = file, tomllib.loads(text), SimpleNamespace(title=title, text=text)

    def __reduce__(self) -> tuple[Any, ...]:
        return StoredCase, (self._file, self.title, self.text)

    @property
    def core(self) -> _core.Case:
        """Reads the case."""
        return Case.of(self._file, self._data).core

    def __repr__(self) -> str:
        return f"<rollfem.Case {self.title!r}, stored>"
