# SPDX-License-Identifier: LGPL-2.1-or-later
"""compare.html: several models on one or several cases, side by side."""
import os
from html import escape

import numpy as np

from ..reader import read_result
from ..result import registered
from . import answer, report, styles, tables
from .figure import Figure
from .page import draw, hint, made_by, section, under


def _models(cases):
    return list(dict.fromkeys(m for case in cases for m in case["seconds"]))


# With more places than this a case gets one column for the worst of them.
MOST_PLACES = 4


def _standing(case, model, quantity, place=None):
    """The standing of a model in a quantity at a place; for all places together (None) the worst one, with the total
    counts."""
    found = [s for s in case["standings"] if s["model"] == model and s["quantity"] == quantity
             and place in (None, s.get("patch", ""))]
    if not found:
        return None
    worst = max(found, key=lambda s: abs(s["largest_difference"]))
    return {**worst, **{name: sum(s[name] for s in found) for name in ("differ", "compared")}}


def _columns(cases):
    """(case, place, heading) of the columns of the tables of differences; place "" in a case without profiles, None for
    all of many together."""
    for case in cases:
        places = list(dict.fromkeys(s.get("patch", "") for s in case["standings"])) or [""]
        notes = [escape(place).replace(", ", ",<br>") if len(places) > 1 else "" for place in places]
        if len(places) > MOST_PLACES:
            places, notes = [None], ["worst place"]
        for place, note in zip(places, notes):
            yield case, place, under(escape(case["name"]), note) if note else escape(case["name"])


def _difference_cell(standing):
    """The largest difference with the error bars there, bold if any difference exceeds them."""
    if standing is None:
        return "–"
    value = tables.percent(100 * standing["largest_difference"])
    beyond = standing["differ"] > 0
    note = f"bars ±{tables.number(100 * abs(standing['allowed_there']), 2)}"
    if beyond and standing["compared"] > 1:
        note += f"<br>at {standing['differ']} of {standing['compared']}"
    return under(f"<b>{value}</b>" if beyond else value, note)


def _heading(quantity):
    """Title, symbol and reference of percentage differences."""
    of = quantity["relative_to"]
    of = "of the reference" if of == "value" else f"of {tables.symbol(of)}"
    title = " ".join(filter(None, (escape(quantity["title"]), tables.symbol(quantity["symbol"]))))
    return under(title, f"% {of}")


def _difference_table(heading, columns):
    """Largest difference of every model in columns of case, place, quantity and heading; empty if nothing was
    compared."""
    rows = []
    for model in _models([case for case, *_ in columns]):
        found = [_standing(case, model, quantity, place) for case, place, quantity, _ in columns]
        if any(found):
            rows.append([escape(styles.label(model)), *map(_difference_cell, found)])
    return tables.table([heading] + [text for *_, text in columns], rows) if rows else ""


def _differences(cases, quantities):
    """The tables of differences; for one case at one place a single table with a column for each quantity."""
    columns = list(_columns(cases))
    headings = {name: _heading(quantity) for name, quantity in quantities.items()}
    if len(columns) == 1:
        case, place, _ = columns[0]
        return _difference_table("largest difference", [
            (case, place, q, heading) for q, heading in headings.items()
            if any(_standing(case, m, q, place) for m in _models(cases))])
    found = "".join(_difference_table(heading, [(case, place, q, text) for case, place, text in columns])
                    for q, heading in headings.items())
    return f"<div class=side>{found}</div>" if found else ""


def _cost_table(cases):
    rows = [[escape(styles.label(model))]
            + [tables.number(c["seconds"].get(model), 3) for c in cases]
            + [tables.number(sum(c["seconds"].get(model, 0.0) for c in cases), 3)] for model in _models(cases)]
    return tables.table(["seconds", *(escape(c["name"]) for c in cases), "all"], rows)


def cost_figure(cases):
    """Largest difference from the reference against seconds, one marker for each model and case. None if nothing was
    compared."""
    figure = Figure(2)
    for quantity, title, of in (("max_pressure", "largest pressure $p_0$", "reference"),
                                ("traction_coefficient", "traction coefficient", "$\\mu$")):
        spots = {model: [(c["seconds"][model], max(100 * abs(s["largest_difference"]), 1e-4))
                         for c in cases if (s := _standing(c, model, quantity))] for model in _models(cases)}
        if not any(spots.values()):
            continue
        panel = figure.add(320, 240, title, "seconds of the model on the case", f"largest difference [% of {of}]")
        panel.x.log = panel.y.log = True
        for model, pairs in spots.items():
            panel.spots(pairs, size=3.8, **styles.line(model, True))
        bars = [100 * s["allowed_there"] for c in cases for s in c["standings"]
                if s["quantity"] == quantity and s["allowed_there"] > 0]
        if bars:
            panel.y.see([np.median(bars)])
            panel.level(np.median(bars))
    figure.entry("error bars, median", "soft", (1.5, 2.2), 1.0)
    return figure if figure.panels else None


