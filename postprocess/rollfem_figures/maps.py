"""Pictures over the patch: zones of adhesion and slip of each model, oblique views of tractions."""
import numpy as np

from . import keys, looks, selection
from .axes import nice_step, tick_text
from .figure import Figure
from .outline import extent, patch_panel, zones
from .seen import adhering


def contact_area(result):
    """Adhesion and slip of every model with friction at a few creepages. None when no model has
    them."""
    zoned = [m for m in selection.friction_models(result)
             if m.has_bound and {"pressure", "state"} <= set(m.points[0].fields)]
    chosen = selection.chosen_keys(zoned, 4) if zoned else []
    if not chosen:
        return None
    texts, shared = keys.key_texts(chosen)
    half_x, half_y = extent(zoned)
    # Tall patches: a row for each model, all its creepages beside each other; else the other way round.
    by_model = half_x <= 1.3 * half_y or len(zoned) == 1
    pairs = [(m, k) for m in zoned for k in chosen] if by_model else [(m, k) for k in chosen for m in zoned]
    figure = Figure(len(chosen) if by_model else len(zoned), in_rows=True)
    said = []
    for model, key in pairs:
        point = model.at(key)
        found = zones(model, point) if point else None
        if found is None:
            continue
        panel = patch_panel(figure, f"{looks.label(model)}\n{texts[key]}", ("$x$ [mm]", "$y$ [mm]"), (half_x, half_y),
                            min(95 / half_x, 130 / half_y), 105)
        panel.area(found.outline, "slip")
        panel.area(found.adhesion, "adhesion")
        panel.paths(found.outline, "ink", 1.2)
        said.append(f"{looks.label(model)} {adhering(point)} at {texts[key]}")
    figure.entry("adhesion", fill="adhesion")
    figure.entry("slip", fill="slip")
    figure.entry("rolling to the right" + (f", {shared}" if shared else ""))
    figure.seen = "Zones of adhesion (leading side) and slip: " + "; ".join(said) + "."
    return figure


class _Oblique:
    """Cavalier projection: x to the right, y to the back and up, the traction upwards."""

    def __init__(self, half_x, half_y, values):
        self.half_x, self.half_y = half_x, half_y
        self.low, self.top = min(0.0, float(values.min())), max(0.0, float(values.max()))
        if self.top - self.low < 1e-9:
            self.top = self.low + 1e-9
        self.skew = 0.75 * half_x / half_y  # all in units of half_x, whatever the patch's shape
        self.rise = 0.6 * half_x / half_y
        self.lift = 1.5 * half_x / (self.top - self.low)

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
        panel.area([np.concatenate([ends, base[::-1]])], "ground", 1, 2 + depth)
        if state is None:
            kinds = np.where(values[j, columns][:-1] + values[j, columns][1:] > 0, 3, 0)
        else:
            kinds = np.maximum(state[j, columns][:-1], state[j, columns][1:])
        starts = np.flatnonzero(np.concatenate([[True], kinds[1:] != kinds[:-1]]))
        for a, b in zip(starts, [*starts[1:], len(kinds)]):  # segments of one colour are one line
            panel.paths([ends[a:b + 1]], ("grey", "adhesion", "slip", "ink")[int(kinds[a])], 1.2, (), 2 + depth,
                        0.6 if kinds[a] == 0 else 1)


def _ticks(half):
    step = nice_step(2 * half, 5)
    return [(n * step, tick_text(n * step, step)) for n in range(-int(half / step), int(half / step) + 1)]


def _frame(panel, view, unit_label):
    """Axes of the projection: x in front, y on the right, the traction on the left."""
    ink = {"colour": "soft", "width": 0.9, "order": 1}
    text = {"colour": "ink", "order": 1000}
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
    lines = [view([a * view.half_x for a, _ in corners], [b * view.half_y for _, b in corners])]
    small = 0.05 * view.half_x
    below = view.lift * view.low  # labels stand under what hangs below the plane
    for tick, name in _ticks(view.half_x):
        x, y = view(tick, -view.half_y)
        lines.append(np.array([(x, y), (x, y - small)]))
        panel.text(x, y + below, name, "middle", shift=(0, 15), **text)
    x, y = view(0, -view.half_y)
    panel.text(x, y + below, "$x$ [mm], rolling $\\rightarrow$", "middle", shift=(0, 30), **text)
    for tick, name in _ticks(view.half_y):
        x, y = view(view.half_x, tick)
        lines.append(np.array([(x, y), (x + small, y)]))
        panel.text(x, y, name, shift=(7, 4), **text)
    x, y = view(view.half_x, 0)
    panel.text(x, y, "$y$ [mm]", shift=(32, 16), **text)
    x, y = view(-view.half_x, -view.half_y)
    x -= 2 * small
    lines.append(np.array([(x, y + below), (x, y + view.lift * view.top)]))
    step = nice_step(view.top - view.low, 5)
    for n in range(int(np.ceil(view.low / step - 1e-9)), int(view.top / step + 1e-9) + 1):
        height = y + view.lift * n * step
        lines.append(np.array([(x - small, height), (x, height)]))
        panel.text(x - small, height, tick_text(n * step, step), "end", shift=(-3, 4), **text)
    panel.text(x, y + view.lift * view.top, unit_label, "middle", shift=(0, -8), **text)
    panel.paths(lines, **ink)
    left, bottom = view(-view.half_x, -view.half_y)
    right, back = view(view.half_x, view.half_y)
    panel.x.limits = (left - 9 * small, right + 10 * small)
    panel.y.limits = (bottom - 8.5 * small + below, max(back, view.lift * view.top) + 4 * small)


def _view(figure, model, values, state, title, unit_label):
    view = _Oblique(*extent([model]), values)
    panel = figure.add(380, 0, title, equal=True, bare=True)
    _frame(panel, view, unit_label)
    _strips(panel, view, model, values, state)


def oblique(result, model):
    """p_n and -p_x over the patch at one creepage, the same for every model, strip by strip; p_n alone
    of a model without friction. None without fields."""
    pressure = model.points[0].fields.get("pressure") if model.points else None
    if pressure is None or not (pressure > 0).any():
        return None
    figure = Figure(2, looks.label(model))
    figure.seen = f"Pressure of {looks.label(model)} over the patch, up to {pressure.max():.4g} MPa."
    if not model.has_friction:
        _view(figure, model, pressure, None, "contact pressure", "$p_n$ [MPa]")
        return figure
    shown = selection.reference_for_forces(result)
    creepages = selection.typical_key([shown]) if shown else None
    point = model.at(creepages) if creepages else None
    if point is None or not {"pressure", "traction_x"} <= set(point.fields):
        return None
    pressure, state = point.fields["pressure"], point.fields.get("state")
    traction = -point.fields["traction_x"]
    text = keys.key_texts([creepages])[0][creepages]
    _view(figure, model, pressure, None, "contact pressure", "$p_n$ [MPa]")
    _view(figure, model, traction, state, f"tangential traction, {text}", "$-p_x$ [MPa]")
    figure.entry("adhesion", "adhesion", width=2)
    figure.entry("slip", "slip", width=2)
    figure.seen += (f" Its traction −p_x at {text}, between {traction.min():.4g} and {traction.max():.4g} MPa; "
                    f"it {adhering(point)}.")
    return figure
