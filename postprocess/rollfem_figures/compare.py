"""compare.html: several models on one or several cases, side by side."""
import os
from html import escape

import numpy as np

from . import looks, page, report, tables
from .build import build as build_run, draw_all
from .figure import Figure, folder_of
from .reader import read_json


def _models(cases):
    return list(dict.fromkeys(m for case in cases for m in case["seconds"]))


# With more places than this a case has one column for the worst of them.
MOST_PLACES = 4


def _places(case):
    """Names of the places of a case; [""] for one without profiles, [None] for all of many together."""
    found = list(dict.fromkeys(s.get("patch", "") for s in case["standings"])) or [""]
    return found if len(found) <= MOST_PLACES else [None]


def _standing(case, model, quantity, place=None):
    """The standing of a model in a quantity at a place; for all places together (None) the worst, with the
    counts of all."""
    found = [s for s in case["standings"] if s["model"] == model and s["quantity"] == quantity
             and place in (None, s.get("patch", ""))]
    if not found:
        return None
    worst = max(found, key=lambda s: abs(s["largest_difference"]))
    return {**worst, "differ": sum(s["differ"] for s in found),
            "compared": sum(s["compared"] for s in found)}


def _columns(cases):
    """(case, place, heading) of the columns of the tables of differences."""
    columns = []
    for case in cases:
        names = _places(case)
        for place in names:
            note = ""
            if place is None:
                note = "worst place"
            elif len(names) > 1:
                note = escape(place).replace(", ", ",<br>")
            columns.append((case, place, escape(case["name"])
                            + (f"<br><span class=d>{note}</span>" if note else "")))
    return columns


def _difference_cell(standing):
    """The largest difference with what the error bars allow there, bold where any is beyond them."""
    if standing is None:
        return "–"
    value = tables.percent(100 * standing["largest_difference"])
    beyond = standing["differ"] > 0
    note = f"bars ±{tables.number(100 * abs(standing['allowed_there']), 2)}"
    if beyond and standing["compared"] > 1:
        note += f"<br>at {standing['differ']} of {standing['compared']}"
    return (f"<b>{value}</b>" if beyond else value) + f"<br><span class=d>{note}</span>"


def _heading(quantity):
    """Title, symbol and what differences are a percentage of."""
    of = quantity["relative_to"]
    of = "of the reference" if of == "value" else f"of {tables.symbol(of)}"
    title = " ".join(filter(None, (escape(quantity["title"]), tables.symbol(quantity["symbol"]))))
    return f"{title}<br><span class=d>% {of}</span>"


def _difference_table(heading, columns):
    """Largest difference of every model in columns of case, place, quantity and heading; empty when nothing was
    compared."""
    models = [m for m in _models([case for case, *_ in columns])
              if any(_standing(case, m, quantity, place) for case, place, quantity, _ in columns)]
    if not models:
        return ""
    rows = [[escape(looks.label(m))] + [_difference_cell(_standing(case, m, quantity, place))
                                        for case, place, quantity, _ in columns] for m in models]
    return tables.table([heading] + [text for *_, text in columns], rows)


def _differences(cases, headings):
    """The tables of differences; of one case at one place one table with a column for each quantity."""
    columns = _columns(cases)
    if len(columns) == 1:
        case, place, _ = columns[0]
        return _difference_table("largest difference", [
            (case, place, q, heading) for q, heading in headings.items()
            if any(_standing(case, m, q, place) for m in _models(cases))])
    found = "".join(_difference_table(heading, [(case, place, q, text) for case, place, text in columns])
                    for q, heading in headings.items())
    return f"<div class=side>{found}</div>" if found else ""


def _cost_table(cases):
    models = _models(cases)
    rows = [[escape(looks.label(m))]
            + [tables.number(c["seconds"][m], 3) if m in c["seconds"] else "–" for c in cases]
            + [tables.number(sum(c['seconds'].get(m, 0.0) for c in cases), 3)]
            for m in models]
    head = ["seconds"] + [escape(c["name"]) for c in cases] + ["all"]
    return tables.table(head, rows)


