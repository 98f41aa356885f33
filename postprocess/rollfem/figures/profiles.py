# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles: a profile of wheel or rail with its curvature over y; and a wheel on its rail with the distance between
them."""
import math

import numpy as np

from ..files import read_rows
from ..reader import read_columns
from .figure import Figure
from .maps import colour_scale, filled

LINEAR = 1e-3  # 1/mm; the scale of curvature is linear below and logarithmic beyond: radii from 10 mm to 10 m
DECADE = 0.6  # length of the linear part, in decades


def joints(s):
    """Indices of the first of two rows at every joint of the curvature."""
    return np.flatnonzero(np.diff(s) == 0.0)


def on_scale(curvature):
    """Position of a curvature (1/mm) on the scale: linear about 0, logarithmic beyond."""
    size = np.abs(np.asarray(curvature, dtype=float)) / LINEAR
    return np.sign(curvature) * np.where(size <= 1, DECADE * size, DECADE + np.log10(np.maximum(size, 1)))


def _ticks(curvature):
    largest = max(np.abs(curvature).max(), LINEAR)
    sizes = [10.0**e for e in range(-3, int(np.ceil(np.log10(largest))) + 1)]
    low, high = 2.0 * min(curvature.min(), 0.0), 2.0 * max(curvature.max(), 0.0)
    shown = [-t for t in sizes if -t >= low] + [0.0] + [t for t in sizes if t <= high]
    return [(float(on_scale(t)), f"{t:g}".replace("-", "−")) for t in sorted(shown)]


def draw_profile(title: str, columns: dict[str, np.ndarray]) -> Figure:
    """The figure of a profile."""
    y, z, curvature = (columns[name] for name in ("y", "z", "curvature"))
    places = joints(columns["s"])
    figure = Figure(1, title)
    shape = figure.add(560, 0, "", "$y$, to the field side [mm]", "$z$, down [mm]", equal=True)
    shape.line(y, z, "blue", 1.8)
    shape.y.flipped = True
    if len(places):
        shape.line(y[places], z[places], "slip", marker="o", size=3.4, joined=False, order=4, name="joint: the radius changes")
    bend = figure.add(560, 200, "", "$y$, to the field side [mm]", "curvature [1/mm]")
    for place in places:
        bend.level(y[place], "soft", (3, 2), 0.6, upright=True)
    bend.line(y, on_scale(curvature), "blue", 1.5)
    bend.y.ticks = _ticks(curvature)
    shape.room_left = bend.room_left = 84  # one below the other
    return figure


# Colours of the patches of one wheel, the most loaded first.
PATCH_COLOURS = ["red", "blue", "green", "pink"]


def _as_function(points):
    """(y, z) of a section with increasing y; of an undercut side only the first part."""
    order = np.argsort(points[:, 0], kind="stable")
    y, z = points[order].T
    keep = np.concatenate([[True], np.diff(y) > 1e-9])
    return y[keep], z[keep]


def draw_pair(drawn, touching, title):
    """`drawn`: points y, z [n, 2] of "rail" and "wheel" on the track; `touching`: dicts with patch,
    y_track, z_track (mm), contact_angle (rad), rolling_radius (mm)."""
    figure = Figure(2)
    shape = figure.add(380, 0, title, "$y$ on the track, to the right [mm]", "height [mm]", equal=True)
    gap = figure.add(250, 210, "distance at the axle, unloaded", "$y$ on the track, to the right [mm]", "[mm]")
    for name, ink in (("rail", "ink"), ("wheel", "blue")):
        y, z = drawn[name].T
        shape.line(y, -z, ink, 1.5, name=name)
    # Vertical undeformed distance around the contact.
    rail, wheel = _as_function(drawn["rail"]), _as_function(drawn["wheel"])
    low, high = min(p["y_track"] for p in touching) - 20, max(p["y_track"] for p in touching) + 20
    y = np.linspace(max(rail[0][0], wheel[0][0], low), min(rail[0][-1], wheel[0][-1], high), 600)
    distance = np.interp(y, *rail) - np.interp(y, *wheel)
    gap.line(y, distance, "blue", 1.5)
    least = max(0.0, float(distance.min()) - 0.1)  # where contact is ahead of the axle, the bodies are apart at the axle
    gap.x.limits, gap.y.limits = (low, high), (least - 0.02, least + 0.6)
    for k, place in enumerate(touching):
        look = {"colour": PATCH_COLOURS[k % len(PATCH_COLOURS)], "marker": "o", "size": 3.6, "order": 5}
        at, patch = place["y_track"], f"patch {place['patch']:.0f}"
        angle = f"{math.degrees(place['contact_angle']):.2f}°"
        shape.spots([(at, -place["z_track"])], **look)
        gap.spots([(at, np.interp(at, y, distance))], name=f"{patch}: {angle}, radius {place['rolling_radius']:.3f} mm", **look)
    return figure


def _pair_of(path):
    """The arguments of draw_pair from a table of wheel, rail and patches."""
    title, rows, _ = read_rows(path)
    drawn = {part: np.array([[float(row["y"]), float(row["z"])] for row in rows if row["part"] == part])
             for part in ("rail", "wheel")}
    names = {"y_track": "y", "z_track": "z", "contact_angle": "angle", "rolling_radius": "radius"}
    return drawn, [{"patch": float(row["part"].split()[1]), **{name: float(row[column]) for name, column in names.items()}}
                   for row in rows if row["part"].startswith("patch")], title


MOST_SECTIONS = 7
SECTION_COLOURS = ("ink", "violet", "blue", "sky", "green", "amber", "red")


def _without_gaps(position, y, z):
    """Rows of sections without what they lack (nan): its points coincide with the nearest one that a section has. A part
    begins or ends at a section, where the row is there twice, with and without it."""
    rows = [(position[0], y[0], z[0])]
    for k in range(1, len(y)):
        here, before = np.isnan(y[k]), np.isnan(y[k - 1])
        if (here != before).any():
            lacking, at = (before, k) if here.sum() < before.sum() else (here, k - 1)
            rows.append((position[at], *(np.where(lacking, np.nan, part[at]) for part in (y, z))))
        rows.append((position[k], y[k], z[k]))
    position, y, z = (np.array(part) for part in zip(*rows))
    for row in range(len(y)):
        known = np.flatnonzero(~np.isnan(y[row]))
        near = known[np.abs(np.arange(y.shape[1])[:, None] - known).argmin(axis=1)]
        y[row], z[row] = y[row, near], z[row, near]
    return position, y, z


RUNNING = 6.0  # mm below the top, of the map: where wheels run, so that small differences show


def draw_sections(title, columns, unit):
    """Sections along the way: some of them over y with their features, and a map of all, on which the features are
    lines: the height seen from above, or how far a wheel is out of round. `unit`: of the position."""
    where, what = (("position along the track [mm]", f"height of the surface, upper {RUNNING:g} mm [mm]") if unit == "mm" else
                   ("angle about the axle [rad]", "radius, less that of the first section [mm]"))
    at, count = np.unique(columns["position"], return_counts=True)
    position, part, y, z = (columns[name].reshape(len(at), count[0]) for name in ("position", "part", "y", "z"))
    joints = np.flatnonzero(np.diff(part[0]))
    figure = Figure(2, title, in_rows=True)
    shape = figure.add(560, 0, "", "$y$, to the field side [mm]", "$z$, down [mm]", equal=True)
    figure.add(14, 10, bare=True)  # above the colour scale
    for colour, k in zip(SECTION_COLOURS, np.unique(np.linspace(0, len(at) - 1, MOST_SECTIONS).round().astype(int))):
        known = ~np.isnan(y[k])
        joined = joints[known[joints]]
        shape.line(y[k, known], z[k, known], colour, 1.3, name=f"{at[k]:.4g} {unit}")
        shape.line(y[k, joined], z[k, joined], colour, marker="o", size=2.2, joined=False, order=4)
    shape.y.flipped = True
    plan = figure.add(560, 260, what + "; lines: features" * bool(len(joints)), where,
                      "$y$, to the field side [mm]")
    plan.x.limits, plan.y.limits = (at[0], at[-1]), (np.nanmin(y), np.nanmax(y))
    ways, places, heights = _without_gaps(position, y, z)
    values = np.maximum(-heights.T, np.max(-heights) - RUNNING) if unit == "mm" else (heights - heights[0]).T
    levels, step = filled(plan, ways.T, places.T, values)
    for joint in joints:
        known = ~np.isnan(y[:, joint])
        plan.line(at[known], y[known, joint], "ground", 2.0)
        plan.line(at[known], y[known, joint], "ink", 0.9)
    colour_scale(figure, levels, step, 260)
    shape.room_left = plan.room_left = 64  # one below the other
    return figure


def of_table(path):
    """The figure of a table of `rollfem profile`, for one profile, sections along the way or a case's wheel on its rail."""
    units = read_rows(path).units
    if "position" in units:
        return draw_sections(*read_columns(path, "part"), units["position"])
    return draw_pair(*_pair_of(path)) if "part" in units else draw_profile(*read_columns(path, "curvature"))
