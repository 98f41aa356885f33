# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of creep forces: read and asked."""
import io
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from numpy.typing import ArrayLike

from .errors import FileError
from .files import regular, results_are_sound
from .frames import Labelled, OverAxes, Written, documented, html_table, notes
from .node import hdf5

if TYPE_CHECKING:
    from ._core import CreepTable



@documented
class Table(Written, OverAxes):
    """A table of creep forces, with interpolation between its points (docs/tables.md).

    Args:
        path: The folder that `rollfem table` or `write` has written, or its table.h5.
    Raises:
        FileError: The file is no table.

    >>> table = rollfem.Table("results/thesis_a_table")
    >>> force = table.forces(semi_axis_x=4.1, semi_axis_y=9.4, shear_modulus=80769.0, friction_bound=27.5e3,
    ...                      longitudinal_creepage=[0.001, 0.002], spin=1e-4)
    >>> force.longitudinal_force, force.force_bar              # N
    """

    title: Annotated[str, "of the case"]
    case_text: Annotated[str, "the case file"]
    axes: Annotated[dict[str, np.ndarray], 'values of "load" (N) and "speed" (mm/s) if they have several, "axis_ratio" or '
                    '"lateral_shift" (mm), "longitudinal", "lateral", "spin"; creepages are scaled']
    longitudinal_force: Annotated[np.ndarray, "over mu F_n, over these axes"]
    lateral_force: Annotated[np.ndarray, "over mu F_n"]
    spin_moment: Annotated[np.ndarray, "over mu F_n sqrt(a b)"]
    force_bar: Annotated[np.ndarray, "error bar of the force vector"]
    moment_bar: Annotated[np.ndarray, "error bar of the moment"]
    interpolation: Annotated[dict[str, float], "errors at random points between those of the grid"]
    wheels: Annotated[dict[str, np.ndarray] | None, "of a table over lateral shifts contact_angle, rolling_radius, "
                      "normal_force, ...: arrays over loads, if several, and shifts"]
    force_along_normal: Annotated[np.ndarray | None, "of a table over lateral shifts, over mu F_n"]
    temperature_rise: Annotated[np.ndarray | None, "of a case with heat: largest of the contact by friction, over (mu F_n)^2 "
                                "sqrt(V)/(G beta c^3.5)"]
    heat: Annotated[dict[str, float], "of a case with heat: effusivity (beta, of both bodies), temperature (degC, in contact "
                    "before friction heats it), speed, shear_modulus; else empty"]
    only_for: Annotated[str, 'the falling friction, its speeds, or the layer that the table holds for alone, as for its '
                        'loads; "" for any constant friction']
    poisson_ratio: Annotated[float, "of both bodies"]
    shear_modulus: Annotated[float, "combined, MPa; nan where the table holds for any"]
    friction_coefficient: Annotated[float, "nan where the table holds for any"]
    over: Annotated[str, '"axis_ratio" or "lateral_shift": the axis before the creepages']
    checked: Annotated[np.ndarray, "the random points [n, 12]: ratio or shift, xi', eta', phi', F_x, F_y, M_z interpolated and "
                       "computed, load, speed"]
    about: Annotated[dict[str, Any], "program, command, started, ..."]

    kind = "table"
    first_figure = "table_curves"

    def __init__(self, path: str | os.PathLike[str]) -> None:
        name = os.fspath(path)
        file = os.path.join(name, "table.h5") if os.path.isdir(name) else name
        try:
            if not results_are_sound(file):
                raise FileError(f"{file}: is damaged: its checksum is missing or does not match; do: run rollfem table again")
            with open(file, "rb", opener=regular) as opened:
                self._take(opened.read(), file)
        except FileError:
            raise
        except OSError as error:
            raise FileError(f"{file}: {error.strerror or error}; do: name a table.h5 written by rollfem table") from error

    @classmethod
    def of(cls, core: "CreepTable") -> "Table":
        """A table of the library."""
        made = cls.of_bytes(core.files()["table.h5"])
        made.__dict__["_core"] = core
        return made

    @classmethod
    def of_bytes(cls, data: bytes) -> "Table":
        """The contents of a table.h5."""
        made = cls.__new__(cls)
        made._take(data, "table.h5")
        return made

    def _take(self, data: bytes, name: str) -> None:
        self._data = data
        with hdf5().File(io.BytesIO(data), "r") as file:
            if file.attrs.get("format") != "rollfem table":
                raise FileError(f"{name}: is not a table; do: name a table.h5 written by rollfem table")
            if file.attrs["format_version"] not in (1, 2, 3):
                raise FileError(f"{name}: belongs to another version; do: run rollfem table again")
            try:
                self._read(file)
            except KeyError as error:
                raise FileError(f"{name}: {error.args[0]}; do: run rollfem table again") from error

    def _read(self, file: Any) -> None:
        axes, found = file["axes"], file["interpolation"]
        self.about, self.interpolation = dict(file.attrs), dict(found.attrs)
        self.title, self.poisson_ratio = self.about["title"], float(self.about["poisson_ratio"])
        self.case_text = file["case_text"][()].decode("utf-8", "replace")
        self.over = "lateral_shift" if "lateral_shift" in axes else "axis_ratio"
        several = [name for name in ("load", "speed") if name in axes and len(axes[name]) > 1]
        self.axes = {name: axes[name][()] for name in (*several, self.over, "longitudinal", "lateral", "spin")}
        for name in ("longitudinal_force", "lateral_force", "spin_moment", "force_bar", "moment_bar"):
            setattr(self, name, file[name][()])
        self.checked = found["checked"][()] if "checked" in found else np.zeros((0, 12))
        self.wheels = self.force_along_normal = None
        if self.over == "lateral_shift":
            self.wheels = {name: values[()] for name, values in file["wheel"].items()}
            self.force_along_normal = file["force_along_normal"][()]
        self.heat = {name: float(value) for name, value in file["heat"].attrs.items()} if "heat" in file else {}
        self.temperature_rise = file["temperature_rise"][()] if self.heat else None
        group = file.get("friction" if self.wheels is None else "wheel")
        limits = {} if group is None else dict(group.attrs)
        self.only_for = limits.get("only_for", "")
        self.shear_modulus, self.friction_coefficient = (
            float(limits.get(name, np.nan)) for name in ("shear_modulus", "friction_coefficient"))

    @cached_property
    def _core(self) -> "CreepTable":
        """The table of the library, which interpolates."""
        from . import _core
        with tempfile.TemporaryDirectory() as folder:
            _core.write_files(folder, {"table.h5": self._data})
            return _core.CreepTable(folder)

    def __reduce__(self) -> tuple[Any, ...]:
        return Table.of_bytes, (self._data,)

    def scaled(self, longitudinal: ArrayLike = 0.0, lateral: ArrayLike = 0.0, spin: ArrayLike = 0.0,
               axis_ratio: ArrayLike | None = None, lateral_shift: ArrayLike | None = None,
               load: ArrayLike | None = None, speed: ArrayLike | None = None) -> "TableForces":
        """Forces over mu F_n, the moment over mu F_n sqrt(a b).

        Args:
            longitudinal, lateral, spin: Scaled creepages xi', eta', phi' (docs/tables.md), -.
            axis_ratio, lateral_shift: The one that the table is over (-, mm); otherwise its only value.
            load, speed: N and mm/s of the axes; otherwise their only values.
        Raises:
            InputError: A ratio, shift, load or speed is outside of the table.
            ValueError: The table has several ratios or shifts and none is given.

        >>> table.scaled(longitudinal=0.5, axis_ratio=2.0).longitudinal_force
        """
        first = self.over
        given = {"axis_ratio": axis_ratio, "lateral_shift": lateral_shift}
        for name, value in given.items():
            if name != first and value is not None:
                raise ValueError(f"this table is over {first}; do: name that in place of {name}")
        place = given[first]
        if place is None:
            if len(self.axes[first]) != 1:
                raise ValueError(f"this table has several values of {first}; do: name {first}")
            place = self.axes[first][0]
        return self._forces(self._core.scaled, place, load, speed, longitudinal, lateral, spin)

    def forces(self, *, semi_axis_x: ArrayLike | None = None, semi_axis_y: ArrayLike | None = None,
               shear_modulus: ArrayLike | None = None, lateral_shift: ArrayLike | None = None,
               load: ArrayLike | None = None, speed: ArrayLike | None = None,
               friction_bound: ArrayLike | None = None, longitudinal_creepage: ArrayLike = 0.0,
               lateral_creepage: ArrayLike = 0.0, spin: ArrayLike = 0.0) -> "TableForces":
        """Forces of friction on the wheel.

        Args:
            semi_axis_x, semi_axis_y, shear_modulus: Of an ellipse: along rolling and across; combined, 1/G = (1/G1 +
                1/G2)/2; in consistent units (mm, N, MPa or m, N, Pa; with `only_for` mm, N, MPa).
            lateral_shift: Of the wheelset, mm, for a table over shifts.
            load: N, of a table over shifts that has several. That of an ellipse follows from friction_bound.
            speed: mm/s, of a table that has several; of temperatures otherwise that of the table's case.
            friction_bound: mu F_n; of a wheel that of all contacts, N, otherwise that of the table; no other with
                `only_for`.
            longitudinal_creepage, lateral_creepage, spin: Of the ellipse, or of the main contact, the most loaded one, in
                whose frame the forces are (-, -, 1/mm). Between two shifts where contact jumps the nearer one is taken, and
                the bars hold all by which they differ.
        Raises:
            InputError: Values are outside of the table; with `only_for` also creepages beyond its end.
            TypeError: What the table needs is missing, or what it does not know is given.

        >>> wheel = rollfem.Table("results/s1002_uic60_left_table")
        >>> wheel.forces(lateral_shift=1.3, longitudinal_creepage=[0.001, 0.002]).longitudinal_force
        """
        ellipse = {"semi_axis_x": semi_axis_x, "semi_axis_y": semi_axis_y, "shear_modulus": shear_modulus}
        creepages = longitudinal_creepage, lateral_creepage, spin
        if self.wheels is None:
            needed: dict[str, Any] = {**ellipse, "friction_bound": friction_bound}
            excess: dict[str, Any] = {"lateral_shift": lateral_shift, "load": load}
        else:
            needed, excess = {"lateral_shift": lateral_shift}, ellipse
        missing = [name for name, value in needed.items() if value is None]
        wrong = [name for name, value in excess.items() if value is not None]
        if missing or wrong:
            raise TypeError(f"this table is over {self.over}: it needs {', '.join(needed)}; "
                            f"do: {'give ' + ', '.join(missing) if missing else 'leave out ' + ', '.join(wrong)}")
        if self.wheels is None:
            return self._forces(self._core.physical, *needed.values(), speed, *creepages)
        if friction_bound is None:
            friction_bound = self.friction_coefficient * self.wheel_at(needed["lateral_shift"], load)["normal_force"]
        return self._forces(self._core.of_wheel, *needed.values(), load, speed, friction_bound, *creepages)

    def wheel_at(self, lateral_shift: ArrayLike, load: ArrayLike | None = None) -> dict[str, Any]:
        """The contact of the wheel at any shift.

        Args:
            lateral_shift: mm.
            load: N, of a table that has several.
        Returns:
            Numbers or arrays by name as `wheels`; jump_after: 1 where contact jumps there.
        Raises:
            InputError: For a table over ratios of axes.

        >>> wheel.wheel_at(1.3)["contact_angle"]
        """
        found, shape = _ask(self._core.wheels_at, lateral_shift, load)
        return {name: np.array(values).reshape(shape)[()] for name, values in found.items()}

    @staticmethod
    def _forces(function: Callable[..., Any], *arguments: ArrayLike | None) -> "TableForces":
        found, shape = _ask(function, *arguments)
        return TableForces(*(np.array(column).reshape(shape)[()] for column in found))

    def columns(self) -> dict[str, np.ndarray]:
        """All points.

        Returns:
            Arrays by name, one entry for each point.

        >>> table.columns()["longitudinal_force"]
        """
        return {**self._places(), **{name: values.ravel() for name in notes(TableForces)
                                     if (values := getattr(self, name)) is not None}}

    def _labelled(self) -> Labelled:
        return self._over_axes(self.columns(), lambda name: "1", {"title": self.title})

    def _contents(self) -> dict[str, bytes]:
        return self._core.files()

    def __repr__(self) -> str:
        return f"<rollfem.Table {self.title!r}, {' x '.join(map(str, self.shape))} points>"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ["axis", "values", "from", "to"], (
            [name, len(values), float(values[0]), float(values[-1])] for name, values in self.axes.items()))


