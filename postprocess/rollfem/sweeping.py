# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves one case at every combination of given values."""
import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Annotated, Any

import numpy as np

from . import plot
from ._core import Progress
from .case import CREEPAGES, Case, CaseLike, nested, refuse_unused
from .errors import InputError, SolveError
from .frames import Labelled, OverAxes, documented, html_table
from .point import QUANTITIES, Point, columns_of, known
from .result import Result
from .solving import Models, Told, names_of, solve

MOST_POINTS = 1000  # of a list in a case
Index = tuple[int, ...]


@documented
class Sweep(OverAxes):
    """Results over a grid of values: sweep.traction_coefficient, or sweep.values("...") of a model, is an array with one
    axis for each key, in their order; nan where there is no solution.

    Where a wheel has several patches, forces along the rolling direction, forces in the track frame (vertical_force,
    lateral_force_track), normal forces (each along its own normal), areas and energies are sums over them,
    traction_coefficient is -sum F_x / sum F_n, largest values are those of all, forces in the patches' own frames
    (lateral_force, lateral_pressure, spin_moment) nan, and all else is of the most loaded patch. `patches` has each by
    itself.
    """

    axes: Annotated[dict[str, np.ndarray], "the values of each key; load points that the case itself lists are the last axis: "
                    "a creepage, or point_index (from 0)"]
    results: Annotated[list[Result], "behind the numbers"]
    failures: Annotated[dict[Index, str], "why there is no solution, with skip_failures"]

    def __init__(self, axes: dict[str, np.ndarray], results: Sequence[Result] = (), indices: Sequence[Sequence[Index]] = (),
                 failures: Mapping[Index, str] | None = None) -> None:
        """`indices`: of the load points of every result."""
        self.axes = axes
        self.results, self.failures = [], dict(failures or {})
        self._patches: dict[str, np.ndarray] = {}
        self._indices: list[Sequence[Index]] = []
        for result, at in zip(results, indices):
            self._add(result, at)

    def __reduce__(self) -> tuple[Any, ...]:
        return Sweep, (self.axes, self.results, self._indices, self.failures)

    def patches(self, model: str | None = None) -> np.ndarray:
        """The load points of every patch.

        Args:
            model: Which of several; with true profiles and both wheels "halfspace_left", say.
        Returns:
            Lists of Point over the grid, the most loaded patch first; Point.place says where each is. Empty lists where
            there is no solution.
        Raises:
            KeyError: There is no such model.
            ValueError: There are several, and none is named.

        >>> [point.normal_force for point in sweep.patches()[0]]
        """
        if model is None:
            if len(self._patches) > 1:
                raise ValueError(f"this sweep has {', '.join(self._patches)}; do: name one, as in values(..., model=...)")
            model = next(iter(self._patches), None)
        if model is None or model not in self._patches:
            raise KeyError(f"{model}: this sweep has {', '.join(self._patches) or 'no result'}")
        return self._patches[model]

    def points(self, model: str | None = None) -> np.ndarray:
        """The load points of the most loaded patches.

        Args:
            model: As of `patches`.
        Returns:
            A Point at every place of the grid, None where there is no solution.

        >>> sweep.points()[0].pressure
        """
        return self._map(model, lambda patches: patches[0] if patches else None, object)

    def values(self, name: str, model: str | None = None) -> np.ndarray:
        """A quantity over the grid.

        Args:
            name: One of rollfem.QUANTITIES.
            model: As of `patches`.
        Returns:
            In the unit of the quantity; nan where there is none.
        Raises:
            KeyError: There is no such quantity or model.

        >>> sweep.values("longitudinal_force", model="fastsim")
        """
        known(name, QUANTITIES)
        return self._map(model, lambda patches: whole(name, patches, lambda point, what: point.scalars.get(what)))

    def bars(self, name: str, model: str | None = None) -> np.ndarray:
        """Error bars of a quantity over the grid; of a sum, the sum of the bars.

        Args:
            name, model: As of `values`.
        Returns:
            In the unit of the quantity; nan where there are none.
        Raises:
            KeyError: There is no such quantity or model.

        >>> sweep.bars("longitudinal_force")
        """
        known(name, QUANTITIES)
        return self._map(model, lambda patches: bar_of(name, patches))

    def _map(self, model: str | None, get: Callable[[list[Point]], Any], kind: type = float) -> np.ndarray:
        patches = self.patches(model)
        found: np.ndarray = np.full(patches.shape, np.nan if kind is float else None, dtype=kind)
        for index, each in np.ndenumerate(patches):
            value = get(each)
            if value is not None:
                found[index] = value
        return found

    def __getattr__(self, name: str) -> np.ndarray:
        if name in QUANTITIES:
            return self.values(name)
        raise AttributeError(f"a sweep has no {name}")

    def columns(self, model: str | None = None) -> dict[str, np.ndarray]:
        """All numbers over the combinations.

        Args:
            model: As of `patches`.
        Returns:
            Arrays by name: a column for each key, then the quantities, with NAME_bar beside those that have error bars.

        >>> sweep.columns()["spin"]
        """
        axes = self._places()
        return {**axes, **columns_of(lambda name: self.values(name, model), lambda name: self.bars(name, model), axes)}

    def _labelled(self, model: str | None = None) -> Labelled:
        return self._over_axes(self.columns(model), lambda name: str(QUANTITIES[name.removesuffix("_bar")].unit),
                               {"model": model or next(iter(self._patches))})

    plot = plot.surface

    def _add(self, result: Result, indices: Sequence[Index]) -> None:
        """A result, whose load points have these indices in the grid."""
        self.results.append(result)
        self._indices.append(indices)
        for model in result:
            if model.place is not None and model.place["position"] > 1:
                raise InputError("the case has several positions; do: sweep over them (lateral_shift=[...])")
            name = model.name if model.place is None else f"{model.name}_{model.place['wheel']}"
            if name not in self._patches:
                self._patches[name] = np.frompyfunc(lambda _: [], 1, 1)(np.empty(self.shape))
            for number, index in enumerate(indices):
                # What knows no creepage has one load point for all of them.
                self._patches[name][index].append(model.points[number if len(model) > 1 else 0])

    def __repr__(self) -> str:
        grid = " x ".join(f"{name} ({len(values)})" for name, values in self.axes.items())
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<rollfem.Sweep {grid}: {', '.join(self._patches)}{failed}>"

    def _repr_html_(self) -> str:
        heads = [*self.axes, "model", "traction_coefficient", "max_pressure"]
        return html_table(repr(self), heads, (row for model in self._patches for row in zip(
            *self._places().values(), itertools.repeat(model), *(self.values(name, model).ravel() for name in heads[-2:]))))


