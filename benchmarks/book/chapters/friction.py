# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction without steady rolling: pushing, pressing, and creepage that oscillates."""
import re

import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import ADHESION

from .. import closed_forms, style
from ..chapter import Chapter, Cost, Row, at_most

# Benchmark 3: two like bodies of G = 200, nu = 0.42, A = B = 0.01 1/mm, mu = 0.4; a = 1 mm
FORCE, FRICTION, SHEAR_MODULUS, POISSON = 9.1954, 0.4, 200.0, 0.42


_PUSHED = """[load]
normal_force = {force!r}
[friction]
coefficient = 0.4
[undeformed_distance]
quadratic = [0.01, 0.01]
[wheel]
young_modulus = {modulus!r}
poisson_ratio = {nu!r}
[rail]
young_modulus = {modulus!r}
poisson_ratio = {nu!r}
[rolling]
problem = "shift"
longitudinal_force = {pushes}
[contact_grid]
elements_across = {across}
"""
_CYCLE = (0.875, 0.8085, 0.6187, 0.3348, 0.0, -0.3348, -0.6187, -0.8085, -0.875, -0.8085, -0.6187, -0.3348, 0.0, 0.3348,
          0.6187, 0.8085, 0.875)


def _pushed(bench, nu, parts, across):
    """(model, force) of spheres with a = 1 mm, pushed with these parts of mu F_z one after the other."""
    force = 4 / 3 * SHEAR_MODULUS / (1 - nu) / 50
    text = _PUSHED.format(force=force, nu=nu, modulus=2 * SHEAR_MODULUS * (1 + nu), across=across,
                          pushes=[-part * FRICTION * force for part in parts])
    return bench.run_text(f"pushed_{nu:g}_{len(parts)}", text, ["halfspace"])["halfspace"], force


def _stick_radius(model, point):
    """Radius of the area of adhesion over that of the patch, below the element: where adhesion ends, what the traction falls short of
    its bound by has a square that is linear. Both ways of cutting the patch into rows are averaged."""
    fields = point.fields
    rest = np.where(fields["state"] == ADHESION,
                    fields["traction_bound"] - np.hypot(fields["traction_x"], fields["traction_y"]), 0.0)

    def covered(rows):
        length = 0.0
        for row in rows:
            inside = np.flatnonzero(row > 0)
            length += len(inside)
            if len(inside) >= 10:
                for three in (inside[:3], inside[:-4:-1]):
                    length -= np.roots(np.polyfit(range(3), row[three] ** 2, 1))[0] + 0.5
        return length
    return np.sqrt((covered(rest) + covered(rest.T)) / 2 * model.dx * model.dy / point["contact_area"])


def _work_lost(model):
    area = (model.x[1] - model.x[0]) * (model.y[1] - model.y[0])
    return -area * sum(np.sum(point.fields[f"traction_{axis}"] * point.fields[f"slip_{axis}"])
                       for point in model.points[1:] for axis in "xy")