def _ask(function: Callable[..., Any], *arguments: ArrayLike | None) -> tuple[Any, tuple[int, ...]]:
    """What the library says to arrays of numbers, and their common shape; None: 0, the only value of an axis."""
    arrays = np.broadcast_arrays(*(np.asarray(0.0 if each is None else each, dtype=float) for each in arguments))
    return function(*(array.ravel() for array in arrays)), arrays[0].shape


@documented
@dataclass(eq=False, slots=True)
class TableForces:
    """What a table says: numbers or arrays. The bars hold those of the grid around the point and what 95 of 100 points at
    random were off by interpolation."""

    longitudinal_force: Annotated[Any, "on the wheel along rolling"]
    lateral_force: Annotated[Any, "across"]
    spin_moment: Annotated[Any, "about the normal"]
    force_bar: Annotated[Any, "error bar of the force vector"]
    moment_bar: Annotated[Any, "error bar of the moment"]
    force_along_normal: Annotated[Any, "along the main normal; 0 of an ellipse"]
    temperature_rise: Annotated[Any, "largest rise of the temperature in contact by friction, K; nan without heat"]

    def __repr__(self) -> str:
        with np.printoptions(threshold=6, edgeitems=2, precision=6):
            return f"<rollfem.TableForces {', '.join(f'{name}={getattr(self, name)}' for name in notes(TableForces))}>"
