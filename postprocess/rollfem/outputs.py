# SPDX-License-Identifier: LGPL-2.1-or-later
"""What studies, comparisons and stresses of results are: the files that their commands write."""
import copy
import csv
import io
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import Annotated, Any

import numpy as np

from .errors import FileError
from .files import cell, folder_of, json_is_sound, regular, rows_of, sealed_json
from .frames import Written, documented
from .point import Quantity
from .result import Result
from .stresses import stress_measures


@documented
class Files(Written):
    """What a command writes."""

    contents: Annotated[dict[str, str], "files by their names"]
    text: Annotated[str, "what the command prints"]
    data: Annotated[dict[str, Any], "the JSON file (docs/commands.md)"]

    word = ""  # for messages
    format = 0  # of the JSON file

    def __init__(self, contents: Mapping[str, str], text: str = "", folder: str = "") -> None:
        self.contents, self.folder = dict(contents), folder
        self.data = json.loads(contents[f"{self.kind}.json"])
        self.text = text or str(self.data.get("verdict", ""))

    @classmethod
    def read(cls, path: str) -> Any:
        """From the folder of a command, or a file of it; FileError where it is not one, or damaged."""
        folder = folder_of(path)
        file = os.path.join(folder, f"{cls.kind}.json")
        contents: dict[str, str] = {}
        for name in (f"{cls.kind}.json", f"{cls.kind}.csv"):
            if cls is Comparison and contents and not os.path.exists(os.path.join(folder, name)):
                continue  # its figures do without the table
            with open(os.path.join(folder, name), encoding="utf-8", errors="replace", newline="",
                      opener=regular) as opened:
                contents[name] = opened.read()
        if not json_is_sound(contents[f"{cls.kind}.json"]):
            raise FileError(f"{file} is truncated, damaged or changed: its checksum does not match; run the command again")
        try:
            data = json.loads(contents[f"{cls.kind}.json"])
            if (data.get("kind", cls.kind), data.get("format")) != (cls.kind, cls.format):
                raise FileError(f"{file} is not a {cls.word} that this program reads; run the command again")
            return cls.of(contents, folder)
        except FileError:
            raise
        except (KeyError, IndexError, ValueError) as error:
            raise FileError(f"{file} is truncated or damaged: {error!r}; run the command again") from error

    @classmethod
    def of(cls, contents: Mapping[str, str], folder: str) -> Any:
        """From its files."""
        return cls(contents, folder=folder)

    @property
    def title(self) -> str:
        """The title of the case."""
        return str(self.data.get("title", ""))

    @property
    def labels(self) -> dict[str, str]:
        """Of the models in figures, by name."""
        return self.data.get("labels") or super().labels

    def columns(self) -> dict[str, np.ndarray]:
        """The CSV file.

        Returns:
            Arrays by the names of its columns; numbers, nan where there is none, or words.

        >>> rollfem.study("cases/thesis_a.toml").columns()["order [-]"]
        """
        rows = list(csv.reader(io.StringIO(self.contents[f"{self.kind}.csv"])))
        return {name: _column([row[k] for row in rows[1:]]) for k, name in enumerate(rows[0])}

    def _contents(self) -> dict[str, str]:
        return self.contents

    def __repr__(self) -> str:
        return f"<rollfem.{type(self).__name__} {self.title!r}>"

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p><pre>{escape(self.text)}</pre>"


def _column(texts: list[str]) -> np.ndarray:
    try:
        return np.array([float(text or "nan") for text in texts])
    except ValueError:
        return np.array(texts)


class Study(Files):
    """A refinement study: a case on ever finer grids. `data["places"]` has series of levels, limits and orders;
    `columns()` every number."""

    kind, word, format = "study", "study", 4

    @cached_property
    def with_numbers(self) -> dict[str, Any]:
        """`data` with the numbers of its levels by quantity, from the table."""
        study: dict[str, Any] = copy.deepcopy(self.data)
        quantities = {name: Quantity(**quantity) for name, quantity in study["quantities"].items()}
        columns = {"values": "value", "bars": "error_estimate", "errors": "error", "orders": "order"}
        levels = {}
        for place in study["places"]:
            place["quantities"] = quantities
            for series in place["series"]:
                series.setdefault("references", place["references"])  # studies of 0.1.0 had one reference for all
                for level in series["levels"]:
                    levels[place["key"], series["model"], series["vary"], level["label"], level["parameter"]] = level
                    level.update((name, {}) for name in columns)
        try:
            for row in rows_of(self.contents["study.csv"])[1]:
                level = levels[row["place"], row["model"], row["vary"], row["level"], float(row["parameter"])]
                for name, column in columns.items():
                    if row[column]:
                        level[name][row["quantity"]] = float(row[column])
        except (KeyError, ValueError) as error:
            raise FileError(f"study.csv is not the table of this study: {error!r}; run the command again") from error
        return study


@documented
class Comparison(Files):
    """Models side by side, each difference beside what error bars allow."""

    results: Annotated[dict[str, Result], "by the name of the case; Result.missing names the models without one, and why"]

    kind, word, format = "compare", "comparison", 3

    def __init__(self, contents: Mapping[str, str], text: str = "", folder: str = "",
                 results: dict[str, Result] | None = None) -> None:
        super().__init__(contents, text, folder)
        self.results = results or {}

    def write(self, folder: str | os.PathLike[str], report: bool = False) -> str | os.PathLike[str]:
        for name, result in self.results.items():
            if result.models:
                result.write(os.path.join(folder, name))
        return super().write(folder, report)

    def __repr__(self) -> str:
        return f"<rollfem.Comparison of {', '.join(self.results)}>"


