# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves: traction coefficient against creepage, tractions along the centre lines, forces of strips."""
import itertools
import math
import os

import numpy as np

from ..errors import FileError
from ..files import read_rows
from . import load_points, styles, tables
from .figure import Figure
from .maps import ALONG, extent, loaded_runs
from .published import published


def _draw_published(panel, result, models):
    """Published values as points, within the range of our curves, because a point far outside would shrink them."""
    own = [p["longitudinal_creepage"] for m in models for p in m.points]
    room = 0.05 * (max(own) - min(own))
    for number, row in enumerate(published(result)["creep_curve"]):
        panel.spots([(100 * xi, value) for xi, value in zip(row["xi"], row["traction_coefficient"])
                     if min(own) - room <= xi <= max(own) + room],
                    marker="s^*"[number % 3], size=5.5, hollow="open", order=4, name=row["name"])


def read_overlay(path):
    """(name, [n, 2 or 3]: creepage, traction coefficient, bar) of a measured creep curve in a CSV table; FileError if it is none."""
    try:
        title, rows, units = read_rows(path)
        columns = list(rows[0]) if rows else []
        values = np.array([[float(row[name]) for name in columns[:3]] for row in rows])
    except (OSError, TypeError, ValueError, UnicodeDecodeError) as error:
        raise FileError(f"{path}: is no table of numbers: {error}; do: {OVERLAY}") from error
    if len(columns) < 2 or not np.isfinite(values).all():
        raise FileError(f"{path}: has no creepage and traction coefficient in each row; do: {OVERLAY}")
    values[:, 0] *= 0.01 if units[columns[0]] == "%" else 1.0
    return title or os.path.basename(path), values


OVERLAY = 'give two or three columns with a heading such as "creepage [%],traction coefficient,bar"'


def _draw_overlays(panel, result):
    for number, (name, values) in enumerate(result.overlays):
        panel.spots([(100 * at, value) for at, value, *_ in values], marker="Dv<>"[number % 4], size=3.6, hollow="open", order=5,
                    name=name)
        if values.shape[1] > 2:
            panel.bars(100 * values[:, 0], values[:, 1], values[:, 2], "ink")


def _error(point, force):
    """The error bar of the coefficient."""
    if force == "lateral_force":
        return (point.bar(force) or 0.0) / (abs(point["normal_force"]) or 1)
    return point.bar("traction_coefficient") or 0.0


def creep_curve(result):
    """-F_x/F_z of every model with friction, and beside it the difference from the reference model. None if no model
    has two load points that are no passes. With prescribed forces only for a law that falls: found_for_force."""
    models = [m for m in load_points.friction_models(result) if len(m.points) > 1 and m.points[0].by_number != "pass"]
    found, law = load_points.found_motions(models), result.friction_law
    if not models or (found and law is None):
        return None
    scalar, factor, axis_label = load_points.creepage_axis([p for m in models for p in m.points])
    by_step = any(p["step"] for m in models for p in m.points)
    force = "lateral_force" if scalar.startswith("lateral") else "longitudinal_force"
    ratio = "$-F_y/F_z$" if force == "lateral_force" else "$-F_x/F_z$"
    reference = load_points.reference_for_forces(result)
    friction = result.friction_coefficient
    figure = Figure(2)
    top = figure.add(400, 270, load_points.key_texts(load_points.all_keys(models))[1], axis_label,
                     f"traction coefficient {ratio} [-]")
    largest = max((abs(load_points.coefficient(p, force)) for m in models for p in m.points if p["normal_force"]), default=0.0)
    full = not by_step or largest > 0.6 * friction  # a history far below full slip fills the field
    top.y.see([0.0, friction] if full else [0.0])
    top.y.margin, top.y.least = 0.08, 0.02 * friction
    if full:
        top.level(friction)
    if law is None and full:
        top.text(0.01, friction, f"full slip: $\\mu$ = {friction:.3g}", shift=(0, -4), share=(True, False))
    beside = None
    if len(models) > 1 and reference in models and not found:
        beside = figure.add(400, 270, f"difference from {styles.label(reference)}", axis_label, "[% of $\\mu$]")
        beside.y.see([-1.0, 1.0])
        beside.level(0, styles.of_model(reference)[0], (), 1.6)
    for model in models:
        points = model.points if by_step else sorted(model.points, key=lambda p: p[scalar])
        at = np.array([factor * p[scalar] for p in points])
        values, errors = (np.array([of(p, force) for p in points]) for of in (load_points.coefficient, _error))
        # The straight line of a theory without traction bound leaves the frame.
        look = {"see": model.has_bound, **styles.line(model, True)}
        top.line(at, values, **look)
        if errors.any():
            top.bars(at, values, errors if model.has_bound else 0 * errors, look["colour"])
        top.x.see(at)
        if beside and model is not reference:
            beside.spots([(a, 100 * (v - load_points.coefficient(r, force)) / friction) for a, v, p in zip(at, values, points)
                          if (r := reference.at(p.key))], True, **look)
    if force == "longitudinal_force":
        _draw_published(top, result, models)
    if factor == 100:
        _draw_overlays(top, result)
    if law is not None:
        _draw_fall(figure, result, models)
    return figure


