# SPDX-License-Identifier: LGPL-2.1-or-later
"""The top of a report: what was asked, what an engineer decides by in one table, and what to distrust."""
import math
from html import escape
from types import SimpleNamespace

import numpy as np

from ..result import count, place_label
from ..shakedown import Ellipse
from . import labels, load_points, positions, styles, tables, yielding
from .page import hint, section, under

# Description of bodies and load, by a key specific to such a case; the last one is the fallback.
SHAPES = (("given_pressure.max_pressure", "Hertz's pressure of {given_pressure.max_pressure} MPa given on an ellipse of "
           "semi-axes {given_pressure.semi_axis_x} by {given_pressure.semi_axis_y} mm"),
          ("undeformed_distance.quadratic", "Undeformed distance A x² + B y² with A = {undeformed_distance.quadratic[0]}, "
           "B = {undeformed_distance.quadratic[1]} 1/mm"),
          ("undeformed_distance.file", "Undeformed distance from {undeformed_distance.file}"),
          ("wheel.profile", "Wheel profile {wheel.profile}, nominal radius {wheel.rolling_radius} mm, on rail profile "
           "{rail.profile}"),
          ("wheel.transverse_radius", "Wheel of rolling radius {wheel.rolling_radius} mm (transverse "
           "{wheel.transverse_radius}) on a rail of transverse radius {rail.transverse_radius}"))
LOADS = (("given_pressure.max_pressure", ""), ("load.vertical_force", "; {load.vertical_force} N vertically on each wheel"),
         ("load.normal_force", "; F<sub>z</sub> = {load.normal_force} N"), ("load.approach", "; approach {load.approach} mm"),
         ("load.max_pressure", "; largest pressure {load.max_pressure} MPa by Hertz"),
         ("wheel.profile", "; the height of the wheel is given, its load is a result"))
PROBLEMS = {"shift": "Load points are steps of a shift without rolling. ", "transient": "Load points are steps of rolling. "}


def _words(keys):
    """The keys of a case in words, as sections with members."""
    sections = {}
    for path, value in keys.items():
        section_, _, name = path.rpartition(".")
        text = "flat" if name == "transverse_radius" and math.isinf(value) else (
            [tables.plain(number) for number in value] if isinstance(value, np.ndarray) else
            tables.plain(value) if isinstance(value, (int, float)) else escape(str(value)))
        if name == "transverse_radius" and text != "flat":
            text += " mm"
        setattr(sections.setdefault(section_, SimpleNamespace()), name, text)
    return sections


def _solved(result):
    """The models, load points and positions in words."""
    names = list(dict.fromkeys(styles.label(m) for m in result.models))
    said = f"Solved by {escape(', '.join(names))}" if names else "No model was run"
    most = max(result.models, key=len, default=())
    if len(most) > 1:
        given = " (passes)" if most[0].by_number == "pass" else "" if most[0].by_number else (
            " (" + ", ".join(f"{symbol} = {tables.span([factor * key[k] for key in load_points.all_keys(result.models)], None)} {unit}"
                             for k, (_, _, symbol, factor, unit, _) in enumerate(load_points.PARTS)
                             if k in load_points.varying([p.creepages for p in most])) + ")")
        said += f", {count(most, 'load point')}{given}"
    if len(numbers := positions.positions(result)) > 1:
        over = positions.along(result)
        said += f", {count(numbers, 'position')}: {over.what} {tables.span(over.at.values(), None)} {over.unit}"
    return said + "."


def asked(result):
    """The problem, from the case."""
    case = result.inputs
    if "wheel.profile" in case or "rail.profile" in case:
        case = {"wheel.profile": "of a circle", "rail.profile": "of a circle", **case}
    words = _words(case)
    said = "".join(next(text for name, text in rows if name in case).format_map(words) for rows in (SHAPES, LOADS))
    if math.isfinite(case["rail.rolling_radius"]):
        kind = "roller" if case["rail.rolling_radius"] > 0 else "ring around the wheel"
        said += f"; the rail is a {kind} of radius {words['rail'].rolling_radius} mm"
    law = "without friction" if case["rolling.problem"] == "frictionless" else (
        f"friction coefficient {tables.plain(result.friction_coefficient)}") + tables.law_words(result)
    what = PROBLEMS.get(case["rolling.problem"], "")
    if case["rolling.problem"] == "shift" and not result.friction_coefficient:
        what = "Load points are steps of the load, without rolling. "
    if result.prescribed_forces:
        what += "Tangential forces are prescribed; creepages are results. "
    return f"<p>{said}{';' if 'given_pressure.max_pressure' in case else ','} {law}. {what}{_solved(result)}</p>"


# More contacts than this are shown by the smallest and the largest value of each wheel.
MOST_CONTACTS = 4


def _pressure(point):
    return point["max_pressure"]


def _used(point):
    """T/F_n, the part of the normal force that friction carries."""
    return point.tangential_coefficient


def _scalar(name, factor=1.0):
    return lambda point: None if (value := point.scalars.get(name)) is None else factor * value