@dataclass
class StressSet:
    """Displacement and stress at the places of one request in one body, of `rollfem stress`. Global frame: x along rolling, y
    lateral, z into the wheel; tension is positive.

    `columns`: arrays [n] by the names of stress.csv without units: distance (mm, from the first
    place), x, y, z, displacement_x, ... (mm), xx, yy, zz, xy, yz, xz, hydrostatic, von_mises,
    tresca, orthogonal_shear, principal_1, principal_2, principal_3 (MPa), and of heated bodies temperature (degC), whose
    thermal stress the others then have. `shape` is
    (points across, points along): `columns["von_mises"].reshape(shape)` is the lattice of a plane.
    """

    name: str  # point_1, line_1, plane_1, depth_centre, depth_most_loaded, depth_hottest
    kind: str  # point, line, plane, surface
    body: str  # wheel, rail
    shape: tuple[int, int]
    columns: dict[str, np.ndarray]
    largest: list[dict[str, Any]]  # body, measure, value (MPa), place [x, y, z]
    moved: float = 0.0  # mm, largest distance by which a place was moved onto the surface

    def __getitem__(self, name: str) -> np.ndarray:
        return self.columns[name]

    @property
    def places(self) -> np.ndarray:
        """[n, 3], mm."""
        return np.stack([self.columns[name] for name in "xyz"], axis=1)

    @property
    def stress(self) -> np.ndarray:
        """[n, 6], MPa: xx, yy, zz, xy, yz, xz."""
        return np.stack([self.columns[name] for name in COMPONENTS], axis=1)


COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "xz")


def columns_below(places: np.ndarray, displacement: np.ndarray, stress: np.ndarray) -> dict[str, np.ndarray]:
    """The columns of stress.csv."""
    measures = stress_measures(stress)
    return {"distance": np.hypot(np.hypot(*(places - places[0])[:, :2].T), (places - places[0])[:, 2]),
            **dict(zip("xyz", places.T)), **{f"displacement_{axis}": each for axis, each in zip("xyz", displacement.T)},
            **dict(zip(COMPONENTS, stress.T)), **{name: measures[name] for name in ("hydrostatic", "von_mises", "tresca",
                                                                                 "orthogonal_shear")},
            **{f"principal_{k + 1}": each for k, each in enumerate(measures["principal"].T)}}


@dataclass
class StressModel:
    """Stresses of one model at one load point. `data` is its entry in stress.json."""

    name: str
    key: str
    sets: list[StressSet]
    data: dict[str, Any]
    label: str = ""  # label in figures

    def set(self, name: str, body: str) -> StressSet | None:
        """The set of that name and body, or None."""
        return next((s for s in self.sets if (s.name, s.body) == (name, body)), None)


@documented
class Stress(Files):
    """Stresses below the surface at load points of a stored result."""

    models: Annotated[list[StressModel], "one for each model and load point, with `sets`: name, kind, body, shape and columns of "
                      "arrays (x, y, z in mm; xx, ..., von_mises, tresca, ... in MPa), and `largest`"]

    kind, word, format = "stress", "result of stresses", 2
    drawn_from = "stress.json"

    def __init__(self, data: dict[str, Any], models: list[StressModel], text: str = "", folder: str = "") -> None:
        self.data, self.models, self.text, self.folder = data, models, text, folder

    @classmethod
    def of(cls, contents: Mapping[str, str], folder: str) -> "Stress":
        data = json.loads(contents["stress.json"])
        groups: dict[Any, list[list[float]]] = {}
        names: list[str] = []
        for row in rows_of(contents["stress.csv"])[1]:
            names, (model, point, name, body, *numbers) = list(row)[4:], row.values()
            groups.setdefault((model, int(point), name, body), []).append([float(number) for number in numbers])
        columns = {key: dict(zip(names, np.array(rows).T)) for key, rows in groups.items()}
        return cls(data, [StressModel(entry["name"], entry["key"], [
            StressSet(s["name"], s["kind"], s["body"], (s["points_across"], s["points_along"]),
                      columns[entry["key"], entry["point"], s["name"], s["body"]], s["largest"], s["moved"]) for s in entry["sets"]],
            entry, entry.get("label", "")) for entry in data["models"]], folder=folder)

    @cached_property
    def contents(self) -> dict[str, str]:  # type: ignore[override]
        """Files by their names."""
        head = "model,point,set,body," + ",".join(
            f"{name} [{'mm' if k < 7 else 'degC' if name == 'temperature' else 'MPa'}]" for k, name in enumerate(self.models[0].sets[0].columns))
        rows = [f"{model.key},{model.data['point']},{part.name},{part.body},{','.join(map(cell, row))}" for model in self.models
                for part in model.sets for row in np.stack(list(part.columns.values()), axis=1).tolist()]
        return {"stress.csv": "\n".join([head, *rows, ""]), "stress.json": sealed_json(self.data, 2)}
