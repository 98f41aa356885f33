"""compare.html: several models on one or several cases, laid beside each other."""
import os
from html import escape
from types import SimpleNamespace

import numpy as np
from matplotlib import pyplot as plt

from . import report, style, tables
from .build import build
from .reader import ResultError, read_json

def _model(name):
    """What style asks a model for."""
    return SimpleNamespace(name=name)


def _models(cases):
    return list(dict.fromkeys(m for case in cases for m in case["seconds"]))


# With more places than this a case has one column for the worst of them.
MOST_PLACES = 4


def _places(case):
    """Names of the places of a case; [""] for one without profiles, [None] for all of many together."""
    found = list(dict.fromkeys(s.get("patch", "") for s in case["standings"])) or [""]
    return found if len(found) <= MOST_PLACES else [None]


def _standing(case, model, quantity, place=None):
    """How a model stands in a quantity at a place; of all places together (None) the worst, with the
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


def _size(value):
    return tables.number(abs(value), 2)


def _difference_cell(standing):
    """The largest difference with what the error bars allow there, bold where any is beyond them."""
    if standing is None:
        return "–"
    value = tables.percent(100 * standing["largest_difference"])
    beyond = standing["differ"] > 0
    note = f"bars ±{_size(100 * standing['allowed_there'])}"
    if beyond and standing["compared"] > 1:
        note += f"<br>at {standing['differ']} of {standing['compared']}"
    return (f"<b>{value}</b>" if beyond else value) + f"<br><span class=d>{note}</span>"


def _heading(quantity):
    """Title, symbol and what differences are a percentage of."""
    of = quantity["relative_to"]
    of = "of the reference" if of == "value" else f"of {tables.symbol(of)}"
    title = " ".join(filter(None, (escape(quantity["title"]), tables.symbol(quantity["symbol"]))))
    return f"{title}<br><span class=d>% {of}</span>"


def _difference_table(columns, quantity, heading):
    """Largest difference of every model in every column; empty when nothing was compared."""
    models = [m for m in _models([c for c, _, _ in columns])
              if any(_standing(c, m, quantity) for c, _, _ in columns)]
    if not models:
        return ""
    rows = [[escape(style.label(_model(model)))]
            + [_difference_cell(_standing(case, model, quantity, place)) for case, place, _ in columns]
            for model in models]
    head = [heading] + [text for _, _, text in columns]
    return tables.table(head, rows)


def _differences(cases, headings):
    """The tables of differences; of one case at one place one table with a column for each quantity."""
    columns = _columns(cases)
    if len(columns) != 1:
        found = "".join(_difference_table(columns, *row) for row in headings.items())
        return f"<div class=side>{found}</div>" if found else ""
    case, place, _ = columns[0]
    models = [m for m in _models(cases) if any(s["model"] == m for s in case["standings"])]
    shown = [q for q in headings if any(_standing(case, m, q, place) for m in models)]
    if not shown:
        return ""
    rows = [[escape(style.label(_model(m)))] + [_difference_cell(_standing(case, m, q, place))
                                                for q in shown] for m in models]
    return tables.table(["largest difference"] + [headings[q] for q in shown], rows)


def _cost_table(cases):
    models = _models(cases)
    rows = [[escape(style.label(_model(m)))]
            + [tables.number(c["seconds"][m], 3) if m in c["seconds"] else "–" for c in cases]
            + [f"<b>{tables.number(sum(c['seconds'].get(m, 0.0) for c in cases), 3)}</b>"]
            for m in models]
    head = ["seconds"] + [escape(c["name"]) for c in cases] + ["all"]
    return tables.table(head, rows)


def cost_figure(cases):
    """Largest difference to the reference against seconds, one marker for each model and case. None
    when nothing was compared."""
    panels = [(q, h, of) for q, h, of in (("max_pressure", "largest pressure $p_0$", "reference"),
                                          ("traction_coefficient", "traction coefficient", r"$\mu$"))
              if any(_standing(c, m, q) for c in cases for m in _models(cases))]
    if not panels:
        return None
    figure, axes = plt.subplots(1, len(panels), figsize=(1.2 + 3.9 * len(panels), 3.7), squeeze=False)
    shown = {}
    for axis, (quantity, heading, of) in zip(axes.flat, panels):
        for model in _models(cases):
            spots = [(c["seconds"][model], 100 * abs(s["largest_difference"]))
                     for c in cases if (s := _standing(c, model, quantity))]
            if spots:
                at, high = np.array(spots).T
                shown[model] = axis.plot(at, np.maximum(high, 1e-4), linestyle="none",
                                         marker=style.marker(_model(model)), markersize=6,
                                         color=style.colour(_model(model)), alpha=0.85)[0]
        bars = [100 * s["allowed_there"] for c in cases for s in c["standings"]
                if s["quantity"] == quantity and s["allowed_there"] > 0]
        if bars:
            axis.axhline(np.median(bars), color=style.GREY, linewidth=0.9, linestyle=(0, (1, 1.5)))
            axis.annotate("error bars, median", (0.5, np.median(bars)), ha="center", va="bottom",
                          xycoords=("axes fraction", "data"), color=style.GREY, fontsize=8)
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.margins(0.12)
        low, high = axis.get_ylim()  # whole decades, so that every axis has labels
        axis.set_ylim(10 ** np.floor(np.log10(low)), 10 ** np.ceil(np.log10(high)))
        axis.set_title(heading)
        axis.set_xlabel("seconds of the model on the case")
        axis.set_ylabel(f"largest difference [% of {of}]")
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    figure.legend(shown.values(), [style.label(_model(m)) for m in shown], loc="upper center",
                  ncol=len(shown))
    return figure


def _missing(case):
    return "".join(
        f"<p class={'bad' if m['failed'] else 'say'}><b>{escape(m['model'])}</b> "
        f"{'failed' if m['failed'] else 'is left out'}: {escape(m['reason'])}</p>"
        for m in case["missing"])


def _case_section(comparison, case, directory, png_folder):
    heading = f"<h2 id=\"{escape(case['name'])}\">{escape(case['title'] or case['name'])}</h2>"
    if not case["complete"]:
        return heading + _missing(case)
    folder = os.path.join(directory, case["name"])
    png = os.path.join(png_folder, case["name"]) if png_folder else None
    result, figures = build(folder, png, comparison["reference"] or "halfspace")
    inner = report.touching(result, figures) + report.patches(result, figures, every=True)
    inner += "<h2>Cost</h2>" + tables.cost_table(result) + report.notes(result)
    inner = inner.replace("<h3>", "<h4>").replace("</h3>", "</h4>")
    inner = inner.replace("<h2>", "<h3>").replace("</h2>", "</h3>")
    return "".join([heading, report.asked(result), _missing(case), inner,
                    f"<p class=screen><a href=\"{escape(case['name'])}/report.html\">"
                    "its own report with every number</a></p>"])


def _elasticity(cases):
    """What is not error where finite elements and half-space differ."""
    if not {"fem", "halfspace"} <= set(_models(cases)):
        return ""
    return (" Where FEM and half-space differ by more than the bars, not all of it is error: a half-space leaves out "
            "how a loaded wheel is strained along its circle, which gives a force even at ξ = 0, and that a curved "
            "patch is not flat (docs/verification.md).")


def _asked(comparison):
    names = ", ".join(escape(style.label(_model(m))) for m in comparison["models"])
    wished = comparison["reference"] or "halfspace"
    cases = "".join(f"<li><a href=\"#{escape(c['name'])}\">{escape(c['name'])}</a>: "
                    f"{escape(c['title'])}</li>" for c in comparison["cases"])
    return (f"<p>The models {names} on the same cases. Differences are to "
            f"{escape(style.label(_model(wished)))} where it has the number, else to the half-space or FEM. "
            "Error bars are each model's own estimate of its numerical error; a theory without one "
            "(Hertz) counts as having none, so that what it leaves out shows as a difference.</p>"
            f"<ul>{cases}</ul>")


def build_comparison(directory, png_folder=None):
    """Draws every case of the comparison in `directory` and writes compare.html."""
    comparison = read_json(directory, "compare.json")
    if comparison.get("kind") != "compare" or comparison.get("format") != 2:
        raise ResultError(f"{directory}/compare.json is not a comparison that this program reads")
    style.know(comparison.get("labels", {}))
    cases = [c for c in comparison["cases"] if c["complete"]]
    sections = [_case_section(comparison, c, directory, png_folder) for c in comparison["cases"]]
    folder = style.figures_folder(directory, png_folder)
    figure = cost_figure(cases)
    picture = ""
    if figure is not None:
        style.save(figure, os.path.join(folder, "difference_cost.svg"), png_folder)
        picture = report.image(directory, "difference_cost.svg",
                               "What a model differs from the reference by, and what it costs: one marker "
                               "for each case. Differences below 0.0001 % are drawn there.")
    found = _differences(cases, {name: _heading(quantity)
                                 for name, quantity in comparison["quantities"].items()})
    title = "Comparison of models on " + (
        escape(cases[0]["name"]) if len(cases) == 1 else f"{len(comparison['cases'])} cases")
    report.write_page(os.path.join(directory, "compare.html"), report.page(title, [
        report.heading(title, comparison["program"], comparison),
        report.verdict(comparison["verdict"]), _asked(comparison), picture, found,
        "<p class=hint>Largest difference over the load points of the case, with its sign. Bold: at least one "
        "load point is beyond the error bars of both models together, at how many stands below; “bars”: "
        f"what they allow at that point.{_elasticity(cases)}</p>" if found else "",
        "<h2>Cost</h2>", _cost_table(cases), *sections,
        "<h2>Signs</h2><p>", report.CONVENTIONS, "</p><p class=hint>Beside this file: compare.csv and "
        "compare.json with every number, and a result folder for each case.</p>"]))
