# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: the problem, the patch, forces, tractions and stresses of every model."""
import re
from html import escape

from ..errors import FileError
from ..result import count, place_label
from . import answer, curves, load_points, maps, positions, stresses, styles, tables, temperatures, yielding
from .page import case_file, folded, hint, made_by, section

CONVENTIONS = section("Signs", """<p>x is the rolling direction, and material enters the patch at large x (on the right of
the figures); y is lateral; z points into the wheel. Tractions and forces are those acting on the wheel.
A positive longitudinal creepage ξ brakes the wheel and gives a negative F<sub>x</sub>; the traction
coefficient is −F<sub>x</sub>/F<sub>z</sub>, so that the creep curve rises with ξ, and the figures draw
−p<sub>x</sub> for the same reason. Slip is that of the wheel's surface relative to the rail.</p>""")

BARS = ("±: error bar for grid and solver, estimated by the model, in the unit of the value; a word in its place "
        "says why there is none (exact: a closed form; theory: an approximate theory). “model ±”: model error, "
        "present on any grid; the notes say how it was estimated.")

# Figures of a patch: file name, caption, and the function of the result that draws it or returns None.
OF_PATCH = (
    ("creep_curve", "Creep curve: traction coefficient of every model with friction, and beside it the difference from "
     "the reference model if there are several. Bars: error estimates. Where friction falls with the slip velocity: its "
     "friction in full sliding (dotted), and the rise up to the peak.", curves.creep_curve),
    ("creep_found", "Creepage or shift found for the prescribed force, and the difference from the reference model if there "
     "are several. Bars: error estimates.", curves.found_for_force),
    *((f"path_{axis}", f"Along the line {across} = 0, or through the largest pressure where that lies beside it: contact "
       "pressure, and tangential traction under its bound (thin): μ pₙ, or the theory's own (FASTSIM, strip). Where the two "
       "coincide the surfaces slip.",
       lambda result, axis=axis: curves.path(result, axis)) for axis, across in ("xy", "yx")),
    ("path_lateral", "Lateral traction along the lines of the figures before. It vanishes along y = 0 in a symmetric patch "
     "without lateral creepage or spin.", curves.lateral_paths),
    ("strip_force", "Force per strip: pressure and tangential traction summed along rolling, per mm of width. "
     "Thin: the same strip in full sliding.", curves.strip_forces),
    ("pass_work", "Frictional work per pass and area across the patch: what a strip of wheel or rail receives while the contact "
     "passes over it once (N mm per mm²); its integral over y is the frictional work per mm rolled.", curves.pass_work),
    ("temperature_along", "Temperature of the surfaces along rolling, through the hottest place: both rise together in contact and "
     "cool by conduction behind it.", temperatures.along),
    ("temperature_map", "Temperature of the rail's surface at the hottest load point; white: edge of the patch.", temperatures.surface),
    ("outlines", "Contact patches of all models overlaid, with the border between adhesion and slip area of each; shaded: the "
     "areas of the reference model. Material enters on the right.", maps.outlines),
    ("contact_area", "Adhesion and slip areas, model by model.", maps.contact_area))


def captions(result):
    """(file name, caption, function that draws it or returns None) of the figures of a patch."""
    for name, caption, draw in OF_PATCH:
        yield f"{name}.svg", caption, lambda draw=draw: draw(result)
    for model in result.models:
        yield (f"pressure_map_{model.name}.svg", f"Contact pressure over the patch and, with friction, size of the tangential traction: "
               f"{styles.label(model)}.", lambda model=model: maps.pressure(result, model))
    for number, kind, body in stresses.lines(result):
        yield (f"stress_{number + 1}.svg", stresses.caption(kind, body),
               lambda number=number: stresses.of_request(result, number))
    yield from yielding.captions(result)


