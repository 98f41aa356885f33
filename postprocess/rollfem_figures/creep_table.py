"""A table of creep forces that `rollfem table` wrote, as numpy arrays."""
import os
from dataclasses import dataclass

import h5py
import numpy as np

from .reader import ResultError
from .seal import results_are_sound

FORCES = ("longitudinal_force", "lateral_force", "spin_moment")


@dataclass
class CreepTable:
    """Arrays over [axis_ratio or lateral_shift, longitudinal, lateral, spin]; forces over mu F_n, the moment over mu F_n
    sqrt(a b)."""

    about: dict  # title, program, command, started, poisson_ratio, ...
    axes: dict  # in the order of the arrays
    forces: dict
    force_bar: np.ndarray
    moment_bar: np.ndarray
    interpolation: dict
    checked: np.ndarray  # [points, 10]: a/b or mm, xi', eta', phi', F_x, F_y, M_z interpolated, and solved for
    wheels: dict  # of every lateral shift; empty over ratios

    @property
    def first(self):
        """Name of the first axis."""
        return next(iter(self.axes))


def read_table(directory):
    """The table of a folder."""
    path = os.path.join(directory, "table.h5")
    if not results_are_sound(path):
        raise ResultError(f"{path}: is damaged; do: run rollfem table again")
    with h5py.File(path, "r") as file:
        if file.attrs.get("format") != "rollfem table":
            raise ResultError(f"{path}: is no table")
        checked = file["interpolation"]
        first = "lateral_shift" if "lateral_shift" in file["axes"] else "axis_ratio"
        wheel = file.get("wheel", {})
        return CreepTable(
            dict(file.attrs), {name: file["axes"][name][()] for name in (first, "longitudinal", "lateral", "spin")},
            {name: file[name][()] for name in FORCES}, file["force_bar"][()], file["moment_bar"][()],
            dict(checked.attrs), checked["checked"][()] if "checked" in checked else np.zeros((0, 10)),
            {**dict(getattr(wheel, "attrs", {})), **{name: wheel[name][()] for name in wheel}})
