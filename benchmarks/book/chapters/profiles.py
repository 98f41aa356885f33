# SPDX-License-Identifier: LGPL-2.1-or-later
"""True profiles: S1002 on UIC60, and the Manchester benchmark."""
import json
import math
import os

import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import ADHESION

from .. import published, style
from ..chapter import Chapter, Cost, Row, Table, closest
from ..page import number
from .balance import balance_rows


def _draw_patches_meet(shifts, points, change):
    """Forces of the patches, friction, and change of a force (% of the load) over the lateral shift."""
    figure, axes = plt.subplots(1, 3, figsize=(10.2, 3.3))
    parts = [sorted(points[s].get("patches", []), key=lambda part: part["y"]) for s in shifts]
    for which, words, ink, marker in ((0, "at the flange root", "#D55E00", "s"), (-1, "on the tread", style.BLUE, "o")):
        axes[0].plot(shifts, [here[which]["normal_force"] / 1e3 if here else float("nan") for here in parts],
                     color=ink, marker=marker, markersize=3, linewidth=0.8, label=words)
    axes[0].plot(shifts, [points[s]["normal_force"] / 1e3 for s in shifts], color="black", label="all", linewidth=1.2)
    for force, words, ink, dash in (("longitudinal_force", "$F_x$", style.BLUE, "-"),
                                    ("lateral_force", "$F_y$", "#D55E00", (0, (6, 1.5)))):
        axes[1].plot(shifts, [points[s][force] / 1e3 for s in shifts], color=ink, linestyle=dash, label=words)
    axes[2].semilogy(shifts, change, color=style.BLUE, marker="o", markersize=3, linewidth=0.8)
    axes[2].axhline(0.1, color="black", linewidth=0.8, linestyle="--")
    for axis, words in zip(axes, ("normal force [kN]", "friction on the wheel [kN]",
                                  "change of a force over 1 µm [% of $F_z$]")):
        axis.set_xlabel("lateral shift [mm]")
        axis.set_ylabel(words)
    axes[0].legend(fontsize="small")
    axes[1].legend()
    figure.tight_layout()
    return figure


def _patches_meet(bench):
    """The left wheel shifted until it rests on its flange root: (rows, (figure, caption), cost).

    A second patch appears, joins the first, separates and stays alone; every position is repeated 1 micrometre further.
    """
    load, micrometre = 100e3, 1e-3
    shifts = [round(-6 + 0.05 * k, 2) for k in range(35)]
    result = bench.run("patches_meet", "cases/s1002_uic60_left.toml", ["halfspace"],
                       {"wheelset.lateral_shift": sorted(shifts + [round(s + micrometre, 3) for s in shifts]),
                        "rolling.longitudinal_creepage": 0.0, "friction.coefficient": 0.3})
    with open(os.path.join(bench.folder, "patches_meet", "summary.json"), encoding="utf-8") as file:
        points = {round(m["place"]["lateral_shift"], 3): m["points"][0] for m in json.load(file)["models"]}
    change = [max(abs(points[round(s + micrometre, 3)][force] - points[s][force])
                  for force in ("normal_force", "longitudinal_force", "lateral_force")) for s in shifts]
    figure = _draw_patches_meet(shifts, points, [100 * c / load for c in change])
    rows = [Row("left wheel moved by 1 µm: largest change of a force", "N", 0.0, max(change), 0.001, of=load,
                of_words="F_z", by="half-space, 40 across")]
    caption = ("The left wheel shifted towards its flange (mu = 0.3, xi = 0): from the right, a second patch appears at the "
               "root, joins the patch on the tread, separates from it and stays alone. Each change of a force is to a position "
               "1 µm on")
    cost = Cost(f"left wheel at {2 * len(shifts)} positions: Half-space", sum(m.seconds["total"] for m in result.models))
    return rows, (bench.save(figure, "patches_meet"), caption), cost


