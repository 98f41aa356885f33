# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of the report as HTML, from a result."""
import math
import re
from html import escape

from . import load_points, styles
from .labels import symbol
from .page import hint, under
from .published import published


NOTHING = 1e-15  # in any unit: rounding


def number(value, digits=5):
    """A number for reading: `digits` significant digits (None: all that it needs), without exponent if possible."""
    if value is None or math.isnan(value):
        return "–"
    if digits is None:
        return plain(value)
    if abs(value) < NOTHING:
        return "0"
    if isinstance(value, int) and abs(value) < 10 ** digits:
        return str(value)
    text = f"{value:#.{digits}g}".rstrip(".")
    if "e" in text and 1e-9 < abs(value) < 1e-3:
        text = f"{value:.{digits - 1 - math.floor(math.log10(abs(value)))}f}"
    if "e" in text and 1e-4 <= abs(value) < 1e7:
        text = f"{value:.0f}"
    return text.replace("-", "−")


def plain(value):
    """A number given by the user, without superfluous digits."""
    return f"{0.0 if abs(value) < NOTHING else value:.6g}".replace("-", "−")


def span(values, digits=4):
    """"0 to 0.55", or the one value."""
    values = list(values)
    low, high = (number(0 if abs(v) < 1e-9 * max(map(abs, values)) else v, digits) for v in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def percent(value):
    if value is None or math.isnan(value):
        return ""
    text = f"{value:+.2f}"
    return ("0.00" if float(text) == 0 else text).replace("-", "−") + " %"


ROUNDING = 1e-7  # relative to the value; smaller bars are not shown


def measured(value, bar, digits=5):
    """value ± bar, or value with a word instead of the bar."""
    html = number(value, digits)
    if isinstance(bar, str):
        return html + (f"&nbsp;<span class=e>{escape(bar)}</span>" if bar else "")
    if bar and bar > ROUNDING * abs(value):
        html += f"&nbsp;<span class=e>±&nbsp;{number(bar, 2)}</span>"
    return html


def barred(point, quantity, digits=5):
    """The value of a load point with its bar, or the reason why it has none."""
    if quantity not in point.scalars:
        return "–"
    bar = point.bar(quantity)
    return measured(point[quantity], point.no_bar.get(quantity, "") if bar is None else bar, digits)


def with_bar(point, quantity, digits=5):
    """The value of a load point with its error bar, and below it the model error."""
    html = barred(point, quantity, digits)
    model_error = point.model_error.get(quantity)
    if model_error is not None:
        html = under(html, f"model ±&nbsp;{number(model_error, 2)}")
    return html


def against(point, base, quantity, scale):
    """The difference from the reference in percent of a scale, bold if it exceeds both error bars (a theory without an
    estimate has none); empty without a scale."""
    if not scale:
        return ""
    difference = point[quantity] - base[quantity]
    allowed = (point.bar(quantity) or 0.0) + (base.bar(quantity) or 0.0) + 1e-9 * abs(base[quantity])
    text = percent(100 * difference / abs(scale))
    return under("", f"<b>{text}</b>" if abs(difference) > allowed else text)


# With this many columns a table is printed in landscape format (page.page).
MANY = 6


def table(head, rows, kind="", frame="", name=""):
    """HTML table that scrolls within its frame if it is wider than the page; the first cell of a row is its heading.
    `kind`, `frame`: classes of table and frame; `name`: for screen readers, by default the first head."""
    name = name or "table: " + re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", head[0])).strip()
    frame = frame or "many" * (len(head) >= MANY)
    body = "".join("<tr><th scope=row>" + row[0] + "</th>" + "".join(f"<td>{c}</td>" for c in row[1:]) + "</tr>"
                   for row in rows)
    return (f'<div class="wide{frame and " " + frame}" role=region tabindex=0 aria-label="{name}"><table class="{kind}">'
            f'<thead><tr>{"".join(f"<th scope=col>{h}</th>" for h in head)}</tr></thead><tbody>{body}</tbody></table></div>')


def unit(quantity):
    """" [mm²]"; empty if there is none."""
    return "" if quantity.unit == "-" else f" [{escape(quantity.unit).replace('^2', '²')}]"


def heading(quantity):
    """Title, symbol and unit of a scalar from the file."""
    return " ".join(filter(None, (escape(quantity.title), symbol(quantity.symbol)))) + unit(quantity)


PATCH = ["max_pressure", "contact_length", "contact_width", "semi_axis_x", "semi_axis_y", "contact_area",
         "approach", "normal_force"]


def _tells(result, quantity):
    """Whether a row of the patch table is useful: a given force is the same in every model, and an ellipse has
    semi-axes, a patch of profiles a length and a width."""
    of_profiles = bool(result.models and result.models[0].place)
    if quantity.startswith(("contact_length", "contact_width", "semi_axis")):
        return quantity.startswith("contact") == of_profiles
    values = [m.headline[quantity] for m in result.models if m.headline]
    return quantity != "normal_force" or not values or max(values) - min(values) > 1e-6 * abs(values[0])


def _compared(head, models, reference, rows):
    """A table of models side by side, the reference first, so that no window hides it; `rows`: the first cells and the
    cell of a model (a function)."""
    models = sorted(models, key=lambda model: model is not reference)
    return table([head] + [escape(styles.label(m)) for m in models],
                 [[first] + [cell(m) for m in models] for first, cell in rows])


def patch_table(result):
    """Patch, pressure and approach of every model at its headline."""
    reference = load_points.reference_for_patch(result)
    point = reference.headline

    def cell(model, quantity):
        html = with_bar(model.headline, quantity, 6)
        base = load_points.reference_for(result, quantity)
        if model is base or not base.headline:
            return html
        return html + against(model.headline, base.headline, quantity, base.headline[quantity])

    head = "" if len(reference) < 2 else f"after the last pass ({point.number + 1})" if point and point.by_number == "pass" else (
        "at the largest load")
    return _compared(head, [m for m in result.models if m.headline], reference, [
        (heading(result.quantities[name]), lambda model, name=name: cell(model, name)) for name in PATCH
        if _tells(result, name)])


def published_table(result):
    """Published values for the patch of this case; empty if there are none."""
    known = published(result)
    rows = known["patch"]
    if not rows:
        return ""

    def cell(value):
        if not isinstance(value, dict):
            return "–" if value is None else plain(value)
        return under(plain(value["value"]), f"ξ = {plain(100 * value['xi'])} %")

    lines = [[heading(result.quantities[name])] + [cell(row.get(name)) for row in rows]
             for name in [*PATCH, "max_traction_x"] if any(name in row for row in rows)]
    words = f"The thesis says: {escape(known['says'])}. " if known["says"] else ""
    return (table(["published"] + [escape(row["name"]).replace(": ", ":<br>") for row in rows], lines)
            + f"<p class=hint>{words}Sources: {escape(known['sources'])}.</p>")


def _creepage_head(models):
    """(heading, words of a key) for the values that vary over the load points; `shared_creepage` has the common
    ones."""
    told = _told(models)
    if told is None:
        return next(key[1] for key in load_points.all_keys(models) if len(key) == 2), lambda key: plain(key[0])
    parts = [(k, *load_points.PARTS[k][2:5]) for k in told]
    return (", ".join(f"{symbol} [{unit_}]" for _, symbol, _, unit_ in parts),
            lambda key: ", ".join(plain(key[k] * factor) for k, _, factor, _ in parts))


def _told(models):
    """The parts of the keys shown in a table; None if keys are numbers."""
    found = load_points.all_keys(models)
    return None if any(len(key) == 2 for key in found) else load_points.varying(found) or [0]


def shared_creepage(models):
    """" All at η = 0.1 %." for nonzero values outside the table, which are the same at every load point; empty if there
    are none."""
    first, told = next(iter(load_points.all_keys(models)), (0,)), _told(models)
    said = [f"{symbol} = {plain(factor * first[k])} {unit_}"
            for k, (_, _, symbol, factor, unit_, _) in enumerate(load_points.PARTS)
            if told is not None and k not in told and abs(first[k]) > NOTHING]
    return f" All at {', '.join(said)}." if said else ""


def _with_forces(models, found, words):
    """The words of a key with the prescribed forces of its load point."""
    def said(key):
        point = next(p for m in models if (p := m.at(key)))
        forces = ", ".join(f"F<sub>{axis}</sub> = {plain(point[force])} N" for _, force, axis, *_ in found)
        return under(words(key), forces)

    return said


def creepage_table(result, quantity):
    """A friction quantity of every model with friction at every creepage. Differences from the reference are in percent
    of the reference's value in full sliding."""
    models = load_points.friction_models(result)
    reference = load_points.reference_for_forces(result)
    head, words = _creepage_head(models)
    if found := load_points.found_motions(models):
        words = _with_forces(models, found, words)

    def cell(model, key):
        point, base = model.at(key), reference.at(key)
        if point is None:
            return "–"
        if model is reference or not base:
            return with_bar(point, quantity)
        sliding = result.quantities[quantity].full_sliding(base, result.friction_coefficient)
        return with_bar(point, quantity) + against(point, base, quantity, sliding or base[quantity])

    return _compared(head, models, reference, [(words(key), lambda model, key=key: cell(model, key))
                                    for key in load_points.shown_keys(models)])


def law_words(result):
    """What a case has beside the coefficient: the fall of the law, places, the layer; may be empty."""
    said, case = "", result.inputs
    if result.friction_law is not None:
        rest, kinetic = result.friction_law[[0, -1], 1]
        memory = case.get("friction.memory_distance", 0.0)
        said += (f" at rest, falling ({escape(case['friction.law'])}) by {plain(rest - kinetic)} to {plain(kinetic)} with the "
                 "slip velocity" + f", memory {plain(memory)} mm" * bool(memory))
    for place, words in (("track_position", "along the track"), ("inclination", "over the inclination of the rail"),
                         ("lateral_position", "over the lateral position")):
        if f"friction.{place}" in case:
            said += f", varying {words} (this is the largest)"
    if "layer.thickness" in case:
        said += (f"; a layer of {plain(case['layer.thickness'])} mm with shear modulus "
                 f"{plain(case['layer.shear_modulus'])} MPa")
    if "layer.yield_stress" in case:
        said += (f"; a layer that yields at {plain(case['layer.yield_stress'])} MPa, hardening "
                 f"{plain(case.get('layer.hardening', 0.0))} MPa/mm")
    return said


def fall_table(result):
    """Initial slope, peak and last value of creep curves under friction that falls; empty without such curves."""
    rows = []
    for model in load_points.friction_models(result) if result.friction_law is not None else []:
        creepages, values = load_points.branch(model)
        if len(values) < 3:
            continue
        top, slope = load_points.peak(creepages, values), load_points.initial_slope(creepages, values)
        ends = [top and (number(100 * top[0], 3), top[1]), (plain(100 * creepages[-1]), values[-1])]
        rows.append([escape(styles.label(model)), number(slope, 3)] + [cell for end in ends for cell in (
            (number(end[1], 3), f"{100 * end[1] / result.friction_coefficient:.1f} %", end[0]) if end else "–––")])
    return rows and table(["rise and fall", "initial slope dT/dξ", "peak T", "of μ at rest", "at ξ [%]", "last T",
                           "of μ at rest", "at ξ [%]"], rows) + hint(
        "T: traction coefficient. Initial slope: extrapolated from the three smallest creepages. Peak: of the parabola "
        "through the highest point and its neighbours; –: too few points there, or no fall.") or ""


def grouped(count):
    """A whole number, its digits in groups of three."""
    return f"{count:,}".replace(",", " ")


def cost_table(result):
    """What each model took, over all patches."""
    rows = []
    for name in dict.fromkeys(model.name for model in result.models):
        own = [model for model in result.models if model.name == name]
        seconds = {stage: sum(model.seconds.get(stage, 0.0) for model in own) for model in own for stage in model.seconds}
        parts = sorted(((s, stage) for stage, s in seconds.items() if stage != "total"), key=lambda part: -part[0])[:3]
        patches = f"{len(own)} patches" if len(own) > 1 else ""
        rows.append([under(escape(styles.label(name)), patches) if patches else escape(styles.label(name)),
                     number(seconds.get("total"), 3), ", ".join(f"{escape(stage)} {number(s, 3)}" for s, stage in parts) or "–",
                     *(grouped(max(getattr(model, size) for model in own)) for size in ("unknowns", "contact_elements")),
                     str(sum(map(len, own)))])
    return table(["model", "seconds", "of which", "unknowns", "contact elements", "load points"], rows, "left")


def points_table(result, model):
    """Every scalar of every load point, except those that are 0 everywhere."""
    head, words = _creepage_head([model])
    quantities = {n: q for n, q in result.quantities.items() if n != "converged" and any(p.scalars.get(n) for p in model.points)}
    rows = [[words(p.key), *(barred(p, n) for n in quantities), "yes" if p["converged"] else "no"]
            for p in map(model.at, load_points.shown_keys([model]))]
    return table([head, *((symbol(q.symbol) or escape(q.title)) + unit(q) for q in quantities.values()), "converged"], rows)
