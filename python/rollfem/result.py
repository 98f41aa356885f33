# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results: load points of models, as numbers and numpy arrays.

Units mm, N, MPa, s, rad. Arrays over the contact grid are [ny, nx], x the rolling direction.
"""
from dataclasses import dataclass

import numpy as np

from . import _core, plot


@dataclass(frozen=True)
class Quantity:
    """Description of a scalar of a load point."""

    title: str  #: for headings: "largest pressure"
    symbol: str  #: "F_x", "xi"; empty if there is none
    unit: str  #: "-" if it has none
    meaning: str
    percent_of: str  #: reference of errors in percent: "the value", "mu F_z", ...

    @property
    def label(self):
        """Label for an axis: "largest pressure (MPa)"."""
        return self.title if self.unit == "-" else f"{self.title} ({self.unit})"


@dataclass(frozen=True)
class Field:
    """Description of an array over the contact grid."""

    unit: str
    description: str
    sign: str


QUANTITIES = {name: Quantity(*row) for name, row in _core.quantities().items()}
FIELDS = {name: Field(*row) for name, row in _core.fields().items()}


class Point:
    """One load point of one model: every quantity and every field by its name.

    point.max_pressure is a number, point.pressure an array [ny, nx]; None if the model does not give it. Error bars are
    absolute, in the unit of the quantity:

    error_estimate: {quantity: error bar for grid and solver};
    no_bar: {quantity: why it has no error bar};
    model_error: {quantity: error of the model itself, on any grid};
    richardson: {quantity: value extrapolated to element size 0};
    subsurface: for every [[subsurface.*]] a dict of kind, body, points [n, 3] (mm), displacement [n, 3] (mm), stress
    [n, 6] (MPa: xx, yy, zz, xy, yz, xz);
    stress_maxima: dicts of body, measure, value (MPa), place (mm);
    bodies: {"wheel": ..., "rail": ...} with points, cells, displacement and stress, for finite elements only.
    """

    def __init__(self, record, x, y):
        self.scalars = record["scalars"]
        self.fields = record["fields"]
        self.error_estimate = record["error_estimate"]
        self.no_bar = record["no_bar"]
        self.model_error = record["model_error"]
        self.richardson = record["richardson"]
        self.subsurface = record["subsurface"]
        self.stress_maxima = record["stress_maxima"]
        self.bodies = record["bodies"]
        self.x, self.y = x, y

    def __getitem__(self, name):
        """A quantity or field by name; KeyError if the model does not give it."""
        return self.fields[name] if name in self.fields else self.scalars[name]

    def bar(self, name):
        """The error bar of a quantity, in its unit; None if it has none."""
        return self.error_estimate.get(name)

    def __repr__(self):
        at = ", ".join(f"{QUANTITIES[name].symbol} = {self.scalars[name]:.4g}"
                       for name in ("longitudinal_creepage", "lateral_creepage", "spin") if self.scalars.get(name))
        return (f"<rollfem.Point {at or 'without creepage'}: p_0 = {self.max_pressure:.4g} MPa, "
                f"-F_x/F_z = {self.traction_coefficient:.4g}>")


class ModelResult:
    """Results of one model on one patch: its load points on its contact grid.

    Every quantity is an array over the load points: model.traction_coefficient; nan if the model does not give it.
    x, y: centres of the contact elements, mm; dx, dy: their size, mm.
    name, label: of the model; key: name with wheel, position and patch for true profiles; place: a dict
    of these, with y_track (mm), contact_angle (rad), ..., or None.
    seconds: {stage: s}; unknowns, contact_elements: numbers; notes: remarks on the results; choice: why `auto` chose
    it;
    shortfall: requested accuracy that was not reached; model_error_source: how model errors were estimated.
    """

    def __init__(self, record):
        points = record.pop("points")
        self.__dict__.update(record)
        self.points = [Point(each, self.x, self.y) for each in points]

    def values(self, name):
        """A quantity as an array over the load points; nan if it is not given."""
        return _array(self.points, name)

    def bars(self, name):
        """The error bars of a quantity, in its unit; nan if there are none."""
        return np.array([np.nan if point.bar(name) is None else point.bar(name) for point in self.points])

    def middle(self, field, axis="x", point=0):
        """(place in mm, values) of a field, by its name, along a centre line: "x" is the line y = 0, "y" the line x =
        0; the mean of the two nearest rows if they are equally near."""
        values = self.points[point][field]
        across, size = (self.y, self.dy) if axis == "x" else (self.x, self.dx)
        distance = np.abs(across)
        lines = np.flatnonzero(distance < distance.min() + 1e-6 * size)
        if axis == "x":
            return self.x, values[lines, :].mean(axis=0)
        return self.y, values[:, lines].mean(axis=1)

    def __len__(self):
        return len(self.points)

    def __iter__(self):
        return iter(self.points)

    def __getitem__(self, number):
        return self.points[number]

    def columns(self):
        """{name: array over the load points} of all quantities that the model gives, with NAME_bar for those with error
        bars."""
        found = {}
        for name in QUANTITIES:
            if any(point.scalars.get(name) is not None for point in self.points):
                found[name] = self.values(name)
                if any(point.bar(name) is not None for point in self.points):
                    found[f"{name}_bar"] = self.bars(name)
        return found

    def to_dataframe(self):
        """`columns()` as a pandas.DataFrame, one row per load point. ImportError without pandas."""
        return frame_of(self.columns())

    plot_creep_curve = plot.creep_curve
    plot_pressure = plot.pressure
    plot_traction = plot.traction
    plot_path = plot.path

    def __repr__(self):
        seconds = self.seconds.get("total")
        took = "" if seconds is None else f", {seconds:.3g} s"
        return f"<rollfem.ModelResult {self.key}: {count(self.points, 'load point')}, {self.contact_elements} elements{took}>"


class Result:
    """A case and the results of its models: result["halfspace"], or result.models in the order of the run; with true
    profiles there is one for each patch of each wheel and position.

    case: the rollfem.Case. provenance: {version, commit, ...} of stored results.
    """

    def __init__(self, case, models, core=None, provenance=None, folder=""):
        self.case, self.models, self.folder = case, models, folder
        self.provenance = provenance or {}
        self._core = core

    @classmethod
    def of(cls, case, core):
        """A Result from the library's results."""
        return cls(case, [ModelResult(record) for record in _core.models_of(core)], core)

    @property
    def title(self):
        """The title of the case."""
        return self.case.title

    def __getitem__(self, key):
        """A model by its key, its name (the first one) or its number."""
        if isinstance(key, int):
            return self.models[key]
        for model in [*(m for m in self.models if m.key == key), *(m for m in self.models if m.name == key)]:
            return model
        raise KeyError(f"{key}: this result has {', '.join(model.key for model in self.models)}")

    def __iter__(self):
        return iter(self.models)

    def __len__(self):
        return len(self.models)

    @property
    def points(self):
        """Load points of the only model; ValueError if there are several results."""
        if len(self.models) != 1:
            raise ValueError(f"this result has {', '.join(model.key for model in self.models)}; do: take one, as in "
                             f"result[{self.models[0].key!r}].points" if self.models else "there is no model")
        return self.models[0].points

    def columns(self):
        """{name: array} over all models and load points, with columns model, key and point (from 0), and with true
        profiles those of the place."""
        parts = [model.columns() for model in self.models]
        names = dict.fromkeys(name for part in parts for name in part)
        found = {"model": np.repeat([m.name for m in self.models], [len(m) for m in self.models]),
                 "key": np.repeat([m.key for m in self.models], [len(m) for m in self.models]),
                 "point": np.concatenate([np.arange(len(m)) for m in self.models])}
        if any(model.place for model in self.models):
            for name in dict.fromkeys(name for m in self.models for name in m.place or {}):
                found[name] = np.repeat([(m.place or {}).get(name) for m in self.models], [len(m) for m in self.models])
        for name in names:
            found[name] = np.concatenate([part.get(name, np.full(len(m), np.nan))
                                          for part, m in zip(parts, self.models)])
        return found

    def to_dataframe(self):
        """`columns()` as a pandas.DataFrame, one row per model and load point. ImportError without pandas."""
        return frame_of(self.columns())

    def write(self, folder, report=False):
        """Writes the same folder as `rollfem run`, completely or not at all; with `report` also figures and
        report.html. Raises rollfem.InputError."""
        if self._core is None:
            raise _core.InputError(f"{folder}: this result was read from {self.folder}; do: copy that folder")
        problem = _core.write(self._core, str(folder), report)
        if problem:
            raise _core.InputError(f"{folder}: the results were written, but the report was not drawn: {problem}")
        return folder

    plot_creep_curve = plot.creep_curves

    def __repr__(self):
        models = ", ".join(f"{m.key} ({count(m.points, 'load point')})" for m in self.models[:6])
        more = f", and {len(self.models) - 6} more" if len(self.models) > 6 else ""
        return f"<rollfem.Result {self.title!r}: {models}{more}>"


