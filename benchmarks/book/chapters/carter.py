# SPDX-License-Identifier: LGPL-2.1-or-later
"""Like cylinders: Hertz's line, Carter's rolling, and what bodies of finite width add."""
import numpy as np
from matplotlib import pyplot as plt

from .. import closed_forms, published
from ..chapter import Chapter, Cost, Row, closest


def _carter_patch():
    """(a, b, p0, E*) of cases/carter_line.toml."""
    modulus = 210e3 / (2 * (1 - 0.3**2))
    a, b, pressure, _ = closed_forms.hertz(1 / 1000, 1 / 2e6, 14e3, modulus)
    return a, b, pressure, modulus


def _carter_curve(creepage):
    """-F_x of a very wide ellipse with Carter's solution in every strip, N."""
    a, b, pressure, modulus = _carter_patch()
    y = (np.arange(2000) + 0.5) / 2000
    narrower = np.sqrt(1 - y**2)
    return 2 * b * np.mean([closed_forms.carter_force(a * s, pressure * s, 0.3, modulus, creepage)
                            for s in narrower])


ROLLERS = """[load]
normal_force = {load!r}
[friction]
coefficient = {friction!r}
[wheel]
{wheel}
[rail]
""" + published.CONTACT_STEEL + """
[geometry]
shape = "line"
{geometry}
[rolling]
{rolling}
[contact_grid]
elements_across = {across}
"""
STEEL = f"rolling_radius = 500.0\n{published.CONTACT_STEEL}"
LOAD, LARGEST = 178.89625, 2 * 178.89625 / np.pi  # N/mm, MPa: a = 1 mm
FRICTION, MODULUS = 0.3, published.CONTACT_MODULUS  # mu and E* in MPa
PARTS = (0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 1.1)  # of the creepage of full sliding, 6e-4


def _cylinders(bench):
    """({elements: largest error of the force over mu P}, part of the bars that hold of force and of adhesion area)."""
    worst, held = {}, {"longitudinal_force": [], "adhesion_area": []}
    creepages = [part * 6e-4 for part in PARTS]
    for n in (10, 20, 40, 80, 160):
        text = ROLLERS.format(load=LOAD, friction=FRICTION, wheel=STEEL, geometry="", across=n,
                               rolling=f"longitudinal_creepage = {creepages}")
        worst[n] = 0.0
        for point in bench.run_text(f"carter_cylinders_{n}", text, ["halfspace"])["halfspace"].points:
            xi = point["longitudinal_creepage"]
            exact = {"longitudinal_force": -closed_forms.carter_force(1.0, LARGEST, FRICTION, MODULUS, xi),
                     "adhesion_area": 2 * max(0.0, 1 - xi / 6e-4)}
            for name, value in exact.items():
                held[name].append(abs(point[name] - value) <= point.bar(name))
            worst[n] = max(worst[n], abs(point["longitudinal_force"] - exact["longitudinal_force"]) / (0.3 * LOAD))
    return worst, {name: np.mean(holds) for name, holds in held.items()}


def _rolled(bench, name, rolling, across=40, geometry="", load=LOAD, model="halfspace", more=""):
    """Steel cylinders of 500 mm, a = 1 mm."""
    text = ROLLERS.format(load=load, friction=FRICTION, wheel=STEEL, geometry=geometry, rolling=rolling, across=across)
    return bench.run_text(f"line_{name}", text + more, [model])[model]


def _hertz_rows(bench):
    """Hertz's line, and what refers to the width and to the reference distance."""
    point = _rolled(bench, "hertz", "longitudinal_creepage = 0.0").points[0]
    rows = [Row("line: p0", "MPa", LARGEST, point["max_pressure"], min(5e-4, point.bar("max_pressure") / LARGEST)),
            Row("line: a", "mm", 1.0, point["semi_axis_x"], point.bar("semi_axis_x")),
            Row("line: area", "mm²/mm", 2.0, point["contact_area"], 5e-4),
            Row("line: approach", "mm", closed_forms.line_approach(LOAD, 1.0, MODULUS, 500.0), point["approach"], 1e-4)]
    rolling = "longitudinal_creepage = 2.4e-4"
    narrow = _rolled(bench, "narrow", rolling).points[0]
    wide = _rolled(bench, "wide", rolling, geometry="width = 20.0\nreference_distance = 2000.0", load=20 * LOAD).points[0]
    rows += [Row(f"20 mm wide: {words} over that of 1 mm", "", ratio, wide[key] / narrow[key], allowed) for key, words, ratio, allowed in (
        ("longitudinal_force", "F_x", 20, 5e-6), ("contact_area", "area", 20, 5e-6), ("max_pressure", "p0", 1, 1e-6))]
    rows.append(Row("approach moved by a reference four times as far", "mm", 2 * LOAD / (np.pi * MODULUS) * np.log(4),
                    wide["approach"] - narrow["approach"], 1e-6))
    assert point["contact_width"] == 1.0
    assert [narrow.no_bar[key] for key in ("approach", "elastic_energy", "contact_width")] == ["relative", "relative", "given"]
    return rows


