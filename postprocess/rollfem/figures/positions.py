# SPDX-License-Identifier: LGPL-2.1-or-later
"""With profiles: the contacts of wheels and rails, also along a sweep of positions. And a wheelset over its lateral
shift: difference of rolling radii, contact angles and equivalent conicity, from the table of `rollfem wheelset`
(wheelset.csv) or of a run with a lateral sweep (wheelset_rigid.csv; its wheelset.csv has the loaded patches of each
position)."""
import itertools
import math
import os
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ..files import read_rows
from ..reader import read_columns
from . import curves, load_points, styles, tables
from .figure import Figure
from .page import under
from .profiles import PATCH_COLOURS, draw_pair


def is_history(result):
    """Whether the positions of a wheel follow each other."""
    return len(positions(result)) > 1 and any(m.points and m.points[0]["step"] for m in result.models)


def positions(result):
    """Numbers of the positions in the result."""
    return sorted({m.place["position"] for m in result.models if m.place})


def shown(result):
    """The patches shown one by one: in a history those of the steps whose fields are stored."""
    scenes = result.scenes()
    return [(label, scene) for label, scene in scenes if any(m.points and m.points[0].fields for m in scene.models)] if (
        is_history(result)) else scenes


def pair(result, wheel, position):
    """Wheel on rail at one position with the contact points, and the distance between both; None without profiles."""
    drawn = result.profiles.get((wheel, position))
    places = [scene.models[0].place for _, scene in result.scenes()]
    touching = [place for place in places if (place["wheel"], place["position"]) == (wheel, position)]
    return draw_pair(drawn, touching, f"{wheel} wheel{at_words(result, position)}") if drawn and touching else None


BESIDE = 12.0  # mm of the profiles shown beside what wears


def work(result, wheel, position):
    """The frictional work per pass over wheel and rail as they are drawn, of every model and patch at the load point with
    the largest, or after the last pass; None without work."""
    drawn = result.profiles.get((wheel, position))
    models = curves.with_work(m for m in result.models if (m.place["wheel"], m.place["position"]) == (wheel, position))
    if not drawn or not models:
        return None
    key = load_points.last_pass(models) or max((p for p in models[0].points if p.pass_work is not None),
                                               key=lambda p: p.pass_work.max()).key
    figure = Figure(1)
    shape = figure.add(560, 0, f"{wheel} wheel{at_words(result, position)}", "", "height [mm]", equal=True)
    below = figure.add(560, 170, load_points.key_texts([key])[0][key], "$y$ on the track, to the right [mm]", curves.WORK)
    wearing = []
    for model in models:
        if (point := model.at(key)) and point.pass_work is not None:
            across = model.place["y_track"] - model.y * math.cos(model.place["contact_angle"])
            below.line(across, point.pass_work, **styles.line(model))
            wearing += [across[point.pass_work > 0]]
    wearing = np.concatenate(wearing)
    limits = (wearing.min() - BESIDE, wearing.max() + BESIDE)
    near = [part[(part[:, 0] > limits[0]) & (part[:, 0] < limits[1])] for part in (drawn["rail"], drawn["wheel"])]
    for part, name, ink in zip(near, ("rail", "wheel"), ("ink", "soft")):
        shape.line(part[:, 0], -part[:, 1], ink, 1.5, name=name)
    shape.x.limits = below.x.limits = limits
    touched = [-model.place["z_track"] for model in models]
    shape.y.limits = (max(min(-part[:, 1].max() for part in near) - 1, min(touched) - 0.5 * BESIDE),
                      min(max(-part[:, 1].min() for part in near) + 1, max(touched) + 0.5 * BESIDE))
    below.y.limits = (0.0, None)
    if temperatures := [point["max_temperature"] for model in models if (point := model.at(key)) and "max_temperature" in point.scalars]:
        figure.entry(f"largest temperature {max(temperatures):.0f} °C")
    shape.room_left = below.room_left = 64  # one below the other
    return figure


PRESSURE = "largest pressure"
FORCES = ("$F_x$ on the wheel", "$Y$ on the wheel, to the right")  # summed over all its patches


def _at(name, factor=1.0):
    """A scalar of a model's first load point or of its place, scaled by a factor."""
    return lambda model: factor * (model.place[name] if name in model.place else model.headline[name])


