"""With profiles: where the wheels touch the rails, and how that goes along a row of positions."""
import math
import os

import numpy as np

from . import looks, tables
from .figure import Figure
from .reader import read_rows

# Colours of the patches of one wheel, the most loaded first.
PATCH_COLOURS = ["red", "blue", "green", "pink"]


def first_of_scenes(result):
    """The first model of every patch."""
    return [scene.models[0] for _, scene in result.scenes()]


def positions(result):
    """Numbers of the positions in the result."""
    return sorted({m.place["position"] for m in result.models if m.place})


def _as_function(points):
    """(y, z) of a section with rising y, of an undercut side only what comes first."""
    order = np.argsort(points[:, 0], kind="stable")
    y, z = points[order].T
    keep = np.concatenate([[True], np.diff(y) > 1e-9])
    return y[keep], z[keep]


def _draw_gap(panel, figure, drawn, touching):
    """Vertical distance between rail and wheel around the contact, before they are pressed together."""
    rail, wheel = _as_function(drawn["rail"]), _as_function(drawn["wheel"])
    low, high = min(p["y_track"] for p in touching) - 20, max(p["y_track"] for p in touching) + 20
    y = np.linspace(max(rail[0][0], wheel[0][0], low), min(rail[0][-1], wheel[0][-1], high), 600)
    gap = np.interp(y, *rail) - np.interp(y, *wheel)
    panel.line(y, gap, "blue", 1.5)
    for k, place in enumerate(touching):
        ink = PATCH_COLOURS[k % len(PATCH_COLOURS)]
        panel.line([place["y_track"]], [np.interp(place["y_track"], y, gap)], ink, marker="o", size=3.6,
                   joined=False, order=5)
        figure.entry(f"patch {place['patch']:.0f}: {math.degrees(place['contact_angle']):.2f}°, radius "
                     f"{place['rolling_radius']:.3f} mm", ink, width=0, marker="o")
    panel.x.limits, panel.y.limits = (low, high), (-0.02, 0.6)


def pair(result, wheel, position):
    """Wheel on rail at one position with the contact points, and the distance between the two; None
    without profiles."""
    drawn = result.profiles.get((wheel, position))
    touching = [m.place for m in first_of_scenes(result)
                if m.place["wheel"] == wheel and m.place["position"] == position]
    if drawn is None or not touching:
        return None
    return draw_pair(drawn, touching, f"{wheel} wheel{at_words(result, position)}")


def draw_pair(drawn, touching, title):
    """`drawn`: points y, z [n, 2] of "rail" and "wheel" on the track; `touching`: dicts with patch,
    y_track, z_track (mm), contact_angle (rad), rolling_radius (mm)."""
    figure = Figure(2)
    shape = figure.add(380, 0, title, "$y$ on the track, to the right [mm]", "height [mm]", equal=True)
    for name, ink in (("rail", "ink"), ("wheel", "blue")):
        y, z = drawn[name].T
        shape.line(y, -z, ink, 1.5)
        figure.entry(name, ink, width=1.5)
    for k, place in enumerate(touching):
        shape.line([place["y_track"]], [-place["z_track"]], PATCH_COLOURS[k % len(PATCH_COLOURS)], marker="o",
                   size=3.6, joined=False, order=5)
    gap = figure.add(250, 210, "distance at the axle, unloaded", "$y$ on the track, to the right [mm]", "[mm]")
    _draw_gap(gap, figure, drawn, touching)
    figure.seen = f"{title}: " + "; ".join(
        f"patch {p['patch']:.0f} touches at y = {p['y_track']:.2f} mm under {math.degrees(p['contact_angle']):.2f}°"
        for p in touching) + "."
    return figure


