# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads results.h5, and tables of numbers; without the compiled module:

    from rollfem.reader import read_result
    result = read_result("results/thesis_a")
    point = result["halfspace"].nearest(longitudinal_creepage=0.002)
    point["traction_x"]          # numpy array [ny, nx], MPa, on the wheel
"""
import io
import os
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from .errors import FileError
from .files import folder_of, read_rows, results_are_sound
from .model import ModelResult
from .point import Quantity
from .result import Head, Result, models_of

FORMAT_VERSION = 2
#: What rollfem writes, by a characteristic file of its folder.
KINDS = {"results.h5": "result", "table.h5": "table", "study.json": "study", "compare.json": "compare", "stress.json": "stress"}


def kind_of(path: str) -> str:
    """What rollfem has written at a path: a folder, or a file of it."""
    if os.path.isdir(path):
        return next((kind for file, kind in KINDS.items() if os.path.exists(os.path.join(path, file))), "result")
    return KINDS.get(os.path.basename(path), "result")


def hdf5() -> Any:
    """h5py, loaded by whoever reads a file: `import rollfem` does not wait for it."""
    try:
        import h5py  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise ImportError(f"figures need numpy and h5py: {error}; do: apt install python3-numpy python3-h5py") from error
    return h5py


class Bodies(Mapping[str, dict[str, np.ndarray]]):
    """{"wheel": ..., "rail": ...} of finite elements under one load: dicts of `points` [n, 3] mm undeformed, `cells` [m, 8]
    numbers of points in VTK's order of a hexahedron, `displacement` [n, 3] mm, `stress` [n, 6] MPa (xx, yy, zz, xy, yz,
    xz; tension positive). They are large, so every look-up reads from the file."""

    def __init__(self, nodes: Any, values: Any) -> None:
        """`nodes`, `values`: the groups that hold points and cells, displacement and stress."""
        self._file = values.file.filename
        self._groups = {name: (nodes[name].name, values[name].name) for name in sorted(values)}

    def __getitem__(self, name: str) -> dict[str, np.ndarray]:
        nodes, values = self._groups[name]
        try:
            with hdf5().File(self._file, "r") as file:
                return {**{part: file[nodes][part][()] for part in ("points", "cells")},
                        **{part: file[values][part][()].astype(float) for part in ("displacement", "stress")}}
        except (OSError, KeyError) as error:
            raise FileError(f"{self._file}: the {name} cannot be read: {error}") from error

    def __iter__(self) -> Iterator[str]:
        return iter(self._groups)

    def __len__(self) -> int:
        return len(self._groups)


def _plain(value: Any) -> Any:
    """An HDF5 attribute as a Python value."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    return value.item() if isinstance(value, np.generic) else value


def _attributes(item: Any) -> dict[str, Any]:
    return {name: _plain(value) for name, value in item.attrs.items()}


def _texts(dataset: Any) -> list[str]:
    return [_plain(line) for line in dataset[()]] if dataset.shape != (0,) else []


def _read_yielded(group: Any) -> dict[str, Any]:
    """A body that yields: streamlines as [down, across]."""
    about = _attributes(group)
    shape = about.pop("down"), about.pop("across")
    values = {name: data[()].astype(float) for name, data in group.items()}
    return {**about, **{name: each.reshape(*shape, *each.shape[1:]) if name in ("y", "depth", "strain", "stress", "accumulated")
                        else each for name, each in values.items()}}


def _read_point(group: Any, nodes: Any) -> dict[str, Any]:
    below = [{**_attributes(part), **{n: d[()] for n, d in part.items()}}
             for _, part in sorted(group.get("subsurface", {}).items())]
    maxima = {name: data[()] for name, data in group.get("stress_maxima", {}).items()}
    largest = [{name: each if name == "place" else _plain(each) for name, each in zip(maxima, row)}
               for row in zip(*maxima.values())]
    fields = {name: data[()] for name, data in group.items() if hasattr(data, "shape")}
    return {"scalars": _attributes(group), "pass_work": fields.pop("pass_work", None), "fields": fields,
            **{name: _attributes(group[name]) if name in group else {}
               for name in ("error_estimate", "no_bar", "model_error", "richardson")},
            "subsurface": below, "stress_maxima": largest,
            "yielded": {body: _read_yielded(part) for body, part in group.get("yielded", {}).items()},
            "bodies": Bodies(nodes, group["bodies"]) if nodes is not None and "bodies" in group else {}}


def _read_model(key: str, group: Any) -> dict[str, Any]:
    grid, about = group["grid"], _attributes(group)
    place = _attributes(group["place"]) if "place" in group else None
    if place:
        place.update((count, int(place[count])) for count in ("position", "patch", "patches"))
    points = [_read_point(group["points"][each], group.get("bodies")) for each in sorted(group["points"])]
    return {"name": about.get("model", key), "label": about.get("label", ""), "key": key, "seconds": _attributes(group["seconds"]),
            "unknowns": about["unknowns"], "contact_elements": about["contact_elements"], "notes": _texts(group["notes"]),
            "choice": "", "shortfall": "", "model_error_source": about.get("model_error_source", ""),
            **{side: grid[side][()] for side in ("x", "y")}, **{size: _plain(grid.attrs[size]) for size in ("dx", "dy")},
            **{column: grid[column][()] if column in grid else None for column in ("y_wheel", "y_rail", "width")},
            "place": place, "points": points}


def _read_head(file: Any) -> Head:
    inputs = {name: value for name, value in _attributes(file["case"]).items() if name not in ("title", "file")}
    # friction_law [n, 2]: slip velocity, mm/s, and coefficient; BODY_stress_before [n, 3]: depth, mm, along, across, MPa
    inputs.update({name: item[()] for name, item in file["case"].items() if name != "text"})
    columns = [_texts(file["quantities"][n]) for n in ("name", "title", "symbol", "unit", "meaning", "percent_of")]
    profiles = {(_plain(group.attrs["wheel"]), _plain(group.attrs["position"])):
                {part: group[part][()] for part in ("rail", "wheel")} for group in file.get("profiles", {}).values()}
    return Head(_attributes(file["provenance"]), inputs, {name: Quantity(*row) for name, *row in zip(*columns)}, profiles)


def head_of(data: bytes) -> Head:
    """Of the contents of a results.h5."""
    with hdf5().File(io.BytesIO(data), "r") as file:
        return _read_head(file)


def _read_file(path: str, folder: str) -> Result:
    with hdf5().File(path, "r") as file:
        about = _attributes(file)
        if about.get("format") != "rollfem results":
            raise FileError(f"{path} is not a result of rollfem")
        if about.get("format_version", 0) != FORMAT_VERSION:
            raise FileError(f"{path} has format version {about.get('format_version', 0)}, this program reads {FORMAT_VERSION}")
        if about.get("complete") != 1:
            raise FileError(f"{path} is incomplete, because writing it was interrupted; run the case again")
        head = _read_head(file)
        case = _attributes(file["case"])
        groups = sorted(file["models"].items(), key=lambda item: int(item[1].attrs["order"]))
        models = models_of([_read_model(key, group) for key, group in groups], head.inputs.get("problem"),
                           head.inputs.get("prescribed_forces"))
        return Result(case["title"], case["file"], _plain(file["case/text"][()]), models, about.get("verdict", ""), folder=folder,
                      _head=head)


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