# Panels of the sweep: title, unit, least span of the scale, value of a model.
PANELS = ((PRESSURE, "[MPa]", 50.0, _at("max_pressure")),
          ("contact point on the rail", "$y$ of its profile [mm]", 2.0, _at("y_rail")),
          ("contact point on the wheel", "$y$ of its profile [mm]", 2.0, _at("y_wheel")),
          ("contact angle", "[°]", 0.5, _at("contact_angle", 180 / math.pi)),
          ("normal force", "[kN]", 1.0, _at("normal_force", 1e-3)),
          ("contact area", "[mm²]", 5.0, _at("contact_area")),
          ("length of the patch, along rolling", "[mm]", 1.0, _at("contact_length")),
          ("width of the patch", "[mm]", 1.0, _at("contact_width")),
          ("longitudinal creepage $\\xi$", "[%]", 0.02, _at("longitudinal_creepage", 100)),
          ("spin $\\varphi$", "[rad/m]", 0.02, _at("spin", 1e3)),
          (FORCES[0], "[kN]", 0.2, _at("longitudinal_force", 1e-3)),
          (FORCES[1], "[kN]", 0.2, _at("lateral_force_track", 1e-3)))


class Abscissa(NamedTuple):
    """What a sweep of positions is drawn over: the values by position, their name and unit, whose they are, and whether
    bodies change along it."""
    at: dict[int, float]
    what: str
    unit: str = ""
    of: str = ""
    is_way: bool = False

    @property
    def label(self):
        return self.what + f" of the {self.of}" * bool(self.of) + f" [{self.unit}]" * bool(self.unit)


def along(result):
    """The first abscissa whose values all differ: distance rolled in a history, position along the track, angle of the
    wheel, lateral shift, yaw; otherwise the position numbers."""
    places = {m.place["position"]: m.place for m in result.models if m.place}
    rolled = {m.place["position"]: m.points[0]["distance"] for m in result.models if m.place and m.points}
    if is_history(result) and len(set(rolled.values())) == len(places) > 1:
        return Abscissa(rolled, "distance rolled", "mm", "", True)
    of = "wheel" if "placement.side" in result.inputs else "wheelset"
    for name, factor, *words in (("track_position", 1.0, "position along the track", "mm", "", True),
                                 ("wheel_angle", 1.0, "angle", "rad", "wheel", True),
                                 ("lateral_shift", 1.0, "lateral shift" if of == "wheelset" else "lateral position", "mm", of),
                                 ("yaw", 1e3, "yaw", "mrad", of)):
        values = {number: factor * place.get(name, 0.0) for number, place in places.items()}
        if len({round(v, 9) for v in values.values()}) == len(values) > 1:
            return Abscissa(values, *words)
    return Abscissa({number: number for number in places}, "position")


def at_words(result, position):
    """" at a lateral shift of 3 mm" for a position of a sweep; empty for a single position."""
    over = along(result)
    if len(over.at) < 2:
        return ""
    return (f" at a{'n' * over.what.startswith('a')} {over.what} of {tables.plain(over.at[position])} {over.unit}" if over.unit
            else f" at position {position:.0f}")


WHEELS = (("left", (), False), ("right", (5, 2.5), True))  # wheel, dash, hollow markers


def reference_of_row(result):
    """Name of the model drawn in sweeps: the one with most places (Hertz cannot take every patch), among equals the
    reference."""
    names = [m.name for m in load_points.by_reference(result, [m for m in result.models if m.points and m.place])]
    return max(names, key=names.count)


def _pressure_bars(models):
    return [m.headline.bar("max_pressure") or 0.0 for m in models]


def _by_patch(title, value, here, at, look):
    """Curves of one model and wheel (x, y, look): the sum over its patches for a force, otherwise the most loaded patch,
    joined by a line, then the others."""
    if title in FORCES and not any(m.has_friction for m in here):
        return
    spots = [(at[m.place["position"]], value(m), m.place["patch"] == 1, m) for m in here]
    rows = [(sorted((w, v, k) for k, (w, v, first, _) in enumerate(spots) if first == joined), joined) for joined in (True, False)]
    if title in FORCES:
        rows = [(sorted((where, sum(v for w, v, *_ in spots if w == where), 0) for where in {w for w, *_ in spots}), True)]
    for row, joined in rows:
        if row:
            x, y, numbers = zip(*row)
            bars = {"bars": _pressure_bars([spots[k][3] for k in numbers])} if title == PRESSURE else {}
            yield x, y, {**look, "joined": joined, **bars}