def place_captions(result):
    """The same for the figures before the patches, if wheel and rail have profiles."""
    numbers = positions.positions(result)
    for wheel, position in result.profiles:
        if position in (numbers[0], numbers[-1]):
            yield (f"pair_{wheel}_{position:.0f}.svg",
                   f"The {wheel} wheel on its rail{positions.at_words(result, position)}, with the contact "
                   "points: the middle of the loaded patch, which need not be where the bodies touch first. Right: the undeformed "
                   "distance around them.",
                   lambda wheel=wheel, position=position: positions.pair(result, wheel, position))
            yield (f"work_{wheel}_{position:.0f}.svg",
                   f"Where the {wheel} wheel and its rail wear{positions.at_words(result, position)}: frictional work per "
                   "pass and area over their profiles. A wheel receives it once per revolution.",
                   lambda wheel=wheel, position=position: positions.work(result, wheel, position))
    yield ("wheelset.svg", "The wheelset over its lateral shift: rolling radii and contact angles, unloaded "
           "(lines) and under load (markers); equivalent conicity over the amplitude, from the wave of the free "
           "wheelset (UIC 519, EN 15302) and by harmonic linearisation, and the wavelength.",
           lambda: positions.wheelset(result))
    yield ("positions.svg", "Over the positions: " + (
        "largest pressure with its error bars and normal force of each contact, followed from position to position (one colour "
        "each), height of the wheel, and places. Where one line falls and another rises, the load moves from one contact to the "
        "other." if positions.along(result).is_way else "largest pressure with its error bars, contact points of wheel and rail, "
        "and the other results. Lines: the most loaded patch; single points: further patches; forces: sum over the patches of a "
        "wheel.") + " Filled: left wheel, open: right wheel.", lambda: positions.sweep(result))
    yield ("positions_plan.svg", "The patches of all positions on the rail, seen from above, as ellipses of their length and "
           "width; a colour for each contact, as in the figure before.", lambda: positions.plan(result))


# With more patches than this, each gets only the most informative figures.
MOST_FULL = 8


def _telling(scene):
    """Prefixes of the figures drawn for every patch of a long sweep."""
    reference = load_points.reference_for_forces(scene) or load_points.reference_for_patch(scene)
    return ("creep_", "path_x", "path_y", "outlines", "stress_", "yielded_",
f"pressure_map_{reference.name}.svg")


def captioned(result):
    """The same for a whole run: the places of the patches, then the figures of each patch, whose names begin with s1_,
    s2_, ... if there are several."""
    if not result.inputs:
        raise FileError(f"{result.folder} was written by an earlier version, without the keys of its case; do: run the case again, "
                        "or read its numbers with rollfem.read")
    scenes = positions.shown(result)
    yield ("friction_law.svg", "Friction over the slip velocity of an element, from rest to what is left of it at high "
           "velocities (dotted). Upright: the slip velocity of rigid bodies at the largest creepage. With memory, friction "
           "follows over the sliding distance given.", lambda: curves.friction_law(result))
    if result.models and result.models[0].place:
        yield from place_captions(result)
    for number, (label, scene) in enumerate(scenes, 1):
        first, words = (f"s{number}_", f"{label[0].upper()}{label[1:]}. ") if len(scenes) > 1 else ("", "")
        telling = _telling(scene) if len(scenes) > MOST_FULL else ""
        yield from ((first + name, words + caption, draw) for name, caption, draw in captions(scene) if name.startswith(telling))


def _numbers(result):
    reference = load_points.reference_for_patch(result)
    if reference is None:
        return "<p>No model was run.</p>"
    return section(
        "Patch and pressure", tables.patch_table(result), tables.published_table(result),
        hint(f"Small percentages: difference from {escape(styles.label(reference))}, relative to its value, or from an "
             f"exact value; bold: more than both error bars allow. {BARS}"))


def _sentence(words):
    return words[0].upper() + words[1:]


