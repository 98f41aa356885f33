# SPDX-License-Identifier: LGPL-2.1-or-later
"""Load points: their distinguishing values in words, the selection for drawings, and the reference model."""
import math

import numpy as np

from ..result import exact_one

# For the parts of a key (xi, eta, spin): the scalar, the symbol in figures and on pages, the factor, the unit, and the
# axis label.
PARTS = (("longitudinal_creepage", r"$\xi$", "ξ", 100, "%", r"longitudinal creepage $\xi$ [%]"),
         ("lateral_creepage", r"$\eta$", "η", 100, "%", r"lateral creepage $\eta$ [%]"),
         ("spin", r"$\varphi$", "φ", 1e3, "rad/m", r"spin $\varphi$ [rad/m]"))
# For a history: the scalar and its axis label.
STEPS = (("longitudinal_shift", "longitudinal shift since the start [mm]"),
         ("lateral_shift", "lateral shift since the start [mm]"),
         ("spin_shift", "rotation since the start [rad]"), ("distance", "rolled distance [mm]"), ("step", "step"))


def creepage_axis(points):
    """The varying quantity along the creep curve: (scalar, factor, axis label)."""
    if any(p.by_number and p["step"] for p in points):
        name, label = next((row for row in STEPS[:-1] if any(p[row[0]] for p in points)), STEPS[-1])
        return name, 1.0, label
    name, *_, factor, _, label = PARTS[(varying([p.creepages for p in points]) or [0])[0]]
    return name, factor, label


def varying(keys):
    """The parts of the keys that differ between load points."""
    return [k for k in range(3) if len({0.0 if _is_nothing(key[k]) else key[k] for key in keys}) > 1]


def _is_nothing(creepage):
    """Whether it is the residue of a search for zero."""
    return abs(creepage) < 1e-15


def key_texts(creepages):
    """The distinguishing values of load points, e.g. "ξ = 0.2 %", for each of a list of keys, (xi, eta, spin) or
    (number, what it counts); and their common values, e.g. "η = 0.1 %", empty if there are none."""
    if any(len(c) == 2 for c in creepages):
        return {c: f"{c[1]} {c[0]}" if len(c) == 2 else "" for c in creepages}, ""
    # For a single point: the nonzero values.
    told = varying(creepages) or [k for k in range(3) if not all(_is_nothing(c[k]) for c in creepages)] or [0]

    def text(key, wanted):
        return ", ".join(f"{symbol} = {0 if _is_nothing(key[k]) else factor * key[k]:.4g} {unit}"
                         for k, (_, symbol, _, factor, unit, _) in enumerate(PARTS) if wanted(k))

    shared = text(creepages[0], lambda k: k not in told and not _is_nothing(creepages[0][k])) if creepages else ""
    return {c: text(c, told.__contains__) for c in creepages}, shared


def friction_models(result):
    return [m for m in result.models if m.has_friction]


def with_pressure(result):
    """The models with a pressure field."""
    return [m for m in result.models if m.points and "pressure" in m.points[0].fields]


# Default reference models by their traits, those with the smallest model error first.
BEST = ("corrects_stress", "keeps_bodies", "has_stress")


def by_reference(result, models, best=BEST):
    """These models, the requested reference first, then the default one, then the best ones."""
    wished = (result.reference, result.default_reference)

    def rank(model):
        return next((k for k, name in enumerate(wished) if name == model.name),
                    len(wished) + next((k for k, trait in enumerate(best) if trait in model.traits), len(best)))

    return sorted(models, key=rank)


def reference_for_patch(result):
    """The requested reference model, otherwise the best one in the run."""
    return next(iter(by_reference(result, result.models, (*BEST, "frictionless"))), None)


def reference_for(result, quantity):
    """The same for a quantity at the first load point, or the model whose value is exact if the best one does not
    resolve its model error."""
    best = reference_for_patch(result)
    if best is None or not best.points or best.name == result.reference:
        return best
    return exact_one(result.models, 0, quantity, best.points[0].error_estimate.get(quantity, 0.0)) or best


def reference_for_forces(result):
    return next(iter(by_reference(result, friction_models(result))), None)


def all_keys(models):
    """The keys of all load points of the models, in order of first appearance."""
    return list(dict.fromkeys(point.key for model in models for point in model.points))


