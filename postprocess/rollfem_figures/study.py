"""study.html: errors of one case on ever finer grids, against unknowns and seconds."""
import json
import os
from html import escape
from types import SimpleNamespace

import numpy as np
from matplotlib import pyplot as plt

from . import report, style, tables
from .reader import ResultError

PATCH = [("max_pressure", "largest pressure $p_0$", "p<sub>0</sub> [MPa]"),
         ("semi_axis_x", "semi-axis along x", "semi-axis along x [mm]"),
         ("semi_axis_y", "semi-axis along y", "semi-axis along y [mm]"),
         ("approach", "approach", "approach [mm]")]
SMALLEST = 1e-9  # relative; below it an error is nothing that a figure can show


def _model(series):
    return SimpleNamespace(name=series["model"])


def _is_coefficient(key):
    return key.startswith("traction_coefficient")


def _xi(study, key):
    return 100 * study["points"][int(key.split(":")[1]) - 1]["longitudinal_creepage"]


def _title(study, key):
    for name, title, _ in PATCH:
        if name == key:
            return title
    return rf"traction coefficient, $\xi$ = {_xi(study, key):.4g} %"


def _keys(study):
    """Those of the references: patch first, then along the creep curve."""
    patch = [name for name, _, _ in PATCH if name in study["references"]]
    rest = [k for k in study["references"] if _is_coefficient(k)]
    return patch + sorted(rest, key=lambda k: int(k.split(":")[1]))


def typical_coefficient(study):
    """Key of the load point whose coefficient is nearest to 0.65 mu, where adhesion and slip are both
    there; None without any."""
    keys = [k for k in _keys(study) if _is_coefficient(k)]
    wanted = 0.65 * study["friction_coefficient"]
    return min(keys, key=lambda k: abs(abs(study["references"][k]["value"]) - wanted), default=None)


def _curve(series, key, across):
    """Positions and errors in percent of the levels; what is exact cannot be drawn."""
    rows = [(level[across], 100 * level["errors"][key]) for level in series["levels"]
            if level["errors"].get(key, 0) > SMALLEST and level[across] > 0]
    return np.array(rows).T if rows else None


def _name(study, series):
    text = style.label(_model(series))
    same = [s for s in study["series"] if s["model"] == series["model"]]
    return f"{text}, {series['vary']}" if len(same) > 1 and series["vary"] else text


def _uncertainty(axis, study, key):
    reference = study["references"][key]
    scale = study["friction_coefficient"] if _is_coefficient(key) else abs(reference["value"])
    if reference["uncertainty"] > 0 and scale > 0:
        level = 100 * reference["uncertainty"] / scale
        low, high = axis.get_ylim()
        if level > low:
            axis.axhspan(min(low, level / 10), min(level, high), color="#eeeeee", zorder=0)
            axis.annotate("uncertainty of the reference", (0.02, min(level, high)), ha="left", va="top",
                          xycoords=("axes fraction", "data"), color=style.GREY, fontsize=7.5)
            axis.set_ylim(low, high)


def _order_guide(axis, curve):
    """The slope of order 2 on a surface: error falls as 1/unknowns."""
    at, high = curve
    if len(at) < 3:
        return
    ends = np.array([at[0], at[-1]]) * 1.6
    axis.plot(ends, 1.6 * high[0] * (ends / ends[0]) ** -1, color=style.GREY, linewidth=0.8,
              linestyle=(0, (1, 1.5)))
    axis.annotate("order 2", (ends[0], 1.6 * high[0]), color=style.GREY, fontsize=8, ha="left",
                  va="bottom")


def _panel(axis, study, key, across, guide):
    drawn = {}
    for number, series in enumerate(study["series"]):
        curve = _curve(series, key, across)
        if curve is None:
            continue
        ink = style.line(_model(series))
        same = [s for s in study["series"][:number] if s["model"] == series["model"]]
        if same:
            ink["linestyle"] = (0, (1, 1))
        drawn[_name(study, series)] = axis.plot(
            *curve, marker=style.marker(_model(series)), markersize=5.5,
            markerfacecolor="white" if same else ink["color"], **ink)[0]
        if guide and series["model"] == "halfspace":
            _order_guide(axis, curve)
    axis.set_xscale("log")
    axis.set_yscale("log")
    low, high = axis.get_ylim()  # whole decades, so that every axis has labels
    axis.set_ylim(10 ** np.floor(np.log10(low)), 10 ** np.ceil(np.log10(high)))
    axis.set_title(_title(study, key))
    axis.set_ylabel(r"error [% of $\mu$]" if _is_coefficient(key) else "error [%]")
    axis.set_xlabel("seconds, all load points" if across == "seconds" else "unknowns")
    _uncertainty(axis, study, key)
    return drawn


