# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case, and of one model on one patch."""
import math
from collections.abc import Iterator, Mapping, Sequence, Sized
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from . import plot
from .errors import InputError
from .frames import Gridded, Labelled, Written, documented, html_table
from .node import Node
from .point import FIELDS, QUANTITIES, Named, Point, Quantity, array_of, columns_of, known

if TYPE_CHECKING:
    from ._core import Result as CoreResult
    from .case import Case


#: What tables of notebooks show.
SHOWN = ("longitudinal_creepage", "lateral_creepage", "spin", "normal_force", "traction_coefficient", "max_pressure")


def count(things: Sized, word: str, ending: str = "s") -> str:
    """"3 load points"."""
    return f"{len(things)} {word}{'' if len(things) == 1 else ending}"


@documented
@dataclass(frozen=True)
class Note:
    """What a reader of a result must know; str(note) is its text."""

    severity: Annotated[str, "`remark` or `warning`"]
    about: Annotated[str, "the subject; notes of one model about the same differ in their numbers only"]
    text: Annotated[str, "one sentence"]

    def __str__(self) -> str:
        return self.text


@cache
def registered() -> dict[str, frozenset[str]]:
    """What holds of the models of the program, by name: files of earlier versions do not say it."""
    try:
        from . import _core
    except ImportError:
        return {}
    return {model["name"]: frozenset(name for name, holds in model.items() if holds is True) for model in _core.model_infos()}


