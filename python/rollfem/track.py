# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles, and where rigid wheels touch their rails: nothing is solved here."""
import io
import os
from html import escape
from typing import Any

import numpy as np

from . import _core, plot
from .case import Case
from .frames import InFile, Tabular, html_table
from .solving import checked

#: Columns of a wheelset over its lateral shift, as those of wheelset.csv.
WHEELSET = {"lateral_shift": "mm", "roll": "rad", "radius_left": "mm", "radius_right": "mm", "radius_difference": "mm",
            "angle_left": "rad", "angle_right": "rad", "y_wheel_left": "mm", "y_wheel_right": "mm",
            "conicity_harmonic": "-", "conicity_wave": "-", "wave_length": "mm"}


class Wheelset(Tabular):
    """A rigid wheelset over its lateral shift, from the middle to the right; the other side is the mirror image.

    Attributes
    ----------
    title : str
        Of the case.
    lateral_shift : numpy.ndarray
        mm; for conicities and the wavelength it is the amplitude.
    roll : numpy.ndarray
        rad.
    radius_left, radius_right, radius_difference : numpy.ndarray
        Rolling radii, and right less left, mm.
    angle_left, angle_right : numpy.ndarray
        Contact angles, rad.
    y_wheel_left, y_wheel_right : numpy.ndarray
        Of the contact points on the wheel's profile, mm.
    conicity_harmonic, conicity_wave : numpy.ndarray
        Equivalent conicity by harmonic linearisation, and that of cones with the same wave (UIC 519, EN 15302); nan where
        there is none.
    wave_length : numpy.ndarray
        Of the free wheelset, mm; nan where it does not oscillate.
    """

    lateral_shift: np.ndarray
    roll: np.ndarray
    radius_left: np.ndarray
    radius_right: np.ndarray
    radius_difference: np.ndarray
    angle_left: np.ndarray
    angle_right: np.ndarray
    y_wheel_left: np.ndarray
    y_wheel_right: np.ndarray
    conicity_harmonic: np.ndarray
    conicity_wave: np.ndarray
    wave_length: np.ndarray

    def __init__(self, title: str, columns: dict[str, np.ndarray]) -> None:
        self.title = title
        self.__dict__.update((name, columns[name]) for name in WHEELSET)

    def columns(self) -> dict[str, np.ndarray]:
        """{name: array} of the attributes, one entry for each shift."""
        return {name: getattr(self, name) for name in WHEELSET}

    def figure(self) -> Any:
        """The figure of `rollfem wheelset`: radii, angles, conicity, wavelength.

        Returns
        -------
        Figure
            Notebooks show it; `figure.save("wheelset.svg")` writes it.

        Examples
        --------
        >>> rollfem.wheelset("cases/manchester_A22.toml").figure()
        """
        from rollfem_figures.positions import draw_wheelset
        return draw_wheelset(self.columns())

    def __repr__(self) -> str:
        return f"<rollfem.Wheelset {self.title!r}, lateral shift 0 to {self.lateral_shift[-1]:.4g} mm>"

    def _repr_html_(self) -> str:
        step = max(1, round(1.0 / (self.lateral_shift[1] - self.lateral_shift[0])))
        shown = [name for name in WHEELSET if name.split("_")[0] not in ("roll", "y")]
        return html_table(repr(self), [f"{name} ({WHEELSET[name]})" for name in shown],
                          zip(*(getattr(self, name)[::step] for name in shown)))


def wheelset(case: Any, /, reach: float = 10.0, step: float = 0.1, **sections: Any) -> Wheelset:
    """Rolling radii, contact angles and equivalent conicity of the rigid wheelset of a case.

    Parameters
    ----------
    case : str, os.PathLike, dict or Case
        With profiles of wheel and rail.
    reach : float
        Largest lateral shift, 0.2 to 30 mm; the table ends earlier where a wheel leaves its rail.
    step : float
        mm; EN 15302 asks for 0.2 at most.
    **sections
        Keys that replace those of the case, as of `Case`.

    Returns
    -------
    Wheelset

    Raises
    ------
    InputError
        If the case has no profiles, or reach or step are out of bounds.
    SolveError
        If the wheelset does not stand on the track.

    Examples
    --------
    >>> found = rollfem.wheelset("cases/manchester_A22.toml")
    >>> numpy.interp(3.0, found.lateral_shift, found.conicity_wave)
    """
    if not (0.2 <= reach <= 30.0 and 0.001 <= step <= 0.5 * reach):
        raise _core.InputError(f"wheelset(reach={reach!r}, step={step!r}): allowed: reach 0.2 to 30 mm, step 0.001 mm to half "
                               "of it; do: give values in these ranges")
    case = checked(case, sections, "wheelset")
    return Wheelset(case.title, _core.wheelset(case.core, reach, step))


