# SPDX-License-Identifier: LGPL-2.1-or-later
"""A refinement study as a record: values per level, their errors against a reference, observed orders and limits; as the
files and the text of `rollfem study` (docs/commands.md). Convergence of a sequence of values on successively finer levels: the
observed order, Richardson's limit and the reliability of both. P. J. Roache, Verification and Validation in Computational
Science and Engineering (1998); L. Eca, M. Hoekstra, J. Comput. Phys. 262 (2014), for sequences without an order."""
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..files import cell, quoted, sealed_json
from ..point import QUANTITIES, Quantity


# Range of plausible orders; outside it changes fall too slowly or vanish by coincidence.
LEAST_ORDER, LARGEST_ORDER = 0.5, 6.0
FORMAL_ORDER = 2.0  # of the methods here
LARGEST_FITTED_ORDER = FORMAL_ORDER + 0.5
SAFETY = 1.25  # Roache's factor for three levels
SAFETY_BLIND = 3.0  # Eca and Hoekstra's factor without an order
ROUNDING = 1e-12  # relative; smaller changes are rounding
FEWEST_TO_FIT = 4
SPREAD_SAFETY = 1.5  # factor of the spread of a few extrapolated values
MOST_SCATTER = 0.2  # relative to the mean change between levels


@dataclass
class Limit:
    """f(h) = limit + C h^p from the three finest values; if these show no order, a least-squares fit to all values, provided
    there are at least four and they follow such a curve."""

    value: float  #: Richardson's if there is an order; otherwise the finest
    #: Absolute. If the last three values and the three before show orders of at most 2.5: 1.5 times the spread of the values
    #: extrapolated from both triples and from the last two values with either order, at least a fourth of the distance to the
    #: finest value. With three values: that of the finest. With a fitted order, after Eca and Hoekstra: 1.25 times the
    #: distance to the finest value, plus the scatter about the curve and the finest value's distance from it. Without an
    #: order: three times the largest change. Never below the noise.
    uncertainty: float
    #: Absolute: Roache's grid convergence index with factor 1.25 and an order of at most 2. Changes that fall faster than
    #: order 2.5 do so by coincidence: then the last change counts as at least half of the previous one, with order 1.
    uncertainty_of_finest: float
    order: float | None = None  #: None if neither three values nor the fit give one
    fitted: bool = False  #: to all values
    settled: bool = False  #: the last changes are rounding or solver tolerance
    reason: str = ""  #: why the last three values show no order


def _order_of_three(values: Sequence[float], ratio: float) -> float | str:
    """The order of three values, or why they show none."""
    coarse, middle, fine = values
    before, now = middle - coarse, fine - middle
    if abs(now) <= ROUNDING * max(abs(fine), abs(coarse)):
        return "the last two values are the same"
    if before * now <= 0:
        return "the sequence is not monotone"
    if abs(now) >= abs(before):
        return "its changes do not decrease"
    order = math.log(before / now) / math.log(ratio)
    if order < LEAST_ORDER:
        return f"its changes decrease too slowly (order {order:.2f})"
    if order > LARGEST_ORDER:
        return f"its changes decrease too fast for the method (order {order:.1f}), which is coincidence"
    return order


def _richardson(middle: float, fine: float, ratio: float, order: float) -> float:
    return fine + (fine - middle) / float(ratio**order - 1)


def _fit_all(values: np.ndarray, ratio: float, limit: Limit) -> None:
    """Sets order, value and uncertainties from all values if a curve limit + C ratio^(-order k) with a plausible order fits
    them with little scatter; finer levels have weights 1/h."""
    count = len(values)
    if count < FEWEST_TO_FIT:
        return
    level = np.arange(count)
    weight = ratio**level / (ratio**level).sum()
    orders = LEAST_ORDER + 0.01 * np.arange(round((LARGEST_FITTED_ORDER - LEAST_ORDER) / 0.01) + 1)[:, None]
    x = ratio ** (-orders * level)
    off = x - (weight * x).sum(axis=1, keepdims=True)
    slope = (weight * off * values).sum(axis=1, keepdims=True) / (weight * off * x).sum(axis=1, keepdims=True)
    limits = (weight * (values - slope * x)).sum(axis=1, keepdims=True)
    residuals = values - limits - slope * x
    squares = (weight * residuals**2).sum(axis=1)
    best = int(squares.argmin())
    if best in (0, len(orders) - 1):  # the best order lies beyond the range
        return
    scatter = math.sqrt(count * squares[best] / (count - 3))
    if scatter > MOST_SCATTER * float(np.ptp(values)) / (count - 1):
        return
    limit.order, limit.fitted, limit.value = float(orders[best, 0]), True, float(limits[best, 0])
    limit.uncertainty = limit.uncertainty_of_finest = float(
        SAFETY * abs(values[-1] - limit.value) + scatter + abs(residuals[best, -1]))


