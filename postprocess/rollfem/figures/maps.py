# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contour lines of a field on a grid (marching squares), for sub-element edges of the patch, borders between adhesion and
slip area, and maps of a section. Drawings over the patch: outlines of all models, adhesion and slip area of each, maps of
pressure and traction."""
import math
from dataclasses import dataclass

import numpy as np

from ..point import ADHESION, PLASTIC
from . import load_points, styles
from .figure import Figure, nice_step


# Labels of the axes of the patch.
ALONG = {"x": "$x$ [mm], rolling $\\rightarrow$", "y": "$y$ [mm], lateral"}
LEAST_HEIGHT = 80  # px, least width of a panel with a patch, for its label


# For the 16 combinations of cell corners above the level (bits: 1 at (i, j), 2 at (i+1, j), 4 at (i+1, j+1), 8 at (i,
# j+1)): the sides joined by a line, with higher values on its left. Sides: 0 below, 1 right, 2 above, 3 left. Saddles
# count as below in the middle.
_JOINED = {1: [(0, 3)], 2: [(1, 0)], 3: [(1, 3)], 4: [(2, 1)], 5: [(0, 3), (2, 1)], 6: [(2, 0)],
           7: [(2, 3)], 8: [(3, 2)], 9: [(0, 2)], 10: [(1, 0), (3, 2)], 11: [(1, 2)], 12: [(3, 1)],
           13: [(0, 1)], 14: [(3, 0)]}


def _edges(side, i, j, width):
    """Numbers of cell sides in the grid: sides along x have even numbers."""
    at = {0: (i, j), 1: (i + 1, j), 2: (i, j + 1), 3: (i, j)}[side]
    return 2 * (at[1] * width + at[0]) + (side in (1, 3))


def _places(edges, x, y, values, level):
    """Crossings of the level on cell sides, by their numbers."""
    width = len(x)
    place, upright = edges // 2, edges % 2
    j, i = place // width, place % width
    k, m = np.where(upright, i, i + 1), np.where(upright, j + 1, j)
    low, high = values[j, i], values[m, k]
    share = (level - low) / (high - low)
    return np.stack([x[i] + share * (x[k] - x[i]), y[j] + share * (y[m] - y[j])], axis=1)


def contour_lines(x, y, values, level):
    """Contour lines of a field [ny, nx] at a level as arrays [n, 2]; closed lines repeat their first point."""
    above = values >= level
    kind = (above[:-1, :-1] * 1 + above[:-1, 1:] * 2 + above[1:, 1:] * 4 + above[1:, :-1] * 8)
    follows = {}
    for number, joined in _JOINED.items():
        j, i = np.nonzero(kind == number)
        for start, end in joined if len(i) else ():
            follows.update(zip(_edges(start, i, j, len(x)).tolist(), _edges(end, i, j, len(x)).tolist()))
    found = []
    ends = set(follows.values())
    begins = [edge for edge in follows if edge not in ends]
    while follows:
        edge = begins.pop() if begins else next(iter(follows))
        chain = [edge]
        while edge in follows:
            edge = follows.pop(edge)
            chain.append(edge)
        found.append(_places(np.array(chain), np.asarray(x), np.asarray(y), values, level))
    return found


def at_points(x, y, values, points):
    """Bilinear interpolation of a field on its even grid."""
    i = np.clip((points[:, 0] - x[0]) / (x[1] - x[0]), 0, len(x) - 1.000001)
    j = np.clip((points[:, 1] - y[0]) / (y[1] - y[0]), 0, len(y) - 1.000001)
    k, m = i.astype(int), j.astype(int)
    s, t = i - k, j - m
    return ((1 - t) * ((1 - s) * values[m, k] + s * values[m, k + 1])
            + t * ((1 - s) * values[m + 1, k] + s * values[m + 1, k + 1]))


def edge_function(pressure):
    """A field on the grid whose zero line is the edge of the patch.

    Near the edge p^2 is linear in the distance (Hertz), so p^2 is continued linearly from the two
    outermost loaded elements to the unloaded ones beside them.
    """
    known = pressure > 0
    values = np.where(known, pressure, 0.0) ** 2
    scale = values.max() if values.size else 0.0
    for _ in range(2):  # the second ring fills the corners between a row and a column
        values, known = _continued(values, known, -1e-6 * scale)
    return np.where(known, values, -0.05 * scale)


def _continued(values, known, largest):
    """`values` with one more ring of elements around the known ones, limited to `largest`."""
    sums, counts = np.zeros_like(values), np.zeros_like(values)
    for axis in (0, 1):
        for step in (1, -1):
            near, far = np.roll(values, step, axis), np.roll(values, 2 * step, axis)
            reaches = np.roll(known, step, axis) & ~known
            border = [slice(None)] * 2
            border[axis] = slice(0, 1) if step == 1 else slice(-1, None)
            reaches[tuple(border)] = False  # values that np.roll wrapped around
            sums += np.where(reaches, np.minimum(2 * near - far, largest), 0.0)
            counts += reaches
    return np.where(known, values, sums / np.maximum(counts, 1)), known | (counts > 0)


def loaded_runs(at, pressure):
    """Yields (edge below, edge above, first, last + 1) of every run of loaded elements on a line, the
    edges from p^2 continued linearly, at most one element beyond."""
    inside = np.concatenate([[False], pressure > 0, [False]])
    starts, ends = np.flatnonzero(~inside[:-1] & inside[1:]), np.flatnonzero(inside[:-1] & ~inside[1:])
    step = at[1] - at[0] if len(at) > 1 else 1.0

    def beyond(outer, inner):
        fall = inner ** 2 - outer ** 2
        return step * min(1.0, outer ** 2 / fall) if fall > 0 else 0.5 * step

    for first, last in zip(starts, ends):
        second = min(first + 1, last - 1)
        yield (at[first] - beyond(pressure[first], pressure[second]),
               at[last - 1] + beyond(pressure[last - 1], pressure[max(last - 2, first)]), first, last)


def padded(model, values, outside):
    """x, y and values with a ring of elements around, so that outlines close at the border."""
    x = np.concatenate([[model.x[0] - model.dx], model.x, [model.x[-1] + model.dx]])
    y = np.concatenate([[model.y[0] - model.dy], model.y, [model.y[-1] + model.dy]])
    return x, y, np.pad(values, 1, constant_values=outside)


def extent(models):
    """Half-widths (x, y), mm, of a frame around the patches of all models."""
    half_x = half_y = 0.0
    for model in models:
        for point in model.points:
            pressure = point.fields.get("pressure")
            if pressure is None or not (pressure > 0).any():
                continue
            half_x = max(half_x, np.abs(model.x[(pressure > 0).any(axis=0)]).max() + model.dx)
            half_y = max(half_y, np.abs(model.y[(pressure > 0).any(axis=1)]).max() + model.dy)
    return 1.06 * half_x, 1.06 * half_y


def patch_panel(figure, title, labels, half, scale, narrowest):
    """Adds a panel for patches within the half-widths (extent), with a scale in px per mm and a least width."""
    panel = figure.add(max(2 * half[0] * scale, narrowest), 0, title, *labels, equal=True)
    wide = panel.width / (2 * scale)
    high = max(half[1], LEAST_HEIGHT / (2 * scale))
    panel.x.limits, panel.y.limits, panel.room_left = (-wide, wide), (-high, high), 46
    return panel


def _blurred(values):
    """Sums over neighbours with weights 1, 2, 1 along both axes; outside is 0."""
    for axis in (0, 1):
        wide = np.moveaxis(np.pad(values, [(int(axis == k), int(axis == k)) for k in (0, 1)]), axis, 0)
        values = np.moveaxis(wide[:-2] + 2 * wide[1:-1] + wide[2:], 0, axis)
    return values


def spread(state, kind=ADHESION):
    """1 in elements of `kind`, 0 in others, averaged over neighbours so that the border between the zones runs through
    the steps of the elements, and continued beyond the edge of the patch."""
    values, known = np.where(state == kind, 1.0, 0.0), (state > 0).astype(float)
    for _ in range(2):
        weight = _blurred(known)
        values, known = _blurred(values * known) / np.maximum(weight, 1e-9), (weight > 0).astype(float)
    return values


@dataclass
class Zones:
    """Lines [n, 2], mm: of the edge of the patch, around adhesion, between adhesion and slip, and around what yields."""

    outline: list
    adhesion: list
    borders: list
    has_state: bool
    plastic: list


def zones(model, point):
    """Zones of a load point; None without contact."""
    pressure, state = point.fields.get("pressure"), point.fields.get("state")
    if pressure is None or not (pressure > 0).any():
        return None
    edge = edge_function(pressure)
    x, y, inside = padded(model, edge / pressure.max() ** 2, -1.0)
    outline = contour_lines(x, y, inside, 0.0)
    plastic = []
    if state is not None and (state == PLASTIC).any():
        _, _, yielding = padded(model, spread(state, PLASTIC), 0.0)
        plastic = contour_lines(x, y, np.minimum(inside, yielding - 0.5), 0.0)
    if state is None or not (state == ADHESION).any():
        return Zones(outline, [], [], state is not None, plastic)
    if not (state > ADHESION).any():
        return Zones(outline, outline, [], True, plastic)
    _, _, sticking = padded(model, spread(state), 0.0)
    borders = []
    for line in contour_lines(x, y, sticking, 0.5):
        known = np.flatnonzero(at_points(x, y, inside, line) > 0)
        borders += np.split(line[known], np.flatnonzero(np.diff(known) > 1) + 1)
    return Zones(outline, contour_lines(x, y, np.minimum(inside, sticking - 0.5), 0.0), borders, True, plastic)


def adhering(point):
    """"sticks in 62 % of the patch"."""
    share = 100 * point["adhesion_area"] / point["contact_area"] if point["contact_area"] else 0.0
    if share < 0.05 and (np.asarray(point.fields.get("state")) == PLASTIC).any():
        return "slips or yields everywhere"
    return "slips everywhere" if share < 0.05 else f"sticks in {share:.0f} % of the patch"


# The colour map viridis in steps, and the part with white text.
VIRIDIS = ("#440154 #481b6d #46327e #3f4788 #365c8d #2e6e8e #277f8e #21918c #1fa187 #2db27d #4ac16d #73d056 "
           "#a0da39 #d0e11c #fde725").split()


def _shade(number, levels):
    return VIRIDIS[round(number * (len(VIRIDIS) - 1) / max(1, len(levels) - 1))]


def filled(panel, right, up, values, outline=None):
    """Overlaid areas above increasing levels, from the border of the lattice (or an outline within it). The lattice may be skew,
    because contours are computed over the indices of its points. Returns the levels."""
    low, high = float(values.min()), float(values.max())
    step = nice_step(max(high - low, 1e-6 * max(abs(high), 1e-9)), len(VIRIDIS) - 1)
    first = math.floor(low / step + 1e-9)
    levels = [step * n for n in range(first, first + len(VIRIDIS)) if step * n < high or n == first]
    rows, columns = values.shape
    # A ring beyond the border closes the lines; the border clips it.
    x, y = np.arange(-1, columns + 1.0), np.arange(-1, rows + 1.0)
    x[[0, -1]], y[[0, -1]] = (-1e-3, columns - 1 + 1e-3), (-1e-3, rows - 1 + 1e-3)
    wide = np.pad(values, 1, constant_values=low - 1e3 * (high - low or 1.0))
    panel.area(outline or [_edge(right, up)], VIRIDIS[0])
    for place, level in enumerate(levels[1:], 1):
        rings = contour_lines(x, y, wide, level)
        panel.area([np.stack([at_points(np.arange(columns), np.arange(rows), part, ring)
                              for part in (right, up)], axis=1) for ring in rings], _shade(place, levels))
    return levels, step


def _edge(right, up):
    """The border of a lattice."""
    return np.concatenate([np.stack([part[side] for part in (right, up)], axis=1) for side in (
        np.s_[0, :], np.s_[1:, -1], np.s_[-1, -2::-1], np.s_[-2:0:-1, 0])])


def colour_scale(figure, levels, step, height):
    """A panel with the colour scale of the levels."""
    panel = figure.add(14, height, " ")
    panel.x.ticks, panel.x.limits, panel.room_left = [], (0.0, 1.0), 34
    panel.y.limits = (levels[0], levels[-1] + step)
    for place, level in enumerate(levels):
        panel.area([np.array([(0, level), (1, level), (1, level + step), (0, level + step)])], _shade(place, levels))


def pressure(result, model):
    """Coloured maps of the pressure of a model and, with friction, of the size of its tangential traction, with the edge of the
    patch and the border between adhesion and slip, at a common creepage. None without fields."""
    shown = load_points.reference_for_forces(result) if model.has_friction else None
    key = load_points.typical_key([shown]) if shown else None
    point = model.at(key) if key else next((p for p in model.points if "pressure" in p.fields), None)
    found = zones(model, point) if point else None
    if found is None or min(len(model.x), len(model.y)) < 2:
        return None
    half, figure = extent([model]), Figure(4, styles.label(model), in_rows=True)
    values = {"contact pressure $p_n$ [MPa]": point.fields["pressure"]}
    if key and {"traction_x", "traction_y"} <= set(point.fields):
        text = load_points.key_texts([key])[0][key]
        values[f"size of the tangential traction [MPa], {text}"] = np.hypot(point.fields["traction_x"], point.fields["traction_y"])
    for title, field in values.items():
        panel = patch_panel(figure, title, (ALONG["x"], ALONG["y"]), half, min(150 / half[0], 150 / half[1]), 140)
        levels, step = filled(panel, *np.meshgrid(model.x, model.y), field, found.outline)
        panel.paths(found.outline, "ink", 1.2)
        panel.paths(found.borders, "ink", 3.6)
        panel.paths(found.borders, "ground", 1.4, order=3)
        panel.fit()
        colour_scale(figure, levels, step, panel.height)
    if found.borders:
        figure.entry("double line: border between adhesion and slip")
    said = [f"{title} up to {field.max():.4g}" for title, field in values.items()] + [adhering(point)] * model.has_friction
    return figure.tell("Maps over the patch: ", said)


def _zoned(result):
    """The models with adhesion and slip areas."""
    return [m for m in load_points.friction_models(result)
            if m.has_bound and {"pressure", "state"} <= set(m.points[0].fields)]


def contact_area(result):
    """Adhesion and slip area of every model with friction at a few creepages. None if there are none."""
    zoned = _zoned(result)
    chosen = load_points.chosen_keys(zoned, 4) if zoned else []
    if not chosen:
        return None
    texts, shared = load_points.key_texts(chosen)
    half = extent(zoned)
    # Tall patches: a row for each model with all its creepages side by side; otherwise transposed.
    by_model = half[0] <= 1.3 * half[1] or len(zoned) == 1
    figure = Figure(len(chosen) if by_model else len(zoned), in_rows=True)
    said, yields = [], False
    for model, key in [(m, k) for m in zoned for k in chosen] if by_model else [(m, k) for k in chosen for m in zoned]:
        point = model.at(key)
        found = zones(model, point) if point else None
        if found is None:
            continue
        panel = patch_panel(figure, f"{styles.label(model)}\n{texts[key]}", ("$x$ [mm]", "$y$ [mm]"), half,
                            min(95 / half[0], 130 / half[1]), 105)
        panel.area(found.outline, "slip")
        panel.area(found.plastic, "plastic")
        panel.area(found.adhesion, "adhesion")
        panel.paths(found.outline, "ink", 1.2)
        yields = yields or bool(found.plastic)
        said.append(f"{styles.label(model)} {adhering(point)} at {texts[key]}")
    figure.entry("adhesion", fill="adhesion")
    figure.entry("slip", fill="slip")
    if yields:
        figure.entry("yielding layer", fill="plastic")
    figure.entry("rolling to the right" + (f", {shared}" if shared else ""))
    return figure.tell("Zones of adhesion (leading side) and slip: ", said)


def _bordered_keys(zoned):
    """Up to three load points with both areas; if the curve reaches full slip, the last one is in full slip."""
    def adheres(model, key):
        point = model.at(key)
        return point is not None and "state" in point.fields and (point.fields["state"] == ADHESION).any()

    loaded = load_points.chosen_keys(zoned, 10 ** 6)
    partly = [k for k in loaded if any(adheres(m, k) for m in zoned)]
    full = [k for k in loaded if k not in partly][:1]
    room = 3 - len(full)
    if len(partly) > room:
        partly = [partly[0], partly[len(partly) // 2], partly[-1]] if room == 3 else [
            partly[len(partly) // 3], partly[-1]]
    return partly + full


def outlines(result):
    """Outlines of all models overlaid, at up to three creepages with each model's border between adhesion (on the
    leading side) and slip area; those of the reference model are shaded. None if no model has a pressure field."""
    models, zoned = load_points.with_pressure(result), _zoned(result)
    if not models:
        return None
    chosen = _bordered_keys(zoned) if zoned else []
    reference = load_points.reference_for_forces(result)
    shaded = reference if chosen and reference in zoned else None
    texts, shared = load_points.key_texts(chosen)
    half = extent(models)
    figure = Figure(3)
    for model in models:
        figure.model(model)
    for key in chosen or [None]:
        panel = patch_panel(figure, texts[key] if key else "", (ALONG["x"], ALONG["y"]),
                            half, min(135 / half[0], 150 / half[1]), 115)
        for model in models:
            # Hertz has a single load point.
            point = (model.at(key) if key else None) or (model.headline if model not in zoned else None)
            found = zones(model, point) if point else None
            if found is None:
                continue
            if model is shaded and found.has_state:
                panel.area(found.outline, "slip", 0.3, order=0)
                panel.area(found.adhesion, "ground", order=0)
                panel.area(found.adhesion, "adhesion", 0.35, order=0)
            colour, dash, _ = styles.of_model(model)
            panel.paths([*found.outline, *found.borders], colour, 1.3, dash)
    if shaded is not None:
        figure.entry(f"adhesion ({styles.label(shaded)})", fill="adhesion", opacity=0.35)
        figure.entry(f"slip ({styles.label(shaded)})", fill="slip", opacity=0.3)
    figure.entry(shared)
    said = [f"{styles.label(m)} {m.headline['contact_length']:.3g} by {m.headline['contact_width']:.3g} mm"
            for m in models if m.headline]
    if shaded is not None:
        said += [f"{styles.label(shaded)} {adhering(point)} at {texts[k]}" for k in chosen if (point := shaded.at(k))]
    return figure.tell("Contact areas, along rolling by across: ", said)