# Panels of positions that follow each other, as PANELS.
SLIP = "share of slip"
PANELS_OF_HISTORY = (*PANELS[8:10], (
    SLIP, "of the contact area [%]", 5.0,
    lambda model: 100.0 * (1.0 - model.headline["adhesion_area"] / model.headline["contact_area"])))

def _height(model):
    """mm, down, of the wheel under its load."""
    return model.headline.scalars.get("loaded_height", model.place["height"])


# Panels of a sweep along the way, as PANELS.
HEIGHT, LOAD = "height of the wheel", "vertical force"
PANELS_ALONG = (
    PANELS[0], PANELS[4],
    (HEIGHT, "under load, up [mm]", 0.2, lambda model: -_height(model)),
    (LOAD, "[kN]", 1.0, _at("vertical_force", 1e-3)), *PANELS[1:3],
    ("place along the track", "ahead of the axle [mm]", 2.0, _at("x_track")),
    ("slope of the contact plane along the track", "up ahead [mrad]", 1.0, _at("climb", 1e3)),
    PANELS[3], *(panel for panel in PANELS if panel[0] in ("contact area", *FORCES)))
FARTHEST = 10.0  # mm, across the rail, between the places of one contact at neighbouring positions


def followed(models):
    """The places of one wheel as contacts that move along: [[model]], nearest neighbours from position to position."""
    contacts = []
    numbers = sorted({m.place["position"] for m in models})
    for before, here in zip([None, *numbers], numbers):
        open_ends = [contact for contact in contacts if contact[-1].place["position"] == before]
        new = [m for m in models if m.place["position"] == here]
        steps = sorted((math.hypot(*(contact[-1].place[axis] - model.place[axis] for axis in ("y_rail", "x_track"))), a, b)
                       for a, contact in enumerate(open_ends) for b, model in enumerate(new)
                       if abs(contact[-1].place["y_rail"] - model.place["y_rail"]) < FARTHEST)  # at a flat x jumps
        met, taken = set(), set()
        for _, a, b in steps:
            if a not in met and b not in taken:
                open_ends[a].append(new[b])
                met.add(a), taken.add(b)
        contacts += [[model] for b, model in enumerate(new) if b not in taken]
    return contacts


def _by_contact(title, value, here, at, look):
    """The same of a sweep along the way: a line for each contact that moves along, or for the whole wheel."""
    words = [look["name"]] * bool(look["name"])
    if title in (HEIGHT, LOAD, *FORCES):  # of the wheel
        total = {m.place["position"]: 0.0 for m in here}
        for m in here:
            total[m.place["position"]] = value(m) + (title != HEIGHT) * total[m.place["position"]]
        spots = sorted((at[number], sum_) for number, sum_ in total.items())
        yield (*zip(*spots), {**look, "name": ", ".join([*words, "whole wheel"])})
        return
    for number, contact in enumerate(followed(here)):
        y = [m.place["y_rail"] for m in contact]
        if title == PRESSURE:
            look = {**look, "bars": _pressure_bars(contact)}
        span = f"contact at y = {' to '.join(dict.fromkeys(f'{end:.0f}' for end in (min(y), max(y))))} mm on the rail"
        yield ([at[m.place["position"]] for m in contact], [value(m) for m in contact],
               {**look, "colour": PATCH_COLOURS[number % len(PATCH_COLOURS)], "name": ", ".join([*words, span])})


