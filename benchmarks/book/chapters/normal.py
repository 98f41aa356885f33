# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal contact of half-spaces: Hertz's ellipses, flatter bodies, and the order of the discretisation."""
import os

import numpy as np
from matplotlib import pyplot as plt

from .. import closed_forms, published, style
from ..chapter import Chapter, Cost, Row, at_most, closest
from .line_stress import line_load_rows
from .two_rollers import roller_rows

STEEL = 82000 / (1 - 0.28)  # E* = G/(1 - nu), MPa


def hertz(bench):
    """Hertz's ellipses: pressure, semi-axes, approach"""
    rows, cost, tested = [], [], []
    for radius in (300.0, 80.0, 13.0):
        result = bench.run(f"hertz_{radius:.0f}", "cases/verification/hertz.toml",
                           settings={"rail.transverse_radius": radius})
        exact = closed_forms.hertz(1 / 920, 1 / (2 * radius), 82e3, STEEL)
        for name, allowed in (("hertz", (1e-6,) * 4), ("halfspace", (2e-3, 1e-3, 1e-3, 3e-4))):
            point = result[name].points[0]
            for key, words, unit, value, most in zip(
                    ("semi_axis_x", "semi_axis_y", "max_pressure", "approach"), ("a", "b", "p0", "approach"),
                    ("mm", "mm", "MPa", "mm"), exact, allowed):
                if name == "halfspace" or key == "max_pressure":
                    rows.append(Row(f"rail {radius:g} mm: {words}", unit, value, point[key], most,
                                    by=style.label(result[name])))
        half = result["halfspace"]
        cost.append(Cost(f"rail {radius:g} mm", half.seconds["total"], half.unknowns))
    rows += _pressed_rows(bench)
    tested += ["unit.Hertz.GivesTheBenchmarkTable", "unit.Hertz.HoldsForAnyAspectRatioBothWays",
               "verification.HalfspaceNormal.SemiAxesOfSlenderEllipsesAreFoundAnywhereOnTheGrid"]
    return Chapter(
        "hertz", "Hertz's ellipses",
        "A wheel of 460 mm on rails of three radii across, 82 kN, G = 82 000 MPa, nu = 0.28, no friction; 40 elements "
        "across the smaller extent of the patch ([case](../../cases/verification/hertz.toml)).",
        "Hertz's closed form (Johnson 1985, chapter 4) with elliptic integrals by the arithmetic-geometric mean.",
        rows, cost=cost, tests=tested)


_PRESSED = """[load]
max_pressure = 1200.0
[friction]
coefficient = 0.3
[wheel]
rolling_radius = 450.0
transverse_radius = inf
[rail]
transverse_radius = {radius}
"""


def _pressed_rows(bench):
    """A largest pressure in place of the force."""
    rows = []
    for radius in (60.0, 450.0, 3000.0):
        point = bench.run_text(f"pressed_{radius:.0f}", _PRESSED.format(radius=radius), ["halfspace"])["halfspace"].points[0]
        force = point["normal_force"]
        rows += [Row(f"rail {radius:g} mm: p0 that is given", "MPa", 1200.0, point["max_pressure"],
                     min(2.0, point.bar("max_pressure")) / 1200.0, by="half-space"),
                 Row(f"rail {radius:g} mm: 3 F/(2 pi a b)", "MPa", 1200.0,
                     1.5 * force / (np.pi * point["semi_axis_x"] * point["semi_axis_y"]), 0.01, by="half-space")]
        if radius == 450:
            a = np.pi * 1200.0 * 450.0 / 2 / (210e3 / (2 * (1 - 0.3**2)))
            rows.append(Row("rail 450 mm: force of the p0 that is given", "N", 2 / 3 * np.pi * a * a * 1200.0, force, 1e-9))
    return [*rows, *line_load_rows(bench), *roller_rows(bench)]