def _extrapolate(values: Sequence[float], ratio: float, order: float, limit: Limit) -> None:
    """Extrapolates from the last three values, which show an order."""
    finest, now = values[-1], values[-1] - values[-2]
    limit.order, limit.value = order, _richardson(values[-2], finest, ratio, order)
    if order > LARGEST_FITTED_ORDER:  # faster than the method: coincidence, and so is the extrapolation
        believed = max(abs(now), abs(values[-2] - values[-3]) / ratio)
        limit.uncertainty = limit.uncertainty_of_finest = SAFETY * believed / (ratio - 1)
        return

    def to_limit(other: float) -> float:
        return now / float(ratio ** min(other, FORMAL_ORDER) - 1)

    limit.uncertainty = limit.uncertainty_of_finest = SAFETY * abs(to_limit(order))
    if len(values) == 3:
        return
    earlier = _order_of_three(values[-4:-1], ratio)
    if isinstance(earlier, str) or earlier > LARGEST_FITTED_ORDER:
        return
    others = (_richardson(values[-3], values[-2], ratio, earlier), finest + to_limit(earlier), finest + to_limit(order))
    spread = max(abs(other - limit.value) for other in others)
    limit.uncertainty = max(SPREAD_SAFETY * spread, 0.25 * abs(limit.value - finest))


def limit_of(values: Sequence[float], ratio: float, noise: float = 0.0) -> Limit:
    """The limit of values, coarsest first, each on cells smaller by `ratio` > 1 than the previous one; at least two (two
    give no order). `noise`: absolute uncertainty of a value from its solver; changes below it or below rounding count as
    zero."""
    if len(values) < 2 or not ratio > 1:
        raise AssertionError("a limit needs two levels and a ratio > 1")
    floor = max(noise, ROUNDING * max(abs(values[-1]), abs(values[0])))
    change = float(np.abs(np.diff(values[-3:])).max())
    blind = max(floor, SAFETY_BLIND * change)
    limit = Limit(values[-1], blind, blind, settled=change <= floor)
    if limit.settled:
        limit.reason = "converged to rounding"
    elif len(values) == 2:
        limit.reason = "two levels cannot show an order"
    else:
        if isinstance(last := _order_of_three(values[-3:], ratio), str):
            limit.reason = last
            _fit_all(np.array(values), ratio, limit)
        else:
            _extrapolate(values, ratio, last, limit)
        limit.uncertainty = max(limit.uncertainty, floor)
        limit.uncertainty_of_finest = max(limit.uncertainty_of_finest, floor)
    return limit


def order_of_errors(coarse: float, fine: float, ratio: float) -> float | None:
    """Order from two errors on cells that differ by `ratio`; None if one of them is 0."""
    return math.log(abs(coarse / fine)) / math.log(ratio) if coarse and fine else None


#: Values by key: "max_pressure", "semi_axis_x", "semi_axis_y" (of true profiles "contact_length", "contact_width"),
#: "approach" of the first load point, "traction_coefficient:4" of the fourth.
Values = Mapping[str, float]
RULES = ("exact", "finest", "extrapolated")


@dataclass
class Level:
    """A solved level."""

    label: str  #: "40 across", "0.47 mm"
    parameter: float  #: the varied quantity as a number
    unknowns: int = 0
    contact_elements: int = 0
    seconds: float = 0.0  #: wall time, error estimates included
    values: Values = field(default_factory=dict)
    bars: Values = field(default_factory=dict)  #: the model's own error bars, absolute
    no_bars: dict[str, str] = field(default_factory=dict)  #: why a value has none
    noise: float = 0.0  #: relative tolerance reached by its solver
    shared: float = 0.0  #: seconds for what the first level prepares for all


