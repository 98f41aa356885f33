"""report.html: one file with everything in it, for the screen, the phone and the printer."""
import base64
import os
import re
from html import escape

from . import places, selection, stresses, style, tables
from .reader import place_label

CSS = """
:root{color-scheme:light}
body{font:16px/1.5 system-ui,"Segoe UI",Roboto,"DejaVu Sans",sans-serif;color:#1a1a1a;background:#fff;
margin:0 auto;max-width:62rem;padding:1rem}
h1{font-size:1.6rem;line-height:1.2;margin:.6rem 0}h2{font-size:1.15rem;margin:2rem 0 .4rem;
border-bottom:2px solid #0072B2;padding-bottom:.15rem}
p,li{max-width:48rem}.meta,figcaption,.d,.e,.hint{color:#555;font-size:.85rem}
.wide{overflow-x:auto}.side{display:flex;flex-wrap:wrap;gap:0 2.5rem}.side .wide{max-width:100%}table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.92rem;
margin:.4rem 0}th,td{padding:.25rem .8rem;border-bottom:1px solid #ddd;text-align:right;
vertical-align:top;white-space:nowrap}thead th{border-bottom:2px solid #888;vertical-align:bottom}
tbody th{font-weight:normal;text-align:left}thead th:first-child{text-align:left}
table.left td:nth-child(3),table.left th:nth-child(3){text-align:left;white-space:normal;min-width:11rem}
td .e{white-space:nowrap}figure{margin:1.2rem 0;break-inside:avoid}
figure img{max-width:100%;height:auto;display:block}.scroll{overflow-x:auto}
pre{background:#f5f5f5;padding:.7rem;overflow-x:auto;font-size:.82rem;line-height:1.35}
summary{cursor:pointer;color:#0072B2}.say{border-left:4px solid #E69F00;padding:.1rem .8rem;margin:.8rem 0}
.bad{border-left:4px solid #D55E00;padding:.1rem .8rem}
@media(max-width:40rem){body{padding:.7rem}h1{font-size:1.3rem}th,td{padding:.2rem .45rem}
.scroll img{min-width:34rem}tbody th{white-space:normal;min-width:5.5rem}}code{overflow-wrap:anywhere}
@media print{body{max-width:none;padding:0;font-size:10pt}h2{break-after:avoid}.hint{break-before:avoid}table,tr{break-inside:avoid}
.wide{overflow:visible}table,td .d,td .e,th .d{font-size:7pt}th,td{padding:.12rem .28rem;
white-space:normal}tbody th{white-space:nowrap}summary,.screen{display:none}}
"""

CONVENTIONS = """x is the rolling direction, and material enters the patch at large x (on the right of
the figures); y is lateral; z points into the wheel. Tractions and forces are those acting on the wheel.
A positive longitudinal creepage ξ brakes the wheel and gives a negative F<sub>x</sub>; the traction
coefficient is −F<sub>x</sub>/F<sub>z</sub>, so that the creep curve rises with ξ, and the figures draw
−p<sub>x</sub> for the same reason. Slip is that of the wheel's surface relative to the rail."""


BARS = ("±: what grid and solver leave uncertain, as the model estimates it, in the unit of the value; the word in its "
        "place says why there is none (exact: a closed form; theory: one that is no exact solution). "
        "“model ±”: what the model leaves out whatever its grid; from what it was taken, the notes say.")


def image(directory, name, caption):
    """A figure of a folder with its caption, as part of the page."""
    with open(os.path.join(directory, "figures", name), "rb") as file:
        data = base64.b64encode(file.read()).decode("ascii")
    kind = "fits" if name == "creep_curve.svg" else "scroll"  # what a phone shows whole
    return (f'<figure><div class={kind}><img alt="{escape(caption)}" '
            f'src="data:image/svg+xml;base64,{data}"></div><figcaption>{escape(caption)}</figcaption>'
            "</figure>")


