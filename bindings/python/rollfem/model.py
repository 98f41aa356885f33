# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of one model on one patch."""
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from rollfem_figures.results import ModelRecord

from . import plot
from .frames import Gridded, Labelled, html_table
from .names import known
from .point import FIELDS, QUANTITIES, Point, array_of, attribute, text_of

#: What tables of notebooks show.
SHOWN = ("longitudinal_creepage", "lateral_creepage", "spin", "normal_force", "traction_coefficient", "max_pressure")
HEADS = [QUANTITIES[name].label for name in SHOWN]


def count(things: Sequence[Any], word: str) -> str:
    """"3 load points"."""
    return f"{len(things)} {word}{'' if len(things) == 1 else 's'}"


class ModelResult(Gridded, ModelRecord):
    """Results of one model on one patch: its load points on its contact grid.

    Every quantity is an array over the load points: model.traction_coefficient; nan where the model does not give it.

    Attributes
    ----------
    points : list of Point
        The load points; also model[k], and iteration.
    x, y : numpy.ndarray
        Centres of the contact elements, mm; dx, dy: their size, mm.
    name, label, key : str
        Of the model; for figures; with wheel, position and patch for true profiles.
    place : dict or None
        wheel, position, patch, patches (from 1), y_track (mm), contact_angle (rad), ... for true profiles.
    seconds : dict
        {stage: s}.
    unknowns, contact_elements : int
    notes : list of str
        What a reader must know.
    choice, shortfall, model_error_source : str
        Why `auto` chose it; what was requested and not reached; how model errors were estimated.
    """

    name: str
    label: str
    key: str
    seconds: dict[str, float]
    unknowns: int
    contact_elements: int
    notes: list[str]
    choice: str
    shortfall: str
    model_error_source: str
    dx: float
    dy: float
    x: np.ndarray
    y: np.ndarray
    place: dict[str, Any] | None

    points: list[Point]
    of_point = Point

    if TYPE_CHECKING:
        def __getattr__(self, name: str) -> Any: ...

    def values(self, name: str) -> np.ndarray:
        """A quantity over the load points.

        Parameters
        ----------
        name : str
            One of rollfem.QUANTITIES.

        Returns
        -------
        numpy.ndarray
            nan where it is not given.

        Raises
        ------
        KeyError
            If there is no such quantity.

        Examples
        --------
        >>> result["halfspace"].values("longitudinal_force")
        """
        return array_of(self.points, name)

    def bars(self, name: str) -> np.ndarray:
        """Error bars of a quantity over the load points.

        Parameters
        ----------
        name : str
            One of rollfem.QUANTITIES.

        Returns
        -------
        numpy.ndarray
            In the unit of the quantity; nan where there are none.

        Raises
        ------
        KeyError
            If there is no such quantity.

        Examples
        --------
        >>> result["halfspace"].bars("longitudinal_force")
        """
        return np.array([np.nan if point.bar(name) is None else point.bar(name) for point in self.points])

    def middle(self, field: str, axis: str = "x", point: int = 0) -> tuple[np.ndarray, np.ndarray]:
        """A field along the middle line of the patch.

        Parameters
        ----------
        field : str
            One of rollfem.FIELDS.
        axis : str
            "x": the line y = 0, "y": the line x = 0; the mean of two lines that are equally near.
        point : int
            Load point, from 0.

        Returns
        -------
        place, values : numpy.ndarray
            mm, and in the unit of the field.

        Raises
        ------
        KeyError
            If there is no such field or axis, or the model does not give the field.

        Examples
        --------
        >>> x, traction = result["halfspace"].middle("traction_x")
        """
        values = self.points[point].fields[known(field, FIELDS, "a field")]
        known(axis, ("x", "y"), "an axis")
        return (self.x if axis == "x" else self.y), super().middle(values, axis)

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[Point]:
        return iter(self.points)

    def __getitem__(self, number: int) -> Point:
        return self.points[number]

    def columns(self) -> dict[str, np.ndarray]:
        """All numbers over the load points.

        Returns
        -------
        dict
            {name: array} of the quantities that the model gives, with NAME_bar beside those that have error bars.

        Examples
        --------
        >>> result["halfspace"].columns()["max_pressure_bar"]
        """
        found = {}
        for name in QUANTITIES:
            if any(point.scalars.get(name) is not None for point in self.points):
                found[name] = self.values(name)
                if any(point.bar(name) is not None for point in self.points):
                    found[f"{name}_bar"] = self.bars(name)
        return found

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
        return html_table(repr(self), HEADS, ([self.values(name)[k] for name in SHOWN] for k in range(len(self))))


def _document() -> None:
    """Makes quantities documented attributes."""
    for name in QUANTITIES:
        if name != "seconds":  # of a model those of its stages
            setattr(ModelResult, name, attribute(ModelResult.values, name, f"Over load points. {text_of(name)}"))


_document()
