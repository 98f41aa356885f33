# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stress and displacement below the surface of stored load points, without solving again: `rollfem stress`."""
import math
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .. import _core
from ..errors import InputError
from ..heat import HeatedBody
from ..outputs import Stress, StressModel, StressSet, columns_below
from ..point import Point
from ..reader import read_result
from ..result import ModelResult, Result
from ..shakedown import Ellipse, boundaries, circle_limits, line_limits, surface_fatigue_index, yield_shear_stress
from ..stresses import stress_measures, von_mises

#: Orthogonal shear stress on the surface: the largest tangential traction.
SURFACE_SHEAR = "orthogonal_shear_surface"
_MEASURES = ("von_mises", "tresca", "orthogonal_shear", "principal_1")
_PROFILE_POINTS, _PROFILE_DEPTH = 121, 3.0  # in units of the smaller semi-axis
Maximum = dict[str, Any]  # body, measure, value, place


@dataclass
class Request:
    """Places in a body."""

    name: str  #: in all files: point_1, line_1, ...
    call: str  #: for messages
    places: dict[str, Any]  #: kind, body, from, to, across, depth, points (_core.read_places)
    depth_profile: bool = False  #: depth is relative to the surface at the first place

    @property
    def body(self) -> str:
        """wheel or rail."""
        return str(self.places["body"])


@dataclass
class Wanted:
    """What a call of `rollfem stress` wants; as of `stress`, but load points from 1."""

    result: str  #: for messages
    models: Sequence[str] = ()
    patch: str = ""
    points: Sequence[int] = ()
    creepages: Sequence[float] = ()
    places: str = ""
    depth_profile: bool = False
    depth: float | None = None
    yield_shear_stress: float | None = None
    yield_strength: float | None = None

    @property
    def k(self) -> float | None:
        """The yield stress in shear, MPa."""
        if self.yield_shear_stress is not None and self.yield_strength is not None:
            raise InputError("--yield-shear-stress and --yield-strength exclude each other; allowed: one of them; do: "
                             "leave one out (k = Y / sqrt(3))")
        for name, value in (("shear-stress", self.yield_shear_stress), ("strength", self.yield_strength)):
            if value is not None and not 0 < value < math.inf:
                raise InputError(f"--yield-{name} {value:g}: allowed: a stress > 0 in MPa; do: give one")
        return self.yield_shear_stress if self.yield_strength is None else yield_shear_stress(self.yield_strength)


def requests_of(file: str) -> list[Request]:
    """The requests of a file with [[subsurface.*]], in its order."""
    counts: Counter[str] = Counter()
    found = []
    for places in _core.read_places(file):
        kind = places["kind"]
        counts[kind] += 1
        name = f"{kind}_{counts[kind]}"
        if kind != "point" and (places["to"] == places["from"] or kind == "plane" and places["across"] == places["from"]):
            raise InputError(f"{file}: {name}: two of its points coincide; do: move one of them")
        found.append(Request(name, f"{file}: {name}", places))
    return found


def lattice(places: Mapping[str, Any]) -> np.ndarray:
    """The places [n, 3] of a request, mm, the first side fastest; those that follow the surface on the plane z = 0 or at the
    depth below it."""
    start, end, other = (np.array(places[name]) for name in ("from", "to", "across"))
    i, j = (np.arange(count) / max(1, count - 1) for count in places["points"])
    points = start + i[None, :, None] * (end - start) + np.zeros((len(j), 1, 1))
    if len(j) > 1:
        points += j[:, None, None] * (other - start)
    if places["kind"] == "surface":
        points[..., 2] = places["depth"] if places["body"] == "wheel" else 0.0 - places["depth"]
    return np.reshape(points, (-1, 3))


