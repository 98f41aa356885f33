# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms, independent of the program's code, so that the book does not check a formula against itself.

Units mm, N, MPa. Elastic constants are G and nu of like bodies; E* = G/(1 - nu) unless stated otherwise.
"""
import numpy as np


def elliptic_integrals(k2):
    """Complete K(k), E(k) of the parameter k^2, by the arithmetic-geometric mean (Abramowitz 17.6)."""
    a, b, c, power, sum_ = 1.0, np.sqrt(1.0 - k2), np.sqrt(k2), 1.0, 0.5 * k2
    while c > 1e-16:
        a, b, c = (a + b) / 2, np.sqrt(a * b), (a - b) / 2
        power *= 2
        sum_ += power * c * c / 2
    first = np.pi / (2 * a)
    return first, first * (1.0 - sum_)


def _sides(k2):
    """A and B of h = A x^2 + B y^2 times E*/p0 times the longer semi-axis, which lies along x, for e^2 = k2."""
    first, second = elliptic_integrals(k2)
    ratio = np.sqrt(1 - k2)
    return ratio / k2 * (first - second), ratio / k2 * (second / ratio**2 - first)


def hertz_curvatures(semi_axis_x, semi_axis_y, force, modulus):
    """(A, B) of the bodies whose ellipse has these semi-axes: the inverse of hertz."""
    longer, shorter = max(semi_axis_x, semi_axis_y), min(semi_axis_x, semi_axis_y)
    pressure = 1.5 * force / (np.pi * longer * shorter)
    if longer == shorter:
        return (np.pi * pressure / (4 * modulus * longer),) * 2
    small, large = (float(side * pressure / (modulus * longer)) for side in _sides(1 - (shorter / longer) ** 2))
    return (small, large) if semi_axis_x > semi_axis_y else (large, small)


def hertz(curvature_x, curvature_y, force, modulus):
    """(a along x, b along y, p0, approach) of h = A x^2 + B y^2 under a force (Johnson 1985, 4.26-4.32).

    The ratio of the semi-axes follows from B/A by bisection; curvatures A, B in 1/mm.
    """
    turned = curvature_x > curvature_y
    small, large = sorted((curvature_x, curvature_y))
    if large / small < 1 + 1e-9:
        radius = (3 * force / (8 * modulus * small)) ** (1 / 3)
        pressure = 1.5 * force / (np.pi * radius**2)
        return radius, radius, pressure, 2 * small * radius**2
    low, high = 1e-12, 1 - 1e-12
    for _ in range(200):
        k2 = (low + high) / 2
        a_side, b_side = _sides(k2)
        low, high = (k2, high) if b_side / a_side < large / small else (low, k2)
    ratio = np.sqrt(1 - k2)
    # A = (p0/E*) side/a and p0 = 3F/(2 pi a b), b = ratio a
    longer = (1.5 * force / (np.pi * ratio) * _sides(k2)[0] / (modulus * small)) ** (1 / 3)
    shorter = ratio * longer
    pressure = 1.5 * force / (np.pi * longer * shorter)
    approach = pressure / modulus * shorter * elliptic_integrals(k2)[0]
    axes = (shorter, longer) if turned else (longer, shorter)
    return (*axes, pressure, approach)


def carter_traction(x, semi_axis, pressure, friction, contact_modulus, creepage):
    """Tangential traction (against the sliding, MPa) of two like cylinders at x, + leading (Carter 1926).

    `contact_modulus` is G/(1 - nu) of either body; creepage > 0. With R the relative radius,
    p0 = (a/R) G/(2 (1 - nu)), and the adhesion zone has the half width a' = a - xi R/mu.
    """
    radius = semi_axis * contact_modulus / (2 * pressure)
    stick = max(semi_axis - creepage * radius / friction, 0.0)
    whole = np.sqrt(np.maximum(1 - (x / semi_axis) ** 2, 0))
    part = 0.0
    if stick > 0:
        part = stick / semi_axis * np.sqrt(np.maximum(1 - ((x - (semi_axis - stick)) / stick) ** 2, 0))
    return friction * pressure * (whole - part)


def carter_force(semi_axis, pressure, friction, contact_modulus, creepage):
    """Force per width in N/mm: (1 - (a'/a)^2) mu P, P = pi a p0/2."""
    radius = semi_axis * contact_modulus / (2 * pressure)
    stick = max(semi_axis - creepage * radius / friction, 0.0)
    return (1 - (stick / semi_axis) ** 2) * friction * np.pi * semi_axis * pressure / 2


def carter_slip(x, semi_axis, friction, radius, creepage):
    """Slip of the wheel over the rolling speed within the patch, 0 in the adhesion zone; `radius` is the relative one."""
    stick = max(semi_axis - creepage * radius / friction, 0.0)
    behind = np.minimum(x - (semi_axis - stick), 0.0)
    return friction / radius * np.sqrt(np.maximum(behind**2 - stick**2, 0.0))


def line_approach(force, half_width, modulus, distance):
    """Displacement in the middle of Hertz's pressure of a line relative to the surface at `distance`, both bodies, mm."""
    return 2 * force / (np.pi * modulus) * (np.log(2 * distance / half_width) + 0.5)


def mindlin_traction(r, radius, pressure, friction, part):
    """Traction under a sphere pushed with `part` of mu P (Cattaneo 1938; Johnson 1985, 7.37)."""
    stick = (1 - part) ** (1 / 3) * radius
    whole = np.sqrt(np.maximum(1 - (r / radius) ** 2, 0))
    inner = np.sqrt(np.maximum(1 - (r / stick) ** 2, 0)) * stick / radius
    return friction * pressure * (whole - inner)


def mindlin_shift(radius, force, friction, shear_modulus, poisson, part):
    """Shift of like bodies in mm at a push of `part` of mu P, monotonous from rest (Mindlin 1949)."""
    compliance = 2 * (2 - poisson) / shear_modulus
    return 3 * friction * force / (16 * radius) * compliance * (1 - (1 - part) ** (2 / 3))


def mindlin_part(radius, force, friction, shear_modulus, poisson, shift):
    """The fraction of mu P at a given shift: the inverse of mindlin_shift."""
    compliance = 2 * (2 - poisson) / shear_modulus
    reduced = 1 - shift * 16 * radius / (3 * friction * force * compliance)
    return 1 - max(reduced, 0.0) ** 1.5


def circle_axis_stress(depth, poisson):
    """(sigma_r, sigma_z)/p0 on the axis below Hertz's circle, at depth/a > 0 (Johnson 1985, 3.45)."""
    z = np.asarray(depth, float)
    radial = -(1 + poisson) * (1 - z * np.arctan(1 / z)) + 0.5 / (1 + z * z)
    return radial, -1 / (1 + z * z)


def mcewen(x, z, friction, poisson):
    """Stresses [n, 6] (xx, yy, zz, xy, yz, xz) over p0 in the upper half-plane under p0 sqrt(1 - x^2) and `friction` times it along +x;
    x and z > 0 over the half width (McEwen 1949; Johnson 1985, 4.2 and 7.1)."""
    x, z = np.broadcast_arrays(np.asarray(x, float), np.asarray(z, float))
    half = 1 - x * x + z * z
    root = np.hypot(half, 2 * x * z)
    m, n = np.sqrt((root + half) / 2), np.copysign(np.sqrt(np.maximum(0, (root - half) / 2)), x)
    part = (z * z + n * n) / (m * m + n * n)
    direct, shear = 2 * z - m * (1 + part), n * (m * m - z * z) / (m * m + n * n)
    xx = direct + friction * (n * (2 - (z * z - m * m) / (m * m + n * n)) - 2 * x)
    zz = -m * (1 - part) - friction * shear
    return np.stack([xx, poisson * (xx + zz), zz, 0 * x, 0 * x, friction * direct - shear], axis=-1)


def persson(half_angle):
    """(E1* dR/Q, p(0) R/Q) of a pin in the hole of a plate, contact over 2 half_angle (Persson 1964).

    Like bodies in plane strain, E1* = E/(1 - nu^2) of one of them, dR the clearance, Q per length.
    """
    b2 = np.tan(half_angle / 2) ** 2
    clearance = (2 * (1 - b2**2) - np.log(1 + b2)) / (np.pi * b2 * (1 + b2))
    whole, root = np.sqrt(1 + b2), np.sqrt(b2)
    pressure = 2 / (np.pi * whole) * root + np.log((whole + root) / (whole - root)) / (2 * np.pi * b2 * (1 + b2))
    return clearance, pressure


def mindlin_loss(radius, force, friction, shear_modulus, poisson, part):
    """Work lost in a cycle between +-part of mu P, N mm (Mindlin and Deresiewicz 1953)."""
    compliance = 2 * (2 - poisson) / shear_modulus
    rest = 1 - part
    form = 1 - rest ** (5 / 3) - 5 * part / 6 * (1 + rest ** (2 / 3))
    return 9 * (friction * force) ** 2 / (10 * radius) * compliance * form


def moving_wave(fraction_of_rayleigh, poisson):
    """Deflection under p0 cos(k x) moving over a half-space, over p0/(G k) (Cole and Huth 1958)."""
    if fraction_of_rayleigh == 0:
        return 1 - poisson
    ratio = (1 - 2 * poisson) / (2 - 2 * poisson)  # (c_s/c_p)^2

    def shape(m):
        """a_p m and the Rayleigh function, for m = (V/c_s)^2."""
        first, second = np.sqrt(1 - m * ratio), np.sqrt(1 - m)
        return first * m, 4 * first * second - (1 + second * second) ** 2

    low, high = 0.5, 1 - 1e-12  # the Rayleigh wave, where the function passes through zero
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if shape(middle)[1] > 0 else (low, middle)
    above, below = shape(low * fraction_of_rayleigh**2)
    return above / below


def free_rolling_creepage(friction_free_factor, semi_axis, radius):
    """Creepage of free rolling of unlike cylinders in full slip (Bentall and Johnson 1967).

    `friction_free_factor` is kappa = 2 beta (twice Dundurs' constant), `radius` the relative one. The point of
    no slip c a follows from the balance of forces, asin c + c sqrt(1 - c^2) = pi/4.
    """
    low, high = 0.0, 1.0
    for _ in range(60):
        c = (low + high) / 2
        low, high = (c, high) if np.arcsin(c) + c * np.sqrt(1 - c * c) < np.pi / 4 else (low, c)
    return np.sqrt(1 - low * low) / 2 * friction_free_factor * semi_axis / radius


def adhesive_free_rolling(beta):
    """(xi R/a, largest pressure over Hertz's) of unlike cylinders in free rolling with full adhesion.

    `beta` is Dundurs' constant of the pair, a Hertz's half width. p + i q is the jump across the patch of
    z - i xi - (z - 1)^(1/2 + i e) (z + 1)^(1/2 - i e), 2 pi e = ln((1 + beta)/(1 - beta)), which leaves no force along
    the surface for xi R/b = 2 e; then b = a/sqrt(1 + 4 e^2).
    """
    exponent = np.log((1 + beta) / (1 - beta)) / (2 * np.pi)
    narrower = 1 / np.sqrt(1 + 4 * exponent**2)
    return 2 * exponent * narrower, np.cosh(np.pi * exponent) * narrower


def flat_profile(exponent, semi_axis, edge, modulus):
    """(force, approach, pressure as a function of r) of h = edge (r/a)^(2n), n = 2 or 3, without friction.

    Steuermann (1939); by Sneddon's integrals with d(t) = t int_0^t h'(r)/sqrt(t^2 - r^2) dr: the approach is d(a), the
    force 2 E* int_0^a (d(a) - d(t)) dt, the pressure (E*/pi) int_r^a d'(t)/sqrt(t^2 - r^2) dt. For n = 2 the force is
    64 E* A a^5/15.
    """
    depth = edge * {2: 8 / 3, 3: 16 / 5}[exponent]

    def pressure(r):
        square = np.minimum((np.asarray(r) / semi_axis) ** 2, 1)
        root = np.sqrt(1 - square)
        inner = (root**3 / 3 + square * root if exponent == 2
                 else root**5 / 5 + 2 * square * root**3 / 3 + square**2 * root)
        return 2 * exponent * depth * modulus / (np.pi * semi_axis) * inner
    return 4 * exponent / (2 * exponent + 1) * modulus * depth * semi_axis, depth, pressure


def sneddon(exponent, semi_axis, edge, modulus, r):
    """(force, approach, pressure at r) of the same body from Sneddon's integrals by quadrature."""
    node, weight = np.polynomial.legendre.leggauss(40)
    node, weight = (node + 1) / 2, weight / 2

    def depth(t):
        places = np.multiply.outer(t, np.sin(np.pi / 2 * node))
        return t * np.pi / 2 * (2 * exponent * edge / semi_axis * (places / semi_axis) ** (2 * exponent - 1) @ weight)
    reach, step = np.sqrt(semi_axis**2 - r**2), 1e-4 * semi_axis
    t = np.hypot(r, reach * node)
    rise = (depth(t + step) - depth(t - step)) / (2 * step)
    return (2 * modulus * semi_axis * (depth(semi_axis) - depth(semi_axis * node)) @ weight, depth(semi_axis),
            modulus / np.pi * reach * (rise / t) @ weight)


def _bessel(order, argument):
    """J_n by its integral; the rule of midpoints is exact to rounding for a periodic function."""
    t = (np.arange(200) + 0.5) * np.pi / 200
    return np.mean(np.cos(order * t - argument * np.sin(t)))


def creep_response(wave, distance):
    """F/F_0 of line contact in full adhesion under the creepage xi e^(i w t); `wave` is w a/V.

    Displacements are relative to that at `distance` (over a) from the contact; F_0 is the force of steady creepage.
    """
    edge = _bessel(0, wave) + 1j * _bessel(1, wave)
    return edge / (_bessel(0, wave) + 1j * wave * np.log(2 * distance) * edge)