def _lists(case: Case, without: Sequence[str] = ()) -> dict[str, list[Any]]:
    """What the case lists over its load points, {"rolling.spin": [...]}, less some creepages."""
    found = {f"rolling.{name}": values for name, values in case.data.get("rolling", {}).items()}
    found["wheelset.rotation_change"] = case.data.get("wheelset", {}).get("rotation_change")
    return {key: values for key, values in found.items() if isinstance(values, list) and key not in without}


def _solve_into(sweep: Sweep, case: Case, indices: Sequence[Index], how: Mapping[str, Any], skip: bool) -> None:
    """Solves the load points of a case; if that fails and failures may be skipped, each separately."""
    try:
        result = solve(case, **how)
    except SolveError as error:
        if not skip:
            raise
        lists = _lists(case)
        if len(indices) == 1 or not _separate(case):
            sweep.failures.update((index, str(error)) for index in indices)
            return
        for number, index in enumerate(indices):
            _solve_into(sweep, case.with_({name: values[number] for name, values in lists.items()}), [index], how, skip)
        return
    sweep._add(result, indices)


def _separate(case: Case) -> bool:
    """Whether load points do not depend on each other."""
    return case.data.get("rolling", {}).get("problem", "steady") in ("steady", "frictionless")


def sweep(case: CaseLike, axes: Mapping[str, Any] | None = None, /, *, model: str | None = None, models: Models = None,
          progress: Told = None, skip_failures: bool = False, **keys: Any) -> Sweep:
    """Solves a case at every combination of values.

    Creepages are load points of one solution, which costs least; all other keys take a solution for each combination.
    Load points that the case lists itself are the last axis.

    Args:
        axes: {"friction.coefficient": [0.3, 0.5]}.
        case, model, models: As of `solve`.
        progress: As of `solve`; point and points count the combinations.
        skip_failures: Combinations without a solution are nan and listed in `failures`; otherwise the first raises.
        **keys: Keys and their values as of `Case.with_`: longitudinal_creepage=[...], friction__coefficient=[0.3, 0.5].
    Raises:
        InputError: A key or value is wrong.
        SolveError: A combination has no solution.

    >>> sweep = rollfem.sweep(case, longitudinal_creepage=[0.0, 0.001], spin=[0.0, 1e-4])
    >>> sweep.traction_coefficient.shape
    (2, 2)
    """
    case = case if isinstance(case, Case) else Case(case)
    asked = {name: list(np.atleast_1d(np.asarray(values, dtype=object)).tolist())
             for name, values in {**(axes or {}), **keys}.items()}
    if not asked or not all(asked.values()):
        raise InputError("a sweep needs at least one key and its values, as in spin=[0.0, 1e-4]")
    values = {_key(case, name, given[0]): given for name, given in asked.items()}
    if len(values) < len(asked):
        raise InputError(f"{', '.join(asked)}: two of these are the same key; do: give it once")
    inner = [key for key in values if _separate(case) and key in {f"rolling.{each}" for each in CREEPAGES}]
    outer = [key for key in values if key not in inner]
    first = case.with_({key: values[key][0] for key in outer}) if outer else case
    own_lists, own_count, own_axis = _own_points(first, inner)
    found = Sweep({**{name: np.array(given) for name, given in asked.items()}, **own_axis})
    how = {"models": names_of(model, models) or None}
    count, done = math.prod(found.shape), 0
    for fixed in _combinations(values, outer):
        at = case.with_({key: values[key][k] for key, k in fixed.items()}) if outer else case
        points = [(numbers, own) for numbers in _combinations(values, inner) for own in range(own_count)]
        most = MOST_POINTS if inner else len(points)
        for part in (points[begin:begin + most] for begin in range(0, len(points), most)):
            lists = {key: [values[key][numbers[key]] for numbers, _ in part] for key in inner}
            lists.update((key, [listed[own] for _, own in part]) for key, listed in own_lists.items())
            indices = [tuple({**fixed, **numbers}[key] for key in values) + (own,) * len(own_axis) for numbers, own in part]
            told = None if progress is None else _of_sweep(progress, done, count)
            _solve_into(found, at.with_(lists) if inner else at, indices, {**how, "progress": told}, skip_failures)
            done += len(part)
    return found


