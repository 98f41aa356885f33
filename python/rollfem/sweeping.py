# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves one case at every combination of given values."""
import itertools

import numpy as np

from . import plot
from ._core import InputError, SolveError
from .case import Case, nested
from .result import QUANTITIES, frame_of
from .solving import names_of, solve

# : Keys of [rolling] that take lists; all their combinations become load points of one solution.
CREEPAGES = ("longitudinal_creepage", "lateral_creepage", "spin")
MOST_POINTS = 1000  # of a list in a case


class Sweep:
    """Results over a grid of values: sweep.traction_coefficient, or sweep.values("...") of a model, is an array with
    one axis per key, in the given order; nan marks a missing solution.

    axes: {key: values}; results: the underlying rollfem.Results; failures: {index: reason} with skip_failures.
    """

    def __init__(self, axes, models):
        self.axes = axes
        self.results, self.failures = [], {}
        self._models = models
        self._points = {}

    @property
    def shape(self):
        """Number of values of each axis."""
        return tuple(len(values) for values in self.axes.values())

    def points(self, model=None):
        """An array of rollfem.Point; None marks a missing solution. `model`: required if there are several."""
        if model is None:
            if len(self._points) > 1:
                raise ValueError(f"this sweep has {', '.join(self._points)}; do: name one, as in values(..., model=...)")
            model = next(iter(self._points), None)
        if model not in self._points:
            raise KeyError(f"{model}: this sweep has {', '.join(self._points) or 'no result'}")
        return self._points[model]

    def values(self, name, model=None):
        """A quantity over the grid."""
        if name not in QUANTITIES:
            raise KeyError(f"{name}: not a quantity; allowed: {', '.join(QUANTITIES)}")
        return self._map(model, lambda point: point.scalars.get(name))

    def bars(self, name, model=None):
        """The error bars of a quantity over the grid, in its unit."""
        return self._map(model, lambda point: point.bar(name))

    def _map(self, model, get):
        points = self.points(model)
        found = np.full(points.shape, np.nan)
        for index, point in np.ndenumerate(points):
            value = None if point is None else get(point)
            if value is not None:
                found[index] = value
        return found

    def __getattr__(self, name):
        if name in QUANTITIES:
            return self.values(name)
        raise AttributeError(f"a sweep has no {name}")

    def columns(self, model=None):
        """{name: array} over the combinations: one column per key, then the quantities."""
        grids = np.meshgrid(*self.axes.values(), indexing="ij")
        found = {name: grid.ravel() for name, grid in zip(self.axes, grids)}
        for name in QUANTITIES:
            values = self.values(name, model).ravel()
            if not np.isnan(values).all():
                found.setdefault(name, values)
        return found

    def to_dataframe(self, model=None):
        """`columns()` as a pandas.DataFrame. ImportError without pandas."""
        return frame_of(self.columns(model))

    plot = plot.surface

    def _add(self, index, result, number):
        """Load point `number` of a result at an index of the grid."""
        for model in result:
            if model.place is not None and model.place["patches"] > 1:
                raise InputError("a wheel has several patches here, which one array cannot hold; do: solve each "
                                 "combination and read the values from its result")
            name = model.name if model.place is None else f"{model.name}_{model.place['wheel']}"
            if model.place is not None and model.place["position"] > 1:
                raise InputError("the case has several positions; do: sweep over them (lateral_shift=[...])")
            points = self._points.setdefault(name, np.full(self.shape, None, dtype=object))
            # Models without creepage have a single load point for all combinations.
            points[index] = model.points[number if len(model) > 1 else 0]

    def __repr__(self):
        grid = " x ".join(f"{name} ({len(values)})" for name, values in self.axes.items())
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<rollfem.Sweep {grid}: {', '.join(self._points)}{failed}>"


def _solve_into(sweep, case, indices, how, skip):
    """Solves the load points of a case together; if that fails and failures may be skipped, separately."""
    try:
        result = solve(case, **how)
    except SolveError as error:
        if not skip:
            raise
        if len(indices) == 1:
            sweep.failures[indices[0]] = str(error)
            return
        rolling = case.data["rolling"]
        for number, index in enumerate(indices):
            one = {name: [rolling[name][number]] for name in CREEPAGES if isinstance(rolling.get(name), list)}
            _solve_into(sweep, case.with_(rolling=one), [index], how, skip)
        return
    sweep.results.append(result)
    for number, index in enumerate(indices):
        sweep._add(index, result, number)


def sweep(case, axes=None, /, *, model=None, models=None, progress=None, skip_failures=False, **keys):
    """Solves a case at every combination of values and returns a rollfem.Sweep.

    sweep(case, longitudinal_creepage=[...], spin=[...]), sweep(case, {"friction.coefficient": [0.3, 0.5]}), sweep(case,
    friction__coefficient=[0.3, 0.5]). Creepages become load points of one solution, which is cheapest; other keys need
    one solution per combination. skip_failures: combinations without a solution are nan and listed in `failures`;
    otherwise the first failure raises rollfem.SolveError.
    """
    case = case if isinstance(case, Case) else Case(case)
    asked = {name: [v for v in np.atleast_1d(np.asarray(values, dtype=object)).tolist()]
             for name, values in {**(axes or {}), **keys}.items()}
    if not asked or not all(asked.values()):
        raise InputError("a sweep needs at least one key and its values, as in spin=[0.0, 1e-4]")
    names = list(asked)
    paths = {name: _path(name) for name in names}
    inner = [name for name in names if paths[name][0] == "rolling" and paths[name][-1] in CREEPAGES]
    outer = [name for name in names if name not in inner]
    found = Sweep({name: np.array(values) for name, values in asked.items()}, models)
    how = {"models": names_of(model, models), "progress": progress}
    numbers = {name: range(len(asked[name])) for name in names}
    for fixed in itertools.product(*(numbers[name] for name in outer)):
        at = case.with_({name: asked[name][k] for name, k in zip(outer, fixed)}) if outer else case
        combinations = list(itertools.product(*(numbers[name] for name in inner)))
        for begin in range(0, len(combinations), MOST_POINTS):
            part = combinations[begin:begin + MOST_POINTS]
            lists = {name: [asked[name][c[k]] for c in part] for k, name in enumerate(inner)}
            indices = [tuple({**dict(zip(outer, fixed)), **dict(zip(inner, c))}[name] for name in names) for c in part]
            _solve_into(found, at.with_(lists) if inner else at, indices, how, skip_failures)
    return found


def _path(name):
    """Section and key of a name."""
    at, path = nested({name: 0}), []
    while isinstance(at, dict):
        path.append(next(iter(at)))
        at = at[path[-1]]
    return path


