"""stress.html: what `rollfem stress` found, at all load points that were asked for."""
import os
from html import escape

from . import looks, words
from .build import draw_all
from .figure import folder_of
from .page import figure, write_page
from .stress_reader import read_stress
from .stress_report import figures, load_point
from .stresses import largest_cell, largest_table
from .tables import number, plain, table

REGIONS = {"elastic": "nothing yields", "elastic shakedown": "yields at first, then residual stresses keep "
           "every further pass elastic", "beyond shakedown": "plastic flow at every pass"}


def _heads(result):
    return [words.html(f"{looks.label(m)}, {load_point(m)}") for m in result.models]


def _largest(result):
    """The largest stresses of both bodies, a column for each model and load point."""
    def cell(column, body, measure):
        for found in result.models[column].data["maxima"]:
            if (found["body"], found["measure"]) == (body, measure):
                over = f", {number(found['over_max_pressure'], 3)} p<sub>0</sub>" if "over_max_pressure" in found else ""
                return largest_cell(found["value"], found.get("error_estimate", found.get("no_bar", "")),
                                    found["place"], over)
        return None

    return largest_table(_heads(result), cell)


def _contacts(result):
    columns = (("normal_force", 6), ("max_pressure", 5), ("max_traction", 4), ("tangential_coefficient", 4))
    rows = [[head, *(number(m.data[name], digits) for name, digits in columns)]
            for head, m in zip(_heads(result), result.models)]
    return table(["load point", "F<sub>z</sub> [N]", "p<sub>0</sub> [MPa]", "largest |p<sub>t</sub>| [MPa]",
                  "T/F<sub>z</sub>"], rows)


def _verdicts(result):
    """One verdict of shakedown for every load point of every model; nothing without a yield stress."""
    if result.yield_shear_stress is None:
        return ""
    html = [f"<h2>Shakedown, k = {number(result.yield_shear_stress, 4)} MPa</h2>"]
    for model in {m.key: m for m in result.models}.values():
        chosen = {m.data["point"] for m in result.models if m.key == model.key}
        curve = model.data["shakedown"]
        for point in (p for p in curve if p["point"] in chosen):
            verdict = point["verdict"]
            html.append(f"<p class={'bad' if verdict.startswith('beyond') else 'say'}>{escape(looks.label(model))}, "
                        f"ξ = {plain(100 * point['longitudinal_creepage'])} %: {verdict}; {REGIONS[verdict]}.</p>")
        rows = [[plain(100 * p["longitudinal_creepage"]), number(p["tangential_coefficient"], 4),
                 number(p["load_factor"], 4), number(p["ellipse"]["shakedown"], 4),
                 number(p.get("yield_ratio"), 4), number(p["surface_fatigue_index"], 3), p["verdict"]] for p in curve]
        html.append(table([f"{escape(looks.label(model))}: ξ [%]", "T/F<sub>z</sub>", "p<sub>0</sub>/k",
                           "shakedown limit", "σ<sub>v</sub>/(√3 k)", "surface fatigue index", "verdict"], rows))
    ratio = result.models[0].data["shakedown"][0]["ellipse"]["ratio"]
    html.append(f"<p class=hint>The limit is that of an ellipse b/a = {number(ratio, 3)}, like the patch, in full slip: "
                "there the largest shear on planes parallel to the surface is k. First yield is judged by the largest "
                "von Mises stress σ<sub>v</sub> of this contact if known, otherwise by the lower of the elastic "
                "limits of line and circle.</p>")
    return "".join(html)


def build(path):
    """Draws what stands with stress.json to figures/ beside it and writes stress.html."""
    directory = os.path.dirname(os.path.abspath(path))
    result = read_stress(directory)
    looks.know({model.name: model.label for model in result.models})
    drawn = draw_all(figures(result), folder_of(directory))
    title = "Stress below the surface: " + escape(result.title)
    maps = [f for f in drawn if f.name.startswith("shakedown")]
    below = "".join(map(figure, (f for f in drawn if f not in maps)))
    write_page(os.path.join(directory, "stress.html"), title, f"from <code>{escape(result.source)}</code>", [
        "<h2>Load points</h2>", _contacts(result), "<h2>Largest stresses</h2>", _largest(result),
        "<p class=hint>±: the model's own error estimate, or why there is none. Places x (along rolling), y, z (into "
        "the wheel). Tension is positive.</p>",
        _verdicts(result), *map(figure, maps), "<h2>Lines and planes</h2>" + below if below else ""],
        "Also in this folder: stress.csv with every place, stress.json, figures/.")
