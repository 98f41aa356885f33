"""With profiles: where the wheels touch the rails, and how that goes along a row of positions."""
import csv
import math
import os

import numpy as np
from matplotlib import pyplot as plt

from . import style, tables

# Colours of the patches of one wheel, the most loaded first.
PATCH_COLOURS = ["#D55E00", "#0072B2", "#009E73", "#CC79A7"]


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


def _draw_gap(panel, drawn, touching):
    """Vertical distance between rail and wheel around the contact, before they are pressed together."""
    rail, wheel = _as_function(drawn["rail"]), _as_function(drawn["wheel"])
    lower, upper = max(rail[0][0], wheel[0][0]), min(rail[0][-1], wheel[0][-1])
    y = np.linspace(lower, upper, 3000)
    gap = np.interp(y, *rail) - np.interp(y, *wheel)
    panel.plot(y, gap, color="#0072B2", linewidth=1.3)
    for k, place in enumerate(touching):
        ink = PATCH_COLOURS[k % len(PATCH_COLOURS)]
        panel.plot(place["y_track"], np.interp(place["y_track"], y, gap), "o", color=ink, markersize=5,
                   zorder=5, label=f"patch {place['patch']:.0f}: {math.degrees(place['contact_angle']):.2f}°, "
                   f"radius {place['rolling_radius']:.3f} mm")
    panel.set_xlim(min(p["y_track"] for p in touching) - 20, max(p["y_track"] for p in touching) + 20)
    panel.set_ylim(-0.02, 0.6)
    panel.set_ylabel("distance at the axle, unloaded [mm]")
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, 1.16), ncol=1)


def pair(result, wheel, position):
    """Wheel on rail at one position with the contact points, and the distance between the two; None
    without profiles."""
    drawn = result.profiles.get((wheel, position))
    touching = [m.place for m in first_of_scenes(result)
                if m.place["wheel"] == wheel and m.place["position"] == position]
    if drawn is None or not touching:
        return None
    return draw_pair(drawn, touching, f"{wheel} wheel at position {position:.0f}")


def draw_pair(drawn, touching, title):
    """`drawn`: points y, z [n, 2] of "rail" and "wheel" on the track; `touching`: dicts with patch,
    y_track, z_track (mm), contact_angle (rad), rolling_radius (mm)."""
    figure, panels = plt.subplots(1, 2, figsize=(9.4, 3.4), gridspec_kw={"width_ratios": [1.5, 1]})
    for name, ink in (("rail", "black"), ("wheel", "#0072B2")):
        y, z = drawn[name].T
        panels[0].plot(y, -z, color=ink, linewidth=1.3, label=name)
    for k, place in enumerate(touching):
        panels[0].plot(place["y_track"], -place["z_track"], "o", markersize=5, zorder=5,
                       color=PATCH_COLOURS[k % len(PATCH_COLOURS)])
    panels[0].set_aspect("equal")
    panels[0].set_ylabel("height over the rails [mm]")
    panels[0].legend(loc="best")
    _draw_gap(panels[1], drawn, touching)
    for panel in panels:
        panel.set_xlabel("$y$ on the track, to the right [mm]")
    panels[0].set_title(title)
    style.arrange(figure, panels[None, :], between=(0.75, 0), top=0.5)
    return figure


def draw_pair_file(path, png_folder=None):
    """Draws NAME.svg of a table NAME.csv that `rollfem profile CASE.toml` wrote."""
    style.use()
    with open(path, encoding="utf-8") as table:
        title = table.readline().lstrip("# ").strip()
        rows = list(csv.DictReader(table))
    drawn = {part: np.array([[float(r["y [mm]"]), float(r["z [mm]"])] for r in rows if r["part"] == part])
             for part in ("rail", "wheel")}
    touching = [{"patch": float(r["part"].split()[1]), "y_track": float(r["y [mm]"]),
                 "z_track": float(r["z [mm]"]), "contact_angle": float(r["angle [rad]"]),
                 "rolling_radius": float(r["radius [mm]"])}
                for r in rows if r["part"].startswith("patch")]
    style.save(draw_pair(drawn, touching, title), os.path.splitext(path)[0] + ".svg", png_folder)


def _curves(result):
    """Panels of the sweep: (label, value of a model's first point and place)."""
    return [("contact point on the rail\n$y$ of its profile [mm]", lambda m: m.place["y_rail"]),
            ("contact point on the wheel\n$y$ of its profile [mm]", lambda m: m.place["y_wheel"]),
            ("contact angle [°]", lambda m: math.degrees(m.place["contact_angle"])),
            ("normal force [kN]", lambda m: m.points[0]["normal_force"] / 1e3),
            ("largest pressure [MPa]", lambda m: m.points[0]["max_pressure"]),
            (r"longitudinal creepage $\xi$ [%]",
             lambda m: 100 * m.points[0]["longitudinal_creepage"])]


def sweep(result):
    """Contact point, angle, load, pressure and creepage over the positions; None for fewer than 3."""
    numbers = positions(result)
    if len(numbers) < 3:
        return None
    shifts = {m.place["position"]: m.place["lateral_shift"] for m in result.models}
    by_shift = len({round(s, 9) for s in shifts.values()}) == len(shifts)
    figure, panels = plt.subplots(2, 3, figsize=(9.4, 5.2), sharex=True)
    models = [m for m in result.models if m.points and "vermeulen" not in m.name]
    # Of what all models share, the one that has most places: Hertz cannot take every patch.
    reference = max(dict.fromkeys(m.name for m in models),
                    key=lambda name: sum(m.name == name for m in models))
    for panel, (label, value) in zip(panels.flat, _curves(result)):
        per_model = label.startswith("largest")
        for wheel, fill in (("left", "full"), ("right", "none")):
            for name in sorted({m.name for m in models}) if per_model else [reference]:
                for patch in (1, 2, 3):
                    chosen = [m for m in models if m.name == name and m.place["wheel"] == wheel
                              and m.place["patch"] == patch]
                    if not chosen:
                        continue
                    x = [shifts[m.place["position"]] if by_shift else m.place["position"] for m in chosen]
                    panel.plot(x, [value(m) for m in chosen], linestyle="-" if patch == 1 else "none",
                               linewidth=0.9, color=style.colour(chosen[0]), fillstyle=fill,
                               marker=style.marker(chosen[0]) if per_model else "o", markersize=4.5,
                               label=f"{style.label(chosen[0])}, {wheel}" if patch == 1 else None)
        panel.set_ylabel(label)
    for panel in panels[1]:
        panel.set_xlabel("lateral shift of the wheelset [mm]" if by_shift else "position")
    handles, labels = panels[1, 1].get_legend_handles_labels()
    style.arrange(figure, panels, between=(1.0, 0.2), left=0.95, top=0.35)
    figure.legend(handles, labels, loc="upper center", ncol=min(5, max(1, len(labels))), borderaxespad=0.2)
    return figure


def contact_table(result):
    """One row for every patch: where it is and what the models make of it."""
    models = result.models
    names = list(dict.fromkeys(m.name for m in models))
    head = ["patch", "shift [mm]", "yaw [mrad]", "roll [mrad]", "y track [mm]", "y rail [mm]",
            "y wheel [mm]", "angle [°]", "radius [mm]", "F<sub>n</sub> [N]"]
    head += [f"p<sub>0</sub> {style.label(next(m for m in models if m.name == n))} [MPa]" for n in names]
    rows = []
    for label, scene in result.scenes():
        place = scene.models[0].place
        point = scene.models[0].points[0]
        row = [label, tables.plain(place["lateral_shift"]), tables.plain(1e3 * place["yaw"]),
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