def grid_order(bench):
    """Order of the half-space's pressure, and CONTACT's own digits"""
    study = bench.study("study_a", "cases/thesis_a.toml", ["--model", "halfspace"])
    series = study["places"][0]["series"][0]
    exact = closed_forms.hertz(1 / 810, 1 / 4000, 50e3, 210e3 / (2 * (1 - 0.3**2)))
    levels = {round(level["parameter"]): level for level in series["levels"]}
    rows = []
    for across, pressure in published.CONTACT_PRESSURE_A.items():
        rows.append(Row(f"p0, {across} across, against CONTACT", "MPa", pressure,
                        levels[across]["values"]["max_pressure"], 1e-5))
    finest = levels[160]
    for key, words, unit, value, most in (("max_pressure", "p0", "MPa", exact[2], 1e-4),
                                          ("approach", "approach", "mm", exact[3], 5e-5)):
        rows.append(Row(f"{words}, 160 across", unit, value, finest["values"][key], most))
        rows.append(Row(f"observed order of {words}", "", 2.0, finest["orders"][key], 0.15))
    for key, words, value in (("semi_axis_x", "a", exact[0]), ("semi_axis_y", "b", exact[1])):
        rows.append(Row(f"{words}, 160 across", "mm", value, finest["values"][key], 5e-4))
    for case, errors in published.CONTACT_PRESSURE_ERRORS.items():
        axis_x, axis_y, pressure, approach = closed_forms.hertz(1 / 810, 1 / {"a": 4000, "b": 1000, "c": 200}[case], 50e3,
                                                      210e3 / (2 * (1 - 0.3**2)))
        for across, (error, elements) in errors.items():
            model = bench.run(f"grid_{case}_{across}", f"cases/thesis_{case}.toml", ["halfspace"],
                              {"contact_grid.elements_across": across, "rolling.longitudinal_creepage": 0.0})["halfspace"]
            words, point = f"case {case}, {across} across: ", model.points[0]
            rows += [Row(f"{words}error of p0", "", error, point["max_pressure"] / pressure - 1, 2e-6, of=1.0, of_words="p0",
                         by="CONTACT"),
                     Row(f"{words}elements in contact", "", elements, model.contact_elements, 4, of=1.0, of_words="1", by="CONTACT")]
            # The edge of the patch is found below the element.
            allowed = {20: 8e-3, 40: 2.5e-3, 80: 1e-3}[across]
            rows.append(closest([Row(f"{words}{size}", unit, exact, point[key], most, by="Hertz") for size, unit, key, exact, most in (
                ("a", "mm", "semi_axis_x", axis_x, allowed), ("b", "mm", "semi_axis_y", axis_y, allowed),
                ("area", "mm²", "contact_area", np.pi * axis_x * axis_y, 2 * allowed))]))
            if (case, across) == ("a", 40):
                rows.append(at_most("case a, 40 across: error of the extrapolated p0 over that of p0", "", abs(
                    (point.richardson["max_pressure"] - pressure) / (point["max_pressure"] - pressure)), 0.2))
            if case == "a" and across in published.CONTACT_APPROACH_ERRORS:
                error, allowed = published.CONTACT_APPROACH_ERRORS[across]
                rows.append(Row(f"{words}error of the approach", "", error, point["approach"] / approach - 1, allowed, of=1.0,
                                of_words="the approach", by="CONTACT"))
    return Chapter(
        "grid-order", "Order of the half-space's pressure",
        "Case a of the study of 2012 (Hertz: p0 578.967 MPa) on 10 to 160 elements across, "
        "`rollfem study cases/thesis_a.toml`; cases a, b and c on 20 to 80.",
        "Hertz's closed form; CONTACT rev 2707 on the same grids (its discretisation of the normal problem is the "
        "same, so the digits agree); order 2 of constant elements (Kalker 1990).",
        rows, figures=[(_figure(bench, levels, exact), "Errors in p0 and approach against elements across the patch")],
        cost=[Cost(f"{n} across, seven load points", levels[n]["seconds"], levels[n]["unknowns"]) for n in (40, 160)],
        tests=["verification.HalfspaceNormal.SemiAxesOfSlenderEllipsesAreFoundAnywhereOnTheGrid"])


def _figure(bench, levels, exact):
    figure, axis = plt.subplots(figsize=(4.6, 3.4))
    across = sorted(levels)
    for key, words, value, ink, mark in (("max_pressure", "$p_0$", exact[2], "#0072B2", "o"),
                                         ("approach", "approach", exact[3], "#D55E00", "s")):
        errors = [100 * abs(levels[n]["values"][key] / value - 1) for n in across]
        axis.loglog(across, errors, color=ink, marker=mark, label=words, linewidth=1.4)
    contact = published.CONTACT_PRESSURE_A
    axis.loglog(list(contact), [100 * abs(p / exact[2] - 1) for p in contact.values()], linestyle="none",
                marker="o", markerfacecolor="none", markersize=9, color="black", label="$p_0$, CONTACT")
    guide = [100 * abs(levels[10]["values"]["max_pressure"] / exact[2] - 1) * (10 / n) ** 2 * 1.6 for n in across]
    axis.loglog(across, guide, color=style.GREY, linestyle=(0, (1, 1.5)), label="order 2")
    axis.set_xticks(across, [str(n) for n in across])
    axis.minorticks_off()
    axis.set_xlabel("elements across the patch")
    axis.set_ylabel("error against Hertz [%]")
    axis.legend()
    return bench.save(figure, "grid_order")


_FLAT = """title = "flat profile: h = {edge} mm (r/a)^{power}, a = {a} mm"
models = ["halfspace"]
[load]
normal_force = {force!r}
[friction]
coefficient = 0.0
[wheel]
young_modulus = 210e3
poisson_ratio = 0.3
[rail]
young_modulus = 210e3
poisson_ratio = 0.3
[undeformed_distance]
file = "{file}"
[rolling]
problem = "frictionless"
[contact_grid]
cell_size = [{cell!r}, {cell!r}]
"""


