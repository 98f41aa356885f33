# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steady rolling of like cylinders with an elastic layer between them, by collocation: Carter's problem with a layer.

Shares nothing with the program: tractions are linear between nodes, slip vanishes in the middle of elements, and the end
of the adhesion area is searched for, in place of constant tractions, differences along streamlines and an active set.
"""
import numpy as np


def _strain_matrix(node, middle):
    """The integral of q(s)/(x - s) at `middle` by the values of q at `node`, q being linear in between."""
    left, right = node[:-1], node[1:]
    length = right - left
    logarithm = np.log(np.abs((middle[:, None] - left) / (middle[:, None] - right)))
    second = ((middle[:, None] - left) * logarithm - length) / length
    matrix = np.zeros((len(middle), len(node)))
    matrix[:, :-1] += logarithm - second
    matrix[:, 1:] += second
    return matrix


def creep_force(semi_axis, pressure, friction, modulus, creepage, compliance, elements=600):
    """Force per width in N/mm, opposite to the sliding.

    `modulus`: E* of both bodies, 1/E* = 2 (1 - nu^2)/E; `compliance`: thickness over shear modulus of the layer in mm/MPa.
    Slip-free where (2/(pi E*)) int q(s)/(x - s) ds - compliance q'(x) = xi; q = 0 where material enters, at x = a.
    """
    angle = np.linspace(np.pi, 0, elements + 1)  # dense towards both edges
    node = semi_axis * np.cos(angle)
    middle, length = (node[:-1] + node[1:]) / 2, np.diff(node)
    matrix = 2 / (np.pi * modulus) * _strain_matrix(node, middle)
    matrix[np.arange(elements), np.arange(elements)] += compliance / length
    matrix[np.arange(elements), np.arange(1, elements + 1)] -= compliance / length
    bound = friction * pressure * np.sqrt(np.maximum(1 - (node / semi_axis) ** 2, 0))

    def traction(first):
        """With adhesion in all elements from `first` on, sliding before."""
        q = bound.copy()
        free = np.arange(first + 1, elements)
        if first < elements:
            slip_free = slice(first + 1, elements) if len(free) else slice(0, 0)
            known = matrix[slip_free] @ np.where(np.isin(np.arange(elements + 1), free), 0.0, q)
            q[free] = np.linalg.solve(matrix[slip_free][:, free], creepage - known)
        return q

    low, high = 0, elements  # the smallest `first` at which adhesion begins below the bound
    while low < high:
        first = (low + high) // 2
        q = traction(first)
        if np.all(q[first + 1:elements] <= bound[first + 1:elements]):
            high = first
        else:
            low = first + 1
    return np.trapz(traction(low), node)
