# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads results.h5, stresses, and tables and JSON files of rollfem; published values for a case (published.json)."""
import csv
import json
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .files import folder_of, json_is_sound, regular, results_are_sound
from .results import Model, Quantity, Result

FORMAT_VERSION = 2
JSON_FORMATS = {"compare": ("comparison", 3), "study": ("study", 4)}
STUDY_COLUMNS = {"values": "value", "bars": "error_estimate", "errors": "error", "orders": "order"}


class ResultError(Exception):
    """The folder or file is not a complete rollfem result."""


def hdf5():
    """h5py, loaded by whoever reads a file: `import rollfem` does not wait for it."""
    try:
        import h5py  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise ImportError(f"figures need numpy and h5py: {error}; do: apt install python3-numpy python3-h5py") from error
    return h5py


class Bodies(Mapping):
    """{"wheel": ..., "rail": ...} of finite elements under one load: dicts of `points` [n, 3] mm undeformed, `cells` [m, 8]
    numbers of points in VTK's order of a hexahedron, `displacement` [n, 3] mm, `stress` [n, 6] MPa (xx, yy, zz, xy, yz,
    xz; tension positive). They are large, so every look-up reads from the file."""

    def __init__(self, nodes, values):
        """`nodes`, `values`: the groups that hold points and cells, displacement and stress."""
        self._file = values.file.filename
        self._groups = {name: (nodes[name].name, values[name].name) for name in sorted(values)}

    def __getitem__(self, name):
        nodes, values = self._groups[name]
        try:
            with hdf5().File(self._file, "r") as file:
                return {**{part: file[nodes][part][()] for part in ("points", "cells")},
                        **{part: file[values][part][()].astype(float) for part in ("displacement", "stress")}}
        except (OSError, KeyError) as error:
            raise ResultError(f"{self._file}: the {name} cannot be read: {error}") from error

    def __iter__(self):
        return iter(self._groups)

    def __len__(self):
        return len(self._groups)


