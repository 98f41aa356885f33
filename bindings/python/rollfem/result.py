# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a case."""
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Annotated, Any

import numpy as np

from . import _core, plot
from .case import Case
from .frames import Written, documented, forwarded, html_table
from .model import HEADS, SHOWN, ModelResult, count
from .point import Point


@documented
class Result(Written):
    """A case and the results of its models: result["halfspace"], or result.models in the order of the run, with true
    profiles one for each patch of each wheel and position."""

    case: Annotated[Case, "what was solved"]
    models: Annotated[list[ModelResult], "in the order of the run"]
    missing: Annotated[list[tuple[str, str, bool]], "model, reason, whether it failed, of the models without a result, in "
                       "comparisons"]
    provenance: Annotated[dict[str, Any], "version, commit, ... of results that were read"]
    folder: Annotated[str, "of results that were read"]
    verdict: Annotated[str, "which contacts miss the accuracy, by how much, and what would help; empty if none does"]

    title: str = forwarded("case.title", "The title of the case.")
    first_figure = "creep_curve"

    def __init__(self, case: Case, models: list[ModelResult], core: _core.Result | None = None,
                 provenance: dict[str, Any] | None = None, folder: str = "",
                 missing: Sequence[tuple[str, str, bool]] = (), verdict: str = "") -> None:
        self.case, self.models, self.folder, self.missing = case, models, folder, list(missing)
        self.provenance = provenance or {}
        self.verdict = verdict if core is None else core.verdict
        self._core = core

    @classmethod
    def of(cls, case: Case, core: _core.Result, missing: Sequence[tuple[str, str, bool]] = ()) -> "Result":
        """From results of the library."""
        return cls(case, [ModelResult(record) for record in _core.models_of(core)], core, missing=missing)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._core is None:
            return Result, (self.case, self.models, None, self.provenance, self.folder, (), self.verdict)
        return Result.of, (self.case, self._core, self.missing)

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

    def _store(self, folder: str, report: bool) -> str:
        if self._core is None:
            raise _core.InputError(f"{folder}: this result was read from {self.folder}; do: copy that folder")
        return _core.write(self._core, folder, report)

    @contextmanager
    def _stored(self) -> Iterator[str]:
        if self._core is None:
            yield self.folder
            return
        with super()._stored() as folder:
            yield folder

    plot_creep_curve = plot.creep_curves

    def __repr__(self) -> str:
        models = ", ".join(f"{m.key} ({count(m.points, 'load point')})" for m in self.models[:6])
        more = f", and {len(self.models) - 6} more" if len(self.models) > 6 else ""
        return f"<rollfem.Result {self.title!r}: {models}{more}>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ["model", "point_index", *HEADS],
                          ([model.key, k, *(model.values(name)[k] for name in SHOWN)]
                           for model in self.models for k in range(len(model))))
