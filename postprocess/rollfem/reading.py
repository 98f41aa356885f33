# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads what rollfem has written into the types that computing returns."""
import os
from typing import Any

from .errors import FileError
from .outputs import Comparison, Stress, Study
from .reader import kind_of, read_result
from .result import Result
from .tables import Table


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
    try:
        kind = kind_of(name)
        if kind == "table":
            return Table(name)
        made = {"result": read_result, "study": Study.read, "compare": Comparison.read, "stress": Stress.read}[kind](name)
    except OSError as error:
        raise error if isinstance(error, FileError) else FileError(str(error)) from error
    if isinstance(made, Result):
        for point in (point for model in made.models for point in model.points):
            point.bodies = dict(point.bodies)  # the file may go
    if isinstance(made, Comparison):
        for case in made.data["cases"]:
            if case["complete"] and isinstance(stored := read(os.path.join(made.folder, case["name"])), Result):
                made.results[case["name"]] = stored
    return made