def _plain(value):
    """An HDF5 attribute as a Python value."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    return value.item() if isinstance(value, np.generic) else value


def _attributes(item):
    return {name: _plain(value) for name, value in item.attrs.items()}


def _texts(dataset):
    return [_plain(line) for line in dataset[()]] if dataset.shape != (0,) else []


def _read_yielded(group):
    """A body that yields: streamlines as [down, across]."""
    about = _attributes(group)
    shape = about.pop("down"), about.pop("across")
    values = {name: data[()].astype(float) for name, data in group.items()}
    return {**about, **{name: each.reshape(*shape, *each.shape[1:]) if name in ("y", "depth", "strain", "stress", "accumulated")
                        else each for name, each in values.items()}}


def _read_point(group, number, by_number, nodes):
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
            "bodies": Bodies(nodes, group["bodies"]) if nodes is not None and "bodies" in group else {},
            "number": number, "by_number": by_number}


def _read_model(key, group, by_number):
    grid, about = group["grid"], _attributes(group)
    name = about.get("model", key)
    place = _attributes(group["place"]) if "place" in group else None
    for count in ("position", "patch", "patches") if place else ():
        place[count] = int(place[count])
    # Hertz always has a single point.
    points = [_read_point(group["points"][each], number, by_number if name != "hertz" else "", group.get("bodies"))
              for number, each in enumerate(sorted(group["points"]))]
    return {"name": name, "label": about.get("label", ""), "key": key, "seconds": _attributes(group["seconds"]),
            "unknowns": about["unknowns"], "contact_elements": about["contact_elements"], "notes": _texts(group["notes"]),
            "choice": "", "shortfall": "", "model_error_source": about.get("model_error_source", ""),
            **{side: grid[side][()] for side in ("x", "y")}, **{size: _plain(grid.attrs[size]) for size in ("dx", "dy")},
            **{column: grid[column][()] if column in grid else None for column in ("y_wheel", "y_rail", "width")},
            "place": place, "points": points}


def _read_file(path, directory, of_model):
    with hdf5().File(path, "r") as file:
        about = _attributes(file)
        if about.get("format") != "rollfem results":
            raise ResultError(f"{path} is not a result of rollfem")
        if about.get("format_version", 0) != FORMAT_VERSION:
            raise ResultError(f"{path} has format version {about.get('format_version', 0)}, this program reads "
                              f"{FORMAT_VERSION}")
        if about.get("complete") != 1:
            raise ResultError(f"{path} is incomplete, because writing it was interrupted; run the case again")
        case = _attributes(file["case"])
        # friction_law [n, 2]: slip velocity, mm/s, and coefficient; BODY_stress_before [n, 3]: depth, mm, along, across, MPa
        case.update({name: item[()] for name, item in file["case"].items() if name != "text"})
        by_number = "load point" if case.get("problem", "steady") in ("shift", "transient") or case.get(
            "prescribed_forces", "") else ""
        if any("yielded" in point for group in file["models"].values() for point in group["points"].values()):
            by_number = "pass"
        models = [of_model(_read_model(name, group, by_number)) for name, group in
                  sorted(file["models"].items(), key=lambda item: _plain(item[1].attrs["order"]))]
        columns = [_texts(file["quantities"][n]) for n in ("name", "title", "symbol", "unit", "meaning", "percent_of")]
        profiles = {(_plain(group.attrs["wheel"]), _plain(group.attrs["position"])):
                    {part: group[part][()] for part in ("rail", "wheel")} for group in file.get("profiles", {}).values()}
        return Result(directory, case.pop("title"), case.pop("file"), _plain(file["case/text"][()]), case,
                      _attributes(file["provenance"]), models,
                      {name: Quantity(*row) for name, *row in zip(*columns)}, profiles,
                      verdict=about.get("verdict", ""))


def read_rows(path):
    """(title, [{column without its unit: text}]) of a CSV table; the title comes from a comment above it."""
    with open(path, encoding="utf-8", newline="", opener=regular) as file:
        title = file.readline()
        if not title.startswith("#"):
            title = file.seek(0) or ""
        rows = list(csv.reader(file))
    names = [column.split(" [")[0] for column in rows[0]] if rows else []
    return title.lstrip("# ").strip(), [dict(zip(names, row)) for row in rows[1:]]


def read_columns(path, needed):
    """(title, {column without its unit: array}) of a CSV table of numbers; nan marks a missing one. ResultError without
    the column `needed`."""
    title, rows = read_rows(path)
    if not rows or needed not in rows[0]:
        raise ResultError(f"{path}: has no column {needed}")
    return title, {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}


def _add_numbers(study, path):
    """Adds to the levels of a study their numbers by quantity, from its table."""
    levels = {(place["key"], series["model"], series["vary"], level["label"], level["parameter"]): level
              for place in study["places"] for series in place["series"] for level in series["levels"]}
    for level in levels.values():
        level.update((name, {}) for name in STUDY_COLUMNS)
    try:
        for row in read_rows(path)[1]:
            level = levels[row["place"], row["model"], row["vary"], row["level"], float(row["parameter"])]
            for name, column in STUDY_COLUMNS.items():
                if row[column]:
                    level[name][row["quantity"]] = float(row[column])
    except (OSError, KeyError, ValueError) as error:
        raise ResultError(f"{path} is not the table of this study: {error!r}; run the command again") from error


def sound_json(path):
    """The contents of a JSON file of rollfem. Raises ResultError if it is damaged."""
    with open(path, encoding="utf-8", errors="replace", opener=regular) as file:
        text = file.read()
    if not json_is_sound(text):
        raise ResultError(f"{path} is truncated, damaged or changed: its checksum does not match; "
                          "run the command again")
    try:
        return json.loads(text)
    except ValueError as error:
        raise ResultError(f"{path} is truncated or damaged: {error}; run the command again") from error


def read_json(directory, kind):
    """Reads compare.json or study.json by its kind, with the numbers of a study's levels. Raises ResultError if it is
    damaged or has another format."""
    directory = folder_of(directory)
    path = os.path.join(directory, f"{kind}.json")
    data = sound_json(path)
    word, version = JSON_FORMATS[kind]
    if (data.get("kind"), data.get("format")) != (kind, version):
        raise ResultError(f"{path} is not a {word} that this program reads")
    data["directory"] = directory
    if kind == "study":
        _add_numbers(data, os.path.join(directory, "study.csv"))
    return data


def read_result(path, of_model=Model):
    """Reads a result folder or its results.h5, with models of this type (ModelRecord). Raises ResultError if it is not
    complete."""
    directory, file = folder_of(path), os.path.join(path, "results.h5") if os.path.isdir(path) else path
    if not os.path.exists(file):
        raise ResultError(f"there is no {file}: not a result folder of `rollfem run`")
    if not os.path.isfile(file):  # a device would have no end
        raise ResultError(f"{file} is not a file")
    try:
        sound = results_are_sound(file)
    except OSError as error:
        raise ResultError(f"{file} cannot be read: {error}") from error
    if not hdf5().is_hdf5(file):
        raise ResultError(f"{file} is not a result of rollfem (no HDF5 file)")
    if not sound:
        raise ResultError(f"{file} is truncated or damaged: its checksum does not match; "
                          "run the case again, or use a copy")
    try:
        return _read_file(file, directory, of_model)
    except OSError as error:
        raise ResultError(f"{file} is truncated or damaged: {error}; run the case again") from error
    except KeyError as error:
        raise ResultError(f"{file} cannot be read as a result of rollfem: {error}; "
                          "run the case again") from error


@lru_cache(maxsize=1)
def _all_published():
    with open(os.path.join(os.path.dirname(__file__), "published.json"), encoding="utf-8") as file:
        return json.load(file)


def _is(value, wanted):
    """Whether an input matches the entry: null means flat, a list holds all allowed values; near and within give a
    range."""
    if value is None:
        return False
    if wanted is None:
        return math.isinf(value)
    if isinstance(wanted, list):
        return value in wanted
    if isinstance(wanted, dict):
        return abs(value - wanted["near"]) <= wanted["within"]
    return value == wanted


def _has(values, wanted):
    return all(_is(values.get(name), value) for name, value in wanted.items())


def _published_case(result):
    """The entry whose inputs match the result and whose place matches its patch; empty if there is none. A result with
    several patches has none; pass one of its scenes."""
    places = {m.place["wheel"]: m.place for m in result.models if m.place}
    if len(result.scenes()) > 1 or "rail_rolling_radius" in result.case:
        return {}
    for entry in _all_published()["cases"].values():
        wanted = entry.get("place")
        at_place = not places if wanted is None else any(_has(p, wanted) for p in places.values())
        if at_place and _has(result.case, {**_all_published()["common"], **entry["inputs"]}):
            return entry
    return {}


def published(result):
    """Published data for the case: `creep_curve`, rows name, source, xi (list), traction_coefficient (list, -F_x/F_z);
    `patch`, rows name, source, and the known ones of semi_axis_x, semi_axis_y, contact_length, contact_width (mm),
    contact_area (mm²), max_pressure (MPa), approach (mm), max_traction_x ({"xi", "value" in MPa}); `says`, remarks of
    the 2012 study; `sources`, one sentence for each. Empty if nothing is published."""
    found = {"creep_curve": [], "patch": [], "says": "", **_published_case(result)}
    used = dict.fromkeys(row["source"] for row in found["patch"] + found["creep_curve"])
    return {**found, "sources": "; ".join(_all_published()["sources"][name] for name in used)}


@dataclass
class StressSet:
    """Displacement and stress at the places of one request in one body, of `rollfem stress`. Global frame: x along rolling, y
    lateral, z into the wheel; tension is positive.

    `columns`: arrays [n] by the names of stress.csv without units: distance (mm, from the first
    place), x, y, z, displacement_x, ... (mm), xx, yy, zz, xy, yz, xz, hydrostatic, von_mises,
    tresca, orthogonal_shear, principal_1, principal_2, principal_3 (MPa). `shape` is
    (points across, points along): `columns["von_mises"].reshape(shape)` is the lattice of a plane.
    """

    name: str  # at_1, line_1, plane_1, depth_centre, depth_most_loaded
    kind: str  # point, line, plane, surface
    body: str  # wheel, rail
    shape: tuple
    columns: dict
    largest: list  # dicts measure, value (MPa), over_max_pressure, place [x, y, z]

    def __getitem__(self, name):
        return self.columns[name]


@dataclass
class StressModel:
    """Stresses of one model at one load point. `data` is its entry in stress.json."""

    name: str
    key: str
    sets: list
    data: dict
    label: str = ""  # label in figures

    def set(self, name, body):
        """The set of that name and body, or None."""
        return next((s for s in self.sets if (s.name, s.body) == (name, body)), None)


@dataclass
class StressResult:
    directory: str
    title: str
    source: str
    models: list
    yield_shear_stress: float = None  # MPa, or None if none was given
    shakedown_map: dict = None  # boundaries: lists by name, over tangential_coefficient


def _rows(path):
    """{(model key, load point, set, body): {column: array}} of stress.csv, columns without their units."""
    groups = {}
    for row in read_rows(path)[1]:
        names, (model, point, name, body, *numbers) = list(row)[4:], row.values()
        groups.setdefault((model, int(point), name, body), []).append([float(number) for number in numbers])
    return {key: dict(zip(names, np.array(rows).T)) for key, rows in groups.items()}


def read_stress(directory):
    """Reads the folder of a `rollfem stress` call, or its stress.json. Raises ResultError if it is not one."""
    directory = folder_of(directory)
    try:
        data = sound_json(os.path.join(directory, "stress.json"))
        if data["format"] != 2:
            raise ResultError(f"{directory}: stress.json has format {data['format']}, not 2; do: run rollfem stress again")
        rows = _rows(os.path.join(directory, "stress.csv"))
        models = [StressModel(entry["name"], entry["key"], [
            StressSet(s["name"], s["kind"], s["body"], (s["points_across"], s["points_along"]),
                      rows[entry["key"], entry["point"], s["name"], s["body"]], s["largest"]) for s in entry["sets"]],
            entry, entry.get("label", "")) for entry in data["models"]]
        return StressResult(directory, data["title"], data["source"], models,
                            data.get("yield_shear_stress"), data.get("shakedown_map"))
    except (OSError, KeyError, IndexError, ValueError) as error:
        raise ResultError(f"{directory} is not a folder of `rollfem stress`: {error}") from error