@documented
class ModelResult(Gridded, Named):
    """Results of one model on one patch: its load points on its contact grid.

    Every quantity is an array over the load points: model.traction_coefficient; nan where the model does not give it.
    """

    points: Annotated[list[Point], "the load points; also model[k], and iteration"]
    x: Annotated[np.ndarray, "centres of the contact elements along rolling, mm"]
    y: Annotated[np.ndarray, "across, mm"]
    dx: Annotated[float, "size of the elements, mm"]
    dy: Annotated[float, "mm"]
    y_wheel: Annotated[np.ndarray | None, "of the rows [ny] on the wheel's profile, mm; without profiles y"]
    y_rail: Annotated[np.ndarray | None, "of the rows on the rail's profile, mm"]
    width: Annotated[np.ndarray | None, "of the rows along the surface, mm"]
    name: Annotated[str, "of the model"]
    label: Annotated[str, "for figures"]
    key: Annotated[str, "the name, for true profiles with wheel, position and patch"]
    place: Annotated[dict[str, Any] | None, "for true profiles wheel, position, patch, patches (from 1), y_track (mm), "
                     "contact_angle (rad), ..."]
    seconds: Annotated[dict[str, float], "by stage, s"]
    unknowns: Annotated[int, "size of the system of equations"]
    contact_elements: Annotated[int, "elements in contact"]
    notes: Annotated[list[Note], "what a reader must know, sources of errors among it"]
    choice: Annotated[str, "why `auto` chose it"]
    shortfall: Annotated[str, "what was requested and not reached"]
    hot_limit: Annotated[float, "degC, wheel_heat.limit or rail_heat.limit: above it steel transforms"]
    traits: Annotated[frozenset[str], "what holds of the model, as registered: bounded, has_stress, ..."]

    _found: dict[tuple[Any, ...], Point] | None = None  # points by key, created on first use

    def __init__(self, key: str, node: Node, by_number: str = "") -> None:
        """`by_number`: as of Point."""
        about, grid = node.attributes, node.parts["grid"]
        self.key, self.name, self.place = key, about["model"], node.parts["place"].attributes if "place" in node.parts else None
        notes = node.parts["notes"].entries
        self.seconds = node.parts["seconds"].attributes
        self.notes = [Note(*row) for row in zip(*(notes[column] for column in ("severity", "about", "text")))]
        self.unknowns, self.contact_elements = about["unknowns"], about["contact_elements"]
        for text in ("label", "choice", "shortfall"):
            setattr(self, text, about.get(text, ""))
        self.dx, self.dy = grid.attributes["dx"], grid.attributes["dy"]
        for column in ("x", "y", "y_wheel", "y_rail", "width"):
            setattr(self, column, grid.entries.get(column))
        points = sorted(node.parts["points"].parts.items(), key=lambda item: int(item[0]))
        self.traits = frozenset(node.parts["traits"].attributes) if "traits" in node.parts else registered().get(
            self.name, frozenset({"bounded"}))
        self.points = [Point(point, number, "" if "frictionless" in self.traits else by_number, self.place, node.parts.get("bodies"))
                       for number, (_, point) in enumerate(points)]

    @property
    def headline(self) -> Point | None:
        """The load point whose numbers stand for the model: the last pass over bodies that yield, otherwise the first one at the
        largest normal force; None if none has a solution."""
        solved = [p for p in self.points if p.scalars.get("normal_force") is not None]
        if not solved or solved[0].by_number == "pass":
            return solved[-1] if solved else None
        largest = max(p["normal_force"] for p in solved)
        return next(p for p in solved if p["normal_force"] >= largest * (1 - 1e-9))

    @property
    def has_friction(self) -> bool:
        """Whether the model covers friction."""
        return any(p["max_traction"] > 0 or any(p.creepages) for p in self.points)

    @property
    def has_bound(self) -> bool:
        """Whether its tractions have a bound; those of the linear theory do not."""
        return "bounded" in self.traits

    def values(self, name: str) -> np.ndarray:
        """A quantity over the load points.

        Args:
            name: One of rollfem.QUANTITIES.
        Returns:
            In the unit of the quantity; nan where it is not given.
        Raises:
            KeyError: There is no such quantity.

        >>> result["halfspace"].values("longitudinal_force")
        """
        known(name, QUANTITIES)
        return array_of(point.scalars.get(name) for point in self.points)

    def bars(self, name: str) -> np.ndarray:
        """Error bars of a quantity over the load points.

        Args:
            name: One of rollfem.QUANTITIES.
        Returns:
            In the unit of the quantity; nan where there are none.
        Raises:
            KeyError: There is no such quantity.

        >>> result["halfspace"].bars("longitudinal_force")
        """
        return array_of(point.bar(name) for point in self.points)

    def middle(self, field: str, axis: str = "x", point: int = 0) -> tuple[np.ndarray, np.ndarray]:
        """A field along the middle line of the patch.

        Args:
            field: One of rollfem.FIELDS.
            axis: "x": the line y = 0, "y": the line x = 0; the mean of two lines that are equally near.
            point: Load point, from 0.
        Returns:
            The places along the line, mm, and the values, in the unit of the field.
        Raises:
            KeyError: There is no such field or axis, or the model does not give the field.

        >>> x, traction = result["halfspace"].middle("traction_x")
        """
        values = self.points[point].fields[known(field, FIELDS, "a field")]
        known(axis, ("x", "y"), "an axis")
        return (self.x if axis == "x" else self.y), self.line(values, axis)

    def line(self, values: np.ndarray, axis: str, at: float = 0.0) -> np.ndarray:
        """Values over the contact grid along any line.

        Args:
            values: [ny, nx], in any unit (N, MPa, mm, -).
            axis: "x": the line y = at, "y": the line x = at.
            at: mm; the row or column nearest to it counts, the mean of two that are equally near.
        Returns:
            Over model.x or model.y.

        >>> model.line(model.points[0].pressure, "x", at=2.5)
        """
        across = self.y if axis == "x" else self.x
        distance = np.abs(across - at)
        lines = np.flatnonzero(distance < distance.min() + 1e-6 * (self.dy if axis == "x" else self.dx))
        found: np.ndarray = values[lines, :].mean(axis=0) if axis == "x" else values[:, lines].mean(axis=1)
        return found

    def at(self, key: tuple[Any, ...]) -> Point | None:
        """The load point with some creepages.

        Args:
            key: Point.key: (xi, eta, spin) in steady rolling.
        Returns:
            None where there is no such load point.

        >>> result["fastsim"].at(result["halfspace"].points[0].key)
        """
        if self._found is None:
            self._found = {point.key: point for point in reversed(self.points)}
        return self._found.get(key) or next(
            (p for p in self.points if len(p.key) == len(key) == 3
             and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-15) for a, b in zip(p.key, key))), None)

    def nearest(self, longitudinal_creepage: float) -> Point:
        """The load point whose longitudinal creepage is nearest.

        Args:
            longitudinal_creepage: xi, -.

        >>> result["halfspace"].nearest(0.002).traction_x
        """
        return min(self.points, key=lambda p: abs(float(p["longitudinal_creepage"]) - longitudinal_creepage))

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Point]:
        return iter(self.points)

    def __getitem__(self, number: int) -> Point:
        return self.points[number]

    def columns(self) -> dict[str, np.ndarray]:
        """All numbers over the load points.

        Returns:
            Arrays by name of the quantities that the model gives, with NAME_bar beside those that have error bars.

        >>> result["halfspace"].columns()["max_pressure_bar"]
        """
        return columns_of(self.values, self.bars)

    def _labelled(self) -> Labelled:
        values: dict[str, tuple[Sequence[str], Any, dict[str, str]]] = {}
        for name, column in self.columns().items():
            values[name] = ("point_index",), column, {"units": QUANTITIES[name.removesuffix("_bar")].unit}
        empty = np.full((len(self.y), len(self.x)), np.nan)
        for name, field in FIELDS.items():
            if any(name in point.fields for point in self.points):
                values[name] = (("point_index", "y", "x"), np.stack([p.fields.get(name, empty) for p in self.points]),
                                {"units": field.unit})
        return (values, {"point_index": np.arange(len(self)), "x": self.x, "y": self.y},
                {"model": self.name, "key": self.key})

    plot_creep_curve = plot.creep_curve
    plot_pressure = plot.pressure
    plot_traction = plot.traction
    plot_path = plot.path

    def __repr__(self) -> str:
        seconds = self.seconds.get("total")
        took = "" if seconds is None else f", {seconds:.3g} s"
        return f"<rollfem.ModelResult {self.key}: {count(self.points, 'load point')}, {self.contact_elements} elements{took}>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), heads(), ([self.values(name)[k] for name in SHOWN] for k in range(len(self))))


