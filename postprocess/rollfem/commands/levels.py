# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plans and solves the levels of a refinement study (`rollfem.study`, `rollfem study`)."""
import difflib
import json
import math
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import Any

from .. import _core, outputs
from ..errors import InputError, SolveError
from ..point import QUANTITIES, Point
from ..result import models_of, place_label
from .refinement import RULES, Level, Place, Record, Series, is_stress, study_csv, study_json, table


@cache
def known() -> dict[str, dict[str, Any]]:
    """The models, the cheaper first, by name: built, chooses, parallel, ..., ways to refine them."""
    return {model["name"]: model for model in _core.model_infos()}


def reference_model() -> str:
    """The first model that solves the elastic problem."""
    return next(name for name, model in known().items() if model["has_stress"])


def _ways(model: str, word: str) -> list[dict[str, Any]]:
    return [way for way in known()[model]["ways"] if word in (way["word"], way["also"] or None)]


def _that_vary(word: str) -> list[str]:
    return [name for name in known() if _ways(name, word)]


@dataclass
class Wishes:
    """The request of a study."""

    models: list[str] = field(default_factory=list)  #: empty: reference_model(); ["all"]: all that can take the case
    vary: Collection[str] = ()
    together: bool = False  #: refine all of `vary` at once, not one at a time
    levels: int = 0  #: 0: as the model has it
    quantities: Collection[str] = ()  #: followed in addition, at the headline of a level
    references: Collection[str] = ()  #: exact, finest, extrapolated, QUANTITY=VALUE, with several patches PLACE.QUANTITY=VALUE
    reference_seconds: float = 60.0  #: most that a level finer than the finest may be expected to take; 0: none

    @property
    def all(self) -> bool:
        return self.models == ["all"]

    def named(self) -> list[str]:
        if self.all:
            return [name for name, model in known().items() if model["built"] and not model["chooses"]]
        return self.models or [reference_model()]

    def check(self, case: _core.Case) -> None:
        """Checks that need no scene; InputError."""
        words = list(dict.fromkeys(way["word"] for model in known().values() for way in model["ways"]))
        for word in self.vary:
            if word not in words:
                near = difflib.get_close_matches(word, words, 1)
                raise InputError(f"--vary {word}: cannot be refined; {f'did you mean {near[0]}? ' if near else ''}allowed: "
                                 f"{', '.join(words)}; do: name one of them")
            if not any(_ways(name, word) for name in self.named()):
                allowed = "; ".join(f"{other} of {', '.join(_that_vary(other))}" for other in words)
                raise InputError(f"--vary {word}: no model of this study can refine it; allowed: {allowed}; do: add --model "
                                 f"{_that_vary(word)[-1]}, or vary something else")
            if word == "domain":
                _check_domain(case)
        for name in self.quantities:
            if name not in QUANTITIES and not is_stress(name):
                near = difflib.get_close_matches(name, QUANTITIES, 1)
                raise InputError(f"--quantity {name}: is no scalar of a load point; {f'did you mean {near[0]}? ' if near else ''}"
                                 "allowed: those of docs/results.md, and max_MEASURE_BODY such as max_von_mises_rail with "
                                 "output.stress_maxima; do: name one of them")
        if self.levels and not 2 <= self.levels <= 8:
            raise InputError(f"--levels {self.levels}: allowed: 2 to 8; do: correct it")
        if not self.reference_seconds >= 0:
            raise InputError(f"--reference-seconds {self.reference_seconds}: allowed: 0 or more; do: correct it")

    def able(self, scenes: Sequence[_core.Scene]) -> list[str]:
        """The models that take every scene; InputError for one that was named."""
        found = []
        for name in self.named():
            try:
                for scene in scenes:
                    _core.check(scene, name)
                found.append(name)
            except InputError:
                if not self.all:
                    raise
        return found

    def refer(self, record: Record) -> None:
        """Sets rule and given values of the record, whose places have their exact values; InputError."""
        for word in self.references:
            if word == "exact" and not record.places[0].exact:
                _refuse(word, "no exact value is known for this case", record.places)
            if word in RULES:
                record.rule = word
            else:
                _give(word, record.places)


def _check_domain(case: _core.Case) -> None:
    """InputError unless the program chooses the domain, so that it can be varied."""
    if case.has_profiles:
        why = "the bodies are true sections of rail and rim, or end where their profiles do"
    elif case.has_meshes:
        why = "the bodies end where the meshes named by the case end"
    else:
        return
    raise InputError(f"{case.file}: study --vary domain: {why}; allowed for this case: grid, cell, degree; do: vary one of "
                     "these, or compare runs with other [fem] length, depth and rim_thickness, or other meshes")