def sweep(result):
    """Contact point, angle, load, pressure, patch, creepages and forces of both wheels over the positions, along the way
    load, place and pressure of each contact; None for fewer than 3."""
    if len(positions(result)) < 3:
        return None
    over, reference = along(result), reference_of_row(result)
    models = [m for m in result.models if m.headline]
    names, sides = list(dict.fromkeys(m.name for m in models)), {m.place["wheel"] for m in models}

    def look(name, wheel, dash, hollow):
        words = [styles.label(name)] * (len(names) > 1 or not over.is_way) + [
            f"{wheel} wheel"] * (len(sides) > 1 or not over.is_way)
        own = {"marker": styles.of_model(name)[2], "dash": dash * (len(sides) > 1), "width": 1.3} if over.is_way else {
            **styles.line(name, True), "dash": dash, "width": 1.2}
        return {**own, "hollow": hollow, "size": 2.8, "name": ", ".join(words)}

    def curves(title, value):
        for name, wheel in itertools.product(names, WHEELS):
            here = [m for m in models if (m.name, m.place["wheel"]) == (name, wheel[0])]
            if here and (name == reference or title in (PRESSURE, *FORCES)):
                yield from (_by_contact if over.is_way else _by_patch)(title, value, here, over.at, look(name, *wheel))

    figure, panels = Figure(3), PANELS
    if over.is_way:
        given = LOAD if "load.vertical_force" in result.inputs else HEIGHT
        panels = [panel for panel in (*PANELS_ALONG, *PANELS_OF_HISTORY * is_history(result)) if panel[0] != given and (
            panel[0] not in FORCES or any(m.has_friction for m in models))]
    if all("max_temperature" in m.points[0].scalars for m in models):
        panels = (*panels, ("largest temperature", "[°C]", 5.0, _at("max_temperature")))
    for panel in figure.charts((250, 165), [
            (title, over.label, unit, least, curves(title, value)) for title, unit, least, value in panels]):
        if over.is_way and panel.title == "normal force":  # so that a transfer of load is seen as one
            panel.y.limits = (0.0, None)
    return figure


def plan(result):
    """The patches of all positions on the rail from above, for a way along the track; None otherwise."""
    over = along(result)
    if not over.is_way or over.unit != "mm" or len(over.at) < 3:
        return None
    reference, figure = reference_of_row(result), Figure(1)
    models = [m for m in result.models if m.name == reference and m.headline]
    panel = figure.add(560, 0, "patches on the rail, from above", over.label, "$y$ of the rail's profile [mm]", equal=True)
    turn, corners = np.linspace(0, 2 * np.pi, 41), []
    for wheel, *_ in WHEELS:
        for number, contact in enumerate(followed([m for m in models if m.place["wheel"] == wheel])):
            rings = [np.stack([over.at[m.place["position"]] + m.place["x_track"] + 0.5 * m.headline["contact_length"] * np.cos(turn),
                               m.place["y_rail"] + 0.5 * m.headline["contact_width"] * np.sin(turn)], axis=1) for m in contact]
            colour = PATCH_COLOURS[number % len(PATCH_COLOURS)]
            panel.area(rings, colour, 0.25)
            panel.paths(rings, colour, 1.2)
            corners += rings
    low, high = np.min(corners, axis=(0, 1)), np.max(corners, axis=(0, 1))
    panel.x.limits, panel.y.limits = (low[0] - 3, high[0] + 3), (low[1] - 3, high[1] + 3)
    return figure.tell("Patches on the rail from above: ", [f"{over.label} {low[0]:.4g} to {high[0]:.4g}, y {low[1]:.4g} to {high[1]:.4g} mm"])


def dip_rows(result, columns):
    """Rows of a table with so many columns of numbers."""
    return [row for dip in result.dips if dip["model"] == reference_of_row(result) for row in (
        [f"{dip['wheel']} wheel lowest, under load [mm down]", *[""] * (columns - 1), under(
            tables.number(dip["loaded_height"], 3), f"at {tables.plain(dip['track_position'])} mm")],
        [under("dip angle [mrad]", "steepest fall before it and rise after it, together"), *[""] * (columns - 1),
         tables.number(1e3 * dip["dip_angle"], 3)])]


# Columns of the table of contacts: heading, member of the place, factor, significant digits (None: as given).
COLUMNS = (("shift [mm]", "lateral_shift", 1, None), ("yaw [mrad]", "yaw", 1e3, None), ("roll [mrad]", "roll", 1e3, 4),
           ("y track [mm]", "y_track", 1, 7), ("y rail [mm]", "y_rail", 1, 5), ("y wheel [mm]", "y_wheel", 1, 5),
           ("angle [°]", "contact_angle", 180 / math.pi, 4), ("radius [mm]", "rolling_radius", 1, 7))


