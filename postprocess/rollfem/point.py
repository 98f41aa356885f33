# SPDX-License-Identifier: LGPL-2.1-or-later
"""Load points, as numbers and numpy arrays: what each quantity and field is.

Units mm, N, MPa, s, rad. Arrays over the contact grid are [ny, nx], x the rolling direction.
"""
import importlib
import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Generic, TypeVar

import numpy as np

from .frames import documented
from .node import Node

#: Values of the field `state`.
EXTERIOR, ADHESION, SLIP, PLASTIC = 0, 1, 2, 3


@dataclass(frozen=True)
class Quantity:
    """Description of a scalar of a load point."""

    title: str  #: for headings: "largest pressure"
    symbol: str  #: "F_x", "xi"; empty if there is none
    unit: str  #: "-" if it has none
    meaning: str = ""
    percent_of: str = ""  #: reference of errors and differences in percent: "value", "mu F_z", ...
    compared: bool = False  #: whether models are compared by it; not in files

    @property
    def label(self) -> str:
        """For an axis: "largest pressure (MPa)"."""
        return self.title if self.unit == "-" else f"{self.title} ({self.unit})"

    @property
    def of_friction(self) -> bool:
        """Whether full sliding is the reference of errors and differences."""
        return self.percent_of.startswith("mu")

    def full_sliding(self, point: "Point", friction: float) -> float:
        """The value in full sliding at a load point, in the unit of the quantity; 0 unless it is the reference."""
        if not self.of_friction:
            return 0.0
        force, pressure, a, b = (float(point.scalars.get(name) or 0.0)
                                 for name in ("normal_force", "max_pressure", "semi_axis_x", "semi_axis_y"))
        return friction * abs({"mu": 1.0, "mu F_z": force, "mu F_z sqrt(ab)": force * math.sqrt(a * b), "mu p_0": pressure}[self.percent_of])


@dataclass(frozen=True)
class Field:
    """Description of an array over the contact grid."""

    unit: str
    description: str
    sign: str


Row = TypeVar("Row")


class Described(Mapping[str, Row], Generic[Row]):
    """Descriptions by name, from the compiled module on first use: figures of stored results do without them."""

    def __init__(self, kind: Callable[..., Row], source: str) -> None:
        self._kind, self._source = kind, source

    @cached_property
    def _rows(self) -> dict[str, Row]:
        try:
            from . import _core
        except ImportError:
            return {}
        return {name: self._kind(*row) for name, row in getattr(_core, self._source)().items()}

    def __getitem__(self, name: str) -> Row:
        return self._rows[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)


QUANTITIES: Mapping[str, Quantity] = Described(Quantity, "quantities")
FIELDS: Mapping[str, Field] = Described(Field, "fields")


class Bodies(Mapping[str, dict[str, np.ndarray]]):
    """{"wheel": ..., "rail": ...} of finite elements under one load: dicts of `points` [n, 3] mm undeformed, `cells` [m, 8]
    numbers of points in VTK's order of a hexahedron, `displacement` [n, 3] mm, `stress` [n, 6] MPa (xx, yy, zz, xy, yz,
    xz; tension positive). They are large, so every look-up reads from the file."""

    def __init__(self, nodes: Node, values: Node) -> None:
        self._nodes, self._values = nodes.parts, values.parts

    def __getitem__(self, name: str) -> dict[str, np.ndarray]:
        return {**{part: self._nodes[name].entries[part] for part in ("points", "cells")},
                **{part: self._values[name].entries[part].astype(float) for part in ("displacement", "stress")}}

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(self._values))

    def __len__(self) -> int:
        return len(self._values)


def _section(node: Node) -> dict[str, Any]:
    """A body that yields: streamlines as [down, across]."""
    about = dict(node.attributes)
    down, across = about.pop("down"), about.pop("across")
    return {**about, **{name: array.astype(float).reshape(*(down, across) if len(array) == down * across else array.shape[:1],
                                                          *array.shape[1:]) for name, array in node.entries.items()}}


