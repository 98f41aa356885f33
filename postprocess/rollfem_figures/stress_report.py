"""Figures of what `rollfem stress` wrote: depth profiles, lines, planes, the shakedown map."""
import math

import numpy as np

from . import contours, keys, looks, stresses
from .axes import nice_step
from .figure import Figure
from .stresses import MEASURES

DASHES = [(), (7.5, 2.3), (1.5, 1.5), (6, 1.5, 1.5, 1.5)]
MOST_FIGURES = 40  # of each kind


def load_point(model):
    """Which load point of the model is drawn."""
    key = tuple(model.data[name] for name in ("longitudinal_creepage", "lateral_creepage", "spin"))
    return f"step {model.data['step']}" if model.data["step"] else keys.key_texts([key])[0][key]


def _names(result, prefix):
    """Names of the sets that begin so, in order."""
    found = dict.fromkeys(s.name for m in result.models for s in m.sets if s.name.startswith(prefix))
    return list(found)[:MOST_FIGURES]


def _bodies(result, name):
    return [b for b in ("wheel", "rail") if any(m.set(name, b) for m in result.models)]


def depth_profile(result, name):
    """Stresses down from the surface, one panel for each body. `name`: depth_centre, ..."""
    figure, said = Figure(2), []
    for body in _bodies(result, name):
        panel = figure.add(270, 300, f"{body}, {_where(result, name, body)}", "stress [MPa]",
                           "depth below the surface [mm]")
        panel.y.flipped, panel.y.limits, panel.y.margin = True, (0.0, None), 0.0
        panel.level(0, dash=(), upright=True)
        for model, dash in zip(result.models, DASHES * len(result.models)):
            if part := model.set(name, body):
                for column, _, ink in MEASURES:
                    panel.line(part[column], part["distance"], ink, 1.6, dash)
                deep = int(np.argmax(part["von_mises"]))
                said.append(f"{looks.label(model)}, {body}, {load_point(model)}: von Mises up to "
                            f"{part['von_mises'][deep]:.4g} MPa, {part['distance'][deep]:.3g} mm deep")
    for _, label, ink in MEASURES:
        figure.entry(label, ink)
    if len(result.models) > 1:
        for model, dash in zip(result.models, DASHES * len(result.models)):
            figure.entry(entry_name(result, model), "ink", dash)
    figure.heading_entry(_shared(result))
    figure.seen = "Stress against depth: " + "; ".join(said) + "."
    return figure


def entry_name(result, model):
    """What tells one entry from the others: its model, its load point, or both."""
    models, points = ({key(m) for m in result.models} for key in (looks.label, load_point))
    return ", ".join(([looks.label(model)] if len(models) > 1 or len(points) < 2 else [])
                     + ([load_point(model)] if len(points) > 1 else []))


def _shared(result):
    """The load point that all share, or empty."""
    points = {load_point(m) for m in result.models}
    return points.pop() if len(points) == 1 else ""


def _where(result, name, body):
    part = next(m.set(name, body) for m in result.models if m.set(name, body))
    texts = [f"{v:.2f}".replace("-", "−") if abs(v) >= 5e-3 else "0" for v in (part["x"][0], part["y"][0])]
    return f"under x = {texts[0]}, y = {texts[1]} mm"


# Load points of one model beside each other: the colours, from the first on.
POINT_COLOURS = ["blue", "red", "green", "pink", "amber", "sky", "brown", "violet", "wine", "forest"]


def _looks(result):
    """A look of each entry: of its model where they differ in that, else a colour for each load point."""
    if len({m.name for m in result.models}) == len(result.models):
        return [looks.line(m) for m in result.models]
    names = list(dict.fromkeys(m.name for m in result.models))
    points = list(dict.fromkeys(load_point(m) for m in result.models))
    return [{"colour": POINT_COLOURS[points.index(load_point(m)) % len(POINT_COLOURS)],
             "dash": DASHES[names.index(m.name) % len(DASHES)]} for m in result.models]


def along_line(result, name, body):
    """Four measures along a line, every model and load point in a look of its own."""
    curves = []
    for model, look in zip(result.models, _looks(result)):
        if part := model.set(name, body):
            curves.append(stresses.Curve(entry_name(result, model), look,
                                         np.stack([part[axis] for axis in "xyz"], axis=1), part.columns))
    return stresses.along_line(curves, ", ".join(filter(None, (f"in the {body}", _shared(result)))))


