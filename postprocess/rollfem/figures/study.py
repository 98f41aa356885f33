# SPDX-License-Identifier: LGPL-2.1-or-later
"""study.html: values and errors of one case on successively finer grids."""
from html import escape

import numpy as np

from . import report, styles, tables
from .figure import Figure
from .labels import math
from .page import case_file, hint, made_by, section, under

PATCH = ["max_pressure", "semi_axis_x", "semi_axis_y", "contact_length", "contact_width", "approach"]
SMALLEST = 1e-9  # relative; smaller errors cannot be drawn


def _is_coefficient(key):
    return key.startswith("traction_coefficient")


def _xi(place, key):
    return 100 * place["points"][int(key.split(":")[1]) - 1]["longitudinal_creepage"]


def _quantity(place, key):
    """The quantity of a key, which may name a load point."""
    return place["quantities"][key.split(":")[0]]


def _at_point(key):
    return f", load point {key.split(':')[1]}" if ":" in key else ""


def _title(place, key):
    if not _is_coefficient(key):
        quantity = _quantity(place, key)
        return quantity.title + (f" {math(quantity.symbol)}" if quantity.symbol else "") + _at_point(key)
    repeated = sum(_xi(place, f":{n}") == _xi(place, key) for n in range(1, len(place["points"]) + 1)) > 1
    return rf"traction coefficient, $\xi$ = {_xi(place, key):.4g} %" + (_at_point(key) if repeated else "")


def _keys(place):
    """Keys of the references: patch first, then along the creep curve."""
    patch = [name for name in PATCH if name in place["references"]]
    others = [k for k in place["references"] if ":" not in k and k not in PATCH]
    rest = [k for k in place["references"] if ":" in k]
    return patch + others + sorted(rest, key=lambda k: int(k.split(":")[1]))


def typical_coefficient(place, friction):
    """Key of the load point whose coefficient is nearest to 0.65 mu, with both adhesion and slip; None if there is
    none."""
    keys = [k for k in _keys(place) if _is_coefficient(k)]
    wanted = 0.65 * friction
    return min(keys, key=lambda k: abs(abs(place["references"][k]["value"]) - wanted), default=None)


def _curve(series, key, across):
    """Positions and errors in percent of the levels; exact values cannot be drawn."""
    return [(level[across], 100 * level["errors"][key]) for level in series["levels"]
            if level["errors"].get(key, 0) > SMALLEST and level[across] > 0]


# Looks of series of one model refined in different ways: dash, marker, hollow or not.
VARIANTS = [(None, None, False), ((1.5, 1.5), None, True), ((6, 1.5, 1.5, 1.5), "^", True), ((3, 3), "v", False)]


def _look(place, series):
    """The look of a series as keyword arguments of a curve, with its name."""
    same = [s["vary"] for s in place["series"] if s["model"] == series["model"]]
    look = styles.line(series["model"], True)
    dash, marker, hollow = VARIANTS[same.index(series["vary"]) % len(VARIANTS)]
    name = look["name"] + (f", {series['vary']}" if len(same) > 1 and series["vary"] else "")
    return {**look, "name": name, "dash": dash or look["dash"], "marker": marker or look["marker"], "hollow": hollow}


def _add_band(panel, place, drawn, key, friction):
    """Draws a band of errors below the uncertainty of the limit of the reference model, or the largest of others;
    returns whether there is one."""
    def relative(reference):
        scale = friction if _is_coefficient(key) else abs(reference["value"])
        return 100 * reference["uncertainty"] / scale if scale > 0 else 0.0

    of_reference = [series for series in drawn if series["model"] == place["reference"]]
    level = max(relative(series["references"][key]) for series in of_reference or drawn)
    low = panel.y.range()[0]
    if level > low:
        panel.band(low, level)
    return level > low


def values_figure(place):
    """The values of every quantity with their bars against the cell size, and at size 0 the limit of each model. A model
    without cells is a line across. None without levels."""
    figure = Figure(3 if len(_keys(place)) > 4 else 2)
    for key in _keys(place):
        panel = figure.add(250, 190, _title(place, key), "cell size over the coarsest [-], 0: limit",
                           f"[{_quantity(place, key).unit}]")
        panel.x.see([0.0, 1.0])
        for series in place["series"]:
            look, finer = _look(place, series), max(1.0, series["ratio"])
            rows = [(finer ** -k, level["values"][key], level.get("bars", {}).get(key) or 0.0)
                    for k, level in enumerate(series["levels"]) if key in level["values"]]
            if len(rows) == 1 and not series["ratio"]:
                alone = not any(other["ratio"] for other in place["series"])  # otherwise it may leave the frame
                panel.line([0.0, 1.0], [rows[0][1]] * 2, see=alone, **{**look, "marker": None})
                continue
            at, values, bars = (np.array(column) for column in zip(*rows)) if rows else ((), (), np.zeros(0))
            panel.line(at, values, **look)
            if bars.any():
                panel.bars(at, values, bars, look["colour"])
            if limit := series["limits"].get(key):
                panel.line([0.0], [limit["value"]], **{**look, "hollow": True, "size": 4.5, "name": ""})
                panel.bars(np.zeros(1), np.array([limit["value"]]), np.array([limit["uncertainty"]]), look["colour"])
    figure.entry("large, at 0: limit with its uncertainty")
    return figure if figure.panels else None


