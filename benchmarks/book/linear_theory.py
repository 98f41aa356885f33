# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kalker's creepage coefficients by a series, without grid or printed table.

Without slip, a pair of half-spaces that rolls with the creepages xi, eta and the spin phi has in its patch
du_x/dx = xi - phi y, du_y/dx = eta + phi x, and no traction along the leading edge (Kalker 1967; 1990,
chapter 3). Along a chord traction rises from the leading edge as sqrt(a(y) - x) and ends at the trailing edge as
1/sqrt(a(y) + x), with a(y) = a sqrt(1 - y^2/b^2). So

    p = (a(y) - x) [P(x, y) + a(y) Q(x, y)] / sqrt(1 - x^2/a^2 - y^2/b^2)

with polynomials P and Q meets the edge condition exactly; their coefficients follow from least squares over
chords. Displacements are integrated in polar coordinates about each point: along a line through it the integrand is
smooth over sqrt(1 - t^2) (Gauss-Chebyshev), around the point it is periodic (equal weights). For nu = 0 on a circle
the series gives C11 = C22 = 32/(3 pi) to six digits and C23 = 4/3 to nine.
"""
import numpy as np

LOADS = {"even": ("xi",), "odd": ("eta", "phi")}  # by the symmetry of p_x in y


def _chebyshev(degree, x):
    """T_0 to T_degree at x, one row each."""
    rows = np.empty((degree + 1, x.size))
    rows[0] = 1.0
    if degree:
        rows[1] = x.ravel()
    for k in range(2, degree + 1):
        rows[k] = 2 * rows[1] * rows[k - 1] - rows[k - 2]
    return rows


class Ellipse:
    """Integrals of every term of the series over the ellipse a b = 1 with a/b = ratio, for any Poisson's ratio."""

    def __init__(self, ratio, degree, nodes, turns):
        self.a, self.b, self.degree = ratio**0.5, ratio**-0.5, degree
        chords = int(1.4 * degree) + 4
        self.y = np.cos((np.arange(chords) + 0.5) * np.pi / (2 * chords))
        self.x = np.cos((np.arange(int(1.6 * degree) + 5) + 0.5) * np.pi / (int(1.6 * degree) + 5))
        self.influence = np.array([self._influence(s * np.sqrt(1 - y * y), y, turns, nodes)
                                   for y in self.y for s in self.x])
        self.force = self._force(8 * degree + 40)

    def _influence(self, x, y, turns, nodes):
        """Displacement at a point by every term: kernels 1/R times 1, cos^2, sin^2, sin cos; P, Q; degrees in x, y."""
        # In the plane where the ellipse is a circle; directions are denser where the kernel is steep.
        even, slender = np.pi * ((np.arange(turns) + 0.5) / turns - 0.5), (self.a / self.b)**0.5
        angle = np.arctan(slender * np.tan(even))
        weight = np.pi / turns * slender / (np.cos(even)**2 + (slender * np.sin(even))**2)
        c, s = np.cos(angle), np.sin(angle)
        reach = np.hypot(self.a * c, self.b * s)
        t = np.cos((np.arange(nodes) + 0.5) * np.pi / nodes)
        along = -(x * c + y * s)[:, None] + np.sqrt(1 - (x * s - y * c)**2)[:, None] * t
        px, py = x + along * c[:, None], y + along * s[:, None]
        half = np.sqrt(np.maximum(1 - py * py, 0))
        tx, ty = _chebyshev(self.degree, px), _chebyshev(self.degree, py)
        base = (weight / nodes * self.a * self.b / reach)[:, None] * (half - px)
        cos, sin = self.a * c / reach, self.b * s / reach
        return [(tx * (base * kernel[:, None] * factor).ravel()) @ ty.T
                for kernel in (np.ones(turns), cos * cos, sin * sin, cos * sin) for factor in (1.0, half)]

    def _force(self, count):
        """Integral over the ellipse of every term times 1, x, y."""
        node, weight = np.polynomial.legendre.leggauss(count)
        y = np.sin(np.pi / 2 * node)[:, None]
        x = np.sqrt(1 - y * y) * np.cos((np.arange(count) + 0.5) * np.pi / count)
        y = y + 0 * x
        half = np.sqrt(1 - y * y)
        base = (weight * np.pi / 2 * np.cos(np.pi / 2 * node) * np.pi / count)[:, None] * (half - x) * self.a * self.b
        tx, ty = _chebyshev(self.degree, x), _chebyshev(self.degree, y)
        return {name: [(tx * (base * arm * factor).ravel()) @ ty.T for factor in (1.0, half)]
                for name, arm in (("1", 1.0 + 0 * x), ("x", self.a * x), ("y", self.b * y))}

    def _terms(self, parity):
        """(factor, degree in x, degree in y) of the terms that are even (0) or odd (1) in y."""
        return [(q, m, n) for q in (0, 1) for m in range(self.degree + 1)
                for n in range(parity, self.degree + 1 - m - q, 2)]

    def _solve(self, poisson, parity, loads):
        """Terms of p_x and p_y, with a column of coefficients for each load."""
        terms = self._terms(parity), self._terms(1 - parity)

        def moved(kernels, chosen):
            total = sum(k * self.influence[:, 2 * place:2 * place + 2] for place, k in enumerate(kernels))
            return np.array([total[:, q, m, n] for q, m, n in chosen]).T
        cross = (0, 0, 0, poisson)
        matrix = np.block([[moved((1 - poisson, poisson, 0, 0), terms[0]), moved(cross, terms[1])],
                           [moved(cross, terms[0]), moved((1 - poisson, 0, poisson, 0), terms[1])]])
        x = np.concatenate([self.a * self.x * np.sqrt(1 - y * y) for y in self.y])
        y = self.b * np.repeat(self.y, len(self.x))
        wanted = {"xi": (x, 0 * x), "eta": (0 * x, x), "phi": (-x * y, x * x / 2)}
        right = np.array([np.concatenate(wanted[load]) for load in loads]).T

        def of_chords(columns):
            """Subtracts the mean over each chord, whose displacement is free, weighted by the chord's length."""
            rows = columns.reshape(2, len(self.y), len(self.x), -1)
            rows = (rows - rows.mean(axis=2, keepdims=True)) * ((1 - self.y**2)**0.25)[None, :, None, None]
            return rows.reshape(len(columns), -1)
        matrix, right = of_chords(matrix), of_chords(right)
        scale = np.linalg.norm(matrix, axis=0)
        return terms, np.linalg.lstsq(matrix / scale, right, rcond=1e-13)[0] / scale[:, None]

    def _sum(self, arm, chosen):
        return np.array([self.force[arm][q][m, n] for q, m, n in chosen])

    def coefficients(self, poisson):
        """{"C11", "C22", "C23", "C32", "C33"} with G = 1, a b = 1; C32 = -C23 is a result, not an assumption."""
        (along, across), found = self._solve(poisson, 0, LOADS["even"])
        result = {"C11": self._sum("1", along) @ found[:len(along), 0]}
        (along, across), found = self._solve(poisson, 1, LOADS["odd"])
        lateral = self._sum("1", across) @ found[len(along):]
        moment = self._sum("x", across) @ found[len(along):] - self._sum("y", along) @ found[:len(along)]
        result.update({"C22": lateral[0], "C23": lateral[1], "C32": moment[0], "C33": moment[1]})
        return {name: -float(value) for name, value in result.items()}


def coefficients(ratio, poissons, degree=14):
    """{nu: {name: (value, bar)}} for a/b = ratio: the bar is the change from a degree lower by 4."""
    # Poles of the integrand over the angle come closer for slender ellipses.
    turns = 10 * max(1.0, 0.1 / min(ratio, 1 / ratio))**0.5
    fine, coarse = (Ellipse(ratio, d, 6 * d, int(turns * d)) for d in (degree, degree - 4))
    result = {}
    for nu in poissons:
        best, other = fine.coefficients(nu), coarse.coefficients(nu)
        result[nu] = {name: (best[name], abs(best[name] - other[name])) for name in best}
    return result
