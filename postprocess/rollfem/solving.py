# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls that compute: solving a case, filling a table, refinement studies, comparisons of models, and stresses of stored
results."""
import os
import re
import tempfile
import warnings
from collections.abc import Callable, Collection, Mapping, Sequence
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
from .tables import Table


class AccuracyWarning(UserWarning):
    """The results are sound but miss the requested accuracy, or the 1 % that `auto` aims for."""


class UnitWarning(UserWarning):
    """A value is allowed but probably in the wrong unit."""


#: Called with a rollfem.Progress; an exception raised by it ends the call.
Told = Callable[[_core.Progress], object] | None
#: Names of one or several models; None: those of the case.
Models = str | Collection[str] | None


def names_of(model: str | None, models: Models) -> list[str]:
    """The models that `model` and `models` of a call request; empty: those of the case."""
    if model is not None and models is not None:
        raise InputError("model and models exclude each other; do: give one of them")
    given = model if models is None else models
    if given is None:
        return []
    names: list[Any] = list(given) if isinstance(given, (list, tuple, set)) else [given]
    if not names or not all(isinstance(name, str) for name in names):
        raise InputError(f"models = {given!r}; allowed: a name of a model, or a list of at least one; do: leave it "
                               "out for those of the case")
    return names


def checked(case: CaseLike | None, sections: dict[str, Any] | None = None, call: str = "") -> Case:
    """A Case of what a call was given, with warnings about its values."""
    made = case if isinstance(case, Case) and not sections else Case.for_call(call, case, sections or {})
    for doubt in [*made.core.doubts, *made.core.neglected]:
        warnings.warn(doubt, UnitWarning, stacklevel=3)
    return made


def threads(number: int | None = None) -> int:
    """The threads of a call of this package, at first the caller's alone. Results are the same for any number.

    Args:
        number: The number from now on, 1 to 1024; None leaves it.
    Returns:
        The number of threads.
    Raises:
        InputError: The number is out of range.

    >>> rollfem.threads(8)
    8
    """
    if number is not None:
        if not 1 <= number <= _core.most_threads:
            raise InputError(f"threads({number}): is out of range; allowed: 1 to {_core.most_threads}; "
                                   "do: os.cpu_count() gives the cores of this machine")
        _core.use_threads(number)
    return _core.threads()


def solve(case: CaseLike | None = None, /, *, model: str | None = None, models: Models = None, progress: Told = None,
          **sections: Any) -> Result:
    """Solves a case.

    Other Python threads run meanwhile; Ctrl-C ends it with KeyboardInterrupt.

    Args:
        case: A case file, a dict of sections, or a case.
        model, models: Otherwise those of the case, or `auto`.
        progress: Called with a rollfem.Progress at every iteration; an exception raised by it ends the solution.
        **sections: Keys that replace those of the case, as of `Case`, but for [table]; None removes a key.
    Raises:
        FileError: The case file, or one that it names, cannot be read.
        InputError: The case or the call is wrong.
        SolveError: No solution was reached.
    Warns:
        UnitWarning, AccuracyWarning

    >>> result = rollfem.solve("cases/thesis_a.toml", model="halfspace", spin=1e-4)
    """
    names = names_of(model, models)
    case = checked(case, sections, "solve")
    result = Result.of(case, _core.solve(case.core, names, progress, False)[0])
    if result.verdict:
        short = [f"model {each.name}: {each.shortfall}" for each in result.models if each.shortfall]
        warnings.warn(" ".join([result.verdict, *short[:1]]), AccuracyWarning, stacklevel=2)
    return result


def table(case: CaseLike, /, *, progress: Told = None, **sections: Any) -> Table:
    """Fills a table of creep forces on all cores, as `rollfem table` does; `write` stores it.

    Args:
        case: Its section [table] says over what.
        progress: Called with a rollfem.Progress (point of points) after every part; an exception raised by it ends the
            table.
        **sections: Keys that replace those of the case, as of `Case`.
    Raises:
        InputError: The case is wrong.
        SolveError: A point has no solution.

    >>> table = rollfem.table("cases/thesis_a.toml", table={"axis_ratio": [0.5, 1.0, 2.0]})
    """
    return Table.of(_core.fill_table(checked(case, sections, "table").core, progress))


def in_python(error: InputError) -> InputError:
    """The same error; options of the command line are keywords here."""
    return type(error)(re.sub(r"--([a-z-]+)", lambda match: match[1].replace("-", "_"), str(error)))


def study(case: CaseLike, /, *, model: str | None = None, models: Models = None, vary: str | Sequence[str] = (),
          together: bool = False, levels: int = 0, quantity: str | Sequence[str] = (), reference: str | Sequence[str] = (),
          reference_seconds: float = Wishes.reference_seconds, progress: Told = None) -> Study:
    """Solves a case on successively finer grids, cells, degrees or domains.

    Args:
        case, progress: As of `solve`.
        model, models: Otherwise the half-space; "all": every model that can take the case.
        vary: "grid", "cell", "degree", "domain"; otherwise as the model has it.
        together: Refine all of `vary` at once instead of one at a time.
        levels: 2 to 8; 0: as the model has it.
        quantity: Followed in addition: scalars of a load point, or "max_von_mises_rail" and the like.
        reference: "exact", "finest", "extrapolated" or "QUANTITY=VALUE".
        reference_seconds: Most, in s, that a level beyond the finest, the reference where the levels show no limit, may be
            expected to take; 0: none.
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
        wishes = Wishes(names, listed("vary", vary), together, levels, listed("quantity", quantity), listed("reference", reference),
                        reference_seconds)
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