ORDER = {"colour": "soft", "width": 1.0, "dash": (1.5, 2.2)}


def errors_figure(place, across, wanted, friction):
    """Errors of the keys against "seconds" or "unknowns", log-log. None if there are none."""
    curves = {key: [(series, found) for series in place["series"] if (found := _curve(series, key, across))
                    or across == "seconds" and key in series.get("model_differences", {})] for key in wanted}
    curves = {key: found for key, found in curves.items() if found}
    if not curves:
        return None
    figure = Figure(3 if len(curves) > 4 else 2)
    extra = {}
    for key, found in curves.items():
        panel = figure.add(250, 190, _title(place, key),
                           "time for all load points [s]" if across == "seconds" else "unknowns [-]",
                           "error [% of $\\mu$]" if _is_coefficient(key) else "error [%]")
        panel.x.log = panel.y.log = True
        for series, spots in found:
            panel.spots(spots, True, **_look(place, series))
            difference = series.get("model_differences", {}).get(key, {"value": 0.0})["value"]
            if across == "seconds" and abs(difference) > SMALLEST and series["levels"][-1]["seconds"] > 0:
                panel.spots([(series["levels"][-1]["seconds"], 100 * abs(difference))],
                            **{**_look(place, series), "hollow": "open", "size": 5.5, **({"name": ""} if spots else {})})
                extra[f"large, open: model difference from {styles.label(place['reference'])}"] = {}
            if across == "unknowns" and series.get("measures_others") and len(spots) >= 3:
                # Slope of order 2 on a surface grid: the error falls as 1/unknowns.
                ends = np.array([spots[0][0], spots[-1][0]]) * 1.6
                panel.line(ends, 1.6 * spots[0][1] * ends[0] / ends, **ORDER)
                extra["order 2"] = ORDER
        if _add_band(panel, place, [series for series, _ in found], key, friction):
            extra["uncertainty of the limit"] = {"fill": "band"}
    for name in sorted(extra):
        figure.entry(name, **extra[name])
    return figure


def speed_error(place, friction):
    """Error in the largest pressure and in a traction coefficient against seconds, every model."""
    found = next((k for k in _keys(place) if ":" in k), None)  # for prescribed forces
    wanted = [k for k in ("max_pressure", typical_coefficient(place, friction) or found) if k]
    return errors_figure(place, "seconds", wanted, friction)


def _heading(place, key):
    if not _is_coefficient(key):
        return tables.heading(_quantity(place, key)) + _at_point(key)
    return f"−F<sub>x</sub>/F<sub>z</sub> at ξ = {tables.plain(_xi(place, key))} %"


def _value_cell(place, series, level, key):
    if key not in level["values"]:
        return "–"
    html = tables.measured(level["values"][key], level.get("bars", {}).get(key), 6)
    if key not in level["errors"]:
        return html
    # The finest value may itself be the reference, which has no error.
    if series["references"][key]["kind"] == "finest" and level is series["levels"][-1] and level["errors"].get(key) == 0:
        return under(html, "the reference")
    order = level.get("orders", {}).get(key)
    return under(html, f"{tables.number(100 * level['errors'][key], 2)} %{' of μ' * _is_coefficient(key)}"
                  + (f", order {tables.number(order, 3)}" if order is not None else ""))


def _limit_cell(limit):
    if limit is None:
        return "–"
    note = "converged to rounding" if limit.get("settled") else "no order"
    if "order" in limit:
        note = f"order {tables.number(limit['order'], 3)}{', fitted' if limit['fitted'] else ''}"
    return under(f"{tables.number(limit['value'], 6)} <span class=e>± {tables.number(limit['uncertainty'], 2)}</span>", note)


def _reference_cell(reference):
    return "–" if reference is None else under(
        tables.measured(reference["value"], reference["uncertainty"], 6), reference["kind"])


def _difference_cell(key, difference):
    return "–" if difference is None else (
        f"{tables.percent(100 * difference['value'])}{' of μ' * _is_coefficient(key)} "
        f"<span class=e>± {tables.number(100 * difference['uncertainty'], 2)}</span>")


