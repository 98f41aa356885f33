# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles, and where rigid wheels touch their rails: nothing is solved here."""
import io
import os
from html import escape
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from . import _core, plot
from .case import Case, CaseLike
from .errors import InputError
from .frames import InFile, Tabular, documented, html_table, listed
from .solving import checked


class Wheelset(Tabular):
    """A rigid wheelset over its lateral shift, from the middle to the right; the other side is the mirror image. For
    conicities and the wavelength the shift is the amplitude; nan where there are none."""

    def __init__(self, title: str, columns: dict[str, np.ndarray]) -> None:
        self.title, self._columns = title, tuple(columns)
        self.__dict__.update(columns)

    if TYPE_CHECKING:
        def __getattr__(self, name: str) -> np.ndarray: ...

    def figure(self) -> Any:
        """The figure of `rollfem wheelset`: radii, angles, conicity, wavelength.

        Returns:
            Figure: Notebooks show it; `figure.save("wheelset.svg")` writes it.

        >>> rollfem.wheelset("cases/manchester_A22.toml").figure()
        """
        from .figures.positions import draw_wheelset
        return draw_wheelset(self.columns())

    def __repr__(self) -> str:
        return f"<rollfem.Wheelset {self.title!r}, lateral shift 0 to {self.lateral_shift[-1]:.4g} mm>"

    def _repr_html_(self) -> str:
        step = max(1, round(1.0 / (self.lateral_shift[1] - self.lateral_shift[0])))
        shown = {name: unit for name, (unit, _) in _core.wheelset_columns().items() if name.split("_")[0] not in ("roll", "y")}
        return html_table(repr(self), [f"{name} ({unit})" for name, unit in shown.items()],
                          zip(*(getattr(self, name)[::step] for name in shown)))


listed(Wheelset, {f"{name} (numpy.ndarray)": f"{unit}; {meaning}"
                  for name, (unit, meaning) in _core.wheelset_columns().items()})


def wheelset(case: CaseLike, /, reach: float = 10.0, step: float = 0.1, **sections: Any) -> Wheelset:
    """Rolling radii, contact angles and equivalent conicity of the rigid wheelset of a case.

    Args:
        case: With profiles of wheel and rail.
        reach: Largest lateral shift, 0.2 to 30 mm; the table ends earlier where a wheel leaves its rail.
        step: mm; EN 15302 asks for 0.2 at most.
        **sections: Keys that replace those of the case, as of `Case`.
    Raises:
        InputError: The case has no profiles, or reach or step are out of bounds.
        SolveError: The wheelset does not stand on the track.

    >>> found = rollfem.wheelset("cases/manchester_A22.toml")
    >>> numpy.interp(3.0, found.lateral_shift, found.conicity_wave)
    """
    if not (0.2 <= reach <= 30.0 and 0.001 <= step <= 0.5 * reach):
        raise InputError(f"wheelset(reach={reach!r}, step={step!r}): allowed: reach 0.2 to 30 mm, step 0.001 mm to half "
                               "of it; do: give values in these ranges")
    case = checked(case, sections, "wheelset")
    return Wheelset(case.title, _core.wheelset(case.core, reach, step))


def contact_points(case: CaseLike, /, **sections: Any) -> list[dict[str, Any]]:
    """Where the wheels of a case touch their rails.

    Args:
        case: With profiles of wheel and rail.
        **sections: Keys that replace those of the case, as of `Case`.
    Returns:
        As ModelResult.place: wheel, position, patch (from 1, the most loaded first; 0: a near miss, at most 1 mm off),
        y_track, y_rail, y_wheel, rolling_radius, separation (mm), contact_angle (rad), ...
    Raises:
        InputError: The case has no profiles.
        SolveError: A wheel has left its rail.

    >>> [place["contact_angle"] for place in rollfem.contact_points(case, lateral_shift=3.0)]
    """
    return _core.contact_points(checked(case, sections, "contact_points").core)


