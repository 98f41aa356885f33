# SPDX-License-Identifier: LGPL-2.1-or-later
"""Temperature of the surfaces: along rolling through the hottest place, and as a map."""
import numpy as np

from . import load_points, styles
from .figure import Figure
from .maps import ALONG, colour_scale, edge_function, contour_lines, filled, padded

DEGREES = "temperature [°C]"


def _heated(result):
    return [model for model in result.models if any("temperature_rail" in point.fields for point in model.points)]


def _row(model, point):
    """Of the hottest element in contact."""
    inside = np.where(point.fields["pressure"] > 0, point.fields["temperature_rail"], -np.inf)
    return np.unravel_index(inside.argmax(), inside.shape)[0]


def _hottest(model):
    return max((p for p in model.points if "temperature_rail" in p.fields), key=lambda p: p["max_temperature"])


def along(result):
    """Temperature of both surfaces along x through the hottest place of each load point, up to three. None without heat."""
    models = _heated(result)
    if not models:
        return None
    hottest = _hottest(models[0]).key
    chosen = [key for key in load_points.chosen_keys(models, 3) if key != hottest][-2:] + [hottest]
    texts, shared = load_points.key_texts(chosen)
    figure = Figure(3)
    apart = False
    for key in chosen:
        panel = figure.add(230, 165, texts[key], ALONG["x"], DEGREES)
        for model in models:
            point = model.at(key)
            if point is None or "temperature_rail" not in point.fields:
                continue
            row = _row(model, point)
            wheel, rail = (point.fields[f"temperature_{body}"][row] for body in ("wheel", "rail"))
            panel.line(model.x, rail, **styles.line(model))
            if np.abs(wheel - rail).max() > 1e-3 * np.ptp(rail):
                panel.line(model.x, wheel, **{**styles.line(model), "name": "", "dash": (2, 2)})
                apart = True
    if apart:
        figure.entry("rail", "soft")
        figure.entry("wheel", "soft", dash=(2, 2))
    figure.entry(shared)
    return figure


def surface(result):
    """Map of the rail's surface temperature of the reference model at its hottest load point. None without heat."""
    models = _heated(result)
    if not models:
        return None
    model = models[0]
    point = _hottest(model)
    figure = Figure(2, styles.label(model), in_rows=True)
    right, up = np.meshgrid(model.x, model.y)
    panel = figure.add(300, 0, f"{DEGREES}, {load_points.key_texts([point.key])[0][point.key]}", ALONG["x"], ALONG["y"], equal=True)
    panel.x.limits, panel.y.limits = (model.x[0], model.x[-1]), (model.y[0], model.y[-1])
    levels, step = filled(panel, right, up, point.fields["temperature_rail"])
    panel.paths(contour_lines(*padded(model, edge_function(point.fields["pressure"]), -1.0), 0.0), "ground", width=1.4)
    panel.fit()
    colour_scale(figure, levels, step, panel.height)
    return figure.tell("", [f"{DEGREES} {point.fields['temperature_rail'].min():.4g} to {point['max_temperature']:.4g}"])