def _series_table(place, series):
    keys = [k for k in _keys(place) if any(k in level["values"] for level in series["levels"])]
    rows = [[escape(level["label"]), tables.grouped(level["unknowns"]), tables.number(level["seconds"], 3)]
            + [_value_cell(place, series, level, k) for k in keys] for level in series["levels"]]
    if series["limits"]:
        rows.append(["limit", "", ""] + [_limit_cell(series["limits"].get(k)) for k in keys])
    finer = [[f"reference, finer level {escape(level['label'])}", tables.grouped(level["unknowns"]), tables.number(level["seconds"], 3)]
             for level in series.get("reference_level", [])]
    rows.append([*finer, ["reference", "", ""]][0] + [_reference_cell(series["references"].get(k)) for k in keys])
    if differences := series.get("model_differences"):
        rows.append([f"model difference from {escape(styles.label(place['reference']))}", "", ""]
                    + [_difference_cell(k, differences.get(k)) for k in keys])
    head = [escape(series["parameter"] or "level"), "unknowns", "seconds"] + [_heading(place, k) for k in keys]
    return tables.table(head, rows)


def _overview(study):
    """One row for each series of each place, for the largest pressure."""
    rows = []
    for place, series in ((place, series) for place in study["places"] for series in place["series"]):
        levels = [level for level in series["levels"] if "max_pressure" in level["values"]]
        name = styles.label(series["model"]) + (f", {series['vary']}" if series["vary"] else "")
        rows += [[escape(place["name"]), tables.plain(place.get("lateral_shift", 0)),
                  tables.plain(1e3 * place.get("yaw", 0)), escape(name), escape(levels[-1]["label"]),
                  _value_cell(place, series, levels[-1], "max_pressure"),
                  _limit_cell(series["limits"].get("max_pressure")),
                  tables.number(sum(level["seconds"] for level in series["levels"]), 3)]] if levels else []
    return section("Largest pressure of every patch", tables.table(
        ["patch", "shift [mm]", "yaw [mrad]", "model", "finest level", "p<sub>0</sub> there [MPa]",
         "p<sub>0</sub>, limit [MPa]", "seconds, all levels"], rows)) if len(study["places"]) > 1 else ""


HINTS = """±: the model's own estimate; for limits, the uncertainty from the levels.
The reference of a model is its own limit, unless a value is exact for it or given; where the levels show no limit, a finer level
that is solved for this alone. Errors in percent of the reference,
of traction coefficients in percent of μ. Model difference: between the limits of two models, which no grid removes. Orders: from the
errors of a level and the previous one if the reference is exact or given, otherwise from the last three values.
Limit: Richardson's value of the three finest levels with its uncertainty; if these show no order (not monotone, or
changes that do not decrease), the limit of a curve fitted to all levels, if four or more follow one;
otherwise the finest value with three times the largest change.
An order well above 2 is partly coincidence. Seconds: elapsed time, including all load points and error
estimates."""


# With more patches than this the details of each are collapsed.
MOST_OPEN = 3


def captioned(made):
    """The figures of all places."""
    study = made.with_numbers
    friction = study["friction_coefficient"]
    for place in study["places"]:
        suffix = f"_{place['key']}" if place["key"] else ""
        yield (f"values{suffix}.svg", "Values with error bars as the cells shrink, and the limit of each model. Limits that "
               "lie apart are a difference between models.", lambda place=place: values_figure(place))
        if len(study["places"]) <= MOST_OPEN or len(place["series"]) > 1:
            yield (f"speed_error{suffix}.svg", "Error against seconds, each model against its own limit or exact value; open markers: by how much "
                   "the limits of the models differ.",
                   lambda place=place: speed_error(place, friction))
        yield (f"error_unknowns{suffix}.svg", "Error against unknowns, each model against its own limit or exact value.",
               lambda place=place: errors_figure(place, "unknowns", _keys(place), friction))


def _place_part(study, place, drawn):
    """Figures and tables of a place."""
    suffix = f"_{place['key']}.svg" if place["key"] else ".svg"
    parts = [drawn(f"values{suffix}", f"speed_error{suffix}", f"error_unknowns{suffix}")]
    heading = "h3" if place["name"] else "h2"
    for series in place["series"]:
        parts.append(f"<{heading}>{escape(styles.label(series['model']))}{', refined in ' if series['vary'] else ''}"
                     f"{escape(series['vary'])}</{heading}>")
        for text, kind, said in ((series["failure"], "bad", "Levels without a result"),
                                 (series["left_out"], "hint", "Too coarse and left out"),
                                 (series.get("no_reference"), "hint", "No finer level as a reference")):
            parts.append(f"<p class={kind}>{said}: {escape(text)}</p>" if text else "")
        parts.append(_series_table(place, series) if series["levels"] else "")
    title, body = escape(place["name"]), "".join(parts)
    if len(study["places"]) <= MOST_OPEN:
        return section(title, body) if title else body
    return f"<details><summary>{title}</summary>{body}</details>"


def page(made, drawn):
    """The page of the study."""
    study = made.with_numbers
    return "Refinement study: " + escape(study["title"] or study["case_file"]), made_by(study["program"], study), [
        report.verdict(study["verdict"]), case_file(study["case_file"], study["case_text"]),
        *(hint(f"{escape(note)}.") for note in study["notes"]), _overview(study),
        *(_place_part(study, place, drawn) for place in study["places"]), hint(HINTS)], (
        "Also in this folder: study.csv with every number, study.json, figures/.")