# Rows: heading, quantity with the bar or "", value of a load point, factor of the bar, digits, and how the contacts of one
# wheel make one number: the largest, or their sum.
ROWS = (("largest pressure p<sub>0</sub> [MPa]", "max_pressure", _pressure, 1.0, 5, max),
        ("patch: length along rolling [mm]", "contact_length", _scalar("contact_length"), 1.0, 4, max),
        ("width across [mm]", "contact_width", _scalar("contact_width"), 1.0, 4, max),
        ("contact area [mm²]", "contact_area", _scalar("contact_area"), 1.0, 4, sum),
        ("normal force F<sub>n</sub> [kN]", "normal_force", _scalar("normal_force", 1e-3), 1e-3, 5, sum),
        ("force along rolling F<sub>x</sub> [kN]", "longitudinal_force", _scalar("longitudinal_force", 1e-3), 1e-3, 4, sum),
        ("lateral force F<sub>y</sub> in the contact plane [kN]", "lateral_force", _scalar("lateral_force", 1e-3), 1e-3, 4, sum),
        ("lateral force Y on the track [kN]", "lateral_force_track", _scalar("lateral_force_track", 1e-3), 1e-3, 4, sum),
        ("friction used T/F<sub>n</sub>", "tangential_coefficient", _used, 1.0, 4, max),
        ("wear number Tγ [N]", "frictional_work", _scalar("frictional_work"), 1.0, 4, sum),
        ("largest temperature [°C]", "max_temperature", _scalar("max_temperature"), 1.0, 4, max),
        ("residual compression along [MPa]", "residual_stress", _scalar("residual_stress"), 1.0, 3, max),
        ("plastic strain of the pass [%]", "plastic_increment", _scalar("plastic_increment", 100.0), 100.0, 2, max),
        ("of it lasting [%]", "net_plastic_increment", _scalar("net_plastic_increment", 100.0), 100.0, 2, max),
        ("depth of the groove [µm]", "groove_depth", _scalar("groove_depth", 1e3), 1e3, 3, max))
SMALL = 1e-4  # of the largest normal force: smaller lateral forces are not worth a row


def _points(model):
    """The load points that a row of the table is about: after passes the last one, otherwise all that are solved."""
    of_pass = model.headline is not None and model.headline.by_number == "pass"
    return [model.headline] if of_pass else [p for p in model.points if p.scalars.get("max_pressure") is not None]


def _bar(point, name):
    """The error bar of a quantity, of T/F_n from those of both forces."""
    if name != "tangential_coefficient":
        return point.bar(name)
    bars = [point.bar(force) for force in ("longitudinal_force", "lateral_force")]
    return None if None in bars or not point["normal_force"] else math.hypot(*bars) / point["normal_force"]


def _cell(model, row):
    """A quantity of one contact: value and bar, or the span of several load points."""
    _, name, value, factor, digits, _ = row
    points = [(found, p) for p in _points(model) if (found := value(p)) is not None]
    if not points:
        return "–"
    values, bars = [found for found, _ in points], [factor * (_bar(p, name) or 0.0) for _, p in points]
    if max(values) - min(values) > max(1e-6 * max(map(abs, values)), *bars):
        return tables.span(values, digits)
    number = value(model.headline)
    bar = _bar(model.headline, name)
    word = model.headline.no_bar.get(name, "") if name != "normal_force" else ""
    html = tables.measured(values[0] if number is None else number, word if bar is None else factor * bar, digits)
    return html.replace("&nbsp;<span", " <span")  # the bar may go below


def _shakedown(model):
    """Whether it shakes down and how sure, of steel that yields; otherwise the yield stress that shakedown needs."""
    if yielded := model.points[-1].yielded:
        return "; ".join(f"{body}: {yielding.told(after)}" for body, after in yielded.items())
    points = [p for p in _points(model) if p["semi_axis_x"] > 0]
    if not points:
        return "–"
    point = max(points, key=_used)
    limit = Ellipse(point["semi_axis_y"] / point["semi_axis_x"]).limit(_used(point))
    return tables.number(math.sqrt(3) * point["max_pressure"] / limit, 3)


def _shakedown_row(models):
    return ("shakedown", "verdict of the last pass with its evidence") if any(m.points[-1].yielded for m in models) else (
        "yield strength for shakedown [MPa]", "weaker steel without hardening yields at every pass (shakedown map)")


def _useful(models, row):
    """Whether the row says something."""
    values = [abs(v) for m in models for p in _points(m) if (v := row[2](p)) is not None]
    if not values or max(values) == 0:
        return False
    if row[1] in ("lateral_force", "longitudinal_force", "lateral_force_track"):
        return max(values) > SMALL * max(1e-3 * p["normal_force"] for m in models for p in _points(m))
    return True


def _contacts(models, heads):
    """A column for each contact."""
    rows = [[row[0], *(_cell(m, row) for m in models)] for row in ROWS if _useful(models, row)]
    if models[0].place:
        rows.insert(0, ["contact on the rail at y [mm], angle [°]", *(
            f"{tables.number(m.place['y_rail'], 4)}, {tables.number(math.degrees(m.place['contact_angle']), 3)}" for m in models)])
    name, said = _shakedown_row(models)
    rows.append([under(name, said), *map(_shakedown, models)])
    return tables.table(["", *heads], rows, "answer", name="what the result is")


