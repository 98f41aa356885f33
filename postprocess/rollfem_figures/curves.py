"""Curves: traction coefficient against creepage, tractions along the middle lines."""
import math

import numpy as np
from matplotlib import pyplot as plt

from . import published, selection, style
from .outline import extent, loaded_runs


def bar(point, quantity):
    """The error bar of a quantity, 0 without one."""
    return point.errors.get(quantity, 0.0)


def _draw_published(panel, result, models):
    """Values of others as points, where our curves are: a point far outside would shrink them."""
    own = [p["longitudinal_creepage"] for m in models for p in m.points]
    room = 0.05 * (max(own) - min(own))
    for number, row in enumerate(published.creep_curves(result)):
        points = [(100 * xi, value) for xi, value in zip(row["xi"], row["traction_coefficient"])
                  if min(own) - room <= xi <= max(own) + room]
        if points:
            panel.plot(*zip(*points), linestyle="none", marker="s^*"[number % 3], markersize=8,
                       markerfacecolor="none", markeredgecolor="black", markeredgewidth=0.9, zorder=5,
                       label=row["name"])


def _coefficient(point, force):
    return -point[force] / point["normal_force"] if point["normal_force"] else math.nan


def creep_curve(result):
    """-F_x/F_z of every model with friction, and below the difference to the reference model. None
    when no model has two load points."""
    models = [m for m in selection.friction_models(result) if len(m.points) > 1]
    if not models:
        return None
    scalar, factor, axis_label = style.creepage_axis([p for m in models for p in m.points])
    by_step = any(p["step"] for m in models for p in m.points)
    lateral = scalar.startswith("lateral")
    force = "lateral_force" if lateral else "longitudinal_force"
    ratio = r"$-F_y/F_z$" if lateral else r"$-F_x/F_z$"
    many = len(models) > 4

    reference = selection.reference_for_forces(result)
    compare = len(models) > 1 and reference in models
    figure, axes = plt.subplots(2 if compare else 1, 1, sharex=True, squeeze=False,
                                figsize=(6.4, (5.2 if compare else 4.0) + 0.5 * many),
                                gridspec_kw={"height_ratios": [3, 1.2] if compare else [1]})
    top = axes[0, 0]
    friction = result.case["friction_coefficient"]
    top.axhline(friction, color=style.GREY, linewidth=0.8, linestyle=(0, (1, 1.5)))
    top.annotate(rf"full slip: $\mu$ = {friction:.3g}", (0.01, friction), ha="left", va="bottom",
                 xycoords=("axes fraction", "data"), color=style.GREY, fontsize=8)
    gaps, bounded = [], [0.0, friction]  # of the models with a traction bound, which set the scales
    for model in models:
        points = model.points if by_step else sorted(model.points, key=lambda p: p[scalar])
        at = np.array([factor * p[scalar] for p in points])
        values = np.array([_coefficient(p, force) for p in points])
        bounded += [v for v in values if model.has_bound]
        errors = [bar(p, force) / (abs(p["normal_force"]) or 1) if lateral else bar(p, "traction_coefficient")
                  for p in points]
        top.errorbar(at, values, yerr=errors if any(errors) else None, capsize=2, elinewidth=0.8,
                     marker=style.marker(model), markersize=4.5, label=style.label(model),
                     **style.line(model))
        if compare and model is not reference:
            pairs = [(a, v, reference.at(p.key)) for a, v, p in zip(at, values, points)]
            pairs = [(a, 100 * (v - _coefficient(r, force)) / friction) for a, v, r in pairs if r]
            if pairs:
                gaps += [g for _, g in pairs if model.has_bound]
                axes[1, 0].plot(*zip(*pairs), marker=style.marker(model), markersize=4.5,
                                **style.line(model))
    if not lateral:
        _draw_published(top, result, models)
    top.set_ylabel(f"traction coefficient {ratio} [-]")
    shared = style.key_texts(selection.all_keys(models))[1]
    if shared:
        top.set_title(shared)
    if any(not m.has_bound for m in models):  # a straight line that leaves the frame
        room = 0.1 * (max(bounded) - min(bounded))
        top.set_ylim(min(bounded) - room, max(bounded) + 1.5 * room)
    top.margins(y=0.1)
    if many:
        style.legend_above(figure, axes, top.get_legend_handles_labels()[0], 4, between=(0, 0.16))
    else:
        style.arrange(figure, axes, between=(0, 0.16))
        top.legend(loc="lower right")
    if compare:
        axes[1, 0].axhline(0, **style.line(reference))
        axes[1, 0].set_ylabel(f"difference to\n{style.label(reference)} [% of $\\mu$]")
        reach = 1.15 * max([abs(g) for g in gaps] + [1.0])
        axes[1, 0].set_ylim(-reach, reach)
    axes[-1, 0].set_xlabel(axis_label)
    figure.align_ylabels()
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


def _pressure_panel(panel, models, axis):
    for model in models:
        curve = line_of(model, model.points[0], "pressure", axis)
        if curve is not None:
            panel.plot(*curve, label=style.label(model), zorder=3 if model.name == "hertz" else 2,
                       **style.line(model))
    panel.set_title("contact pressure")
    panel.set_ylabel(r"$p_n$ [MPa]")
    panel.set_ylim(bottom=0)


