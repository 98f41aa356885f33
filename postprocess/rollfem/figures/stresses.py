# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stress in the bodies: measures, curves along lines and the table of the largest values, for runs and for `rollfem
stress`."""
from html import escape

import numpy as np

from ..stresses import stress_measures
from . import load_points, styles
from .figure import Figure
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
    return f"{measured(value, error, 4)}<br><span class=d>at ({at}) mm{more}</span>"


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