def _carter_rows(bench):
    """Traction and slip element by element, the model carter, lateral creepage, and steps from rest."""
    xi = 2.4e-4
    model = _rolled(bench, "guide", f"longitudinal_creepage = {xi}", 100)
    point = model.points[0]
    away = (np.abs(model.x) < 0.97) & (np.abs(model.x + 0.2) > 0.031)  # square roots begin there
    traction = closed_forms.carter_traction(model.x, 1.0, LARGEST, FRICTION, MODULUS, xi)
    slip = closed_forms.carter_slip(model.x, 1.0, FRICTION, 500.0, xi)
    rows = [Row("cylinders, a' = 0.6 a: F_x", "mu P", -0.64, point["longitudinal_force"] / (FRICTION * LOAD), 1e-3),
            Row("cylinders, a' = 0.6 a: largest difference of the traction", "MPa", 0.0,
                np.abs(point["traction_x"][0] + traction)[away].max(), 0.01, of=FRICTION * LARGEST, of_words="mu p0"),
            Row("cylinders, a' = 0.6 a: largest difference of the slip", "", 0.0, np.abs(point["slip_x"][0] - slip)[away].max(),
                0.02, of=xi, of_words="xi")]
    forces, areas, across = [], [], []
    curve = [part * 6e-4 for part in PARTS]
    for here in _rolled(bench, "theory", f"longitudinal_creepage = {curve}", model="carter").points:
        stick = max(0.0, 1 - here["longitudinal_creepage"] / 6e-4)
        forces.append(Row("cylinders: F_x", "mu P", stick**2 - 1, here["longitudinal_force"] / (FRICTION * LOAD), 1e-6, of=1.0,
                          of_words="mu P", by="model carter"))
        areas.append(Row("cylinders: area of adhesion", "mm²", 2 * stick, here["adhesion_area"], 1e-6, of=1.0, of_words="1 mm²",
                         by="model carter"))
        assert here.no_bar["longitudinal_force"] == "exact"
    # u_y under p_y is 1/(1 - nu) of u_x under p_x: antiplane shear is Carter's, steeper by it in the creepage.
    for here in _rolled(bench, "antiplane", f"lateral_creepage = {curve}").points:
        exact = closed_forms.carter_force(1.0, LARGEST, FRICTION, MODULUS, 0.72 * here["lateral_creepage"])
        across.append(Row("cylinders, lateral creepage: F_y", "mu P", -exact / (FRICTION * LOAD),
                          here["lateral_force"] / (FRICTION * LOAD), 1e-3, of=1.0, of_words="mu P"))
        assert abs(here["longitudinal_force"]) <= 1e-9
    # The nearer the reference the stiffer the shift, and the shorter the way to the steady state.
    history = _rolled(bench, "steps", f'problem = "transient"\nlongitudinal_creepage = {xi}', 20, "reference_distance = 5.0",
                      more="[history]\nsteps = 40\nstep_length = 0.5\n")
    steady = _rolled(bench, "narrow", f"longitudinal_creepage = {xi}").points[0]["longitudinal_force"]
    last = history.points[-1]
    assert abs(last["distance"] - 20.0) < 1e-9 and abs(history.points[0]["longitudinal_force"]) < 0.5 * abs(steady)
    return [*rows, closest(forces), closest(areas), closest(across),
            Row("cylinders: F_x after 20 mm of steps from rest", "N/mm", steady, last["longitudinal_force"], 0.02)]


def _finite_rows(bench):
    """Rollers 20 mm wide, pushed by half of what friction bears, shift as the middle of a line load of that length.

    By Cattaneo, mu times Hertz's pressure less mu times that of the half width c, c^2/a^2 = 1/2; the distance of reference of
    a load of length L is L exp(nu/(1 - nu)) along x and L exp(-nu) along y, where 1/(1 - nu) more gives way.
    """
    nu, length = 0.28, 20.0
    force = 0.5 * FRICTION * LOAD * length

    def pushed(direction, reference):
        return _rolled(bench, f"{direction}_{reference}", f'problem = "shift"\n{direction}_force = {force}', 200,
                       f"width = {length}\nreference_distance = {reference}", length * LOAD).points[0]

    def shift(distance):
        return FRICTION * (closed_forms.line_approach(LOAD, 1.0, MODULUS, distance)
                           - closed_forms.line_approach(LOAD / 2, np.sqrt(0.5), MODULUS, distance))
    x, y, near = pushed("longitudinal", "inf"), pushed("lateral", "inf"), pushed("longitudinal", "20.0")
    moved = 2 * nu * force / (np.pi * 82e3 * length)  # all of the patch alike
    assert "approach" not in x.no_bar and "elastic_energy" not in x.no_bar
    return [Row("20 mm wide: shift along", "mm", -shift(length * np.exp(nu / (1 - nu))), x["longitudinal_shift"], 1e-3),
            Row("20 mm wide: shift across", "mm", -shift(length * np.exp(-nu)) / (1 - nu), y["lateral_shift"], 1e-3),
            Row("20 mm wide: shift less that of the surface at 20 mm", "mm", moved, near["longitudinal_shift"] - x["longitudinal_shift"], 1e-4),
            Row("20 mm wide: energy less that of the surface at 20 mm", "N mm", force * moved / 2,
                x["elastic_energy"] - near["elastic_energy"], 1e-4)]


