# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refinement studies, comparisons of models, and stresses of stored results: what the commands of these names compute."""
import os
import re
import tempfile
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from . import _core
from .case import Case, CaseLike, toml_lines
from .commands.comparing import Compared, begin_comparison, compared_models, comparison_of
from .commands.levels import Study as Refined
from .commands.levels import Wishes, study_of
from .commands.subsurface import Wanted, stored_at, stress_of
from .errors import InputError
from .outputs import Comparison, Stress, Study
from .result import Result
from .solving import Models, Told, checked, names_of

def in_python(error: InputError) -> InputError:
    """The same error; options of the command line are keywords here."""
    return type(error)(re.sub(r"--([a-z-]+)", lambda match: match[1].replace("-", "_"), str(error)))


def study(case: CaseLike, /, *, model: str | None = None, models: Models = None, vary: str | Sequence[str] = (),
          together: bool = False, levels: int = 0, reference: str | Sequence[str] = (), progress: Told = None) -> Study:
    """Solves a case on successively finer grids, cells, degrees or domains.

    Args:
        case, progress: As of `solve`.
        model, models: Otherwise the half-space; "all": every model that can take the case.
        vary: "grid", "cell", "degree", "domain"; otherwise as the model has it.
        together: Refine all of `vary` at once instead of one at a time.
        levels: 2 to 8; 0: as the model has it.
        reference: "exact", "finest", "extrapolated" or "QUANTITY=VALUE".
    Raises:
        InputError: The case or the call is wrong.
        SolveError: No level was solved; levels that fail beside others are a warning.

    >>> print(rollfem.study("cases/thesis_a.toml", levels=3).text)
    """
    def listed(name: str, words: str | Sequence[str]) -> list[str]:
        found: list[Any] = list(words) if isinstance(words, (list, tuple, set)) else [words]
        if not all(isinstance(word, str) for word in found):
            raise InputError(f"study: {name} = {words!r}: allowed: a word or a list of words")
        return found

    if not hasattr(levels, "__index__") or abs(levels) >= 2**31:
        raise InputError(f"study: levels = {levels!r}: allowed: a whole number")
    names = names_of(model, models)
    if names != ["all"]:
        names = _core.checked_names(names, "models")
    core = checked(case).core
    try:
        wishes = Wishes(names, listed("vary", vary), together, levels, listed("reference", reference))
        wishes.check(core)
        work = _core.Computation(wishes.named(), progress)
        made = Refined(wishes, core, work)
        work.compute("models", "", made.solve)
    except InputError as error:
        raise in_python(error) from None
    if failures := made.finish():
        warnings.warn(f"levels that failed: {failures}", stacklevel=2)
    return study_of(made.record)


def compare(cases: CaseLike | Sequence[CaseLike], /, *, models: Models = None, reference: str = "",
            progress: Told = None) -> Comparison:
    """Solves cases with several models, and lays their numbers side by side.

    A model that cannot take a case, or fails, is listed in the `missing` of its result.

    Args:
        cases: One or several; a dict {name: case} gives them names.
        models: Otherwise those of `rollfem compare`.
        reference: The model that the others are compared with; otherwise the best there is.
        progress: As of `solve`.
    Raises:
        InputError: A case or the call is wrong.

    >>> print(rollfem.compare("cases/thesis_a.toml", models=["fastsim", "halfspace"]).text)
    """
    names = names_of(None, models) or compared_models()
    if reference and reference not in names:
        raise InputError(f"reference = {reference!r}: it is not among the models compared; allowed: {', '.join(names)}")
    results: dict[str, Result] = {}
    record = begin_comparison(_core.Computation(names, None), names, reference)
    for name, each in _named(cases):
        case = checked(each)
        found = results[name] = Result.of(case, *_core.solve(case.core, names, progress, True))
        record.cases.append(Compared(name, case.title, case.core.file, case.core.friction_coefficient, found.models,
                                               found.missing))
    return comparison_of(record, results)


def _named(cases: CaseLike | Sequence[CaseLike]) -> list[tuple[str, Any]]:
    """(name, case) of what a call was given: a dict whose values are sections is one case."""
    if isinstance(cases, dict) and all(isinstance(each, (str, os.PathLike, Case)) for each in cases.values()):
        return list(cases.items())
    found: list[tuple[str, Any]] = []
    for number, each in enumerate(cases if isinstance(cases, (list, tuple)) else [cases], 1):
        file = each.file if isinstance(each, Case) else each if isinstance(each, (str, os.PathLike)) else ""
        found.append((os.path.splitext(os.path.basename(file))[0] or f"case_{number}", each))
    if len({name for name, _ in found}) < len(found):
        raise InputError("cases: two have the same name; do: give a dict of names and cases")
    return found


def stress(result: Result | str | os.PathLike[str], /, *, places: Mapping[str, Any] | str | os.PathLike[str] | None = None,
           model: str | None = None, models: Models = None, patch: str = "", point_index: int | Sequence[int] = (),
           depth_profile: bool = False, depth: float | None = None, yield_shear_stress: float | None = None,
           yield_strength: float | None = None) -> Stress:
    """Stress and displacement below the surface, without solving again.

    Args:
        result: A result, or the folder of a stored one.
        places: {"line": [{"body": "rail", "from": [0, 0, 0], "to": [0, 0, -10], "points": 50}]}, with the keys of
            [[subsurface.*]] of a case, or a file that holds these; otherwise depth profiles under the patch.
        model, models: Otherwise those with stress.
        patch: "left,1,1": side, position and patch, with true profiles; otherwise the first.
        point_index: Load points, from 0; otherwise the last.
        depth_profile: Depth profiles also where places are given.
        depth: mm, of depth profiles; otherwise three times the smaller semi-axis.
        yield_shear_stress, yield_strength: MPa; one of them, for the shakedown map.
    Raises:
        FileError: The result cannot be read.
        InputError: What is asked for is not stored.

    >>> below = rollfem.stress("results/thesis_a", yield_strength=520.0)
    >>> below.models[0].sets[0]["von_mises"].max()
    """
    points = [int(number) + 1 for number in np.atleast_1d(np.asarray(point_index, dtype=int))]
    name = (result.folder or "this result") if isinstance(result, Result) else os.fspath(result)
    wanted = Wanted(name, names_of(model, models), patch, points, (), "" if places is None or isinstance(places, Mapping)
                    else os.fspath(places), depth_profile, depth, yield_shear_stress, yield_strength)
    stored, file = (result, os.path.join(result.folder, "results.h5") if result.folder else name) if isinstance(
        result, Result) else stored_at(name)
    try:
        if isinstance(places, Mapping):
            with tempfile.TemporaryDirectory() as here:
                wanted = replace(wanted, places=os.path.join(here, "places"))
                with open(wanted.places, "w", encoding="utf-8") as out:
                    out.write("\n".join(toml_lines({"subsurface": places})))
                found, said = stress_of(stored, wanted, file)
        else:
            found, said = stress_of(stored, wanted, file)
    except InputError as error:
        raise in_python(error) from None
    for warning in said:
        warnings.warn(warning, stacklevel=2)
    return found
