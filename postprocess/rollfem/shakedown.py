# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shakedown map of rolling and sliding contact (Johnson 1985, section 9.2; Johnson 1989): load factor p0/k, with the yield
stress in shear k, against traction coefficient T/N. Below the lower boundary nothing yields. Below the upper one residual
stresses make later passages elastic; above it the material yields at every passage.

The boundaries assume tractions proportional to Hertz's pressure, T/N p (full slip), Poisson's ratio 0.3 and von Mises's
condition, for a line contact (plane strain) and a circle:
- elastic: p0 at which the largest von Mises stress is sqrt(3) k. Without friction 3.11 k for the line, 2.79 k for the circle.
- shakedown: p0 at which the largest |xz| anywhere, the shear on planes parallel to the surface, is k (narrow ellipses: Ellipse).
  Residual stress that is uniform along the rolling direction can balance every component except xz (for the line, Melan's
  theorem then gives exactly this value). Without friction 4.00 k (Johnson 1962) and 4.68 k (Ponter, Hearle & Johnson 1985);
  where the surface decides, 1/(T/N). Below a circle with friction residual stress balances a part of xz too, so that this
  boundary is on the safe side (by 20 % at T/N = 0.2, docs/plasticity.md).
"""
import math
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from .stresses import von_mises

NU = 0.3
_HALF = 24  # places to each side of a line along rolling


@dataclass(frozen=True)
class Limits:
    """Largest p0/k at a traction coefficient."""

    elastic: float
    shakedown: float

    def region(self, load_factor: float) -> str:
        """"elastic", "elastic shakedown" or "beyond shakedown": where a point lies in the map."""
        if load_factor <= min(self.elastic, self.shakedown):
            return "elastic"
        return "elastic shakedown" if load_factor <= self.shakedown else "beyond shakedown"


def yield_shear_stress(yield_strength: float) -> float:
    """k of a yield strength in tension by von Mises's condition."""
    return yield_strength / math.sqrt(3.0)


def surface_fatigue_index(traction_coefficient: float, load_factor: float) -> float:
    """T/N - k/p0 of Ekberg, Kabo & Andersson (2002): positive if the surface is expected to ratchet."""
    return traction_coefficient - 1.0 / load_factor


def _limits(von_mises_stress: float, shear: float) -> Limits:
    return Limits(math.sqrt(3.0) / von_mises_stress, 1.0 / shear)


@cache
def _line_field() -> tuple[np.ndarray, np.ndarray]:
    """Stress over p0 [n, 6] of a line contact of half-width 1 by the pressure and by the same traction along x, plane strain, z
    into the material (McEwen; Johnson 1985, sections 4.2 and 7.1). Depths begin at the surface and are denser there; x avoids
    the edge, where the formula is 0/0."""
    x, z = (part.ravel() for part in np.meshgrid(0.00999 * np.arange(-150, 151) + 1e-6, 1.5 * (np.arange(151) / 150) ** 1.5))
    half = 1 - x * x + z * z
    root = np.hypot(half, 2 * x * z)
    m, n = np.sqrt(0.5 * (root + half)), np.copysign(np.sqrt(np.maximum(0.0, 0.5 * (root - half))), x)
    square = m * m + n * n
    ratio = (z * z + n * n) / square
    xx, zz, xz = 2 * z - m * (1 + ratio), -m * (1 - ratio), -n * (m * m - z * z) / square
    of_friction = n * (2 - (z * z - m * m) / square) - 2 * x
    zero = np.zeros_like(x)
    return (np.stack([xx, NU * (xx + zz), zz, zero, zero, xz], axis=1),
            np.stack([of_friction, NU * (of_friction + xz), xz, zero, zero, xx], axis=1))


@cache
def line_limits(friction: float) -> Limits:
    """Of a line contact, to 1e-3; `friction`: traction coefficient >= 0."""
    pressed, rubbed = _line_field()
    stress = pressed + friction * rubbed
    return _limits(von_mises(stress).max(), np.abs(stress[:, 5]).max())


# Largest subsurface stresses of the circle over p0, von Mises and |xz|, at friction 0, 0.05, ... 0.35; with more friction the
# largest ones are at the surface. Computed with the exact integrals of half-space elements, 160 across; tests/python/stress.py
# recomputes them.
_BELOW_CIRCLE = np.array([[0.62000, 0.21386], [0.62110, 0.22788], [0.62443, 0.24217], [0.62991, 0.25670], [0.63761, 0.27145],
                          [0.64753, 0.28642], [0.65973, 0.30160], [0.67416, 0.31695]])


def sliding_circle_surface(x: np.ndarray, friction: float) -> np.ndarray:
    """Stress over p0 [n, 6] on the surface of the circle along y = 0, |x| <= 1 in radii, under pressure p and traction friction
    times p along +x, z into the material (Hamilton 1983; Johnson 1985, sections 3.4 and 7.1): tension at x = -1, where the
    surface yields first."""
    c = np.sqrt(1 - x * x)
    lift = (1 - 2 * NU) / 3 * (1 + c + c * c) / (1 + c)  # (1 - c^3) / x^2 without cancellation at the centre
    zero, part = np.zeros_like(x), friction * math.pi / 8 * x
    return np.stack([lift - c - (4 + NU) * part, -lift - 2 * NU * c - 3 * NU * part, -c, zero, zero, -friction * c], axis=1)


