"""Curves: traction coefficient against creepage, tractions along the middle lines, forces of strips."""
import math

import numpy as np

from . import keys, looks, published, selection
from .figure import Figure
from .outline import extent, loaded_runs
from .seen import span


def _draw_published(figure, panel, result, models):
    """Values of others as points, where our curves are: a point far outside would shrink them."""
    own = [p["longitudinal_creepage"] for m in models for p in m.points]
    room = 0.05 * (max(own) - min(own))
    for number, row in enumerate(published.creep_curves(result)):
        points = [(100 * xi, value) for xi, value in zip(row["xi"], row["traction_coefficient"])
                  if min(own) - room <= xi <= max(own) + room]
        if points:
            marker = "s^*"[number % 3]
            panel.line(*zip(*points), joined=False, marker=marker, size=5.5, hollow="open", order=4)
            figure.entry(row["name"], "ink", width=0, marker=marker, hollow="open")


def _coefficient(point, force):
    return -point[force] / point["normal_force"] if point["normal_force"] else math.nan


def _errors(points, force):
    """Bars of the coefficient."""
    if force == "lateral_force":
        return [(p.bar(force) or 0.0) / (abs(p["normal_force"]) or 1) for p in points]
    return [p.bar("traction_coefficient") or 0.0 for p in points]


def _draw_curve(figure, top, model, points, at, force):
    values = np.array([_coefficient(p, force) for p in points])
    errors = _errors(points, force)
    # A straight line of a theory without a bound leaves the frame.
    top.line(at, values, marker=looks.marker(model), see=model.has_bound, **looks.line(model))
    if any(errors):
        top.bars(at, values, errors if model.has_bound else np.zeros(len(errors)), looks.of_model(model)[0])
    figure.model(model, marker=True)
    return values


def _draw_difference(panel, model, reference, points, at, values, force, friction):
    pairs = [(a, 100 * (v - _coefficient(r, force)) / friction) for a, v, p in zip(at, values, points)
             if (r := reference.at(p.key))]
    if pairs:
        panel.line(*zip(*pairs), marker=looks.marker(model), see=model.has_bound, **looks.line(model))


def creep_curve(result):
    """-F_x/F_z of every model with friction, and beside it the difference from the reference model. None
    when no model has two load points."""
    models = [m for m in selection.friction_models(result) if len(m.points) > 1]
    if not models:
        return None
    scalar, factor, axis_label = keys.creepage_axis([p for m in models for p in m.points])
    by_step = any(p["step"] for m in models for p in m.points)
    force = "lateral_force" if scalar.startswith("lateral") else "longitudinal_force"
    ratio = "$-F_y/F_z$" if force == "lateral_force" else "$-F_x/F_z$"
    reference = selection.reference_for_forces(result)
    friction = result.case["friction_coefficient"]
    figure = Figure(2)
    top = figure.add(400, 270, keys.key_texts(selection.all_keys(models))[1], axis_label,
                     f"traction coefficient {ratio} [-]")
    top.y.see([0.0, friction])
    top.y.margin, top.y.least = 0.08, 0.02 * friction
    top.level(friction)
    top.text(0.01, friction, f"full slip: $\\mu$ = {friction:.3g}", shift=(0, -4), share=(True, False))
    beside = None
    if len(models) > 1 and reference in models:
        beside = figure.add(400, 270, f"difference from {looks.label(reference)}", axis_label, "[% of $\\mu$]")
        beside.y.see([-1.0, 1.0])
        beside.level(0, looks.of_model(reference)[0], (), 1.6)
    said = []
    for model in models:
        points = model.points if by_step else sorted(model.points, key=lambda p: p[scalar])
        at = np.array([factor * p[scalar] for p in points])
        values = _draw_curve(figure, top, model, points, at, force)
        top.x.see(at)
        said.append(f"{looks.label(model)} from {values[0]:.3g} at {at[0]:.3g} to {values[-1]:.3g} at {at[-1]:.3g}")
        if beside and model is not reference:
            _draw_difference(beside, model, reference, points, at, values, force, friction)
    if force == "longitudinal_force":
        _draw_published(figure, top, result, models)
    figure.seen = f"Traction coefficient {ratio} against {axis_label}: {'; '.join(said)}. Full slip is {friction:.3g}."
    return figure


def line_of(model, point, name, axis):
    """Positions and values of a field on the middle line within the patch, 0 at its edges; None when
    the model does not give it. Separate patches are separated by NaN."""
    values, pressure = point.fields.get(name), point.fields.get("pressure")
    if values is None or pressure is None:
        return None
    at = model.x if axis == "x" else model.y
    positions, out = [], []
    for low, high, first, last in loaded_runs(at, model.middle(pressure, axis)):
        positions += [low, *at[first:last], high, math.nan]
        out += [0.0, *model.middle(values, axis)[first:last], 0.0, math.nan]
    return np.array(positions), np.array(out)


def _span(models, chosen, curve, signs):
    """Lowest and highest of fields with their `signs` at all creepages, but of models that nothing bounds."""
    values = [0.0]
    for model in (m for m in models if m.has_friction and m.has_bound):
        for point in filter(None, map(model.at, chosen)):
            for name, sign in signs.items():
                found = curve(model, point, name)
                if found is not None and len(found[1]):
                    values += [sign * np.nanmin(found[1]), sign * np.nanmax(found[1])]
    return min(values), max(values)