def contact_table(result):
    """One row for every patch: its place and the results of the models."""
    names = list(dict.fromkeys(m.name for m in result.models))
    over, rows = along(result), []
    columns = [column for column in COLUMNS if any(abs(m.place[column[1]]) > 1e-12 for m in result.models)]
    for _, scene in shown(result):
        place, found = scene.models[0].place, {m.name: m.headline for m in reversed(scene.models) if m.headline}
        rows.append([place["wheel"], tables.plain(over.at[place["position"]]), f"{place['patch']:.0f}",
                     *(tables.number(factor * place[name], digits) for _, name, factor, digits in columns),
                     tables.barred(scene.models[0].headline, "normal_force") if scene.models[0].headline else "–",
                     *(tables.barred(found[name], "max_pressure") if name in found else "–" for name in names)])
    return tables.table(["wheel", over._replace(of="").label, "patch", *(head for head, *_ in columns), "F<sub>n</sub> [N]",
                         *(f"p<sub>0</sub> {styles.label(name)} [MPa]" for name in names)], rows)


BOTH = (("left", "blue", (), "o"), ("right", "slip", (5, 2), "s"))
KINDS = (("wave", "green", ()), ("harmonic", "wine", (7, 2, 1.5, 2)))
UNDER_LOAD = " (markers: under load)"
SHIFT = "shift to the right [mm]"
# Least spans of the scales, so that cones, with constant conicity and angle, appear as straight lines.
LEAST_RADIUS, LEAST_ANGLE, LEAST_CONICITY, LEAST_LENGTH = 0.2, 0.5, 0.05, 5.0


def _conicity_seen(table):
    """The conicity in words, at the amplitude nearest to 3 mm with a value."""
    known = np.flatnonzero(np.isfinite(table["conicity_wave"]))
    if not known.size:
        return "the wheelset does not oscillate"
    at = known[np.argmin(abs(table["lateral_shift"][known] - 3.0))]
    return (f"the equivalent conicity at an amplitude of {table['lateral_shift'][at]:.3g} mm is "
            f"{table['conicity_wave'][at]:.3g} by the wave and {table['conicity_harmonic'][at]:.3g} by "
            f"harmonic linearisation")


def _radius_differences(loaded):
    """[(lateral shift, right minus left rolling radius)]; empty for one wheel."""
    radius = {(p["position"], p["wheel"]): p["rolling_radius"] for p in loaded}
    return sorted((p["lateral_shift"], radius[p["position"], "right"] - radius[p["position"], "left"])
                  for p in loaded if p["wheel"] == "left" and (p["position"], "right") in radius)


def draw_wheelset(table: dict[str, np.ndarray], loaded: Sequence[dict[str, Any]] = ()) -> Figure:
    """Radii, angles and conicity over the shift: lines for the rigid wheelset; markers `loaded` for the most loaded
    patches of a run. If some of these are to the left, the lines are extended by mirroring."""
    shift, difference = table["lateral_shift"], table["radius_difference"]
    angle = {side: np.degrees(table[f"angle_{side}"]) for side in ("left", "right")}
    left = slice(None, 0, -1) if any(place["lateral_shift"] < 0 for place in loaded) else slice(0)

    def line(values, mirrored, **look):
        return np.concatenate([-shift[left], shift]), np.concatenate([mirrored[left], values]), look

    def markers(spots, **look):
        return [(*zip(*spots), {**look, "joined": False, "order": 5})] if spots else []

    figure = Figure(2)
    differences = _radius_differences(loaded)
    angles = []
    for (side, colour, dash, marker), other in zip(BOTH, ("right", "left")):
        spots = sorted((p["lateral_shift"], np.degrees(p["contact_angle"])) for p in loaded if p["wheel"] == side)
        angles += [line(angle[side], angle[other], colour=colour, dash=dash), *markers(spots, colour=colour, marker=marker)]
        figure.entry(f"{side} wheel" + UNDER_LOAD * bool(spots), colour, dash, marker=marker if spots else None)
    if differences:
        figure.entry("right minus left" + UNDER_LOAD, "ink", marker="D")
    length = table["wave_length"] * 1e-3
    charts = [
        ("rolling radii", SHIFT, "right less left [mm]", LEAST_RADIUS,
         [line(difference, -difference), *markers(differences, marker="D", size=2.8)]),
        ("contact angles", SHIFT, "contact angle [°]", LEAST_ANGLE, angles),
        ("equivalent conicity", "amplitude [mm]", "conicity [-]", LEAST_CONICITY,
         [(shift, table[f"conicity_{kind}"], {"colour": colour, "dash": dash, "name": f"conicity, {kind}"})
          for kind, colour, dash in KINDS if np.isfinite(table[f"conicity_{kind}"]).any()]),
        ("length of the wave", "amplitude [mm]", "[m]", LEAST_LENGTH, [(shift, length, {})])]
    # A hollow wheel may have no wave.
    figure.charts((270, 200), [chart for chart in charts if any(np.isfinite(y).any() for _, y, _ in chart[-1])])
    return figure.tell(f"Wheelset shifted by 0 to {shift[-1]:.3g} mm: ", [
        f"the right rolling radius grows to {difference[-1]:.3g} mm more than the left, the right contact angle to "
        f"{angle['right'].max():.3g} degrees", _conicity_seen(table)])


