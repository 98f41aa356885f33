# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wear of profiles: from the work of friction to depths by a law, and from depths to the next profile (docs/wear.md).

A law is a function of a `Sliding`: removed volume per area of contact and length rolled (mm^3 per mm^2 and mm, a number
without unit), for every element. Along rolling it sums up to the depth of one pass, in mm. Three laws are here; one of
your own is any such function:

    def twice_the_work(at):
        return 2e-9 * at.work         # 2e-9 mm^3/(N mm)
"""
import math
import os
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from .errors import InputError
from .result import ModelResult
from .track import Profile


class WearRangeWarning(UserWarning):
    """A law was used outside the range of the tests behind it."""


class HotSurfaceWarning(UserWarning):
    """A surface gets so hot that steel transforms: no law of wear knows it then."""


@dataclass(frozen=True)
class Sliding:
    """What a wear law may depend on, as arrays over the contact elements."""

    pressure: np.ndarray  #: MPa
    work: np.ndarray      #: frictional work per area of contact and length rolled, |p_t . s|, N/mm^2: local T-gamma/A
    slip: np.ndarray      #: sliding velocity over rolling velocity, that of the work: work over |p_t|, -
    speed: float          #: rolling velocity, mm/s; 0: not given
    temperature: np.ndarray | None = None  #: of both surfaces, degC; None without heat


Law = Callable[[Sliding], np.ndarray]


def _require(least: float = 0.0, most: float = math.inf, above: bool = False, **given: float) -> None:
    """Raises InputError where a number is none, not finite, or outside of `least` to `most`; `above`: least is too small."""
    for name, value in given.items():
        if not (isinstance(value, (int, float, np.number)) and math.isfinite(value) and least <= value <= most
                and not (above and value == least)):
            upper = f", at most {most:g}" if math.isfinite(most) else ""
            raise InputError(f"wear: {name} = {value}; allowed: a finite number "
                             f"{f'above {least:g}' if above else f'of {least:g} or more'}{upper}; do: correct it")


def _warn_beyond(what: str, largest: float, limit: float, unit: str) -> None:
    if largest > limit:
        warnings.warn(f"wear law: {what} of {largest:.4g} {unit} is beyond {limit:g} {unit}, the range of its tests",
                      WearRangeWarning, stacklevel=4)


@dataclass(frozen=True)
class WorkInRegimes:
    """Wear by the work of friction per area in three regimes: mild, severe, catastrophic.

    Mass per area of contact and metre rolled, in micrograms/(m mm^2), over I = T-gamma/A in N/mm^2: `mild` I up to
    `limits[0]`, `severe` up to `limits[1]`, and severe + `catastrophic` (I - limits[1]) beyond. The defaults are those of
    wheels of R8T on rails of 900A, dry, on twin discs: Lewis and Dwyer-Joyce 2004, J. Engineering Tribology 218, 467-478;
    Braghin, Lewis, Dwyer-Joyce and Bruni 2006, Wear 261, 1253-1264. I reached 121 N/mm^2 there (7.2 kN and 20 % of slip
    on 6.1 mm^2); beyond `largest` a WearRangeWarning says so.
    """

    mild: float = 5.3              #: micrograms/(m N)
    severe: float = 55.0           #: micrograms/(m mm^2)
    catastrophic: float = 61.9     #: micrograms/(m N)
    limits: tuple[float, float] = (10.4, 77.2)  #: N/mm^2
    density: float = 7.8e3         #: micrograms/mm^3 (kg/m^3)
    factor: float = 1.0            #: of lubrication, water, another steel: yours
    largest: float = 121.0         #: N/mm^2

    def __post_init__(self) -> None:
        lower, upper = self.limits
        _require(mild=self.mild, severe=self.severe, catastrophic=self.catastrophic, lower_limit=lower, factor=self.factor)
        _require(density=self.density, largest=self.largest, above=True)
        _require(lower, upper_limit=upper)

    def per_metre(self, work: np.ndarray) -> np.ndarray:
        """Micrograms per metre rolled and mm^2 of contact, over the work per area in N/mm^2."""
        mild, severe = self.limits
        return np.where(work <= mild, self.mild * work, self.severe + self.catastrophic * np.maximum(work - severe, 0.0))

    def __call__(self, at: Sliding) -> np.ndarray:
        _warn_beyond("a work per area", float(at.work.max(initial=0.0)), self.largest, "N/mm^2")
        return 1e-3 * self.factor / self.density * self.per_metre(at.work)


@dataclass(frozen=True)
class Archard:
    """Archard's law, volume = k N s / H, with a map of k over pressure and sliding velocity.

    k is `mild` below `velocities[0]` and above `velocities[1]`, `severe` between them, and `seizure` where the pressure
    exceeds `pressure` times the hardness. The defaults are the middles of the ranges that Jendel 2002, Wear 253, 90-99
    (also KTH, TRITA-FKT 2000:49) gives for dry wheels: 1 to 10, 30 to 40 and 300 to 400, all 1e-4. The map ends at about
    1 m/s (`fastest`).
    """

    hardness: float                #: MPa, of the softer body (Vickers or Brinell x 9.81)
    mild: float = 5.5e-4           #: -
    severe: float = 35e-4          #: -
    seizure: float = 350e-4        #: -
    velocities: tuple[float, float] = (200.0, 700.0)  #: mm/s
    pressure: float = 0.8          #: of the hardness
    factor: float = 1.0            #: of lubrication, water: yours
    fastest: float = 1000.0        #: mm/s

    def __post_init__(self) -> None:
        slow, fast = self.velocities
        _require(mild=self.mild, severe=self.severe, seizure=self.seizure, lower_velocity=slow, factor=self.factor)
        _require(hardness=self.hardness, pressure=self.pressure, fastest=self.fastest, above=True)
        _require(slow, upper_velocity=fast)

    def coefficient(self, pressure: np.ndarray, velocity: np.ndarray) -> np.ndarray:
        """k over the pressure, MPa, and the sliding velocity, mm/s."""
        slow, fast = self.velocities
        moderate = np.where((velocity >= slow) & (velocity <= fast), self.severe, self.mild)
        return np.where(pressure > self.pressure * self.hardness, self.seizure, moderate)

    def __call__(self, at: Sliding) -> np.ndarray:
        if not at.speed > 0.0:
            raise InputError("Archard's map needs the rolling velocity; do: give speed=, in mm/s")
        velocity = at.slip * at.speed
        _warn_beyond("a sliding velocity", float(velocity.max(initial=0.0)), self.fastest, "mm/s")
        removal: np.ndarray = self.factor * self.coefficient(at.pressure, velocity) * at.pressure * at.slip / self.hardness
        return removal


@dataclass(frozen=True)
class ConstantCoefficient:
    """Volume in proportion to the work of friction; steel on steel, dry and mild: 5.3 micrograms/(m N), 6.8e-7."""

    coefficient: float = 5.3e-3 / 7.8e3  #: mm^3/(N mm)

    def __post_init__(self) -> None:
        _require(coefficient=self.coefficient)

    def __call__(self, at: Sliding) -> np.ndarray:
        return self.coefficient * at.work


def hottest(models: Iterable[ModelResult], point: int = 0) -> dict[str, dict[str, float]]:
    """The largest temperature of each body in contact, per position and patch of a case with heat.

    Args:
        models: Of a result; `point`: load point, from 0.
    Returns:
        By model.key: temperature (degC, of both surfaces, which are alike in contact), y_wheel and y_rail (mm, where on the
        profiles); models without heat are left out.

    >>> hottest(result.models)
    """
    found = {}
    for model in models:
        at = model.points[point]
        if at.temperature_rail is not None:
            row = int(np.where(at.pressure > 0.0, at.temperature_rail, -math.inf).max(axis=1).argmax())
            places = {name: float(values[row]) for name in ("y_wheel", "y_rail") if (values := getattr(model, name)) is not None}
            found[model.key] = {"temperature": float(at.max_temperature), **places}
    return found


def depth_of_pass(model: ModelResult, law: Law, point: int = 0, speed: float = 0.0) -> np.ndarray:
    """The depth that one pass of a contact removes.

    Args:
        model: Of a model with slip, on one patch, in steady rolling.
        law: `WorkInRegimes()`, `Archard(...)`, `ConstantCoefficient(...)`, or a function of a `Sliding`.
        point: Load point, from 0.
        speed: Rolling velocity, mm/s, for laws that depend on it.
    Returns:
        [ny], mm, over model.y_wheel and model.y_rail. A wheel is passed once per revolution, a rail by every wheel.
    Raises:
        InputError: The model has no slip, or `speed` is negative or not finite.

    >>> depth_of_pass(result["halfspace"], WorkInRegimes())
    """
    _require(speed=speed)
    at = model.points[point]
    if at.work is None:
        raise InputError(f"wear of {model.key}: without slip there is no work of friction; do: take halfspace, hybrid, fem, "
                         "carter, fastsim, fastrip or strip, in steady rolling")
    traction = np.hypot(at.traction_x, at.traction_y)
    # With the slip of a zone that is thinner than an element, which the field of slip lacks.
    slip = np.divide(at.work, traction, out=np.zeros_like(traction), where=traction > 0.0)
    if at.temperature_rail is not None and at.max_temperature > model.hot_limit:
        warnings.warn(f"wear of {model.key}: the surfaces reach {at.max_temperature:.0f} degC; above {model.hot_limit:g} degC steel "
                      "transforms, and no law of wear holds", HotSurfaceWarning, stacklevel=2)
    removal = np.asarray(law(Sliding(at.pressure, at.work, slip, speed, at.temperature_rail)))
    if removal.shape != slip.shape or not np.isfinite(removal).all() or (removal < 0.0).any():
        raise InputError("wear law: allowed: a finite number of 0 or more for every element of the contact")
    depth: np.ndarray = removal.sum(axis=1) * model.dx
    return depth


@dataclass(frozen=True)
class WornProfile:
    """A profile of wheel or rail that wears: points of a curve, y to the field side and z down, mm.

    >>> wheel = WornProfile.of(rollfem.Profile("S1002"))
    >>> area = wheel.area_of(result.models, WorkInRegimes(), passes=1e4)
    >>> wheel.worn(area, smoothing=2.0).write("worn.csv")
    """

    y: np.ndarray
    z: np.ndarray
    body: str         #: "wheel" or "rail"
    step: float = 0.2  #: mm between points, 0.001 to 1: arcs of 12 mm need that

    def __post_init__(self) -> None:
        _require(1e-3, 1.0, step=self.step)

    @classmethod
    def of(cls, profile: Profile, step: float = 0.2) -> "WornProfile":
        """From a profile, which it follows with points in equal steps (mm)."""
        return cls(np.array(profile.y), np.array(profile.z), profile.body, step)._in_steps()

    @property
    def along(self) -> np.ndarray:
        """Length along the points, mm."""
        return np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(self.y), np.diff(self.z)))])

    @property
    def widths(self) -> np.ndarray:
        """Of the profile that belongs to each point, mm."""
        halves = 0.5 * np.diff(self.along)
        widths: np.ndarray = np.append(halves, 0.0) + np.append(0.0, halves)
        return widths

    def area_of_pass(self, model: ModelResult, depth: np.ndarray) -> np.ndarray:
        """The area that one pass removes from the part of each point, mm^2: exactly the sum of depth times width.

        Args:
            model: Of one patch; `depth`: its depth_of_pass.
        Raises:
            InputError: The patch lies beyond the profile.
        """
        rows = model.y_wheel if self.body == "wheel" else model.y_rail
        assert rows is not None and model.width is not None
        if rows[0] > rows[-1]:  # the patch frame of a right wheel
            rows, depth, width = rows[::-1], depth[::-1], model.width[::-1]
        else:
            width = model.width
        middles = 0.5 * (rows[1:] + rows[:-1])
        edges = np.concatenate([[2.0 * rows[0] - middles[0]], middles, [2.0 * rows[-1] - middles[-1]]])
        wearing = np.flatnonzero(depth > 0.0)
        if len(wearing) and not self.y[0] <= edges[wearing[0]] <= edges[wearing[-1] + 1] <= self.y[-1]:
            raise InputError(f"wear of {model.key}: y = {edges[wearing[0]]:.4g} to {edges[wearing[-1] + 1]:.4g} mm lies beyond "
                             f"the {self.body}'s profile, {self.y[0]:.4g} to {self.y[-1]:.4g} mm; do: take a longer profile")
        # Undercut parts, where y turns back, do not wear.
        along, order = self.along, np.concatenate([[True], np.diff(np.maximum.accumulate(self.y)) > 0.0])
        removed = np.concatenate([[0.0], np.cumsum(depth * width)])
        halfway = np.concatenate([[along[0]], 0.5 * (along[1:] + along[:-1]), [along[-1]]])
        return np.diff(np.interp(halfway, np.interp(edges, self.y[order], along[order]), removed))

    def area_of(self, models: Iterable[ModelResult], law: Law, passes: float = 1.0, speed: float = 0.0,
                point: int = 0) -> np.ndarray:
        """The same of a number of passes, summed over patches: all that models hold. mm^2."""
        _require(passes=passes)
        area = np.zeros(len(self.y))
        for model in models:
            area += passes * self.area_of_pass(model, depth_of_pass(model, law, point, speed))
        return area

    def smoothed(self, area: np.ndarray, length: float) -> np.ndarray:
        """Areas smoothed along the profile by nearly a Gaussian of this standard deviation (mm); their sum remains."""
        if np.shape(area) != self.y.shape or not np.isfinite(area).all() or (np.asarray(area) < 0.0).any():
            raise InputError(f"wear: area: allowed: an area of 0 or more for each of the {len(self.y)} points of this profile")
        _require(0.0, float(self.along[-1]), smoothing=length)
        widths, diffusion = self.widths, length * length / 6.0 / np.diff(self.along)
        for _ in range(3):  # three implicit steps of diffusion: no new extremes
            area = widths * _solve_diffusion(widths, diffusion, area)
        return area

    def worn(self, area: np.ndarray, smoothing: float = 0.0, largest: float = 0.3) -> "WornProfile":
        """The profile without this area.

        Args:
            area: mm^2, as of `area_of`.
            smoothing: Length over which wear is spread, mm, standard deviation; 0: none.
            largest: Depth of one step, mm, above 0.
        Returns:
            WornProfile: Points moved along the normals, and again in equal steps. The area between the curves is the given
            one to 1e-9, below 1e-7 mm^2 to the rounding of coordinates, 1e-16 mm^2.
        Raises:
            InputError: An argument is negative or not finite, the step is deeper than `largest`, or leaves kinks that the program would reject.
        """
        _require(largest=largest, above=True)
        area = self.smoothed(area, smoothing)
        target = float(area.sum())
        if target == 0.0:
            return self
        depth = area / self.widths
        if depth.max() > largest:
            raise InputError(f"wear: {depth.max():.3g} mm in one step is more than {largest:g} mm; do: take shorter steps")
        factor = 1.0
        for _ in range(20):  # curvature and the new points change the area a little
            new = self._moved(factor * depth)._in_steps()
            missed = 1.0 - self.area_to(new) / target
            if abs(missed) < 1e-10:
                break
            factor += missed
        new.check()
        return new

    def area_to(self, other: "WornProfile") -> float:
        """The area between this profile and one with the same ends, mm^2, positive where that one is worn."""
        if len(self.y) == len(other.y):  # of the quadrilaterals between them, without the rounding of large areas
            y, z = np.diff(self.y), np.diff(self.z)
            by, bz = other.y - self.y, other.z - self.z
            parts = y * (bz[1:] + bz[:-1]) - z * (by[1:] + by[:-1]) + by[1:] * bz[:-1] - bz[1:] * by[:-1]
            return self._inwards * 0.5 * math.fsum(parts)
        y, z = np.concatenate([self.y, other.y[::-1]]), np.concatenate([self.z, other.z[::-1]])
        y, z = y - y[0], z - z[0]
        return self._inwards * 0.5 * float(np.sum(y * np.roll(z, -1) - np.roll(y, -1) * z))

    def check(self) -> None:
        """Raises InputError where the profile crosses itself, or has kinks beyond the 20 degrees a file may have."""
        angle = np.unwrap(np.arctan2(np.diff(self.z), np.diff(self.y)))
        kink = np.degrees(np.abs(np.diff(angle)).max())
        if kink > 20.0 or not np.hypot(np.diff(self.y), np.diff(self.z)).min() > 0.0:
            raise InputError(f"worn profile: a kink of {kink:.3g} degrees near y = {self.y[np.abs(np.diff(angle)).argmax() + 1]:.4g} "
                             "mm; allowed: 20; do: take shorter steps, or a larger smoothing")

    def write(self, file: str | os.PathLike[str]) -> str:
        """Writes the points as a profile that cases may name. Returns the file."""
        name = os.fspath(file)
        with open(name, "w", encoding="utf-8") as out:
            out.write(f"# {self.body}: y to the field side, z down, mm\n")
            np.savetxt(out, np.stack([self.y, self.z], axis=1), "%.12g")
        return name

    @property
    def _inwards(self) -> float:
        """Sign of z into the body: a rail lies below its surface, a wheel above."""
        return 1.0 if self.body == "rail" else -1.0

    def _moved(self, depth: np.ndarray) -> "WornProfile":
        along = self.along
        y, z = np.gradient(self.y, along), np.gradient(self.z, along)
        size = self._inwards * depth / np.hypot(y, z)
        return replace(self, y=self.y - size * z, z=self.z + size * y)

    def _in_steps(self) -> "WornProfile":
        """Points in equal steps on a cubic through the points."""
        along = self.along
        keep = np.concatenate([[True], np.diff(along) > 1e-9])
        along, y, z = along[keep], self.y[keep], self.z[keep]
        at = np.linspace(0.0, along[-1], max(8, round(along[-1] / self.step)) + 1)
        return replace(self, y=_cubic(at, along, y), z=_cubic(at, along, z))


def _cubic(at: np.ndarray, x: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Cubic Hermite interpolation with slopes of second order."""
    slope = np.gradient(values, x)
    k = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(x) - 2)
    h = x[k + 1] - x[k]
    t = (at - x[k]) / h
    chord = values[k + 1] - values[k]
    left, right = h * slope[k] - chord, h * slope[k + 1] - chord
    found: np.ndarray = values[k] + t * (chord + (1.0 - t) * (left - t * (left + right)))
    return found


def _solve_diffusion(widths: np.ndarray, diffusion: np.ndarray, right: np.ndarray) -> np.ndarray:
    """u with widths u - (diffusion u')' = right and no flux through the ends: elimination in a symmetric band."""
    main = widths + np.append(diffusion, 0.0) + np.append(0.0, diffusion)
    u = right.astype(float)
    for k, off in enumerate(diffusion):
        share = off / main[k]
        main[k + 1] -= share * off
        u[k + 1] += share * u[k]
    u[-1] /= main[-1]
    for k in range(len(diffusion) - 1, -1, -1):
        u[k] = (u[k] + diffusion[k] * u[k + 1]) / main[k]
    return u


def passes_of_wheel(distance: float, radius: float) -> float:
    """Revolutions over a distance (mm, 0 or more) of a wheel with this rolling radius (mm, above 0)."""
    _require(distance=distance)
    _require(radius=radius, above=True)
    return distance / (2.0 * math.pi * radius)