def _traction_panel(panel, models, creepages, axis):
    for model in models:
        point = model.at(creepages)
        if point is None or not model.has_friction:
            continue
        for name, sign, ink in (
                ("traction_bound", 1, {"color": style.colour(model), "linewidth": 0.7, "alpha": 0.7}),
                ("traction_x", -1, style.line(model))):
            curve = line_of(model, point, name, axis)
            if curve is not None:
                panel.plot(curve[0], sign * curve[1], **ink)


def _limits(models, keys, values_of):
    """Lowest and highest of `values_of(model, point, name)` at all creepages, but of models that nothing
    bounds: one scale for all panels."""
    values = [0.0]
    for model in (m for m in models if m.has_friction and m.has_bound):
        for point in filter(None, map(model.at, keys)):
            for name, sign in (("traction_bound", 1), ("traction_x", -1)):
                found = values_of(model, point, name)
                if found is not None and len(found):
                    values += [sign * np.nanmin(found), sign * np.nanmax(found)]
    room = 0.05 * (max(values) - min(values)) or 1.0
    return min(values) - room, max(values) + room


def _panels(count):
    """(figure, all its panels, the `count` that are used, over one abscissa): at most three beside each
    other."""
    columns = min(3, count)
    rows = math.ceil(count / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(0.5 + 3.1 * columns, 0.85 + 2.1 * rows),
                                squeeze=False, sharex=True)
    for panel in list(axes.flat)[count:]:
        panel.set_visible(False)
    return figure, axes, list(axes.flat)[:count]


def _label_lowest(panels, columns, half, label):
    """The abscissa from -half to half, named under the lowest panel of every column."""
    panels[0].set_xlim(-half, half)
    for panel in panels[-columns:]:
        panel.set_xlabel(label)
        panel.tick_params(labelbottom=True)


def _legend_above(figure, axes, bound, shared):
    """The curves of the first panel, the thin lines of the traction `bound` and what all panels share;
    either may be empty."""
    handles = axes[0, 0].get_legend_handles_labels()[0]
    if bound:
        handles.append(style.entry(bound, color=style.GREY, linewidth=0.7))
    if shared:
        handles.append(style.entry(shared))
    style.legend_above(figure, axes, handles, 5, between=(0.8, 0.45), left=0.78)


def path(result, axis):
    """p_n, and p_x with the traction bound at several creepages, along the middle line of "x" or
    "y". None when no model has a pressure field."""
    models = [m for m in result.models if m.points and "pressure" in m.points[0].fields]
    if not models:
        return None
    chosen = selection.chosen_keys(models, 5)
    texts, shared = style.key_texts(chosen)
    figure, axes, panels = _panels(1 + len(chosen))
    _pressure_panel(panels[0], models, axis)
    limits = _limits(models, chosen, lambda *of: (line_of(*of, axis) or [None, []])[1])
    for panel, key in zip(panels[1:], chosen):
        _traction_panel(panel, models, key, axis)
        panel.set_title(texts[key])
        panel.set_ylim(limits)
        panel.set_ylabel(r"$-p_x$ [MPa]")
    half = extent(models)[0 if axis == "x" else 1]
    _label_lowest(panels, axes.shape[1], half,
                  r"$x$ [mm], rolling $\rightarrow$" if axis == "x" else r"$y$ [mm], lateral")
    own = any(m.name in ("fastsim", "strip") for m in models)
    bound = "traction bound" if own else r"traction bound $\mu\,p_n$"
    _legend_above(figure, axes, bound if chosen else "", shared)
    return figure


def _strip_force(model, field):
    """Force per strip, N per mm of width: a traction summed over the elements of each row along
    rolling."""
    return field.sum(axis=1) * model.dx


def strip_forces(result):
    """Forces of the strips along rolling, over y: p_n, and -p_x at several creepages with the full
    sliding of the same strips. None when no model has a pressure field."""
    models = [m for m in result.models if m.points and "pressure" in m.points[0].fields]
    if not models:
        return None
    chosen = selection.chosen_keys(models, 5)
    texts, shared = style.key_texts(chosen)
    figure, axes, panels = _panels(1 + len(chosen))
    for model in models:
        panels[0].plot(model.y, _strip_force(model, model.points[0].fields["pressure"]),
                       label=style.label(model), **style.line(model))
    panels[0].set_title("normal force per strip")
    panels[0].set_ylabel(r"$\int p_n\,dx$ [N/mm]")
    limits = _limits(models, chosen, lambda model, point, name: _strip_force(model, point.fields[name])
                     if name in point.fields else None)
    for panel, key in zip(panels[1:], chosen):
        for model in models:
            point = model.at(key)
            if point is None or not model.has_friction or "traction_x" not in point.fields:
                continue
            if "traction_bound" in point.fields:
                panel.plot(model.y, _strip_force(model, point.fields["traction_bound"]), linewidth=0.7,
                           alpha=0.7, color=style.colour(model))
            panel.plot(model.y, -_strip_force(model, point.fields["traction_x"]), **style.line(model))
        panel.set_title(texts[key])
        panel.set_ylim(limits)
        panel.set_ylabel(r"$-\int p_x\,dx$ [N/mm]")
    _label_lowest(panels, axes.shape[1], extent(models)[1], r"$y$ [mm], lateral")
    _legend_above(figure, axes, "full sliding of the strip" if chosen else "", shared)
    return figure
