# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the creep force law, written by `rollfem table`."""
import os

import numpy as np

from ._core import CreepTable as _CreepTable
from .result import frame_of


class Table:
    """A table of creep forces, with interpolation between its points.

        table = rollfem.Table("results/thesis_a_table")       # or its table.h5
        force = table.forces(semi_axis_x=4.1, semi_axis_y=9.4, shear_modulus=80769.0, friction_bound=27.5e3,
                             longitudinal_creepage=[0.001, 0.002], spin=1e-4)
        force.longitudinal_force, force.force_bar              # N

        wheel = rollfem.Table("results/s1002_uic60_left_table")       # over lateral shifts
        force = wheel.forces(lateral_shift=1.3, longitudinal_creepage=[0.001, 0.002], spin=1e-4)

    axes: {"axis_ratio" or "lateral_shift", "longitudinal", "lateral", "spin": values}; longitudinal_force,
    lateral_force (over mu F_n), spin_moment (over mu F_n sqrt(a b)), force_bar, moment_bar: arrays over these four
    axes. interpolation: errors at random points between the grid points. Tables over lateral shifts also have
    force_along_normal (over mu F_n) and wheels, {name: array over the shifts}: contact_angle, rolling_radius,
    normal_force, ... (docs/tables.md); otherwise None. Raises rollfem.InputError for a file that is not a table, and
    for a ratio or shift outside the table.
    """

    def __init__(self, path):
        self._core = _CreepTable(os.fspath(path))
        found = self._core.contents()
        self.title, self.case_text, self.poisson_ratio = found["title"], found["case_text"], found["poisson_ratio"]
        first = "lateral_shift" if found["over_shifts"] else "axis_ratio"
        self.axes = dict(zip((first, "longitudinal", "lateral", "spin"), map(np.array, found["axes"])))
        self.interpolation = found["interpolation"]
        shape = tuple(len(values) for values in self.axes.values())
        forces = np.array(found["forces"]).reshape(*shape, 3)
        bars = np.array(found["bars"]).reshape(*shape, 2)
        self.longitudinal_force, self.lateral_force, self.spin_moment = np.moveaxis(forces, -1, 0)
        self.force_bar, self.moment_bar = np.moveaxis(bars, -1, 0)
        self.wheels = self.force_along_normal = self.shear_modulus = self.friction_coefficient = None
        if found["over_shifts"]:
            self.wheels = {name: np.array(values) for name, values in found["wheels"].items()}
            self.force_along_normal = np.array(found["along_normal"]).reshape(shape)
            self.shear_modulus, self.friction_coefficient = found["shear_modulus"], found["friction_coefficient"]

    @property
    def shape(self):
        """Number of values of each axis."""
        return self.force_bar.shape

    def scaled(self, longitudinal=0.0, lateral=0.0, spin=0.0, axis_ratio=None, lateral_shift=None):
        """Forces over mu F_n, the moment over mu F_n sqrt(a b), at scaled creepages xi', eta', phi' (docs/tables.md);
        arguments may be arrays. `axis_ratio` or `lateral_shift` (mm) may be omitted if the table has only one. Returns
        a TableForces."""
        first = next(iter(self.axes))
        given = {"axis_ratio": axis_ratio, "lateral_shift": lateral_shift}
        for name, value in given.items():
            if name != first and value is not None:
                raise ValueError(f"this table is over {first}; do: give that instead of {name}")
        place = given[first]
        if place is None:
            if self.shape[0] != 1:
                raise ValueError(f"this table has several values of {first}; do: give {first}")
            place = self.axes[first][0]
        return self._ask(self._core.scaled, place, longitudinal, lateral, spin)

    def forces(self, *, semi_axis_x=None, semi_axis_y=None, shear_modulus=None, lateral_shift=None, friction_bound=None,
               longitudinal_creepage=0.0, lateral_creepage=0.0, spin=0.0):
        """Forces of friction on the wheel. All arguments may be arrays. Returns a TableForces.

        For an ellipse, in the units of the arguments, which must be consistent (mm, N, MPa or m, N, Pa): semi_axis_x,
        semi_axis_y: along and across rolling; shear_modulus: combined, 1/G = (1/G1 + 1/G2)/2; friction_bound: mu F_n.

        For a wheel, in mm, N and N mm: lateral_shift of the wheelset; friction_bound: mu F_n of all contacts, by
        default that of the table; creepages of the main (most loaded) contact. Forces are in the frame of the main
        contact. The table is valid for the load it was computed with. Between two shifts where contact jumps, the
        nearer one applies, and the bars include the full difference between both.
        """
        ellipse = {"semi_axis_x": semi_axis_x, "semi_axis_y": semi_axis_y, "shear_modulus": shear_modulus}
        creepages = longitudinal_creepage, lateral_creepage, spin
        if self.wheels is None:
            needed = {**ellipse, "friction_bound": friction_bound}
            excess = {"lateral_shift": lateral_shift}
        else:
            needed, excess = {"lateral_shift": lateral_shift}, ellipse
        missing = [name for name, value in needed.items() if value is None]
        wrong = [name for name, value in excess.items() if value is not None]
        if missing or wrong:
            raise TypeError(f"this table is over {next(iter(self.axes))}: it needs {', '.join(needed)}; "
                            f"do: {'give ' + ', '.join(missing) if missing else 'leave out ' + ', '.join(wrong)}")
        if self.wheels is None:
            return self._ask(self._core.physical, *needed.values(), *creepages)
        if friction_bound is None:
            friction_bound = self.friction_coefficient * self.wheel_at(lateral_shift)["normal_force"]
        return self._ask(self._core.of_wheel, lateral_shift, friction_bound, *creepages)

    def wheel_at(self, lateral_shift):
        """{name: number or array} of `wheels` at a lateral shift (mm); jump_after: 1 if contact jumps there. Raises
        rollfem.InputError for a table over axis ratios."""
        shifts = np.asarray(lateral_shift, dtype=float)
        found = self._core.wheels_at(np.ascontiguousarray(shifts).ravel())
        return {name: np.array(values).reshape(shifts.shape)[()] for name, values in found.items()}

    @staticmethod
    def _ask(function, *arguments):
        arrays = np.broadcast_arrays(*(np.asarray(argument, dtype=float) for argument in arguments))
        found = np.array(function(*(np.ascontiguousarray(array).ravel() for array in arrays)))
        return TableForces(*(column.reshape(arrays[0].shape)[()] for column in found))

    def columns(self):
        """{name: array} with one entry per point."""
        grids = np.meshgrid(*self.axes.values(), indexing="ij")
        found = {name: grid.ravel() for name, grid in zip(self.axes, grids)}
        for name in ("longitudinal_force", "lateral_force", "spin_moment", "force_bar", "moment_bar"):
            found[name] = getattr(self, name).ravel()
        if self.force_along_normal is not None:
            found["force_along_normal"] = self.force_along_normal.ravel()
        return found

    def to_dataframe(self):
        """`columns()` as a pandas.DataFrame. ImportError without pandas."""
        return frame_of(self.columns())

    def __repr__(self):
        return f"<rollfem.Table {self.title!r}, {' x '.join(map(str, self.shape))} points>"


class TableForces:
    """Values of a table: longitudinal_force, lateral_force, spin_moment, and the bars force_bar (of the force vector)
    and moment_bar, which add the error bars at the surrounding grid points and the interpolation error not exceeded at
    95 of 100 random points; force_along_normal, 0 for an ellipse. Numbers or arrays."""

    __slots__ = ("longitudinal_force", "lateral_force", "spin_moment", "force_bar", "moment_bar", "force_along_normal")

    def __init__(self, *values):
        for name, value in zip(self.__slots__, values):
            setattr(self, name, value)

    def __repr__(self):
        return f"<rollfem.TableForces {', '.join(f'{name}={getattr(self, name)}' for name in self.__slots__)}>"