def heads() -> list[str]:
    """Of the columns SHOWN."""
    return [QUANTITIES[name].label for name in SHOWN]


@documented
@dataclass(eq=False, repr=False)
class Result(Written):
    """A case and the results of its models: result["halfspace"], or result.models in the order of the run, with true
    profiles one for each patch of each wheel and position."""

    title: Annotated[str, "the title of the case"]
    case_file: Annotated[str, "the case file"]
    case_text: Annotated[str, "the case as TOML"]
    models: Annotated[list[ModelResult], "in the order of the run"]
    verdict: Annotated[str, "which contacts miss the accuracy, by how much, and what would help; empty if none does"] = ""
    missing: Annotated[list[tuple[str, str, bool]], "model, reason, whether it failed, of the models without a result, in "
                       "comparisons"] = field(default_factory=list)
    folder: Annotated[str, "of results that were read"] = ""
    provenance: Annotated[dict[str, Any], "version, commit, host, started, command, processes"] = field(default_factory=dict)
    inputs: Annotated[dict[str, Any], "the keys of the case that it gives or that have a default, by path: "
                      "\"wheel.rolling_radius\"; lists are arrays"] = field(default_factory=dict)
    friction_law: Annotated[np.ndarray | None, "[n, 2] where friction falls: slip velocity (mm/s; in a shift slip in mm), "
                            "coefficient"] = None
    quantities: Annotated[dict[str, Quantity], "what the numbers are"] = field(default_factory=dict)
    profiles: Annotated[dict[tuple[str, int], dict[str, np.ndarray]], "by wheel and position rail and wheel [n, 2], y and z "
                        "on the track (mm)"] = field(default_factory=dict)
    dips: Annotated[list[dict[str, Any]], "model, wheel, track_position, loaded_height (mm), dip_angle (rad): where each wheel "
                    "is lowest on its way along the track, and how sharply it turns"] = field(default_factory=list)
    overlays: list[tuple[str, np.ndarray]] = field(default_factory=list)  # for creep curves: (name, [n, 2 or 3] creepage, value, bar)
    reference: str = ""  # name of the reference model of figures, if the user has chosen one
    default_reference: str = ""  # that of the command, otherwise the best one of the run
    _core: "CoreResult | None" = None

    kind = "result"
    first_figure = "creep_curve"

    @classmethod
    def of(cls, case: "Case", core: "CoreResult", missing: Sequence[tuple[str, str, bool]] = ()) -> "Result":
        """From results of the library."""
        from . import _core
        made = cls.made_of(Node.of(_core.contents_of(core)), missing=list(missing), _core=core)
        made.case_file, made.__dict__["case"] = case.file, case
        return made

    @classmethod
    def made_of(cls, root: Node, **others: Any) -> "Result":
        """From what a file or the library holds."""
        case, about, none = root.parts["case"], root.attributes, Node({}, {}, {})
        keys = case.parts.get("keys", none)
        columns = [root.parts["quantities"].entries[n] for n in ("name", "title", "symbol", "unit", "meaning", "percent_of")]
        pairs = root.parts["profiles"].parts.values() if "profiles" in root.parts else ()
        made = cls(case.attributes["title"], case.attributes["file"], case.entries["text"], [], about.get("verdict", ""),
                   provenance=root.parts["provenance"].attributes, inputs={**keys.attributes, **keys.entries},
                   friction_law=case.entries.get("friction_law"),
                   quantities={name: Quantity(*row) for name, *row in zip(*columns)},
                   dips=root.rows("dips"),
                   profiles={(pair.attributes["wheel"], pair.attributes["position"]): dict(pair.entries) for pair in pairs}, **others)
        models = sorted(root.parts["models"].parts.items(), key=lambda item: int(item[1].attributes["order"]))
        history = made.inputs.get("rolling.problem") in ("shift", "transient")
        by_number = "load point" if history or made.prescribed_forces else ""
        if not history and any("yielded" in point.parts for _, model in models for point in model.parts["points"].parts.values()):
            by_number = "pass"
        made.models = [ModelResult(key, model, by_number) for key, model in models]
        for model in made.models:
            model.hot_limit = min((made.inputs[key] for key in ("wheel_heat.limit", "rail_heat.limit") if key in made.inputs), default=700.0)
        return made

    @property
    def prescribed_forces(self) -> bool:
        """Whether creepages (shifts) were found for prescribed forces."""
        return not {"rolling.longitudinal_force", "rolling.lateral_force"}.isdisjoint(self.inputs)

    @property
    def friction_coefficient(self) -> float:
        """At rest; the largest where it varies."""
        return float(np.max(self.inputs["friction.coefficient"]))

    @property
    def slip_speed(self) -> float:
        """Slip velocity over slip, mm/s: the rolling speed; a shift has none, its slip in mm is taken as that of a second."""
        return 1.0 if self.inputs["rolling.problem"] == "shift" else float(self.inputs["rolling.speed"])

    def __reduce__(self) -> Any:
        return super().__reduce__() if self._core is None else (Result.of, (self.case, self._core, self.missing))

    @cached_property
    def case(self) -> "Case":
        """What was solved."""
        from .case import StoredCase
        return StoredCase(self.case_file, self.title, self.case_text)

    def __getitem__(self, key: str | int) -> ModelResult:
        """A model by its key, or the first of that name; or by number."""
        if isinstance(key, int):
            return self.models[key]
        for model in [*(m for m in self.models if m.key == key), *(m for m in self.models if m.name == key)]:
            return model
        raise KeyError(f"{key}: this result has {', '.join(model.key for model in self.models)}")

    def __iter__(self) -> Iterator[ModelResult]:
        return iter(self.models)

    def __len__(self) -> int:
        return len(self.models)

    @property
    def points(self) -> list[Point]:
        """Load points of the only model; ValueError where there are several results."""
        if len(self.models) != 1:
            raise ValueError(f"this result has {', '.join(model.key for model in self.models)}; do: take one, as in "
                             f"result[{self.models[0].key!r}].points" if self.models else "there is no model")
        return self.models[0].points

    def columns(self) -> dict[str, np.ndarray]:
        """All numbers over models and load points.

        Returns:
            Arrays by name: model, key and point_index (from 0, as result[...].points has them; `point` of files counts from
            1), with true profiles those of the place, then the quantities and their bars.

        >>> result.columns()["point_index"]
        """
        parts: list[dict[str, Any]] = [
            {"model": model.name, "key": model.key, "point_index": np.arange(len(model)), **(model.place or {}),
             **model.columns()} for model in self.models]
        return {name: np.concatenate([np.broadcast_to(part.get(name, np.nan), len(model))
                                      for part, model in zip(parts, self.models)])
                for name in dict.fromkeys(name for part in parts for name in part)}

    def scenes(self) -> list[tuple[str, "Result"]]:
        """The results of every patch.

        Returns:
            Label and Result in the order of the run; "" and itself without profiles.

        >>> [label for label, _ in result.scenes()]
        """
        found: dict[str, list[ModelResult]] = {}
        for model in self.models:
            found.setdefault(place_label(model.place), []).append(model)
        if list(found) == [""]:
            return [("", self)]
        return [(label, replace(self, models=models)) for label, models in found.items()]

    def _store(self, folder: str, report: bool) -> str:
        if self._core is None:
            raise InputError(f"{folder}: this result was read from {self.folder}; do: copy that folder")
        from . import _core
        return _core.write(self._core, folder, report)

    plot_creep_curve = plot.creep_curves

    def __repr__(self) -> str:
        models = ", ".join(f"{m.key} ({count(m.points, 'load point')})" for m in self.models[:6])
        more = f", and {len(self.models) - 6} more" if len(self.models) > 6 else ""
        return f"<rollfem.Result {self.title!r}: {models}{more}>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ["model", "point_index", *heads()],
                          ([model.key, k, *(model.values(name)[k] for name in SHOWN)]
                           for model in self.models for k in range(len(model))))


def exact_one(models: Sequence[ModelResult], k: int, name: str, resolved: float) -> ModelResult | None:
    """The model whose value of a quantity is exact at load point k, if its model error is not resolved."""
    return next((m for m in models if k < len(m) and m[k].no_bar.get(name) == "exact"
                 and m[k].model_error.get(name, 0.0) <= resolved), None)


def models_of(core: "CoreResult") -> list[ModelResult]:
    """The models of a result of the library."""
    from . import _core
    return Result.made_of(Node.of(_core.contents_of(core))).models


def place_label(place: Mapping[str, Any] | None) -> str:
    """Label of a patch within a run; empty without profiles."""
    if not place:
        return ""
    text = f"{place['wheel']} wheel, position {place['position']}"
    if place["patches"] > 1:
        text += f", patch {place['patch']} of {place['patches']}"
    return text
