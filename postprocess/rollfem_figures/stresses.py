"""Stress in the bodies: along the lines that the case asks for, and the largest values."""
from html import escape

import numpy as np

from . import keys, looks, selection
from .figure import Figure
from .tables import measured, number, plain, table


def measures(stress):
    """Scalars of stresses [n, 6] (xx yy zz xy yz xz, MPa): von Mises, Tresca (difference of the outer
    principal stresses), hydrostatic (mean, negative in compression) and orthogonal shear stress."""
    xx, yy, zz, xy, yz, xz = np.asarray(stress, dtype=float).T
    principal = np.linalg.eigvalsh(
        np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2))
    return {
        "von_mises": np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
                             + 3 * (xy ** 2 + yz ** 2 + xz ** 2)),
        "tresca": principal[..., 2] - principal[..., 0],
        "orthogonal_shear": np.hypot(xz, yz),
        "hydrostatic": (xx + yy + zz) / 3,
    }


PANELS = [("von_mises", "von Mises stress"), ("tresca", "Tresca stress"),
          ("orthogonal_shear", "orthogonal shear stress"), ("hydrostatic", "hydrostatic stress")]


def lines(result):
    """(number in the case from 0, kind, body) of every request that is a line or follows a surface."""
    found = {}
    for model in result.models:
        for point in model.points:
            for k, part in enumerate(point.subsurface):
                if part["kind"] in ("line", "surface"):
                    found[k] = (k, part["kind"], part["body"])
    return [found[k] for k in sorted(found)]


def _position(points):
    """Where the points are along their line: (values, axis label)."""
    change = points[-1] - points[0]
    length = np.linalg.norm(change)
    names = (r"$x$ [mm], rolling $\rightarrow$", r"$y$ [mm], lateral", "depth below the origin [mm]")
    # The third coordinate of a line on a curved surface changes, too.
    for axis in (2, 0, 1):
        if length > 0 and abs(change[axis]) > 0.995 * length:
            return (np.abs(points[:, 2]) if axis == 2 else points[:, axis]), names[axis]
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)]), "distance along the line [mm]"


def load_point(result):
    """The key of the load point that is drawn, None when no model has stresses."""
    models = [m for m in result.models if any(p.subsurface for p in m.points)]
    if not models:
        return None
    key = selection.typical_key(models)
    return models[0].points[0].key if key is None else key


def along_line(result, number_of_request):
    """Four measures of stress of every model that has them, along one request. None when none has."""
    key = load_point(result)
    drawn = []
    for model in result.models:
        point = model.at(key) if key is not None else None
        if point is not None and len(point.subsurface) > number_of_request:
            drawn.append((model, point.subsurface[number_of_request]))
    if not drawn:
        return None
    figure = Figure(2)
    axis_label = _position(drawn[0][1]["points"])[1]
    for name, text in PANELS:
        panel = figure.add(300, 165, text, axis_label, "[MPa]")
        panel.x.margin = 0.0
        if name == "hydrostatic":
            panel.level(0, dash=())
        else:
            panel.y.limits = (0.0, None)
        for model, part in drawn:
            panel.line(_position(part["points"])[0], measures(part["stress"])[name], **looks.line(model))
    for model, _ in drawn:
        figure.entry(looks.label(model), *looks.of_model(model)[:2])
    texts, shared = keys.key_texts(selection.all_keys(result.models))
    heading = ", ".join(t for t in (f"in the {drawn[0][1]['body']}", texts.get(key, ""), shared) if t)
    figure.entry(heading)
    figure.seen = f"Stress {heading}, along {axis_label}: " + "; ".join(
        f"{looks.label(m)} von Mises up to {measures(part['stress'])['von_mises'].max():.4g} MPa"
        for m, part in drawn) + "."
    return figure


def caption(kind, body):
    where = ("On the surface of" if kind == "surface" else "Along a line in")
    return (f"{where} the {body}: von Mises, Tresca and orthogonal shear stress, and the hydrostatic "
            "stress, negative in compression.")


NAMES = {"von_mises": "von Mises", "tresca": "Tresca", "orthogonal_shear": "orthogonal shear",
         "principal_1": "principal, tension"}


def _largest(model, body, measure):
    """(value, place, bar or why there is none, point) of the load point where it is largest, or None."""
    found = [(m["value"], m["place"], p.errors.get(f"max_{measure}_{body}", p.no_bar.get(f"max_{measure}_{body}", "")), p)
             for p in model.points for m in p.stress_maxima
             if m["body"] == body and m["measure"] == measure]
    return max(found, key=lambda row: row[0]) if found else None


def maxima_table(result):
    """The largest stresses of both bodies over all load points, with places; empty without any."""
    models = [m for m in result.models if any(p.stress_maxima for p in m.points)]
    if not models:
        return ""
    rows = []
    for body in ("wheel", "rail"):
        for measure, name in NAMES.items():
            row = [f"{body}: {name} [MPa]"]
            for model in models:
                best = _largest(model, body, measure)
                if best is None:
                    row.append("–")
                    continue
                value, place, error, point = best
                at = ", ".join(number(round(float(x), 2) + 0.0, 3) for x in place)
                html = measured(value, error, digits=4) + f"<br><span class=d>at ({at}) mm"
                if len(model.points) > 1:
                    html += (f", load point {plain(point.key[0])}" if point.by_number
                             else f", ξ = {plain(100 * point['longitudinal_creepage'])} %")
                row.append(html + "</span>")
            rows.append(row)
    return table(["largest"] + [escape(looks.label(m)) for m in models], rows)