def asked(result):
    """What was asked for, from the case."""
    case = result.case
    if "vertical_force" in case:
        load = f"{tables.plain(case['vertical_force'])} N vertically on each wheel"
    elif "normal_force" in case:
        load = f"F<sub>z</sub> = {tables.plain(case['normal_force'])} N"
    else:
        load = f"approach {tables.plain(case['approach'])} mm"

    def radius(value):
        return "flat" if abs(value) == float("inf") else f"{tables.plain(value)} mm"

    what = {"shift": "Load points are steps of a shift without rolling. ",
            "transient": "Load points are steps of rolling. ",
            "frictionless": "Without friction. "}.get(case.get("problem"), "")
    if case.get("prescribed_forces"):
        what += "Tangential forces are prescribed; creepages are results. "
    details = (f"<details><summary>case file {escape(result.case_file)}</summary>"
               f"<pre>{escape(result.case_text)}</pre></details>")
    friction = f"friction coefficient {tables.plain(case['friction_coefficient'])}. {what}</p>{details}"
    if "given_max_pressure" in case:
        return (f"<p>Hertz's pressure of {tables.plain(case['given_max_pressure'])} MPa given on an "
                f"ellipse of semi-axes {tables.plain(case['given_semi_axis_x'])} by "
                f"{tables.plain(case['given_semi_axis_y'])} mm; {friction}")
    if "distance_A" in case:
        return (f"<p>Undeformed distance A x² + B y² with A = {tables.plain(case['distance_A'])}, "
                f"B = {tables.plain(case['distance_B'])} 1/mm; {load}, {friction}")
    if "distance_file" in case:
        return (f"<p>Undeformed distance from {escape(case['distance_file'])}; {load}, {friction}")
    if "wheel_profile" in case or "rail_profile" in case:
        wheel = case.get("wheel_profile", "of a circle")
        rail = case.get("rail_profile", "of a circle")
        return (f"<p>Wheel profile {escape(wheel)}, nominal radius "
                f"{tables.plain(case['wheel_rolling_radius'])} mm, on rail profile {escape(rail)}; "
                f"{load}, {friction}")
    return (f"<p>Wheel of rolling radius {tables.plain(case['wheel_rolling_radius'])} mm "
            f"(transverse {radius(case['wheel_transverse_radius'])}) on a rail of transverse radius "
            f"{radius(case['rail_transverse_radius'])}; {load}, {friction}")


def _numbers(result):
    reference = selection.reference_for_patch(result)
    if reference is None:
        return "<p>No model was run.</p>"
    html = ["<h2>Patch and pressure</h2>", tables.patch_table(result), tables.published_table(result),
            f"<p class=hint>Small percentages: difference to {escape(style.label(reference))}, of its value; "
            f"bold: more than both error bars allow. {BARS}</p>"]
    failed = [f"{style.label(m)} at ξ = {tables.plain(100 * p['longitudinal_creepage'])} %"
              for m in result.models for p in m.points if not p["converged"]]
    if failed:
        html.insert(0, f"<p class=bad><b>Not converged:</b> {escape('; '.join(failed))}. These numbers "
                    "cannot be trusted.</p>")
    return "".join(html)


def _forces(result, creep_curve):
    reference = selection.reference_for_forces(result)
    if reference is None:
        return ""
    models = selection.friction_models(result)
    points = [p for m in models for p in m.points]
    shared = tables.shared_creepage(models)
    note = ""
    if len(models) > 1:
        note = (f"Small percentages: difference to {escape(style.label(reference))}, in percent of full "
                "sliding (μ, μ p<sub>0</sub>, μ F<sub>z</sub>); bold: more than both error bars allow.")
    hint = f"<p class=hint>{note}{shared}</p>" if note or shared else ""
    html = ["<h2>Traction coefficient −F<sub>x</sub>/F<sub>z</sub></h2>",
            tables.creepage_table(result, "traction_coefficient"), hint, creep_curve,
            "<h2>Largest tangential traction |p<sub>x</sub>| [MPa]</h2>",
            tables.creepage_table(result, "max_traction_x")]
    largest = max(abs(p["normal_force"]) for p in points)
    if any(abs(p["lateral_force"]) > 1e-4 * largest for p in points):
        html += ["<h2>Lateral force F<sub>y</sub> [N]</h2>",
                 tables.creepage_table(result, "lateral_force")]
    return "".join(html)


def _stresses(result, images):
    largest = stresses.maxima_table(result)
    if not largest and not images:
        return ""
    hint = ("<p class=hint>Over all load points. ±: the model's own error estimate. Places x, y, z; z "
            "points into the wheel.</p>")
    return "<h2>Stress in the bodies</h2>" + (largest + hint if largest else "") + images


def notes(result):
    said = dict.fromkeys((style.label(m), note) for m in result.models
                         for note in m.notes + [f"model error: {m.model_error_source}"] * bool(m.model_error_source))
    rows = [f"<li><b>{escape(name)}</b>: {escape(note)}</li>" for name, note in said]
    return "<h2>What to know about the models</h2><ul>" + "".join(rows) + "</ul>" if rows else ""


