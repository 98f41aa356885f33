"""Steady rolling of half-spaces and the theories."""
import numpy as np
from matplotlib import pyplot as plt

from rollfem_figures import style

from .. import closed_forms, published
from ..chapter import Chapter, Cost, Row


def _carter_patch():
    """(a, b, p0, E*) of cases/carter_line.toml."""
    modulus = 210e3 / (2 * (1 - 0.3**2))
    a, b, pressure, _ = closed_forms.hertz(1 / 1000, 1 / 2e6, 14e3, modulus)
    return a, b, pressure, modulus


def _carter_curve(creepage):
    """-F_x of a very wide ellipse, every strip a roller of Carter, N."""
    a, b, pressure, modulus = _carter_patch()
    y = (np.arange(2000) + 0.5) / 2000
    narrower = np.sqrt(1 - y**2)
    return 2 * b * np.mean([closed_forms.carter_force(a * s, pressure * s, 0.3, modulus, creepage)
                            for s in narrower])


def carter(bench):
    """Carter: steady rolling of like cylinders"""
    result = bench.run("carter", "cases/carter_line.toml", ["halfspace", "carter"])
    half, theory = result.model("halfspace"), result.model("carter")
    plane = bench.test("verification_halfspace_line:Carter.ForceWithinATenthOfAPercentAt40ElementsOfSecondOrder")
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
        rows.append(Row(f"cylinders, {n} elements: largest error of the force", "mu P", 0.0, plane[f"error_at_{n}"],
                        most, of=1.0, of_words="mu P", by="half-space in the plane"))
    figure = _carter_figure(bench, half)
    orders = [np.log2(plane[f"error_at_{n}"] / plane[f"error_at_{2 * n}"]) for n in (20, 40, 80)]
    return Chapter(
        "carter", "Carter: steady rolling of like cylinders",
        "A patch a hundred times as wide as long, mu = 0.3 ([case](../../cases/carter_line.toml)): every strip rolls like a "
        "cylinder. And cylinders in the plane by the line compliance (test), a = 1 mm, R = 500 mm.",
        "Carter (1926), strip by strip: a', force and traction in closed form.",
        rows, figures=[(figure, "Tangential traction through the middle; lines: Carter, marks: half-space")],
        cost=[Cost("half-space, six load points", half.seconds["total"], half.unknowns)],
        tests=["verification.Carter.ForceWithinATenthOfAPercentAt40ElementsOfSecondOrder",
               "verification.Carter.TractionsAndSlipOfTheUsersGuide", "unit.Carter.GivesTheBenchmark"],
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


def bentall_johnson(bench):
    """Bentall and Johnson: rollers of unlike materials"""
    program = "verification_halfspace_line:BentallJohnson."
    free = bench.test(program + "CreepageOfFreeRollingWithHardlyAnyFriction")
    rough = bench.test(program + "FrictionLowersTheCreepageAndRaisesThePressure")
    pulled = bench.test(program + "TractiveAndBrakedRolling")
    # Al on steel: 1/G, nu/G and K/G are means of both bodies
    g = 2 / (1 / 23000 + 1 / 82000)
    nu = g * (0.31 / 23000 + 0.28 / 82000) / 2
    k = g * ((1 - 0.62) / 23000 - (1 - 0.56) / 82000) / 4
    exact = closed_forms.free_rolling_creepage(2 * k / (1 - nu), 0.1, 25.0)
    contact = published.CONTACT_ROLLERS
    rows = [Row("xi of free rolling, mu = 1e-4", "", exact, free["creepage"], 0.002, by="closed form"),
            Row("xi of free rolling, mu = 0.05", "", contact[0.05], rough["creepage_at_0.05"], 0.0012, by="CONTACT"),
            Row("xi of free rolling, mu = 10", "", contact[10.0], rough["creepage_at_10"], 0.0014, by="CONTACT"),
            Row("p0, mu = 10", "MPa", published.CONTACT_ROLLERS_PRESSURE, rough["pressure_at_10"], 2e-4, by="CONTACT"),
            Row("xi at 0.75 mu P, mu = 0.05", "", published.CONTACT_ROLLERS_PULLED[0], pulled["creepage_driven"],
                0.002, by="CONTACT"),
            Row("xi at -0.75 mu P, mu = 0.05", "", published.CONTACT_ROLLERS_PULLED[1], pulled["creepage_braked"],
                0.002, by="CONTACT")]
    return Chapter(
        "bentall-johnson", "Bentall and Johnson: rollers of unlike materials",
        "Aluminium (G = 23 000 MPa, nu = 0.31) on steel (82 000, 0.28), rollers of 50 mm, a = 0.1 mm: cylinders in the "
        "plane by the line compliance, 200 or 400 elements; pressure and traction act on each other.",
        "Bentall and Johnson (1967), where everything slips, in closed form; CONTACT's user guide (200 elements, "
        "first-order difference, three digits; the rows with free rolling take that difference too).",
        rows, cost=[Cost("three tests", free["seconds"] + rough["seconds"] + pulled["seconds"])],
        tests=["verification.BentallJohnson.CreepageOfFreeRollingWithHardlyAnyFriction",
               "verification.BentallJohnson.FrictionLowersTheCreepageAndRaisesThePressure",
               "verification.BentallJohnson.TractiveAndBrakedRolling"])


def kalker(bench):
    """Kalker's linear theory: small creepage and spin"""
    result = bench.run("kalker", "cases/verification/kalker.toml", ["halfspace"])
    model = result.model("halfspace")
    along, aside, spin = model.points
    g, c = 82e3, 6.0
    found = {"C11": -along["longitudinal_force"] / (g * c**2 * 1e-5), "C22": -aside["lateral_force"] / (g * c**2 * 1e-5),
             "C23": -spin["lateral_force"] / (g * c**3 * 1e-6), "-C32": aside["spin_moment"] / (g * c**3 * 1e-5)}
    table = published.KALKER_NU_025[1.0]
    rows = [Row(name, "", value, found[name], 0.02) for name, value in zip(("C11", "C22", "C23"), table)]
    rows.append(Row("-C32 against C23 (reciprocity)", "", found["C23"], found["-C32"], 0.01))
    swept = bench.test("verification_halfspace_forces:KalkersCoefficients.FromTheSolverAt40ElementsForEvery"
                       "AspectAndPoissonsRatio")
    for ratio in ("0.1", "0.5", "2", "10"):
        for name, value in zip(("C11", "C22", "C23"), published.KALKER_NU_025[float(ratio)]):
            rows.append(Row(f"{name}, a/b = {ratio}", "", value, swept[f"{name.lower()}_{ratio}_0.25"], 0.02))
    figure, axis = plt.subplots(figsize=(4.6, 3.3))
    ratios = sorted(published.KALKER_NU_025)
    for k, (name, ink) in enumerate((("C11", "#0072B2"), ("C22", "#D55E00"), ("C23", "#009E73"))):
        axis.loglog(ratios, [published.KALKER_NU_025[r][k] for r in ratios], color=ink, linewidth=1.2,
                    label=f"$C_{{{name[1:]}}}$, Kalker's table")
        tested = [r for r in ("0.1", "0.5", "1", "2", "10") if f"{name.lower()}_{r}_0.25" in swept]
        axis.loglog([float(r) for r in tested], [swept[f"{name.lower()}_{r}_0.25"] for r in tested], color=ink,
                    linestyle="none", marker="o", markersize=4)
    axis.set_xlabel("a/b (a along rolling)")
    axis.set_ylabel("coefficient")
    axis.legend()
    name = bench.save(figure, "kalker")
    return Chapter(
        "kalker", "Kalker's linear theory: small creepage and spin",
        "A circle of 6 mm under a given pressure, nu = 0.25, friction without bound in effect, 40 elements across "
        "([case](../../cases/verification/kalker.toml)); other ellipses by the test.",
        "Kalker's table (1967; 1990, table E.3), itself good to about 1 %; C23 = -C32 by reciprocity.",
        rows, figures=[(name, "Coefficients for nu = 0.25; lines: Kalker's table, marks: half-space at 40 across")],
        cost=[Cost("half-space, three load points", model.seconds["total"], model.unknowns)],
        tests=["verification.KalkersCoefficients.FromTheSolverAt40ElementsForEveryAspectAndPoissonsRatio",
               "verification.SteadyRolling.SmallCreepageGivesKalkersCoefficients",
               "unit.KalkerCoefficients.AreTheTabulatedOnesAtItsEntries"])


def benchmark_9(bench):
    """Partial slip with creepage and spin against CONTACT"""
    found, cost = {}, []
    for n in (10, 20, 40, 80, 160):
        model = bench.run(f"benchmark_9_{n}", "cases/benchmark9.toml", ["halfspace"],
                          {"contact_grid.elements_across": n}).model("halfspace")
        point = model.points[0]
        found[n] = (point["longitudinal_force"], point["lateral_force"], point["spin_moment"])
        cost.append(Cost(f"{n} across", model.seconds["total"], model.unknowns))
    rows = []
    for n in (80, 160):
        for k, (words, unit, most) in enumerate((("F_x", "N", 0.005), ("F_y", "N", 0.005), ("M_z", "N mm", 0.05))):
            rows.append(Row(f"{words}, {n} across", unit, published.EXTRAPOLATED_BENCHMARK_9[k], found[n][k], most))
    figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.3))
    contact = published.CONTACT_BENCHMARK_9
    for axis, k, words in zip(axes, (0, 2), ("$F_x$ [N]", "$M_z$ [N mm]")):
        axis.axhline(published.EXTRAPOLATED_BENCHMARK_9[k], color=style.GREY, linestyle=(0, (5, 3)), linewidth=1.0,
                     label="CONTACT, extrapolated")
        axis.semilogx(list(contact), [v[k] for v in contact.values()], color="black", marker="x", linewidth=1.0,
                      label="CONTACT, first order")
        axis.semilogx(list(found), [v[k] for v in found.values()], color="#0072B2", marker="o", markersize=4,
                      linewidth=1.2, label="half-space")
        axis.set_xticks([10, 20, 40, 80, 160], ["10", "20", "40", "80", "160"])
        axis.minorticks_off()
        axis.set_xlabel("elements across the patch")
        axis.set_ylabel(words)
    axes[0].legend()
    figure.tight_layout()
    name = bench.save(figure, "benchmark_9")
    return Chapter(
        "benchmark-9", "Partial slip with creepage and spin",
        "A circle of 6 mm under Hertz's pressure of 82 kN, mu = 0.3, xi = -0.1 %, eta = 0.05 %, spin 1e-4 rad/mm "
        "([case](../../cases/benchmark9.toml)).",
        "CONTACT rev 2707 on 20 to 120 elements across with its first-order difference, extrapolated in 1/n (some 0.1 % in "
        "the forces, a few percent in the moment). Two sequences of rollfem enclose 10 250 +- 2 N and -1168 +- 6 N mm.",
        rows, figures=[(name, "Longitudinal force and spin moment against the grid")], cost=cost,
        tests=["verification.GivenPressure.GivesBenchmark9ThroughTheModel",
               "verification.SteadyRolling.SecondOrderReachesTheConvergedForcesAt20Across",
               "verification.SteadyRolling.FirstOrderGivesTheValuesOfTheDesignAndOfContact",
               "verification.LeadingEdge.ForcesConvergeWithOrderOneAndAHalfAtLeast"])


def fastsim(bench):
    """FASTSIM against CONTACT's"""
    model = bench.run("fastsim", "cases/verification/fastsim_a.toml").model("fastsim")
    rows = []
    for point in model.points:
        force, traction = published.CONTACT_FASTSIM_A[point["longitudinal_creepage"]]
        at = f"at xi = {100 * point['longitudinal_creepage']:g} %"
        rows.append(Row(f"-F_x/F_z {at}", "", force, point["traction_coefficient"], 2e-5))
        rows.append(Row(f"largest traction {at}", "MPa", traction, point["max_traction"], 2e-5))
    return Chapter(
        "fastsim", "FASTSIM against CONTACT's",
        "Case a, parabolic traction bound, 160 by 160 elements of one grid, as CONTACT divides the patch "
        "([case](../../cases/verification/fastsim_a.toml)).",
        "CONTACT rev 2707's own FASTSIM on the same elements: the same algorithm (Kalker 1982).", rows,
        cost=[Cost("six load points", model.seconds["total"], model.unknowns or None)],
        tests=["verification.FastsimAgainstContact.ParabolicBoundOfCaseA",
               "verification.FastsimAgainstContact.ParabolicBoundOfCaseC",
               "verification.FastsimAgainstContact.EllipticBound"])