def _draw_traction(panel, model, point, curve, field, sides):
    """Minus a traction, and thin its bound on both sides of 0 or above it."""
    thin = {"colour": looks.of_model(model)[0], "width": 0.8, "opacity": 0.75}
    for name, sign, look in [*(("traction_bound", side, thin) for side in sides), (field, -1, looks.line(model))]:
        found = curve(model, point, name)
        if found is not None and len(found[0]):
            panel.line(found[0], sign * found[1], **look)


def _panels(result, chosen, titles, labels, half, curve):
    """A figure of the pressure and, at each of the creepages, the traction under its bound; `curve(model,
    point, field)` gives what is drawn, None where the model has none. `titles` of the first panel;
    `labels` of x, of its y and of the others' y."""
    models = selection.with_pressure(result)
    texts, shared = keys.key_texts(chosen)
    figure = Figure(3)
    first = figure.add(230, 165, titles, labels[0], labels[1])
    first.y.limits = (0.0, None)
    for model in models:
        found = curve(model, model.points[0], "pressure")
        if found is not None and len(found[0]):
            first.line(*found, order=3 if model.name == "hertz" else 2, **looks.line(model))
            figure.model(model)
    low, high = _span(models, chosen, curve, {"traction_bound": 1, "traction_x": -1})
    room = 0.05 * (high - low) or 1.0
    for key in chosen:
        panel = figure.add(230, 165, texts[key], labels[0], labels[2])
        panel.y.limits = low - room, high + room
        for model in models:
            if model.has_friction and (point := model.at(key)):
                _draw_traction(panel, model, point, curve, "traction_x", (1,))
    for panel in figure.panels:
        panel.x.limits = (-half, half)
    return figure, models, shared


def path(result, axis):
    """p_n, and p_x with the traction bound at several creepages, along the middle line of "x" or
    "y". None when no model has a pressure field."""
    models = selection.with_pressure(result)
    if not models:
        return None
    chosen = selection.chosen_keys(models, 5)
    label = "$x$ [mm], rolling $\\rightarrow$" if axis == "x" else "$y$ [mm], lateral"
    figure, models, shared = _panels(result, chosen, "contact pressure", (label, "$p_n$ [MPa]", "$-p_x$ [MPa]"),
                                     extent(models)["xy".index(axis)],
                                     lambda model, point, name: line_of(model, point, name, axis))
    own = any(m.name in ("fastsim", "strip") for m in models)
    if chosen:
        figure.entry("traction bound" if own else "traction bound $\\mu p_n$", "soft", width=0.8)
    figure.heading_entry(shared)
    figure.seen = (f"Contact pressure over {axis}: " + "; ".join(
        f"{looks.label(m)} up to {m.points[0]['max_pressure']:.4g} MPa between "
        f"{span(line_of(m, m.points[0], 'pressure', axis))}"
        for m in models) + (f". Then tangential traction under its bound at {len(chosen)} load points." if chosen else "."))
    return figure


def _strip_force(model, point, name):
    """Force per strip over y, N per mm of width: a traction summed over the elements of each row along
    rolling."""
    field = point.fields.get(name)
    return None if field is None else (model.y, field.sum(axis=1) * model.dx)


def strip_forces(result):
    """Forces of the strips along rolling, over y: p_n, and -p_x at several creepages with the full
    sliding of the same strips. None when no model has a pressure field."""
    models = selection.with_pressure(result)
    if not models:
        return None
    chosen = selection.chosen_keys(models, 5)
    figure, models, shared = _panels(result, chosen, "normal force per strip",
                                     ("$y$ [mm], lateral", "$\\int p_n dx$ [N/mm]", "$-\\int p_x dx$ [N/mm]"),
                                     extent(models)[1], _strip_force)
    if chosen:
        figure.entry("full sliding of the strip", "soft", width=0.8)
    figure.heading_entry(shared)
    figure.seen = "Normal force per mm of width over y: " + "; ".join(
        f"{looks.label(m)} up to {_strip_force(m, m.points[0], 'pressure')[1].max():.4g} N/mm" for m in models) + "."
    return figure


# Below this part of the largest bound p_y is noise on the scale of the figure.
LEAST_LATERAL = 0.02


def lateral_paths(result):
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
        figure.model(model)
    figure.entry("traction bound, both signs", "soft", width=0.8)
    figure.heading_entry(shared)
    lines = {axis: lambda model, point, name, axis=axis: line_of(model, point, name, axis) for axis in "xy"}
    lows, highs = zip(*(_span(models, chosen, curve, {"traction_y": -1}) for curve in lines.values()))
    bound = max(_span(models, chosen, curve, {"traction_bound": 1})[1] for curve in lines.values())
    low, high = min(*lows, -LEAST_LATERAL * bound), max(*highs, LEAST_LATERAL * bound)
    for (axis, curve), half, label in zip(lines.items(), extent(models), (
            "$x$ [mm] at $y$ = 0, rolling $\\rightarrow$", "$y$ [mm] at $x$ = 0, lateral")):
        for key in chosen:
            panel = figure.add(230, 165, texts[key], label, "$-p_y$ [MPa]")
            panel.x.limits = (-half, half)
            panel.y.limits = (low - 0.08 * (high - low), high + 0.08 * (high - low))
            for model in models:
                if point := model.at(key):
                    _draw_traction(panel, model, point, curve, "traction_y", (1, -1) if model.has_bound else ())
    figure.seen = (f"Lateral traction along both middle lines at {len(chosen)} load points: between "
                   f"{min(lows):.3g} and {max(highs):.3g} MPa, under a bound of up to {bound:.4g} MPa.")
    return figure
