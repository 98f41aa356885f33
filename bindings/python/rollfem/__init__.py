# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rolling contact of wheel and rail, with error bars.

    import rollfem
    result = rollfem.solve("case.toml", model="halfspace")
    result.points[0].max_pressure            # MPa

Units are mm, N, MPa, s, rad. x is the rolling direction, y lateral, z normal and into the wheel; forces and tractions
act on the wheel, and traction_coefficient is -F_x/F_z. `help(rollfem.Point)` lists every quantity with unit and sign.
"""
from . import figures as _figures
from . import wear
from ._core import FileError, InputError, Progress, SolveError
from ._core import models as _models
from ._core import version as _version
from .case import Case
from .model import ModelResult
from .point import FIELDS, QUANTITIES, Point, stress_measures
from .reading import read
from .result import Result
from .solving import AccuracyWarning, UnitWarning, solve, threads
from .studies import Comparison, Stress, Study, compare, stress, study
from .sweeping import Sweep, sweep
from .tables import Table, TableForces, table
from .track import Profile, Wheelset, contact_points, wheelset

__version__ = _version()
models = _models
__all__ = ["AccuracyWarning", "Case", "Comparison", "FIELDS", "FileError", "InputError", "ModelResult", "Point",
           "Profile", "Progress", "QUANTITIES", "Result", "SolveError", "Stress", "Study", "Sweep", "Table", "TableForces",
           "UnitWarning", "Wheelset", "compare", "contact_points", "models", "read", "solve", "stress",
           "stress_measures", "study", "sweep", "table", "threads", "wear", "wheelset"]
