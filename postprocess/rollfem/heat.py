# SPDX-License-Identifier: LGPL-2.1-or-later
"""Temperature and thermal stress below the heated surface of a body. The layer is thin beside the patch, so that the material
around holds it: the thermal stress is the same along and across, -E alpha (T - T_0)/(1 - nu), and nothing else (Johnson 1985, 12.2)."""
from typing import Any

import numpy as np


class HeatedBody:
    """A body below the contact at one load point."""

    def __init__(self, constants: tuple[float, ...], elastic: tuple[float, float], grid: Any, surface: np.ndarray) -> None:
        """`constants`: as of _core.heated_body; `elastic`: E in MPa and nu; `grid`: the model's; `surface`: temperatures [ny, nx]."""
        self._constants, self._grid, self._surface = constants, grid, surface
        self.before = constants[2]
        self.by_kelvin = -elastic[0] * constants[3] / (1 - elastic[1])

    def rise(self, places: np.ndarray) -> np.ndarray:
        """K above the temperature before contact at places [n, 3], mm (contact::rise_below)."""
        from . import _core
        grid, below = self._grid, np.column_stack([places[:, :2], np.abs(places[:, 2])])
        return np.array(_core.rise_below(self._constants, grid.x, grid.y, grid.dx, grid.dy, self._surface, below))

    def stress(self, rise: np.ndarray) -> np.ndarray:
        """The thermal stress [n, 6], MPa."""
        found = np.zeros((len(rise), 6))
        found[:, :2] = (self.by_kelvin * rise)[:, None]
        return found
