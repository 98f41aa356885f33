# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hertz the other way round: relative curvatures of the bodies whose contact is a given ellipse."""
import math


def integrals(ratio: float) -> tuple[float, float]:
    """K and D = (K - E)/e^2, complete elliptic integrals with e^2 = 1 - ratio^2, 0 < ratio <= 1, by the
    arithmetic-geometric mean; without cancellation near the circle (Abramowitz and Stegun 17.6)."""
    e2 = 1.0 - ratio**2
    mean, geometric = 0.5 * (1.0 + ratio), math.sqrt(ratio)
    c = 0.5 / (1.0 + ratio)  # half the difference of both, over e^2
    total, weight = 0.5, 1.0
    for _ in range(40):
        total += weight * c * c * e2
        weight, c = 2.0 * weight, 0.25 * c * c * e2 / (0.5 * (mean + geometric))
        mean, geometric = 0.5 * (mean + geometric), math.sqrt(mean * geometric)
    k = math.pi / (2.0 * mean)
    return k, k * total


def curvatures(semi_axis_x: float, semi_axis_y: float, normal_force: float, modulus: float) -> tuple[float, float]:
    """A and B (1/mm) of the undeformed distance A x^2 + B y^2 of bodies with E* = `modulus` (MPa) that touch in this
    ellipse (mm) under this force (N): Johnson (1985), equations 4.25."""
    a, b = max(semi_axis_x, semi_axis_y), min(semi_axis_x, semi_axis_y)
    k, d = integrals(b / a)
    pressure = 1.5 * normal_force / (math.pi * a * b)
    along, across = pressure / modulus * b / a**2 * d, pressure / modulus / b * (k - d)
    return (along, across) if semi_axis_x >= semi_axis_y else (across, along)
