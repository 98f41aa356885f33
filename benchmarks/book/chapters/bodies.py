# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finite elements: elements, incompressibility, inertia, and contact of bodies far from half-spaces."""
import numpy as np

from .. import closed_forms
from ..chapter import Chapter, Cost, Row, at_most


def elements(bench):
    """Order of the elements on curved bodies"""
    rows, seconds = [], 0.0
    for test, words, displacement, energy in (
            ("QuadraticElementsOnAConvexWheel", "Q2, convex wheel", 3.0, 2.0),
            ("QuadraticElementsOnAConcaveWheel", "Q2, concave wheel", 3.0, 2.0),
            ("QuadraticElementsOnARail", "Q2, rail", 3.0, 2.0), ("LinearElementsOnARail", "Q1, rail", 2.0, 1.0)):
        found = bench.test(f"verification_fem:ManufacturedSolution.{test}")
        rows.append(Row("order of the displacement", "", displacement, found["order_of_displacement"],
                        0.25 / displacement, by=words))
        rows.append(Row("order of the energy", "", energy, found["order_of_energy"], 0.2 / energy, by=words))
        rows.append(at_most("error of the displacement on the finer mesh", "", found["error"], 0.05 if words.startswith("Q1") else 2e-3, by=words))
        seconds += found["seconds"]
    return Chapter(
        "elements", "Order of the elements on curved bodies",
        "A displacement is chosen, its body force and surface tractions are applied to segments of wheel and rail with "
        "curved surfaces, and the solution is compared with it, on two meshes.",
        "the manufactured solution; orders k + 1 in the displacement (L2) and k in the energy of elements of degree k.",
        rows, cost=[Cost("four tests", seconds)],
        tests=["verification.ManufacturedSolution.QuadraticElementsOnAConvexWheel",
               "verification.ManufacturedSolution.QuadraticElementsOnAConcaveWheel",
               "verification.ManufacturedSolution.QuadraticElementsOnARail",
               "verification.ManufacturedSolution.LinearElementsOnARail",
               "verification.PatchTest.LinearDisplacementIsInEquilibriumOnSkewCellsWithHangingNodes"])


elements.needs_fem = True


def persson(bench):
    """Persson's conformal pin: far from half-spaces"""
    found = bench.test("verification_fem:PerssonPin.TouchesOverTheAngleAndWithThePressureOfTheClosedForm")
    rows, missed = [], []
    for angle in (20, 40, 60):
        clearance, pressure = closed_forms.persson(np.radians(angle))
        rows.append(Row("half the angle of contact", "degrees", angle, found[f"half_angle_at_{angle}"], 0.5 / angle,
                        by=f"{angle} degrees"))
        rows.append(Row("p(0) R/Q", "", pressure, found[f"pressure_at_{angle}"], 0.01, by=f"{angle} degrees"))
        rows.append(at_most("error of the angle, elements of 1.5 over those of 3 degrees", "", abs(
            (found[f"half_angle_at_{angle}"] - angle) / (found[f"coarse_half_angle_at_{angle}"] - angle)), 0.7, by=f"{angle} degrees"))
        # Hertz's line contact of the same clearance: a^2 = 4 Q R/(pi E*), 1/R = dR/R^2, E* = E1*/2, p0 = 2Q/(pi a)
        semi_axis = np.sqrt(8 / (np.pi * clearance))
        missed.append(f"{100 * (2 / (np.pi * semi_axis) / pressure - 1):.1f} % at {angle} degrees".replace("-", "−"))
    return Chapter(
        "persson", "Persson's conformal pin: far from half-spaces",
        "A disc in the hole of a large plate, plane strain, like materials, no friction; both meshed separately and "
        "solved with the library's elasticity, factorisation and normal solver; elements of 1.5 degrees.",
        "Persson (1964), checked against an independent Fourier solution of disc and plate (to 5 digits).", rows,
        cost=[Cost("three angles, two meshes each", found["seconds"])],
        tests=["verification.PerssonPin.TouchesOverTheAngleAndWithThePressureOfTheClosedForm",
               "unit.Persson.GivesTheTableOfTheFourierSolution"],
        after="At the same load and clearance the error of p(0) by Hertz's theory, i.e. by half-spaces, is "
              + ", ".join(missed) + ".")