# What may be found for a prescribed force: the scalar, the force and its direction; name, factor and unit in figures.
FOUND = (("longitudinal_creepage", "longitudinal_force", "x", r"longitudinal creepage $\xi$", 100, "%"),
         ("lateral_creepage", "lateral_force", "y", r"lateral creepage $\eta$", 100, "%"),
         ("longitudinal_shift", "longitudinal_force", "x", "shift along $x$", 1000, "µm"),
         ("lateral_shift", "lateral_force", "y", "shift along $y$", 1000, "µm"))


def found_motions(models):
    """The rows of FOUND that are results of these models."""
    return [row for row in FOUND if any(p.found(row[0]) for m in models for p in m.points)]


def _evenly(found, count):
    """`count` entries of a list: the first, the last and evenly spaced ones between them; for 1 the middle one."""
    if len(found) <= count:
        return found
    return [found[round(k * (len(found) - 1) / (count - 1))] for k in range(count)] if count > 1 else [
        found[len(found) // 2]]


# Most rows of a table of load points; longer lists are thinned out, files contain all.
MOST_ROWS = 60


def shown_keys(models):
    """All keys, or a selection from a long list."""
    return _evenly(all_keys(models), MOST_ROWS)


def chosen_keys(models, count):
    """Up to `count` load points with tractions, spread over the creep curve."""
    def having(keys, what):
        return [c for c in keys if any((p := m.at(c)) and what(p) for m in models)]

    loaded = having(all_keys(models), lambda p: p["max_traction"] > 0)
    loaded = having(loaded, lambda p: "pressure" in p.fields) or loaded  # long lists store fields at some load points only
    if sticking := having(loaded, lambda p: p["adhesion_area"] > 0):  # among points in full slip, the first suffices
        sliding = [c for c in loaded if c not in sticking]
        loaded = [c for c in loaded if c not in sliding[1:]]
    return _evenly(loaded, count)


def last_pass(models):
    """The key of the last pass with stored fields over bodies that yield; None for other load points."""
    passes = [p.key for m in models for p in m.points if p.by_number == "pass" and p.fields]
    return max(passes, default=None)


def typical_key(models):
    """The last pass; otherwise a load point with both adhesion and slip area, or the middle one."""
    if last := last_pass(models):
        return last

    def imbalance(key):
        points = [p for m in models if (p := m.at(key)) and p["contact_area"] > 0]
        return min((abs(p["adhesion_area"] / p["contact_area"] - 0.5) for p in points), default=1.0)

    return min(chosen_keys(models, 10 ** 6), key=imbalance, default=None)


def coefficient(point, force):
    """-F/F_z of a force; nan without load."""
    return -point[force] / point["normal_force"] if point["normal_force"] else math.nan


def branch(model):
    """(creepages, traction coefficients) of a steady creep curve over creepage along or across alone, from 0 upwards; of
    the sign with more points. Empty for other load points."""
    points = [p for p in model.points if not p.by_number and not math.isnan(p["normal_force"])]  # with a solution
    told = varying([p.creepages for p in points])
    if len(told) != 1 or told[0] > 1 or any(c for p in points for k, c in enumerate(p.creepages) if k != told[0]):
        return np.zeros(0), np.zeros(0)
    force = ("longitudinal_force", "lateral_force")[told[0]]
    pairs = [(p.creepages[told[0]], coefficient(p, force)) for p in points]
    sign = math.copysign(1, sum(math.copysign(1, at) for at, _ in pairs if at))
    return np.array(sorted((sign * at, sign * value) for at, value in pairs if sign * at > 0)).reshape(-1, 2).T


def peak(creepages, values):
    """(creepage, value) at the summit of the parabola through the highest point and its neighbours; None where the
    highest point is the first or the last."""
    top = int(np.argmax(values)) if len(values) else 0
    if not 0 < top < len(values) - 1:
        return None
    at, middle = creepages[top - 1:top + 2] - creepages[top], values[top]
    bend, slope, _ = np.polyfit(at, values[top - 1:top + 2] - middle, 2)
    return creepages[top] - slope / (2 * bend), middle - slope ** 2 / (4 * bend)


# Extrapolations of the initial slope from two and from three points differ by less than this part.
SURE_SLOPE = 0.05


def initial_slope(creepages, values):
    """d(-F/F_z)/d(creepage) at 0 as the parabola through the slopes to the three smallest creepages extrapolates it,
    which is exact for Vermeulen and Johnson's law; None where the points are too far apart for it."""
    if len(values) < 3:
        return None
    at, slopes = creepages[:3], values[:3] / creepages[:3]
    two, three = (np.polynomial.Polynomial.fit(at[:n], slopes[:n], n - 1)(0.0) for n in (2, 3))
    return float(three) if abs(three - two) < SURE_SLOPE * abs(three) else None