def _forces(result, creep_curve):
    reference = load_points.reference_for_forces(result)
    if reference is None:
        return ""
    models = load_points.friction_models(result)
    keys = len(load_points.all_keys(models))
    said = f"Small percentages: difference from {escape(styles.label(reference))}, in percent of full sliding " \
        "(μ, μ p<sub>0</sub>, μ F<sub>z</sub>); bold: more than both error bars allow." if len(models) > 1 else ""
    found = load_points.found_motions(models)
    said += " Creepages and shifts that were found: in percent of the value." * (bool(found) and len(models) > 1)
    said += tables.shared_creepage(models)
    if keys > load_points.MOST_ROWS:
        said += f" {load_points.MOST_ROWS} of {keys} load points; all are in creep_curve.csv."
    points = [p for m in models for p in m.points]
    largest = max(abs(p["normal_force"]) for p in points)
    lateral = any(abs(p["lateral_force"]) > 1e-4 * largest for p in points)
    given = {force for _, force, *_ in found} | (set() if lateral else {"lateral_force"})
    rows = [(f"{_sentence(tables.heading(result.quantities[name]))}, found for the given force", name) for name, *_ in found]
    rows += [(heading, quantity) for heading, quantity, force in (
        ("Traction coefficient −F<sub>x</sub>/F<sub>z</sub>", "traction_coefficient", "longitudinal_force"),
        ("Largest tangential traction |p<sub>x</sub>| [MPa]", "max_traction_x", ""),
        ("Lateral force F<sub>y</sub> [N]", "lateral_force", "lateral_force")) if force not in given]
    after = hint(said) + creep_curve + tables.fall_table(result)
    return "".join(section(heading, tables.creepage_table(result, quantity), after * (k == 0))
                   for k, (heading, quantity) in enumerate(rows))


def _said(result, severity, row):
    """The notes of the models, each as HTML by `row` of label and text. What a model notes about the same subject at several
    patches appears once, with the numbers of the first patch."""
    said = {}
    for model in result.models:
        for note in (note for note in model.notes if note.severity == severity):
            first, others = said.setdefault((styles.label(model), note.about), (note, set()))
            if note != first:
                others.add(model.key)
    for (name, about), (note, others) in said.items():
        more = "" if not others else f" (values differ for {count(others, 'other patch', 'es')})"
        yield row.format(escape(name), escape("model error: " * (about == "model_error") + str(note) + more))


def warned(result):
    """The box below the title: results that miss the accuracy, and all warnings of the models."""
    return verdict(result.verdict) + "".join(_said(result, "warning", "<p class=say>{}: warning: {}</p>"))


def notes(result):
    """All other notes."""
    rows = "".join(_said(result, "remark", "<li>{}: {}</li>"))
    return f"<ul>{rows}</ul>" if rows else ""


def lower(html, levels=1):
    """The HTML with every heading lowered by `levels`."""
    return re.sub(r"(</?h)([23])>", lambda found: f"{found[1]}{int(found[2]) + levels}>", html)


def _patch(scene, images, heading):
    """Everything about one patch with its figures (page.Drawn)."""
    largest = stresses.maxima_table(scene)
    html = "".join([
        _numbers(scene), images("pressure_map", "outlines", "contact_area"), _forces(scene, images("creep_")),
        section("Tractions in the patch", images("path", "strip_force")),
        section("Work of friction", images("pass_work")),
        section("Heat of friction", images("temperature")),
        section("Steel that yields", yielding.passes_table(scene), images("yielded_")),
        section("Stress in the bodies", largest, hint("Over all load points. ±: the model's own error estimate. Places x, "
                                                      "y, z; z points into the wheel.") * bool(largest), images("stress_"))])
    return f"<h3>{escape(heading)}</h3>" + lower(html, 2) if heading else html


# With up to this many patches, all are printed.
MOST_PRINTED = 4


def patches(result, figures, name="patch"):
    """The section of the patch; with several, the reader chooses the one shown. `name`: of the choice."""
    if len(scenes := positions.shown(result)) < 2:
        return "".join(_patch(scene, figures, "") for _, scene in scenes)
    articles = []
    for number, (label, scene) in enumerate(scenes, 1):
        words = positions.at_words(result, scene.models[0].place["position"])
        heading = label[0].upper() + label[1:] + ("," + words if words else "")
        articles.append(_patch(scene, figures.under(f"s{number}_"), heading))
    return section("The patches", _chooser(result, articles, name))