def _axes(place: Place) -> tuple[str, str]:
    """What is the size of a patch: that of profiles is no ellipse."""
    return ("contact_length", "contact_width") if place.at else ("semi_axis_x", "semi_axis_y")


def _refuse(word: str, why: str, places: Sequence[Place]) -> None:
    allowed = (f"allowed: exact, finest, extrapolated, or QUANTITY=VALUE with max_pressure, {', '.join(_axes(places[0]))}, "
               "approach or traction_coefficient:N of load point N")
    if len(places) > 1:
        allowed += f", as PLACE.QUANTITY=VALUE with one of the places {places[0].key} to {places[-1].key}"
    raise InputError(f"--reference {word}: {why}; {allowed}; do: correct it")


def _give(word: str, places: Sequence[Place]) -> None:
    """Takes PLACE.QUANTITY=VALUE; with a single place PLACE may be omitted."""
    key, equals, number = word.partition("=")
    if not equals:
        _refuse(word, "not a reference", places)
    meant = next((place for place in places if place.key and key.startswith(f"{place.key}.")), None)
    if meant:
        key = key.removeprefix(f"{meant.key}.")
    elif len(places) > 1:
        _refuse(word, "the case has several patches, and this does not name one", places)
    place = meant or places[0]
    coefficients = [f"traction_coefficient:{k}" for k in range(1, len(place.creepages) + 1)]
    if key not in ("max_pressure", "approach", *_axes(place), *coefficients):
        _refuse(word, "unknown quantity in this case", places)
    try:
        place.given[key] = float(number)
    except ValueError:
        _refuse(word, "the value is not a number", places)


FEWEST_CELLS = 4  # across the patch, of the first level of finite elements: coarser ones say nothing about its limit
#: Of the last pass over bodies that yield.
OF_PASSES = ("plastic_increment", "net_plastic_increment", "residual_stress", "groove_depth", "forward_flow", "plastic_work")


def _numbers(result: "_core.Result | None", axes: tuple[str, str], more: Collection[str] = ()) -> Iterator[tuple[str, Point, str]]:
    """(key of the study, load point, quantity) of what the model gives, with `more` quantities."""
    points = models_of(result)[0].points if result else []
    if head := models_of(result)[0].headline if result else None:
        largest = {f"max_{row['measure']}_{row['body']}": float(row["value"]) for row in head.stress_maxima}
        head.scalars.update(largest)
        fixed = ("max_pressure", *axes, "approach")
        for name in dict.fromkeys([*largest, "max_temperature", *more]):
            if name not in fixed and head.scalars.get(name):
                yield name, head, name
    for name in ("max_pressure", *axes, "approach") if points else ():
        if points[0].scalars.get(name):
            yield name, points[0], name
    for number, point in enumerate(points, 1):
        if (point.scalars.get("max_traction") or 0) > 0:
            found = [name for name in ("longitudinal_creepage", "lateral_creepage") if point.found(name)]
            for name in found if found[:1] == ["longitudinal_creepage"] else ["traction_coefficient", *found]:
                yield f"{name}:{number}", point, name
    for name in OF_PASSES if points else ():
        if points[-1].scalars.get(name):
            yield f"{name}:{len(points)}", points[-1], name


def _solved(level: Level, result: _core.Result, seconds: float, axes: tuple[str, str], more: Collection[str]) -> None:
    """Enters a result into its level."""
    model, numbers = models_of(result)[0], list(_numbers(result, axes, more))
    if lacking := {name for name in more if is_stress(name)} - {key for key, *_ in numbers}:
        there = [key for key, *_ in numbers if is_stress(key)]
        raise InputError(f"--quantity {lacking.pop()}: is not there; allowed here: {', '.join(there) or 'none'}; do: set output.stress_maxima, "
                         "or correct it")
    level.unknowns, level.contact_elements, level.seconds = model.unknowns, model.contact_elements, seconds
    level.shared = model.seconds.get("correction", 0.0)
    level.values = {key: point.scalars[name] for key, point, name in numbers}
    level.bars = {key: point.error_estimate[name] for key, point, name in numbers if name in point.error_estimate}
    level.no_bars = {key: point.no_bar[name] for key, point, name in numbers if name in point.no_bar}
    level.noise = max((point["residual"] for point in model), default=0.0)