def found_for_force(result):
    """The creepage or shift of every model at each load point whose force is prescribed, and beside it the difference
    from the reference model, both with bars. None without prescribed forces."""
    models = load_points.friction_models(result)
    reference = load_points.reference_for_forces(result)
    figure = Figure(2)
    for name, force, axis, words, factor, unit in load_points.found_motions(models):
        several = len(load_points.all_keys(models)) > 1
        across = f"prescribed force $-F_{axis}$ [kN]" if several else ""
        panel = figure.add(400, 270, "found for the given force", across, f"{words} [{unit}]")
        panels = [(panel, lambda point, base: factor * point[name], lambda point, base: factor * (point.bar(name) or 0.0))]
        if len(models) > 1 and reference in models:
            beside = figure.add(400, 270, f"difference from {styles.label(reference)}", across, f"[% of its {words}]")
            beside.level(0, styles.of_model(reference)[0], (), 1.6)
            panels.append((beside, lambda point, base: 100 * (point[name] / base[name] - 1),
                           lambda point, base: 100 * abs((point.bar(name) or 0.0) / base[name])))
        for place, (panel, of, bar) in itertools.product(range(len(models)), panels):
            pairs = [(p, base) for p in models[place].points if (base := reference.at(p.key)) and abs(base[name]) > 1e-12]
            at = np.array([-p[force] / 1e3 if several else place for p, _ in pairs])
            values, errors = (np.array([what(*pair) for pair in pairs]) for what in (of, bar))
            order = np.argsort(at)
            panel.spots(list(zip(at[order], values[order])), several, **styles.line(models[place], True))
            panel.bars(at, values, errors, styles.of_model(models[place])[0])
            if not several:
                panel.x.ticks = [(k, styles.label(model)) for k, model in enumerate(models)]
                panel.x.limits = (-0.5, len(models) - 0.5)
    return figure if figure.panels else None


def _draw_fall(figure, result, models):
    """The friction of full sliding under a creep curve, and a panel of its rise with initial slope and peak."""
    found = {model.key: load_points.branch(model) for model in models}
    tops = {key: load_points.peak(*both) for key, both in found.items()}
    top, friction = figure.panels[0], result.friction_coefficient
    sign = math.copysign(1, sum(sum(p.creepages[:2]) for m in models for p in m.points))
    at = np.linspace(0, max((both[0][-1] for both in found.values() if len(both[0])), default=0.0), 300)
    sliding = np.interp(result.slip_speed * at, *result.friction_law.T)
    look = {"colour": "soft", "width": 1.2, "dash": (1.5, 2.2), "see": False, "name": "full sliding"}
    top.line(sign * 100 * at, sign * sliding, **look)
    top.text(0.99, friction, f"at rest: $\\mu$ = {friction:.3g}", "end", shift=(0, -4), share=(True, False))
    reach = 2.5 * max((peak[0] for peak in tops.values() if peak), default=0.0)
    if not reach:
        return
    of = "" if sign > 0 else "minus "
    rise = figure.add(400, 270, "the rise", of + top.x.label, of + top.y.label)
    rise.x.limits, rise.y.limits = (0.0, 100 * reach), (0.0, 1.12 * friction)
    rise.level(friction)
    rise.line(100 * at, sliding, **look)
    for model in models:
        (creepages, values), peak = found[model.key], tops[model.key]
        rise.line(100 * creepages, values, **styles.line(model, True))
        if slope := load_points.initial_slope(creepages, values):
            rise.line([0.0, 100 * friction / slope], [0.0, friction], styles.of_model(model)[0], 0.8, opacity=0.75)
            figure.entry("initial slope", "soft", width=0.8)
        if peak:
            rise.spots([(100 * peak[0], peak[1])], colour="ink", marker="o", size=7, hollow="open", name="peak")
        if peak and model is load_points.reference_for_forces(result):
            rise.text(100 * peak[0], peak[1], f"{styles.label(model)}: {peak[1]:.3g} at {100 * peak[0]:.3g} %", "middle", "ink",
                      (0, 26))


