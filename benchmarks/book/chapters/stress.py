# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subsurface stress of half-spaces and finite elements."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.stresses import stress_measures as measures

from .. import closed_forms, published, style
from ..chapter import Chapter, Cost, Row, closest
from .line_stress import line_rows

MODULUS = 210e3 / (2 * (1 - 0.3**2))  # E* of two steels, MPa


def _peak(depth, value):
    """(value, place) of the largest value, by the parabola through the three highest points."""
    k = int(np.clip(np.argmax(value), 1, len(value) - 2))
    (left, middle, right), step = value[k - 1:k + 2], depth[1] - depth[0]
    bend = left - 2 * middle + right
    move = 0.5 * (left - right) / bend
    return middle - 0.25 * (left - right) * move, depth[k] + move * step


def _circle(bench, name, across=80, nu=0.3, more=""):
    """(depth over a, stresses over p0, the point) on the axis below the circle of the case; a and p0 of nu = 0.3 and another force."""
    modulus = 210e3 / (2 * (1 - nu**2))
    model = bench.run(f"circle_{name}", "cases/verification/circle_stress.toml", settings={
        "contact_grid.elements_across": across, "wheel.transverse_radius": f"inf\npoisson_ratio = {nu}",
        "rail.transverse_radius": f"405.0\npoisson_ratio = {nu}", "+": more})["halfspace"]
    a, _, p0, _ = closed_forms.hertz(1 / 810, 1 / 810, 20e3, modulus)
    line = model.points[0].subsurface[0]
    return -line["points"][:, 2] / a, line["stress"] / p0, model.points[0], a, p0


def _difference_on_axis(depth, stress, nu):
    """Largest deeper than a tenth of the radius, over p0."""
    below = depth > 0.1
    radial, vertical = closed_forms.circle_axis_stress(depth[below], nu)
    return max(np.abs(stress[below][:, [0, 1]] - radial[:, None]).max(), np.abs(stress[below, 2] - vertical).max())


def _circle_rows(bench):
    """Other Poisson's ratios, order, and tension at the surface."""
    rows = []
    for nu in (0.25, 0.28, 0.4999):
        depth, stress, *_ = _circle(bench, f"nu_{nu:g}", nu=nu)
        shear, at = _peak(depth, 0.5 * (stress[:, 0] - stress[:, 2]))
        fine = np.linspace(0.3, 0.7, 400001)
        radial, vertical = closed_forms.circle_axis_stress(fine, nu)
        k = np.argmax(radial - vertical)
        mises = measures(stress)["von_mises"].max()
        rows += [Row(f"nu = {nu:g}: largest shear over p0", "", 0.5 * (radial - vertical)[k], shear, 1e-3, by="half-space, 80 across"),
                 Row(f"nu = {nu:g}: its depth over a", "", fine[k], at, 2e-3, of=1.0, of_words="a", by="half-space, 80 across"),
                 Row(f"nu = {nu:g}: largest von Mises stress over p0", "", (radial - vertical)[k], mises, 1e-3, by="half-space, 80 across")]
    errors = {across: _difference_on_axis(*_circle(bench, f"{across}", across)[:2], 0.3) for across in (20, 80)}
    rows.append(Row("order of the stress on the axis, 20 to 80 across, up to 1.7", "", 1.7,
                    min(1.7, np.log(errors[20] / errors[80]) / np.log(4)), 1e-9))
    # Radial (1 - 2 nu) p0 a^2/(3 r^2) beside the circle, hoop the opposite; y = 0 is the middle of a row.
    a = closed_forms.hertz(1 / 810, 1 / 810, 20e3, MODULUS)[0]
    line = "".join(f'\n[[subsurface.surface]]\nbody = "rail"\nfrom = [{first * a}, 0.0]\nto = [{last * a}, 0.0]\npoints = {count}\n'
                   for first, last, count in ((1.05, 3.0, 40), (1 + 0.5 / 81, 1.05, 2)))
    _, _, point, a, p0 = _circle(bench, "surface", 81, more=line)
    beside, edge = point.subsurface[1:]
    r, stress = beside["points"][:, 0] / a, beside["stress"] / p0
    exact = 0.4 / (3 * r * r)
    rows += [closest([Row(f"beside the circle: {words} stress", "p0", sign * e, s, 5e-3 * e + 1e-3, of=1.0, of_words="p0",
                          by="half-space, 81 across") for e, s in zip(exact, stress[:, component])])
             for words, component, sign in (("radial", 0, 1), ("hoop", 1, -1))]
    assert np.abs(stress[:, 2]).max() < 1e-14
    return [*rows, Row("at the edge of the circle: radial stress", "p0", 0.4 / 3, edge["stress"][0, 0] / p0, 6e-3, of=1.0, of_words="p0",
                       by="half-space, 81 across")]


