# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving a case, filling a table."""
import warnings
from collections.abc import Callable, Collection
from typing import Any

from . import _core
from .case import Case, CaseLike
from .errors import InputError
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
