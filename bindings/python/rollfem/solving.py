# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving a case."""
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from . import _core
from .case import Case
from .result import Result


class AccuracyWarning(UserWarning):
    """The results are sound but miss the requested accuracy, or the 1 % that `auto` aims for."""


class UnitWarning(UserWarning):
    """A value is allowed but probably in the wrong unit."""


#: Called with a rollfem.Progress; an exception raised by it ends the call.
Told = Callable[[_core.Progress], object] | None


def names_of(model: str | None, models: Any) -> list[str]:
    """The models that `model` and `models` of a call request; empty: those of the case."""
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


def checked(case: Any, sections: dict[str, Any] | None = None, call: str = "") -> Case:
    """A Case of what a call was given, with warnings about its values."""
    made = case if isinstance(case, Case) and not sections else Case.for_call(call, case, sections or {})
    for doubt in made.core.doubts:
        warnings.warn(doubt, UnitWarning, stacklevel=3)
    return made


def solve(case: Any = None, /, *, model: str | None = None, models: Any = None, progress: Told = None,
          **sections: Any) -> Result:
    """Solves a case.

    Other Python threads run meanwhile; Ctrl-C ends it with KeyboardInterrupt.

    Parameters
    ----------
    case : str, os.PathLike, dict or Case, optional
        A case file, a dict of sections, or a case.
    model, models : str or list of str, optional
        Otherwise those of the case, or `auto`.
    progress : callable, optional
        Called with a rollfem.Progress at every iteration; an exception raised by it ends the solution.
    **sections
        Keys that replace those of the case, as of `Case`, but for [table]; None removes a key.

    Returns
    -------
    Result

    Raises
    ------
    FileError
        If the case file, or one that it names, cannot be read.
    InputError
        If the case or the call is wrong.
    SolveError
        If no solution was reached.

    Warns
    -----
    UnitWarning, AccuracyWarning

    Examples
    --------
    >>> result = rollfem.solve("cases/thesis_a.toml", model="halfspace", spin=1e-4)
    """
    names = names_of(model, models)
    case = checked(case, sections, "solve")
    result = Result.of(case, _core.solve(case.core, names, progress, False)[0])
    if result.verdict:
        short = [f"model {each.name}: {each.shortfall}" for each in result.models if each.shortfall]
        warnings.warn(" ".join([result.verdict, *short[:1]]), AccuracyWarning, stacklevel=2)
    return result


@dataclass(frozen=True)
class Forecast:
    """What the model `auto` expects of a contact of the case before anything is solved.

    Attributes
    ----------
    place : dict or None
        Of the patch, with true profiles.
    accuracy : float
        That `auto` looks for.
    sentence : str
        Grid, time and errors of the model that it would choose for the whole case.
    models : list of dict
        model, cannot (why it is out of the question; empty: it is not), model_error, and levels: dicts of
        elements_across, discretisation (both errors as parts of the whole), seconds.
    """

    place: dict[str, Any] | None
    accuracy: float
    sentence: str
    models: list[dict[str, Any]]


def forecast(case: Any = None, /, **sections: Any) -> list[Forecast]:
    """What the model `auto` would choose, and the time it takes, from the size of the contact alone.

    Parameters
    ----------
    case, **sections
        As of `solve`.

    Returns
    -------
    list of Forecast
        One for each contact of the case.

    Raises
    ------
    InputError, SolveError
        As `solve`; nothing is solved but where true profiles touch.

    Examples
    --------
    >>> print(rollfem.forecast("cases/thesis_a.toml")[0].sentence)
    """
    return [Forecast(*each) for each in _core.forecast(checked(case, sections, "forecast").core)]