def build(path):
    """Draws NAME.svg of a table NAME.csv that `rollfem profile CASE.toml` wrote."""
    title, rows = read_rows(path)
    drawn = {part: np.array([[float(row["y"]), float(row["z"])] for row in rows if row["part"] == part])
             for part in ("rail", "wheel")}
    names = {"y_track": "y", "z_track": "z", "contact_angle": "angle", "rolling_radius": "radius"}
    touching = [{"patch": float(row["part"].split()[1]), **{name: float(row[column]) for name, column in names.items()}}
                for row in rows if row["part"].startswith("patch")]
    draw_pair(drawn, touching, title).save(os.path.splitext(path)[0] + ".svg")


def force_to_the_right(model):
    """Of the wheel along y of the track at the first load point, N, from the forces in the patch's frame
    (docs/track.md)."""
    angle, tilt = model.place["contact_angle"], 1 if model.place["wheel"] == "left" else -1
    point = model.points[0]
    return -point["lateral_force"] * math.cos(angle) + tilt * point["normal_force"] * math.sin(angle)


def _curves():
    """Panels of the sweep: (title, unit, least span of the scale, value of a model's first point and
    place)."""
    return [("contact point on the rail", "$y$ of its profile [mm]", 2.0, lambda m: m.place["y_rail"]),
            ("contact point on the wheel", "$y$ of its profile [mm]", 2.0, lambda m: m.place["y_wheel"]),
            ("contact angle", "[°]", 0.5, lambda m: math.degrees(m.place["contact_angle"])),
            ("normal force", "[kN]", 1.0, lambda m: m.points[0]["normal_force"] / 1e3),
            (PRESSURE, "[MPa]", 50.0, lambda m: m.points[0]["max_pressure"]),
            ("contact area", "[mm²]", 5.0, lambda m: m.points[0]["contact_area"]),
            ("length of the patch, along rolling", "[mm]", 1.0, lambda m: m.points[0]["contact_length"]),
            ("width of the patch", "[mm]", 1.0, lambda m: m.points[0]["contact_width"]),
            ("longitudinal creepage $\\xi$", "[%]", 0.02, lambda m: 100 * m.points[0]["longitudinal_creepage"]),
            ("spin $\\varphi$", "[rad/m]", 0.02, lambda m: 1e3 * m.points[0]["spin"]),
            (FORCES[0], "[kN]", 0.2, lambda m: m.points[0]["longitudinal_force"] / 1e3),
            (FORCES[1], "[kN]", 0.2, lambda m: force_to_the_right(m) / 1e3)]


PRESSURE = "largest pressure"
FORCES = ("$F_x$ on the wheel", "force to the right on the wheel")  # those of all its patches


def along(result):
    """What a row of positions is drawn over: (values by position, axis label): the lateral shift, else
    the yaw, in which no two are alike; else their numbers."""
    at = {m.place["position"]: m.place for m in result.models if m.place}
    for name, factor, label in (("lateral_shift", 1.0, "lateral shift of the wheelset [mm]"),
                                ("yaw", 1e3, "yaw of the wheelset [mrad]")):
        values = {number: factor * place[name] for number, place in at.items()}
        if len({round(v, 9) for v in values.values()}) == len(values) > 1:
            return values, label
    return {number: number for number in at}, "position"


def at_words(result, position):
    """" at a lateral shift of 3 mm", where one of a row of positions is; empty of a single one."""
    at, label = along(result)
    if len(at) < 2:
        return ""
    what, _, unit = label.rstrip("]").partition(" of the wheelset [")
    return f" at a {what} of {tables.plain(at[position])} {unit}" if unit else f" at position {position:.0f}"


WHEELS = (("left", (), False), ("right", (5, 2.5), True))  # wheel, dash, hollow markers


def reference_of_row(result):
    """Name of the model that rows are drawn of: one that has most places (Hertz cannot take every patch), of
    those the reference."""
    names = list(dict.fromkeys(m.name for m in result.models if m.points and m.place))
    wished = [name for name in (result.reference, "halfspace", "hybrid", "fem") if name in names] + names
    return max(wished, key=lambda name: sum(m.name == name for m in result.models))


