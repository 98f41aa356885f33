# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slip added by slight curvature to frictionless Hertz contact, to first order, in closed form up to one integral.

The surface z = h = (x^2/R_x + y^2/R_y)/2 of a body above it is moved to z = 0: there the half-space's stresses leave
tractions -d_b(h sigma_ab) - p h_,a along the surface, which strain it as they strain a half-space; and the strain
along x at z = h is that at z = 0 less h d^2 u_z/dx^2. Under Hertz's elliptic pressure all transforms are those of
polynomials along every direction of the wave vector, so that the slip is A + B x^2 + C y^2 inside the ellipse.
Units: mm, p0 = G = 1.
"""
import numpy as np


def _strain(semi_axes, curvatures, poisson, count=720):
    """[e0, e_xx, e_yy] of e_x = e0 + e_xx x^2 + e_yy y^2 on the surface of one body, without the half-space's part."""
    (a, b), (cx, cy) = semi_axes, curvatures
    theta = 2 * np.pi * np.arange(count) / count
    cos, sin = np.cos(theta), np.sin(theta)
    unit = (cos, sin)
    g = np.hypot(a * cos, b * sin)
    wave = np.fft.fftfreq(count, 1 / count)

    def turned(values):
        """Derivative with respect to theta of smooth periodic functions."""
        return np.fft.ifft(1j * wave * np.fft.fft(values)).real

    # A transform P(k) = F(k, theta) of the pressure, integrated along k with cos(k c), is F_0 + F_2 c^2; there k d/dk
    # multiplies c^j by -(j + 1).
    strain = np.zeros((2, count))
    for row, power in enumerate((0, 2)):
        radial = -(power + 1.0)
        pressure = 1 / g if power == 0 else -1 / g**3

        def first(values):
            """k times the gradient by the wave vector."""
            return cos * radial * values - sin * turned(values), sin * radial * values + cos * turned(values)

        def second(values):
            """k^2 (cx d^2/dkx^2 + cy d^2/dky^2)."""
            once = turned(values)
            return ((cx * cos**2 + cy * sin**2) * (radial**2 - radial) * values
                    + 2 * sin * cos * (cy - cx) * (radial - 1) * once
                    + (cx * sin**2 + cy * cos**2) * (turned(once) + radial * values))

        gradient = first(pressure)
        traction = [c * part for c, part in zip((cx, cy), gradient)]
        for i in range(2):
            for j in range(2):
                shape = (2 * poisson if i == j else 0) + (1 - 2 * poisson) * unit[i] * unit[j]
                traction[i] = traction[i] + unit[j] * second(pressure * shape) / 2
        along = cos * traction[0] + sin * traction[1]
        strain[row] = cos * (traction[0] - poisson * cos * along)
    scale = np.pi**2 * a * b / 2 / (4 * np.pi**2) * (2 * np.pi)
    bent = -(1 - poisson) * scale * np.mean(cos**2 * 2 / g**3)  # d^2 u_z/dx^2
    return np.array([scale * np.mean(strain[0]),
                     scale * np.mean(strain[1] * cos**2) - bent * cx / 2,
                     scale * np.mean(strain[1] * sin**2) - bent * cy / 2])


def slip(semi_axes, wheel, rail, poisson):
    """[s0, s_xx, s_yy] of the slip along x, s0 + s_xx x^2 + s_yy y^2, of two like bodies without creepage.

    `semi_axes` (a, b); `wheel`, `rail`: curvatures (1/R_x, 1/R_y), > 0 convex. In units of p0/G, with the sign of
    creepage. Excludes the difference of rolling radii.
    """
    return _strain(semi_axes, rail, poisson) - _strain(semi_axes, wheel, poisson)