def _spans(result, models):
    """Of every wheel the smallest and the largest value over the positions, and where they are."""
    over, heads, columns = positions.along(result), [], []
    useful = [row for row in ROWS if _useful(models, row)]
    for wheel in ("left", "right"):
        own = [m for m in models if m.place["wheel"] == wheel]
        if not own:
            continue
        heads += [f"{wheel} wheel: smallest", "largest"]
        for pick in (min, max):
            cells = []
            for _, _, value, _, digits, together in useful:
                at = {}
                for m in own:
                    found = [v for p in _points(m) if (v := value(p)) is not None]
                    at.setdefault(over.at[m.place["position"]], []).append(max(found, key=abs, default=0.0))
                number, where = pick(((together(each), where) for where, each in at.items()), key=lambda each: each[0])
                cells.append(under(tables.number(number, digits), f"at {tables.plain(where)} {over.unit}"))
            columns.append(cells)
    rows = [[row[0], *cells] for row, *cells in zip(useful, *columns)]
    worst = max(models, key=lambda m: max((p["max_pressure"] for p in _points(m)), default=0.0))
    name, said = _shakedown_row([worst])
    where = f"where p<sub>0</sub> is largest, {tables.plain(over.at[worst.place['position']])} {over.unit}; {said}"
    rows.append([under(name, where), *[""] * (len(heads) - 1), _shakedown(worst)])
    return tables.table(["", *heads], rows + positions.dip_rows(result, len(heads)), "answer", name="what the result is")


def _failed(result):
    """The load points that did not converge, in a box."""
    lines = [f"{styles.label(m)} at {labels.plain(load_points.key_texts([p.key])[0][p.key]) or f'load point {p.number + 1}'}"
             + f" ({place_label(m.place)})" * bool(m.place) for m in result.models for p in m.points if not p["converged"]]
    more = f" and {len(lines) - 6} more" if len(lines) > 6 else ""
    return f"<p class=bad>Not converged: {escape('; '.join(lines[:6]))}{more}. Do not use these numbers.</p>" if lines else ""


def _uncertain(result, models):
    """How large error bars and model errors are."""
    lines = []
    for words, name, scale, of in (("p<sub>0</sub>", "max_pressure", lambda p: p["max_pressure"], "%"), (
            "traction coefficient", "traction_coefficient", lambda p: result.friction_coefficient, "% of μ")):
        for kind, bar in (("error bars of grid and solver", lambda p, name=name: p.bar(name)),
                          ("model error", lambda p, name=name: p.model_error.get(name))):
            parts = [100 * b / scale(p) for m in models for p in _points(m) if (b := bar(p)) and scale(p)]
            if parts:
                lines.append(f"{words}: {kind} up to {tables.number(max(parts), 2)} {of}.")
    return lines


def _differences(result, models):
    """By how much other models differ in the largest pressure, in words."""
    said = []
    for name in dict.fromkeys(m.name for m in result.models):
        pairs = [(m.headline, base.headline) for m in result.models if m.name == name for base in models
                 if base is not m and base.place == m.place and m.headline and base.headline]
        parts = [100 * (p["max_pressure"] / base["max_pressure"] - 1) for p, base in pairs if base["max_pressure"]]
        if parts and name != models[0].name:
            largest = max(parts, key=abs)
            said.append(f"{escape(styles.label(name))}: p<sub>0</sub> {tables.percent(largest)} from the numbers above.")
    return said


def part(result, warned):
    """What was asked, what to distrust, and the answer; `warned`: HTML of verdict and warnings."""
    scenes = [scene for _, scene in result.scenes()]
    shown = [model for scene in scenes for model in [
        load_points.reference_for_forces(scene) or load_points.reference_for_patch(scene)] if model and model.headline]
    if not shown:
        return asked(result) + warned
    heads = [escape(place_label(m.place).replace(", position 1", "") if len(positions.positions(result)) < 2 else place_label(m.place))
             or escape(styles.label(m)) for m in shown]
    table = _contacts(shown, heads) if len(shown) <= MOST_CONTACTS else _spans(result, shown)
    about = f"By {escape(', '.join(dict.fromkeys(styles.label(m) for m in shown)))}"
    point = shown[0].headline
    if point.by_number == "pass":
        about += f", after the last pass of {len(shown[0])}: passes before it have other numbers"
    elif len(shown[0]) > 1:
        about += "; “a to b”: over the load points"
    lines = "".join(f"<li>{line}</li>" for line in [*_uncertain(result, shown), *_differences(result, shown)])
    return section("The answer", asked(result), _failed(result), warned, table,
                   hint(about + "; ±: error bar of grid and solver. Forces act on the wheel."),
                   f"<h3>How sure it is</h3><ul>{lines}</ul>" if lines else "")