class Named:
    """What has attributes by the names of quantities, which `api` makes when it is first loaded."""

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_"):
            importlib.import_module(".api", __package__)
            if name in type(self).__dict__:
                return type(self).__dict__[name].__get__(self)
        raise AttributeError(f"{type(self).__name__} has no {name}")


@documented
class Point(Named):
    """One load point of one model: every quantity and every field by its name.

    point.max_pressure is a number, None where the model does not give it or the load point has no solution; point.pressure
    an array [ny, nx], None where the model has none. Bars are absolute, in the unit of the quantity.
    """

    scalars: Annotated[dict[str, Any], "the quantities that the model gives"]
    fields: Annotated[dict[str, np.ndarray], "the fields that it gives"]
    error_estimate: Annotated[dict[str, float], "by quantity: uncertainty left by grid and solver"]
    no_bar: Annotated[dict[str, str], "by quantity: why it has none"]
    model_error: Annotated[dict[str, float], "by quantity: what the model neglects, on any grid"]
    richardson: Annotated[dict[str, float], "by quantity: value extrapolated to elements of size 0"]
    subsurface: Annotated[list[dict[str, Any]], "for every [[subsurface.*]]: kind, body, points [n, 3] (mm), displacement "
                          "[n, 3] (mm), stress [n, 6] (MPa: xx, yy, zz, xy, yz, xz)"]
    stress_maxima: Annotated[list[dict[str, Any]], "body, measure, value (MPa), place (mm)"]
    bodies: Annotated[Mapping[str, dict[str, np.ndarray]], "wheel and rail with points, cells, displacement and stress, for "
                      "finite elements only"]
    yielded: Annotated[Mapping[str, dict[str, Any]], "wheel and rail that yield, after this pass (step of a shift) of the "
                       "load: verdict, from_pass, increment, ...; y, depth, accumulated [down, across], strain, stress [down, "
                       "across, 6] of the section behind the load (below the middle of the contact); surface_y, groove, "
                       "forward_flow [across; empty after a step] (docs/results.md)"]
    pass_work: Annotated[np.ndarray | None, "frictional work per pass and area of the rows [ny] of the grid, N/mm; its bar "
                         "is that of max_pass_work"]
    place: Annotated[dict[str, Any] | None, "of the patch, as of its ModelResult"]
    number: Annotated[int, "of the load point in its model, from 0"]
    by_number: Annotated[str, 'what this number counts if it identifies the load point: "load point" (steps of a history, '
                         'prescribed forces) or "pass" (bodies that yield); otherwise ""']

    def __init__(self, node: Node, number: int, by_number: str, place: dict[str, Any] | None, bodies: Node | None) -> None:
        """`bodies`: the nodes and cells of wheel and rail."""
        parts = node.parts
        self.scalars = {name: value for name, value in node.attributes.items() if value == value}  # nan: no solution
        self.fields = {name: array for name, array in node.entries.items() if name != "pass_work"}
        self.pass_work = node.entries.get("pass_work")
        for name in ("error_estimate", "no_bar", "model_error", "richardson"):
            setattr(self, name, parts[name].attributes if name in parts else {})
        self.subsurface = [{**part.attributes, **part.entries} for part in parts["subsurface"].parts.values()
                           ] if "subsurface" in parts else []
        self.stress_maxima = node.rows("stress_maxima")
        self.yielded = {body: _section(part) for body, part in parts["yielded"].parts.items()} if "yielded" in parts else {}
        none: Mapping[str, dict[str, np.ndarray]] = {}
        self.bodies = none if bodies is None or "bodies" not in parts else Bodies(bodies, parts["bodies"])
        self.number, self.by_number, self.place = number, by_number, place

    def __getitem__(self, name: str) -> Any:
        """A quantity or field; KeyError where the model does not give it."""
        if name in self.scalars:
            return self.scalars[name]
        return self.fields[name if name in self.fields else known(name, [*QUANTITIES, *FIELDS], "a quantity or field")]

    def bar(self, name: str) -> float | None:
        """The error bar of a quantity.

        Args:
            name: One of rollfem.QUANTITIES.
        Returns:
            In the unit of the quantity; None where it has none.
        Raises:
            KeyError: There is no such quantity.

        >>> result.points[0].bar("max_pressure")
        """
        return self.error_estimate.get(name if name in self.scalars else known(name, QUANTITIES))

    def found(self, name: str) -> bool:
        """Whether a creepage or shift is a result, found for a prescribed force.

        Args:
            name: Of the creepage or shift.
        Returns:
            Told by its error bar, or by why it has none.

        >>> result.points[0].found("longitudinal_creepage")
        """
        if word := self.no_bar.get(name):
            return word not in ("given", "balance")
        return name in self.error_estimate and "spin" not in self.error_estimate  # free rolling has a bar of the spin

    @property
    def tangential_coefficient(self) -> float:
        """T/F_z, of the tangential tractions alone, as in stress.json: the pressure of a curved patch acts across, too."""
        force = float(self.scalars.get("normal_force", 0.0))  # none without a solution
        across = self.scalars.get("lateral_force", 0.0) - self.scalars.get("lateral_pressure", 0.0)
        return math.hypot(self.scalars.get("longitudinal_force", 0.0), across) / force if force > 0 else 0.0

    @property
    def creepages(self) -> tuple[float, float, float]:
        """(xi, eta, spin)."""
        return self.scalars["longitudinal_creepage"], self.scalars["lateral_creepage"], self.scalars["spin"]

    @property
    def key(self) -> tuple[Any, ...]:
        """Key of a load point within its case, equal in every model: (xi, eta, spin), or (number from 1, what it counts)
        where creepages are results or repeat."""
        return (self.number + 1, self.by_number) if self.by_number else self.creepages

    def __repr__(self) -> str:
        at = ", ".join(f"{QUANTITIES[name].symbol} = {self.scalars[name]:.4g}"
                       for name in ("longitudinal_creepage", "lateral_creepage", "spin") if self.scalars.get(name))
        if self.scalars.get("max_pressure") is None:
            return f"<rollfem.Point {at or 'without creepage'}: no solution>"
        return (f"<rollfem.Point {at or 'without creepage'}: p_0 = {self.scalars['max_pressure']:.4g} MPa, "
                f"-F_x/F_z = {self.scalars['traction_coefficient']:.4g}>")