def _pushed_rows(bench):
    """Pushed by 7/8 mu F_z and back, and in cycles."""
    rows, part = [], 7 / 8
    for nu, of_shift, of_loss in ((0.0, 5e-4, 0.003), (POISSON, 3e-3, 0.01)):
        model, force = _pushed(bench, nu, (part, 0.0), 40)
        law = (1.0, force, FRICTION, SHEAR_MODULUS, nu)
        loaded, back = model.points
        words = f"pushed by 7/8 mu F_z, nu = {nu:g}"
        whole = closed_forms.mindlin_shift(*law, part)
        rows += [Row(f"{words}: approach", "mm", 0.02, loaded["approach"], 1e-3),
                 Row(f"{words}: shift", "mm", whole, loaded["longitudinal_shift"], of_shift),
                 Row(f"{words}: p0", "MPa", 1.5 * force / np.pi, loaded["max_pressure"], 1e-3),
                 Row(f"{words}: force", "N", -part * FRICTION * force, loaded["longitudinal_force"], 3e-5)]
        rows.append(Row(f"{words}: radius of the adhesion area", "mm", 0.5, _stick_radius(model, loaded), 3e-3 if nu else 6e-3))
        if nu == 0:
            rows.append(Row(f"{words}: shift left when released", "mm", whole - 2 * closed_forms.mindlin_shift(*law, part / 2),
                            back["longitudinal_shift"], 2e-3, of=whole, of_words="the shift"))
            r = np.hypot(*np.meshgrid(model.x, model.y))
            peak, elements = FRICTION * loaded["max_pressure"], np.pi / ((model.x[1] - model.x[0]) * (model.y[1] - model.y[0]))
            shape = (1.0, 1.5 * force / np.pi, FRICTION)
            first = closed_forms.mindlin_traction(r, *shape, part)
            for point, exact, allowed, when in ((loaded, first, 0.01, "pushed"),
                                                (back, first - 2 * closed_forms.mindlin_traction(r, *shape, part / 2), 0.02, "released")):
                off = np.sum(np.abs(point.fields["traction_x"] + exact)) / elements
                rows.append(Row(f"tractions when {when}, nu = 0: mean difference", "MPa", 0.0, off, allowed, of=peak, of_words="mu p0"))
            rows += _shifted_on(bench, force, law)
        cycle = _pushed(bench, nu, _CYCLE, 30)[0]
        rows.append(Row(f"work lost in a cycle, nu = {nu:g}", "N mm", closed_forms.mindlin_loss(*law, part), _work_lost(cycle), of_loss))
        if nu == 0:
            rows.append(Row("shift at the end of the cycle", "mm", cycle.points[0]["longitudinal_shift"],
                            cycle.points[-1]["longitudinal_shift"], 1e-3, by="at its beginning"))
    return rows


def _shifted_on(bench, force, law):
    """A shift goes on where a force has led to."""
    unit, way = FRICTION * force, [closed_forms.mindlin_shift(*law, part) for part in (0.5, 0.8)]
    text = _PUSHED.format(force=force, nu=0.0, modulus=2 * SHEAR_MODULUS, across=40, pushes=f"[{-0.5 * unit}, nan]")
    point = bench.run_text("pushed_and_shifted", f"{text}[history]\nlongitudinal_shift = [0.0, {way[1] - way[0]}]\n",
                           ["halfspace"])["halfspace"].points[1]
    return [Row("pushed by mu F_z/2 and shifted on: shift", "mm", way[1], point["longitudinal_shift"], 1e-3),
            Row("pushed by mu F_z/2 and shifted on: force", "mu F_z", -0.8, point["longitudinal_force"] / unit, 1.25e-3)]


def cattaneo(bench):
    """Cattaneo and Mindlin: a sphere pushed back and forth"""
    result = bench.run("cattaneo", "cases/cattaneo.toml")
    model = result["halfspace"]
    radius, _, pressure, approach = closed_forms.hertz(0.01, 0.01, FORCE, SHEAR_MODULUS / (1 - POISSON))
    pushed = model.points[2]  # the shift after the third step is 0.008172 mm
    shift = pushed["longitudinal_shift"]
    part = closed_forms.mindlin_part(radius, FORCE, FRICTION, SHEAR_MODULUS, POISSON, shift)
    rows = [Row("p0", "MPa", pressure, pushed["max_pressure"], 1e-3),
            Row("approach", "mm", approach, pushed["approach"], 1e-3),
            Row(f"force at a shift of {shift:.6f} mm", "N", part * FRICTION * FORCE, -pushed["longitudinal_force"],
                0.005, of=FRICTION * FORCE, of_words="mu F_z"),
            Row("radius of the adhesion area", "mm", radius * (1 - part) ** (1 / 3),
                np.sqrt(pushed["adhesion_area"] / np.pi), 0.02), *_pushed_rows(bench)]
    return Chapter(
        "cattaneo", "Cattaneo and Mindlin: a sphere pushed back and forth",
        "Like bodies, G = 200 MPa, nu = 0.42, R = 50 mm, 9.1954 N, mu = 0.4, so that a = 1 mm; pushed by 0.008172 "
        "mm, back, and forth again ([case](../../cases/cattaneo.toml)); 40 elements across. The work lost is that "
        "of cycles of +-7/8 mu F_z at 30 across.",
        "Cattaneo (1938), Mindlin (1949), Mindlin and Deresiewicz (1953). The closed form neglects the traction "
        "across the push, which is exact for nu = 0 alone: with nu = 0.42 it is an approximation itself. The "
        "adhesion area is counted by elements in the first rows.",
        rows, figures=[(_loop(bench, model, radius), "Traction through the middle after 0.008172 mm, and the loop of "
                        "force over shift; lines: closed form, marks: half-space")],
        cost=[Cost("15 steps", model.seconds["total"], model.unknowns)])


