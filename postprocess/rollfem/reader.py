# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads what rollfem has written into the types that computing returns, and tables of numbers; without the compiled module:

    from rollfem.reader import read_result
    result = read_result("results/thesis_a")
    point = result["halfspace"].nearest(longitudinal_creepage=0.002)
    point["traction_x"]          # numpy array [ny, nx], MPa, on the wheel
"""
import errno
import os
from typing import Any

import numpy as np

from .errors import FileError
from .files import folder_of, read_rows, results_are_sound
from .node import Node, hdf5
from .result import Result

FORMAT_VERSION = 3
_WANTED = "do: name a result folder of rollfem run, or its results.h5"
_AGAIN = "do: run the case again"
#: What rollfem writes, by a characteristic file of its folder.
KINDS = {"results.h5": "result", "table.h5": "table", "study.json": "study", "compare.json": "compare", "stress.json": "stress"}


def stored(path: str) -> Any:
    """What rollfem has written to a folder, also named by a file of it: a Result, Table, Study, Comparison or Stress."""
    if os.path.isdir(path):
        kind = next((kind for file, kind in KINDS.items() if os.path.exists(os.path.join(path, file))), "result")
    else:
        kind = KINDS.get(os.path.basename(path), "result")
    if kind == "result":
        return read_result(path)
    if kind == "table":
        from .tables import Table
        return Table(path)
    from .outputs import Comparison, Files, Stress, Study
    kinds: dict[str, type[Files]] = {"study": Study, "compare": Comparison, "stress": Stress}
    return kinds[kind].read(path)


def _read_file(path: str, folder: str) -> Result:
    with hdf5().File(path, "r") as file:
        about = dict(file.attrs)
        if about.get("format") != "rollfem results":
            raise FileError(f"{path} is an HDF5 file, but not a result of rollfem; do: name the results.h5 of a run")
        if about.get("format_version", 0) != FORMAT_VERSION:
            raise FileError(f"{path} has format version {about.get('format_version', 0)}, this program reads {FORMAT_VERSION}; "
                            f"{_AGAIN} with this version of rollfem, or read it with the version that wrote it "
                            f"({file['provenance'].attrs['version']})")
        if about.get("complete") != 1:
            raise FileError(f"{path} is incomplete, because writing it was interrupted; {_AGAIN}")
        made = Result.made_of(Node.in_file(file), folder=folder)
    for model in made.models:
        for name, values in (item for point in model.points for item in point.fields.items()):
            if values.shape != (shape := (len(model.y), len(model.x))):
                raise ValueError(f"{name} has the shape {values.shape} on a grid of {shape}")
    return made


def read_columns(path: str, needed: str) -> tuple[str, dict[str, np.ndarray]]:
    """(title, {column without its unit: array}) of a CSV table of numbers; nan marks a missing one. FileError without
    the column `needed`."""
    title, rows, _ = read_rows(path)
    if not rows or needed not in rows[0]:
        raise FileError(f"{path}: has no column {needed}")
    return title, {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def read_result(path: str) -> Result:
    """Reads a result folder or its results.h5. Raises FileError if it is not complete."""
    file = os.path.join(path, "results.h5") if os.path.isdir(path) else path
    try:
        sound = results_are_sound(file)
    except OSError as error:
        why = {errno.ENOENT: "there is no such file", 0: "is not a regular file"}.get(error.errno or 0, f"cannot be read: {error}")
        raise FileError(f"{file}: {why}; {_WANTED}") from error
    if not sound and not hdf5().is_hdf5(file):
        raise FileError(f"{file}: is not a result of rollfem (no HDF5 file); {_WANTED}")
    if not sound:
        raise FileError(f"{file} is truncated or damaged: its checksum is missing or does not match; {_AGAIN}, or use a copy")
    try:
        return _read_file(file, folder_of(path))
    except FileError:
        raise
    except OSError as error:
        raise FileError(f"{file} is truncated or damaged: {error}; {_AGAIN}") from error
    except (KeyError, TypeError, ValueError) as error:
        raise FileError(f"{file} cannot be read as a result of rollfem: {error}; {_AGAIN}") from error


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
        made = stored(name)
    except OSError as error:
        raise error if isinstance(error, FileError) else FileError(str(error)) from error
    if isinstance(made, Result):
        for point in (point for model in made.models for point in model.points):
            point.bodies = dict(point.bodies)  # the file may go
    if made.kind == "compare":
        for case in made.data["cases"]:
            if case["complete"] and isinstance(result := read(os.path.join(made.folder, case["name"])), Result):
                made.results[case["name"]] = result
    return made