@documented
class Profile(Tabular, InFile):
    """A profile of wheel or rail as one curve: y towards the field side, z down, both in mm.

    Args:
        source: A file (two columns, or a format of docs/profiles.md) or a built-in profile ("S1002").
        body: "wheel" or "rail"; otherwise the ending of the file or the built-in profile says it.
        **mend: Keys of [wheel_profile] or [rail_profile] of a case (docs/profiles.md): smoothing=0.01, shift=[-70, 0],
            flip=True, unit="inch", ...
    Raises:
        FileError: The file cannot be read.
        InputError: It has faults that no key mends, or a key is wrong.

    >>> worn = rollfem.Profile("worn.csv", "rail", smoothing=0.01)
    >>> worn.smallest_convex_radius
    """

    s: Annotated[np.ndarray, "along the profile, mm, every tenth of a millimetre; two rows where the curvature jumps"]
    y: Annotated[np.ndarray, "mm"]
    z: Annotated[np.ndarray, "mm"]
    angle: Annotated[np.ndarray, "of the tangent from y to z, degrees"]
    curvature: Annotated[np.ndarray, "1/mm, positive where the curve turns towards +z"]
    length: Annotated[float, "mm"]
    gauge_face: Annotated[float | None, "y in mm, 14 mm below the top of a rail, or of a wheel's flange at z = 10"]
    flange_tip: Annotated[float | None, "y in mm of the tip of the flange"]
    smallest_convex_radius: Annotated[float, "mm, as seen from outside of the body"]
    smallest_hollow_radius: Annotated[float, "mm, as seen from outside of the body"]
    joints: Annotated[list[float], "y in mm where the radius jumps"]
    points: Annotated[int, "of a file, after mending"]
    smoothing: Annotated[dict[str, float] | None, "scatter of the points of a file, rms and largest distance from the curve, mm"]
    _columns = ("s", "y", "z", "angle", "curvature")
    kind: Annotated[str, '"built in", "arcs", "polynomial", "file" or "radius"']

    def __init__(self, source: str | os.PathLike[str], body: str | None = None, **mend: Any) -> None:
        name = os.fspath(source)
        if body is None:
            body = _core.body_of_profile(name)
        body = _body(body, f"Profile({name!r}, {body!r})")
        # Only this profile matters; the rest is a placeholder.
        bodies: dict[str, dict[str, Any]] = {
            "wheel": {"profile": "S1002", "rolling_radius": 460.0}, "rail": {"profile": "60E1"},
            "track": {"inclination": "none"}, "load": {"vertical_force": 1e5}, "friction": {"coefficient": 0.3}}
        bodies[body]["profile"] = name
        self._take(body, name, Case({**bodies, **({f"{body}_profile": mend} if mend else {})}))

    @classmethod
    def of(cls, case: CaseLike, body: str) -> "Profile":
        """The profile of a body of a case, as it is mended there.

        Args:
            case: As of `solve`.
            body: "wheel" or "rail".
        Raises:
            InputError: As of `Profile`.

        >>> rollfem.Profile.of("cases/manchester_A22.toml", "wheel").figure()
        """
        body = _body(body, f"Profile.of(..., {body!r})")
        case = checked(case)
        made = cls.__new__(cls)
        made._take(body, case.data.get(body, {}).get("profile", ""), case)
        return made

    def _take(self, body: str, name: str, case: Case) -> None:
        self.body, self.name = body, name
        self.__dict__.update(_core.profile(case.core, body == "wheel"))

    def _text_in(self, folder: str) -> str:
        columns, text = self.columns(), io.StringIO()
        # Joints once: points must not coincide.
        rows = np.stack(list(columns.values()), axis=1)[np.append(np.diff(self.s) > 0.0, True)]
        np.savetxt(text, rows, "%.9g", ",", header=",".join(columns), comments="")
        return text.getvalue()

    plot_curvature = plot.curvature
    plot = plot.profile

    def figure(self) -> Any:
        """The figure of `rollfem profile`: shape and curvature.

        Returns:
            Figure: Notebooks show it; `figure.save("profile.svg")` writes it.

        >>> rollfem.Profile("S1002").figure()
        """
        from .figures.profiles import draw_profile
        return draw_profile(f"{self.body} {self.name}", self.columns())

    def __repr__(self) -> str:
        return f"<rollfem.Profile {self.body} {self.name!r}, y = {self.y[0]:.4g} to {self.y[-1]:.4g} mm>"

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p>{self.figure().svg()}"


def _body(given: str | None, call: str) -> str:
    if given not in ("wheel", "rail"):
        raise InputError(f"{call}: may be a wheel or a rail; allowed: \"wheel\", \"rail\"; do: name one of them")
    return given
