# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads results.h5, and tables of numbers; without the compiled module:

    from rollfem.reader import read_result
    result = read_result("results/thesis_a")
    point = result["halfspace"].nearest(longitudinal_creepage=0.002)
    point["traction_x"]          # numpy array [ny, nx], MPa, on the wheel
"""
import os

import numpy as np

from .errors import FileError
from .files import folder_of, read_rows, results_are_sound
from .node import Node, hdf5
from .result import Result

FORMAT_VERSION = 2
#: What rollfem writes, by a characteristic file of its folder.
KINDS = {"results.h5": "result", "table.h5": "table", "study.json": "study", "compare.json": "compare", "stress.json": "stress"}


def kind_of(path: str) -> str:
    """What rollfem has written at a path: a folder, or a file of it."""
    if os.path.isdir(path):
        return next((kind for file, kind in KINDS.items() if os.path.exists(os.path.join(path, file))), "result")
    return KINDS.get(os.path.basename(path), "result")


def _read_file(path: str, folder: str) -> Result:
    with hdf5().File(path, "r") as file:
        about = dict(file.attrs)
        if about.get("format") != "rollfem results":
            raise FileError(f"{path} is not a result of rollfem")
        if about.get("format_version", 0) != FORMAT_VERSION:
            raise FileError(f"{path} has format version {about.get('format_version', 0)}, this program reads {FORMAT_VERSION}")
        if about.get("complete") != 1:
            raise FileError(f"{path} is incomplete, because writing it was interrupted; run the case again")
        return Result.made_of(Node.in_file(file), folder=folder)


def read_columns(path: str, needed: str) -> tuple[str, dict[str, np.ndarray]]:
    """(title, {column without its unit: array}) of a CSV table of numbers; nan marks a missing one. FileError without
    the column `needed`."""
    title, rows = read_rows(path)
    if not rows or needed not in rows[0]:
        raise FileError(f"{path}: has no column {needed}")
    return title, {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def read_result(path: str) -> Result:
    """Reads a result folder or its results.h5. Raises FileError if it is not complete."""
    file = os.path.join(path, "results.h5") if os.path.isdir(path) else path
    if not os.path.exists(file):
        raise FileError(f"there is no {file}: not a result folder of `rollfem run`")
    if not os.path.isfile(file):  # a device would have no end
        raise FileError(f"{file} is not a file")
    try:
        sound = results_are_sound(file)
    except OSError as error:
        raise FileError(f"{file} cannot be read: {error}") from error
    if not hdf5().is_hdf5(file):
        raise FileError(f"{file} is not a result of rollfem (no HDF5 file)")
    if not sound:
        raise FileError(f"{file} is truncated or damaged: its checksum does not match; "
                        "run the case again, or use a copy")
    try:
        return _read_file(file, folder_of(path))
    except FileError:
        raise
    except OSError as error:
        raise FileError(f"{file} is truncated or damaged: {error}; run the case again") from error
    except KeyError as error:
        raise FileError(f"{file} cannot be read as a result of rollfem: {error}; "
                        "run the case again") from error
