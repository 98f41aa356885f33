# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings over the patch: outlines of all models, adhesion and slip area of each, oblique views of tractions."""
import numpy as np

from ..point import ADHESION, PLASTIC
from . import load_points, styles
from .figure import Figure
from .outline import ALONG, adhering, extent, patch_panel, zones
from .panel import even_marks, nice_step


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
            point = (model.at(key) if key else None) or (model.points[0] if model not in zoned else None)
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
    said = [f"{styles.label(m)} {m.points[0]['contact_length']:.3g} by {m.points[0]['contact_width']:.3g} mm"
            for m in models]
    if shaded is not None:
        said += [f"{styles.label(shaded)} {adhering(point)} at {texts[k]}" for k in chosen if (point := shaded.at(k))]
    return figure.tell("Contact areas, along rolling by across: ", said)


class _Oblique:
    """Cavalier projection: x to the right, y to the back and up, the traction upwards."""

    def __init__(self, model, values):
        half_x, half_y = extent([model])
        self.half_x, self.half_y = half_x, half_y
        self.low, self.top = min(0.0, float(values.min())), max(0.0, float(values.max()))
        if self.top - self.low < 1e-9:
            self.top = self.low + 1e-9
        self.skew = 0.75 * half_x / half_y  # all in units of half_x for any shape of patch
        self.rise = 0.6 * half_x / half_y
        self.lift = 1.5 * half_x / (self.top - self.low)
        y = np.clip(model.y, -half_y, half_y)[:, None]
        self.highest = max(self.rise * half_y, float((self.rise * y + self.lift * values).max()))

    def __call__(self, x, y, value=0.0):
        x, y, value = np.broadcast_arrays(x, y, value)
        return np.stack([x + self.skew * y, self.rise * y + self.lift * value], axis=-1)


def _strips(panel, view, model, values, state, count=24):
    """The surface as strips y = constant, drawn from the back to the front."""
    loaded = np.flatnonzero(np.abs(model.y) <= view.half_y)
    rows = loaded[::-max(1, round(len(loaded) / count))]
    columns = np.flatnonzero(np.abs(model.x) <= view.half_x)
    columns = columns[::max(1, len(columns) // 70)]
    for depth, j in enumerate(rows):
        ends = view(model.x[columns], model.y[j], values[j, columns])
        base = view(model.x[columns[[0, -1]]], model.y[j])
        panel.area([np.concatenate([ends, base[::-1]])], "ground", order=2 + depth)
        if state is None:
            kinds = np.where(values[j, columns][:-1] + values[j, columns][1:] > 0, 4, 0)
        else:
            kinds = np.maximum(state[j, columns][:-1], state[j, columns][1:])
        starts = np.flatnonzero(np.concatenate([[True], kinds[1:] != kinds[:-1]]))
        for a, b in zip(starts, [*starts[1:], len(kinds)]):  # segments of equal colour form one line
            panel.paths([ends[a:b + 1]], ("grey", "adhesion", "slip", "plastic", "ink")[int(kinds[a])],
                        opacity=0.6 if kinds[a] == 0 else 1, order=2 + depth)


def _frame(panel, view, unit_label):
    """Axes of the projection: x in front, y on the right, the traction on the left."""
    half_x, half_y, small = view.half_x, view.half_y, 0.05 * view.half_x
    below = view.lift * view.low  # labels stand below everything under the plane
    lines = [view(half_x * np.array([-1, 1, 1, -1, -1]), half_y * np.array([-1, -1, 1, 1, -1]))]

    def axis(marks, place, away, anchor, shift):
        for value, name in marks:
            at = place(value)
            lines.append(np.array([at, at + away]))
            write(at if away[1] == 0 else at + (0, below), name, anchor, shift)

    def write(at, text, anchor, shift):
        panel.text(*at, text, anchor, "ink", shift, order=1000)

    axis(even_marks(-half_x, half_x, nice_step(2 * half_x, 5)), lambda value: view(value, -half_y), (0, -small),
         "middle", (0, 15))
    write(view(0, -half_y) + (0, below), ALONG["x"], "middle", (0, 30))
    axis(even_marks(-half_y, half_y, nice_step(2 * half_y, 5)), lambda value: view(half_x, value), (small, 0),
         "start", (7, 4))
    write(view(half_x, 0), "$y$ [mm]", "start", (32, 16))
    x, y = view(-half_x, -half_y)
    x -= 2 * small
    lines.append(np.array([(x, y + below), (x, y + view.lift * view.top)]))
    axis(even_marks(view.low, view.top, nice_step(view.top - view.low, 5)),
         lambda value: np.array([x - small, y + view.lift * value]), (small, 0), "end", (-3, 4))
    write((x, y + view.lift * view.top), unit_label, "middle", (0, -8))
    panel.paths(lines, "soft", 0.9, order=1)
    left, bottom = view(-half_x, -half_y)
    right = view(half_x, half_y)[0]
    panel.x.limits = (left - 9 * small, right + 10 * small)
    panel.y.limits = (bottom - 8.5 * small + below, view.highest + 4 * small)


def _view(figure, model, values, state, title, unit_label):
    view = _Oblique(model, values)
    panel = figure.add(380, 0, title, equal=True, bare=True)
    _frame(panel, view, unit_label)
    _strips(panel, view, model, values, state)


def oblique(result, model):
    """p_n and -p_x over the patch at a common creepage, strip by strip; only p_n for a model without friction. None
    without fields."""
    pressure = model.points[0].fields.get("pressure") if model.points else None
    if pressure is None or not (pressure > 0).any():
        return None
    figure = Figure(2, styles.label(model))
    said = [f"up to {pressure.max():.4g} MPa"]
    if model.has_friction:
        shown = load_points.reference_for_forces(result)
        key = load_points.typical_key([shown]) if shown else None
        point = model.at(key) if key else None
        if point is None or not {"pressure", "traction_x"} <= set(point.fields):
            return None
        pressure, traction = point.fields["pressure"], -point.fields["traction_x"]
    _view(figure, model, pressure, None, "contact pressure", "$p_n$ [MPa]")
    if model.has_friction:
        text = load_points.key_texts([key])[0][key]
        _view(figure, model, traction, point.fields.get("state"), f"tangential traction, {text}", "$-p_x$ [MPa]")
        figure.entry("adhesion", "adhesion", width=2)
        figure.entry("slip", "slip", width=2)
        if (np.asarray(point.fields.get("state")) == PLASTIC).any():
            figure.entry("yielding layer", "plastic", width=2)
        said.append(f"traction −p_x at {text} between {traction.min():.4g} and {traction.max():.4g} MPa; "
                    f"it {adhering(point)}")
    return figure.tell(f"Pressure of {styles.label(model)} over the patch, ", said)
