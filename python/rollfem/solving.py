"""Solving a case."""
import warnings

from . import _core
from .case import Case
from .result import Result


class AccuracyWarning(UserWarning):
    """The results are sound, but the accuracy that the case asks for was not reached."""


class DoubtWarning(UserWarning):
    """A value is allowed but probably in the wrong unit."""


def names_of(model, models):
    """The models that `model` and `models` of a call request; empty: those of the case."""
    if model is not None and models is not None:
        raise _core.InputError("model and models are both given; do: give one of them")
    given = model if models is None else models
    return [] if given is None else [given] if isinstance(given, str) else list(given)


def solve(case=None, /, *, model=None, models=None, progress=None, **sections):
    """Solves a case and returns a rollfem.Result.

    case: a case file, a dict of sections, or a rollfem.Case; sections may also be keywords (load={...}), which replace
    single keys of the case. model, models: a name, or several; otherwise those of the case, or `auto`. progress: called
    with a rollfem.Progress at every iteration; an exception raised by it ends the solution. Other Python threads run
    meanwhile; Ctrl-C ends it with KeyboardInterrupt.

    Raises rollfem.InputError for a case or call that is wrong, rollfem.SolveError where no solution was reached.
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