def stress_circle(bench):
    """Stress below Hertz's circle and line"""
    model = bench.run("circle_stress", "cases/verification/circle_stress.toml")["halfspace"]
    a, _, p0, _ = closed_forms.hertz(1 / 810, 1 / 810, 20e3, MODULUS)
    line = model.points[0].subsurface[0]
    depth, stress = -line["points"][:, 2], line["stress"]
    radial, vertical = (p0 * s for s in closed_forms.circle_axis_stress(depth / a, 0.3))
    below = depth > 0.1 * a
    worst = max(np.abs(stress[below, 0] - radial[below]).max(), np.abs(stress[below, 2] - vertical[below]).max())
    shear, at = _peak(depth, 0.5 * (stress[:, 0] - stress[:, 2]))
    fine = np.linspace(0.3, 0.7, 400001)
    exact = closed_forms.circle_axis_stress(fine, 0.3)
    k = np.argmax(exact[0] - exact[1])
    exact_shear, exact_depth = 0.5 * (exact[0] - exact[1])[k], fine[k]
    rows = [Row("stress deeper than 0.1 a: largest difference", "MPa", 0.0, worst, 1.5e-4, of=p0, of_words="p0",
                by="half-space, 80 across"),
            Row("largest shear over p0", "", exact_shear, shear / p0, 1e-3, by="half-space, 80 across"),
            Row("its depth over a", "", exact_depth, at / a, 4e-3, by="half-space, 80 across")]
    rows += [*_circle_rows(bench), *line_rows(bench)]
    cost = [Cost("half-space with 161 points", model.seconds["total"], model.unknowns)]
    if bench.has_fem:
        found = bench.test("verification_fem:FemCircle.LargestShearStressIsThatOfHertzAndItsPlace")
        for body in ("wheel", "rail"):
            rows.append(Row("largest shear over p0", "", exact_shear, found[f"{body}_shear_over_p0"], 0.01,
                            by=f"FEM, a/8, {body}"))
            rows.append(Row("its depth over a", "", exact_depth, found[f"{body}_depth_over_a"], 0.02, of=1.0,
                            of_words="a", by=f"FEM, a/8, {body}"))
        cost.append(Cost("FEM, the test", found["seconds"]))
    figure, axis = plt.subplots(figsize=(4.4, 3.8))
    for values, exact_values, words, ink in (
            (stress[:, 0], radial, r"$\sigma_r$", "#0072B2"), (stress[:, 2], vertical, r"$\sigma_z$", "#D55E00"),
            (measures(stress)["von_mises"], np.abs(vertical - radial), "von Mises", "#009E73")):
        axis.plot(exact_values / p0, depth / a, color=ink, linewidth=1.2, label=words)
        axis.plot(values[::5] / p0, depth[::5] / a, linestyle="none", marker="o", markersize=3, color=ink)
    axis.plot([], [], color=style.GREY, linewidth=1.2, label="closed form")
    axis.plot([], [], color=style.GREY, linestyle="none", marker="o", markersize=3, label="half-space")
    axis.invert_yaxis()
    axis.set_xlabel("stress over $p_0$")
    axis.set_ylabel("depth over $a$")
    axis.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    name = bench.save(figure, "stress_circle")
    return Chapter(
        "stress-circle", "Stress below Hertz's circle and line",
        "Wheel and rail of 405 mm, 20 kN, nu = 0.3, no friction ([case](../../cases/verification/circle_stress.toml)); steel "
        "cylinders of a = 1 mm that slide along and across; Norton's crane wheel (Machine Design, example 7-2).",
        "the closed form on the axis of the circle (Johnson 1985, 3.45), its largest shear found to six digits, and beside it; "
        "McEwen (1949) and antiplane shear in closed form below lines.", rows,
        figures=[(name, "Stress on the axis; lines: closed form, marks: half-space")], cost=cost,
        tests=["verification.LineStress.IsThatOfLongElements", "verification.fem_circle_stress"])


