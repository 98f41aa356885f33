#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Displacement of one face of an elastic wedge by a point load on the other: where the coefficients of
halfspace/elasticity/neighbours.cpp come from. The section is solved by quadratic triangles out to 3 m, the direction
along the edge by a Fourier integral. Needs scipy (python3-scipy). Some ten minutes:

    benchmarks/corner.py                # solves wedges of 80 to 270 degrees, prints coefficients and their errors
    benchmarks/corner.py --block 100    # a right angle that is clamped 100 mm from its edge
    benchmarks/corner.py --poisson 0.45 # coefficients for another Poisson's ratio than 0.3
"""

import argparse

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

E, NU, LOAD_AT = 210e3, 0.3, 10.0  # MPa, -, mm from the edge
G = 0.5 * E / (1.0 + NU)
TURNS = [-90, -75, -60, -45, -30, 15, 30, 45, 60, 75, 90, 100]  # degrees; positive: convex
ALONG = np.array([0.0, 2.5, 5, 10, 15, 20, 30, 40])  # mm along the edge
DEGREE = 5


def shapes(x, y):
    """Quadratic shape functions of a triangle and their derivatives: corners, then edges 01, 12, 20."""
    z = 1.0 - x - y
    return (np.array([z * (2 * z - 1), x * (2 * x - 1), y * (2 * y - 1), 4 * z * x, 4 * x * y, 4 * y * z]),
            np.array([[1 - 4 * z, 4 * x - 1, 0, 4 * (z - x), 4 * y, -4 * y],
                      [1 - 4 * z, 0, 4 * y - 1, -4 * x, 4 * x, 4 * (z - y)]]))


def gauss_points():
    """Six points of degree 4 (Dunavant 1985)."""
    for a, weight in ((0.445948490915965, 0.223381589678011), (0.091576213509771, 0.109951743655322)):
        for point in ((a, a), (1 - 2 * a, a), (a, 1 - 2 * a)):
            yield point, weight / 2


class Wedge:
    """Displacements (U_x sin kx, U_y cos kx, U_z cos kx) of a wedge; k < 0 exchanges sine and cosine."""

    def __init__(self, turn, outside):
        interior, per_decade, columns = np.pi - turn, 10, max(8, round(16 * (1 - turn / np.pi)))
        rings = 10.0 ** (1.0 / per_decade)
        count = int(np.ceil(per_decade * np.log10(outside / LOAD_AT)))
        self.radii = LOAD_AT * rings ** np.arange(-per_decade, count + 1)
        radii = np.repeat(self.radii, 2)[:-1]
        radii[1::2] = np.sqrt(self.radii[1:] * self.radii[:-1])
        angles = np.linspace(0.0, interior, 2 * columns + 1)
        self.width = len(angles)
        points = np.stack([np.outer(radii, np.cos(angles)), np.outer(radii, np.sin(angles))], -1).reshape(-1, 2)
        triangles = np.array([t for i in range(0, len(radii) - 2, 2) for j in range(0, self.width - 2, 2)
                              for t in self.halves(i * self.width + j)])
        for a, b, middle in ((0, 1, 3), (1, 2, 4), (2, 0, 5)):
            points[triangles[:, middle]] = 0.5 * (points[triangles[:, a]] + points[triangles[:, b]])
        self.free = np.arange(3 * (len(points) - self.width))  # the last ring is clamped
        self.size = 3 * len(points)
        self.parts = self.stiffness(points, triangles)

    def halves(self, corner):
        """The two triangles of a quadrilateral of 2 by 2 spacings."""
        at = [[corner + i * self.width + j for j in range(3)] for i in range(3)]
        return [(at[0][0], at[2][0], at[2][2], at[1][0], at[2][1], at[1][1]),
                (at[0][0], at[2][2], at[0][2], at[1][1], at[1][2], at[0][1])]

    def stiffness(self, points, triangles):
        """Matrices of k^0, k^1 and k^2."""
        law = np.zeros((6, 6))  # xx yy zz yz xy xz
        law[:3, :3] = 2 * G * NU / (1 - 2 * NU)
        law[range(6), range(6)] += [2 * G] * 3 + [G] * 3
        parts, x, y, z = np.zeros((3, len(triangles), 18, 18)), *(np.arange(6) * 3 + d for d in range(3))
        for point, weight in gauss_points():
            values, slopes = shapes(*point)
            jacobian = np.einsum("an,mnd->mad", slopes, points[triangles])
            by_y, by_z = np.moveaxis(np.linalg.solve(jacobian, np.broadcast_to(slopes, (len(triangles), 2, 6))), 1, 0)
            still, moving = np.zeros((2, len(triangles), 6, 18))
            moving[:, 0, x] = values
            still[:, 1, y], still[:, 2, z], still[:, 3, y], still[:, 3, z] = by_y, by_z, by_z, by_y
            still[:, 4, x], moving[:, 4, y] = by_y, -values
            still[:, 5, x], moving[:, 5, z] = by_z, -values
            weights = weight * np.abs(np.linalg.det(jacobian))[:, None, None]
            product = [weights * np.einsum("mai,ab,mbj->mij", a, law, b, optimize=True)
                       for a, b in ((still, still), (still, moving), (moving, moving))]
            parts += [product[0], product[1] + product[1].transpose(0, 2, 1), product[2]]
        rows = (3 * triangles[:, :, None] + np.arange(3)).reshape(len(triangles), 18)
        index = (np.repeat(rows, 18, 1).ravel(), np.tile(rows, (1, 18)).ravel())
        return [sparse.csc_matrix((p.ravel(), index))[self.free][:, self.free] for p in parts]

    def across_the_edge(self, outs, along):
        return self.displacements(2 * self.width * int(np.argmin(abs(self.radii - LOAD_AT))),
                                  [2 * self.width * i + self.width - 1 for i in outs], along)

    def displacements(self, load, at, along, longest=3e-6, spread=0.0):
        """mm per N by a load at a node: [direction of the load, node, direction, x], axes of the section. `longest`:
        smallest wave number, 1/mm; `spread`: standard deviation of the load along the edge, mm."""
        nodes, weights = np.polynomial.legendre.leggauss(34)
        lower, upper = np.log(longest), np.log(2.0)
        k = np.exp(lower + (upper - lower) * (nodes + 1) / 2)
        weights = weights * (upper - lower) / 2 * k / np.pi * np.exp(-0.5 * (spread * k) ** 2)
        found = np.zeros((3, len(at), 3, len(along)))
        for wave, weight in zip(k, weights):
            for sign, loads in ((1, [1, 2]), (-1, [0])):
                matrix = self.parts[0] + sign * wave * self.parts[1] + wave**2 * self.parts[2]
                forces = np.zeros((len(self.free), len(loads)))
                forces[[3 * load + d for d in loads], range(len(loads))] = 1.0
                solver = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                              options={"SymmetricMode": True})
                moved = np.zeros((self.size, len(loads)))
                moved[self.free] = solver.solve(forces)
                factors = [np.sin(wave * along), np.cos(wave * along), np.cos(wave * along)]
                if sign < 0:
                    factors = [factors[1], factors[0], factors[0]]
                for column, d in enumerate(loads):
                    values = moved[:, column].reshape(-1, 3)[at]
                    found[d] += weight * values[:, :, None] * np.array(factors)[None]
        return found


def in_frames(found, turn):
    """From axes of the section to x, t, n at load and place."""
    interior = np.pi - turn
    c, s = np.cos(interior), np.sin(interior)
    return np.einsum("ad,dock,bc->aobk", [[1, 0, 0], [0, -1, 0], [0, 0, 1]], found, [[1, 0, 0], [0, c, s], [0, s, -c]])


def half_space(kind, xi):
    """Boussinesq and Cerruti (Johnson 1985, 3.2, 3.6), times 2 pi G rho."""
    eta = np.sqrt(1 - xi * xi)
    return {"nn": 1 - NU, "tn": (0.5 - NU) * eta, "xn": (0.5 - NU) * xi, "xx": 1 - NU + NU * xi**2,
            "tt": 1 - NU + NU * eta**2, "xt": NU * xi * eta}[kind]


def samples():
    """Of each kind: turn, x/rho, change of the displacement times 2 pi G rho; the mean of both directions."""
    kinds = {"nn": (2, 2, 1), "tn": (1, 2, -1), "xn": (0, 2, -1), "xx": (0, 0, 1), "tt": (1, 1, 1), "xt": (0, 1, 1)}
    rows = {kind: [] for kind in kinds}
    for degrees in TURNS:
        turn = np.radians(degrees)
        wedge = Wedge(turn, 3e3)
        outs = [i for i, r in enumerate(wedge.radii) if 3.9 < r < 26]
        found = in_frames(wedge.across_the_edge(outs, ALONG), turn)
        rho = np.hypot(LOAD_AT + wedge.radii[outs][:, None], ALONG)
        for kind, (a, b, sign) in kinds.items():
            change = np.pi * G * rho * (found[a, :, b] + sign * found[b, :, a]) - half_space(kind, ALONG / rho)
            near = ALONG / rho < 0.87
            rows[kind] += list(zip(np.full(near.sum(), turn), (ALONG / rho)[near], change[near]))
    return {kind: np.array(row).T for kind, row in rows.items()}


def fit():
    for kind, (turn, xi, change) in samples().items():
        powers = turn[:, None] ** np.arange(1, DEGREE + 1) * (xi if kind in ("xn", "xt") else 1 + 0 * xi)[:, None]
        matrix, weight = np.hstack([powers, powers * xi[:, None] ** 2]), 1 / (0.05 + 0.12 * abs(change))
        found = np.linalg.lstsq(matrix * weight[:, None], change * weight, rcond=None)[0]
        error = abs(matrix @ found - change)
        within = {bound: error[abs(turn) < np.radians(bound + 1)].max() for bound in (60, 75, 90)}
        print(kind, found.round(3).reshape(2, DEGREE).tolist(), "largest error up to",
              ", ".join(f"{bound} degrees {largest:.3f}" for bound, largest in within.items()))


def block(size):
    for degrees in (90, -90):
        wedge = Wedge(np.radians(degrees), size)
        outs = [i for i, r in enumerate(wedge.radii) if 4.5 < r < 21]
        found = in_frames(wedge.across_the_edge(outs, np.zeros(1)), np.radians(degrees))[2, :, 2, 0]
        print(f"{degrees} degrees, 10 kN:",
              "; ".join(f"{wedge.radii[i]:.1f} mm {1e7 * u:.2f} um" for i, u in zip(outs, found)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--block", type=float, metavar="MM", help="distance of the clamped end from the edge")
    parser.add_argument("--poisson", type=float, default=NU, metavar="NU", help="Poisson's ratio (default: %(default)s)")
    options = parser.parse_args()
    NU, G = options.poisson, 0.5 * E / (1.0 + options.poisson)
    if options.block:
        block(options.block)
    else:
        fit()
