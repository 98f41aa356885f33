# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rolling contact of wheel and rail, with error bars.

    import rollfem
    result = rollfem.solve("case.toml", model="halfspace")
    result.points[0].max_pressure            # MPa

Units are mm, N, MPa, s, rad. x is the rolling direction, y lateral, z normal and into the wheel; forces and tractions
act on the wheel, and traction_coefficient is -F_x/F_z. `help(rollfem.Point)` lists every quantity with unit and sign.
"""
from ._core import InputError, Progress, SolveError
from ._core import models as _models
from ._core import version as _version
from .case import Case
from .reading import read
from .result import FIELDS, QUANTITIES, ModelResult, Point, Result, stress_measures
from .solving import AccuracyWarning, DoubtWarning, solve
from .sweeping import Sweep, sweep
from .table import Table, TableForces

__version__ = _version()
models = _models
__all__ = ["AccuracyWarning", "Case", "DoubtWarning", "FIELDS", "InputError", "ModelResult", "Point", "Progress",
           "QUANTITIES", "Result", "SolveError", "Sweep", "Table", "TableForces", "models", "read", "solve", "stress_measures",
           "sweep"]