@dataclass
class Reference:
    """What the errors of the levels of a series refer to: a property of its own model."""

    value: float = 0.0
    uncertainty: float = 0.0  #: absolute; 0: exact or given
    kind: str = ""  #: "exact", "given", "extrapolated", "finer level", "finest"


@dataclass
class Series:
    """One model, refined in one way."""

    model: str
    vary: str = ""  #: "grid", "cell", "degree", "domain", "grid and domain"; "" one level
    parameter: str = ""  #: "elements across", "FE cell in mm"
    ratio: float = 0.0  #: by which cells shrink (domains grow) from level to level; 0 if not meaningful
    measures_others: bool = False  #: models differ from it, if it has three levels
    limit_of_its_own: bool = False  #: finite bodies do not tend to the closed form
    levels: list[Level] = field(default_factory=list)  #: coarsest first
    reference: Level | None = None  #: finer than the finest level: only where the levels' errors need it
    no_reference: str = ""  #: why there is none although they need it
    failure: str = ""  #: why levels failed
    left_out: str = ""  #: coarse levels that do not fit the case, and why

    @property
    def name(self) -> str:
        return self.model + (f" ({self.vary})" if self.vary else "")

    def keys(self) -> list[str]:
        return sorted({key for level in self.levels for key in level.values})

    def values(self, key: str) -> list[float]:
        """Of the levels that have the key."""
        return [level.values[key] for level in self.levels if key in level.values]

    def limit(self, key: str) -> Limit | None:
        """From the levels and the reference; None with fewer than two or without a ratio."""
        levels = [level for level in (*self.levels, self.reference) if level and key in level.values]
        if len(levels) < 2 or not self.ratio > 1:
            return None
        values = [level.values[key] for level in levels]
        return limit_of(values, self.ratio, levels[-1].noise * abs(values[-1]))

    def own_limit(self, key: str, finest: bool) -> Reference:
        """The limit of the series; of a single level its value."""
        limit = self.limit(key)
        if limit and limit.order is not None and not finest:
            return Reference(limit.value, limit.uncertainty, "extrapolated")
        if limit and self.reference and key in self.reference.values:
            return Reference(self.reference.values[key], limit.uncertainty_of_finest, "finer level")
        return Reference(self.values(key)[-1], limit.uncertainty_of_finest if limit else 0.0, "finest")


@dataclass
class Place:
    """The study of one contact: of a case with radii, or of one patch of true profiles. Each has its own limits."""

    creepages: Sequence[Sequence[float]]  #: of the load points
    exact: Values = field(default_factory=dict)  #: Hertz's values, if they are valid
    key: str = ""  #: "left_3_1"; empty with radii
    name: str = ""  #: "left wheel, position 3, patch 1 of 2"
    at: Mapping[str, Any] | None = None  #: of a patch
    given: dict[str, float] = field(default_factory=dict)  #: by the user; take precedence
    series: list[Series] = field(default_factory=list)

    @property
    def base(self) -> Series:
        """From which other models differ: the half-space refined in its grid, otherwise the first with three levels,
        otherwise the first."""
        def rank(series: Series) -> int:
            return (1 + (len(series.levels) >= 3) * (1 + series.measures_others)) if series.levels else 0
        return max(self.series, key=rank)


def is_stress(name: str) -> bool:
    """Whether it is the largest stress of a body, as "max_von_mises_rail"."""
    return name not in QUANTITIES and re.fullmatch(r"max_\w+_(wheel|rail)", name) is not None


def described(name: str) -> Quantity:
    """What a quantity is."""
    if not is_stress(name):
        return QUANTITIES[name]
    measure, _, body = name[4:].rpartition("_")
    return Quantity(f"largest {measure.replace('_', ' ')} stress in the {body}", "", "MPa", percent_of="value")


def is_coefficient(key: str) -> bool:
    """Whether the key is a traction coefficient, whose errors are relative to the coefficient of friction."""
    return key.startswith("traction_coefficient")


def percent_of(key: str) -> str:
    """Reference of percentage errors of the key."""
    return "mu" if is_coefficient(key) else "value"


def percent(key: str, error: float) -> str:
    """"0.27 %" of the reference's value, "0.27 % of mu"."""
    return f"{100 * error:.2g} %{' of mu' * is_coefficient(key)}"