def carter(bench):
    """Carter: steady rolling of like cylinders"""
    result = bench.run("carter", "cases/carter_line.toml", ["halfspace", "carter"])
    half, theory = result["halfspace"], result["carter"]
    plane, held = _cylinders(bench)
    rows = []
    for point, other in zip(half.points, theory.points):
        xi = point["longitudinal_creepage"]
        if xi == 0:
            continue
        exact = _carter_curve(xi) / 14e3
        rows.append(Row(f"-F_x/F_z at xi = {100 * xi:g} %", "", exact, point["traction_coefficient"], 0.006,
                        of=0.3, of_words="mu", by="half-space, 24 across"))
        rows.append(Row(f"-F_x/F_z at xi = {100 * xi:g} %", "", exact, other["traction_coefficient"], 1e-3,
                        of=0.3, of_words="mu", by="model carter"))
    for n, most in ((40, 0.001), (80, 2.5e-4)):
        rows.append(Row(f"cylinders, {n} elements: largest error of the force", "mu P", 0.0, plane[n],
                        most, of=1.0, of_words="mu P", by="half-space in the plane"))
    rows += [Row(f"cylinders: order of the force, {n} to {4 * n} elements", "", 2.0, np.log2(plane[n] / plane[4 * n]) / 2, most,
                 by="half-space in the plane") for n, most in ((10, 0.3), (20, 0.25))]
    rows.append(Row("cylinders: order of the force, 40 to 80 elements", "", 2.0, np.log2(plane[40] / plane[80]), 0.15,
                    by="half-space in the plane"))
    rows += [Row(f"cylinders: part of the bars of the {words} that hold", "", 1.0, held[name], 0.1, by="half-space in the plane")
             for name, words in (("longitudinal_force", "force"), ("adhesion_area", "area of adhesion"))]
    rows += [*_hertz_rows(bench), *_carter_rows(bench), *_finite_rows(bench)]
    figure = _carter_figure(bench, half)
    orders = [np.log2(plane[n] / plane[2 * n]) for n in (20, 40, 80)]
    return Chapter(
        "carter", "Carter: steady rolling of like cylinders",
        "A patch a hundred times as wide as long, mu = 0.3 ([case](../../cases/carter_line.toml)): every strip "
        "rolls like a cylinder. In addition, plane cylinders by the line compliance, a = 1 mm, R = 500 mm.",
        "Carter (1926), strip by strip: a', force and traction in closed form.",
        rows, figures=[(figure, "Tangential traction through the middle; lines: Carter, marks: half-space")],
        cost=[Cost("half-space, six load points", half.seconds["total"], half.unknowns)],
        tests=["verification.LineContact.OfFiniteWidthIsAnElementOfContact", "unit.Carter.GivesTheBenchmark"],
        after="Order of the force of cylinders from 20, 40 and 80 elements to twice as many: "
              + ", ".join(f"{o:.2f}" for o in orders) + ".")


def _carter_figure(bench, half):
    a, _, pressure, modulus = _carter_patch()
    figure, axis = plt.subplots(figsize=(4.8, 3.3))
    x = np.linspace(-1.05 * a, 1.05 * a, 500)
    row = np.abs(half.y).argmin()
    for point, ink in zip([half.nearest(xi) for xi in (1e-4, 2e-4, 4e-4)], ("#56B4E9", "#0072B2", "#D55E00")):
        xi = point["longitudinal_creepage"]
        axis.plot(x, closed_forms.carter_traction(x, a, pressure, 0.3, modulus, xi), color=ink, linewidth=1.2)
        axis.plot(half.x, -point.fields["traction_x"][row], linestyle="none", marker="o", markersize=3.5, color=ink,
                  label=f"xi = {100 * xi:g} %")
    axis.set_xlabel("x, rolling to the right [mm]")
    axis.set_ylabel("$-p_x$ [MPa]")
    axis.set_ylim(top=axis.get_ylim()[1] * 1.3)
    axis.legend(ncol=3, loc="upper center", handletextpad=0.1, columnspacing=1.0)
    return bench.save(figure, "carter")