def count(things, word):
    """"3 load points"."""
    return f"{len(things)} {word}{'' if len(things) == 1 else 's'}"


def _array(points, name):
    if name not in QUANTITIES:
        raise KeyError(f"{name}: not a quantity; allowed: {', '.join(QUANTITIES)}")
    values = [point.scalars.get(name) for point in points]
    return np.array([np.nan if value is None else value for value in values])


def frame_of(columns):
    """A pandas.DataFrame."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_dataframe needs pandas; do: apt install python3-pandas, or use columns(), which has the "
                          "same data as numpy arrays") from error
    return pandas.DataFrame(columns)


def stress_measures(stress):
    """Scalar measures of stresses [..., 6] in MPa: xx, yy, zz, xy, yz, xz, as in point.subsurface and point.bodies.

    A dict of arrays, MPa, tension positive:
    hydrostatic: (xx + yy + zz) / 3;
    von_mises, tresca: equivalent uniaxial stresses, the latter the difference of the outer principal stresses;
    orthogonal_shear: sqrt(xz^2 + yz^2), on the plane parallel to the surface;
    principal [..., 3]: principal stresses, the largest first.
    ValueError if the last axis does not have length six.
    """
    return _core.stress_measures(stress)


def _document():
    """Turns quantities and fields into documented attributes."""
    for name, quantity in QUANTITIES.items():
        symbol = f", {quantity.symbol}" if quantity.symbol else ""
        text = f"{quantity.title}{symbol} [{quantity.unit}]: {quantity.meaning}"
        setattr(Point, name, property(lambda self, name=name: self.scalars.get(name), doc=text))
        if name != "seconds":  # seconds of a model are per stage
            setattr(ModelResult, name, property(lambda self, name=name: self.values(name), doc=f"Over load points. {text}"))
    for name, field in FIELDS.items():
        sign = f"; {field.sign}" if field.sign else ""
        setattr(Point, name, property(lambda self, name=name: self.fields.get(name),
                                      doc=f"[ny, nx], {field.unit}: {field.description}{sign}"))


_document()