def _lattice(part):
    """In-plane coordinates [across, along] of a plane, with their labels: that of the global frame
    for a side that follows an axis, else the distance along it; of a skew parallelogram the
    distance across its first side."""
    points = np.array([part[c].reshape(part.shape) for c in ("x", "y", "z")])
    offset = points - points[:, :1, :1]
    sides, found = [], []
    for change, name in ((offset[:, 0, -1], "first side [mm]"), (offset[:, -1, 0], "second side [mm]")):
        side = change / np.linalg.norm(change)
        axis = int(np.argmax(np.abs(side)))
        if abs(side[axis]) > 0.999999:
            found.append((axis, points[axis], f"${'xyz'[axis]}$ [mm]"))
        else:
            found.append((-1, np.tensordot(side, offset, 1), name))
        sides.append(side)
    if abs(np.dot(*sides)) > 1e-6:
        along = np.tensordot(sides[0], offset, 1)
        across = np.linalg.norm(offset - sides[0][:, None, None] * along, axis=0)
        return along, across, "first side [mm]", "across it [mm]"
    if found[0][0] > found[1][0] >= 0:  # x to the right, z up
        found.reverse()
    return found[0][1], found[1][1], found[0][2], found[1][2]


# The colour map viridis, in steps; and where on it the words are white.
VIRIDIS = ("#440154 #481b6d #46327e #3f4788 #365c8d #2e6e8e #277f8e #21918c #1fa187 #2db27d #4ac16d #73d056 "
           "#a0da39 #d0e11c #fde725").split()


def _shade(number, levels):
    return VIRIDIS[round(number * (len(VIRIDIS) - 1) / max(1, len(levels) - 1))]


def _filled(panel, right, up, values):
    """Areas above ever higher levels over each other. The lattice may be askew: levels are found over the
    numbers of its points. Returns the levels."""
    low, high = float(values.min()), float(values.max())
    step = nice_step(max(high - low, 1e-6 * max(abs(high), 1e-9)), len(VIRIDIS) - 1)
    first = math.floor(low / step + 1e-9)
    levels = [step * n for n in range(first, first + len(VIRIDIS)) if step * n < high]
    rows, columns = values.shape
    # A ring around, beyond the border, closes the lines; the border cuts it off.
    x, y = np.arange(-1, columns + 1.0), np.arange(-1, rows + 1.0)
    x[[0, -1]], y[[0, -1]] = (-1e-3, columns - 1 + 1e-3), (-1e-3, rows - 1 + 1e-3)
    wide = np.pad(values, 1, constant_values=low - 1e3 * (high - low or 1.0))
    panel.area([_edge(right, up)], VIRIDIS[0])
    for number, level in enumerate(levels[1:], 1):
        rings = contours.lines(x, y, wide, level)
        panel.area([np.stack([contours.at_points(np.arange(columns), np.arange(rows), part, ring)
                              for part in (right, up)], axis=1) for ring in rings], _shade(number, levels))
    return levels, step


def _edge(right, up):
    """The border of a lattice."""
    return np.concatenate([np.stack([part[side] for part in (right, up)], axis=1) for side in (
        np.s_[0, :], np.s_[1:, -1], np.s_[-1, -2::-1], np.s_[-2:0:-1, 0])])


def _scale(figure, levels, step, height):
    """A panel with the colours of the levels."""
    panel = figure.add(14, height, " ")
    panel.x.ticks, panel.x.limits, panel.room_left = [], (0.0, 1.0), 34
    panel.y.limits = (levels[0], levels[-1] + step)
    for number, level in enumerate(levels):
        panel.area([np.array([(0, level), (1, level), (1, level + step), (0, level + step)])], _shade(number, levels))


def plane(result, model, part):
    """Filled contours of four measures on a plane."""
    right, up, right_label, up_label = _lattice(part)
    figure = Figure(4, f"{looks.label(model)}, {part.body}, {load_point(model)}", in_rows=True)
    wide, high = np.ptp(right), max(np.ptp(up), 1e-9)
    width = min(300.0, 330.0 * wide / high)
    for column, label, _ in MEASURES:
        values = part[column].reshape(part.shape)
        panel = figure.add(width, 0, f"{label} stress [MPa]", right_label, up_label, equal=True)
        panel.x.limits, panel.y.limits = (right.min(), right.max()), (up.min(), up.min() + high)
        levels, step = _filled(panel, right, up, values)
        if column != "hydrostatic":
            peak = np.unravel_index(np.argmax(values), values.shape)
            for ink, size in (("ground", 4.4), ("ink", 3.6)):
                panel.line([right[peak]], [up[peak]], ink, marker="x", size=size, joined=False, order=4)
        panel.fit()
        _scale(figure, levels, step, panel.height)
    figure.seen = f"Stress in the {part.body} on a plane, {looks.label(model)}: " + "; ".join(
        f"{label} from {part[column].min():.4g} to {part[column].max():.4g} MPa" for column, label, _ in MEASURES) + "."
    return figure


