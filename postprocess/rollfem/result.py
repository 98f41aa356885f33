# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case."""
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from . import plot
from .errors import InputError
from .frames import Written, documented, forwarded, html_table
from .model import SHOWN, ModelResult, count, heads
from .point import Point, Quantity

if TYPE_CHECKING:
    from ._core import Result as CoreResult
    from .case import Case


@dataclass
class Head:
    """What results.h5 says before the models."""

    provenance: dict[str, Any]
    inputs: dict[str, Any]
    quantities: dict[str, Quantity]
    profiles: dict[tuple[str, int], dict[str, np.ndarray]]


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
    reference: str = ""  # name of the reference model of figures, if the user has chosen one
    default_reference: str = ""  # that of the command, otherwise the best one of the run
    _core: "CoreResult | None" = None
    _head: "Head | None" = None

    kind = "result"
    first_figure = "creep_curve"

    @classmethod
    def of(cls, case: "Case", core: "CoreResult", missing: Sequence[tuple[str, str, bool]] = ()) -> "Result":
        """From results of the library."""
        from . import _core
        rolling = case.data.get("rolling", {})
        models = models_of(_core.models_of(core), rolling.get("problem"), {"longitudinal_force", "lateral_force"} & set(rolling))
        made = cls(case.title, case.file, case.text, models, core.verdict, list(missing), _core=core)
        made.__dict__["case"] = case
        return made

    def __reduce__(self) -> Any:
        return super().__reduce__() if self._core is None else (Result.of, (self.case, self._core, self.missing))

    @cached_property
    def case(self) -> "Case":
        """What was solved."""
        from .case import StoredCase
        return StoredCase(self.case_file, self.title, self.case_text)

    @property
    def head(self) -> Head:
        """What its results.h5 says, or would say, before the models; ImportError without h5py."""
        if self._head is None:
            from . import _core
            from .reader import head_of
            self._head = head_of(_core.head(self._core))
        return self._head

    provenance = forwarded("head.provenance", "Version, commit, host, ... of the run.")
    inputs = forwarded("head.inputs", "The main numbers of the case.")
    quantities = forwarded("head.quantities", "What the numbers are.")
    profiles = forwarded(
        "head.profiles", "By wheel and position rail and wheel [n, 2], y and z on the track (mm).")

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

    @contextmanager
    def _stored(self) -> Iterator[str]:
        """A folder that holds this."""
        if self._core is None:
            yield self.folder
            return
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            self._store(os.path.join(folder, "result"), False)
            yield os.path.join(folder, "result")

    plot_creep_curve = plot.creep_curves

    def __repr__(self) -> str:
        models = ", ".join(f"{m.key} ({count(m.points, 'load point')})" for m in self.models[:6])
        more = f", and {len(self.models) - 6} more" if len(self.models) > 6 else ""
        return f"<rollfem.Result {self.title!r}: {models}{more}>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ["model", "point_index", *heads()],
                          ([model.key, k, *(model.values(name)[k] for name in SHOWN)]
                           for model in self.models for k in range(len(model))))


def models_of(records: Sequence[dict[str, Any]], problem: str | None, prescribed_forces: Any) -> list[ModelResult]:
    """Models from what files or the library say of them; with numbered load points (Point.by_number) where creepages
    repeat, are results, or bodies yield."""
    by_number = "load point" if problem in ("shift", "transient") or prescribed_forces else ""
    if any(point["yielded"] for record in records for point in record["points"]):
        by_number = "pass"
    return [ModelResult(record, by_number) for record in records]


def place_label(place: Mapping[str, Any] | None) -> str:
    """Label of a patch within a run; empty without profiles."""
    if not place:
        return ""
    text = f"{place['wheel']} wheel, position {place['position']}"
    if place["patches"] > 1:
        text += f", patch {place['patch']} of {place['patches']}"
    return text
