# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conformal contact: CONTACT's results explained, curved half-spaces, the hybrid, and the range of each theory."""
import numpy as np
from matplotlib import pyplot as plt

from .. import style
from .. import conformal_records as records, published, turned_half_space
from ..chapter import Chapter, Cost, Row, Table
from ..page import number, percent
from .work import run_case

GROOVE, CORNER = "cases/conformal_groove.toml", "cases/conformal_corner.toml"
FREE = {"rolling.problem": '"steady"\nlongitudinal_force = 0.0'}
FORCE = 10e3


def _groove(bench, radius, models, settings=None, name=""):
    rounder = {f"{body}.round_to": 0.85 for body in ("wheel", "rail") if radius == 10.02}
    return bench.run(f"conformal_groove_{round(100 * radius)}{name}", GROOVE, models,
                     {"rail.transverse_radius": -radius, **rounder, **(settings or {})})


def _turned_patch(radius):
    scene = turned_half_space.Scene(10.0, radius, 420.0, True, 80e3)
    reach_x, reach_s = {10.25: (3.4, 3.3), 10.10: (2.9, 4.9), 10.05: (2.7, 6.3), 10.02: (2.4, 9.0)}[radius]
    return turned_half_space.Patch(scene, 0.2, 0.25, reach_x, reach_s)


def _contact_rows(bench, cost):
    """The half-space with CONTACT's friction against CONTACT."""
    rows = []
    for radius, printed in published.CONTACT_GROOVES.items():
        model = _groove(bench, radius, ["halfspace"], FREE, "_free")["halfspace"]
        point = model.points[0]
        for words, unit, key, value, allowed in (
                ("p0", "MPa", "max_pressure", "p0", 2e-3), ("approach", "mm", "approach", "approach", 1e-3),
                ("creepage of free rolling", "", "longitudinal_creepage", "creepage", 4e-3 if radius < 10.1 else 3e-3)):
            if value in printed:
                rows.append(Row(f"groove of {radius} mm, mu = 0.3, F_x = 0: {words}", unit, printed[value], point[key],
                                allowed, by="half-space, curved"))
        rows.append(Row(f"groove of {radius} mm, mu = 0.3, F_x = 0: force", "N", FORCE, point["normal_force"], 1e-6, by="half-space, curved"))
        # Spin about normals that lean makes lateral friction, which carries 1.6 % of the load at 10.25 mm and 2.6 % at 10.10 mm.
        if radius >= 10.1:
            assert _groove(bench, radius, ["hertz", "halfspace"])["halfspace"].points[0]["max_pressure"] > 1.004 * point["max_pressure"]
        cost.append(Cost(f"groove of {radius} mm, half-space, F_x = 0", model.seconds["total"], model.unknowns))
    return rows


def _corner_rows(bench):
    """The program's distance is closed along z, CONTACT's grows as x^2 along the normal: 0.8 % in force, 0.5 % in p0."""
    model = bench.run("conformal_corner", CORNER, ["halfspace"])["halfspace"]
    point = model.points[0]
    total = point.fields["pressure"].sum() * model.dx * model.dy
    words = "corner, given approach: "
    return [Row(f"{words}{what}", unit, value, reached, allowed, by="half-space, curved, against CONTACT")
            for what, unit, value, reached, allowed in (
                ("sum of pressure", "kN", 91.84, 1e-3 * total, 0.012), ("F_z", "kN", 89.25, 1e-3 * point["normal_force"], 0.012),
                ("F_z over the sum of pressure", "", 89.25 / 91.84, point["normal_force"] / total, 2e-3 * 91.84 / 89.25),
                ("p0", "MPa", 1012.0, point["max_pressure"], 8e-3))]


