"""The tables of the report as HTML, from a result."""
import math
import re
from html import escape

from . import keys, looks, published, selection
from .reader import full_sliding, place_label


def number(value, digits=5):
    """A number for reading: `digits` significant ones, no exponent where it can be helped."""
    if value is None:
        return "–"
    if value == 0:
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
    """A number that the user gave, without the digits that it does not need."""
    return f"{value:.6g}".replace("-", "−")


def percent(value):
    if value is None:
        return ""
    text = f"{value:+.2f}"
    return ("0.00" if float(text) == 0 else text).replace("-", "−") + " %"


ROUNDING = 1e-7  # of a value: a bar below is not worth a line


def measured(value, bar, digits=5):
    """value ± bar, or the word in place of the bar."""
    html = number(value, digits)
    if isinstance(bar, str):
        return html + (f"&nbsp;<span class=e>{escape(bar)}</span>" if bar else "")
    if bar and bar > ROUNDING * abs(value):
        html += f"&nbsp;<span class=e>±&nbsp;{number(bar, 2)}</span>"
    return html


def barred(point, quantity, digits=5):
    """The value of a load point with its bar, or with why it has none."""
    if quantity not in point.scalars:
        return "–"
    bar = point.bar(quantity)
    return measured(point[quantity], point.no_bar.get(quantity, "") if bar is None else bar, digits)


def with_bar(point, quantity, digits=5):
    """The value of a load point with what is said of its error, and under it what the model leaves out."""
    html = barred(point, quantity, digits)
    model_error = point.model_errors.get(quantity)
    if model_error is not None:
        html += f"<br><span class=d>model ±&nbsp;{number(model_error, 2)}</span>"
    return html


def against(point, base, quantity, scale):
    """The difference to the reference in percent of a scale, bold where it is beyond both error bars (a theory without
    an estimate has none); nothing without a scale."""
    if not scale:
        return ""
    difference = point[quantity] - base[quantity]
    allowed = (point.bar(quantity) or 0.0) + (base.bar(quantity) or 0.0) + 1e-9 * abs(base[quantity])
    text = percent(100 * difference / abs(scale))
    return f"<br><span class=d>{f'<b>{text}</b>' if abs(difference) > allowed else text}</span>"


# With so many columns a table is printed on a page that lies on its side (page.page).
MANY = 6


def table(head, rows, kind=""):
    """HTML table that scrolls within its frame where it is wider than the page; the first cell of a row is
    its heading."""
    name = re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", head[0])).strip()
    many = " many" if len(head) >= MANY else ""
    html = [f'<div class="wide{many}" role=region tabindex=0 aria-label="table: {name}">'
            f'<table class="{kind}"><thead><tr>']
    html += [f"<th scope=col>{h}</th>" for h in head]
    html.append("</tr></thead><tbody>")
    for row in rows:
        html.append("<tr><th scope=row>" + row[0] + "</th>" + "".join(f"<td>{c}</td>" for c in row[1:]) + "</tr>")
    html.append("</tbody></table></div>")
    return "".join(html)


# What the letters of the files look like on a page.
GREEK = {"xi": "ξ", "eta": "η", "phi": "φ", "mu": "μ"}


def symbol(text):
    """A symbol of the files as HTML: F_x, xi, -F_x/F_z, mu p_0."""
    text = re.sub(r"\b(" + "|".join(GREEK) + r")\b", lambda found: GREEK[found[1]], escape(text))
    return re.sub(r"_(\w+)", r"<sub>\1</sub>", text).replace("-", "−")


def unit(quantity):
    """" [mm²]"; empty where it has none."""
    return "" if quantity.unit == "-" else f" [{quantity.unit.replace('^2', '²')}]"


def heading(quantity):
    """Title, symbol and unit of a scalar as the file has them."""
    return " ".join(filter(None, (escape(quantity.title), symbol(quantity.symbol)))) + unit(quantity)


PATCH = ["max_pressure", "contact_length", "contact_width", "semi_axis_x", "semi_axis_y", "contact_area",
         "approach", "normal_force"]


def _tells(result, quantity):
    """Whether a row of the patch table says anything: a given force is the same in every model, and
    an ellipse has semi-axes, a patch of profiles a length and a width."""
    of_profiles = bool(result.models and result.models[0].place)
    if quantity.startswith(("contact_length", "contact_width", "semi_axis")):
        return quantity.startswith("contact") == of_profiles
    values = [m.points[0][quantity] for m in result.models if m.points]
    return quantity != "normal_force" or not values or max(values) - min(values) > 1e-6 * abs(values[0])


