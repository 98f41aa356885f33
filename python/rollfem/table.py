"""Tables of the creep force law that `rollfem table` has written."""
import os

import numpy as np

from ._core import CreepTable as _CreepTable
from .result import frame_of


class Table:
    """A table of creep forces, and what it says between its points.

        table = rollfem.Table("results/thesis_a_table")       # or its table.h5
        force = table.forces(semi_axis_x=4.1, semi_axis_y=9.4, shear_modulus=80769.0, friction_bound=27.5e3,
                             longitudinal_creepage=[0.001, 0.002], spin=1e-4)
        force.longitudinal_force, force.force_bar              # N

    axes: {"axis_ratio", "longitudinal", "lateral", "spin": values}; longitudinal_force, lateral_force (over mu F_n),
    spin_moment (over mu F_n sqrt(a b)), force_bar, moment_bar: arrays over these four axes. interpolation: what was
    found at points at random between those of the grid. Raises rollfem.InputError for a file that is no table, and for
    a ratio of axes outside of it.
    """

    def __init__(self, path):
        self._core = _CreepTable(os.fspath(path))
        found = self._core
        self.title, self.case_text, self.poisson_ratio = found.title, found.case_text, found.poisson_ratio
        self.axes = dict(zip(("axis_ratio", "longitudinal", "lateral", "spin"), map(np.array, found.axes)))
        self.interpolation = dict(found.interpolation)
        shape = tuple(len(values) for values in self.axes.values())
        forces = np.array(found.forces).reshape(*shape, 3)
        bars = np.array(found.bars).reshape(*shape, 2)
        self.longitudinal_force, self.lateral_force, self.spin_moment = np.moveaxis(forces, -1, 0)
        self.force_bar, self.moment_bar = np.moveaxis(bars, -1, 0)

    @property
    def shape(self):
        """Number of values of each axis."""
        return self.force_bar.shape

    def scaled(self, longitudinal=0.0, lateral=0.0, spin=0.0, axis_ratio=None):
        """Forces over mu F_n, the moment over mu F_n sqrt(a b), at scaled creepages xi', eta', phi' (docs/tables.md);
        arguments may be arrays. Without `axis_ratio` the only one of the table. Returns a TableForces."""
        if axis_ratio is None:
            if self.shape[0] != 1:
                raise ValueError("this table has several ratios of axes; do: name axis_ratio")
            axis_ratio = self.axes["axis_ratio"][0]
        return self._ask(self._core.scaled, axis_ratio, longitudinal, lateral, spin)

    def forces(self, *, semi_axis_x, semi_axis_y, shear_modulus, friction_bound, longitudinal_creepage=0.0,
               lateral_creepage=0.0, spin=0.0):
        """Forces on the wheel in the units of the arguments, which must be consistent (mm, N, MPa or m, N, Pa).

        semi_axis_x, semi_axis_y: of the ellipse, along rolling and across; shear_modulus: combined, 1/G = (1/G1 +
        1/G2)/2; friction_bound: mu F_n. All may be arrays. Returns a TableForces.
        """
        return self._ask(self._core.physical, semi_axis_x, semi_axis_y, shear_modulus, friction_bound,
                         longitudinal_creepage, lateral_creepage, spin)

    @staticmethod
    def _ask(function, *arguments):
        arrays = np.broadcast_arrays(*(np.asarray(argument, dtype=float) for argument in arguments))
        found = np.array(function(*(np.ascontiguousarray(array).ravel() for array in arrays)))
        return TableForces(*(column.reshape(arrays[0].shape)[()] for column in found))

    def columns(self):
        """{name: array}, one entry for each point."""
        grids = np.meshgrid(*self.axes.values(), indexing="ij")
        found = {name: grid.ravel() for name, grid in zip(self.axes, grids)}
        for name in ("longitudinal_force", "lateral_force", "spin_moment", "force_bar", "moment_bar"):
            found[name] = getattr(self, name).ravel()
        return found

    def to_dataframe(self):
        """`columns()` as a pandas.DataFrame. ImportError without pandas."""
        return frame_of(self.columns())

    def __repr__(self):
        return f"<rollfem.Table {self.title!r}, {' x '.join(map(str, self.shape))} points>"


class TableForces:
    """What a table says: longitudinal_force, lateral_force, spin_moment, and the bars force_bar (of the force vector)
    and moment_bar, which hold the bars of the grid around the point and what 95 of 100 points at random were off by
    interpolation. Numbers or arrays."""

    __slots__ = ("longitudinal_force", "lateral_force", "spin_moment", "force_bar", "moment_bar")

    def __init__(self, *values):
        for name, value in zip(self.__slots__, values):
            setattr(self, name, value)

    def __repr__(self):
        return f"<rollfem.TableForces {', '.join(f'{name}={getattr(self, name)}' for name in self.__slots__)}>"