persson.needs_fem = True


def incompressible(bench):
    """Nearly incompressible bodies: Lame's cylinder"""
    found = bench.test("verification_fem:NearlyIncompressible.ThickCylinderHasLamesDisplacementAndStress")
    rows = []
    for degree, cells, most in ((2, 4, 1e-3), (1, 8, 0.01)):
        rows.append(Row(f"error of the displacement, Q{degree}, {cells} cells", "", 0.0,
                        found[f"projected_degree_{degree}"], most, of=1.0, of_words="the displacement"))
    plain = " and ".join(f"{100 * found[f'plain_degree_{d}']:.0f} % (Q{d})" for d in (2, 1))
    return Chapter(
        "incompressible", "Nearly incompressible bodies: Lame's cylinder",
        "A thick cylinder under pressure, nu = 0.4999; dilatation projected to a lower order.",
        "Lame's closed form.", rows, cost=[Cost("test", found["seconds"])],
        tests=["verification.NearlyIncompressible.ThickCylinderHasLamesDisplacementAndStress",
               "verification.NearlyIncompressible.QuadraticElementsKeepTheirOrderWherePlainOnesLock",
               "verification.NearlyIncompressible.RubberBallPressesAndRollsAsTheHalfSpaceSays"],
        after=f"Elements without the projection have errors of {plain}: they lock.")


incompressible.needs_fem = True


def inertia(bench):
    """Inertia of rolling: moving pressure, spinning ring"""
    wave = bench.test("verification_fem:MovingPressure.DeflectsAHalfSpaceAsColeAndHuthSay")
    ring = bench.test("verification_fem:SpinningRing.HasTheClosedFormsDisplacementAndHoopStress")
    speed = bench.test("verification_fem:RollingInertia.VanishesAsTheSquareOfTheSpeed")
    rows = []
    for poisson in (0.3, 0.4999):
        for fraction in (0, 0.6, 0.89):
            rows.append(Row(f"deflection at {fraction:g} of the Rayleigh speed, nu = {poisson}", "p0/(G k)",
                            closed_forms.moving_wave(fraction, poisson), wave[f"deflection_{poisson}_{fraction}"], 5e-4))
    rows += [Row("spinning ring: error of the displacement", "", 0.0, ring["displacement_error"], 1e-5, of=1.0,
                 of_words="the displacement"),
             Row("spinning ring: largest error of the hoop stress", "", 0.0, ring["hoop_error"], 2e-3, of=1.0,
                 of_words="the stress"),
             Row("spinning ring: order of the displacement", "", 3.0, ring["order"], 0.4 / 3),
             Row("change of the compliance at 2 V over that at V", "", 4.0, speed["ratio"], 0.005)]
    return Chapter(
        "inertia", "Inertia of rolling: moving pressure, spinning ring",
        "A pressure wave moving over a half-space (8 cells per half wave); a thick ring spinning so fast that its "
        "displaced material adds 3 % to its load (12 cells); the compliance of wheel and rail at two speeds.",
        "Cole and Huth (1958); Bessel functions for the ring, load on the displaced material; V^2 for small speeds.",
        rows, cost=[Cost("three tests", wave["seconds"] + ring["seconds"] + speed["seconds"])],
        tests=["verification.MovingPressure.DeflectsAHalfSpaceAsColeAndHuthSay",
               "verification.MovingPressure.BeyondTheRayleighSpeedLeavesTheStiffnessIndefinite",
               "verification.SpinningRing.HasTheClosedFormsDisplacementAndHoopStress",
               "verification.RollingInertia.VanishesAsTheSquareOfTheSpeed"])


inertia.needs_fem = True