def _masing(shift, from_shift, from_part, radius, sign):
    """Fraction of mu F_z on the way back from a turning point: twice the first curve (Masing)."""
    half = closed_forms.mindlin_part(radius, FORCE, FRICTION, SHEAR_MODULUS, POISSON, abs(shift - from_shift) / 2)
    return from_part + 2 * sign * half


def _loop(bench, model, radius):
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.3))
    point = model.points[2]
    part = closed_forms.mindlin_part(radius, FORCE, FRICTION, SHEAR_MODULUS, POISSON, point["longitudinal_shift"])
    pressure = 1.5 * FORCE / (np.pi * radius**2)
    x = np.linspace(-1.1 * radius, 1.1 * radius, 400)
    left.plot(x, closed_forms.mindlin_traction(np.abs(x), radius, pressure, FRICTION, part), color="black",
              linewidth=1.2, label="closed form")
    row = np.abs(model.y).argmin()
    left.plot(model.x, -point.fields["traction_x"][row], linestyle="none", marker="o", markersize=3.5,
              color="#0072B2", label="half-space")
    left.set_xlabel("x [mm]")
    left.set_ylabel("traction against the push [MPa]")
    left.legend(loc="lower center")
    shifts = np.array([0] + [p["longitudinal_shift"] for p in model.points])
    parts = np.array([0] + [-p["longitudinal_force"] for p in model.points]) / (FRICTION * FORCE)
    top = shifts.max()
    curve = np.linspace(0, top, 100)
    turned = closed_forms.mindlin_part(radius, FORCE, FRICTION, SHEAR_MODULUS, POISSON, top)
    right.plot(1e3 * curve, [closed_forms.mindlin_part(radius, FORCE, FRICTION, SHEAR_MODULUS, POISSON, s) for s in curve],
               color="black", linewidth=1.2)
    around = np.linspace(-top, top, 200)
    right.plot(1e3 * around, [_masing(s, top, turned, radius, -1) for s in around], color="black", linewidth=1.2)
    right.plot(1e3 * around, [_masing(s, -top, -turned, radius, 1) for s in around], color="black", linewidth=1.2)
    right.plot(1e3 * shifts, parts, linestyle="none", marker="o", markersize=4, color="#0072B2")
    right.set_xlabel("shift [µm]")
    right.set_ylabel(r"force over $\mu F_z$")
    figure.tight_layout()
    return bench.save(figure, "cattaneo")


_LINE = """[friction]
coefficient = {friction!r}
[wheel]
young_modulus = {wheel!r}
poisson_ratio = 0.0
[rail]
young_modulus = {rail!r}
poisson_ratio = 0.0
[geometry]
shape = "line"
relative_radius = 100.0
[rolling]
problem = "shift"
[history]
normal_force = {forces}
[contact_grid]
elements_across = 200
"""


