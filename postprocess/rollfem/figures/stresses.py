# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stress in the bodies: measures, curves along lines and the table of the largest values of runs; and stress.html, results of
`rollfem stress` at all requested load points: depth profiles, lines, planes and the shakedown map."""
from html import escape

import numpy as np

from ..stresses import stress_measures
from . import labels, load_points, styles
from .figure import Figure
from .maps import colour_scale, filled
from .page import hint, section, under
from .tables import measured, number, plain, table


# measure: (column, label, colour). One colour per measure in a common panel.
MEASURES = [("von_mises", "von Mises", "blue"), ("tresca", "Tresca", "red"),
            ("orthogonal_shear", "orthogonal shear", "green"), ("hydrostatic", "hydrostatic", "soft")]
LARGEST = {"von_mises": "von Mises", "tresca": "Tresca", "orthogonal_shear": "orthogonal shear below the surface",
           "orthogonal_shear_surface": "orthogonal shear on the surface", "xz_range": "range of τ<sub>xz</sub> along rolling",
           "principal_1": "principal, tension"}


def _position(points):
    """Positions of the points along their line: (values, axis label)."""
    change = points[-1] - points[0]
    length = np.linalg.norm(change)
    names = (r"$x$ [mm], rolling $\rightarrow$", r"$y$ [mm], lateral", "$z$ [mm], into the wheel")
    # On a curved surface the third coordinate changes too.
    for axis in (2, 0, 1):
        if length > 0 and abs(change[axis]) > 0.995 * length:
            if axis == 2 and points[:, 2].min() * points[:, 2].max() >= 0:
                return np.abs(points[:, 2]), "depth below the origin [mm]"
            return points[:, axis], names[axis]
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)]), "distance along the line [mm]"


def along_line(curves, heading):
    """Four measures along a line; `curves`: look with a name, places [n, 3], arrays by measure; `heading`: their common
    part."""
    figure = Figure(2)
    axis_label = _position(curves[0][1])[1]
    panels = figure.charts((300, 165), [
        (f"{label} stress", axis_label, "[MPa]", 0.0,
         [(_position(points)[0], values[name], look) for look, points, values in curves]) for name, label, _ in MEASURES])
    for panel in panels:
        panel.x.margin, panel.y.limits = 0.0, (0.0, None)
    panels[-1].y.limits = (None, None)
    panels[-1].level(0, dash=())
    figure.entry(heading)
    return figure


def lines(result):
    """(number in the case from 0, kind, body) of every request for a line or along a surface."""
    found = {k: (k, part["kind"], part["body"]) for model in result.models for point in model.points
             for k, part in enumerate(point.subsurface) if part["kind"] in ("line", "surface")}
    return [found[k] for k in sorted(found)]


def of_request(result, number_of_request):
    """The stress of every model with stresses along one request of a run. None if there is none."""
    models = [m for m in result.models if any(p.subsurface for p in m.points)]
    key = load_points.typical_key(models) or (models[0].points[0].key if models else None)
    found = [(model, point.subsurface[number_of_request]) for model in models
             if (point := model.at(key)) is not None and len(point.subsurface) > number_of_request]
    if not found:
        return None
    texts, shared = load_points.key_texts(load_points.all_keys(result.models))
    return along_line([(styles.line(model), part["points"], stress_measures(part["stress"])) for model, part in found],
                      ", ".join(filter(None, (f"in the {found[0][1]['body']}", texts.get(key, ""), shared))))


def caption(kind, body):
    where = ("On the surface of" if kind == "surface" else "Along a line in")
    return (f"{where} the {body}: von Mises, Tresca and orthogonal shear stress, and the hydrostatic "
            "stress, negative in compression.")


def largest_cell(value, error, place, more=""):
    """Value, bar and place of a largest stress, with a remark on the place."""
    at = ", ".join(number(round(float(x), 2) + 0.0, 3) for x in place)
    return under(measured(value, error, 4), f"at ({at}) mm{more}")


def largest_table(heads, cell_of):
    """The largest stresses of both bodies, with a column per head; cell_of(column, body, measure) is None for a missing
    value. Empty without values."""
    rows = []
    for body in ("wheel", "rail"):
        for measure, name in LARGEST.items():
            cells = [cell_of(column, body, measure) for column in range(len(heads))]
            if any(cells):
                rows.append([f"{body}: {name} [MPa]", *(cell or "–" for cell in cells)])
    return table(["largest", *heads], rows) if rows else ""


def maxima_table(result):
    """The largest stresses over all load points of a run, with places; empty if there are none."""
    models = [m for m in result.models if any(p.stress_maxima for p in m.points)]

    def cell(column, body, measure):
        found = [(m["value"], m["place"], p) for p in models[column].points for m in p.stress_maxima
                 if (m["body"], m["measure"]) == (body, measure)]
        if not found:
            return None
        value, place, point = max(found, key=lambda row: row[0])
        more = "" if len(models[column].points) < 2 else f", {point.by_number} {point.key[0]}" if point.by_number else (
            f", ξ = {plain(100 * point['longitudinal_creepage'])} %")
        name = f"max_{measure}_{body}"
        return largest_cell(value, point.error_estimate.get(name, point.no_bar.get(name, "")), place, more)

    return largest_table([escape(styles.label(m)) for m in models], cell)


KINDS = (("line", (7.5, 3), "line contact"), ("circle", (1.5, 1.5), "circular contact"))


def shakedown_panel(figure, title, bounds, factors):
    """Adds the panel of a shakedown map: load factor p0/k against tangential coefficient with its boundaries (StressResult)
    and room for these load factors."""
    panel = figure.add(440, 300, title, "tangential force over normal force $T/F_z$ [-]", "load factor $p_0/k$ [-]")
    at, top = bounds["tangential_coefficient"], max([5.2] + [1.15 * factor for factor in factors])
    panel.x.limits, panel.y.limits = (0.0, max(at)), (0.0, top)
    if "ellipse_shakedown" in bounds:
        ratio = bounds["ellipse_ratio"]  # None: a line contact
        panel.line(at, bounds["ellipse_shakedown"], "ink", 1.8, name="shakedown limit of "
                   + ("this line contact" if ratio is None else f"the ellipse, $b/a$ = {ratio:.3g}"))
    for kind, dash, name in KINDS:
        panel.line(at, bounds[f"{kind}_shakedown"], "soft", 1.1, dash, name=f"shakedown limit, {name}")
        panel.line(at, bounds[f"{kind}_elastic"], "sky", 1.1, dash, name=f"elastic limit, {name}")
    panel.text(0.012, 0.3, "elastic")
    if top < 6:  # otherwise there is no space between the limits
        panel.text(0.008, 3.2, "elastic shakedown")
    panel.text(0.97, 0.93, "plastic flow at every pass", "end", share=(True, True))
    return panel


DASHES = [(), (7.5, 2.3), (1.5, 1.5), (6, 1.5, 1.5, 1.5)]
# Colours of the load points of one model, from the first on.
POINT_COLOURS = ["blue", "red", "green", "pink", "amber", "sky", "brown", "violet", "wine", "forest"]
MOST_FIGURES = 40  # of each kind


def load_point(model):
    """Label of the drawn load point of the model."""
    key = tuple(model.data[name] for name in ("longitudinal_creepage", "lateral_creepage", "spin"))
    return f"step {model.data['step']}" if model.data["step"] else load_points.key_texts([key])[0][key]


def entry_name(result, model):
    """The distinguishing part of an entry: its model, its load point, or both."""
    models, points = ({key(m) for m in result.models} for key in (styles.label, load_point))
    return ", ".join(([styles.label(model)] if len(models) > 1 or len(points) < 2 else [])
                     + ([load_point(model)] if len(points) > 1 else []))


def _shared(result):
    """The common load point, or empty."""
    points = {load_point(m) for m in result.models}
    return points.pop() if len(points) == 1 else ""


def _by_name(result, prefix):
    """{(name, body): [(number, model, set)]} of the sets whose names begin with a prefix (or one of several), for some
    of the names, in order."""
    names = dict.fromkeys(s.name for m in result.models for s in m.sets if s.name.startswith(prefix))
    found = {(name, body): [(k, m, m.set(name, body)) for k, m in enumerate(result.models) if m.set(name, body)]
             for name in list(names)[:MOST_FIGURES] for body in ("wheel", "rail")}
    return {key: sets for key, sets in found.items() if sets}


def depth_profile(result, by_body):
    """Stresses down from the surface, {body: sets (_by_name)}: the measures of a body in one panel, or one panel each
    for several models or load points."""
    several = len(result.models) > 1
    looks = _looks(result)
    figure = Figure(len(MEASURES) if several else 2, in_rows=several)
    for body, parts in by_body.items():
        spot = [f"{v:.2f}".replace("-", "−") if abs(v) >= 5e-3 else "0" for v in (parts[0][2][c][0] for c in "xy")]
        place = f"{body}, under x = {spot[0]}, y = {spot[1]} mm"
        if not several:
            panel = _depth_panel(figure, 270, place, "stress [MPa]")
        for column, label, ink in MEASURES:
            if several:
                panel = _depth_panel(figure, 210, place, f"{label} [MPa]")
            for number, model, part in parts:
                look = {**looks[number], "name": entry_name(result, model)} if several else {"colour": ink, "name": label}
                panel.line(part[column], part["distance"], **look)
    figure.entry(_shared(result))
    return figure


def _depth_panel(figure, width, title, label):
    panel = figure.add(width, 300, title, label, "depth below the surface [mm]")
    panel.y.flipped, panel.y.limits, panel.y.margin = True, (0.0, None), 0.0
    panel.level(0, dash=(), upright=True)
    return panel


def _looks(result):
    """The look of each entry: of its model if models differ, otherwise a colour for each load point."""
    if len({m.name for m in result.models}) == len(result.models):
        return [styles.line(m) for m in result.models]
    names, points = (list(dict.fromkeys(map(of, result.models))) for of in (lambda m: m.name, load_point))
    return [{"colour": POINT_COLOURS[points.index(load_point(m)) % len(POINT_COLOURS)],
             "dash": DASHES[names.index(m.name) % len(DASHES)]} for m in result.models]


def along_request(result, body, parts):
    """Four measures along a line, with one look for every model and load point."""
    looks = _looks(result)
    return along_line(
        [({**looks[place], "name": entry_name(result, model)}, np.stack([part[axis] for axis in "xyz"], axis=1),
          part.columns) for place, model, part in parts],
        ", ".join(filter(None, (f"in the {body}", _shared(result)))))


def _lattice(part):
    """In-plane coordinates [across, along] of a plane, with their labels: the global coordinate for a side along an
    axis, otherwise the distance along the side; of a skew parallelogram the distance across its first side."""
    points = np.array([part[c].reshape(part.shape) for c in ("x", "y", "z")])
    offset = points - points[:, :1, :1]
    sides, found = [], []
    for change, name in ((offset[:, 0, -1], "first side [mm]"), (offset[:, -1, 0], "second side [mm]")):
        side = change / np.linalg.norm(change)
        axis = int(np.argmax(np.abs(side)))
        if abs(side[axis]) > 0.999999:
            found.append((axis, points[axis], f"${'xyz'[axis]}$ [mm]"))
        else:
            found.append((-1, np.tensordot(side, offset, 1), name))
        sides.append(side)
    if abs(np.dot(*sides)) > 1e-6:
        along = np.tensordot(sides[0], offset, 1)
        across = np.linalg.norm(offset - sides[0][:, None, None] * along, axis=0)
        return along, across, "first side [mm]", "across it [mm]"
    if found[0][0] > found[1][0] >= 0:  # x to the right, z up
        found.reverse()
    return found[0][1], found[1][1], found[0][2], found[1][2]


def plane(model, part):
    """Filled contours of four measures on a plane."""
    right, up, right_label, up_label = _lattice(part)
    figure = Figure(4, f"{styles.label(model)}, {part.body}, {load_point(model)}", in_rows=True)
    wide, high = np.ptp(right), max(np.ptp(up), 1e-9)
    for column, label, _ in MEASURES:
        values = part[column].reshape(part.shape)
        panel = figure.add(min(300.0, 330.0 * wide / high), 0, f"{label} stress [MPa]", right_label, up_label, equal=True)
        panel.x.limits, panel.y.limits = (right.min(), right.max()), (up.min(), up.min() + high)
        levels, step = filled(panel, right, up, values)
        peak = np.unravel_index(np.argmax(values), values.shape)
        for ink, size in (("ground", 4.4), ("ink", 3.6)) if column != "hydrostatic" else ():
            panel.spots([(right[peak], up[peak])], colour=ink, marker="x", size=size, order=4)
        panel.fit()
        colour_scale(figure, levels, step, panel.height)
    return figure.tell("", [f"{label} stress {part[column].min():.4g} to {part[column].max():.4g} MPa"
                            for column, label, _ in MEASURES])


def _curves(result):
    """{key of a model: (model, its shakedown at all load points, numbers of the requested ones)}."""
    return {m.key: (m, m.data["shakedown"], [other.data["point"] for other in result.models if other.key == m.key])
            for m in result.models}


def shakedown_map(result):
    """Load factor against tangential coefficient: boundaries of line and circular contact, and every
    load point of every model. None without a yield stress."""
    bounds = result.data.get("shakedown_map")
    if bounds is None:
        return None
    curves = _curves(result)
    figure = Figure(1)
    panel = shakedown_panel(figure, f"yield stress in shear $k$ = {result.data['yield_shear_stress']:.4g} MPa", bounds,
                                     [p["load_factor"] for _, curve, _ in curves.values() for p in curve])
    for size, (model, curve, asked) in zip((4.5, 3.2, 2.6, 2.2) * len(curves), curves.values()):
        look = {**styles.line(model, True), "size": size}  # models that coincide stay visible
        spots = [(p["tangential_coefficient"], p["load_factor"]) for p in curve]
        chosen = [spots[number_ - 1] for number_ in asked]
        panel.spots(spots, True, hollow=True, order=4, **{**look, "name": ""})
        figure.entry(f"{look['name']} (filled: the load points of the stresses)", look["colour"], look["dash"],
                     marker=look["marker"])
        panel.spots(chosen, order=5, **{**look, "name": f"{look['name']} (filled: the load points of the stresses)"})
    return figure.tell("Shakedown map, ", [panel.seen()])


def captioned(result):
    """The figures of everything."""
    yield "shakedown_map.svg", "Shakedown map.", lambda: shakedown_map(result)
    depths = {}
    for (name, body), parts in _by_name(result, "depth_").items():
        depths.setdefault(name, {})[body] = parts
    for name, by_body in depths.items():
        yield (f"{name}.svg", "Stress against depth under the " + name[6:].replace("_", " ") + " of the patch.",
               lambda by_body=by_body: depth_profile(result, by_body))
    for (name, body), parts in _by_name(result, ("line_", "surface_")).items():
        yield (f"{name}_{body}.svg", f"Stress in the {body} along {name.replace('_', ' ')}.",
               lambda body=body, parts=parts: along_request(result, body, parts))
    several = len({m.key for m in result.models}) < len(result.models)
    for (name, body), parts in _by_name(result, "plane_").items():
        for _, model, part in parts:
            yield (f"{name}_{body}_{model.name}" + f"_{model.data['point']}" * several + ".svg",
                   f"Stress in the {body} on {name.replace('_', ' ')}; cross: the largest.",
                   lambda model=model, part=part: plane(model, part))


REGIONS = {"elastic": "nothing yields", "elastic shakedown": "yields at first, then residual stresses keep "
           "every further pass elastic", "beyond shakedown": "plastic flow at every pass"}


def _largest(result, heads):
    """The largest stresses of both bodies, a column for each model and load point."""
    def cell(column, body, measure):
        for found in result.models[column].data["maxima"]:
            if (found["body"], found["measure"]) == (body, measure):
                over = f", {number(found['over_max_pressure'], 3)} p<sub>0</sub>" if "over_max_pressure" in found else ""
                return largest_cell(found["value"], found.get("error_estimate", found.get("no_bar", "")),
                                             found["place"], over)
        return None

    return largest_table(heads, cell)


def _contacts(result, heads):
    columns = (("normal_force", 6), ("max_pressure", 5), ("max_traction", 4), ("tangential_coefficient", 4))
    return table(["load point", "F<sub>z</sub> [N]", "p<sub>0</sub> [MPa]", "largest |p<sub>t</sub>| [MPa]",
                  "T/F<sub>z</sub>"],
                 [[head, *(number(m.data[name], digits) for name, digits in columns)]
                  for head, m in zip(heads, result.models)])


def _verdicts(result, image):
    """One verdict on shakedown for every load point of every model; empty without a yield stress."""
    if "yield_shear_stress" not in result.data:
        return ""
    html = []
    for model, curve, asked in _curves(result).values():
        for point in (p for p in curve if p["point"] in asked):
            verdict = point["verdict"]
            html.append(f"<p class={'bad' if verdict.startswith('beyond') else 'say'}>{escape(styles.label(model))}, "
                        f"ξ = {plain(100 * point['longitudinal_creepage'])} %: {verdict}; {REGIONS[verdict]}; "
                        f"{point['margin'].replace('the limit', 'the shakedown limit')}.</p>")
        rows = [[plain(100 * p["longitudinal_creepage"]), number(p["tangential_coefficient"], 4),
                 number(p["load_factor"], 4), number(p["ellipse"]["shakedown"], 4),
                 number(p.get("yield_ratio"), 4), number(p["surface_fatigue_index"], 3), p["verdict"]] for p in curve]
        html.append(table([f"{escape(styles.label(model))}: ξ [%]", "T/F<sub>z</sub>", "p<sub>0</sub>/k",
                           "shakedown limit", "σ<sub>v</sub>/(√3 k)", "surface fatigue index", "verdict"], rows))
    ratio = result.models[0].data["shakedown"][0]["ellipse"]["ratio"]
    return section(f"Shakedown, k = {number(result.data['yield_shear_stress'], 4)} MPa", *html, hint(
        f"The limit is for {'a line contact' if ratio is None else f'an ellipse b/a = {number(ratio, 3)}'}, like the patch, "
        "in full slip: there the largest shear on planes parallel to the surface is k or, below narrow ellipses, the stresses "
        "of two instants of a passage differ by 2 √3 k (von Mises). First yield is judged by the largest "
        "von Mises stress σ<sub>v</sub> of this contact if known, otherwise by the lower of the elastic "
        "limits of line and circle."), image)


def page(result, drawn):
    """The page of stresses."""
    heads = [labels.html(f"{styles.label(m)}, {load_point(m)}") for m in result.models]
    return "Stress below the surface: " + escape(result.title), f"from <code>{escape(result.data['source'])}</code>", [
        section("Load points", _contacts(result, heads)), "<h2>Largest stresses</h2>", _largest(result, heads),
        hint("±: the model's own error estimate, or why there is none. Places x (along rolling), y, z (into "
             "the wheel). Tension is positive."),
        _verdicts(result, drawn("shakedown")), section("Lines and planes", drawn("depth_", "line_", "surface_", "plane_"))], (
        "Also in this folder: stress.csv with every place, stress.json, figures/.")