@cache
def circle_limits(friction: float) -> Limits:
    """Of a circular contact, to 2e-3."""
    deep = [np.interp(friction, 0.05 * np.arange(len(_BELOW_CIRCLE)), column) for column in _BELOW_CIRCLE.T]
    surface = sliding_circle_surface(1e-3 * np.arange(-1000, 1001), friction)
    return _limits(max(deep[0], von_mises(surface).max()), max(deep[1], np.abs(surface[:, 5]).max()))


def _pairs_of_loads(x: np.ndarray, y: np.ndarray, z: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """The stress that point loads `weight` at (-x, -y) and (-x, y), along z and along x, cause at (0, 0, z), summed over the
    last two axes (Boussinesq and Cerruti; Johnson 1985, sections 3.2 and 3.6): [..., 2, 6]."""
    a = 1 - 2 * NU
    square = x * x + y * y + z * z
    r = np.sqrt(square)
    cube = square * r
    s, part, c = 1 / (r + z), weight / math.pi, 3 / (cube * square)
    flat, bent = a * (z / square - s) / r, a * (2 * r + z) * s * s / cube - c * z
    even, odd = a / cube, a * s * s / r
    curl = odd * (1 / square + 2 * s / r) - c
    zero = np.zeros_like(r)
    pressed = [flat + x * x * bent, flat + y * y * bent, -c * z * z * z, zero, zero, -c * x * z * z]
    rubbed = [x * (even - 3 * odd + x * x * curl), x * (even - odd + y * y * curl), -c * x * z * z, zero, zero, -c * x * x * z]
    return np.stack([np.stack([np.sum(part * each, axis=(-2, -1)) for each in load], axis=-1) for load in (pressed, rubbed)],
                    axis=-2)


class Ellipse:
    """The shakedown limit of an elliptic contact from the stress in the plane y = 0 below a sliding Hertz ellipse, under the
    pressure p0 sqrt(1 - (x/a)^2 - (y/b)^2) and friction times this pressure along x. The smaller one of two bounds: that of the
    largest xz, and Melan's theorem for two instants of a passage. A fixed residual stress keeps both within the yield surface
    only if their elastic stresses differ by at most 2 sqrt(3) k (von Mises); without load the stress is 0. The second one
    decides below patches narrower than b/a = 0.65, at y = 0."""

    def __init__(self, ratio: float) -> None:
        """`ratio`: b/a, semi-axis across over semi-axis along rolling; clamped to 0.1 to 50. Infinite: a line contact."""
        self.ratio = ratio if math.isinf(ratio) else min(max(ratio, 0.1), 50.0)

    @property
    def is_line(self) -> bool:
        """Whether it is a line contact."""
        return math.isinf(self.ratio)

    @cached_property
    def _stress(self) -> np.ndarray:
        """[depth, place along rolling, pressure or traction, 6] in an ellipse with semi-axes 1 and `ratio`. Integration points
        are the sinh of even ones about the field point, to be dense where the point load is steep."""
        x, z = np.meshgrid(0.05 * np.arange(-_HALF, _HALF + 1), 0.05 * np.arange(1, _HALF + 1) * min(1.0, self.ratio))
        x, z = x[..., None], z[..., None]
        nodes, weights = np.polynomial.legendre.leggauss(24)  # type: ignore[no-untyped-call]
        start, end = np.arcsinh((-1 - x) / z), np.arcsinh((1 - x) / z)
        s, ds = 0.5 * (start + end) + 0.5 * (end - start) * nodes, 0.5 * (end - start) * weights
        away = -z * np.sinh(s)  # distance from the load to the field point
        rest, near = np.maximum(0.0, 1 - (x - away) ** 2), np.hypot(z, away)
        end = np.arcsinh(self.ratio * np.sqrt(rest) / near)[..., None]
        t, dt = 0.5 * end * (1 + nodes), 0.5 * end * weights
        y = near[..., None] * np.sinh(t)
        pressure = np.sqrt(np.maximum(0.0, rest[..., None] - (y / self.ratio) ** 2))
        weight = (ds * z * np.cosh(s) * near)[..., None] * dt * np.cosh(t) * pressure
        return _pairs_of_loads(away[..., None], y, z[..., None], weight)

    def limit(self, friction: float) -> float:
        """p0/k above which the material yields at every passage, to 5e-3."""
        if self.is_line:
            return line_limits(friction).shakedown
        stress = self._stress[:, :, 0] + friction * self._stress[:, :, 1]
        instants = np.concatenate([np.zeros_like(stress[:, :1]), stress], axis=1)  # the first unloaded
        one, other = np.triu_indices(instants.shape[1], 1)
        change = von_mises(instants[:, other] - instants[:, one]).max()
        shear = max(friction, np.abs(stress[..., 5]).max())  # on the surface, xz is the traction
        return float(min(1 / shear, 2 * math.sqrt(3.0) / change))


def boundaries(ellipse: Ellipse) -> dict[str, Any]:
    """The boundaries of the map as curves, for drawing."""
    at = [0.01 * step for step in range(61)]
    lines, circles = [line_limits(friction) for friction in at], [circle_limits(friction) for friction in at]
    return {"ellipse_ratio": None if ellipse.is_line else ellipse.ratio, "tangential_coefficient": at,
            **{f"{kind}_{name}": [getattr(each, name) for each in limits]
               for kind, limits in (("line", lines), ("circle", circles)) for name in ("elastic", "shakedown")},
            "ellipse_shakedown": [ellipse.limit(friction) for friction in at]}