def errors_figure(study, across, keys):
    """Errors of the keys against "seconds" or "unknowns", log-log. None when there are none."""
    keys = [k for k in keys if any(_curve(s, k, across) is not None for s in study["series"])]
    if not keys:
        return None
    columns = min(2, len(keys))
    rows = -(-len(keys) // columns)
    figure, axes = plt.subplots(rows, columns, squeeze=False,
                                figsize=(1.0 + 3.9 * columns, 0.9 + 3.1 * rows))
    drawn = {}
    for axis, key in zip(axes.flat, keys):
        drawn.update(_panel(axis, study, key, across, across == "unknowns"))
    for axis in axes.flat[len(keys):]:
        axis.set_visible(False)
    across_legend = max(2, int(figure.get_figwidth() / 1.7))
    legend_rows = -(-len(drawn) // across_legend)
    figure.tight_layout(rect=(0, 0, 1, 1 - (0.1 + 0.22 * legend_rows) / figure.get_figheight()))
    figure.legend(drawn.values(), drawn, loc="upper center", ncol=-(-len(drawn) // legend_rows))
    return figure


def speed_error(study):
    """Error in the largest pressure and in a traction coefficient against seconds, every model."""
    keys = [k for k in ("max_pressure", typical_coefficient(study)) if k]
    return errors_figure(study, "seconds", keys)


def _heading(study, key):
    for name, _, heading in PATCH:
        if name == key:
            return heading
    return f"−F<sub>x</sub>/F<sub>z</sub> at ξ = {tables.plain(_xi(study, key))} %"


def _series_table(study, series):
    keys = [k for k in _keys(study) if any(k in level["values"] for level in series["levels"])]
    rows = []
    for level in series["levels"]:
        row = [escape(level["label"]), f"{level['unknowns']:,}".replace(",", " "),
               tables.number(level["seconds"], 3)]
        for key in keys:
            if key not in level["values"]:
                row.append("–")
                continue
            html = f"<b>{tables.number(level['values'][key], 6)}</b>"
            if key in level["errors"]:
                html += f"<br><span class=d>{tables.number(100 * level['errors'][key], 2)} %"
                order = level.get("orders", {}).get(key)
                html += (f", order {tables.number(order, 3)}" if order is not None else "") + "</span>"
            row.append(html)
        rows.append(row)
    limits = series["limits"]
    if limits:
        row = ["limit", "", ""]
        for key in keys:
            limit = limits.get(key)
            if limit is None:
                row.append("–")
            elif "order" in limit:
                row.append(f"<b>{tables.number(limit['value'], 6)}</b> <span class=e>± "
                           f"{tables.number(limit['uncertainty'], 2)}</span><br><span class=d>order "
                           f"{tables.number(limit['order'], 3)}</span>")
            else:
                row.append(f"{tables.number(limit['value'], 6)} <span class=e>± "
                           f"{tables.number(limit['uncertainty'], 2)}</span><br><span class=d>no order"
                           "</span>")
        rows.append(row)
    row = ["reference", "", ""]
    for key in keys:
        reference = study["references"].get(key)
        row.append(f"{tables.number(reference['value'], 6)}<br><span class=d>{reference['kind']}</span>"
                   if reference else "–")
    rows.append(row)
    head = [escape(series["parameter"] or "level"), "unknowns", "seconds"] + [_heading(study, k) for k in keys]
    return tables.table(head, rows)


HINTS = """Errors in percent of the reference, of traction coefficients in percent of μ. Orders: from the
errors of a level and the one before where the reference is exact or given, else from the last three values.
Limit: Richardson's value of the three finest levels with its uncertainty, or the finest value with three
times the largest change where the sequence shows no order (it is not monotone, or its changes do not fall).
An order well above 2 is partly chance. Seconds: what a user waits for, all load points and the error
estimates included."""


def build_study(directory, png_folder=None):
    """Draws the study in `directory` and writes study.html."""
    with open(os.path.join(directory, "study.json"), encoding="utf-8") as file:
        study = json.load(file)
    if study.get("kind") != "study" or study.get("format") != 1:
        raise ResultError(f"{directory}/study.json is not a study that this program reads")
    style.use()
    folder = os.path.join(directory, "figures")
    os.makedirs(folder, exist_ok=True)
    if png_folder:
        os.makedirs(png_folder, exist_ok=True)
    images = ""
    for name, caption, figure in (
            ("speed_error.svg", "Error against seconds. Where a line stays flat the theory ends, not the "
             "grid; what has no error (Hertz where it is the reference) is not drawn.", speed_error(study)),
            ("error_unknowns.svg", "Error against unknowns, every quantity of the study.",
             errors_figure(study, "unknowns", _keys(study)))):
        if figure is not None:
            style.save(figure, os.path.join(folder, name), png_folder)
            images += report.image(directory, name, caption)
    made = study["program"]
    title = "Refinement study: " + escape(study["title"] or study["case_file"])
    meta = f"rollfem {made['version']} ({made['commit']}), {study['started']}, {study['host']}"
    words = "".join(f"<li>{escape(sentence)}</li>" for sentence in study["words"])
    parts = [f"<h1>{title}</h1><p class=meta>{escape(meta)}<br><code>{escape(study['command'])}</code></p>",
             f"<details><summary>case file {escape(study['case_file'])}</summary>"
             f"<pre>{escape(study['case_text'])}</pre></details>", images]
    for series in study["series"]:
        name = escape(style.label(_model(series)))
        parts.append(f"<h2>{name}{', refined in ' if series['vary'] else ''}{escape(series['vary'])}</h2>")
        if series["failure"]:
            parts.append(f"<p class=bad>Ended early: {escape(series['failure'])}</p>")
        parts.append(_series_table(study, series))
    parts += [f"<p class=hint>{HINTS}</p>", f"<h2>In words</h2><ul>{words}</ul>",
              "<p class=hint>Beside this file: study.json and study.csv with every number, figures/.</p>"]
    report.write_page(os.path.join(directory, "study.html"), report.page(title, parts))