def largest_in(body: str, places: np.ndarray, stress: np.ndarray, least_depth: float = 0.0, below: float = 0.0) -> list[Maximum]:
    """The largest value of every measure in a body, with its place. Ignores places nearer to z = 0 than `least_depth`, but not
    on it; measures below the surface ignore all above `below`. Where all places lie there, the largest shear is that on the
    surface."""
    depth, found = np.abs(places[:, 2]), []
    measures = stress_measures(stress)
    measures["principal_1"] = measures["principal"][:, 0]
    on_surface = bool((depth <= below).all())
    for name in _MEASURES:
        if name == "orthogonal_shear" and not on_surface:
            counts = depth > below
        else:
            counts = (depth <= 0.0) | (depth >= least_depth)
        at = np.argmax(values := np.where(counts, measures[name], -np.inf))
        found.append({"body": body, "measure": SURFACE_SHEAR if name == "orthogonal_shear" and on_surface else name,
                      "value": float(values[at]), "place": places[at].tolist()})
    return found


class Loaded:
    """A load point of a model, and where its stresses come from."""

    def __init__(self, result: Result, model: ModelResult, number: int, source: str) -> None:
        """`source`: tractions, bodies or corrected (_core.models_with_stress)."""
        self.result, self.model, self.number, self.source = result, model, number, source
        self.point = model.points[number]
        self._heated: dict[str, HeatedBody] = {}
        # Perhaps without ends.
        self.line_reference = _core.line_reference(self._case()) if len(model.y) == 1 and result.case_text else 0.0
        self.element = model.dx if self.line_reference else max(model.dx, model.dy)
        a, b = (float(self.point.scalars.get(f"semi_axis_{side}", math.nan)) for side in "xy")
        self.semi_axes = a, b
        self.smaller = self.semi_axes[0] if self.line_reference else min(self.semi_axes)

    def _case(self) -> _core.Case:
        return _core.parse_case(self.result.case_text, self.result.case_file)

    def _tractions(self) -> _core.Loaded:
        model, fields = self.model, self.point.fields
        return _core.Loaded(model.x, model.y, model.dx, model.dy, self.line_reference, fields["pressure"],
                            fields.get("traction_x", np.zeros(0)), fields.get("traction_y", np.zeros(0)))

    def _material(self, body: str) -> tuple[float, float]:
        return self.result.inputs[f"{body}.young_modulus"], self.result.inputs[f"{body}.poisson_ratio"]

    def heated(self, body: str) -> HeatedBody | None:
        """The heat below the surface of a body; None without it."""
        surface = self.point.fields.get(f"temperature_{body}")
        if surface is not None and body not in self._heated:
            self._heated[body] = HeatedBody(_core.heated_body(self._case(), body == "wheel"), self._material(body), self.model, surface)
        return self._heated.get(body)

    def has(self, body: str) -> bool:
        """Whether a body has stress: finite elements store elastic bodies alone."""
        return not self.point.bodies or body in self.point.bodies

    def depth_profiles(self, depth: float | None) -> list[Request]:
        """Lines from the surface down below the centre of the patch, and below the most loaded element unless it contains the
        centre."""
        deep = _PROFILE_DEPTH * self.smaller if depth is None else depth
        if not 0 < deep < math.inf:
            raise InputError(f"model {self.model.key} does not give the size of the patch; do: give a --depth" if depth is None
                             else f"--depth {depth:g}: allowed: a depth > 0 in mm; do: give one")
        pressure, model = self.point.fields["pressure"], self.model
        rows, columns = np.nonzero(pressure > 0)
        centre = [0.0 if abs(mean) < 1e-9 * size else float(mean) for mean, size in (
            (sum(model.x[columns]) / max(1, len(columns)), model.dx), (sum(model.y[rows]) / max(1, len(rows)), model.dy))]
        row, column = np.unravel_index(np.argmax(pressure), pressure.shape)
        most = [float(model.x[column]), float(model.y[row])]
        apart = any(abs(a - b) > 0.51 * size for a, b, size in zip(most, centre, (model.dx, model.dy)))
        lines = [("depth_centre", centre, deep), ("depth_most_loaded", most, deep)][:1 + apart]
        if "temperature_rail" in self.point.fields:
            lines.append(("depth_hottest", self.hottest(), 0.1 * deep))
        return [Request(name, "depth profile", {
            "kind": "line", "body": body, "from": [*spot, 0.0], "to": [*spot, down if body == "wheel" else -down],
            "across": [0.0] * 3, "depth": 0.0, "points": [_PROFILE_POINTS, 1]}, True)
            for name, spot, down in lines for body in ("wheel", "rail") if self.has(body)]

    def heated_range(self, k: float) -> float | None:
        """Change of the surface's stress at the hottest place while it passes through the contact, over that which stays elastic with
        any residual stress, 2 sqrt(3) k (Melan's theorem for two instants); of the body with the larger. None where
        stress does not come from the tractions."""
        if self.source != "tractions":
            return None
        place = np.array([[*self.hottest(), 0.0]])
        found = []
        for body in ("wheel", "rail"):
            stress, heat = self._tractions().below(body == "wheel", *self._material(body), place)[1], self.heated(body)
            assert heat
            found.append(von_mises(stress + heat.stress(heat.rise(place)))[0] / (2 * math.sqrt(3) * k))
        return float(max(found))

    def hottest(self) -> list[float]:
        """x and y of the largest temperature, mm."""
        return [float(self.point[f"max_temperature_{axis}"]) for axis in "xy"]

    def stresses(self, requests: Sequence[Request]) -> tuple[list[StressSet], list[Maximum]]:
        """Displacement and stress at the requests, and the largest stresses of both bodies."""
        if self.source == "corrected":
            found, maxima = self._tractions().corrected(
                self._case(), self.model.place, *self.semi_axes, [(each.places, each.depth_profile) for each in requests])
            return [self._set(each, *parts) for each, parts in zip(requests, found)], maxima
        sets = (self._in_bodies if self.source == "bodies" else self._in_half_spaces)(requests)
        maxima = self.point.stress_maxima or (
            self._largest_at_nodes() if self.source == "bodies"
            else self._tractions().maxima([self._material(body) for body in ("wheel", "rail")], *self.semi_axes))
        return sets, self._raised(maxima, sets)

    def _raised(self, maxima: Sequence[Maximum], sets: Sequence[StressSet]) -> list[Maximum]:
        """The largest values or those at the requested places: the search skips depths below one element, which matters if
        elements are long. Ignores places closer to the surface than half an element but not on it."""
        least = 0.0 if self.source == "bodies" else 0.5 * self.element
        found = [{**each, "place": [float(c) for c in each["place"]]} for each in maxima]
        for part in sets:
            largest = {each["measure"]: each for each in largest_in(part.body, part.places, part.stress, least, least)}
            for maximum in found:
                at = largest.get(maximum["measure"])
                if at and maximum["body"] == part.body and at["measure"] != SURFACE_SHEAR and at["value"] > maximum["value"]:
                    maximum.update(at)
        return found

    def _set(self, request: Request, places: np.ndarray, displacement: np.ndarray, stress: np.ndarray, moved: float = 0.0) -> StressSet:
        """With temperature and thermal stress, where the load point has temperatures."""
        heat, warm = self.heated(request.body), {}
        if heat is not None:
            below = np.array(places)
            if request.depth_profile:
                below[:, 2] -= below[0, 2]
            elif request.places["kind"] == "surface":
                below[:, 2] = request.places["depth"]
            rise = heat.rise(below)
            stress, warm = stress + heat.stress(rise), {"temperature": heat.before + rise}
        return StressSet(request.name, request.places["kind"], request.body, (request.places["points"][1], request.places["points"][0]),
                         {**columns_below(places, displacement, stress), **warm}, largest_in(request.body, places, stress), float(moved))

    def _in_half_spaces(self, requests: Sequence[Request]) -> list[StressSet]:
        """From integrals over the tractions. A half-space has no material beyond z = 0."""
        all_places = [lattice(each.places) for each in requests]
        for each, places in zip(requests, all_places):
            wheel = each.body == "wheel"
            for x, y, z in places[(places[:, 2] if wheel else -places[:, 2]) < 0][:1]:
                raise InputError(f"{each.call}: ({x:g}, {y:g}, {z:g}) mm is not in the {each.body} of model {self.model.key}, a "
                                 f"half-space with z {'>=' if wheel else '<='} 0; do: name points inside it, or the other body")
        loaded, sets = self._tractions(), []
        for each, places in zip(requests, all_places):
            sets.append(self._set(each, places, *loaded.below(each.body == "wheel", *self._material(each.body), places)))
        return sets

    def _stored(self, body: str) -> _core.StoredBody:
        return _core.StoredBody(body, *(self.point.bodies[body][part] for part in ("points", "cells", "displacement", "stress")))

    def _in_bodies(self, requests: Sequence[Request]) -> list[StressSet]:
        """By interpolation in the stored bodies, whose surface lies at z = 0 only in the middle of the patch."""
        for each in requests:
            if not self.has(each.body):
                raise InputError(f"{each.call}: the {each.body} is rigid and has no stored stress; do: name the other body")
        stored = {body: self._stored(body) for body in {each.body for each in requests}}
        sets = []
        for each in requests:
            places, body = lattice(each.places), stored[each.body]
            inner = (0.5 if each.body == "wheel" else -0.5) * min(self.semi_axes)
            if each.places["kind"] == "surface":
                places[:, 2] += [body.surface(x, y, inner, -inner) for x, y, _ in places]
            elif each.depth_profile:
                places[:, 2] += body.surface(places[0, 0], places[0, 1], inner, -inner)
            try:
                found, displacement, stress, moved = body.at(places)
            except InputError as error:
                raise type(error)(f"{each.call}: {error}") from None
            sets.append(self._set(each, found, displacement, stress, moved.max()))
        return sets

    def _largest_at_nodes(self) -> list[Maximum]:
        """Between the nodes there are no larger ones: each measure is a convex function of the stress, and the interpolated
        stress is a mean of those of the nodes. On a curved surface nodes have a small z."""
        point, found = self.point, []
        middle = [point.scalars.get(f"patch_{side}_middle") or 0.0 for side in "xy"]
        size = np.hypot(*(point.fields.get(f"traction_{side}", np.zeros((1, 1))) for side in "xy"))
        row, column = np.unravel_index(np.argmax(size), size.shape)
        place = [float(self.model.x[column]), float(self.model.y[row]), 0.0] if size.max() > 0 else [0.0] * 3
        for name in [body for body in ("wheel", "rail") if body in point.bodies]:
            body = point.bodies[name]
            found += [*largest_in(name, body["points"], body["stress"], 0.0, 0.5 * self.element),
                      {"body": name, "measure": SURFACE_SHEAR, "value": float(size.max()), "place": place},
                      *self._stored(name).xz_range(*self.semi_axes, *middle)]
        return found