def _fine_rows(bench):
    """The left wheel on CONTACT's elements, in a plane as there."""
    text = bench.case_text("cases/s1002_uic60_left.toml", {"rolling.longitudinal_creepage": 0.0}).replace(
        "elements_across = 40", "cell_size = [0.2, 0.2]")
    model = bench.run_text("s1002_left_fine", text + '\n[halfspace]\nsurface = "planar"\n', ["halfspace"])["halfspace"]
    point = model.points[0]
    return [Row(f"left wheel, 0.2 mm: {words}", unit, value, reached, allowed, by="half-space, planar")
            for words, unit, value, reached, allowed in (
                ("p0", "MPa", 1011.17, point["max_pressure"], 0.005), ("length", "mm", 12.75, point["contact_length"], 0.2 / 12.75),
                ("width", "mm", 16.20, point["contact_width"], 0.2 / 16.20), ("area", "mm²", 155.48, point["contact_area"], 0.01),
                ("approach", "mm", 0.09331, point["approach"], 0.003), ("elements in contact", "", 3905, model.contact_elements, 0.01))]


def wheel_on_rail(bench):
    """S1002 on UIC60 at 100 kN: both wheels"""
    rows, tables, cost = [], [], []
    models = ["hertz", "fastsim", "strip", "halfspace"] + (["fem"] if bench.has_fem else [])
    for side in ("left", "right"):
        # 0.5 mm: the default cells are too coarse for the widths (docs/verification.md)
        result = bench.run(f"s1002_{side}", f"cases/s1002_uic60_{side}.toml", models,
                           {"rolling.longitudinal_creepage": "[0.001, 0.004]", "+": "\n[fem]\ncell_size = 0.5\n"})
        contact = published.WHEEL_ON_RAIL[side]["CONTACT today"]
        entries = []
        for model in result.models:
            point = model.points[0]
            values = (point["max_pressure"], point["contact_length"], point["contact_width"])
            entries.append((style.label(model), values))
            if model.name in ("halfspace", "fem"):
                limits = (0.005, 0.2 / 12.75, 0.2 / 16.20)
                for words, unit, value, mine, most in zip(("p0", "length", "width"), ("MPa", "mm", "mm"), contact,
                                                          values, limits):
                    if value is not None:
                        rows.append(Row(f"{side} wheel: {words}", unit, value, mine, most, by=style.label(model)))
            cost.append(Cost(f"{side}: {style.label(model)}", model.seconds["total"], model.unknowns or None))
        entries += [(name if name.startswith("CONTACT") else f"*{name}*", values)
                    for name, values in published.WHEEL_ON_RAIL[side].items()]
        tables.append(Table(f"The {side} wheel by all:", ["by", "p0 in MPa", "length in mm", "width in mm"],
                            [[name, *(number(v, 5) for v in values)] for name, values in entries]))
    rows += _fine_rows(bench)
    figures = []
    if not bench.small:
        more, figure, seconds = _patches_meet(bench)
        rows, figures = rows + more, [figure]
        cost.append(seconds)
    return Chapter(
        "wheel-on-rail", "S1002 on UIC60 at 100 kN",
        "A wheelset 2 mm to the right, wheel radius 450 mm, mu = 0.55, rails inclined 1:40 "
        "([left](../../cases/s1002_uic60_left.toml), [right](../../cases/s1002_uic60_right.toml)); half-space at 40 "
        "across, "
        "finite elements on cells of 0.5 mm.",
        "CONTACT rev 2707 on the same profiles (0.05 mm elements on the left; on the right only p0 is available). "
        "The values of the 2012 study are shown for comparison; its patch lengths cannot carry 100 kN at its "
        "pressures "
        "([verification](../verification.md)).",
        rows, tables=tables, figures=figures, cost=cost,
        tests=["verification.ProfilePatches.S1002OnUic60HasContactsCreepCurve",
               "verification.JoinedPatches.ForcesAreContinuousAsPatchesComeAndGo",
               "verification.FemOnTheStudysLeftWheel.WithBoxesHasPressureAndForcesOfTheHalfSpace"])


# Tolerance of every column, in its unit or as a fraction of the reference: (left, right on its tread or flange root,
# right on its flange). The patch on the flange is three or four elements of 0.2 mm wide. Only the tests check adhesion:
# from 1 mm on everything slips.
_HELD = {"y": ("mm", 0.03, 0.03, 0.03), "z": ("mm", 0.001, 0.006, 0.03), "angle": ("rad", 1.5e-4, 2.5e-3, 2.5e-3),
         "y_wheel": ("mm", 0.05, 0.05, 0.05), "force": ("N", 1e-3, 1e-3, 1.2e-3), "along": ("", 4e-3, 4e-3, 4e-3),
         "across": ("", 4e-3, 4e-3, 4e-3), "approach": ("mm", 1e-3, 5e-3, 5e-3), "pressure": ("MPa", 3e-3, 0.012, 0.05),
         "elements": ("", 0.02, 0.03, 0.09), "xi": ("", 0.02, 0.02, 0.02), "eta": ("", 0.015, 0.015, 0.015),
         "spin": ("", 0.015, 0.015, 0.015)}
