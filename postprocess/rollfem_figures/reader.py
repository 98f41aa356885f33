# SPDX-License-Identifier: LGPL-2.1-or-later
"""results.h5 as numpy arrays.

Units mm, N, MPa, s, rad. Arrays over the contact grid are [ny, nx]; x is the rolling direction,
material enters the patch at large x. Tractions and forces act on the wheel.
"""
import csv
import json
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from .files import folder_of, json_is_sound, results_are_sound

FORMAT_VERSION = 2
JSON_FORMATS = {"compare": ("comparison", 3), "study": ("study", 4)}
STUDY_COLUMNS = {"values": "value", "bars": "error_estimate", "errors": "error", "orders": "order"}
EXTERIOR, ADHESION, SLIP, PLASTIC = 0, 1, 2, 3


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


# Quantities whose error is twice that of another one.
TWICE = {"contact_length": "semi_axis_x", "contact_width": "semi_axis_y"}


class PointRecord:
    """One load point of one model, from a file or from the solution (rollfem.Point).

    `scalars`: longitudinal_creepage, normal_force (N), traction_coefficient = -F_x/F_z, ... as in summary.json.
    `fields`: pressure, traction_x, traction_y, traction_bound (MPa), slip_x, slip_y, gap (mm), state (0 exterior, 1
    adhesion, 2 slip, 3 plastic), ...; fields not given by the model are missing. By quantity: `error_estimate`, the error bar, in
    its unit; `no_bar`, why it has none ("exact", "given", ...);
    `model_error`, in its unit; `richardson`, the value extrapolated to element size 0.
    `subsurface`: dicts for every [[subsurface.*]]: kind, body, points [n, 3], displacement [n, 3], stress [n, 6];
    `stress_maxima`, the largest stresses: dicts body, measure, value (MPa), place [x, y, z] (mm); `bodies`: Bodies of finite
    elements, if stored; otherwise empty.
    `x`, `y`, `place`: those of its model.
    """

    def __init__(self, record, x, y, place):
        self.__dict__.update(record)
        self.x, self.y, self.place = x, y, place

    @property
    def lateral_force_track(self):
        """Lateral force on the wheel in the track frame (to the right), N, where lateral_force lies in the plane of the
        patch (docs/track.md); None without a track."""
        if self.place is None:
            return None
        angle, tilt = self.place["contact_angle"], 1 if self.place["wheel"] == "left" else -1
        return float(tilt * self.scalars["normal_force"] * math.sin(angle) - self.scalars["lateral_force"] * math.cos(angle))


class Point(PointRecord):
    """A load point as figures need it. `number`: of the load point, from 0; `by_number`: identified by it (steps of a
    history, prescribed forces)."""

    def __getitem__(self, name):
        return self.scalars[name]

    def bar(self, quantity):
        """The error bar of a quantity; None if it has none."""
        if quantity not in self.error_estimate and TWICE.get(quantity) in self.error_estimate:
            return 2 * self.error_estimate[TWICE[quantity]]
        return self.error_estimate.get(quantity)

    def found(self, quantity):
        """Whether a creepage or shift is a result: found for a prescribed force. Its statement of the error tells."""
        if word := self.no_bar.get(quantity):
            return word not in ("given", "balance")
        return quantity in self.error_estimate and "spin" not in self.error_estimate  # free rolling has a bar of the spin

    @property
    def creepages(self):
        """(xi, eta, spin)."""
        return tuple(self[n] for n in ("longitudinal_creepage", "lateral_creepage", "spin"))

    @property
    def key(self):
        """Key of a load point within its case, equal in every model: (xi, eta, spin), or the number from 1 in a history
        or with prescribed forces, where creepages are results."""
        return (float(self.number + 1),) if self.by_number else self.creepages


class ModelRecord:
    """All load points of one model on its contact grid, from a file or from the solution (rollfem.ModelResult).

    `name`, `label` (in figures), `key` (name of its group in results.h5: the name, with profiles followed by the patch);
    `seconds`, `unknowns`, `contact_elements`, `notes`; `model_error_source`, source of the model errors, or why there are
    none; `x`, `y`, element centres, and `dx`, `dy` (mm); `place`, with profiles that of the patch: a dict of wheel,
    position, patch, y_track (mm), contact_angle (rad), ...; otherwise None.
    """

    of_point = PointRecord  # type of its load points

    def __init__(self, record):
        self.__dict__.update(record)
        self.points = [self.of_point(point, self.x, self.y, self.place) for point in record["points"]]

    def middle(self, values, axis, at=0.0):
        """`values` [ny, nx] along a line: axis "x" for the line y = at, "y" for x = at.

        The row or column nearest to it; the mean of two if they are equally near.
        """
        across = self.y if axis == "x" else self.x
        distance = np.abs(across - at)
        lines = np.flatnonzero(distance < distance.min() + 1e-6 * (self.dy if axis == "x" else self.dx))
        return values[lines, :].mean(axis=0) if axis == "x" else values[:, lines].mean(axis=1)