def _listed(names: Sequence[Any]) -> str:
    return ", ".join(dict.fromkeys(map(str, names)))


def _patch(model: ModelResult) -> str:
    assert model.place
    return ",".join(str(model.place[name]) for name in ("wheel", "position", "patch"))


def _models_of(result: Result, wanted: Wanted, file: str) -> list[ModelResult]:
    """The requested models of the requested patch; otherwise those with stress, otherwise the first one."""
    there, patch = result.models, wanted.patch
    if not there:
        raise InputError(f"{file} holds no models; do: run a case")
    if patch and not there[0].place:
        raise InputError(f"--patch {patch}: {file} comes from a case without profiles and has one patch; do: leave --patch out")
    if there[0].place:
        patch = patch or _patch(there[0])
        if not (there := [model for model in there if _patch(model) == patch]):
            raise InputError(f"--patch {patch}: no such patch in {file}; allowed: {_listed([_patch(m) for m in result.models])}; "
                             "do: name one of them")
    for name in wanted.models:
        if all(model.name != name for model in there):
            raise InputError(f"--model {name}: it is not in {wanted.result}; allowed: {_listed([m.name for m in there])}; "
                             "do: name one of them")
    names = wanted.models or [name for name, _ in _core.models_with_stress()]
    return [model for name in names for model in there if model.name == name] or there[:1]


