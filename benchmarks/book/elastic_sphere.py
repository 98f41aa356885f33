# SPDX-License-Identifier: LGPL-2.1-or-later
"""An elastic sphere between two opposite Hertz pressures, by Lur'e's series: the effect of curvature on the half-space.

A. I. Lur'e, Three-Dimensional Problems of the Theory of Elasticity (1964), chapter 6. Inside a sphere, for every n,

    u_r = (A (n+1)(n-2+4nu) r^(n+1) + B n r^(n-1)) P_n,    u_theta = (A (n+5-4nu) r^(n+1) + B r^(n-1)) dP_n/dtheta

and A and B follow from the pressure p_n P_n and no shear on the surface. `residuals` verifies that this form is in
equilibrium and has these tractions.

The series for strains of the surface, e_theta along the meridian and e_psi across, converge as n^(-3/2), oscillating.
The limit of their coefficients for large n, c0 + c1/(n + 1/2), is summed in closed form, as sum p_n P_n is the pressure
and sum p_n P_n/(n + 1/2) Mehler's integral (Kummer's way); the rest converges as n^(-7/2). Lengths in any unit, strains
times G/p0.
"""
import numpy as np


def cap_coefficients(count, angle):
    """p_n of p = sqrt(1 - sin^2(t/2)/sin^2(angle/2)) on both caps t < angle, n = 0, ..., count - 1.

    Hertz's pressure over the chord. By Mehler's integral of P_n; odd n are zero.
    """
    n = np.arange(count)
    m = n + 0.5
    integral = (np.sin((m + 1) * angle) / (m + 1) + np.sin((m - 1) * angle) / (m - 1)) / 2 \
        - np.cos(angle) * np.sin(m * angle) / m
    return np.where(n % 2 == 0, 2.0, 0.0) * m * integral / np.sqrt(2 * (1 - np.cos(angle)))


def surface_coefficients(n, poisson):
    """(U, T): u_r = R/G sum U p_n P_n, u_theta = R/G sum T p_n dP_n/dtheta on the surface."""
    below = (n * n + n + 1 + (2 * n + 1) * poisson) * (n - 1.0)
    return (-(4 * (1 - poisson) * n * n + 2 * poisson * n - 2 + 4 * poisson) / (4 * below),
            ((1 - 2 * poisson) * n - 2 + poisson) / (2 * below))


def _legendre(count, cosine):
    """(n, P_n, (1 - x^2) dP_n/dx) at all places, for n = 0, ..., count - 1."""
    before, here = np.zeros_like(cosine), np.ones_like(cosine)
    for n in range(count):
        yield n, here, n * (before - cosine * here)
        before, here = here, ((2 * n + 1) * cosine * here - n * before) / (n + 1)


def _over_number(theta, angle):
    """Sum of p_n P_n/(n + 1/2) of one cap by sum P_n(cos t) cos((n + 1/2) f) = 1/sqrt(2 (cos f - cos t)), f < t."""
    end = np.minimum(theta, angle)
    # f = end sin(v) removes the root at f = t inside the cap
    v, weight = np.polynomial.legendre.leggauss(200)
    v, weight = np.pi / 4 * (v + 1), np.pi / 4 * weight
    f = end[:, None] * np.sin(v)
    below = 4 * np.sin((theta[:, None] + f) / 2) * np.sin((theta[:, None] - f) / 2)  # 2 (cos f - cos t)
    above = 2 * np.sin((angle + f) / 2) * np.sin((angle - f) / 2)
    sums = (above / np.sqrt(below) * end[:, None] * np.cos(v)) @ weight
    return sums / np.sqrt(2 * (1 - np.cos(angle)))


