"""The lateral traction p_y along the middle lines."""
import numpy as np
from matplotlib import pyplot as plt

from . import selection, style
from .curves import line_of
from .outline import extent

# Below this part of the largest bound p_y is noise on the scale of the figure.
LEAST = 0.02


def _panel(panel, models, key, axis):
    """Curves of all models at one creepage on one middle line; returns the values they take and the
    largest bound."""
    values, bounds = [0.0], [0.0]
    for model in models:
        point = model.at(key)
        if point is None:
            continue
        curve = line_of(model, point, "traction_y", axis)
        if curve is not None and curve[1].size:
            panel.plot(curve[0], -curve[1], label=style.label(model), **style.line(model))
            if model.has_bound:
                values += [-np.nanmax(curve[1]), -np.nanmin(curve[1])]
        bound = line_of(model, point, "traction_bound", axis)
        if bound is not None and bound[1].size and model.has_bound:
            bounds.append(np.nanmax(bound[1]))
            for sign in (1, -1):
                panel.plot(bound[0], sign * bound[1], color=style.colour(model), linewidth=0.7,
                           alpha=0.7)
    return values, max(bounds)


def paths(result):
    """-p_y along the middle lines, y = 0 above and x = 0 below, at up to three creepages; thin the
    bound, which leaves the frame where p_y is far below it. None without tangential tractions."""
    models = [m for m in selection.friction_models(result) if "traction_y" in m.points[0].fields]
    keys = selection.chosen_keys(models, 4)
    keys = keys[1:] if len(keys) > 3 else keys  # of four the first says least
    if not keys:
        return None
    texts, shared = style.key_texts(keys)
    # One creepage: the two lines side by side.
    rows, columns = (2, len(keys)) if len(keys) > 1 else (1, 2)
    figure, axes = plt.subplots(rows, columns, figsize=(0.6 + 3.1 * columns, 0.6 + 2.3 * rows),
                                squeeze=False, sharey=True)
    values, bounds = [], []
    for row, axis in zip(axes.reshape(2, -1), "xy"):
        half = extent(models)["xy".index(axis)]
        for panel, key in zip(row, keys):
            found, bound = _panel(panel, models, key, axis)
            values += found
            bounds.append(bound)
            panel.set_xlim(-half, half)
            panel.set_title(texts[key])
            panel.set_xlabel(r"$x$ [mm] at $y$ = 0, rolling $\rightarrow$" if axis == "x"
                             else r"$y$ [mm] at $x$ = 0, lateral")
    for panel in axes[:, 0]:
        panel.set_ylabel(r"$-p_y$ [MPa]")
    least = LEAST * max(bounds)
    low, high = min(*values, -least), max(*values, least)
    axes[0, 0].set_ylim(low - 0.08 * (high - low), high + 0.08 * (high - low))
    handles = axes[0, 0].get_legend_handles_labels()[0]
    handles.append(style.entry("traction bound, both signs", color=style.GREY, linewidth=0.7))
    if shared:
        handles.append(style.entry(shared))
    style.legend_above(figure, axes, handles, max(2, int(figure.get_figwidth() / 1.6)), between=(0.25, 0.78))
    return figure