def friction_law(result):
    """The coefficient of friction over the slip velocity. None for a constant one."""
    law = result.friction_law
    if law is None:
        return None
    rest, kinetic = law[0, 1], law[-1, 1]
    rigid = max((result.slip_speed * math.hypot(*p.creepages[:2]) for m in result.models for p in m.points), default=0.0)
    end = max(rigid, law[np.argmax(law[:, 1] <= kinetic + 0.06 * (rest - kinetic)), 0])
    shown = law[law[:, 0] <= 1.2 * end]
    figure = Figure(1)
    panel = figure.add(400, 190, f"friction law ({result.inputs['friction.law']})", "slip velocity $s$ [mm/s]",
                       "coefficient of friction $\\mu$ [-]")
    panel.line(shown[:, 0], shown[:, 1], "blue", 1.8)
    panel.x.limits, panel.y.limits = (0.0, 1.05 * end), (0.0, 1.18 * rest)
    panel.level(kinetic)
    panel.text(0.01, kinetic, f"kinetic: {kinetic:.3g}", shift=(0, 13), share=(True, False))
    panel.text(0.01, rest, f"at rest: {rest:.3g}", shift=(0, -5), share=(True, False))
    if rigid > 0:
        panel.level(rigid, upright=True)
        left = rigid > 0.5 * end
        panel.text(rigid, 0, "rigid slip at the largest creepage", "end" if left else "start", shift=(-4 if left else 4, -5))
    memory = result.inputs.get("friction.memory_distance", 0.0)
    panel.text(0.99, rest, f"memory: {1000 * memory:.3g} µm slid" if memory else "no memory", "end", shift=(0, -5),
               share=(True, False))
    return figure


def line_place(models, axis):
    """Where lines along an axis go: through the contact point, or through the largest pressure of the first model that
    misses it there by more than 2 %."""
    pressures = [p.fields["pressure"] for p in models[0].points if "pressure" in p.fields]
    pressure = max(pressures, key=np.max)
    if models[0].line(pressure, axis).max() >= 0.98 * pressure.max():
        return 0.0
    row, column = np.unravel_index(pressure.argmax(), pressure.shape)
    return float(models[0].y[row] if axis == "x" else models[0].x[column])


def _along(axis, at):
    """The label of a line along an axis."""
    other = "y" if axis == "x" else "x"
    return f"${axis}$ [mm] at ${other}$ = {tables.plain(round(at, 2))}, " + ("rolling $\\rightarrow$" if axis == "x" else "lateral")


def line_of(axis, place=0.0):
    """A function of model, load point and field: positions and values on a line within the patch, 0 at its edges; None
    if the model does not give it. Separate patches are separated by NaN."""
    def curve(model, point, name):
        values, pressure = point.fields.get(name), point.fields.get("pressure")
        if values is None or pressure is None:
            return None
        at = model.x if axis == "x" else model.y
        positions, out = [], []
        for low, high, first, last in loaded_runs(at, model.line(pressure, axis, place)):
            positions += [low, *at[first:last], high, math.nan]
            out += [0.0, *model.line(values, axis, place)[first:last], 0.0, math.nan]
        return np.array(positions), np.array(out)

    return curve


def strip_of(model, point, name):
    """Force per strip over y, N per mm of width: a traction summed over the elements of each row along
    rolling."""
    field = point.fields.get(name)
    return None if field is None else (model.y, field.sum(axis=1) * model.dx)


def _span(models, chosen, curve, signs):
    """Lowest and highest value of fields with their `signs` at all creepages, except for models without traction
    bound."""
    values = [0.0]
    for model in (m for m in models if m.has_friction and m.has_bound):
        for point in filter(None, map(model.at, chosen)):
            for name, sign in signs.items():
                found = curve(model, point, name)
                if found is not None and len(found[1]):
                    values += [sign * np.nanmin(found[1]), sign * np.nanmax(found[1])]
    return min(values), max(values)


def _draw_tractions(panel, models, key, curve, field, sides=(1,)):
    """Minus a traction of every model, and as thin lines its bound on both sides of 0 or above it."""
    for model in models:
        point = model.at(key) if model.has_friction else None
        thin = {"colour": styles.of_model(model)[0], "width": 0.8, "opacity": 0.75}
        bounds = [("traction_bound", side, thin) for side in sides if model.has_bound or len(sides) == 1]
        for name, sign, look in [*bounds, (field, -1, {**styles.line(model), "name": ""})] if point else ():
            found = curve(model, point, name)
            if found is not None:
                panel.line(found[0], sign * found[1], **look)


