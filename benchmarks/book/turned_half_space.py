# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conformal contact on a half-space bent with the surface, independent of the program: CONTACT's method, step by step.

Elements lie along the arc of the common circle of both bodies. Their influence is that of the half-space rolled out flat;
*turned*, the displacement of an element I by tractions on J has the direction of the frame of J and is taken along that of
I (CONTACT's variant 3 of the coefficients of Blanco-Lorenzo et al. 2016):

    u_s(I) = cos a u_s - sin a u_n,   u_n(I) = sin a u_s + cos a u_n,   a = angle of J minus angle of I

so that between like bodies pressure is coupled to friction. mm, N, MPa, rad; x along rolling, s along the arc, n into the
wheel; tractions are those on the wheel, p_n > 0 in compression.
"""
from dataclasses import dataclass

import numpy as np


@dataclass
class Scene:
    """Circles across: convex `inner` in hollow `outer`; in a groove the wheel is the convex body, otherwise the hollow
    one."""

    inner: float
    outer: float
    rolling_radius: float
    wheel_is_inner: bool
    shear_modulus: float
    poisson: float = 0.28
    friction: float = 0.3
    along_the_normal: bool = False  # the distance x^2/(2 R) is along the normal, as in CONTACT's example


class Patch:
    """Elements of dx by ds over +-reach_x by +-reach_s, an odd number each way, with the undeformed distance."""

    def __init__(self, scene, dx, ds, reach_x, reach_s):
        self.scene, self.dx, self.ds, self.area = scene, dx, ds, dx * ds
        count = [2 * int(np.ceil(reach / size)) + 1 for reach, size in ((reach_s, ds), (reach_x, dx))]
        self.shape = tuple(count)
        self.s, self.x = (axis.ravel() for axis in np.meshgrid(
            (np.arange(count[0]) - count[0] // 2) * ds, (np.arange(count[1]) - count[1] // 2) * dx, indexing="ij"))
        radius = (scene.inner + scene.outer) / 2
        self.lean = (1 if scene.wheel_is_inner else -1) * self.s / radius  # angle of the normal, seen along rolling
        self.cosine, self.sine = np.cos(self.lean), np.sin(self.lean)
        beside = radius - scene.inner  # distance of the common circle's centre from either of the others
        inner = beside * self.cosine + np.sqrt(scene.inner**2 - (beside * self.sine) ** 2)
        outer = -beside * self.cosine + np.sqrt(scene.outer**2 - (beside * self.sine) ** 2)
        fall = radius * (1 - self.cosine) * (1 if scene.wheel_is_inner else -1)
        if scene.along_the_normal:
            along = self.x**2 / (2 * scene.rolling_radius)
        else:
            local = scene.rolling_radius - fall
            along = (local - np.sqrt(local**2 - self.x**2)) * self.cosine
        self.distance = outer - inner + along
        wheel = scene.inner if scene.wheel_is_inner else -scene.outer
        place = radius * self.sine
        self.drop = wheel - np.sign(wheel) * np.sqrt(wheel**2 - np.minimum(np.abs(place), 0.999 * abs(wheel)) ** 2)

    def influence(self, to, source, turned, ahead=0.0):
        """Displacement [i][j] at elements `to`, shifted by `ahead` along x, under unit tractions j on `source`."""
        xx, yy, xy, nn = coefficients(self.x[to][:, None] + ahead - self.x[source], self.s[to][:, None] - self.s[source],
                                       self.dx, self.ds, self.scene.shear_modulus, self.scene.poisson)
        none = 0 * nn
        if not turned:
            return [[xx, xy, none], [xy, yy, none], [none, none, nn]]
        turn = self.lean[source] - self.lean[to][:, None]
        c, s = np.cos(turn), np.sin(turn)
        return [[xx, xy, none], [c * xy, c * yy, -s * nn], [s * xy, s * yy, c * nn]]


def coefficients(x, y, dx, dy, shear_modulus, poisson):
    """xx, yy, xy, nn of both bodies together, at (x, y) from the middle of a loaded element."""
    def corners(primitive):
        a, b = dx / 2, dy / 2
        return primitive(x + a, y + b) - primitive(x - a, y + b) - primitive(x + a, y - b) + primitive(x - a, y - b)

    def asinh(of, by):
        return np.arcsinh(of / np.where(by == 0, 1e-30, np.abs(by)))
    along, across = corners(lambda u, v: u * asinh(v, u)), corners(lambda u, v: v * asinh(u, v))
    nu, factor = poisson, 1 / (np.pi * shear_modulus)
    both = (1 - nu) * (along + across)
    return (factor * (both + nu * across), factor * (both + nu * along), factor * -nu * corners(np.hypot), factor * both)


def coupling(x, y, dx, dy):
    """The integrals of x/r^2 and y/r^2 over a loaded element: along the surface under pressure, between unlike bodies."""
    def over(u, v, du, dv):
        def primitive(a, b):
            return b * np.log(np.hypot(a, b)) + a * np.arctan(b / a)
        a, b = du / 2, dv / 2
        return primitive(u + a, v + b) - primitive(u - a, v + b) - primitive(u + a, v - b) + primitive(u - a, v - b)
    return over(x, y, dx, dy), over(y, x, dy, dx)


def pressure(patch, approach, turned, tractions=None, guess=None):
    """p_n at that approach, including displacements by given (p_x, p_s); active set on the overlapping elements."""
    overlap = patch.distance - approach * patch.cosine
    near = np.where(overlap < 0)[0]
    matrix = patch.influence(near, near, turned)[2]
    right = -overlap[near]
    if tractions is not None:
        right = right - matrix[0] @ tractions[0][near] - matrix[1] @ tractions[1][near]
    active = np.ones(len(near), bool) if guess is None else guess[near] > 0
    for _ in range(60):
        found = np.zeros(len(near))
        inside = np.where(active)[0]
        found[inside] = np.linalg.solve(matrix[2][np.ix_(inside, inside)], right[inside])
        pulled = found < 0
        open_ = matrix[2] @ np.maximum(found, 0) - right
        new = (active & ~pulled) if pulled.any() else (active | (open_ < -1e-12))
        if np.array_equal(new, active):
            break
        active = new
    result = np.zeros(len(patch.x))
    result[near] = np.maximum(found, 0)
    return result


def tractions(patch, normal, creepage, turned, start=None):
    """(p_x, p_s) of steady rolling under that pressure; first-order differences, Newton's method."""
    inside = np.where(normal > 0)[0]
    count = len(inside)
    here, ahead = patch.influence(inside, inside, turned), patch.influence(inside, inside, turned, patch.dx)
    slip_by = [[(here[i][j] - ahead[i][j]) / patch.dx for j in range(3)] for i in range(2)]
    turning = (1 - creepage) / patch.scene.rolling_radius
    rigid = np.concatenate([creepage + turning * patch.drop[inside] + slip_by[0][2] @ normal[inside],
                            -turning * patch.sine[inside] * patch.x[inside] + slip_by[1][2] @ normal[inside]])
    matrix = np.block([row[:2] for row in slip_by])
    bound = patch.scene.friction * normal[inside]
    scale = 1 / np.mean(np.diag(matrix))
    t = np.zeros(2 * count) if start is None else np.concatenate([part[inside] for part in start])

    def residual(t):
        q = t - scale * (rigid + matrix @ t)
        length = np.hypot(q[:count], q[count:])
        share = np.where(length > bound, bound / np.maximum(length, 1e-30), 1.0)
        return t - np.tile(share, 2) * q, q, length, share
    for _ in range(60):
        lack, q, length, share = residual(t)
        if np.abs(lack).max() < 1e-7 * bound.max():
            break
        slips = (length > bound) / np.maximum(length, 1e-30)
        held = np.maximum(np.maximum(bound, np.hypot(t[:count], t[count:])), 1e-30)
        move = np.eye(2 * count) - scale * matrix
        along = (q[:count] * slips)[:, None] * move[:count] + (q[count:] * slips)[:, None] * move[count:]
        kept = np.vstack([share[:, None] * (move[:count] - (t[:count] / held)[:, None] * along),
                          share[:, None] * (move[count:] - (t[count:] / held)[:, None] * along)])
        step, part = np.linalg.solve(np.eye(2 * count) - kept, -lack), 1.0
        while part > 0.05 and np.linalg.norm(residual(t + part * step)[0]) >= np.linalg.norm(lack):
            part /= 2
        t = t + part * step
    result = np.zeros((2, len(patch.x)))
    result[:, inside] = t.reshape(2, count)
    return result


def under_force(patch, force, approach, turned, creepage=None, feedback=False):
    """{p0, approach, friction_part, F_x} under a force along z; `creepage` None: no friction.

    `approach`: a first guess. `feedback`: friction displaces the surfaces along the normal; without it friction only
    carries its part of the load, and the pressure is solved once (Johnson's process).
    """
    tried, friction, normal = [], None, None
    for _ in range(20):
        normal = pressure(patch, approach, turned, friction if feedback else None, normal)
        if creepage is not None:
            friction = tractions(patch, normal, creepage, turned, friction)
        carried = 0.0 if friction is None else patch.area * (friction[1] @ patch.sine)
        found = patch.area * (normal @ patch.cosine) + carried
        tried.append((np.log(approach), np.log(found)))
        if abs(found / force - 1) < 2e-5:
            break
        slope = 1.4 if len(tried) < 2 else np.clip(np.diff(tried[-2:], axis=0)[0] @ [0, 1]
                                                   / (np.diff(tried[-2:], axis=0)[0] @ [1, 0]), 0.8, 3.0)
        approach *= (force / found) ** (1 / slope)
    return {"p0": normal.max(), "approach": approach, "friction_part": carried / force,
            "F_x": 0.0 if friction is None else patch.area * friction[0].sum()}
