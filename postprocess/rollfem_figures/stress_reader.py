# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output of `rollfem stress` as numpy arrays.

Units mm, N, MPa. Global frame: x along rolling, y lateral, z into the wheel. Tension is positive.
"""
import os
from dataclasses import dataclass

import numpy as np

from .files import folder_of
from .reader import ResultError, read_rows, sound_json


@dataclass
class StressSet:
    """Displacement and stress at the places of one request in one body.

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