def _panels(result, title, labels, half, curve, thin):
    """A figure of the pressure and, at several load points, the traction under its bound;
    `curve(model, point, field)` returns the curve, or None if the model has none. `title`: of the first panel;
    `labels`: of x, of its y and of the others' y; `half`: half-width of the drawing; `thin`: legend entry of the
    bound. None if no model has a pressure field."""
    models = load_points.with_pressure(result)
    if not models:
        return None
    chosen = load_points.chosen_keys(models, 5)
    texts, shared = load_points.key_texts(chosen)
    figure = Figure(3)
    first = figure.add(230, 165, title + ", last pass" * bool(load_points.last_pass(models)), labels[0], labels[1])
    first.y.limits = (0.0, None)
    for model in models:
        last = load_points.last_pass([model])
        found = curve(model, model.at(last) if last else model.points[0], "pressure")
        if found is not None:
            first.line(*found, order=3 if "frictionless" in model.traits else 2, **styles.line(model))
    low, high = _span(models, chosen, curve, {"traction_bound": 1, "traction_x": -1})
    room = 0.05 * (high - low) or 1.0
    for key in chosen:
        panel = figure.add(230, 165, texts[key], labels[0], labels[2])
        panel.y.limits = low - room, high + room
        _draw_tractions(panel, models, key, curve, "traction_x")
    for panel in figure.panels:
        panel.x.limits = (-extent(models)[half], extent(models)[half])
    if chosen:
        figure.entry(thin, "soft", width=0.8)
    figure.entry(shared)
    return figure


def path(result, axis):
    """p_n, and p_x with the traction bound at several creepages, along the line "x" or "y". None if no model has a
    pressure field."""
    models = load_points.with_pressure(result)
    if not models:
        return None
    own, at = any("own_bound" in m.traits for m in models), line_place(models, axis)
    return _panels(result, "contact pressure", (_along(axis, at), "$p_n$ [MPa]", "$-p_x$ [MPa]"), "xy".index(axis),
                   line_of(axis, at), "traction bound" if own else "traction bound $\\mu p_n$")


def strip_forces(result):
    """Forces of the strips along rolling, over y: p_n, and -p_x at several creepages with the full sliding of the same
    strips."""
    return _panels(result, "normal force per strip", (ALONG["y"], "$\\int p_n dx$ [N/mm]", "$-\\int p_x dx$ [N/mm]"), 1,
                   strip_of, "full sliding of the strip")


LEAST_WORK = 1e-6  # N/mm; less is what the iteration leaves where nothing slips


def with_work(models):
    """The models with work of friction at some load point."""
    return [m for m in models if any(p.pass_work is not None and p.pass_work.max() > LEAST_WORK for p in m.points)]


WORK = "work per pass $w$ [N/mm]"


def pass_work(result):
    """Frictional work per pass and area over y at up to three load points. None without work."""
    models = with_work(result.models)
    chosen = load_points.chosen_keys(models, 3) if models else []
    if not chosen:
        return None
    texts, shared = load_points.key_texts(chosen)
    figure = Figure(3)
    for key in chosen:
        panel = figure.add(230, 165, texts[key], ALONG["y"], WORK)
        panel.y.limits = (0.0, None)
        for model in models:
            if (point := model.at(key)) and point.pass_work is not None:
                panel.line(model.y, point.pass_work, **styles.line(model))
    figure.entry(shared)
    return figure


# Below this fraction of the largest bound, p_y is noise on the scale of the figure.
LEAST_LATERAL = 0.02


def lateral_paths(result):
    """-p_y along lines as of `path`, along x above and along y below, at up to three creepages; thin lines: the bound, which
    leaves the frame where p_y is far below it. None without tangential tractions."""
    models = [m for m in load_points.friction_models(result) if "traction_y" in m.points[0].fields]
    chosen = load_points.chosen_keys(models, 4)
    chosen = chosen[1:] if len(chosen) > 3 else chosen  # the first of four is the least informative
    if not chosen:
        return None
    texts, shared = load_points.key_texts(chosen)
    figure = Figure(max(2, len(chosen)))
    for model in models:
        figure.model(model)
    figure.entry("traction bound, both signs", "soft", width=0.8)
    figure.entry(shared)
    at = {axis: line_place(models, axis) for axis in "xy"}
    lines = {axis: line_of(axis, at[axis]) for axis in "xy"}
    lows, highs = zip(*(_span(models, chosen, lines[axis], {"traction_y": -1}) for axis in "xy"))
    bound = max(_span(models, chosen, lines[axis], {"traction_bound": 1})[1] for axis in "xy")
    low, high = min(*lows, -LEAST_LATERAL * bound), max(*highs, LEAST_LATERAL * bound)
    for axis, half in zip("xy", extent(models)):
        for key in chosen:
            panel = figure.add(230, 165, texts[key], _along(axis, at[axis]), "$-p_y$ [MPa]")
            panel.x.limits = (-half, half)
            panel.y.limits = (low - 0.08 * (high - low), high + 0.08 * (high - low))
            _draw_tractions(panel, models, key, lines[axis], "traction_y", (1, -1))
    return figure