class Model(ModelRecord):
    """A model as figures need it."""

    of_point = Point
    _found = None  # points by key, created on first use

    @property
    def has_friction(self):
        """Whether the model covers friction."""
        return any(p["max_traction"] > 0 or any(p.creepages) for p in self.points)

    @property
    def has_bound(self):
        """Whether its tractions have a bound; those of the linear theory do not."""
        return self.name != "linear"

    def at(self, key):
        """The point with that key, (xi, eta, spin) in steady rolling; or None."""
        if self._found is None:
            self._found = {point.key: point for point in reversed(self.points)}
        return self._found.get(key) or next(
            (p for p in self.points if len(p.key) == len(key)
             and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-15) for a, b in zip(p.key, key))), None)

    def nearest(self, longitudinal_creepage):
        """The point whose xi is nearest."""
        return min(self.points, key=lambda p: abs(p["longitudinal_creepage"] - longitudinal_creepage))


@dataclass(frozen=True)
class Quantity:
    """Description of a scalar of a load point."""

    title: str  # for headings: "largest pressure"
    symbol: str  # "F_x", "xi"; empty if there is none
    unit: str  # "-" if it has none
    meaning: str = ""
    percent_of: str = ""  # reference of errors and differences in percent: "value", "mu F_z", ...

    @property
    def label(self):
        """For an axis: "largest pressure (MPa)"."""
        return self.title if self.unit == "-" else f"{self.title} ({self.unit})"


@dataclass
class Result:
    """A whole run."""

    directory: str
    title: str
    case_file: str
    case_text: str
    case: dict
    provenance: dict
    models: list
    quantities: dict = field(default_factory=dict)  # {name: Quantity}, in the order of summary.json
    # with profiles: {(wheel, position): {"rail": [n, 2], "wheel": [n, 2]}}, y and z on the track
    profiles: dict = field(default_factory=dict)
    # name of the reference model, if the user has chosen one
    reference: str = ""
    default_reference: str = ""  # name of the reference model of the command, otherwise the best one of the run
    verdict: str = ""  # one sentence on results that miss the accuracy; otherwise empty

    def scenes(self):
        """(label, Result) of every patch, in the order of the run; ("", self) without profiles."""
        found = {}
        for model in self.models:
            found.setdefault(place_label(model.place), []).append(model)
        if list(found) == [""]:
            return [("", self)]
        return [(label, replace(self, models=models)) for label, models in found.items()]

    def model(self, name):
        """The (first) model of that name; KeyError if the result does not contain it."""
        return {model.name: model for model in reversed(self.models)}[name]


def place_label(place):
    """Label of a patch within a run; empty without profiles."""
    if not place:
        return ""
    text = f"{place['wheel']} wheel, position {place['position']}"
    if place["patches"] > 1:
        text += f", patch {place['patch']} of {place['patches']}"
    return text


def _plain(value):
    """An HDF5 attribute as a Python value."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    return value.item() if isinstance(value, np.generic) else value


def _attributes(item):
    return {name: _plain(value) for name, value in item.attrs.items()}


def _texts(dataset):
    return [_plain(line) for line in dataset[()]] if dataset.shape != (0,) else []


def _read_point(group, number, by_number, nodes):
    below = [{**_attributes(part), **{n: d[()] for n, d in part.items()}}
             for _, part in sorted(group.get("subsurface", {}).items())]
    maxima = {name: data[()] for name, data in group.get("stress_maxima", {}).items()}
    largest = [{name: each if name == "place" else _plain(each) for name, each in zip(maxima, row)}
               for row in zip(*maxima.values())]
    return {"scalars": _attributes(group), "fields": {n: d[()] for n, d in group.items() if hasattr(d, "shape")},
            **{name: _attributes(group[name]) if name in group else {}
               for name in ("error_estimate", "no_bar", "model_error", "richardson")},
            "subsurface": below, "stress_maxima": largest,
            "bodies": Bodies(nodes, group["bodies"]) if nodes is not None and "bodies" in group else {},
            "number": number, "by_number": by_number}


def full_sliding(point, percent_of, friction):
    """Full-sliding value of a quantity whose errors are in percent of `percent_of`; 0 for other quantities."""
    if not percent_of.startswith("mu"):
        return 0.0
    size = {"mu": 1.0, "mu F_z": point["normal_force"], "mu p_0": point["max_pressure"],
            "mu F_z sqrt(ab)": point["normal_force"] * math.sqrt(point["semi_axis_x"] * point["semi_axis_y"])}
    return friction * abs(size[percent_of])


def _read_model(key, group, by_number):
    grid, about = group["grid"], _attributes(group)
    name = about.get("model", key)
    place = _attributes(group["place"]) if "place" in group else None
    for count in ("position", "patch", "patches") if place else ():
        place[count] = int(place[count])
    # Hertz always has a single point.
    points = [_read_point(group["points"][each], number, by_number and name != "hertz", group.get("bodies"))
              for number, each in enumerate(sorted(group["points"]))]
    return {"name": name, "label": about.get("label", ""), "key": key, "seconds": _attributes(group["seconds"]),
            "unknowns": about["unknowns"], "contact_elements": about["contact_elements"], "notes": _texts(group["notes"]),
            "choice": "", "shortfall": "", "model_error_source": about.get("model_error_source", ""),
            **{side: grid[side][()] for side in ("x", "y")}, **{size: _plain(grid.attrs[size]) for size in ("dx", "dy")},
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
        if "friction_law" in file["case"]:  # [n, 2]: slip velocity, mm/s, and coefficient of friction
            case["friction_law"] = file["case/friction_law"][()]
        by_number = bool(case.get("problem", "steady") in ("shift", "transient") or case.get("prescribed_forces", ""))
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
    with open(path, encoding="utf-8", newline="") as file:
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
    with open(path, encoding="utf-8", errors="replace") as file:
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