def shakedown_map(result):
    """Load factor against tangential coefficient: boundaries of line and circular contact, and every
    load point of every model. None without a yield stress."""
    bounds = result.shakedown_map
    if bounds is None:
        return None
    figure = Figure(1)
    panel = figure.add(440, 300, f"yield stress in shear $k$ = {result.yield_shear_stress:.4g} MPa",
                       "tangential force over normal force $T/F_z$ [-]", "load factor $p_0/k$ [-]")
    at = bounds["tangential_coefficient"]
    models = list({m.key: m for m in result.models}.values())
    top = max([5.2] + [1.15 * p["load_factor"] for m in models for p in m.data["shakedown"]])
    panel.x.limits, panel.y.limits = (0.0, max(at)), (0.0, top)
    if "ellipse_shakedown" in bounds:
        panel.line(at, bounds["ellipse_shakedown"], "ink", 1.8)
        figure.entry(f"shakedown limit of the ellipse, $b/a$ = {bounds['ellipse_ratio']:.3g}", "ink", width=1.8)
    for kind, dash, name in KINDS:
        panel.line(at, bounds[f"{kind}_shakedown"], "soft", 1.1, dash)
        panel.line(at, bounds[f"{kind}_elastic"], "sky", 1.1, dash)
        figure.entry(f"shakedown limit, {name}", "soft", dash, 1.1)
        figure.entry(f"elastic limit, {name}", "sky", dash, 1.1)
    said = []
    for size, model in zip((4.5, 3.2, 2.6, 2.2) * len(models), models):  # models that agree stay visible
        curve = model.data["shakedown"]
        spots = [(p["tangential_coefficient"], p["load_factor"]) for p in curve]
        panel.line(*zip(*spots), marker=looks.marker(model), size=size, hollow=True, order=4, **looks.line(model))
        chosen = [spots[m.data["point"] - 1] for m in result.models if m.key == model.key]
        panel.line(*zip(*chosen), looks.of_model(model)[0], marker=looks.marker(model), size=size, joined=False, order=5)
        figure.entry(f"{looks.label(model)} (filled: the load points of the stresses)", *looks.of_model(model)[:2],
                     marker=looks.marker(model))
        said += [f"{looks.label(model)} at {x:.3g}, {y:.3g}" for x, y in chosen]
    panel.text(0.012, 0.3, "elastic")
    if top < 6:  # else there is no room between the limits
        panel.text(0.008, 3.2, "elastic shakedown")
    panel.text(0.97, 0.93, "plastic flow at every pass", "end", share=(True, True))
    figure.seen = ("Shakedown map, tangential force over normal force against the load factor: " + "; ".join(said)
                   + ". The words beside it say in which region they are.")
    return figure


KINDS = (("line", (7.5, 3), "line contact"), ("circle", (1.5, 1.5), "circular contact"))


def figures(result):
    """(file name, caption, function that makes the figure or returns None) of everything."""
    for name in _names(result, "depth_"):
        yield (f"{name}.svg", "Stress against depth under the " + name[6:].replace("_", " ") + " of the patch.",
               lambda name=name: depth_profile(result, name))
    for name in _names(result, "line_"):
        for body in _bodies(result, name):
            yield (f"{name}_{body}.svg", f"Stress in the {body} along {name.replace('_', ' ')}.",
                   lambda name=name, body=body: along_line(result, name, body))
    for name in _names(result, "plane_"):
        for model in result.models:
            for part in model.sets:
                if part.name == name:
                    several = len({m.key for m in result.models}) < len(result.models)
                    file = f"{name}_{part.body}_{model.name}" + (f"_{model.data['point']}" if several else "")
                    yield (f"{file}.svg", f"Stress in the {part.body} on {name.replace('_', ' ')}; cross: the largest.",
                           lambda model=model, part=part: plane(result, model, part))
    yield "shakedown_map.svg", "Shakedown map.", lambda: shakedown_map(result)
