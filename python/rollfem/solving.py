# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving a case."""
import warnings

from . import _core
from .case import Case
from .result import Result


class AccuracyWarning(UserWarning):
    """The results are sound but miss the requested accuracy."""


class DoubtWarning(UserWarning):
    """A value is allowed but probably in the wrong unit."""


def names_of(model, models):
    """The models requested by the arguments `model` and `models`; empty: those of the case."""
    if model is not None and models is not None:
        raise _core.InputError("model and models exclude each other; do: give one of them")
    given = model if models is None else models
    if given is None:
        return []
    names = [given] if isinstance(given, str) else list(given) if isinstance(given, (list, tuple, set)) else [given]
    if not names or not all(isinstance(name, str) for name in names):
        raise _core.InputError(f"models = {given!r}; allowed: a name of a model, or a list of at least one; do: leave it "
                               "out for those of the case")
    return names


def solve(case=None, /, *, model=None, models=None, progress=None, **sections):
    """Solves a case and returns a rollfem.Result.

    case: a case file, a dict of sections, or a rollfem.Case; keyword sections (load={...}) replace single keys of the
    case. model, models: one name or several; default: those of the case, or `auto`. progress: called with a
    rollfem.Progress at every iteration; an exception raised by it ends the solution. Other Python threads keep running;
    Ctrl-C raises KeyboardInterrupt.

    Raises rollfem.InputError for an invalid case or call, rollfem.SolveError if there is no solution.
    """
    names = names_of(model, models)
    if not isinstance(case, Case) or sections:
        case = Case(case, **sections)
    for doubt in case.core.doubts:
        warnings.warn(doubt, DoubtWarning, stacklevel=2)
    result = Result.of(case, _core.solve(case.core, names, progress))
    for each in result.models:
        if each.shortfall:
            warnings.warn(f"model {each.name}: {each.shortfall}", AccuracyWarning, stacklevel=2)
    return result