# Between two whole millimetres, and where positions change fast: a third adheres at 0.5 mm, where first and second order
# differ most; at 6.5 mm the right wheel has just come onto its flange; its contact moves by 10 mm/mm at 0.5 mm.
_BETWEEN = {("left", "approach"): 2e-3, ("right", "angle"): 1e-3, ("right", "pressure"): 5e-3}
_BESIDE = {("left", 0.5): {"along": 0.012, "across": 0.012}, ("left", 6.5): {"along": 0.012, "across": 0.012},
           ("left", 5): {"along": 0.02, "across": 0.02}, ("right", 0.5): {"y": 0.15, "xi": 0.04, "eta": 0.04, "spin": 0.04},
           ("right", 6.5): {"y": 0.04, "angle": 5e-3, "force": 5e-3, "along": 8e-3, "across": 8e-3, "eta": 0.02, "spin": 0.02}}
_ABSOLUTE = {"y": "1 mm", "z": "1 mm", "angle": "1 rad", "y_wheel": "1 mm", "along": "mu F_n", "across": "mu F_n"}
_WORDS = {"y": "y on the track", "z": "z on the track", "angle": "contact angle", "y_wheel": "y on the wheel",
          "force": "normal force", "along": "-F_x/(mu F_n)", "across": "F_y/(mu F_n)", "pressure": "p0",
          "elements": "elements in contact"}


def _position(model):
    """The columns of CONTACT's tables with this program's values."""
    point, place = model.points[0], model.place
    bound = 0.3 * point["normal_force"]
    return {"y": place["y_track"], "z": place["z_track"], "angle": place["contact_angle"], "y_wheel": place["y_wheel"],
            "force": point["normal_force"], "along": -point["longitudinal_force"] / bound,
            "across": point["lateral_force"] / bound, "approach": point["approach"], "pressure": point["max_pressure"],
            "elements": model.contact_elements, "xi": point["longitudinal_creepage"], "eta": point["lateral_creepage"],
            "spin": point["spin"]}


def _allowed(name, side, shift):
    limits = _HELD[name][1:]
    usual = limits[0 if side == "left" else 2 if shift > 6 else 1]
    if shift % 1 and not (name == "pressure" and shift > 6):
        usual = _BETWEEN.get((side, name), usual)
    return _BESIDE.get((side, shift), {}).get(name, usual)


def _references(side, shift):
    """CONTACT's columns of a wheel."""
    if shift in published.MANCHESTER[side]:
        return dict(zip(published.MANCHESTER_COLUMNS, published.MANCHESTER[side][shift]))
    return dict(zip(published.MANCHESTER_BETWEEN_COLUMNS, published.MANCHESTER_BETWEEN[side][shift]))


def _vertical_row():
    """CONTACT's columns are copied rightly: pressure and friction carry the left wheel's 10 kN, to half of a digit."""
    rows = [_references("left", s) for s in (*published.MANCHESTER["left"], *published.MANCHESTER_BETWEEN["left"])]
    far = max((row["force"] * (math.cos(row["angle"]) + 0.3 * row["across"] * math.sin(row["angle"])) - 10e3 for row in rows),
              key=abs)
    return Row("vertical force of the columns, farthest", "N", 10e3, 10e3 + far, 5.5e-4, by="CONTACT, left wheel")


def _column_rows(name, side, positions):
    """One row for all positions of a wheel."""
    rows = []
    for shift, mine in positions.items():
        reference = _references(side, shift).get(name)
        # Two patches share the right wheel's load at 5 mm: 0.02 mm of shift would change these columns by their
        # differences.
        if reference is None or shift == 5 and (name == "xi" or side == "right" and name != "force"):
            continue
        allowed = _allowed(name, side, shift)
        scale = 1.0 if name in _ABSOLUTE else reference
        if name in ("xi", "eta") and abs(reference) < 1e-3:
            scale, allowed = 1.0, 2e-5
        words = _ABSOLUTE.get(name) or ("1" if scale == 1.0 else "")
        rows.append(Row(f"{_WORDS.get(name, name)}, at {shift:g} mm", _HELD[name][0], reference, mine[name], allowed,
                        of=scale, of_words=words, by=f"{side} wheel"))
    return closest(rows)