def _points_of(model: ModelResult, wanted: Wanted) -> list[int]:
    """Load points from 0; the last one by default."""
    if not model.points:
        raise InputError(f"{wanted.result}: model {model.key} has no load points; do: run the case again")
    if wanted.points and wanted.creepages:
        raise InputError("--point and --creepage exclude each other; allowed: one of them; do: leave one out")
    chosen = []
    for number in wanted.points:
        if not 1 <= number <= len(model):
            raise InputError(f"--point {number}: model {model.key} has load points 1 to {len(model)}; do: name one of them")
        chosen.append(number - 1)
    for creepage in wanted.creepages:
        there = [float(point["longitudinal_creepage"]) for point in model.points]
        near = [k for k, xi in enumerate(there) if abs(xi - creepage) <= 1e-9 * max(abs(xi), 1e-6)]
        if not near:
            raise InputError(f"--creepage {creepage:g}: model {model.key} has no such load point; allowed: "
                             f"{_listed([f'{xi:g}' for xi in there])}; do: name one of them")
        chosen.append(near[0])
    return list(dict.fromkeys(chosen)) or [len(model) - 1]


def _check_stored(at: Loaded, result: str) -> None:
    """Refuses load points whose stored data do not give stresses."""
    model, number = at.model, at.number + 1
    if "max_pressure" not in at.point.scalars:
        raise InputError(f"{result}: load point {number} of model {model.key} has no solution; do: name another with --point")
    if at.source != "bodies":
        if "pressure" not in at.point.fields:
            raise InputError(f"{result}: model {model.key} stores no tractions at load point {number}; do: name another with --point "
                             'or --model, or run the case again with [output] grid_fields = "all"')
        return
    kept = [k + 1 for k, point in enumerate(model.points) if point.bodies]
    if not kept:
        raise InputError(f"{result}: the bodies of model {model.key} are not stored; do: run the case again with [output] "
                         'body_fields = "all" (and without fields = false)')
    if number not in kept:
        other = next(name for name, source in _core.models_with_stress() if source == "tractions")
        raise InputError(f"load point {number}: model {model.key} stores its bodies only for these load points: {_listed(kept)}; "
                         f'do: choose one of them or --model {other}, or run the case again with [output] body_fields = "all"')


