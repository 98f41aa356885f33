# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of several models side by side: every number with its error bar and its difference from a reference model, for one
or several cases; as the files and the text of `rollfem compare` (docs/commands.md)."""
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from .. import _core
from ..files import cell, quoted, sealed_json
from ..outputs import Comparison
from ..point import QUANTITIES, Point, Quantity
from ..result import ModelResult, Result, exact_one, place_label
from .levels import known

#: What may be found for a prescribed force: symbol, and the force that is then no result.
FOUND = {"longitudinal_creepage": ("xi", "traction_coefficient"), "lateral_creepage": ("eta", "lateral_coefficient"),
         "longitudinal_shift": ("shift x", "traction_coefficient"), "lateral_shift": ("shift y", "lateral_coefficient")}
#: A model without a result for a case: its name, why, and whether it failed or cannot take the case.
Missing = tuple[str, str, bool]


@dataclass
class Compared:
    """A case with its results."""

    name: str  #: of its result folder beside the comparison
    title: str
    case_file: str
    friction: float  #: coefficient
    models: Sequence[ModelResult] = ()
    missing: Sequence[Missing] = ()


def scalars_of(models: Sequence[ModelResult]) -> Sequence[ModelResult]:
    """Results without the values of elements and nodes, which no comparison needs."""
    for point in (point for model in models for point in model):
        point.fields, point.subsurface, point.bodies = {}, [], {}
    return models


@dataclass
class Number:
    """One quantity of one model at one load point, compared with the reference."""

    patch: str  #: "left wheel, position 1"; empty without profiles
    model: str
    point: int  #: from 1
    motion: tuple[float, float, float]  #: creepages and spin
    quantity: str  #: as in summary.json, or lateral_coefficient = -F_y/F_z
    value: float
    error: float | None = None  #: the model's own estimate, absolute
    model_error: float | None = None  #: as estimated by the model, absolute
    reference: str = ""
    reference_value: float | None = None
    reference_error: float = 0.0  #: absolute; 0 without an estimate
    scale: float = 0.0  #: of relative differences: the reference's value, or the value at full sliding

    @property
    def difference(self) -> float:
        return (self.value - (self.reference_value or 0.0)) / self.scale

    @property
    def allowed(self) -> float:
        """The sum of both error bars, relative to the scale."""
        return ((self.error or 0.0) + self.reference_error) / self.scale

    @property
    def excess(self) -> float:
        """By how much the difference exceeds the bars; a theory without an estimate has no bar."""
        return abs(self.difference) - self.allowed

    @property
    def differs(self) -> bool:
        return self.reference_value is not None and self.excess > 1e-9  # less is rounding


@cache
def quantities() -> dict[str, Quantity]:
    """By which models are compared: those of the patch first, then those of friction."""
    found = {name: quantity for name, quantity in QUANTITIES.items() if quantity.compared}
    ordered = dict(sorted(found.items(), key=lambda item: item[1].of_friction))
    ordered["lateral_coefficient"] = replace(QUANTITIES["traction_coefficient"], title="lateral coefficient", symbol="-F_y/F_z")
    for name, (symbol, _) in FOUND.items():
        ordered[name] = replace(QUANTITIES[name], symbol=symbol, percent_of="value")
    return ordered


def value_of(point: Point, name: str) -> float:
    """0 where the model does not give it."""
    if name != "lateral_coefficient":
        return float(point.scalars.get(name) or 0.0)
    force = point.scalars.get("normal_force")
    return -float(point.scalars.get("lateral_force") or 0.0) / float(force) if force else 0.0


def error_of(point: Point, name: str) -> float | None:
    """The error bar; that of the lateral coefficient follows from the bar of the force."""
    if name != "lateral_coefficient":
        return point.error_estimate.get(name)
    bar, force = point.error_estimate.get("lateral_force"), point.scalars.get("normal_force")
    return bar / abs(force) if bar is not None and force else None


def whole_of(point: Point, name: str, friction: float) -> float:
    """100 % of a quantity at a load point: full sliding, otherwise the magnitude of the value; 0: there is none."""
    quantity = quantities()[name]
    if quantity.of_friction:
        return quantity.full_sliding(point, friction)
    return abs(value_of(point, name)) if quantity.percent_of else 0.0


def _rubs(model: ModelResult) -> bool:
    """Whether the model has tractions."""
    return any((point.scalars.get("max_traction") or 0.0) > 0 for point in model)


def _is_result(point: Point, name: str) -> bool:
    """A motion found for a force is a result in place of that force."""
    if name in FOUND:
        return point.found(name)
    return not any(force == name and point.found(motion) for motion, (_, force) in FOUND.items())


def reference_of(models: Sequence[ModelResult], order: Iterable[str]) -> ModelResult | None:
    """The first of `order` that is among the models, otherwise the first model."""
    names = {model.name: model for model in reversed(models)}
    return next((names[name] for name in order if name in names), models[0] if models else None)


def _refer(number: Number, base: ModelResult, friction: float) -> None:
    point, name = base[number.point - 1], number.quantity
    value, scale = value_of(point, name), whole_of(point, name, friction)
    if scale > 0 and (value or quantities()[name].of_friction):
        number.reference, number.reference_value, number.scale = base.name, value, scale
        number.reference_error = error_of(point, name) or 0.0


def _numbers_of_patch(models: Sequence[ModelResult], friction: float, references: Sequence[str]) -> Iterator[Number]:
    rubbing = [model for model in models if _rubs(model)]
    bases = {False: reference_of(models, references), True: reference_of(rubbing, references)}
    lateral = any(abs(p.scalars.get("lateral_force") or 0.0) > 1e-4 * abs(p.scalars.get("normal_force") or 0.0)
                  for model in rubbing for p in model)
    for model in models:
        for k, point in enumerate(model):
            for name, quantity in quantities().items():
                with_friction = quantity.of_friction or name in FOUND
                if with_friction and not (model in rubbing and _is_result(point, name)):
                    continue
                value = value_of(point, name)
                if name == "lateral_coefficient" and not lateral or not value and not quantity.of_friction:
                    continue  # exactly 0 in what cannot be 0: the model does not give it
                number = Number(place_label(model.place), model.name, k + 1, point.creepages, name, value, error_of(point, name),
                                point.model_error.get(name))
                base = bases[with_friction]
                if base and base.name not in references[:1] and k < len(base):
                    base = exact_one(models, k, name, error_of(base[k], name) or 0.0) or base
                if base and base is not model and k < len(base):
                    _refer(number, base, friction)
                yield number


def numbers_of(compared: Compared, references: Sequence[str]) -> list[Number]:
    """All numbers of a case, patch by patch, model by model, load point by load point. `references`: in order of preference."""
    patches: dict[str, list[ModelResult]] = {}
    for model in compared.models:
        patches.setdefault(place_label(model.place), []).append(model)
    return [number for models in patches.values() for number in _numbers_of_patch(models, compared.friction, references)]


@dataclass
class Standing:
    """Comparison of a model with the reference in one quantity at one place of one case."""

    patch: str  #: as in Number; also empty for all places together
    model: str
    reference: str
    quantity: str
    compared: int  #: number of compared values
    differ: int  #: number of values that differ by more than the error bars
    worst: Number  #: the largest difference
    beyond: Number  #: the number that exceeds the error bars most


def gathered(all_of: Iterable[Standing]) -> list[Standing]:
    """One standing for each place, model and quantity."""
    found: dict[tuple[str, str, str], Standing] = {}
    for more in all_of:
        one = found.setdefault((more.patch, more.model, more.quantity), more)
        if one is not more:
            one.compared, one.differ = one.compared + more.compared, one.differ + more.differ
            one.worst = max(one.worst, more.worst, key=lambda number: abs(number.difference))
            one.beyond = max(one.beyond, more.beyond, key=lambda number: number.excess)
    return list(found.values())


def standings_of(numbers: Iterable[Number]) -> list[Standing]:
    """The standings of every place."""
    return gathered(Standing(n.patch, n.model, n.reference, n.quantity, 1, int(n.differs), n, n)
                    for n in numbers if n.reference_value is not None)


@dataclass
class CaseStandings:
    """A case with the standings of its models."""

    name: str
    standings: list[Standing]
    seconds: dict[str, float] = field(default_factory=dict)  #: of the models, in their order

    @classmethod
    def of(cls, compared: Compared, references: Sequence[str]) -> "CaseStandings":
        made = cls(compared.name, standings_of(numbers_of(compared, references)))
        for model in compared.models:
            made.seconds[model.name] = made.seconds.get(model.name, 0.0) + model.seconds.get("total", 0.0)
        return made


#: Columns of the table, and the unit of a difference; the files contain more quantities.
COLUMNS = {"max_pressure": ("p0", "%"), "semi_axis_x": ("semi-axis x", "%"), "semi_axis_y": ("semi-axis y", "%"),
           "traction_coefficient": ("-F_x/F_z", "% of mu"), "lateral_coefficient": ("-F_y/F_z", "% of mu"),
           **{name: (symbol, "%") for name, (symbol, _) in FOUND.items()}, "max_traction_x": ("|p_x|", "% of mu p0")}


def _percent(value: float) -> str:
    """With two significant digits."""
    size = abs(100 * value)
    digits = 0 if size >= 9.95 else 1 if size >= 0.995 else 2 if size >= 0.0995 else 3
    return "0" if size < 0.0005 else f"{100 * value:.{digits}f}"


def table(one: CaseStandings) -> str:
    """For the terminal: the largest differences of every model over all places, marked if they exceed the error bars, and the
    seconds."""
    if not one.seconds:
        return ""
    every = {(s.model, s.quantity): s for s in gathered(replace(s, patch="") for s in one.standings)}
    shown = [name for name in COLUMNS if any(quantity == name for _, quantity in every)]
    lines = [f"  {'':<18}" + "".join(f"{COLUMNS[name][row]:>13}" for name in shown) + end
             for row, end in enumerate((f"{'seconds':>10}", ""))]
    for model, seconds in one.seconds.items():
        found = [every.get((model, name)) for name in shown]
        cells = (f"{'-' if s is None else _percent(s.worst.difference):>12}{'*' if s and s.differ else ' '}" for s in found)
        lines.append(f"  {model:<18}{''.join(cells)}{seconds:>10.3g}")
    return "\n".join(lines) + "\n"


def verdict(cases: Sequence[CaseStandings]) -> str:
    """One line: which models agree with the reference within the error bars in every case, and by how much the others exceed
    them. Empty if nothing was compared."""
    within: list[str] = []
    beyond: list[str] = []
    for model in dict.fromkeys(name for case in cases for name in case.seconds):
        of_model = [s for case in cases for s in case.standings if s.model == model and s.quantity in COLUMNS]
        parts = []
        for name, (title, unit) in COLUMNS.items():
            worst = [abs(s.beyond.difference) for s in of_model if s.quantity == name and s.differ]
            parts += [f"{title} {_percent(max(worst))} {unit}"] if worst else []
        if of_model:
            (beyond if parts else within).append(f"{model} ({', '.join(parts)})" if parts else model)
    if not within and not beyond:
        return ""
    references = dict.fromkeys(s.reference for case in cases for s in case.standings)
    return (f"Within the error bars of {', '.join(references)}: {', '.join(within) or 'none'}. "
            f"Beyond them: {', '.join(beyond) or 'none'}.")


@dataclass
class Record:
    """All of a comparison."""

    head: Mapping[str, Any]  #: program, host, started, ...
    models: Sequence[str]  #: as requested
    reference: str  #: as requested; may be empty
    measures: Sequence[str]  #: references of the program, in order of preference
    cases: list[Compared] = field(default_factory=list)

    @property
    def references(self) -> list[str]:
        return [self.reference, *self.measures]

    def standings(self) -> list[CaseStandings]:
        return [CaseStandings.of(compared, self.references) for compared in self.cases]


def text_of(record: Record) -> str:
    """What the program prints: the table of every case with the models that are missing, and the verdict."""
    every, text = record.standings(), ""
    for compared, one in zip(record.cases, every):
        text += f"{compared.name}: {compared.title}\n{table(one)}"
        for model, reason, failed in compared.missing:
            text += f"  {model}: {'failed' if failed else 'left out'}: {reason}\n"
        text += "\n"
    said = verdict(every)
    return text + (f"largest difference at any load point; *: some are beyond the error bars\n{said}\n" if said else "")


def _standing_data(s: Standing) -> dict[str, Any]:
    return {**({"patch": s.patch} if s.patch else {}), "model": s.model, "reference": s.reference, "quantity": s.quantity,
            "compared": s.compared, "differ": s.differ, "largest_difference": s.worst.difference,
            "allowed_there": s.worst.allowed, "point": s.worst.point}


def compare_json(record: Record) -> str:
    """compare.json."""
    headings = {name: {"title": q.title, "symbol": q.symbol, "unit": q.unit, "relative_to": q.percent_of}
                for name, q in quantities().items()}
    every = record.standings()
    cases = [{"name": compared.name, "title": compared.title, "case_file": compared.case_file,
              "complete": bool(compared.models),
              "missing": [dict(zip(("model", "reason", "failed"), missing)) for missing in compared.missing],
              "seconds": one.seconds, "standings": [_standing_data(standing) for standing in one.standings]}
             for compared, one in zip(record.cases, every)]
    return sealed_json({"format": 3, "kind": "compare", **record.head, "models": list(record.models),
                        "reference": record.reference, "measures": list(record.measures), "quantities": headings, "verdict": verdict(every), "cases": cases})


HEAD = ("case,patch,model,point,longitudinal_creepage [-],lateral_creepage [-],spin [rad/mm],quantity,value,error_estimate,"
        "model_error,reference,reference_value,reference_error,scale,difference [%],allowed by error bars [%],differs\n")


def compare_csv(record: Record) -> str:
    """compare.csv: one row per number."""
    text = HEAD
    for compared in record.cases:
        for n in numbers_of(compared, record.references):
            cells: list[Any] = [quoted(compared.name), quoted(n.patch), n.model, n.point, *n.motion, n.quantity, n.value, n.error,
                                n.model_error]
            cells += [None] * 7 if n.reference_value is None else [
                n.reference, n.reference_value, n.reference_error, n.scale, 100 * n.difference, 100 * n.allowed, int(n.differs)]
            text += ",".join(map(cell, cells)) + "\n"
    return text


def compared_models() -> list[str]:
    """Those of `rollfem compare` that this build has."""
    return [name for name, model in known().items() if model["in_compare"] and model["built"]]


def begin_comparison(work: _core.Computation, names: Sequence[str], reference: str) -> Record:
    """A comparison without cases."""
    measures = [name for name, model in known().items() if model["measures_others"]]
    return Record(work.provenance("rollfem::compare"), names, reference, measures)


def comparison_of(record: Record, results: dict[str, Result] | None = None) -> Comparison:
    """The comparison as its files."""
    return Comparison({"compare.json": compare_json(record), "compare.csv": compare_csv(record)},
                      text_of(record), results=results)