@dataclass
class Record:
    """All of a study."""

    head: Mapping[str, Any]  #: program, host, started, ...
    title: str
    case_file: str
    case_text: str
    friction: float
    rule: str = ""  #: one of RULES; otherwise exact if there is such a value, otherwise extrapolated
    notes: list[str] = field(default_factory=list)  #: on all places
    places: list[Place] = field(default_factory=list)

    def references(self, place: Place, series: Series) -> dict[str, Reference]:
        """Of all keys of a series: unless a value is given or exact for it, its own limit."""
        take_exact = self.rule == "exact" or not self.rule and not series.limit_of_its_own
        found = {}
        for key in series.keys():
            if key in place.given:
                found[key] = Reference(place.given[key], 0.0, "given")
            elif take_exact and key in place.exact:
                found[key] = Reference(place.exact[key], 0.0, "exact")
            elif self.rule != "exact":
                found[key] = series.own_limit(key, self.rule == "finest")
        return found

    def ends_in_itself(self, place: Place, series: Series) -> bool:
        """Whether the finest level is the reference of a quantity that still changes."""
        return any(reference.kind == "finest" and not ((limit := series.limit(key)) and limit.settled)
                   for key, reference in self.references(place, series).items())

    def differences(self, place: Place, series: Series) -> dict[str, tuple[float, float]]:
        """The limits of a model less those of `Place.base`, and the uncertainty of both: relative to the latter, for
        coefficients to that of friction. Effects of the theory, not of the grid; empty for series of the same model."""
        if series.model == place.base.model:
            return {}
        found, of_base = {}, self.references(place, place.base)
        # Without creepage half-spaces have no force, and so no entry.
        none = any(map(is_coefficient, of_base))
        for key in series.keys():
            if key not in of_base and not (is_coefficient(key) and none):
                continue
            own, of = series.own_limit(key, self.rule == "finest"), of_base.get(key, Reference())
            if (scale := self.friction if is_coefficient(key) else abs(of.value)) > 0:
                found[key] = ((own.value - of.value) / scale, (own.uncertainty + of.uncertainty) / scale)
        return found

    def error(self, key: str, value: float, reference: Reference) -> float:
        """|value - reference| relative to the reference, for coefficients relative to the coefficient of friction."""
        scale = self.friction if is_coefficient(key) else abs(reference.value)
        return abs(value - reference.value) / scale if scale > 0 else abs(value)

    def orders(self, series: Series, key: str, reference: Reference) -> list[float | None]:
        """At the levels of a series with the key: from the errors of a level and the previous one if the reference is exact
        or given, otherwise from the last three values, because an extrapolated reference would reproduce its own order."""
        values = series.values(key)
        found: list[float | None] = [None] * len(values)
        for k in range(1, len(values) if series.ratio > 1 else 0):
            if reference.kind in ("exact", "given"):
                coarse, fine = (self.error(key, value, reference) for value in values[k - 1:k + 1])
                found[k] = order_of_errors(coarse, fine, series.ratio)
            elif k >= 2:
                found[k] = limit_of(values[k - 2:k + 1], series.ratio).order
        return found

    def each_series(self) -> Iterator[tuple[Place, Series]]:
        return ((place, series) for place in self.places for series in place.series)


SMALLEST = 1e-9  # smaller errors are rounding


def _words(errors: Mapping[str, float]) -> str:
    """"p0 0.27 %, -F_x/F_z 0.5 % of mu": the largest errors."""
    kinds: tuple[tuple[str, str, Callable[[str], bool]], ...] = (
        ("p0", "max_pressure", lambda key: key == "max_pressure"), ("-F_x/F_z", "traction_coefficient", is_coefficient),
        ("creepage", "longitudinal_creepage", lambda key: "_creepage:" in key))
    largest = [(name, of, max((abs(error) for key, error in errors.items() if belongs(key)), default=0.0))
               for name, of, belongs in kinds]
    return ", ".join(f"{name} {percent(of, error)}" for name, of, error in largest if error > SMALLEST)


