# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subsurface stress of half-spaces and finite elements."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.stresses import stress_measures as measures

from .. import closed_forms, published, style
from ..chapter import Chapter, Cost, Row

MODULUS = 210e3 / (2 * (1 - 0.3**2))  # E* of two steels, MPa


def _peak(depth, value):
    """(value, place) of the largest value, by the parabola through the three highest points."""
    k = int(np.clip(np.argmax(value), 1, len(value) - 2))
    (left, middle, right), step = value[k - 1:k + 2], depth[1] - depth[0]
    bend = left - 2 * middle + right
    move = 0.5 * (left - right) / bend
    return middle - 0.25 * (left - right) * move, depth[k] + move * step


def stress_circle(bench):
    """Stress on the axis below Hertz's circle"""
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
    axis.invert_yaxis()
    axis.set_xlabel("stress over $p_0$")
    axis.set_ylabel("depth over a")
    axis.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    name = bench.save(figure, "stress_circle")
    return Chapter(
        "stress-circle", "Stress on the axis below Hertz's circle",
        "Wheel and rail of 405 mm, 20 kN, nu = 0.3, no friction ([case](../../cases/verification/circle_stress.toml)).",
        "the closed form on the axis (Johnson 1985, 3.45); its largest shear found to six digits.", rows,
        figures=[(name, "Stress on the axis; lines: closed form, marks: half-space")], cost=cost,
        tests=["verification.SubsurfaceHertz.StressOnTheAxisOfTheCircleConverges",
               "verification.SubsurfaceHertz.LargestShearBelowTheCircle", "verification.fem_circle_stress"])


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
        tests=["verification.SubsurfaceHertz.CaseAOfContact", "verification.fem_case_a"])