def _digit_rows(bench, p0):
    """All components and the displacement on 80 across."""
    point = bench.run("stress_a_fine", "cases/subsurface_a.toml", ["halfspace"], {
        "friction.coefficient": 0.0, "rolling.longitudinal_creepage": "[0.0]", "contact_grid.elements_across": 80})["halfspace"].points[0]
    stresses, moves = [], []
    for body in ("wheel", "rail"):
        line = next(s for s in point.subsurface if s["kind"] == "line" and s["body"] == body)
        for z, contact in published.CONTACT_STRESS_A.items():
            k = np.abs(np.abs(line["points"][:, 2]) - z).argmin()
            exact = np.array([*contact[:3], 0.0, 0.0, 0.0, contact[3]])
            found = np.array([*line["stress"][k], measures(line["stress"][[k]])["von_mises"][0]])
            at = f"at {z:g} mm in the {body}"
            stresses.append(Row(f"stress {at}: largest difference of a component", "MPa", 0.0, np.abs(found - exact).max(), 2e-4, of=p0,
                                of_words="p0", by="half-space, 80 across"))
            moves.append(Row(f"displacement {at}", "mm", published.CONTACT_DISPLACEMENT_A[z], abs(line["displacement"][k, 2]), 5e-4,
                             by="half-space, 80 across"))
    return [closest(stresses), closest(moves)]


def stress_case_a(bench):
    """Stress below case a against CONTACT, half-space and finite elements"""
    models = ["halfspace"] + (["fem"] if bench.has_fem else [])
    result = bench.run("stress_a", "cases/subsurface_a.toml", models,
                       {"friction.coefficient": 0.0, "rolling.longitudinal_creepage": "[0.0]"})
    p0 = closed_forms.hertz(1 / 810, 1 / 4000, 50e3, MODULUS)[2]
    rows, cost, lines = [], [], []
    for model in result.models:
        bodies = ("wheel", "rail") if model.name == "fem" else ("rail",)
        for body in bodies:
            line = next(s for s in model.points[0].subsurface if s["kind"] == "line" and s["body"] == body)
            depth = np.abs(line["points"][:, 2])
            worst = {"sxx": 0.0, "syy": 0.0, "szz": 0.0, "von Mises": 0.0}
            for z, contact in published.CONTACT_STRESS_A.items():
                s = line["stress"][np.abs(depth - z).argmin()]
                ours = (s[0], s[1], s[2], measures([s])["von_mises"][0])
                for key, mine, theirs in zip(worst, ours, contact):
                    worst[key] = max(worst[key], mine - theirs, key=abs)
            by = "FEM, 0.47 mm, " + body if model.name == "fem" else "half-space, 40 across"
            for key, value in worst.items():
                rows.append(Row(f"{key}: largest difference over eight depths", "MPa", 0.0, value,
                                0.01 if model.name == "fem" else 0.002, of=p0, of_words="p0", by=by))
            lines.append((model, body, depth, measures(line["stress"])["von_mises"]))
        cost.append(Cost(style.label(model), model.seconds["total"], model.unknowns))
    rows += _digit_rows(bench, p0)
    figure, axis = plt.subplots(figsize=(4.4, 3.8))
    for model, body, depth, value in lines:
        if model.name == "halfspace" or body == "rail":
            ink, dash = ("#0072B2", "-") if model.name == "halfspace" else ("#D55E00", (0, (5, 2)))
            axis.plot(value, depth, color=ink, linestyle=dash, linewidth=1.3,
                      label="half-space" if model.name == "halfspace" else "FEM, rail")
    contact = published.CONTACT_STRESS_A
    axis.plot([s[3] for s in contact.values()], list(contact), linestyle="none", marker="o", markersize=5,
              markerfacecolor="none", color="black", label="CONTACT")
    axis.invert_yaxis()
    axis.set_xlabel("von Mises stress [MPa]")
    axis.set_ylabel("depth [mm]")
    axis.legend()
    name = bench.save(figure, "stress_case_a")
    return Chapter(
        "stress-case-a", "Stress below case a",
        "The middle of the patch of case a, normal load, depths 0.5 to 12 mm ([case](../../cases/subsurface_a.toml) without "
        "friction).",
        "CONTACT rev 2707 (160 elements across), six digits printed.", rows,
        figures=[(name, "Von Mises stress below the middle of the patch")], cost=cost,
        tests=["verification.fem_case_a"])