def _shift_of_contacts_xi(bench, at_five):
    """At 5 mm the right wheel touches at two places and xi changes by 3.5 % with 0.01 mm of shift: the judged value is
    the shift at which our xi equals CONTACT's, interpolated between 4.98 and 5 mm."""
    before = bench.run("manchester_4.98", "cases/manchester_A22.toml",
                       settings={"wheelset.lateral_shift": 4.98, "wheelset.yaw": 0.0024 * 4.98})
    before = _position(next(m for m in before.models if m.place["wheel"] == "left"))["xi"]
    wanted = published.MANCHESTER["left"][5][published.MANCHESTER_COLUMNS.index("xi")]
    shift = 5.0 - 0.02 * (at_five - wanted) / (at_five - before)
    return Row("shift at which xi is CONTACT's at 5 mm", "mm", 5.0, shift, 0.02, of=1.0, of_words="1 mm", by="left wheel")


def _traction_rows(bench):
    """Digits of CONTACT's tractions on its elements, one in the middle of its reference point, with its creepages there: the program's
    are those at its own reference point, up to 0.024 mm from it."""
    rows = []
    for shift, (y_track, xi, eta, spin, along, across, touching, adhering) in published.MANCHESTER_TRACTIONS.items():
        place = {"wheelset.lateral_shift": shift, "wheelset.yaw": 0.0024 * shift, "output.fields": "true"}
        plain = next(m for m in bench.run(f"tractions_{shift:g}", "cases/manchester_A22.toml", settings=place).models
                     if m.place["wheel"] == "left")
        point = plain.points[0]
        # The patch's y points to the field, -y of the track.
        reference = (plain.place["y_track"] - y_track) / math.cos(plain.place["contact_angle"])
        extent = [0.2 * (2 * math.ceil(point[key] / 0.4) + 9) for key in ("contact_length", "contact_width")]
        middle = reference + 0.2 * round((point["patch_y_middle"] - reference) / 0.2)
        motion = (f'"none"\nlongitudinal_creepage = {-xi + spin * reference}\nlateral_creepage = {eta}\nspin = {spin}\n'
                  'upwind_order = "first"')
        model = bench.run(f"tractions_{shift:g}_theirs", "cases/manchester_A22.toml", settings={
            **place, "rolling.extra_slip": motion, "contact_grid.cell_size": f"[0.2, 0.2]\nextent = {extent}\nmiddle = [0.0, {middle}]",
            "wheelset.side": '"left"', "wheelset.free_rolling": '"none"'}).models[0]
        point = model.points[0]
        bound = 0.3 * point["normal_force"]
        # In pure rolling it is a balance about zero of a patch 16 mm wide, and turns by 0.0016 where the patch moves by 7 um across.
        rows += [Row(f"left wheel, CONTACT's elements, {shift:g} mm: {words}", "mu F_n", value, point[key] / bound, allowed, of=1.0,
                     of_words="mu F_n", by="first order") for words, key, value, allowed in (
                         ("F_x", "longitudinal_force", -along, 2e-4 if shift else 2e-3), ("F_y", "lateral_force", across, 2e-4))]
        assert abs(model.contact_elements - touching) <= 1 and np.sum(point.fields["state"] == ADHESION) == adhering
    return rows


def _draw_manchester(places):
    figure, axes = plt.subplots(2, 2, figsize=(8.4, 6.0))
    columns = ("angle", "pressure", "xi", "along")
    labels = ("contact angle [degrees]", "$p_0$ [MPa]", r"$|\xi|$ [%]", r"$|F_x|/(\mu F_n)$")
    for side, ink in (("left", "#0072B2"), ("right", "#D55E00")):
        shifts = sorted(published.MANCHESTER[side])
        for axis, name, words in zip(axes.flat, columns, labels):
            scale = {"xi": 100, "angle": 180 / 3.141592653589793}.get(name, 1)
            index = published.MANCHESTER_COLUMNS.index(name)
            axis.plot(shifts, [scale * abs(published.MANCHESTER[side][s][index]) for s in shifts], linestyle="none",
                      marker="o", markersize=8, markerfacecolor="none", color="black",
                      label="CONTACT" if side == "left" else None)
            axis.plot(shifts, [scale * abs(places[side][s][name]) for s in shifts], color=ink, marker="o", markersize=3.5,
                      linewidth=1.2, label=f"rollfem, {side}")
            axis.set_xlabel("lateral shift [mm]")
            axis.set_ylabel(words)
    axes[0, 1].legend(loc="upper left")
    figure.tight_layout()
    return figure