def _row(title, models, at, value):
    """[(spots (where, value), whether a line joins them)] of one model and wheel: the sum over its patches of a force,
    else the most loaded patch, then the others."""
    spots = [(at[m.place["position"]], value(m), m.place["patch"] == 1) for m in models]
    if title in FORCES:
        return [(sorted((where, sum(v for w, v, _ in spots if w == where)) for where in {w for w, *_ in spots}), True)]
    return [(sorted((w, v) for w, v, first in spots if first == joined), joined) for joined in (True, False)]


def sweep(result):
    """Contact point, angle, load, pressure, patch, creepages and forces of both wheels over the positions;
    None for fewer than 3."""
    if len(positions(result)) < 3:
        return None
    at, label = along(result)
    models = [m for m in result.models if m.points and "vermeulen" not in m.name]
    reference = reference_of_row(result)
    figure = Figure(3)
    names = list(dict.fromkeys(m.name for m in models))
    series = {}  # {(name, wheel): (models, look)}
    for name in names:
        for wheel, dash, hollow in WHEELS:
            here = [m for m in models if (m.name, m.place["wheel"]) == (name, wheel)]
            look = {"dash": dash, "width": 1.2, "marker": looks.marker(name), "hollow": hollow}
            series[name, wheel] = here, {"colour": looks.of_model(name)[0], **look}
            if any(m.place["wheel"] == wheel for m in models):
                figure.entry(f"{looks.label(name)}, {wheel} wheel", looks.of_model(name)[0], **look)

    def curves(title, value):
        for (name, _), (here, look) in series.items():
            if (name == reference or title in (PRESSURE, *FORCES)) and (
                    title not in FORCES or any(m.has_friction for m in here)):
                for spots, joined in _row(title, here, at, value):
                    if spots:
                        yield (*zip(*spots), {**look, "size": 2.8, "joined": joined})

    figure.charts((250, 165), [(title, label, unit, least, curves(title, value)) for title, unit, least, value in _curves()])
    ends = f"{label} from {min(at.values()):.4g} to {max(at.values()):.4g}"
    peak = max((m.points[0]["max_pressure"], at[m.place["position"]], m.place["wheel"]) for m in models
               if m.name == reference)
    figure.seen = (f"Contact points, contact angle, normal force, pressure, patch, creepages and forces over the {ends}. "
                   f"The largest pressure, {peak[0]:.4g} MPa, is at {peak[1]:.4g} on the {peak[2]} wheel.")
    return figure


def contact_table(result):
    """One row for every patch: where it is and what the models make of it."""
    models = result.models
    names = list(dict.fromkeys(m.name for m in models))
    head = ["wheel", "position", "patch", "shift [mm]", "yaw [mrad]", "roll [mrad]", "y track [mm]", "y rail [mm]",
            "y wheel [mm]", "angle [°]", "radius [mm]", "F<sub>n</sub> [N]"]
    head += [f"p<sub>0</sub> {looks.label(next(m for m in models if m.name == n))} [MPa]" for n in names]
    rows = []
    for _, scene in result.scenes():
        place = scene.models[0].place
        point = scene.models[0].points[0]
        row = [place["wheel"], f"{place['position']:.0f}", f"{place['patch']:.0f}",
               tables.plain(place["lateral_shift"]), tables.plain(1e3 * place["yaw"]),
               tables.number(1e3 * place["roll"], 4)]
        row += [tables.number(place[k], d) for k, d in
                (("y_track", 7), ("y_rail", 5), ("y_wheel", 5))]
        row += [tables.number(math.degrees(place["contact_angle"]), 4),
                tables.number(place["rolling_radius"], 7), tables.barred(point, "normal_force")]
        for name in names:
            found = [m for m in scene.models if m.name == name and m.points]
            row.append(tables.barred(found[0].points[0], "max_pressure") if found else "–")
        rows.append(row)
    return tables.table(head, rows)