def _barred(point: Point, maximum: Maximum) -> dict[str, Any]:
    """A largest stress with its error bar if it is a stored one; otherwise it has only its single grid."""
    stored = any(each["body"] == maximum["body"] and each["measure"] == maximum["measure"] and each["value"] == maximum["value"]
                 for each in point.stress_maxima)
    name = f"max_{maximum['measure']}_{maximum['body']}" if stored else ""
    said: dict[str, Any] = {part: maximum[part] for part in ("body", "measure", "value")}
    if point["max_pressure"] > 0:
        said["over_max_pressure"] = maximum["value"] / point["max_pressure"]
    said["place"] = [float(c) for c in maximum["place"]]
    bar = point.error_estimate.get(name)
    said["no_bar" if bar is None else "error_estimate"] = point.no_bar.get(name, "one grid") if bar is None else bar
    return said


def _yield_ratio(maxima: Sequence[Maximum], k: float) -> float:
    """Largest von Mises stress of the bodies over the yield value sqrt(3) k."""
    return max((each["value"] for each in maxima if each["measure"] == "von_mises"), default=0.0) / (math.sqrt(3.0) * k)


def _ellipse(at: Loaded) -> Ellipse:
    """The ellipse that fits the patch, or a line."""
    a, b = at.semi_axes
    return Ellipse(math.inf if at.line_reference else b / a if a > 0 else 1.0)