@dataclass
class Plan:
    """One model, refined in one way (or several ways together)."""

    series: Series
    ways: list[str]
    count: int

    @classmethod
    def of(cls, model: str, ways: Sequence[dict[str, Any]], levels: int) -> "Plan":
        ratios = {way["ratio"] for way in ways}
        series = Series(model, " and ".join(way["word"] for way in ways), ", ".join(way["parameter"] for way in ways),
                        ratios.pop() if len(ratios) == 1 else 0.0, measures_others=model == reference_model(),
                        limit_of_its_own=not known()[model]["half_spaces"])
        counts = [min(levels or way["levels"], way["levels"]) if way["fixed"] or not levels else levels for way in ways]
        return cls(series, [way["word"] for way in ways], min(counts, default=1))


def _plans(model: str, wishes: Wishes) -> list[Plan]:
    """One for each word in `vary` that the model can refine, or a single one for all of them together; otherwise its first
    way. A model with nothing to refine has one level."""
    ways = [way for word in wishes.vary for way in _ways(model, word)] if wishes.vary else known()[model]["ways"][:1]
    if len(ways) < 2 or wishes.together:
        return [Plan.of(model, ways, wishes.levels)]
    return [Plan.of(model, [way], wishes.levels) for way in ways]


class Study:
    """A study at work: `solve` every model of every place on its levels, then `finish`."""

    def __init__(self, wishes: Wishes, case: _core.Case, work: _core.Computation) -> None:
        self.wishes, self.work = wishes, work
        self.scenes, self.notes = work.scenes(case)
        self.models = wishes.able(self.scenes)
        self.record = Record(work.provenance("rollfem::study"), case.title, case.file, case.text, case.friction_coefficient)
        for scene in self.scenes:
            place = Place(scene.creepages, key=scene.key, name=place_label(scene.place), at=scene.place)
            place.exact = {key: point.scalars[name] for key, point, name in _numbers(_core.exact_of(scene), _axes(place))}
            self.record.places.append(place)
        if case.has_profiles:
            self.record.notes = [*(note.text for note in self.notes),
                                 "the balance of the wheelset is found once: all levels of a patch have the same "
                                 "normal force and creepages, so that only the discretisation differs"]
        wishes.refer(self.record)

    def solve(self) -> None:
        """Levels that fail are part of their series. Every process of a parallel run calls it."""
        for scene, place in zip(self.scenes, self.record.places):
            for plan in (plan for model in self.models for plan in _plans(model, self.wishes)):
                series = self._series(plan, scene, place)
                if not series.levels and self.wishes.all:
                    self._say(place, f"{series.model} is left out: {series.failure}")
                else:
                    place.series.append(series)

    def finish(self) -> str:
        """Drops places without series, for which all models were left out. Returns the failures of all series in one text;
        SolveError when no level at all was solved."""
        every = [series for place in self.record.places for series in place.series]
        failures = "; ".join(series.failure for series in every if series.failure)
        if not any(series.levels for series in every):
            raise SolveError(failures)
        self.record.places = [place for place in self.record.places if place.series]
        return failures

    def _say(self, place: Place, text: str) -> None:
        self.work.say(f"study: {place.name}{': ' * bool(place.name)}{text}")

    def _series(self, plan: Plan, scene: _core.Scene, place: Place) -> Series:
        """If a level is too coarse to be meshed or solved, the series begins with a finer one. After a solved level a failure
        ends the series, because limits need consecutive levels."""
        series, work = plan.series, self.work
        on_all_threads = known()[series.model]["parallel"]
        if not (on_all_threads or work.first):
            return series
        numbers = [k for k in range(plan.count) if work.holds(k)]
        refined = [_core.refined(scene, series.model, plan.ways, k, plan.count) for k in numbers]
        if plan.ways == ["cell"]:
            refined = _fine_enough(refined, _core.patch_size(scene) or math.inf, series)
        groups = [[one] for one in refined] if on_all_threads else [refined]
        for group in groups:
            for level, why, too_coarse in self._levels(group, series, place):
                if not why:
                    series.levels.append(level)
                    continue
                self._say(place, f"{series.model} {level.label}: no result: {why}")
                said = "left_out" if too_coarse and not series.levels else "failure"
                if why not in (list_of := getattr(series, said)):
                    setattr(series, said, f"{list_of}{'; ' * bool(list_of)}{level.label}: {why}")
                if series.levels and work.whole:
                    return series
        if work.whole and len(series.levels) == len(refined):
            self._add_reference(plan, scene, place)
        solved = [*series.levels, *([series.reference] if series.reference else [])]
        for level in solved:  # from a cold start, each
            level.seconds += solved[0].shared - level.shared
        if not series.levels and series.left_out:
            series.failure, series.left_out = "; ".join(filter(None, (series.failure, series.left_out))), ""
        return series

    def _add_reference(self, plan: Plan, scene: _core.Scene, place: Place) -> None:
        """Solves a level beyond the finest where the levels show no limit, so that the finest has an error, too. Collective for a
        parallel model."""
        series, work = plan.series, self.work
        if not series.ratio > 1 or len(series.levels) < 2 or not self.wishes.reference_seconds:
            return
        before, finest = (max(level.seconds, 1e-3) for level in series.levels[-2:])
        seconds = finest * max(finest / before, series.ratio**2) * self.record.ends_in_itself(place, series)
        if known()[series.model]["parallel"]:
            seconds = float(work.from_first(repr(seconds)))
        if not seconds:
            return
        wanted = _core.refined(scene, series.model, plan.ways, plan.count, plan.count)
        if seconds > self.wishes.reference_seconds:
            series.no_reference = (f"{wanted[0]} would take some {seconds:.2g} s, more than reference-seconds = "
                                   f"{self.wishes.reference_seconds:g}")
            return
        (level, why, _), = self._levels([wanted], series, place)
        series.reference, series.no_reference = None if why else level, f"{level.label}: {why}" if why else ""

    def _levels(self, wanted: Sequence[tuple[str, float, _core.Scene]], series: Series,
                place: Place) -> list[tuple[Level, str, bool]]:
        """(level, why it has no result, whether another grid may have one), each as stored by an earlier call or solved.
        Collective for a parallel model."""
        work = self.work
        levels = [Level(label, parameter) for label, parameter, _ in wanted]
        names = [_record_name(place, series, level) for level in levels]
        failed: dict[int, tuple[str, bool]] = {}
        missing = [k for k, level in enumerate(levels) if not self._resumed(level, names[k], series, place)]

        def done(number: int, result: "_core.Result | None", outcome: Any, too_coarse: bool) -> None:
            level, name = levels[missing[number]], names[missing[number]]
            if result is None:
                failed[missing[number]] = outcome, too_coarse
                return
            _solved(level, result, outcome, _axes(place), self.wishes.quantities)
            work.keep(name, json.dumps(asdict(level)))
            work.drop(f"{name}-of-")
            self._say(place, f"{series.model} {level.label}: {level.seconds:.2g} s")

        work.solve_levels([_core.Level(series.model, wanted[k][0], wanted[k][2], f"{names[k]}-of-") for k in missing],
                          self.notes, done)
        return [(level, *failed.get(k, ("", False))) for k, level in enumerate(levels)]

    def _resumed(self, level: Level, name: str, series: Series, place: Place) -> bool:
        """Whether the level was read from the records of an earlier call; processes agree on what the first one has."""
        kept = (self.work.find(name) or b"").decode()
        if known()[series.model]["parallel"]:
            kept = self.work.from_first(kept)
        if not kept:
            return False
        try:
            level.__dict__.update(asdict(Level(**json.loads(kept))))
        except (ValueError, TypeError):
            self.work.refuse(name)
            return False
        self._say(place, f"{series.model} {level.label}: resumed")
        return True


def _fine_enough(levels: list[tuple[str, float, _core.Scene]], size: float, series: Series) -> list[tuple[str, float, _core.Scene]]:
    """Without the levels of few cells across a patch of this size, which the series names; at least the finest."""
    coarse = [level for level in levels[:-1] if size < (FEWEST_CELLS - 1e-6) * level[1]]
    series.left_out = "; ".join(f"{label}: only {size / cell:.2g} cells across the patch; do: give a smaller fem.cell_size"
                                for label, cell, _ in coarse)
    return levels[len(coarse):]


def _record_name(place: Place, series: Series, level: Level) -> str:
    """Name of a stored level, with the exact parameter, because labels are rounded; it belongs to the last refined
    quantity."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", f"level-{place.key}-{series.model}-{series.vary}-{level.label}-{level.parameter:.12g}")


def study_of(record: Record) -> outputs.Study:
    """The study as its files."""
    return outputs.Study({"study.json": study_json(record), "study.csv": study_csv(record)},
                 table(record))