def known(name: str, allowed: Collection[str], what: str = "a quantity") -> str:
    """The name, if it is allowed; otherwise KeyError with what might be meant."""
    if name in allowed:
        return name
    import difflib
    near = difflib.get_close_matches(str(name), allowed, 1)
    raise KeyError(f"{name}: not {what}; {f'did you mean {near[0]}? ' if near else ''}allowed: {', '.join(allowed)}")


def columns_of(values: Callable[[str], np.ndarray], bars: Callable[[str], np.ndarray],
               beside: Collection[str] = ()) -> dict[str, np.ndarray]:
    """The quantities that there are `beside` others, with NAME_bar where there are bars."""
    found = {}
    for name in QUANTITIES:
        if name not in beside and not np.isnan(numbers := values(name)).all():
            found[name] = numbers.ravel()
            if not np.isnan(uncertain := bars(name)).all():
                found[f"{name}_bar"] = uncertain.ravel()
    return found


def array_of(numbers: Iterable[float | None]) -> np.ndarray:
    """nan for None."""
    return np.array([np.nan if number is None else number for number in numbers])


def text_of(name: str) -> str:
    """A quantity in words."""
    quantity = QUANTITIES[name]
    symbol = f", {quantity.symbol}" if quantity.symbol else ""
    return f"{quantity.title}{symbol} [{quantity.unit}]: {quantity.meaning}"


def attributes(kind: type, get: Callable[[Any, str], Any], texts: Mapping[str, str]) -> None:
    """Documented attributes of a class, by their names, that get(self, name) looks up."""
    def looked_up(name: str) -> property:
        return property(lambda self: get(self, name), doc=texts[name])

    for name in texts:
        setattr(kind, name, looked_up(name))
