"""study.html: errors of one case on ever finer grids, against unknowns and seconds."""
import os
from html import escape
from types import SimpleNamespace

import numpy as np
from matplotlib import pyplot as plt

from . import report, style, tables
from .reader import Quantity, ResultError, read_json

PATCH = ["max_pressure", "semi_axis_x", "semi_axis_y", "contact_length", "contact_width", "approach"]
SMALLEST = 1e-9  # relative; below it an error is nothing that a figure can show


def _model(series):
    return SimpleNamespace(name=series["model"])


def _is_coefficient(key):
    return key.startswith("traction_coefficient")


def _xi(place, key):
    return 100 * place["points"][int(key.split(":")[1]) - 1]["longitudinal_creepage"]


def _title(place, key):
    if quantity := place["quantities"].get(key):
        return quantity.title + (f" ${quantity.symbol}$" if quantity.symbol else "")
    return rf"traction coefficient, $\xi$ = {_xi(place, key):.4g} %"


def _keys(place):
    """Those of the references: patch first, then along the creep curve."""
    patch = [name for name in PATCH if name in place["references"]]
    rest = [k for k in place["references"] if _is_coefficient(k)]
    return patch + sorted(rest, key=lambda k: int(k.split(":")[1]))


def typical_coefficient(place, friction):
    """Key of the load point whose coefficient is nearest to 0.65 mu, where adhesion and slip are both
    there; None without any."""
    keys = [k for k in _keys(place) if _is_coefficient(k)]
    wanted = 0.65 * friction
    return min(keys, key=lambda k: abs(abs(place["references"][k]["value"]) - wanted), default=None)


def _curve(series, key, across):
    """Positions and errors in percent of the levels; what is exact cannot be drawn."""
    rows = [(level[across], 100 * level["errors"][key]) for level in series["levels"]
            if level["errors"].get(key, 0) > SMALLEST and level[across] > 0]
    return np.array(rows).T if rows else None


# Series of one model refined in different ways: dash, marker, whether it is filled.
VARIANTS = [(None, None, True), ((0, (1, 1)), None, False), ((0, (4, 1, 1, 1)), "^", False),
            ((0, (2, 2)), "v", True)]


def _variant(place, series):
    """Which of the series of its model it is."""
    return [s["vary"] for s in place["series"] if s["model"] == series["model"]].index(series["vary"])


def _name(place, series):
    text = style.label(_model(series))
    same = [s for s in place["series"] if s["model"] == series["model"]]
    return f"{text}, {series['vary']}" if len(same) > 1 and series["vary"] else text


def _uncertainty(axis, place, key, friction):
    """A band of errors that the reference cannot tell; its handle for the legend, by name."""
    reference = place["references"][key]
    scale = friction if _is_coefficient(key) else abs(reference["value"])
    if not reference["uncertainty"] > 0 or not scale > 0:
        return {}
    level = 100 * reference["uncertainty"] / scale
    low, high = axis.get_ylim()
    if level <= low:
        return {}
    band = axis.axhspan(min(low, level / 10), min(level, high), color="#e6e6e6", zorder=0)
    axis.set_ylim(low, high)
    return {"uncertainty of the reference": band}


def _order_guide(axis, curve):
    """The slope of order 2 on a surface: error falls as 1/unknowns."""
    at, high = curve
    if len(at) < 3:
        return {}
    ends = np.array([at[0], at[-1]]) * 1.6
    return {"order 2": axis.plot(ends, 1.6 * high[0] * (ends / ends[0]) ** -1, color=style.GREY,
                                 linewidth=0.8, linestyle=(0, (1, 1.5)))[0]}


def _panel(axis, place, key, across, friction):
    drawn, guides = {}, {}
    for series in place["series"]:
        curve = _curve(series, key, across)
        if curve is None:
            continue
        ink = style.line(_model(series))
        dash, marker, filled = VARIANTS[_variant(place, series) % len(VARIANTS)]
        ink["linestyle"] = dash or ink["linestyle"]
        drawn[_name(place, series)] = axis.plot(
            *curve, marker=marker or style.marker(_model(series)), markersize=5.5,
            markerfacecolor=ink["color"] if filled else "white", **ink)[0]
        if across == "unknowns" and series["model"] == "halfspace":
            guides |= _order_guide(axis, curve)
    axis.set_xscale("log")
    axis.set_yscale("log")
    for limits, change in ((axis.get_xlim, axis.set_xlim), (axis.get_ylim, axis.set_ylim)):
        low, high = limits()  # whole decades, so that every axis has labels
        change(10 ** np.floor(np.log10(low)), 10 ** np.ceil(np.log10(high)))
    axis.set_title(_title(place, key))
    axis.set_ylabel(r"error [% of $\mu$]" if _is_coefficient(key) else "error [%]")
    axis.set_xlabel("time for all load points [s]" if across == "seconds" else "unknowns [-]")
    return drawn, guides | _uncertainty(axis, place, key, friction)