def verdict(record: Record) -> str:
    """One line: errors of the finest levels, and the number of sequences of levels that show an order."""
    errors: dict[str, dict[str, float]] = {}
    differences: dict[str, dict[str, float]] = {}
    limits: list[Limit] = []

    def gather(into: dict[str, float], key: str, error: float) -> None:
        into[key] = max(into.get(key, 0.0), abs(error))

    for place, series in record.each_series():
        own, other = errors.setdefault(series.name, {}), differences.setdefault(series.name, {})
        for key, reference in record.references(place, series).items():
            limits += filter(None, [series.limit(key)])
            if reference.kind != "finest":
                gather(own, key, record.error(key, series.values(key)[-1], reference))
        for key, (difference, _) in record.differences(place, series).items():
            gather(other, key, difference)

    def listed(beginning: str, of: Mapping[str, Mapping[str, float]]) -> str:
        text = "; ".join(f"{name} {words}" for name, found in of.items() if (words := _words(found)))
        return f"{beginning}: {text}. " if text else ""

    fitted = sum(limit.fitted for limit in limits)
    shown = sum(limit.order is not None for limit in limits) - fitted
    return (listed("Finest levels against their references", errors)
            + listed(f"Model differences from {record.places[0].base.model}", differences)
            + f"Of {len(limits)} sequences of levels {shown} show an order"
            + (f" and {fitted} a fitted one." if fitted else "."))


def _name_of(place: Place, key: str) -> str:
    name, _, point = key.partition(":")
    if not point:
        return described(name).title
    if not is_coefficient(key):
        return f"{QUANTITIES[name].title} {'found at' if name.endswith('creepage') else 'of'} load point {point}"
    creepage = place.creepages[int(point) - 1]
    again = f", load point {point}" if place.creepages.count(creepage) > 1 else ""
    return f"traction coefficient at xi = {100 * creepage[0]:.4g} %{again}"


def _limit_line(limit: Limit | None) -> str:
    if limit is None:
        return ""
    value = f"    limit {limit.value:.7g} +- {limit.uncertainty:.2g}, order "
    if limit.fitted:
        return f"{value}{limit.order:.2f} fitted to all levels (of the last three {limit.reason})\n"
    if limit.order is not None:
        chance = " (partly coincidence: the method is of order 2)" if limit.order > 2.5 else ""
        return f"{value}{limit.order:.2f} from the last three levels{chance}\n"
    if limit.settled:
        return f"    converged to rounding: finest value +- {limit.uncertainty_of_finest:.2g}\n"
    return f"    finest value +- {limit.uncertainty_of_finest:.2g}; no order can be claimed: {limit.reason}\n"


def _key_table(record: Record, place: Place, series: Series, key: str, reference: Reference) -> str:
    unit = described(key.partition(":")[0]).unit
    unit = f" {unit}" if unit != "-" else ""
    # Labels of quantities refined together are long.
    width = max(len(text) for text in (series.parameter, *(level.label for level in series.levels)))
    finer = series.reference if reference.kind == "finer level" else None
    lines = [f"  {_name_of(place, key)}, reference {reference.value:.7g}{unit} ({finer.label if finer else reference.kind})",
             f"    {series.parameter:<{width}}{'unknowns':>10}{'seconds':>10}{'value':>14}{'bar':>14}{'error':>16}{'order':>8}"]
    levels = [level for level in series.levels if key in level.values]
    for level, order in zip([*levels, *([finer] if finer else [])], [*record.orders(series, key, reference), None]):
        own = level is finer or level is levels[-1] and reference.kind == "finest"
        value, bar = level.values[key], level.bars.get(key)
        error = "reference" if own else percent(key, record.error(key, value, reference))
        lines.append(f"    {level.label:<{width}}{level.unknowns:>10}{level.seconds:>10.3g}{value:>14.7g}"
                     f"{level.no_bars.get(key, '') if bar is None else f'+- {bar:.2g}':>14}{error:>16}{'' if order is None else f'{order:.2f}':>8}")
    return "\n".join(lines) + "\n" + _limit_line(series.limit(key))


