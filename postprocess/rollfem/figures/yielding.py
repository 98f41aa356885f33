# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies that yield, pass after pass: plastic strain of the passes, residual stress, the section behind the load, groove and
forward flow, the passes in the shakedown map, and their table. Of bodies that are pressed the same, step after step: the
section lies below the middle of the contact, the groove is an imprint."""
import math
from html import escape

import numpy as np

from ..shakedown import Ellipse, boundaries, yield_shear_stress
from . import load_points, stresses, styles
from .figure import Figure
from .maps import colour_scale, filled
from .page import hint
from .tables import barred, heading, number, table

DEPTH = "depth below the surface [mm]"
ACROSS = "$y$ [mm], lateral"
# Looks of up to four passes, the last one first.
PASSES = (("red", ()), ("blue", (7.5, 2.3)), ("green", (3, 1.5)), ("amber", (1.5, 1.5)))
MOST_MARKED = 30  # of more passes, lines without markers


def told(after):
    """The verdict with its evidence, unless both meshes agree."""
    evidence = after.get("evidence", "both meshes")
    return after["verdict"] + (f" ({evidence})" if evidence != "both meshes" else "")


def bodies(result):
    """[(model, body)] of what yields."""
    found = [(model, body) for model in result.models for body in ("wheel", "rail")
             if any(body in point.yielded for point in model.points)]
    return [(m, b) for m, b in found if m is found[0][0]]


def one(result):
    """"pass", or "step" of bodies that are pressed, not rolled over."""
    return "step" if result.inputs.get("rolling.problem") == "shift" else "pass"


def _stress_before(result, body):
    """Depth (mm), residual stress along and across (MPa) before the first pass; None without."""
    depth, along, across = (result.inputs.get(f"{body}_plasticity.residual_{name}") for name in ("depth", "along", "across"))
    if depth is None:
        return None
    return np.broadcast_arrays(depth, *(0.0 if stress is None else stress for stress in (along, across)))


def _passes(model, body):
    """[(number, load point, body after it)]."""
    return [(point.number + 1, point, point.yielded[body]) for point in model.points if body in point.yielded]


def _shown(model, body, of="pass"):
    """[(look with a name, load point, body)] of a few passes: the first, the last, and in between."""
    passes = _passes(model, body)
    count = len(passes)
    wanted = sorted({0, min(count - 1, 1), round(math.sqrt(count - 1)), count - 1})
    return [({"colour": colour, "dash": dash, "name": f"{of} {n}"}, point, after)
            for (colour, dash), (n, point, after) in zip(PASSES, [passes[k] for k in wanted][::-1])][::-1]


def _band(model, point, after):
    """The column of the section below the middle of the running band, where the pressure has its centre."""
    pressure = point.fields.get("pressure")
    middle = 0.0 if pressure is None or not pressure.any() else float(
        (pressure.sum(axis=1) * model.y).sum() / pressure.sum())
    return int(np.abs(after["y"][0] - middle).argmin())


def _lines(result):
    """(member of the body, words, look) of the lines of passes()."""
    blue, red = ({"colour": "blue", "width": 3.2, "marker": "o", "size": 5.5}, {"colour": "red", "marker": "s", "size": 2.8})
    if one(result) == "step":
        return ("plastic_strain", "in all steps so far", blue), ("increment", "in the step", red)
    return ("increment", "in the pass, back and forth", blue), ("net_increment", "of it lasting after the pass", red)


def passes(result):
    """Plastic strain of every pass and its lasting part; of every step and of all so far. None if nothing yields."""
    figure = Figure(2)
    for model, body in bodies(result):
        rows = _passes(model, body)
        last = rows[-1][2]
        since = f" since {one(result)} {last['from_pass']}" if 1 < last["from_pass"] < rows[-1][0] else ""
        panel = figure.add(400, 250, f"{body}: {told(last)}{since}", one(result), "largest plastic strain [-]")
        panel.y.log = one(result) == "pass"
        at = [n for n, *_ in rows]
        panel.x.limits = (0.5, at[-1] + 0.5)
        if len(at) < 12:
            panel.x.ticks = [(n, str(n)) for n in at]
        for name, words, look in _lines(result):
            values = np.array([after[name] for *_, after in rows])
            panel.line(at, np.where(values > 0, values, np.nan) if panel.y.log else values, name=words,
                       **(look if len(at) <= MOST_MARKED else {**look, "marker": None}))
        if (yields := result.inputs.get(f"{body}_plasticity.yield_stress")) is not None:
            strain = yields / result.inputs[f"{body}.young_modulus"]
            panel.y.see([strain])
            panel.level(strain)
            panel.text(0.99, strain, f"yield strain {strain:.2g}", "end", shift=(0, -4), share=(True, False))
    return figure if figure.panels else None


def residual_stress(result, model, body):
    """Residual stress over depth below the middle of the running band after a few passes."""
    figure = Figure(2)
    shown, before = _shown(model, body, one(result)), _stress_before(result, body)
    for component, words in ((0, "along"), (1, "across")):
        panel = figure.add(300, 290, f"residual stress {words}", "stress [MPa], tension positive", DEPTH)
        panel.y.flipped, panel.y.margin = True, 0.0
        panel.y.see([0.0])
        panel.level(0, dash=(), upright=True)
        for look, point, after in shown:
            column = _band(model, point, after)
            panel.line(after["stress"][:, column, component], after["depth"][:, column], **look)
        if before is not None:
            depth = shown[-1][2]["depth"][:, 0]
            panel.line(np.interp(depth, before[0], before[1 + component]), depth, "soft", 1.2, (1, 2),
                       name=f"before the first {one(result)}")
    figure.entry(f"in the {body}")
    return figure


def _mirrored(after):
    """y, depth, accumulated strain, plastic shear strain 2 xz and residual stress along of the whole section [down,
    across], where half of it is stored."""
    parts = [after["y"], after["depth"], after["accumulated"], 2 * after["strain"][..., 5], after["stress"][..., 0]]
    if after["y"].min() <= 0:
        return parts
    return [np.concatenate([sign * part[:, ::-1], part], axis=1) for sign, part in zip((-1, 1, 1, 1, 1), parts)]


def section(result, model, body):
    """Maps of accumulated plastic strain, plastic shear strain (of a pass) and residual stress over the section behind the
    load after the last pass."""
    number_, _, after = _passes(model, body)[-1]
    y, depth, *fields = _mirrored(after)
    rolls = one(result) == "pass"
    figure = Figure(6, f"{body} after {one(result)} {number_}, seen along {'rolling' if rolls else 'x'}", in_rows=True)
    wide, high, said = np.ptp(y), depth.max(), []
    for name, unit, values in zip(("accumulated plastic strain", "plastic shear strain along rolling", "residual stress along"),
                                  ("%", "%", "MPa"), fields):
        if not rolls and "shear" in name:
            continue  # pressed evenly to both sides
        values = values * (100 if unit == "%" else 1)
        panel = figure.add(min(270.0, 300.0 * wide / high), 0, f"{name} [{unit}]", ACROSS, "depth [mm]", equal=True)
        panel.x.limits, panel.y.limits, panel.y.flipped = (y.min(), y.max()), (0.0, high), True
        levels, step = filled(panel, y, depth, values)
        panel.fit()
        colour_scale(figure, levels, step, panel.height)
        said.append(f"{name} {values.min():.3g} to {values.max():.3g} {unit}")
    return figure.tell(f"Section of the {body} after {one(result)} {number_}: ", said)


def groove(result, model, body):
    """Plastic displacement of the surface over y after a few passes, into the body and along rolling."""
    figure = Figure(2)
    kinds = {"groove": "groove: plastic displacement of the surface", "forward_flow": "forward flow: the same along rolling"}
    if one(result) == "step":
        kinds = {"groove": "imprint: plastic displacement of the surface"}
    for name, title in kinds.items():
        panel = figure.add(330, 200, title, ACROSS, "[µm]")
        panel.level(0, dash=())
        for look, _, after in _shown(model, body, one(result)):
            y, values = after["surface_y"], 1000 * after[name]
            if y.min() > 0:
                y, values = np.concatenate([-y[::-1], y]), np.concatenate([values[::-1], values])
            panel.line(y, values, **look)
        panel.y.see([0.0])
    figure.entry(f"on the {body}; minus: into it")
    return figure


def shakedown_map(result):
    """The passes in the shakedown map. None if nothing yields, or nothing rolls."""
    found = one(result) == "pass" and [(model, body, k) for model, body in bodies(result)
             if (k := yield_shear_stress(result.inputs.get(f"{body}_plasticity.yield_stress", 0.0)))]
    if not found:
        return None
    point = found[0][0].points[-1]
    figure = Figure(1)
    ratio = point["semi_axis_y"] / point["semi_axis_x"] if point["semi_axis_x"] else 1.0
    curves = [(body, [(p.number + 1, p.tangential_coefficient, p["max_pressure"] / k) for p in model.points])
              for model, body, k in found]
    title = "yield stress in shear " + ", ".join(f"$k$ = {k:.4g} MPa ({body})" for _, body, k in found)
    panel = stresses.shakedown_panel(figure, title, boundaries(Ellipse(ratio)), [p[2] for _, curve in curves for p in curve])
    for (body, curve), (colour, marker) in zip(curves, (("red", "s"), ("violet", "o"))):
        panel.spots([p[1:] for p in curve], True, colour=colour, width=1, marker=marker, hollow=True, order=4,
                    name=f"passes over the {body} (filled: the last)")
        panel.spots([curve[-1][1:]], colour=colour, marker=marker, order=5)
    return figure.tell("Shakedown map with the passes, ", [panel.seen()])


def captions(result):
    """(file name, caption, function that draws it) of the figures of bodies that yield."""
    rolls = one(result) == "pass"
    yield ("yielded_passes.svg", ("Plastic strain of every pass, where it is largest: all of it, back and forth, and the part that "
           "lasts after the pass. Elastic shakedown: both vanish; plastic shakedown: hardly anything lasts; ratchetting: the same "
           "part lasts after every pass. " if rolls else "Plastic strain after every step, where it is largest, and what the step "
           "has added to it. ") + "Dotted: the yield strain, for comparison.", lambda: passes(result))
    yield ("yielded_shakedown_map.svg", "The passes in the shakedown map, which holds for steel that does not harden: hardening "
           "raises its limits. The pressure falls while the bodies conform.", lambda: shakedown_map(result))
    below, behind, done = ("middle of the running band", "behind the load", "groove with its lips, and displacement along "
                           "rolling") if rolls else ("middle of the contact", "through the middle of the contact", "the imprint "
                           "that stays without load, with its lips")
    for model, body in bodies(result):
        yield (f"yielded_stress_{body}.svg", f"Residual stress in the {body}, over depth below the {below}.",
               lambda model=model, body=body: residual_stress(result, model, body))
        yield (f"yielded_section_{body}.svg", f"Section of the {body} {behind} after the last {one(result)}." +
               (" Shear strain: twice the tensor's xz; its sign is that of the flow along rolling." if rolls else ""),
               lambda model=model, body=body: section(result, model, body))
        yield (f"yielded_groove_{body}.svg", f"What plastic flow has done to the surface of the {body}: {done}.",
               lambda model=model, body=body: groove(result, model, body))


COLUMNS = ("normal_force", "max_pressure", "plastic_increment", "net_plastic_increment", "plastic_strain", "residual_stress",
           "groove_depth", "forward_flow", "plastic_work")


def passes_table(result):
    """What every pass does, and the verdict on every body; empty if nothing yields."""
    found = bodies(result)
    if not found:
        return ""
    model, rolls = found[0][0], one(result) == "pass"
    columns = [name for name in COLUMNS[rolls:] if any(name in p.scalars for p in model.points)]
    rows = [[number(p.number + 1), *(barred(p, name, 3) for name in columns),
             "<br>".join(f"{body}: {told(after)}" for body, after in p.yielded.items())]
            for p in map(model.at, load_points.shown_keys([model]))]
    last = model.points[-1].yielded
    said = "".join(f"<p class=say>{escape(styles.label(model))}, {body}: {escape(after.get('finding', after['verdict']))}.</p>"
                   for body, after in last.items())
    said_of = [heading(result.quantities[name]) for name in columns]
    if not rolls:
        said_of = [words.replace("pass", "step").replace("groove", "imprint") for words in said_of]
    return said + table([one(result), *said_of, "verdict"], rows, frame="many") + hint(
        "Largest values of both bodies; residual stress, groove and flow: of the section behind the load." if rolls else
        "Largest values of both bodies; residual stress and imprint: what plastic strain alone leaves, in the section through the "
        "middle of the contact. Once the load is 0, this is the state of the body.")
