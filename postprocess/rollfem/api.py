# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of the package that users call."""
from . import wear
from ._core import Progress, models
from ._core import version as _version
from .case import Case
from .errors import FileError, InputError, SolveError
from .outputs import Comparison, Stress, Study
from .point import FIELDS, QUANTITIES, Point, attributes, text_of
from .reader import read
from .result import ModelResult, Note, Result
from .solving import AccuracyWarning, UnitWarning, compare, solve, stress, study, table, threads
from .stresses import stress_measures
from .sweeping import Sweep, sweep
from .tables import Table, TableForces
from .track import Profile, Wheelset, contact_points, wheelset

__version__ = _version()
__all__ = ["AccuracyWarning", "Case", "Comparison", "FIELDS", "FileError", "InputError", "ModelResult", "Note", "Point",
           "Profile", "Progress", "QUANTITIES", "Result", "SolveError", "Stress", "Study", "Sweep", "Table", "TableForces",
           "UnitWarning", "Wheelset", "compare", "contact_points", "models", "read", "solve", "stress",
           "stress_measures", "study", "sweep", "table", "threads", "wear", "wheelset"]

attributes(Point, lambda self, name: self.scalars.get(name), {name: text_of(name) for name in QUANTITIES})
attributes(Point, lambda self, name: self.fields.get(name),
           {name: f"[ny, nx], {field.unit}: {field.description}{'; ' * bool(field.sign)}{field.sign}"
            for name, field in FIELDS.items()})
# The seconds of a model are those of its stages.
attributes(ModelResult, ModelResult.values,
           {name: f"Over load points. {text_of(name)}" for name in QUANTITIES if name != "seconds"})