def table(record: Record) -> str:
    """Text for the terminal: a table for each series of each place, and the verdict."""
    text = ""
    for place, series in record.each_series():
        differences = record.differences(place, series)
        text += f"{place.name}{': ' * bool(place.name)}{series.model}{f', refined in {series.vary}' * bool(series.vary)}\n"
        text += f"  too coarse: {series.left_out}\n" if series.left_out else ""
        text += f"  levels without a result: {series.failure}\n" if series.failure else ""
        text += f"  no finer level as a reference: {series.no_reference}\n" if series.no_reference else ""
        for key, reference in record.references(place, series).items():
            text += _key_table(record, place, series, key, reference)
            if key in differences:
                value, uncertainty = differences[key]
                text += (f"    model difference from {place.base.model}: {'-' if value < 0 else '+'}{percent(key, abs(value))} "
                         f"+- {100 * uncertainty:.2g}\n")
    return f"{text}\n{verdict(record)}\n"


def _limit_data(limit: Limit) -> dict[str, Any]:
    order: dict[str, Any] = {"order": limit.order, "fitted": limit.fitted}
    if limit.order is None:
        order = {"no_order_because": limit.reason}
    return {**order, "settled": limit.settled, "value": limit.value, "uncertainty": limit.uncertainty,
            "uncertainty_of_finest": limit.uncertainty_of_finest}


def _references_data(references: Mapping[str, Reference]) -> dict[str, Any]:
    return {key: {**vars(reference), "relative_to": percent_of(key)} for key, reference in references.items()}


def _series_data(record: Record, place: Place, series: Series) -> dict[str, Any]:
    references = record.references(place, series)
    limits = {key: _limit_data(limit) for key in references if (limit := series.limit(key))}
    differences = {key: {"value": value, "uncertainty": uncertainty, "relative_to": percent_of(key)}
                   for key, (value, uncertainty) in record.differences(place, series).items()}
    levels = [{name: getattr(level, name) for name in ("label", "parameter", "unknowns", "contact_elements", "seconds")}
              for level in (*series.levels, *[series.reference] * bool(series.reference))]
    names = ("model", "vary", "parameter", "ratio", "measures_others", "failure", "left_out", "no_reference")
    found = {**{name: getattr(series, name) for name in names},
             "levels": levels[:len(series.levels)], "reference_level": levels[len(series.levels):], "limits": limits, "references": _references_data(references)}
    return {**found, "model_differences": differences} if differences else found


def _place_data(record: Record, place: Place) -> dict[str, Any]:
    at = {name: place.at[name] for name in ("lateral_shift", "yaw")} if place.at else {}
    names = ("longitudinal_creepage", "lateral_creepage", "spin")
    return {"key": place.key, "name": place.name, **at, "points": [dict(zip(names, motion)) for motion in place.creepages],
            "reference": place.base.model, "references": _references_data(record.references(place, place.base)),
            "series": [_series_data(record, place, series) for series in place.series]}


def study_json(record: Record) -> str:
    """study.json."""
    used = {key.partition(":")[0] for _, series in record.each_series() for key in series.keys()}
    quantities = {name: {"title": q.title, "symbol": q.symbol, "unit": q.unit}
                  for name, q in ((name, described(name)) for name in (*QUANTITIES, *sorted(used - set(QUANTITIES))))}
    return sealed_json({
        "format": 4, "kind": "study", **record.head, "title": record.title, "case_file": record.case_file,
        "case_text": record.case_text, "friction_coefficient": record.friction, "notes": record.notes,
        "quantities": quantities, "verdict": verdict(record), "places": [_place_data(record, place) for place in record.places]})


HEAD = ("place,model,vary,level,parameter,unknowns,contact_elements,seconds [s],quantity,value,error_estimate,reference,"
        "reference_uncertainty,reference_kind,error [-],relative_to,order [-]\n")


def study_csv(record: Record) -> str:
    """study.csv: one row per place, series, level and key."""
    text = HEAD
    for place, series in record.each_series():
        references = record.references(place, series)
        orders = {key: iter(record.orders(series, key, reference)) for key, reference in references.items()}
        for level in series.levels:
            # Labels of several things refined together have commas.
            label = quoted(level.label) if "," in level.label else level.label
            for key in sorted(level.values):
                value, of = level.values[key], references.get(key)
                cells: list[Any] = [place.key, series.model, series.vary, label, level.parameter, level.unknowns,
                         level.contact_elements, level.seconds, key, value, level.bars.get(key)]
                cells += [None] * 6 if of is None else [of.value, of.uncertainty, of.kind, record.error(key, value, of),
                                                        percent_of(key), next(orders[key])]
                text += ",".join(map(cell, cells)) + "\n"
    return text