def _flange_on_finer_elements(bench):
    """p0 of the right wheel at 10 mm against element size; CONTACT's 0.2 mm do not resolve it."""
    rows, cost = [], 0.0
    for size in () if bench.small else (0.2, 0.1, 0.05):
        result = bench.run(f"manchester_flange_{size:g}", "cases/manchester_A22.toml",
                           settings={"wheelset.lateral_shift": 10.0, "wheelset.yaw": 0.024,
                                     "contact_grid.cell_size": f"[{size}, {size}]"})
        model = next(m for m in result.models if m.place["wheel"] == "right")
        point = model.points[0]
        cost += model.seconds["total"]
        rows.append([f"{size:g} mm", str(model.contact_elements), number(point["contact_width"], 3),
                     f"{point['max_pressure']:.1f}", f"{point.bar('max_pressure'):.0f}"])
    rows.append(["CONTACT, 0.2 mm", str(published.MANCHESTER["right"][10][9]), "", "2643", ""])
    return Table("Right wheel at 10 mm on its flange, on finer elements:",
                 ["elements", "in contact", "width, mm", "p0, MPa", "its bar"], rows), Cost("the flange on three grids", cost)


def manchester(bench):
    """Manchester benchmark A-2.2: eleven positions of a wheelset"""
    result = bench.run("manchester", "cases/manchester_A22.toml")
    halves = sorted(published.MANCHESTER_BETWEEN["left"])
    between = bench.run("manchester_between", "cases/manchester_A22.toml",
                        settings={"wheelset.lateral_shift": halves, "wheelset.yaw": [0.0024 * shift for shift in halves]})
    places = {"left": {}, "right": {}}
    for model in (*result.models, *between.models):
        shift = round(model.place["lateral_shift"], 1)
        places[model.place["wheel"]][shift] = _position(model)
        assert model.place["patches"] == 1
        if (model.place["wheel"], shift) == ("right", 5):
            patches = model.points[0]["patch_count"]
    rows = [_vertical_row(), Row("patches, at 5 mm", "", 2, patches, 1e-9, by="right wheel")]
    rows += [_column_rows(name, side, places[side]) for side in ("left", "right") for name in published.MANCHESTER_COLUMNS]
    rows += [_shift_of_contacts_xi(bench, places["left"][5]["xi"]), *_traction_rows(bench), *balance_rows(bench)]
    name = bench.save(_draw_manchester(places), "manchester")
    finer, finer_cost = _flange_on_finer_elements(bench)
    return Chapter(
        "manchester", "Manchester benchmark A-2.2",
        "S1002 on UIC60, 10 kN on each wheel, mu = 0.3, shift 0 to 10 mm with 2.4 mrad of yaw for each, no torque "
        "about the "
        "axle; both wheels, every column, and most of them at each half millimetre between; the table shows the position closest to its tolerance "
        "([case](../../cases/manchester_A22.toml)).",
        "CONTACT's shipped results (user guide 5.7; Shackleton and Iwnicki 2008), left wheel r2707, right wheel "
        "r2447. At the "
        "largest creepages up to 1.3 % are a matter of definition: CONTACT divides by the mean of forward and "
        "circumferential speed. The height of the wheelset differs (its roll is prescribed there, here both wheels "
        "touch) and is compared at 0 mm only (last test).",
        rows, tables=[finer], figures=[(name, "Angle, pressure, creepage and force of both wheels over the shift")],
        cost=[Cost("both wheels at eleven positions, half-space", sum(m.seconds["total"] for m in result.models)),
              finer_cost],
        tests=["verification.ManchesterHeight.IsTheirsLessTheApproach"],
        after="At 5 mm the right wheel touches at two places, tread and flange root, which CONTACT joins into one "
              "patch: there the normal force is compared, and on the left wheel everything except creepage and "
              "longitudinal and lateral friction. p0 on the flange is the least informative row: elements of 0.2 mm, the "
              "benchmark's, fit 3.7 times into the width of the patch; on them this program is 2.6 % below its own limit and "
              "CONTACT 1.9 % above that limit; on 0.05 mm the half-space has 2591 MPa and a bar of 11. The comparison at "
              "0.2 mm judges two discretisation errors of opposite sign, not the method.")