def of_table(path):
    """The figure of a table of `rollfem wheelset`."""
    return draw_wheelset(read_columns(path, "conicity_wave")[1])


def wheelset(result):
    """The figure of a run with a lateral sweep. None without a sweep."""
    path = os.path.join(result.folder, "wheelset_rigid.csv")
    if not os.path.exists(path):
        return None
    reference = reference_of_row(result)
    return draw_wheelset(read_columns(path, "conicity_wave")[1],
                 [m.place for m in result.models if m.name == reference and m.place["patch"] == 1])


# Columns of the table of a report: (heading, column of wheelset.csv, factor, significant digits).
OF_SHIFT = (("along the track [mm]", "track_position", 1, None), ("wheel angle [rad]", "wheel_angle", 1, 5),
            ("shift [mm]", "lateral_shift", 1, None), ("r right − left, rigid [mm]", "rigid_radius_difference", 1, 4),
           ("loaded [mm]", "radius_difference", 1, 4), ("conicity, harmonic", "conicity_harmonic", 1, 4),
           ("wave", "conicity_wave", 1, 4), ("wave length [m]", "wave_length", 1e-3, 4))
OF_WHEEL = (("angle [°]", "contact_angle", 180 / np.pi, 4), ("length [mm]", "contact_length", 1, 4),
            ("width [mm]", "contact_width", 1, 4), ("p<sub>0</sub> [MPa]", "max_pressure", 1, 5),
            ("F<sub>x</sub> [kN]", "longitudinal_force", 1e-3, 4), ("Y [kN]", "lateral_force_track", 1e-3, 4))


def _shift_cell(row, column, factor, digits):
    if not row.get(column):
        return "–"
    value = factor * float(row[column])
    return tables.number(0 if abs(value) < 1e-9 else value, digits)


def wheelset_table(result):
    """HTML: one line per position, by the model drawn in sweeps; empty without a sweep of shifts or along the way."""
    path = os.path.join(result.folder, "wheelset.csv")
    if not os.path.exists(path):
        return ""
    reference = reference_of_row(result)
    rows = [row for row in read_rows(path)[1] if row["model"] == reference and row["point"] == "1"]
    wheels = [side for side in ("left", "right") if any(row[f"{side} patches"] for row in rows)]
    known = [column for column in OF_SHIFT if len({row.get(column[1]) for row in rows} - {"", None}) > (column[0] == "shift [mm]")]
    columns = known + [(f"{side}: {head}", f"{side} {name}", factor, digits)
                       for side in wheels for head, name, factor, digits in OF_WHEEL]
    return (tables.table([column[0] for column in columns],
                         [[_shift_cell(row, *column[1:]) for column in columns] for row in rows])
            + f"<p class=hint>Patches by {styles.label(reference)} at the first load point; length and width: most loaded patch of a wheel; "
            "F<sub>x</sub> and Y: forces on the wheel in the track frame, along the track and to the right."
            + " Rigid: unloaded. Conicity at the amplitude of the shift: by harmonic linearisation, and that of cones with the same wave "
            "(UIC 519, EN 15302)." * any("conicity" in column[1] for column in known) + "</p>")
