# SPDX-License-Identifier: LGPL-2.1-or-later
"""Temperature and thermal stress below the heated surface of a body: conduction into the depth alone, as the surface temperature
is computed (Carslaw and Jaeger 1959, 2.9). The layer is thin beside the patch, so that the material around holds it: the thermal
stress is the same along and across, -E alpha (T - T_0)/(1 - nu), and nothing else (Johnson 1985, 12.2)."""
import math
from typing import Any

import numpy as np

_erfc = np.frompyfunc(math.erfc, 1, 1)
_FAR = 6.0  # depth over 2 sqrt(kappa t) from which nothing arrives


def _ierfc(u: np.ndarray) -> np.ndarray:
    """The integral of erfc from u to infinity."""
    near = np.minimum(u, _FAR)
    return np.where(u < _FAR, np.exp(-near * near) / math.sqrt(math.pi) - near * _erfc(near).astype(float), 0.0)


class HeatedBody:
    """A body below the contact at one load point."""

    def __init__(self, constants: tuple[float, ...], elastic: tuple[float, float], grid: Any, surface: np.ndarray) -> None:
        """`constants`: as of _core.heated_body; `elastic`: E in MPa and nu; `grid`: the model's; `surface`: temperatures [ny, nx]."""
        effusivity, self.diffusivity, self.before, expansion, self.speed = constants
        self.conductivity = effusivity * math.sqrt(self.diffusivity)
        self.by_kelvin = -elastic[0] * expansion / (1 - elastic[1])
        self.grid, rows = grid, surface - self.before
        weights, flow = self._warming(np.zeros(1))[0], np.zeros_like(rows)
        # The heat flow of every element that leads to these temperatures, N/(mm s), from the leading edge.
        for i in reversed(range(rows.shape[1])):
            flow[:, i] = (rows[:, i] - flow[:, i + 1:] @ weights[1:rows.shape[1] - i]) / weights[0]
        self._flow = np.hstack([flow, np.zeros_like(flow)])

    def _warming(self, depths: np.ndarray) -> np.ndarray:
        """K by a flow of 1 N/(mm s) through an element, at depths over the distance from it in elements: [depth, distance]."""
        passed = np.maximum(0.0, np.arange(len(self.grid.x) + 1) - 0.5) * self.grid.dx / self.speed
        length = np.sqrt(self.diffusivity * passed)[None, :]
        ratio = np.divide(depths[:, None], 2 * length, out=np.full((len(depths), length.shape[1]), math.inf), where=length > 0)
        heat = 2 * length * _ierfc(np.where(depths[:, None] > 0, ratio, 0.0)) / self.conductivity
        return np.diff(heat, axis=1)

    def rise(self, places: np.ndarray) -> np.ndarray:
        """K above the temperature before contact at places [n, 3], mm; linear between the middles of elements, 0 off the grid."""
        grid = self.grid
        depths, which = np.unique(np.abs(places[:, 2]), return_inverse=True)
        warming = self._warming(depths)
        i = np.clip((places[:, 0] - grid.x[0]) / grid.dx, 0, len(grid.x) - 1)
        j = np.clip((places[:, 1] - grid.y[0]) / grid.dy, 0, len(grid.y) - 1)
        inside = (np.abs(places[:, 0] - 0.5 * (grid.x[0] + grid.x[-1])) <= 0.5 * len(grid.x) * grid.dx)
        if len(grid.y) > 1:
            inside &= np.abs(places[:, 1] - 0.5 * (grid.y[0] + grid.y[-1])) <= 0.5 * len(grid.y) * grid.dy
        found, ahead = np.zeros(len(places)), np.arange(warming.shape[1])
        for n in np.flatnonzero(inside):
            for row, across in ((int(j[n]), 1 - j[n] % 1), (min(int(j[n]) + 1, len(grid.y) - 1), j[n] % 1)):
                for column, along in ((int(i[n]), 1 - i[n] % 1), (min(int(i[n]) + 1, len(grid.x) - 1), i[n] % 1)):
                    if across * along > 0:
                        found[n] += across * along * (self._flow[row, column + ahead] @ warming[which[n]])
        return found

    def stress(self, rise: np.ndarray) -> np.ndarray:
        """The thermal stress [n, 6], MPa."""
        found = np.zeros((len(rise), 6))
        found[:, :2] = (self.by_kelvin * rise)[:, None]
        return found
