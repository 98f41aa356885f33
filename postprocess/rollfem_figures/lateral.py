"""The lateral traction p_y along the middle lines."""
import numpy as np

from . import keys, looks, selection
from .curves import line_of
from .figure import Figure
from .outline import extent

# Below this part of the largest bound p_y is noise on the scale of the figure.
LEAST = 0.02


def _draw(panel, models, key, axis):
    """Curves of all models at one creepage on one middle line; returns the values they take and the
    largest bound."""
    values, bounds = [0.0], [0.0]
    for model in models:
        point = model.at(key)
        if point is None:
            continue
        curve = line_of(model, point, "traction_y", axis)
        if curve is not None and curve[1].size:
            panel.line(curve[0], -curve[1], **looks.line(model))
            if model.has_bound:
                values += [-np.nanmax(curve[1]), -np.nanmin(curve[1])]
        bound = line_of(model, point, "traction_bound", axis)
        if bound is not None and bound[1].size and model.has_bound:
            bounds.append(np.nanmax(bound[1]))
            for sign in (1, -1):
                panel.line(bound[0], sign * bound[1], looks.of_model(model)[0], 0.8, opacity=0.75)
    return values, max(bounds)


def paths(result):
    """-p_y along the middle lines, y = 0 above and x = 0 below, at up to three creepages; thin the
    bound, which leaves the frame where p_y is far below it. None without tangential tractions."""
    models = [m for m in selection.friction_models(result) if "traction_y" in m.points[0].fields]
    chosen = selection.chosen_keys(models, 4)
    chosen = chosen[1:] if len(chosen) > 3 else chosen  # of four the first says least
    if not chosen:
        return None
    texts, shared = keys.key_texts(chosen)
    figure = Figure(max(2, len(chosen)))
    for model in models:
        figure.entry(looks.label(model), *looks.of_model(model)[:2])
    figure.entry("traction bound, both signs", "soft", width=0.8)
    if shared:
        figure.entry(shared)
    values, bounds = [], []
    for axis in "xy":
        half = extent(models)["xy".index(axis)]
        for key in chosen:
            label = ("$x$ [mm] at $y$ = 0, rolling $\\rightarrow$" if axis == "x" else "$y$ [mm] at $x$ = 0, lateral")
            panel = figure.add(230, 165, texts[key], label, "$-p_y$ [MPa]")
            found, bound = _draw(panel, models, key, axis)
            values += found
            bounds.append(bound)
            panel.x.limits = (-half, half)
    least = LEAST * max(bounds)
    low, high = min(*values, -least), max(*values, least)
    for panel in figure.panels:
        panel.y.limits = (low - 0.08 * (high - low), high + 0.08 * (high - low))
    figure.seen = (f"Lateral traction along both middle lines at {len(chosen)} load points: between "
                   f"{min(values):.3g} and {max(values):.3g} MPa, under a bound of up to {max(bounds):.4g} MPa.")
    return figure