def _spence_line_rows(bench):
    """Cylinders that are weakly coupled: K'(k)/K(k) = beta/mu of k = c/a (Spence 1975; Johnson 1985), exact while the shear does not
    act back on the pressure; a = 1 mm, E* = 1 MPa, pressed in 58 steps."""
    rows, beta, force = [], 0.025, np.pi / 400
    for ratio in (1.0, 0.5):
        text = _LINE.format(friction=beta / ratio, wheel=2 / (1 + 2 * beta), rail=2 / (1 - 2 * beta),
                            forces=[force * (k / 60) ** 2 for k in range(3, 61)])
        last = bench.run_text(f"spence_line_{ratio:g}", text, ["halfspace"])["halfspace"].points[-1]
        low, high = 0.0, 1.0
        for _ in range(60):
            k = (low + high) / 2
            beyond = closed_forms.elliptic_integrals(1 - k * k)[0] / closed_forms.elliptic_integrals(k * k)[0] > ratio
            low, high = (k, high) if beyond else (low, k)
        rows += [Row(f"cylinders, beta/mu = {ratio:g}: half width of adhesion over a", "", k, np.sum(last.fields["state"] == ADHESION) / 200,
                     0.01, of=1.0, of_words="a"),  # an element of 200 is half a percent
                 Row(f"cylinders, beta/mu = {ratio:g}: longitudinal force", "N", 0.0, last["longitudinal_force"], 1e-6, of=force,
                     of_words="P")]
    return rows


def spence(bench):
    """Spence: unlike bodies pressed together with friction"""
    result = bench.run("spence", "cases/spence.toml")
    model = result["halfspace"]
    ratios, forces = [], []
    for point in model.points[3:]:
        ratios.append(np.sqrt(point["adhesion_area"] / point["contact_area"]))
        forces.append(point["normal_force"])
    force = (70 / 90) ** 3
    text = re.sub(r"normal_force = \[[^]]*\]", f"normal_force = {[force * (k / 35) ** 3 for k in range(2, 36)]}",
                  bench.case_text("cases/spence.toml")).replace("elements_across = 48", "cell_size = [0.1, 0.1]")
    fine = bench.run_text("spence_fine", text, ["halfspace"])["halfspace"]
    last = fine.points[-1]
    adhering = np.sum(last.fields["state"] == ADHESION) / np.sum(last.fields["pressure"] > 0)
    hertz = closed_forms.hertz(1 / 243, 1 / 243, force, 1.0)[2]
    rows = [Row("adhesion radius over patch radius", "", 0.5, np.sqrt(adhering), 0.01, by="0.1 mm elements, 34 steps"),
            Row("p0 over Hertz's", "", 1.31, last["max_pressure"] / hertz, 0.01, by="the same"),
            Row("p0 against CONTACT", "MPa", 0.02392, last["max_pressure"], 0.003, by="the same"),
            Row("approach against CONTACT", "mm", 0.09874, last["approach"], 0.002, by="the same"),
            Row("longitudinal force", "N", 0.0, last["longitudinal_force"], 1e-6, of=force, of_words="F_z", by="the same"),
            Row("adhesion radius over patch radius, last step", "", 0.5, ratios[-1], 0.03, by="the case, 48 across"),
            *_spence_line_rows(bench)]
    figure, axis = plt.subplots(figsize=(4.6, 3.0))
    axis.axhline(0.5, color="black", linewidth=1.2, label="Spence")
    axis.plot(forces, ratios, linestyle="none", marker="o", markersize=4, color="#0072B2", label="half-space")
    axis.set_ylim(0, 1)
    axis.set_xlabel("normal force [N]")
    axis.set_ylabel("adhesion radius over patch radius")
    axis.legend(loc="upper right")
    name = bench.save(figure, "spence")
    return Chapter(
        "spence", "Spence: unlike bodies pressed together with friction",
        "An elastic sphere (G = 0.5 MPa, nu = 0, R = 121.5 mm) pressed on a rigid plane, mu = 0.2986, in steps of load "
        "([case](../../cases/spence.toml)).",
        "CONTACT's user guide after Spence (1975): the adhesion area keeps half the radius; p0 1.31 of Hertz's; CONTACT's "
        "example: 0.09874 mm and 0.02392 MPa at 0.4705 N. Spence's closed form is not used: the version available "
        "does not reproduce the user guide's value.",
        rows, figures=[(name, "The adhesion area grows with the patch: cases/spence.toml, from the fourth step on")],
        cost=[Cost("16 steps", model.seconds["total"], model.unknowns),
              Cost("34 steps, 0.1 mm", fine.seconds["total"], fine.unknowns)],
        tests=["verification.Spence.FirstStepOnFourElements"])


