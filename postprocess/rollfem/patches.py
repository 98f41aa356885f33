# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of a wheel from those of its patches."""
from collections.abc import Callable, Sequence
from typing import Any

from .point import Point

#: Of a wheel with several patches: sums, and those that have no sum as each patch has a frame of its own.
SUMS = ("normal_force", "longitudinal_force", "vertical_force", "lateral_force_track", "contact_area", "adhesion_area",
        "patch_count", "elastic_energy", "frictional_work", "creepage_work", "revolution_work", "iterations", "seconds")
#: Of the patch with the largest work.
PLACES = ("pass_work_y_wheel", "pass_work_y_rail")
OWN_FRAME = ("lateral_force", "lateral_pressure", "spin_moment")


def whole(name: str, patches: Sequence[Point], get: Callable[[Point, str], Any]) -> Any:
    """A number of a wheel from those of its patches; None where there is none."""
    if len(patches) < 2:
        return get(patches[0], name) if patches else None
    if name in OWN_FRAME:
        return None
    if name in PLACES:
        return get(max(patches, key=lambda point: get(point, "max_pass_work") or 0.0), name)
    if name == "traction_coefficient":
        forces = [[get(point, each) for point in patches] for each in ("longitudinal_force", "normal_force")]
        return None if None in forces[0] or not sum(forces[1]) else -sum(forces[0]) / sum(forces[1])
    values = [get(point, name) for point in patches]
    if name in SUMS:
        return None if None in values else sum(values)
    known = [value for value in values if value is not None]
    if name.startswith("max_") or name == "residual":
        return max(known, default=None)
    return min(known, default=None) if name == "converged" else values[0]


def bar_of(name: str, patches: Sequence[Point]) -> float | None:
    if len(patches) > 1 and name == "traction_coefficient":
        bars = [point.bar("longitudinal_force") for point in patches]
        known = [bar for bar in bars if bar is not None]
        return sum(known) / sum(point.normal_force for point in patches) if len(known) == len(bars) else None
    if len(patches) > 1 and name.startswith("max_"):
        return max(patches, key=lambda point: point.scalars.get(name) or 0.0).bar(name)
    found: float | None = whole(name, patches, lambda point, what: point.bar(what))
    return found