def surface_strain(theta, angle, poisson, count, split=True):
    """(e_theta, e_psi) times G/p0 at 0 < theta < pi/2 by `count` terms; `split`: with the closed sums."""
    theta = np.asarray(theta, float)
    p, cosine, sine = cap_coefficients(count, angle), np.cos(theta), np.sin(theta)
    n = np.arange(count)
    u, t = np.zeros(count), np.zeros(count)
    even = n[::2]
    u[::2], t[::2] = surface_coefficients(even, poisson)
    m, turn = n + 0.5, n * (n + 1.0)
    bend = t * turn  # d2P/dtheta2 = -n (n+1) P - cot dP/dtheta
    displacement = np.zeros_like(theta)
    meridian = np.zeros_like(theta)
    slope = np.zeros_like(theta)
    if split:
        u1, b0 = -(1 - poisson), (1 - 2 * poisson) / 2
        b1 = b0 * (1.5 - 2 * poisson) - 1.25 + poisson
        pressure = np.sqrt(np.maximum(1 - (np.sin(theta / 2) / np.sin(angle / 2)) ** 2, 0))
        over = _over_number(theta, angle) + _over_number(np.pi - theta, angle)
        half2 = np.sin(angle / 2) ** 2
        carried = 2 * half2 / 1.5 * (1 - pressure**3)  # integral of p sin from 0 to theta
        displacement, meridian = u1 * over, b0 * pressure + b1 * over
        slope = -b0 * (carried - p[0] * (1 - cosine)) / sine
        u = np.where(n % 2 == 0, u - u1 / m, 0)
        bend = np.where(n % 2 == 0, bend - b0 - b1 / m, 0)
        t = np.where(n % 2 == 0, t - b0 / np.maximum(turn, 1), 0)
    for k, here, rise in _legendre(count, cosine):
        if k % 2:
            continue
        displacement = displacement + u[k] * p[k] * here
        meridian = meridian + bend[k] * p[k] * here
        slope = slope - (t[k] if k else 0.0) * p[k] * rise / sine
    return displacement - meridian - cosine / sine * slope, displacement + cosine / sine * slope


def half_space_strain(r, poisson):
    """(e_r, e_across) times G/p0 of the surface of a half-space at r/a under Hertz's pressure (Johnson 1985, 3.41)."""
    r = np.asarray(r, float)
    pressure = np.sqrt(np.maximum(1 - r * r, 0))
    across = -(1 - 2 * poisson) / 2 * (1 - pressure**3) / (3 * r * r)
    return -(1 - 2 * poisson) / 2 * pressure - across, across


def elastic_slip(x, y, semi_axis, radius, poisson, count=4000):
    """Slip along x of the sphere, whose axle is parallel to y, over a flat rail, times G/p0, at (x, y)/a.

    With the sign of creepage: strain of the rail along x minus strain of the sphere along its circle. Excludes the
    difference of rolling radii, y^2/(2 R^2).
    """
    r = np.hypot(x, y)
    angle = 2 * np.arcsin(semi_axis / (2 * radius))
    theta = 2 * np.arcsin(r * semi_axis / (2 * radius))
    meridian, across = surface_strain(theta, angle, poisson, count)
    along = (x / r) ** 2
    circle = along / (1 - (np.sin(theta) * y / r) ** 2)
    flat = half_space_strain(r, poisson)
    return along * flat[0] + (1 - along) * flat[1] - circle * meridian - (1 - circle) * across


def _displacement(n, poisson, place):
    """Displacement at `place` in a sphere of radius 1 under the pressure P_n, G = 1 (n > 1)."""
    r = np.linalg.norm(place)
    cosine = place[2] / r
    legendre = np.polynomial.legendre.Legendre.basis(n)
    inner = n * n + n + 1 + (2 * n + 1) * poisson
    a = 1 / (4 * inner)
    b = -a * (n * n + 2 * n - 1 + 2 * poisson) / (n - 1)
    radial = (a * (n + 1) * (n - 2 + 4 * poisson) * r ** (n + 1) + b * n * r ** (n - 1)) * legendre(cosine)
    # u_theta e_theta with dP/dtheta = -sin P', and sin e_theta = cos e_r - e_z
    slope = -(a * (n + 5 - 4 * poisson) * r ** (n + 1) + b * r ** (n - 1)) * legendre.deriv()(cosine)
    outward = place / r
    return radial * outward + slope * (cosine * outward - np.array([0.0, 0.0, 1.0]))


def residuals(n, poisson, step=1e-3):
    """(largest residual force in equilibrium, largest residual traction on the surface), by finite differences."""
    along = np.eye(3)

    def stress(place):
        gradient = np.array([(_displacement(n, poisson, place + step * e) - _displacement(n, poisson, place - step * e))
                             / (2 * step) for e in along])
        strain = (gradient + gradient.T) / 2
        return 2 * strain + 2 * poisson / (1 - 2 * poisson) * np.trace(strain) * np.eye(3)

    inside = np.array([0.3, 0.35, 0.45])
    force = sum((stress(inside + step * e) - stress(inside - step * e)) @ e for e in along) / (2 * step)
    outward = np.array([0.48, 0.36, 0.8])
    pressure = np.polynomial.legendre.Legendre.basis(n)(outward[2])
    return np.abs(force).max(), np.abs(stress(outward) @ outward + pressure * outward).max()
