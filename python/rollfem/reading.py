# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads stored results into the same types as solved ones."""
import importlib
import os
import sys
import tomllib

from . import _core
from .case import Case
from .result import ModelResult, Result


def _reader():
    """The reader of the plotting program, which supports earlier formats and checksums."""
    folder = os.path.dirname(_core.figures_directory())
    if folder not in sys.path:
        sys.path.append(folder)
    try:
        return importlib.import_module("rollfem_figures.reader")
    except ImportError as error:
        raise ImportError(f"reading results needs h5py and {folder}/rollfem_figures: {error}; "
                          "do: apt install python3-h5py") from error


def _point(point):
    return {**vars(point), "bodies": {name: vars(body) for name, body in point.bodies.items()}}


def _model(model):
    return ModelResult({**vars(model), "choice": "", "shortfall": "", "points": [_point(point) for point in model.points]})


def read(folder):
    """Reads a folder written by `rollfem run` or `Result.write`, or its results.h5, as a rollfem.Result. Raises
    rollfem.InputError if it is not a complete result."""
    reader = _reader()
    try:
        stored = reader.read_result(os.fspath(folder))
    except (reader.ResultError, OSError) as error:
        raise _core.InputError(str(error)) from error
    return Result(StoredCase(stored), [_model(model) for model in stored.models], provenance=stored.provenance,
                  folder=stored.directory)


class StoredCase(Case):
    """The case of a stored result. It is parsed only if more than title and text is needed, because missing files of
    the case must not prevent showing the result."""

    def __init__(self, stored):
        self._stored, self._file = stored, stored.case_file
        self._data = tomllib.loads(stored.case_text)

    @property
    def core(self):
        """Reads the case."""
        return Case.of(self._file, self._data).core

    @property
    def title(self):
        return self._stored.title

    @property
    def text(self):
        return self._stored.case_text

    def __repr__(self):
        return f"<rollfem.Case {self.title!r}, stored>"