def _flat_run(bench, exponent, across, semi_axis, edge, force):
    """The half-space with h = edge (r/a)^(2n), given point by point."""
    name = os.path.join(os.path.abspath(bench.folder), f"flat_{exponent}.csv")
    places = np.linspace(-1.25, 1.25, 101) * semi_axis
    with open(name, "w", encoding="utf-8") as file:
        file.writelines(f"{x!r}, {y!r}, {edge * ((x * x + y * y) / semi_axis**2) ** exponent!r}\n"
                        for y in map(float, places) for x in map(float, places))
    text = _FLAT.format(edge=edge, power=2 * exponent, a=semi_axis, force=float(force), file=name, cell=2 * semi_axis / across)
    return bench.run_text(f"flat_{exponent}_{across}", text)["halfspace"]


def steuermann(bench):
    """Steuermann: bodies flatter than paraboloids"""
    semi_axis, edge, modulus = 5.0, 1e-3, 210e3 / (2 * (1 - 0.3**2))
    rows, cost = [], []
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.3))
    for exponent, ink in ((2, "#0072B2"), (3, "#D55E00")):
        force, approach, pressure = closed_forms.flat_profile(exponent, semi_axis, edge, modulus)
        fine = np.linspace(0, semi_axis, 2001)
        largest = pressure(fine).max()
        sneddon = closed_forms.sneddon(exponent, semi_axis, edge, modulus, fine[pressure(fine).argmax()])
        errors = {}
        for across in (20, 40, 80, 160):
            model = _flat_run(bench, exponent, across, semi_axis, edge, force)
            point = model.points[0]
            middle = point.fields["pressure"][np.abs(model.y) < 0.6 * semi_axis / across * 2][:, model.x > 0]
            exact = pressure(np.hypot(model.x[model.x > 0], np.abs(model.y).min()))
            inside = model.x[model.x > 0] < 0.95 * semi_axis
            errors[across] = (abs(point["approach"] / approach - 1),
                              np.sqrt(np.mean((middle[0] - exact)[inside] ** 2)) / largest)
        words = f"h = A r^{2 * exponent}"
        rows += [Row(f"{words}: approach", "mm", approach, point["approach"], 3e-5, by="160 across"),
                 Row(f"{words}: largest pressure", "MPa", largest, point["max_pressure"], 2e-4, by="160 across"),
                 Row(f"{words}: pressure along the middle, root mean square", "", 0.0, errors[160][1], 1e-4, of=1.0,
                     of_words="the largest", by="160 across"),
                 Row(f"{words}: radius of the patch", "mm", semi_axis, point["semi_axis_x"], 1.25 / 80, by="160 across"),
                 Row(f"{words}: order of the approach, 80 to 160 across", "", 2.0,
                     np.log2(errors[80][0] / errors[160][0]), 0.1),
                 *(Row(f"{words}: {name}", unit, value, by_quadrature, 1e-5, by="Sneddon's integrals")
                   for name, unit, value, by_quadrature in zip(("force", "approach", "largest pressure"), ("N", "mm", "MPa"),
                                                               (force, approach, largest), sneddon))]
        cost.append(Cost(f"{words}, 160 across", model.seconds["total"], model.unknowns))
        left.plot(fine, pressure(fine), color=ink, linewidth=1.2, label=f"$r^{2 * exponent}$")
        coarse = _flat_run(bench, exponent, 40, semi_axis, edge, force)
        row = np.abs(coarse.y).argmin()
        left.plot(np.hypot(coarse.x, coarse.y[row])[coarse.x > 0], coarse.points[0].fields["pressure"][row][coarse.x > 0],
                  linestyle="none", marker="o", markersize=3.5, color=ink)
        right.loglog(list(errors), [100 * e[0] for e in errors.values()], color=ink, marker="o", markersize=4,
                     label=f"approach, $r^{2 * exponent}$")
        right.loglog(list(errors), [100 * e[1] for e in errors.values()], color=ink, marker="s", markersize=4,
                     linestyle="--", label=f"pressure, $r^{2 * exponent}$")
    left.set_xlim(0, 1.1 * semi_axis)
    left.set_xlabel("r [mm]")
    left.set_ylabel("pressure [MPa]")
    left.legend()
    right.set_xticks([20, 40, 80, 160], ["20", "40", "80", "160"])
    right.minorticks_off()
    right.set_xlabel("elements across the patch")
    right.set_ylabel("error [%]")
    right.legend(fontsize="small")
    figure.tight_layout()
    return Chapter(
        "steuermann", "Steuermann: bodies flatter than paraboloids",
        "Steel, h = 0.001 mm (r/a)^4 and (r/a)^6 with a = 5 mm, given point by point in a file; the force is that of the "
        "closed form, P = 64 E* A a^5/15 and 192 E* A a^7/35.",
        "Steuermann (1939) by Sneddon's integrals, which are also evaluated by quadrature: approach 8 A a^4/3 and "
        "16 A a^6/5, pressure 32 E* A sqrt(a^2 - r^2) (a^2 + 2 r^2)/(9 pi) for the fourth power, largest not in the "
        "middle but at "
        "r = a/sqrt(2).",
        rows, figures=[(bench.save(figure, "steuermann"),
                        "Pressure over the radius (lines: closed form, marks: 40 across), and errors against the grid")],
        cost=cost, after="The radius is found from the square of the pressure over three elements inside the edge, which is straight "
              "under Hertz's pressure only: here it is known to an element or so (2 a/n).")