def _chooser(result, articles, name):
    """One of many patches shown at a time, chosen in a table of positions and wheels; without a script. `articles`:
    HTML of each of the scenes; `name`: of the choice, unique on the page."""
    inputs, rules, parts, cells = [], [], [], {}
    for number, ((label, scene), article) in enumerate(zip(positions.shown(result), articles), 1):
        this, place = f"{name}{number}", scene.models[0].place
        cells.setdefault((place["position"], place["wheel"]), []).append(f'<label for="{this}">{place["patch"]:.0f}</label>')
        inputs.append(f'<input type=radio class=pick name="{name}" id="{this}" aria-label="{escape(label)}"'
                      f'{" checked" if number == 1 else ""}>')
        rules.append(f"#{this}:checked~#of-{this}{{display:block}}"
                     f"#{this}:checked~.chooser [for={this}]{{background:var(--accent);color:var(--ground)}}"
                     f"#{this}:focus-visible~.chooser [for={this}]{{outline:2px solid var(--ink)}}")
        parts.append(f'<article class=patch id="of-{this}">{article}</article>')
    if len(articles) <= MOST_PRINTED:
        rules.append("@media print{.patch{display:block}}")
    over = positions.along(result)
    numbers = sorted({position for position, _ in cells})
    table = tables.table([escape(over._replace(of="").label), *(tables.plain(over.at[n]) for n in numbers)],
                         [[f"{wheel} wheel", *("".join(cells.get((n, wheel), ["–"])) for n in numbers)]
                          for wheel in ("left", "right") if any(key[1] == wheel for key in cells)],
                         frame="chooser", name="choose a patch")
    return (f"<section aria-label=\"Patches\"><style>{''.join(rules)}</style>{''.join(inputs)}"
            "<p class=hint>Choose a patch (1: the most loaded of its wheel); arrow keys move along the row.</p>"
            f"{table}{''.join(parts)}</section>")


def touching(result, figures):
    """The section on the contacts of wheel and rail, for profiles, its rows of numbers folded; otherwise empty."""
    if not (result.models and result.models[0].place):
        return ""
    row = positions.wheelset_table(result)
    over = "The wheels along the way" if positions.along(result).is_way else "Wheelset over lateral shift"
    said = hint("Track: y to the right, contact angle positive where the plane falls towards the middle of the track; profile "
                "coordinates: y to the field side. Forces and pressures at the largest load, after passes of the last.")
    return section(over, figures("positions", "wheelset.svg"), folded("numbers of every position", row)) * bool(
        row or len(positions.positions(result)) > 2) + section(
        "Where wheel and rail touch", figures("pair_", "work_"), folded("numbers of every contact", positions.contact_table(result) + said))


def page(result, figures):
    """The report of a result, in the order of an engineer's questions."""
    details = "".join(f"<details><summary>all numbers of {escape(styles.label(m))}"
                      f"{', ' if m.place else ''}{escape(place_label(m.place))}</summary>"
                      f"{tables.points_table(result, m)}</details>" for m in result.models if m.points)
    said = notes(result)
    return escape(result.title or result.case_file or "rollfem result"), made_by(result.provenance, result.provenance), [
        answer.part(result, warned(result)), case_file(result.case_file, result.case_text), touching(result, figures),
        patches(result, figures), figures("friction_law"), f"<div class=screen><h2>Every load point</h2>{details}</div>", CONVENTIONS,
        section("Notes and cost", said, tables.cost_table(result))], (
        "Also in this folder: results.h5 (all fields), summary.json, creep_curve.csv, contacts.csv (with profiles), "
        "wheelset.csv (for a lateral sweep), pass_work.csv, path_x.csv, path_y.csv, subsurface.csv (if requested), fields/ (for "
        "ParaView), figures/.")


# Replacements that turn a verdict for the terminal into HTML.
LOOKS = [("`([^`]*)`", r"<code>\1</code>"), (r"\bmu\b", "μ"), (r"\bp0\b", "p<sub>0</sub>"), (r"([Fp])_([xyz0])", r"\1<sub>\2</sub>"), ("-F<", "−F<")]


def verdict(text):
    """The verdict of a comparison or study, with the model labels of figures and tables."""
    text = escape(text)
    for pattern, look in LOOKS + [(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", escape(label).replace("\\", r"\\"))
                                  for name, label in styles.LABELS.items()]:
        text = re.sub(pattern, look, text)
    return f"<p class=say>{text}</p>" if text else ""
