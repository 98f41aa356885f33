# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case."""
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from . import plot
from .errors import InputError
from .frames import Written, documented, html_table
from .model import SHOWN, ModelResult, count, heads
from .node import Node
from .point import Point, Quantity

if TYPE_CHECKING:
    from ._core import Result as CoreResult
    from .case import Case


@documented
@dataclass(eq=False, repr=False)
class Result(Written):
    """A case and the results of its models: result["halfspace"], or result.models in the order of the run, with true
    profiles one for each patch of each wheel and position."""

    title: Annotated[str, "the title of the case"]
    case_file: Annotated[str, "the case file"]
    case_text: Annotated[str, "the case as TOML"]
    models: Annotated[list[ModelResult], "in the order of the run"]
    verdict: Annotated[str, "which contacts miss the accuracy, by how much, and what would help; empty if none does"] = ""
    missing: Annotated[list[tuple[str, str, bool]], "model, reason, whether it failed, of the models without a result, in "
                       "comparisons"] = field(default_factory=list)
    folder: Annotated[str, "of results that were read"] = ""
    provenance: Annotated[dict[str, Any], "version, commit, host, started, command, processes"] = field(default_factory=dict)
    inputs: Annotated[dict[str, Any], "the keys of the case that it gives or that have a default, by path: "
                      "\"wheel.rolling_radius\"; lists are arrays"] = field(default_factory=dict)
    friction_law: Annotated[np.ndarray | None, "[n, 2] where friction falls: slip velocity (mm/s; in a shift slip in mm), "
                            "coefficient"] = None
    quantities: Annotated[dict[str, Quantity], "what the numbers are"] = field(default_factory=dict)
    profiles: Annotated[dict[tuple[str, int], dict[str, np.ndarray]], "by wheel and position rail and wheel [n, 2], y and z "
                        "on the track (mm)"] = field(default_factory=dict)
    reference: str = ""  # name of the reference model of figures, if the user has chosen one
    default_reference: str = ""  # that of the command, otherwise the best one of the run
    _core: "CoreResult | None" = None

    kind = "result"
    first_figure = "creep_curve"

    @classmethod
    def of(cls, case: "Case", core: "CoreResult", missing: Sequence[tuple[str, str, bool]] = ()) -> "Result":
        """From results of the library."""
        from . import _core
        made = cls.made_of(Node.of(_core.contents_of(core)), missing=list(missing), _core=core)
        made.case_file, made.__dict__["case"] = case.file, case
        return made

    @classmethod
    def made_of(cls, root: Node, **others: Any) -> "Result":
        """From what a file or the library holds."""
        case, about, none = root.parts["case"], root.attributes, Node({}, {}, {})
        keys = case.parts.get("keys", none)
        columns = [root.parts["quantities"].entries[n] for n in ("name", "title", "symbol", "unit", "meaning", "percent_of")]
        pairs = root.parts["profiles"].parts.values() if "profiles" in root.parts else ()
        made = cls(case.attributes["title"], case.attributes["file"], case.entries["text"], [], about.get("verdict", ""),
                   provenance=root.parts["provenance"].attributes, inputs={**keys.attributes, **keys.entries},
                   friction_law=case.entries.get("friction_law"),
                   quantities={name: Quantity(*row) for name, *row in zip(*columns)},
                   profiles={(pair.attributes["wheel"], pair.attributes["position"]): dict(pair.entries) for pair in pairs}, **others)
        models = sorted(root.parts["models"].parts.items(), key=lambda item: int(item[1].attributes["order"]))
        by_number = "load point" if made.inputs.get("rolling.problem") in ("shift", "transient") or made.prescribed_forces else ""
        if any("yielded" in point.parts for _, model in models for point in model.parts["points"].parts.values()):
            by_number = "pass"
        made.models = [ModelResult(key, model, by_number) for key, model in models]
        return made

    @property
    def prescribed_forces(self) -> bool:
        """Whether creepages (shifts) were found for prescribed forces."""
        return not {"rolling.longitudinal_force", "rolling.lateral_force"}.isdisjoint(self.inputs)

    @property
    def friction_coefficient(self) -> float:
        """At rest; the largest where it varies."""
        return float(np.max(self.inputs["friction.coefficient"]))

    @property
    def slip_speed(self) -> float:
        """Slip velocity over slip, mm/s: the rolling speed; a shift has none, its slip in mm is taken as that of a second."""
        return 1.0 if self.inputs["rolling.problem"] == "shift" else float(self.inputs["rolling.speed"])

    def __reduce__(self) -> Any:
        return super().__reduce__() if self._core is None else (Result.of, (self.case, self._core, self.missing))

    @cached_property
    def case(self) -> "Case":
        """What was solved."""
        from .case import StoredCase
        return StoredCase(self.case_file, self.title, self.case_text)

    def __getitem__(self, key: str | int) -> ModelResult:
        """A model by its key, or the first of that name; or by number."""
        if isinstance(key, int):
            return self.models[key]
        for model in [*(m for m in self.models if m.key == key), *(m for m in self.models if m.name == key)]:
            return model
        raise KeyError(f"{key}: this result has {', '.join(model.key for model in self.models)}")

    def __iter__(self) -> Iterator[ModelResult]:
        return iter(self.models)

    def __len__(self) -> int:
        return len(self.models)

    @property
    def points(self) -> list[Point]:
        """Load points of the only model; ValueError where there are several results."""
        if len(self.models) != 1:
            raise ValueError(f"this result has {', '.join(model.key for model in self.models)}; do: take one, as in "
                             f"result[{self.models[0].key!r}].points" if self.models else "there is no model")
        return self.models[0].points

    def columns(self) -> dict[str, np.ndarray]:
        """All numbers over models and load points.

        Returns:
            Arrays by name: model, key and point_index (from 0, as result[...].points has them; `point` of files counts from
            1), with true profiles those of the place, then the quantities and their bars.

        >>> result.columns()["point_index"]
        """
        parts: list[dict[str, Any]] = [
            {"model": model.name, "key": model.key, "point_index": np.arange(len(model)), **(model.place or {}),
             **model.columns()} for model in self.models]
        return {name: np.concatenate([np.broadcast_to(part.get(name, np.nan), len(model))
                                      for part, model in zip(parts, self.models)])
                for name in dict.fromkeys(name for part in parts for name in part)}

    def scenes(self) -> list[tuple[str, "Result"]]:
        """The results of every patch.

        Returns:
            Label and Result in the order of the run; "" and itself without profiles.

        >>> [label for label, _ in result.scenes()]
        """
        found: dict[str, list[ModelResult]] = {}
        for model in self.models:
            found.setdefault(place_label(model.place), []).append(model)
        if list(found) == [""]:
            return [("", self)]
        return [(label, replace(self, models=models)) for label, models in found.items()]

    def _store(self, folder: str, report: bool) -> str:
        if self._core is None:
            raise InputError(f"{folder}: this result was read from {self.folder}; do: copy that folder")
        from . import _core
        return _core.write(self._core, folder, report)

    plot_creep_curve = plot.creep_curves

    def __repr__(self) -> str:
        models = ", ".join(f"{m.key} ({count(m.points, 'load point')})" for m in self.models[:6])
        more = f", and {len(self.models) - 6} more" if len(self.models) > 6 else ""
        return f"<rollfem.Result {self.title!r}: {models}{more}>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ["model", "point_index", *heads()],
                          ([model.key, k, *(model.values(name)[k] for name in SHOWN)]
                           for model in self.models for k in range(len(model))))


def models_of(core: "CoreResult") -> list[ModelResult]:
    """The models of a result of the library."""
    from . import _core
    return Result.made_of(Node.of(_core.contents_of(core))).models


def place_label(place: Mapping[str, Any] | None) -> str:
    """Label of a patch within a run; empty without profiles."""
    if not place:
        return ""
    text = f"{place['wheel']} wheel, position {place['position']}"
    if place["patches"] > 1:
        text += f", patch {place['patch']} of {place['patches']}"
    return text