def _curved_rows(bench):
    """The curved half-space against the plane one: on flat bodies, by the shift of its creep curve, and by Persson's cylinder."""
    bent = '[halfspace]\nsurface = "curved"'
    both = [run_case(bench, f"flat_{k}", [(1e-3, 5e-4, 1e-4)], 40, rail=2000.0, more=more)["halfspace"].points[0] for k, more in enumerate(("", bent))]
    rows = [Row("case a, curved: p0", "MPa", both[0]["max_pressure"], both[1]["max_pressure"], 1e-4, by="half-space, planar"),
            *(Row(f"case a, curved: {words}", "N", both[0][key], both[1][key], 2e-4, of=0.55 * 50e3, of_words="mu F_z", by="half-space, planar")
              for words, key in (("F_x", "longitudinal_force"), ("F_y", "lateral_force")))]
    # CONTACT in the plane with the slip -y^2/(2 R_rail R), to elements of 0 by its first order. The true wheel's radius falls by
    # y^2/(2 R_wheel), a twentieth less; local spin, which CONTACT was not given, shifts further.
    limit = 2 * published.CONTACT_CURVE_E_80[0.0] - published.CONTACT_CURVE_E[0.0]
    # Half contact angles in degrees; a conforming cylinder has 1.0038 of Hertz's pressure at 10 and 1.0157 at 20, as their square.
    for letter, bodies, degrees in (("e", (100.0, -105.263), 6.2), ("f", (50.0, -51.282), 12.5)):
        plane, curved = (run_case(bench, f"{letter}_{k}", [(0.0, 0.0, 0.0)], 40, rail=bodies[0], across_wheel=bodies[1],
                                  more=more)["halfspace"].points[0] for k, more in enumerate(("", bent)))
        # Both have the wheel's rolling radii; the curved surface adds the local spin, which shifts a little further.
        assert curved["traction_coefficient"] < plane["traction_coefficient"]
        rows += [Row(f"case {letter}, curved: -F_x/F_z at xi = 0", "", plane["traction_coefficient"], curved["traction_coefficient"], 0.03,
                     by="planar with the extra slip"),
                 Row(f"case {letter}, curved: what p0 has more, over a cylinder's", "", 0.85,
                     (curved["max_pressure"] / plane["max_pressure"] - 1) / (0.0038 * degrees**2 / 100), 0.65, of=1.0, of_words="1",
                     by="0.2 to 1.5 of Persson's")]
        if letter == "e":
            rows.append(Row("case e, curved: -F_x/F_z at xi = 0, CONTACT's slip a twentieth less", "", limit * 100 / 105.263,
                            curved["traction_coefficient"], 0.04, of=abs(limit), of_words="CONTACT's"))
            assert curved["traction_coefficient"] < limit * 100 / 105.263
    point = run_case(bench, "f_smooth", {"problem": '"frictionless"'}, 40, rail=50.0, across_wheel=-51.282, more=bent)["halfspace"].points[0]
    return [*rows, Row("case f, curved, no friction: F_z", "N", 50e3, point["normal_force"], 1e-6),
            Row("case f, curved, no friction: F_y", "N", 0.0, point["lateral_force"], 1e-3, of=1.0, of_words="1 N")]


def _step_rows():
    """CONTACT's steps one by one, with the book's own half-space."""
    patch, printed = _turned_patch(10.25), published.CONTACT_GROOVES[10.25]
    flat = turned_half_space.under_force(patch, FORCE, 0.0224, False, printed["creepage"])
    once = turned_half_space.under_force(patch, FORCE, 0.0222, True, printed["creepage_turned"])
    back = turned_half_space.under_force(patch, FORCE, 0.0223, True, printed["creepage_turned"], True)
    words = "groove of 10.25 mm, mu = 0.3, F_x = 0: p0"
    corner = turned_half_space.Patch(turned_half_space.Scene(10.0, 10.2, 650.54, False, 82e3, along_the_normal=True),
                                     0.4, 0.4, 10.0, 7.6)
    normal = turned_half_space.pressure(corner, 0.09089, False)
    return [Row(words, "MPa", printed["p0"], flat["p0"], 2e-3, by="book: rolled out flat"),
            Row(words, "MPa", printed["p0_turned"], once["p0"], 2e-3, by="book: turned, pressure found once"),
            Row(words, "MPa", printed["p0_turned_back"], back["p0"], 3e-3, by="book: turned, friction fed back"),
            Row("corner, given approach: p0", "MPa", 1012.0, normal.max(), 2e-3, by="book: x²/2R along the normal"),
            Row("corner, given approach: sum of pressure", "kN", 91.84, 1e-3 * normal.sum() * corner.area, 3e-3,
                by="book: x²/2R along the normal")], flat["friction_part"]


def _truth_rows():
    """The hybrid against turned directions: two independent corrections of the curved half-space."""
    rows = []
    for radius in records.GROOVES:
        turned = turned_half_space.under_force(_turned_patch(radius), FORCE, records.GROOVES[radius]["approach"], True)
        rows.append(Row(f"groove of {radius} mm, no friction: p0", "MPa", turned["p0"], records.GROOVES[radius]["p0"],
                        5e-3 if radius == 10.02 else 3e-3, by="hybrid (record), against the book: turned"))
    for words, unit, hybrid, elements, allowed in records.BOTH:
        rows.append(Row(words, unit, elements, hybrid, allowed, by="hybrid, against finite elements (records)"))
    return rows


def _calculix_rows():
    """The groove over its equivalent on a flat rail, on equal meshes of another program (benchmarks/calculix)."""
    lines, finest = published.calculix("groove")

    def ratio(line, key):
        return line["groove"].get(f"{key}_of_fit", line["groove"][key]) / line["flat"].get(f"{key}_of_fit", line["flat"][key])
    words = "groove of 10.05 mm, no friction: "
    named = (("hybrid", "hybrid", 4e-3, 1e-2, 1e-3), ("halfspace", "half-space, curved", 2e-2, 5e-2, 5e-3))
    return [row for name, who, pressure, width, lateral in named for row in (
        Row(words + "p0 over that on a flat rail", "", ratio(finest, "p0"), ratio(lines[name], "p0"), pressure,
            by=f"{who}, against CalculiX (records)"),
        Row(words + "b over that on a flat rail", "", ratio(finest, "b"), ratio(lines[name], "b"), width,
            by=f"{who}, against CalculiX (records)"),
        Row(words + "sum of p dA over F_z", "", finest["groove"]["sum_over_force"],
            lines[name]["groove"]["sum_over_force"], lateral, by=f"{who}, against CalculiX (records)"))]