def contact_points(case: Any, /, **sections: Any) -> list[dict[str, Any]]:
    """Where the wheels of a case touch their rails.

    Parameters
    ----------
    case : str, os.PathLike, dict or Case
        With profiles of wheel and rail.
    **sections
        Keys that replace those of the case, as of `Case`.

    Returns
    -------
    list of dict
        As ModelResult.place: wheel, position, patch (from 1, the most loaded first; 0: a near miss, at most 1 mm off),
        y_track, y_rail, y_wheel, rolling_radius, separation (mm), contact_angle (rad), ...

    Raises
    ------
    InputError
        If the case has no profiles.
    SolveError
        If a wheel has left its rail.

    Examples
    --------
    >>> [place["contact_angle"] for place in rollfem.contact_points(case, lateral_shift=3.0)]
    """
    return _core.contact_points(checked(case, sections, "contact_points").core)


class Profile(Tabular, InFile):
    """A profile of wheel or rail as one curve: y towards the field side, z down, both in mm.

    Parameters
    ----------
    source : str or os.PathLike
        A file (two columns, or a format of docs/profiles.md) or a built-in profile ("S1002").
    body : str, optional
        "wheel" or "rail"; otherwise the ending of the file or the built-in profile says it.
    **mend
        Keys of [wheel_profile] or [rail_profile] of a case (docs/profiles.md): smoothing=0.01, shift=[-70, 0], flip=True,
        unit="inch", ...

    Attributes
    ----------
    s, y, z : numpy.ndarray
        Along the profile, mm, every tenth of a millimetre; two rows where the curvature jumps.
    angle : numpy.ndarray
        Of the tangent from y to z, degrees.
    curvature : numpy.ndarray
        1/mm, positive where the curve turns towards +z.
    length, smallest_convex_radius, smallest_hollow_radius : float
        mm; radii as seen from outside of the body.
    gauge_face, flange_tip : float or None
        y in mm: 14 mm below the top of a rail, or of a wheel's flange at z = 10; of the tip of the flange.
    joints : list of float
        y in mm where the radius jumps.
    points : int
        Of a file, after mending.
    smoothing : dict or None
        scatter of the points of a file, rms and largest distance from the curve, mm.

    Raises
    ------
    FileError
        If the file cannot be read.
    InputError
        If it has faults that no key mends, or a key is wrong.

    Examples
    --------
    >>> worn = rollfem.Profile("worn.csv", "rail", smoothing=0.01)
    >>> worn.smallest_convex_radius
    """

    s: np.ndarray
    y: np.ndarray
    z: np.ndarray
    angle: np.ndarray
    curvature: np.ndarray
    length: float
    gauge_face: float | None
    flange_tip: float | None
    smallest_convex_radius: float
    smallest_hollow_radius: float
    joints: list[float]
    points: int
    smoothing: dict[str, float] | None
    kind: str

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
    def of(cls, case: Any, body: str) -> "Profile":
        """The profile of a body of a case, as it is mended there.

        Parameters
        ----------
        case : str, os.PathLike, dict or Case
        body : str
            "wheel" or "rail".

        Returns
        -------
        Profile

        Raises
        ------
        InputError
            As of `Profile`.

        Examples
        --------
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

    def columns(self) -> dict[str, np.ndarray]:
        """{name: array} of s, y, z, angle and curvature."""
        return {name: getattr(self, name) for name in ("s", "y", "z", "angle", "curvature")}

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

        Returns
        -------
        Figure
            Notebooks show it; `figure.save("profile.svg")` writes it.

        Examples
        --------
        >>> rollfem.Profile("S1002").figure()
        """
        from rollfem_figures.profiles import draw_profile
        return draw_profile(f"{self.body} {self.name}", self.columns())

    def __repr__(self) -> str:
        return f"<rollfem.Profile {self.body} {self.name!r}, y = {self.y[0]:.4g} to {self.y[-1]:.4g} mm>"

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p>{self.figure().svg()}"


def _body(given: str | None, call: str) -> str:
    if given not in ("wheel", "rail"):
        raise _core.InputError(f"{call}: may be a wheel or a rail; allowed: \"wheel\", \"rail\"; do: name one of them")
    return given
