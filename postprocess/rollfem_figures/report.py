"""report.html: the problem, the patch, forces, tractions and stresses of every model."""
import os
import re
from html import escape

from . import looks, places, selection, stresses, tables, wheelset
from .chooser import chooser
from .page import figure, made_by, write_page
from .reader import place_label

CONVENTIONS = """x is the rolling direction, and material enters the patch at large x (on the right of
the figures); y is lateral; z points into the wheel. Tractions and forces are those acting on the wheel.
A positive longitudinal creepage ξ brakes the wheel and gives a negative F<sub>x</sub>; the traction
coefficient is −F<sub>x</sub>/F<sub>z</sub>, so that the creep curve rises with ξ, and the figures draw
−p<sub>x</sub> for the same reason. Slip is that of the wheel's surface relative to the rail."""


BARS = ("±: uncertainty left by grid and solver, estimated by the model, in the unit of the value; a word in its place "
        "says why there is none (exact: a closed form; theory: an approximate theory). “model ±”: what the model "
        "neglects on any grid; the notes say how it was estimated.")


# What is in contact and under what load, by a key that only such a case has; the last where no other fits.
SHAPES = (("given_max_pressure", "Hertz's pressure of {given_max_pressure} MPa given on an ellipse of semi-axes "
           "{given_semi_axis_x} by {given_semi_axis_y} mm"),
          ("distance_A", "Undeformed distance A x² + B y² with A = {distance_A}, B = {distance_B} 1/mm"),
          ("distance_file", "Undeformed distance from {distance_file}"),
          ("wheel_profile", "Wheel profile {wheel_profile}, nominal radius {wheel_rolling_radius} mm, on rail profile "
           "{rail_profile}"),
          ("wheel_transverse_radius", "Wheel of rolling radius {wheel_rolling_radius} mm (transverse "
           "{wheel_transverse_radius}) on a rail of transverse radius {rail_transverse_radius}"))
LOADS = (("given_max_pressure", ""), ("vertical_force", "; {vertical_force} N vertically on each wheel"),
         ("normal_force", "; F<sub>z</sub> = {normal_force} N"), ("approach", "; approach {approach} mm"))
PROBLEMS = {"shift": "Load points are steps of a shift without rolling. ", "transient": "Load points are steps of rolling. "}


def asked(result):
    """The problem, from the case."""
    case = dict(result.case)
    if "wheel_profile" in case or "rail_profile" in case:
        case = {"wheel_profile": "of a circle", "rail_profile": "of a circle", **case}
    words = {name: tables.plain(value) if isinstance(value, (int, float)) else escape(str(value))
             for name, value in case.items()}
    for name in ("wheel_transverse_radius", "rail_transverse_radius"):
        if name in case:
            words[name] = "flat" if abs(case[name]) == float("inf") else f"{words[name]} mm"
    said = "".join(next(text for name, text in rows if name in case).format_map(words) for rows in (SHAPES, LOADS))
    law = "without friction" if case.get("problem") == "frictionless" else (
        f"friction coefficient {words['friction_coefficient']}")
    what = PROBLEMS.get(case.get("problem"), "")
    if case.get("prescribed_forces"):
        what += "Tangential forces are prescribed; creepages are results. "
    return (f"<p>{said}{';' if 'given_max_pressure' in case else ','} {law}. {what}</p>"
            f"<details><summary>case file {escape(result.case_file)}</summary>"
            f"<pre>{escape(result.case_text)}</pre></details>")


def _numbers(result):
    reference = selection.reference_for_patch(result)
    if reference is None:
        return "<p>No model was run.</p>"
    html = ["<h2>Patch and pressure</h2>", tables.patch_table(result), tables.published_table(result),
            f"<p class=hint>Small percentages: difference from {escape(looks.label(reference))}, relative to its value; "
            f"bold: more than both error bars allow. {BARS}</p>"]
    failed = [f"{looks.label(m)} at ξ = {tables.plain(100 * p['longitudinal_creepage'])} %"
              for m in result.models for p in m.points if not p["converged"]]
    if failed:
        html.insert(0, f"<p class=bad>Not converged: {escape('; '.join(failed))}. These numbers "
                    "cannot be trusted.</p>")
    return "".join(html)