def _details(result):
    return "".join(f"<details><summary>all numbers of {escape(style.label(m))}"
                   f"{', ' if m.place else ''}{escape(place_label(m.place))}</summary>"
                   f"{tables.points_table(result, m)}</details>" for m in result.models if m.points)


def _patch(result, images, heading):
    """Everything about one patch; `images(start)` gives its figures whose names begin so."""
    html = [_numbers(result), images("outlines", "contact_area"), _forces(result, images("creep_curve")),
            "<h2>Tractions in the patch</h2>" if images("path", "strip_force", "oblique") else "",
            images("path", "strip_force", "oblique"), _stresses(result, images("stress_"))]
    text = "".join(html)
    if heading:
        text = f"<h2>{escape(heading)}</h2>" + text.replace("<h2>", "<h3>").replace("</h2>", "</h3>")
    return text


def patches(result, figures, every=False):
    """The patches one after the other; of a long row of positions the first ones have figures, and the
    others tables if `every` one is wanted."""
    scenes = result.scenes()
    drawn = {name.split("_", 1)[0] for name, _ in figures if name[0] == "s" and name[1].isdigit()}
    html = []
    for number, (label, scene) in enumerate(scenes, 1):
        prefix = f"s{number}_" if len(scenes) > 1 else ""
        if prefix and f"s{number}" not in drawn and not every:
            break

        def images(*starts, prefix=prefix):
            return "".join(image(result.directory, n, c) for n, c in figures
                           if n.startswith(tuple(prefix + s for s in starts)))

        heading = label[0].upper() + label[1:] if label else ""
        html.append(_patch(scene, images, heading if len(scenes) > 1 else ""))
    return "".join(html)


def touching(result, figures):
    """Where wheel and rail touch, with profiles; else nothing."""
    if not (result.models and result.models[0].place):
        return ""
    return ("<h2>Where wheel and rail touch</h2>" + places.contact_table(result)
            + "<p class=hint>Track: y to the right, positive angles rise to the flange; profile "
            "coordinates: y to the field side. Forces and pressures at the first load point.</p>"
            + "".join(image(result.directory, n, c) for n, c in figures
                      if n.startswith(("pair_", "positions"))))


def report_html(result, figures):
    """The page as text; `figures` are (file name in figures/, caption)."""
    made = result.provenance
    title = escape(result.title or result.case_file or "rollfem result")
    return page(title, [
        heading(title, made, made),
        asked(result), touching(result, figures), patches(result, figures), "<h2>Cost</h2>", tables.cost_table(result),
        notes(result), "<h2>Signs</h2><p>", CONVENTIONS, "</p>",
        "<div class=screen><h2>Every load point</h2>", _details(result),
        "<p class=hint>Beside this file: results.h5 (all fields), summary.json, creep_curve.csv, "
        "contacts.csv with profiles, path_x.csv, path_y.csv, subsurface.csv where asked for, fields/ "
        "(for ParaView), figures/.</p></div>"])


# What a verdict, made for a terminal, looks like on a page.
LOOKS = [(r"\bmu\b", "μ"), (r"\bp0\b", "p<sub>0</sub>"), (r"([Fp])_([xyz])", r"\1<sub>\2</sub>"), ("-F<", "−F<")]


def verdict(text):
    """The verdict of a comparison or study, models by the names that figures and tables have."""
    text = escape(text)
    for pattern, look in LOOKS + [(rf"(?<![\w.-]){name}(?![\w-])", label)
                                  for name, label in style.LABELS.items()]:
        text = re.sub(pattern, look, text)
    return f"<p class=say>{text}</p>" if text else ""


def heading(title, program, run):
    """What the page is about, as HTML, and which call of which program has made it."""
    made = f"rollfem {program['version']} ({program['commit']}), {run['started']}, {run['host']}"
    if run["processes"] > 1:
        made += f", {run['processes']} processes"
    return f"<h1>{title}</h1><p class=meta>{escape(made)}<br><code>{escape(run['command'])}</code></p>"


def page(title, parts):
    """A whole page from its parts; the title is HTML."""
    return "".join([
        "<!DOCTYPE html><html lang=en><head><meta charset=utf-8>"
        '<meta name=viewport content="width=device-width,initial-scale=1">'
        f"<title>{title}</title><style>{CSS}</style></head><body>", *parts, "</body></html>\n"])


def write_page(path, text):
    """Writes a page whole or not at all."""
    with style.whole(path) as part, open(part, "w", encoding="utf-8") as file:
        file.write(text)


def write_report(result, figures):
    """Writes report.html whole or not at all."""
    write_page(os.path.join(result.directory, "report.html"), report_html(result, figures))