def _in_map(at: Loaded, ellipse: Ellipse, k: float, known: Mapping[int, Sequence[Maximum]]) -> list[dict[str, Any]]:
    """All load points of a model in the shakedown map; `known`: the largest stresses that were computed. First yield follows
    from the largest stress if known or stored, otherwise from the lower elastic limit of line and circle; shakedown from the
    limit of the ellipse."""
    found, model = [], at.model
    for number, point in enumerate(model.points):
        traction, (factor, shear, creepage) = point.tangential_coefficient, (
            float(point.scalars.get(name, math.nan)) for name in ("max_pressure", "max_traction", "longitudinal_creepage"))
        factor /= k
        line, circle, limit = line_limits(traction), circle_limits(traction), ellipse.limit(traction)
        maxima = known.get(number, point.stress_maxima)
        ratio = _yield_ratio(maxima, k) if maxima else None
        elastic = factor <= min(line.elastic, circle.elastic) if ratio is None else ratio < 1
        heated = Loaded(at.result, model, number, at.source).heated_range(k) if "temperature_rail" in point.fields else None
        found.append({
            "point": number + 1, "longitudinal_creepage": creepage, "tangential_coefficient": traction,
            "load_factor": factor, "max_traction_over_k": shear / k,
            "surface_fatigue_index": surface_fatigue_index(traction, factor),
            **{name: {"elastic": limits.elastic, "shakedown": limits.shakedown, "region": limits.region(factor)}
               for name, limits in (("line", line), ("circle", circle))},
            "ellipse": {"ratio": None if ellipse.is_line else ellipse.ratio, "shakedown": limit},
            "verdict": "beyond shakedown" if factor > limit or (heated or 0) > 1 else "elastic" if elastic else "elastic shakedown",
            "margin": f"p0 is {100 * abs(factor / limit - 1):.2g} % {'above' if factor > limit else 'below'} the limit",
            **({} if ratio is None else {"yield_ratio": ratio}), **({} if heated is None else {"heated_range": heated})})
    return found


def _entry(at: Loaded, sets: Sequence[StressSet], maxima: Sequence[Maximum]) -> dict[str, Any]:
    """A load point in stress.json."""
    model, point = at.model, at.point
    return {
        "name": model.name, "key": model.key, **({"label": model.label} if model.label else {}),
        **({"place": {name: model.place[name] for name in ("wheel", "position", "patch")}} if model.place else {}),
        "point": at.number + 1, **dict(zip(("longitudinal_creepage", "lateral_creepage", "spin"), point.creepages)),
        "step": point.scalars.get("step", 0), **{name: point[name] for name in ("normal_force", "max_pressure", "max_traction")},
        "tangential_coefficient": point.tangential_coefficient, "maxima": [_barred(point, each) for each in maxima],
        "sets": [{"name": part.name, "kind": part.kind, "body": part.body, "points_along": part.shape[1],
                  "points_across": part.shape[0], "moved": part.moved,
                  "largest": [{name: value for name, value in _barred(point, each).items() if name != "body"}
                              for each in part.largest]} for part in sets]}


def stress_of(result: Result, wanted: Wanted, file: str) -> tuple[Stress, list[str]]:
    """The stresses that a call wants, and what was left out and why; InputError if nothing is left. `file`: of the result."""
    requests, k = requests_of(wanted.places) if wanted.places else [], wanted.k
    source, left_out = dict(_core.models_with_stress()), []
    made: list[tuple[Loaded, StressModel, list[Maximum]]] = []
    for model in _models_of(result, wanted, file):
        for number in _points_of(model, wanted):
            at = Loaded(result, model, number, source.get(model.name, "tractions"))
            try:
                _check_stored(at, wanted.result)
            except InputError as error:
                left_out.append(str(error))
                continue
            profiles = at.depth_profiles(wanted.depth) if wanted.depth_profile or not requests else []
            sets, maxima = at.stresses([*profiles, *requests])
            made.append((at, StressModel(model.name, model.key, sets, _entry(at, sets, maxima), model.label), maxima))
    left_out = list(dict.fromkeys(left_out))
    if not made:
        raise InputError(left_out[0])
    data = {"format": 2, "source": file, "title": result.title, **({"yield_shear_stress": k} if k else {}),
            "models": [each.data for _, each, _ in made]}
    if k:
        known: dict[str, dict[int, list[Maximum]]] = {}
        for at, _, maxima in made:
            known.setdefault(at.model.key, {})[at.number] = maxima
        for at, each, maxima in made:
            each.data["yield_ratio"] = _yield_ratio(maxima, k)
            each.data["shakedown"] = _in_map(at, _ellipse(at), k, known[at.model.key])
        data["shakedown_map"] = boundaries(_ellipse(made[0][0]))
    text = _text(data, made, bool(wanted.points or wanted.creepages))
    return Stress(data, [each for _, each, _ in made], text), [f"left out: {why}" for why in left_out]


def _bar(said: Mapping[str, Any]) -> str:
    return f"+- {said['error_estimate']:.2g}" if "error_estimate" in said else str(said.get("no_bar", ""))