def _forces(result, creep_curve):
    reference = selection.reference_for_forces(result)
    if reference is None:
        return ""
    models = selection.friction_models(result)
    points = [p for m in models for p in m.points]
    shared = tables.shared_creepage(models)
    count = len(selection.all_keys(models))
    if count > selection.MOST_ROWS:
        shared += f" {selection.MOST_ROWS} of {count} load points; all are in creep_curve.csv."
    note = ""
    if len(models) > 1:
        note = (f"Small percentages: difference from {escape(looks.label(reference))}, in percent of full "
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
    """The notes of the models. A note that differs between patches only in its numbers appears once, with those of
    the first patch."""
    said = {}
    for model in result.models:
        for note in model.notes + [f"model error: {model.model_error_source}"] * bool(model.model_error_source):
            words = looks.label(model), re.sub(r"[-+]?\d+(\.\d*)?(e[-+]?\d+)?", "", note)
            said.setdefault(words, [note, set()])
            if note != said[words][0]:
                said[words][1].add(model.key)
    rows = []
    for (name, _), (note, others) in said.items():
        more = "" if not others else " (and another patch with other numbers)" if len(others) == 1 else (
            f" (and {len(others)} other patches with other numbers)")
        rows.append(f"<li>{escape(name)}: {escape(note + more)}</li>")
    return "<h2>Notes on the models</h2><ul>" + "".join(rows) + "</ul>" if rows else ""


def _details(result):
    return "".join(f"<details><summary>all numbers of {escape(looks.label(m))}"
                   f"{', ' if m.place else ''}{escape(place_label(m.place))}</summary>"
                   f"{tables.points_table(result, m)}</details>" for m in result.models if m.points)


def lower(html):
    """The HTML with every heading one level lower."""
    for level in (3, 2):
        html = html.replace(f"<h{level}>", f"<h{level + 1}>").replace(f"</h{level}>", f"</h{level + 1}>")
    return html


def _patch(scene, images, heading):
    """Everything about one patch; `images(start)` gives its figures whose names begin so."""
    tractions = images("path", "strip_force", "oblique")
    html = [_numbers(scene), images("outlines", "contact_area"), _forces(scene, images("creep_curve")),
            "<h2>Tractions in the patch</h2>" if tractions else "", tractions, _stresses(scene, images("stress_"))]
    text = "".join(html)
    return f"<h3>{escape(heading)}</h3>" + lower(lower(text)) if heading else text


# Of so many patches the printer gets all.
MOST_PRINTED = 4


def patches(result, figures, name="patch"):
    """The patch; one of several is shown, which the reader chooses. `name`: of the choice."""
    scenes = result.scenes()
    articles = []
    for number, (label, scene) in enumerate(scenes, 1):
        prefix = f"s{number}_" if len(scenes) > 1 else ""

        def images(*starts, prefix=prefix):
            return "".join(figure(f) for f in figures if f.name.startswith(tuple(prefix + s for s in starts)))

        words = places.at_words(result, scene.models[0].place["position"]) if len(scenes) > 1 else ""
        words = f",{words}" if words else ""
        articles.append(_patch(scene, images, label[0].upper() + label[1:] + words if words or prefix else ""))
    if len(scenes) < 2:
        return "".join(articles)
    return "<h2>The patches</h2>" + chooser(result, scenes, articles, name, len(scenes) <= MOST_PRINTED)


def touching(result, figures):
    """The section on where wheel and rail touch, for profiles; otherwise empty."""
    if not (result.models and result.models[0].place):
        return ""
    row = wheelset.table_of_run(result)
    shift = "".join(figure(f) for f in figures if f.name == "wheelset.svg")
    return ((f"<h2>Wheelset over lateral shift</h2>{row}{shift}" if row else "")
            + "<h2>Where wheel and rail touch</h2>" + places.contact_table(result)
            + "<p class=hint>Track: y to the right, positive angles rise to the flange; profile "
            "coordinates: y to the field side. Forces and pressures at the first load point.</p>"
            + "".join(figure(f) for f in figures if f.name.startswith(("pair_", "positions"))))


def write_report(result, figures):
    """Writes report.html; `figures` are what is drawn (build.Drawn)."""
    made = result.provenance
    title = escape(result.title or result.case_file or "rollfem result")
    write_page(os.path.join(result.directory, "report.html"), title, made_by(made, made), [
        asked(result), touching(result, figures), patches(result, figures), "<h2>Cost</h2>", tables.cost_table(result),
        notes(result), "<h2>Signs</h2><p>", CONVENTIONS, "</p>",
        "<div class=screen><h2>Every load point</h2>", _details(result), "</div>"],
        "Also in this folder: results.h5 (all fields), summary.json, creep_curve.csv, contacts.csv (with profiles), "
        "wheelset.csv (for a row of shifts), path_x.csv, path_y.csv, subsurface.csv (if requested), fields/ (for "
        "ParaView), figures/.")


# Replacements that turn a verdict for the terminal into HTML.
LOOKS = [(r"\bmu\b", "μ"), (r"\bp0\b", "p<sub>0</sub>"), (r"([Fp])_([xyz])", r"\1<sub>\2</sub>"), ("-F<", "−F<")]


def verdict(text):
    """The verdict of a comparison or study, models by the names that figures and tables have."""
    text = escape(text)
    for pattern, look in LOOKS + [(rf"(?<![\w.-]){name}(?![\w-])", label)
                                  for name, label in looks.LABELS.items()]:
        text = re.sub(pattern, look, text)
    return f"<p class=say>{text}</p>" if text else ""