def _of_sweep(progress: Callable[[Progress], object], done: int, count: int) -> Callable[[Progress], object]:
    """Tells of the combinations of a sweep in place of the load points of one solution."""
    def tell(event: Progress) -> object:
        event.point, event.points = min(done + event.point, count), count
        return progress(event)

    return tell


def _combinations(values: Mapping[str, Sequence[Any]], keys: Sequence[str]) -> Iterator[dict[str, int]]:
    """Every combination of the values of some keys, by their numbers."""
    for numbers in itertools.product(*(range(len(values[key])) for key in keys)):
        yield dict(zip(keys, numbers))


def _own_points(case: Case, swept: Sequence[str]) -> tuple[dict[str, list[Any]], int, dict[str, np.ndarray]]:
    """Load points that the case lists beside the keys that are swept: its lists, their number, their axis."""
    lists = _lists(case, swept)
    count = max(map(len, lists.values()), default=1) if _separate(case) else case.load_points
    if count < 2:
        return lists, 1, {}
    if len(lists) == 1 and _separate(case):
        return lists, count, {name.split(".")[1]: np.array(values) for name, values in lists.items()}
    return lists, count, {"point_index": np.arange(count)}


def _key(case: Case, name: str, value: Any) -> str:
    """The key "section.name" that a name stands for, which solving uses."""
    at: Any = nested({name: value}, case.data, "sweep")
    refuse_unused(at, case.data, "sweep")
    if isinstance(value, dict):
        return name.replace("__", ".")
    path = []
    while isinstance(at, dict):
        path.append(next(iter(at)))
        at = at[path[-1]]
    return ".".join(path)


#: Of a wheel with several patches: sums, and those that have no sum as each patch has a frame of its own.
SUMS = ("normal_force", "longitudinal_force", "vertical_force", "lateral_force_track", "contact_area", "adhesion_area",
        "patch_count", "elastic_energy", "frictional_work", "creepage_work", "revolution_work", "iterations", "seconds")
#: Of the patch with the largest work.
PLACES = ("pass_work_y_wheel", "pass_work_y_rail")
OWN_FRAME = ("lateral_force", "lateral_pressure", "spin_moment")


def whole(name: str, patches: Sequence[Point], get: Callable[[Point, str], Any]) -> Any:
    """A number of a wheel from those of its patches; None where there is none."""
    if len(patches) < 2:
        return get(patches[0], name) if patches else None
    if name in OWN_FRAME:
        return None
    if name in PLACES:
        return get(max(patches, key=lambda point: get(point, "max_pass_work") or 0.0), name)
    if name == "traction_coefficient":
        forces = [[get(point, each) for point in patches] for each in ("longitudinal_force", "normal_force")]
        return None if None in forces[0] or not sum(forces[1]) else -sum(forces[0]) / sum(forces[1])
    values = [get(point, name) for point in patches]
    if name in SUMS:
        return None if None in values else sum(values)
    known = [value for value in values if value is not None]
    if name.startswith("max_") or name == "residual":
        return max(known, default=None)
    return min(known, default=None) if name == "converged" else values[0]


def bar_of(name: str, patches: Sequence[Point]) -> float | None:
    if len(patches) > 1 and name == "traction_coefficient":
        bars = [point.bar("longitudinal_force") for point in patches]
        known = [bar for bar in bars if bar is not None]
        return sum(known) / sum(point.normal_force for point in patches) if len(known) == len(bars) else None
    if len(patches) > 1 and name.startswith("max_"):
        return max(patches, key=lambda point: point.scalars.get(name) or 0.0).bar(name)
    found: float | None = whole(name, patches, lambda point, what: point.bar(what))
    return found