def _groove_table(bench, cost):
    """Theories against the hybrid at given force; (Table, [(ratio, {theory: {quantity: difference}})])."""
    lines, sweep = [], []
    for radius in records.GROOVES:
        result = _groove(bench, radius, ["hertz", "halfspace"])
        cost.append(Cost(f"groove of {radius} mm, half-space", result["halfspace"].seconds["total"],
                         result["halfspace"].unknowns))
        truth = records.GROOVES[radius]
        away = {}
        for name, words in (("hertz", "Hertz"), ("halfspace", "half-space, curved")):
            point = result[name].points[0]
            away[name] = {short: point[key] / truth[short] - 1 for short, key in
                          (("p0", "max_pressure"), ("a", "semi_axis_x"), ("b", "semi_axis_y"), ("approach", "approach"))}
            lines.append([f"{radius} mm", words, *(f"{number(truth[k] * (1 + away[name][k]), 5)} ({percent(away[name][k])})"
                                                  for k in ("p0", "a", "b", "approach"))])
        lines.append([f"{radius} mm", "hybrid", *(number(truth[k], 5) for k in ("p0", "a", "b", "approach"))])
        sweep.append((truth["b"] / 10.0, away))
    return Table("Grooves at 10 kN without friction, differences from the hybrid: p0 in MPa, semi-axes and approach in mm.",
                 ["groove", "theory", "p0", "a", "b", "approach"], lines), sweep


def _corner_tables():
    head = ["", "F_z, kN", "sum of pressure, kN", "p0, MPa"]
    without = Table("Corner at an approach of 0.09089 mm without friction, and the effect of the rest of the body:", head,
                    [list(line) for line in records.CORNER])
    friction = Table("Corner, friction of 0.3, the whole rigid slip of CONTACT's cases 4 and 5 (`extra_slip = \"file\"`):",
                     ["", "F_x, kN", "F_s along the arc, kN", "sum of pressure, kN", "p0, MPa"],
                     [list(line) for line in records.CORNER_FRICTION])
    rest = Table("Effect of the rest of the body: changes against bodies that are circular up to 0.7 of their radii "
                 "and segments as large as the program "
                 "takes them (8 semi-axes):", ["", "corner: F_z", "corner: p0", "10.25 mm: p0", "10.05 mm: p0"],
                 [list(line) for line in records.REST])
    return [without, rest, friction]


def _figure(bench, sweep):
    figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.4), sharex=True)
    ratio = [0.0, *(at for at, _ in sweep)]
    for axis, quantity, words in ((axes[0], "p0", "$p_0$"), (axes[1], "approach", "the approach")):
        for name, label in (("hertz", "Hertz, plane half-space"), ("halfspace", "half-space, curved")):
            ink, dash, mark = style.LOOKS[name]
            axis.plot(ratio, [0.0, *(100 * away[name][quantity] for _, away in sweep)], color=ink, linestyle=dash,
                      marker=mark, label=label)
        axis.axhspan(-1, 1, color=style.GREY, alpha=0.15, linewidth=0)
        axis.set_xlabel("half the patch / radius across")
        axis.set_ylabel(f"difference in {words} [%]")
    axes[0].legend(fontsize="small", loc="lower left")
    figure.tight_layout()
    return bench.save(figure, "conformal")


def conformal_contact(bench):
    """Conformal contact: CONTACT's numbers explained, and the range of each theory"""
    cost = []
    rows = _contact_rows(bench, cost)
    steps, part = _step_rows()
    rows += _corner_rows(bench) + _curved_rows(bench) + steps + _truth_rows() + _calculix_rows()
    table, sweep = _groove_table(bench, cost)
    return Chapter(
        "conformal-contact", "Conformal contact: grooves and corners",
        "A wheel of 420 mm and 10 mm across in grooves of 10.25, 10.10, 10.05, 10.02 mm under 10 kN "
        "([case](../../cases/conformal_groove.toml)), and a rail's corner of 10 mm in a wheel's root of 10.2 mm at "
        "a prescribed approach ([case](../../cases/conformal_corner.toml)).",
        "CONTACT's printed results (testbank/examples_conformal/groove_li and examples/conformal of its repository); "
        "a half-space of the book's own that follows CONTACT's steps exactly "
        "(`benchmarks/book/turned_half_space.py`); "
        "records of the hybrid and of finite elements, with their commands "
        "(`benchmarks/book/conformal_records.py`); CalculiX, whose elements, contact and solver share nothing with this "
        "program (`benchmarks/calculix/curved_patch.py --pair groove`).",
        rows, tables=[table, *_corner_tables()],
        figures=[(_figure(bench, sweep), "Hertz and the curved half-space minus the hybrid in the grooves at 10 kN; "
                                         "grey: 1 %")],
        cost=cost,
        tests=["verification.HybridInAGroove.HasThePressureOfDirectionsTurned",
               "verification.HybridInAGroove.IsRoundAsFarAsTheCaseSays"],
        after=records.VERDICT.format(part=number(100 * part, 2)))
