# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convergence of a sequence of values on successively finer levels: the observed order, Richardson's limit and the
reliability of both. P. J. Roache, Verification and Validation in Computational Science and Engineering (1998); L. Eca, M.
Hoekstra, J. Comput. Phys. 262 (2014), for sequences without an order."""
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

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
