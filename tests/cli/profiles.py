# SPDX-License-Identifier: LGPL-2.1-or-later
"""Built-in profiles as text in files."""

import json

import numpy as np


def points_of(rollfem, name, spacing=0.5):
    """Points (y, z) of a built-in profile, this far apart along it."""
    table = json.loads(rollfem.done("profile", name, "--json").out)["profiles"][0]["columns"]
    s, keep = np.unique(table["s"], return_index=True)
    y, z, angle = (np.array(table[column])[keep] for column in ("y", "z", "angle"))
    # Cubic between the rows, which are so dense that it is exact to 1e-9 mm.
    at = np.arange(s[0], s[-1], spacing)
    k = np.clip(np.searchsorted(s, at, side="right") - 1, 0, len(s) - 2)
    h = s[k + 1] - s[k]
    t = (at - s[k]) / h

    def between(value, slope):
        return ((1 + 2 * t) * (1 - t)**2 * value[k] + t**2 * (3 - 2 * t) * value[k + 1]
                + h * t * (1 - t) * ((1 - t) * slope[k] - t * slope[k + 1]))
    return list(zip(between(y, np.cos(np.radians(angle))).tolist(), between(z, np.sin(np.radians(angle))).tolist()))


def columns(points):
    return "".join(f"{y:.12g} {z:.12g}\n" for y, z in points)