def patch_table(result):
    """Patch, pressure and approach of the first load point of every model."""
    models = [m for m in result.models if m.points]
    reference = selection.reference_for_patch(result)
    rows = []
    for quantity in PATCH:
        if not _tells(result, quantity):
            continue
        row = [heading(result.quantities[quantity])]
        for model in models:
            cell = with_bar(model.points[0], quantity, 6)
            if model is not reference and reference and reference.points:
                base = reference.points[0]
                cell += against(model.points[0], base, quantity, base[quantity])
            row.append(cell)
        rows.append(row)
    return table(["first load point"] + [escape(looks.label(m)) for m in models], rows)


def published_table(result):
    """What others give for the patch of this case; empty without any."""
    rows = published.patches(result)
    if not rows:
        return ""
    lines = [[heading(result.quantities[name])] + [plain(row[name]) if name in row else "–" for row in rows]
             for name in PATCH if any(name in row for row in rows)]
    if any("max_traction_x" in row for row in rows):
        lines.append([heading(result.quantities["max_traction_x"])] + [_at_creepage(row.get("max_traction_x"))
                                                            for row in rows])
    said = published.says(result)
    words = f"The thesis says: {escape(said)}. " if said else ""
    return (table(["published"] + [escape(row["name"]).replace(": ", ":<br>") for row in rows], lines)
            + f"<p class=hint>{words}Sources: {escape(published.sources(result))}.</p>")


def _at_creepage(entry):
    """A published value with the creepage it belongs to."""
    if entry is None:
        return "–"
    return f"{plain(entry['value'])}<br><span class=d>ξ = {plain(100 * entry['xi'])} %</span>"


def _creepage_head(models):
    """(heading, number in the key, factor) of what varies over the load points; what they share is in
    `shared_creepage`."""
    found = selection.all_keys(models)
    if any(len(key) == 1 for key in found):
        return [("load point", 0, 1)]
    return [(f"{keys.PARTS[k][1]} [{keys.PARTS[k][3]}]", k, keys.PARTS[k][2]) for k in keys.varying(found) or [0]]


def shared_creepage(models):
    """" All at η = 0.1 %.", of what is not zero and not in the table, since it is the same at every load
    point; empty if nothing is."""
    first = next(iter(selection.all_keys(models)), (0,))
    told = [k for _, k, _ in _creepage_head(models)]
    said = [f"{symbol} = {plain(factor * first[k])} {unit}" for k, (_, symbol, factor, unit) in enumerate(keys.PARTS)
            if len(first) > 1 and first[k] and k not in told]
    return f" All at {', '.join(said)}." if said else ""


def creepage_table(result, quantity):
    """A quantity of friction of every model that has friction at every creepage. Differences to the
    reference are in percent of what full sliding gives in the reference."""
    models = selection.friction_models(result)
    reference = selection.reference_for_forces(result)
    columns = _creepage_head(models)
    percent_of = result.quantities[quantity].percent_of
    rows = []
    for creepages in selection.shown_keys(models):
        row = [", ".join(plain(creepages[k] * factor) for _, k, factor in columns)]
        base = reference.at(creepages)
        for model in models:
            point = model.at(creepages)
            cell = "–" if point is None else with_bar(point, quantity)
            if point and model is not reference and base:
                sliding = full_sliding(base, percent_of, result.case["friction_coefficient"])
                cell += against(point, base, quantity, sliding or base[quantity])
            row.append(cell)
        rows.append(row)
    head = [", ".join(c[0] for c in columns)] + [escape(looks.label(m)) for m in models]
    return table(head, rows)


def cost_table(result):
    rows = []
    for model in result.models:
        other = {k: v for k, v in model.seconds.items() if k != "total"}
        parts = ", ".join(f"{escape(k)} {number(v, 3)}" for k, v in
                          sorted(other.items(), key=lambda item: -item[1]))
        name = escape(looks.label(model))
        if model.place:
            name += f"<br><span class=d>{escape(place_label(model.place))}</span>"
        rows.append([name, number(model.seconds.get('total'), 3),
                     parts or "–", f"{model.unknowns:,}".replace(",", " "),
                     f"{model.contact_elements:,}".replace(",", " "), str(len(model.points))])
    return table(["model", "seconds", "of which", "unknowns", "contact elements", "load points"], rows,
                 "left")


def points_table(result, model):
    """Every scalar of every load point, but those that are 0 in all."""
    columns = _creepage_head([model])
    names = [n for n in result.quantities
             if n != "converged" and any(p.scalars.get(n) for p in model.points)]
    rows = [[", ".join(plain(p.key[k] * f) for _, k, f in columns)]
            + [barred(p, n) for n in names] + ["yes" if p["converged"] else "no"]
            for p in map(model.at, selection.shown_keys([model]))]
    quantities = [result.quantities[n] for n in names]
    head = [(symbol(q.symbol) or escape(q.title)) + unit(q) for q in quantities]
    return table([", ".join(c[0] for c in columns)] + head + ["converged"], rows)