def cost_figure(cases):
    """Largest difference from the reference against seconds, one marker for each model and case. None
    when nothing was compared."""
    figure, shown, said = Figure(2), {}, []
    for quantity, title, of in (("max_pressure", "largest pressure $p_0$", "reference"),
                                ("traction_coefficient", "traction coefficient", "$\\mu$")):
        if not any(_standing(c, m, quantity) for c in cases for m in _models(cases)):
            continue
        panel = figure.add(320, 240, title, "seconds of the model on the case", f"largest difference [% of {of}]")
        panel.x.log = panel.y.log = True
        for model in _models(cases):
            spots = [(c["seconds"][model], max(100 * abs(s["largest_difference"]), 1e-4))
                     for c in cases if (s := _standing(c, model, quantity))]
            if spots:
                colour, _, marker = shown[model] = looks.of_model(model)
                panel.line(*zip(*spots), colour, marker=marker, size=3.8, joined=False)
                said.append(f"{looks.label(model)} {title}: up to {max(s[1] for s in spots):.2g} %")
        bars = [100 * s["allowed_there"] for c in cases for s in c["standings"]
                if s["quantity"] == quantity and s["allowed_there"] > 0]
        if bars:
            panel.y.see([np.median(bars)])
            panel.level(np.median(bars))
    if not figure.panels:
        return None
    for model, (colour, _, marker) in shown.items():
        figure.entry(looks.label(model), colour, width=0, marker=marker)
    figure.entry("error bars, median", "soft", (1.5, 2.2), 1.0)
    figure.seen = f"Largest difference from the reference against seconds. {'; '.join(said)}."
    return figure


def _missing(case):
    return "".join(
        f"<p class={'bad' if m['failed'] else 'say'}>{escape(m['model'])} "
        f"{'failed' if m['failed'] else 'is left out'}: {escape(m['reason'])}</p>"
        for m in case["missing"])


def _case_section(comparison, case, directory):
    heading = f"<h2 id=\"{escape(case['name'])}\">{escape(case['title'] or case['name'])}</h2>"
    if not case["complete"]:
        return heading + _missing(case)
    folder = os.path.join(directory, case["name"])
    result, figures = build_run(folder, comparison["reference"] or "halfspace")
    inner = report.touching(result, figures) + report.patches(result, figures, f"of-{case['name']}-")
    inner += "<h2>Cost</h2>" + tables.cost_table(result) + report.notes(result)
    return "".join([heading, report.asked(result), _missing(case), report.lower(inner),
                    f"<p class=screen><a href=\"{escape(case['name'])}/report.html\">"
                    "its own report with every number</a></p>"])


def _elasticity(cases):
    """Explains differences between finite elements and half-space that are not errors."""
    if not {"fem", "halfspace"} <= set(_models(cases)):
        return ""
    return (" Differences between FEM and half-space beyond the bars are not numerical errors alone: a half-space "
            "neglects the strain of a loaded wheel along its circle, which causes a force even at ξ = 0, and the "
            "curvature of the patch (docs/verification.md).")


def _reference_words(comparison):
    """The model that differences refer to, and its substitute where that one has no value."""
    wished = comparison["reference"] or "halfspace"
    ways = list(dict.fromkeys([wished, *(m for m in ("halfspace", "fem") if m in comparison["models"])]))
    first, *others = [escape(looks.label(name)) for name in ways]
    return f"Differences are from {first}" + (f" or, where it has no value, from {' or '.join(others)}. " if others else ". ")


def _asked(comparison):
    names = ", ".join(escape(looks.label(m)) for m in comparison["models"])
    cases = "".join(f"<li><a href=\"#{escape(c['name'])}\">{escape(c['name'])}</a>: "
                    f"{escape(c['title'])}</li>" for c in comparison["cases"])
    return (f"<p>Models: {names}. {_reference_words(comparison)}"
            "Error bars are each model's own estimate of its numerical error; an exact closed form "
            "(Hertz) has none, so that what it neglects shows as a difference.</p>"
            f"<ul>{cases}</ul>")


def build(directory):
    """Draws every case of the comparison in `directory` and writes compare.html."""
    comparison = read_json(directory, "compare")
    looks.know(comparison.get("labels", {}))
    cases = [c for c in comparison["cases"] if c["complete"]]
    sections = [_case_section(comparison, c, directory) for c in comparison["cases"]]
    drawn = draw_all([("difference_cost.svg", "Difference of each model from the reference against its cost, one marker "
                       "per case. Differences below 0.0001 % are drawn at that value.",
                       lambda: cost_figure(cases))], folder_of(directory))
    found = _differences(cases, {name: _heading(quantity)
                                 for name, quantity in comparison["quantities"].items()})
    title = "Comparison of models on " + (
        escape(cases[0]["name"]) if len(cases) == 1 else f"{len(comparison['cases'])} cases")
    page.write_page(
        os.path.join(directory, "compare.html"), title, page.made_by(comparison["program"], comparison), [
            report.verdict(comparison["verdict"]), _asked(comparison), "<h2>Differences</h2>" * bool(found),
            *map(page.figure, drawn), found,
            "<p class=hint>Largest difference over the load points of the case, with its sign. Bold: at least one "
            "load point exceeds the error bars of both models together; their number is given below. “bars”: "
            f"what they allow at that point.{_elasticity(cases)}</p>" if found else "",
            "<h2>Cost</h2>", _cost_table(cases), *sections,
            "<h2>Signs</h2><p>", report.CONVENTIONS, "</p>"],
        "Also in this folder: compare.csv and compare.json with every number, and a result folder for each case.")