def _missing(case):
    return "".join(
        f"<p class={'bad' if m['failed'] else 'say'}>{escape(m['model'])} "
        f"{'failed' if m['failed'] else 'is left out'}: {escape(m['reason'])}</p>"
        for m in case["missing"])


def _case_section(comparison, case):
    heading = f"<h2 id=\"{escape(case['name'])}\">{escape(case['title'] or case['name'])}</h2>"
    if not case["complete"]:
        return heading + _missing(case)
    result = read_result(os.path.join(comparison.folder, case["name"]))
    result.reference, result.default_reference = comparison.data["reference"], _measures(comparison)[0]
    figures = draw(result, result.folder)
    inner = (report.touching(result, figures) + report.patches(result, figures, f"of-{case['name']}-")
             + section("Cost", tables.cost_table(result)) + report.notes(result))
    return "".join([heading, report.warned(result), answer.asked(result), _missing(case), report.lower(inner),
                    f"<p class=screen><a href=\"{escape(case['name'])}/report.html\">"
                    "full report of this case</a></p>"])


def _measures(comparison):
    """The default references, in order of preference."""
    return comparison.data.get("measures") or [name for name, traits in registered().items() if "measures_others" in traits
                                               ] or comparison.data["models"]


def _elasticity(comparison, cases):
    """Explains differences between finite elements and half-space that are not errors."""
    if not set(_measures(comparison)) <= set(_models(cases)):
        return ""
    return (" Differences between FEM and half-space beyond the error bars are not only numerical errors: a half-space "
            "neglects the strain of a loaded wheel along its circumference, which causes a force even at ξ = 0, and the "
            "curvature of the patch (docs/verification.md).")


def _asked(comparison):
    """Models and cases, the reference model of the differences, and its substitute where it has no value."""
    measures = _measures(comparison)
    ways = dict.fromkeys([comparison.data["reference"] or measures[0],
                          *(m for m in measures if m in comparison.data["models"])])
    first, *others = [escape(styles.label(name)) for name in ways]
    names = ", ".join(escape(styles.label(m)) for m in comparison.data["models"])
    cases = "".join(f"<li><a href=\"#{escape(c['name'])}\">{escape(c['name'])}</a>: "
                    f"{escape(c['title'])}</li>" for c in comparison.data["cases"])
    return (f"<p>Models: {names}. Differences are from {first}"
            + (f" or, where it has no value, from {' or '.join(others)}. " if others else ". ")
            + "An exact closed form (Hertz) is the reference where the other one does not resolve its model error. "
            f"Error bars are each model's own estimate of its numerical error.</p><ul>{cases}</ul>")


def _complete(comparison):
    return [case for case in comparison.data["cases"] if case["complete"]]


def captioned(comparison):
    """The figures of all cases together."""
    return [("difference_cost.svg", "Difference of each model from the reference against its cost, one marker per case. "
             "Differences below 0.0001 % are drawn at that value.", lambda: cost_figure(_complete(comparison)))]


def page(comparison, drawn):
    """The page; it also draws the report of every case."""
    cases = _complete(comparison)
    sections = [_case_section(comparison, c) for c in comparison.data["cases"]]
    found = _differences(cases, comparison.data["quantities"])
    title = "Comparison of models on " + (
        escape(cases[0]["name"]) if len(cases) == 1 else f"{len(comparison.data['cases'])} cases")
    return title, made_by(comparison.data["program"], comparison.data), [
        report.verdict(comparison.data["verdict"]), _asked(comparison),
        section("Differences between models", drawn(""), found),
        hint("Largest difference over the load points of the case, with its sign. Bold: at least one "
             "load point exceeds the error bars of both models together; their number is given below. “bars”: "
             f"sum of both at that point.{_elasticity(comparison, cases)}") if found else "",
        section("Cost", _cost_table(cases)), *sections, report.CONVENTIONS], (
        "Also in this folder: compare.csv with every number, compare.json, and a result folder for each case.")