def _row(what: str, body: str, said: Mapping[str, Any]) -> str:
    x, y, z = (0.0 if abs(value) < 5e-4 else value for value in said["place"])  # without -0.000
    return (f"  {what:<22}{body:<6} {said['measure']:<25}{said['value']:>10.2f} {_bar(said):<14}"
            f"{said.get('over_max_pressure', 0.0):>8.4f}{x:>10.3f}{y:>9.3f}{z:>9.3f}\n")


def _text(data: Mapping[str, Any], made: Sequence[tuple[Loaded, StressModel, list[Maximum]]], named: bool) -> str:
    """What the command prints; `named`: load points were, which otherwise are the last ones."""
    text = f"{data['title']}\n{data['source']}\n"
    for place, (at, model, _) in enumerate(made):
        point, entry, count = at.point, model.data, len(at.model)

        def barred(name: str, point: Point = point) -> str:
            bar = point.bar(name)
            return point.no_bar.get(name, "") if bar is None else f"+- {bar:.2g}"

        text += f"\n{model.key}: load point {entry['point']}"
        if not named and count > 1:
            text += f" (the last of {count}; others: --point 1 to {count}, --creepage)"
        text += f" (step {entry['step']})" if entry["step"] else ", xi = {:g}, eta = {:g}, spin = {:g} rad/mm".format(*point.creepages)
        text += (f"; F_z = {entry['normal_force']:g} N ({barred('normal_force')}), p0 = {entry['max_pressure']:.2f} MPa "
                 f"({barred('max_pressure')}), T/F_z = {entry['tangential_coefficient']:.4f}\n")
        text += f"  {'largest':<22}{'body':<6} {'stress':<25}{'MPa':>10} {'+-':<14}{'of p0':>8}{'x in mm':>10}{'y':>9}{'z':>9}\n"
        text += "".join(_row("of the body", each["body"], each) for each in entry["maxima"])
        text += "".join(_row(part["name"], part["body"], each) for part in entry["sets"] for each in part["largest"])
        if "shakedown" in entry and (place + 1 == len(made) or made[place + 1][1].key != model.key):
            text += _map_text(data["yield_shear_stress"], entry["shakedown"],
                              {each.data["point"] for _, each, _ in made if each.key == model.key})
    return text


def _heated_text(each: Mapping[str, Any]) -> str:
    return f"; with heat the surface goes through {each['heated_range']:.2g} of what stays elastic" if "heated_range" in each else ""


def _map_text(k: float, points: Sequence[Mapping[str, Any]], asked: set[int]) -> str:
    """The shakedown table of all load points of a model."""
    ratio = points[0]["ellipse"]["ratio"]
    what = "the line contact" if ratio is None else f"the ellipse that fits, b/a = {ratio:.2f}"
    text = (f"\n  shakedown map, k = {k:.1f} MPa (yield stress in shear); limit of p0/k of {what}\n"
            f"  {'point':<6}{'xi':>11}{'T/F_z':>8}{'p0/k':>8}{'limit':>10}{'FI_surf':>9}{'Y-ratio':>8}  "
            "verdict, and margin to the limit\n")
    for each in points:
        known = f"{each['yield_ratio']:.3f}" if "yield_ratio" in each else "-"
        text += (f"  {each['point']:<6}{each['longitudinal_creepage']:>11g}{each['tangential_coefficient']:>8.4f}"
                 f"{each['load_factor']:>8.3f}{each['ellipse']['shakedown']:>10.2f}{each['surface_fatigue_index']:>9.3f}{known:>8}  "
                 f"{each['verdict']}; {each['margin']}{_heated_text(each)}{'  <' * (each['point'] in asked)}\n")
    return text + ("  elastic: the largest von Mises stress is below sqrt(3) k (Y-ratio; if unknown, p0 below the limits of line and "
                   "circle); shakedown: under full slip, at the same T/F_z\n")


def stored_at(path: str) -> tuple[Result, str]:
    """The result at a path, and its results.h5."""
    return read_result(path), os.path.join(path, "results.h5") if os.path.isdir(path) else path
