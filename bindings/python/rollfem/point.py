# SPDX-License-Identifier: LGPL-2.1-or-later
"""Load points, as numbers and numpy arrays: what each quantity and field is.

Units mm, N, MPa, s, rad. Arrays over the contact grid are [ny, nx], x the rolling direction.
"""
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from numpy.typing import ArrayLike
from rollfem_figures.results import PointRecord, Quantity

from . import _core
from .frames import documented
from .names import known


@dataclass(frozen=True)
class Field:
    """Description of an array over the contact grid."""

    unit: str
    description: str
    sign: str


QUANTITIES = {name: Quantity(*row) for name, row in _core.quantities().items()}
FIELDS = {name: Field(*row) for name, row in _core.fields().items()}


@documented
class Point(PointRecord):
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
    yielded: Annotated[Mapping[str, dict[str, Any]], "wheel and rail that yield, after this pass of the load: "
                       "verdict, from_pass, increment, ...; y, depth, accumulated [down, across], strain, stress [down, "
                       "across, 6] of the section behind the load; surface_y, groove, forward_flow [across] (docs/results.md)"]
    pass_work: Annotated[np.ndarray | None, "frictional work per pass and area of the rows [ny] of the grid, N/mm; its bar "
                         "is that of max_pass_work"]
    place: Annotated[dict[str, Any] | None, "of the patch, as of its ModelResult"]

    if TYPE_CHECKING:
        def __getattr__(self, name: str) -> Any: ...

    def __getitem__(self, name: str) -> Any:
        """A quantity or field; KeyError where the model does not give it."""
        known(name, [*QUANTITIES, *FIELDS], "a quantity or field")
        return self.fields[name] if name in self.fields else self.scalars[name]

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
        return self.error_estimate.get(known(name, QUANTITIES))

    def __repr__(self) -> str:
        at = ", ".join(f"{QUANTITIES[name].symbol} = {self.scalars[name]:.4g}"
                       for name in ("longitudinal_creepage", "lateral_creepage", "spin") if self.scalars.get(name))
        if self.max_pressure is None:
            return f"<rollfem.Point {at or 'without creepage'}: no solution>"
        return (f"<rollfem.Point {at or 'without creepage'}: p_0 = {self.max_pressure:.4g} MPa, "
                f"-F_x/F_z = {self.traction_coefficient:.4g}>")


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


def stress_measures(stress: ArrayLike) -> dict[str, np.ndarray]:
    """Scalars of stresses.

    Args:
        stress: [..., 6], MPa: xx, yy, zz, xy, yz, xz, as point.subsurface and point.bodies have them.
    Returns:
        Arrays by name, MPa, tension positive. hydrostatic: (xx + yy + zz) / 3; von_mises, tresca: equivalent uniaxial
        stresses, the latter the difference of the outer principal stresses; orthogonal_shear: sqrt(xz^2 + yz^2), on the
        plane parallel to the surface; principal [..., 3]: principal stresses, the largest first.
    Raises:
        ValueError: The last axis does not have length six.

    >>> rollfem.stress_measures(point.subsurface[0]["stress"])["von_mises"].max()
    """
    try:
        stress = np.asarray(stress, dtype=float)
    except (TypeError, ValueError):
        raise _core.InputError(f"stress_measures({stress!r:.60}): allowed: numbers, six along the last axis") from None
    return _core.stress_measures(stress)


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


attributes(Point, lambda self, name: self.scalars.get(name), {name: text_of(name) for name in QUANTITIES})
attributes(Point, lambda self, name: self.fields.get(name),
           {name: f"[ny, nx], {field.unit}: {field.description}{'; ' * bool(field.sign)}{field.sign}"
            for name, field in FIELDS.items()})