def errors_figure(place, across, keys, friction):
    """Errors of the keys against "seconds" or "unknowns", log-log. None when there are none."""
    keys = [k for k in keys if any(_curve(s, k, across) is not None for s in place["series"])]
    if not keys:
        return None
    columns = min(3 if len(keys) > 4 else 2, len(keys))
    rows = -(-len(keys) // columns)
    figure, axes = plt.subplots(rows, columns, squeeze=False,
                                figsize=(1.0 + (3.9 if columns < 3 else 2.9) * columns, 0.9 + 2.7 * rows))
    drawn, guides = {}, {}
    for axis, key in zip(axes.flat, keys):
        lines, more = _panel(axis, place, key, across, friction)
        drawn |= lines
        guides |= more
    drawn |= guides
    for axis in axes.flat[len(keys):]:
        axis.set_visible(False)
    for name, handle in drawn.items():
        handle.set_label(name)
    style.legend_above(figure, axes, list(drawn.values()), max(2, int(figure.get_figwidth() / 2.2)),
                       between=(0.78, 0.8))
    return figure


def speed_error(place, friction):
    """Error in the largest pressure and in a traction coefficient against seconds, every model."""
    keys = [k for k in ("max_pressure", typical_coefficient(place, friction)) if k]
    return errors_figure(place, "seconds", keys, friction)


def _heading(place, key):
    if quantity := place["quantities"].get(key):
        return tables.heading(quantity)
    return f"−F<sub>x</sub>/F<sub>z</sub> at ξ = {tables.plain(_xi(place, key))} %"


def _is_reference(place, series, level, key):
    """The finest value that errors are measured against has none itself."""
    return (place["references"][key]["kind"] == "finest" and level is series["levels"][-1]
            and level["errors"].get(key) == 0)


def _value_cell(place, series, level, key):
    if key not in level["values"]:
        return "–"
    html = tables.measured(level["values"][key], level.get("bars", {}).get(key), 6)
    if key not in level["errors"]:
        return html
    if _is_reference(place, series, level, key):
        return html + "<br><span class=d>the reference</span>"
    html += f"<br><span class=d>{tables.number(100 * level['errors'][key], 2)} %{' of μ' * _is_coefficient(key)}"
    order = level.get("orders", {}).get(key)
    return html + (f", order {tables.number(order, 3)}" if order is not None else "") + "</span>"


def _limit_cell(limit):
    if limit is None:
        return "–"
    value = tables.number(limit["value"], 6)
    html = f"<b>{value}</b>" if "order" in limit else value
    html += f" <span class=e>± {tables.number(limit['uncertainty'], 2)}</span><br><span class=d>"
    if "order" not in limit:
        return html + ("settled to rounding" if limit.get("settled") else "no order") + "</span>"
    return html + f"order {tables.number(limit['order'], 3)}{', fitted' if limit['fitted'] else ''}</span>"


def _reference_cell(reference):
    if reference is None:
        return "–"
    return tables.measured(reference["value"], reference["uncertainty"], 6) + \
        f"<br><span class=d>{reference['kind']}</span>"


def _series_table(place, series):
    keys = [k for k in _keys(place) if any(k in level["values"] for level in series["levels"])]
    rows = [[escape(level["label"]), f"{level['unknowns']:,}".replace(",", " "),
             tables.number(level["seconds"], 3)] + [_value_cell(place, series, level, k) for k in keys]
            for level in series["levels"]]
    if series["limits"]:
        rows.append(["limit", "", ""] + [_limit_cell(series["limits"].get(k)) for k in keys])
    rows.append(["reference", "", ""] + [_reference_cell(place["references"].get(k)) for k in keys])
    head = [escape(series["parameter"] or "level"), "unknowns", "seconds"] + [_heading(place, k) for k in keys]
    return tables.table(head, rows)


def _overview(study):
    """One row for each series of each place: the largest pressure, which is the first thing asked for."""
    rows = []
    for place in study["places"]:
        for series in place["series"]:
            levels = [level for level in series["levels"] if "max_pressure" in level["values"]]
            if not levels:
                continue
            name = style.label(_model(series)) + (f", {series['vary']}" if series["vary"] else "")
            rows.append([escape(place["name"]), tables.plain(place.get("lateral_shift", 0)),
                         tables.plain(1e3 * place.get("yaw", 0)), escape(name), escape(levels[-1]["label"]),
                         _value_cell(place, series, levels[-1], "max_pressure"),
                         _limit_cell(series["limits"].get("max_pressure")),
                         tables.number(sum(level["seconds"] for level in series["levels"]), 3)])
    head = ["patch", "shift [mm]", "yaw [mrad]", "model", "finest level", "p<sub>0</sub> there [MPa]",
            "p<sub>0</sub>, limit [MPa]", "seconds, all levels"]
    return "<h2>Largest pressure of every patch</h2>" + tables.table(head, rows)


HINTS = """±: the model's own estimate; of limits, what the levels leave uncertain.
Errors in percent of the reference, of traction coefficients in percent of μ. Orders: from the
errors of a level and the one before where the reference is exact or given, else from the last three values.
Limit: Richardson's value of the three finest levels with its uncertainty; where these show no order (they are
not monotone, or their changes do not fall) that of a curve fitted to all levels, if four or more follow one;
else the finest value with three times the largest change.
An order well above 2 is partly chance. Seconds: what a user waits for, all load points and the error
estimates included."""


# With more patches than this the details of each are folded away.
MOST_OPEN = 3


def _figures(study, place, directory, folder, png_folder):
    """The figures of a place, written, as parts of the page."""
    friction = study["friction_coefficient"]
    suffix = f"_{place['key']}" if place["key"] else ""
    wanted = []
    if len(study["places"]) <= MOST_OPEN or len(place["series"]) > 1:
        wanted.append(("speed_error", "Error against seconds. Where a line stays flat the theory ends, not the "
                       "grid; what has no error (Hertz where it is the reference) is not drawn.",
                       speed_error(place, friction)))
    wanted.append(("error_unknowns", "Error against unknowns, every quantity of the study.",
                   errors_figure(place, "unknowns", _keys(place), friction)))
    images = ""
    for name, caption, figure in wanted:
        if figure is not None:
            style.save(figure, os.path.join(folder, f"{name}{suffix}.svg"), png_folder)
            images += report.image(directory, f"{name}{suffix}.svg", caption)
    return images


def _place_parts(study, place, images):
    """Figures and tables of a place."""
    heading = "h3" if place["name"] else "h2"
    parts = [images]
    for series in place["series"]:
        name = escape(style.label(_model(series)))
        parts.append(f"<{heading}>{name}{', refined in ' if series['vary'] else ''}{escape(series['vary'])}"
                     f"</{heading}>")
        if series["failure"]:
            parts.append(f"<p class=bad>Levels without a result: {escape(series['failure'])}</p>")
        if series["left_out"]:
            parts.append(f"<p class=hint>Too coarse and left out: {escape(series['left_out'])}</p>")
        if series["levels"]:
            parts.append(_series_table(place, series))
    if not place["name"]:
        return parts
    title = escape(place["name"])
    if len(study["places"]) <= MOST_OPEN:
        return [f"<h2>{title}</h2>"] + parts
    return [f"<details><summary>{title}</summary>"] + parts + ["</details>"]


def build_study(directory, png_folder=None):
    """Draws the study in `directory` and writes study.html."""
    study = read_json(directory, "study.json")
    if study.get("kind") != "study" or study.get("format") != 3:
        raise ResultError(f"{directory}/study.json is not a study that this program reads")
    folder = style.figures_folder(directory, png_folder)
    style.know(study.get("labels", {}))
    title = "Refinement study: " + escape(study["title"] or study["case_file"])
    parts = [report.heading(title, study["program"], study), report.verdict(study["verdict"]),
             f"<details><summary>case file {escape(study['case_file'])}</summary>"
             f"<pre>{escape(study['case_text'])}</pre></details>"]
    parts += [f"<p class=hint>{escape(note)}.</p>" for note in study["notes"]]
    if len(study["places"]) > 1:
        parts.append(_overview(study))
    quantities = {name: Quantity(**quantity) for name, quantity in study["quantities"].items()}
    for place in study["places"]:
        place["quantities"] = quantities
        parts += _place_parts(study, place, _figures(study, place, directory, folder, png_folder))
    parts += [f"<p class=hint>{HINTS}</p>",
              "<p class=hint>Beside this file: study.json and study.csv with every number, figures/.</p>"]
    report.write_page(os.path.join(directory, "study.html"), report.page(title, parts))