def creep_frequency(bench):
    """Oscillating creepage: amplitude and phase of the force"""
    found = bench.test("verification:CreepFrequency.OfLineContactIsTheClosedForm")
    waves, distance, rows = (0.1, 0.3, 1.0, 2.0, 4.0), 20.0, []
    for wave in waves:
        exact = closed_forms.creep_response(wave, distance)
        mine = found[f"amplitude_{wave:g}"], found[f"phase_{wave:g}"]
        at = f"L/a = {2 * np.pi / wave:.3g}"
        fine, coarse = (found[f"{grid}amplitude_{wave:g}"] * np.exp(1j * found[f"{grid}phase_{wave:g}"]) for grid in ("", "coarse_"))
        rows += [at_most(f"distance from the closed form, {at}", "", abs(fine - exact) / abs(exact), 0.02, by="80 elements"),
                 at_most(f"the same over that of 40 elements, {at}", "", abs((fine - exact) / (coarse - exact)), 0.7, by="80 elements")]
        rows.append(Row(f"amplitude over that of steady creepage, {at}", "", abs(exact), mine[0], 0.01))
        rows.append(Row(f"phase behind the creepage, {at}", "rad", -np.angle(exact), -mine[1], 0.01, of=1.0,
                        of_words="1 rad"))
    figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.3))
    fine = np.geomspace(0.03, 6, 200)
    response = np.array([closed_forms.creep_response(wave, distance) for wave in fine])
    lengths = 2 * np.pi / np.array(waves)
    axes[0].loglog(2 * np.pi / fine, np.abs(response), color="black", linewidth=1.2, label="closed form")
    axes[0].loglog(lengths, [found[f"amplitude_{w:g}"] for w in waves], linestyle="none", marker="o", markersize=4,
                   color="#0072B2", label="in steps, 80 elements")
    axes[1].semilogx(2 * np.pi / fine, np.degrees(np.angle(response)), color="black", linewidth=1.2)
    axes[1].semilogx(lengths, [np.degrees(found[f"phase_{w:g}"]) for w in waves], linestyle="none", marker="o",
                     markersize=4, color="#0072B2")
    for axis, words in zip(axes, ("force over that of steady creepage", "phase [degrees]")):
        axis.set_xlabel("wavelength over half the patch, L/a")
        axis.set_ylabel(words)
    axes[0].legend()
    figure.tight_layout()
    return Chapter(
        "creep-frequency", "Oscillating creepage: amplitude and phase of the force",
        "Line contact in full adhesion, rolled in steps of one element under the creepage xi cos(2 pi s/L) until "
        "the start no longer matters; 80 elements, displacements relative to those at 20 a.",
        "a closed form derived here ([theory](../theory.md)), F/F_0 = (J_0 + i J_1)/(J_0 + i k a ln(2 D/a) (J_0 + i "
        "J_1)), J = "
        "J(k a), k = 2 pi/L: the two-dimensional case of Knothe and Gross-Thebing's (1986) transfer functions, "
        "whose values for ellipses were not available. Half-planes have no fixed point at infinity, hence the "
        "distance D.",
        rows, figures=[(bench.save(figure, "creep_frequency"), "Amplitude and phase over the wavelength")],
        cost=[Cost("the test, two grids", found["seconds"])],
        tests=["verification.CreepFrequency.OfLineContactIsTheClosedForm"])
