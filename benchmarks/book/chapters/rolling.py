# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steady rolling of half-spaces and the theories."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import ADHESION

from .. import closed_forms, published, style, unlike_cylinders
from ..chapter import Chapter, Cost, Row, Table, at_most, closest, printed
from ..page import number, percent
from .carter import ROLLERS


def _unlike(bench, friction, ratio, elements=200, order="second"):
    """(xi, largest pressure, model) of aluminium on steel, rollers of 50 mm; F_x of the wheel is `ratio` mu P. CONTACT's
    creepage is minus ours."""
    text = ROLLERS.format(load=16.2019, friction=friction, wheel="young_modulus = 60260.0\npoisson_ratio = 0.31",
                           geometry="relative_radius = 25.0", across=elements,
                           rolling=f"longitudinal_force = {ratio * friction * 16.2019!r}\nupwind_order = \"{order}\"")
    model = bench.run_text(f"unlike_{friction:g}_{ratio:g}_{elements}_{order}", text, ["halfspace"])["halfspace"]
    return -model.points[0]["longitudinal_creepage"], model.points[0]["max_pressure"], model


def bentall_johnson(bench):
    """Bentall and Johnson: rollers of unlike materials"""
    smooth, rough = _unlike(bench, 1e-4, 0.0, 400), _unlike(bench, 10.0, 0.0, 200, "first")
    coarse, fine = _unlike(bench, 10.0, 0.0, 100, "first"), _unlike(bench, 10.0, 0.0)
    driven, braked = _unlike(bench, 0.05, 0.75), _unlike(bench, 0.05, -0.75)
    # Al on steel: 1/G, nu/G and K/G are means of both bodies
    g = 2 / (1 / 23000 + 1 / 82000)
    nu = g * (0.31 / 23000 + 0.28 / 82000) / 2
    k = g * ((1 - 0.62) / 23000 - (1 - 0.56) / 82000) / 4
    exact = closed_forms.free_rolling_creepage(2 * k / (1 - nu), 0.1, 25.0)
    contact = published.CONTACT_ROLLERS
    rows = [Row("xi of free rolling, mu = 1e-4", "", exact, smooth[0], 0.001, by="closed form"),
            Row("p0, mu = 1e-4", "MPa", 2 * 16.2019 / (np.pi * 0.1), smooth[1], 5e-4, by="Hertz"),
            *(Row(f"xi of free rolling, mu = {mu:g}", "", contact[mu], found[0], most, by="CONTACT")
              for mu, found, most in ((1e-4, smooth, 0.002), (0.05, _unlike(bench, 0.05, 0.0, 200, "first"), 0.0012),
                                      (10.0, rough, 0.0014))),
            Row("p0, mu = 10", "MPa", published.CONTACT_ROLLERS_PRESSURE, rough[1], 2e-4, by="CONTACT"),
            Row("xi of free rolling, mu = 10, second order", "", 2 * rough[0] - coarse[0], fine[0], 0.003,
                by="first order, extrapolated")]
    for found, at, xi, pressure in zip((driven, braked), ("0.75", "-0.75"), published.CONTACT_ROLLERS_PULLED, (103.3, 103.2)):
        rows += [Row(f"xi at {at} mu P, mu = 0.05", "", xi, found[0], 0.002, by="CONTACT"),
                 Row(f"p0 at {at} mu P, mu = 0.05", "MPa", pressure, found[1], 5e-4, by="CONTACT")]
    return Chapter(
        "bentall-johnson", "Bentall and Johnson: rollers of unlike materials",
        "Aluminium (G = 23 000 MPa, nu = 0.31) on steel (82 000, 0.28), rollers of 50 mm, a = 0.1 mm: plane "
        "cylinders by the line compliance, 200 or 400 elements; pressure and traction are coupled.",
        "Bentall and Johnson (1967), in closed form for full slip; CONTACT's user guide (200 elements, "
        "first-order difference, three digits; the rows with free rolling use that difference too).",
        rows, cost=[Cost("seven runs", sum(m.seconds["total"] for *_, m in (smooth, rough, coarse, fine, driven, braked)))],
        tests=["verification.BentallJohnson.MaterialOfTheBenchmark"])


def _aluminium_on_steel():
    """Dundurs' beta = K/(1 - nu): G = 23 000 MPa, nu = 0.31 on 82 000, 0.28; 1/G, nu/G, K/G are means of both."""
    g = 2 / (1 / 23000 + 1 / 82000)
    nu = g * (0.31 / 23000 + 0.28 / 82000) / 2
    return g * ((1 - 0.62) / 23000 - (1 - 0.56) / 82000) / 4 / (1 - nu)


# Friction coefficient, F_x over mu P, tolerance in mu a/R.
UNLIKE_ROLLING = ((0.05, 0.5, 5e-4), (0.05, 0.0, 5e-4), (0.05, -0.5, 5e-4), (0.1, 0.75, 1e-3), (0.1, 0.0, 1e-3),
                  (0.1, -0.5, 1e-3), (0.3, 0.5, 4e-3), (0.3, -0.75, 4e-3), (0.3, -0.9, 4e-3))


def nowell_hills(bench):
    """Nowell and Hills: tractive rolling of unlike cylinders"""
    beta, semi_axis, radius, hertz = _aluminium_on_steel(), 0.1, 25.0, 103.145
    scale = semi_axis / radius
    found = [_unlike(bench, friction, ratio) for friction, ratio, _ in UNLIKE_ROLLING]
    free = _unlike(bench, 10.0, 0.0)
    rows = []
    for k, (friction, ratio, most) in enumerate(UNLIKE_ROLLING):
        rollers = unlike_cylinders.Rollers(beta, friction, 300)
        exact = rollers.roll(ratio=ratio)
        words = f"mu = {friction:g}, F_x = {ratio:g} mu P"
        xi, pressure = -rollers.creepage(exact) * scale, rollers.pressure(exact) * hertz
        rows.append(Row(f"xi, {words}", "", xi, found[k][0], most, of=friction * scale, of_words="mu a/R"))
        rows.append(Row(f"largest pressure, {words}", "MPa", pressure, found[k][1], 2e-4))
        if friction == 0.05:
            half = _unlike(bench, friction, ratio, 100)
            rows.append(Row(f"xi, {words}, 100 elements", "", xi, half[0], 2e-3))
            rows.append(Row(f"largest pressure, {words}, 100 elements", "MPa", pressure, half[1], 5e-4))
    adhering = closed_forms.adhesive_free_rolling(beta)
    quadrature = unlike_cylinders.Rollers(beta, 10.0, 200)
    exact = quadrature.roll(ratio=0.0)
    rows += [Row("xi of free rolling, mu = 10: quadrature against the closed form", "", adhering[0] * scale,
                 -quadrature.creepage(exact) * scale, 2e-5),
             Row("xi of free rolling, mu = 10", "", adhering[0] * scale, free[0], 0.016, by="200 elements"),
             Row("largest pressure, mu = 10", "MPa", adhering[1] * hertz, free[1], 2e-4, by="200 elements")]
    figure, axes = plt.subplots(1, 3, figsize=(10.2, 3.4))
    rollers = unlike_cylinders.Rollers(beta, 0.05, 200)
    for axis, ratio in zip(axes, (0.5, -0.5)):
        state = rollers.roll(ratio=ratio)
        axis.plot(rollers.node, np.pi * state["p"] * rollers.over_hertz(state), color=style.GREY, linewidth=1.0,
                  label="pressure")
        axis.plot(rollers.node, np.pi * state["q"] / 0.05 * rollers.over_hertz(state), color="#0072B2", linewidth=1.4,
                  label=r"traction over $\mu$")
        stuck = state["side"] == 0
        axis.fill_between(rollers.node, -1.1, 1.2, where=stuck, color="#56B4E9", alpha=0.25, linewidth=0, label="adhesion")
        axis.set_ylim(-1.1, 1.2)
        axis.set_title(f"$F_x = {ratio:g}\\,\\mu P$", fontsize=9)
        axis.set_xlabel("x/a, rolling to the right")
    axes[0].set_ylabel("over Hertz's $p_0$")
    axes[0].legend(fontsize="small", loc="lower left")
    ratios = np.linspace(-0.96, 0.96, 1 if bench.small else 17)
    for friction, ink in ((0.05, "#0072B2"), (0.1, "#D55E00"), (0.3, "#009E73")):
        rollers = unlike_cylinders.Rollers(beta, friction, 80)
        axes[2].plot(ratios, [-1e2 * rollers.creepage(rollers.roll(ratio=r)) * scale for r in ratios], color=ink,
                     linewidth=1.2, label=rf"$\mu = {friction:g}$")
        mine = [(r, found[k][0]) for k, (mu, r, _) in enumerate(UNLIKE_ROLLING) if mu == friction]
        axes[2].plot([r for r, _ in mine], [1e2 * xi for _, xi in mine], linestyle="none", marker="o", markersize=4, color=ink)
    axes[2].plot([], [], color=style.GREY, linewidth=1.2, label="quadrature")
    axes[2].plot([], [], color=style.GREY, linestyle="none", marker="o", markersize=4, label="200 elements")
    axes[2].set(xlabel=r"$F_x/(\mu P)$", ylabel=r"$-\xi$ [%]")
    axes[2].legend(fontsize="small")
    figure.tight_layout()
    return Chapter(
        "nowell-hills", "Nowell and Hills: tractive rolling of unlike cylinders",
        "Aluminium on steel as before, driven and braked, from low to high friction: up to three adhesion zones "
        "between slip in either direction; pressure and traction are coupled. 200 elements in the plane.",
        "the problem of Nowell and Hills (1988), whose figures were not available: solved independently by "
        "Gauss-Chebyshev quadrature "
        "of the two singular integral equations (`benchmarks/book/unlike_cylinders.py`, 200 nodes; 100 and 300 "
        "change xi by "
        "1e-4 of it at most), which shares no element, no difference and no iteration between normal and tangential "
        "problem with the program. In full adhesion free rolling has a closed form, derived here: xi R/a = "
        "2 e/sqrt(1 + 4 e^2), 2 pi e = ln((1 + beta)/(1 - beta)).",
        rows, figures=[(bench.save(figure, "nowell_hills"),
                        "Pressure and traction by quadrature, mu = 0.05, adhesion shaded; creepage over force (lines: "
                        "quadrature, marks: 200 elements)")],
        cost=[Cost("ten runs", sum(m.seconds["total"] for *_, m in (*found, free)))],
        after="At mu = 10 the coupling narrows the patch by 0.4 %, half of one of the 200 elements at either end, "
              "which accounts for the error of the creepage. CONTACT's 3.59e-4 in the chapter before, on 200 "
              "elements of first order, is 2.2 % below the closed form.")


def _draw_benchmark_9(found):
    """Differences of force and moment from what CONTACT extrapolates to, on ever finer grids."""
    figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.3))
    contact = published.CONTACT_BENCHMARK_9
    for axis, k, words, limit, bar in zip(axes, (0, 2), ("$F_x$", "$M_z$"), (10250, -1168), (2, 6)):
        whole = published.EXTRAPOLATED_BENCHMARK_9[k]
        percent = lambda value, whole=whole: 100 * (value / whole - 1)
        axis.axhline(0, color=style.GREY, linestyle=(0, (5, 3)), linewidth=1.0, label="CONTACT, extrapolated")
        axis.axhspan(percent(limit - bar), percent(limit + bar), color="#0072B2", alpha=0.25, linewidth=0,
                     label="limit enclosed by rollfem")
        for values, look in ((contact, {"color": "black", "marker": "x", "linewidth": 1.0, "label": "CONTACT, first order"}),
                             (found, {"color": "#0072B2", "marker": "o", "markersize": 4, "linewidth": 1.2,
                                      "label": "half-space"})):
            axis.semilogx(list(values), [percent(v[k]) for v in values.values()], **look)
        axis.set_xticks([10, 20, 40, 80, 160], ["10", "20", "40", "80", "160"])
        axis.minorticks_off()
        axis.set_xlabel("elements across the patch")
        axis.set_ylabel(f"difference in {words} [%]")
    axes[0].legend()
    figure.tight_layout()
    return figure


_ELLIPSE = """[load]
normal_force = 82e3
[friction]
coefficient = 0.3
""" + published.CONTACT_BODIES + """[undeformed_distance]
quadratic = {quadratic}
[rolling]
{rolling}
[contact_grid]
extent = {extent}
cell_size = {cells}
"""


def ellipse(bench, name, axes, elements, scale, rolling, more=""):
    """An ellipse under 82 kN on elements as CONTACT lays them, over `scale` times the ellipse; first-order difference."""
    extent = [2 * scale * axis for axis in axes]
    text = _ELLIPSE.format(quadratic=list(closed_forms.hertz_curvatures(*axes, 82e3, published.CONTACT_MODULUS)), extent=extent,
                           cells=[length / elements for length in extent], rolling=f'{rolling}\nupwind_order = "first"')
    return bench.run_text(f"ellipse_{name}", text + more, ["halfspace"])["halfspace"]


def _elements(model):
    return model.contact_elements, np.sum(model.points[0].fields["state"] == ADHESION)


def _digit_rows(bench):
    """CONTACT's numbers digit by digit, on its elements with its difference."""
    model = ellipse(bench, "44", (8.0, 4.0), 44, 1.1, "lateral_creepage = -6.25e-4\nspin = 6.25e-4")
    numbers, elements = published.CONTACT_ELLIPSE
    assert _elements(model) == elements
    rows = [printed(f"ellipse of 8 by 4 mm: {words}", unit, value, model.points[0][key]) for (words, unit, key), value in zip(
        (("F_y", "N", "lateral_force"), ("M_z", "N mm", "spin_moment"), ("p0", "MPa", "max_pressure"), ("approach", "mm", "approach")), numbers)]
    motion = "longitudinal_creepage = -1e-3\nlateral_creepage = 5e-4\nspin = 1e-4"
    for n, elements in published.CONTACT_ELEMENTS_9.items():
        model = ellipse(bench, f"9_{n}", (6.0, 6.0), n + 6, 1 + 6 / n, motion)
        assert _elements(model) == elements
        rows += [printed(f"{words}, {n} across, first order", unit, value, model.points[0][key]) for (words, unit, key), value in zip(
            (("F_x", "N", "longitudinal_force"), ("F_y", "N", "lateral_force"), ("M_z", "N mm", "spin_moment")),
            published.CONTACT_BENCHMARK_9[n])]
    return rows


def _order_rows(bench, found):
    """Order of the fitted leading edge, and the limit that both differences have."""
    rows = []
    for coarse in (10, 20):
        for k, words, least in ((0, "F_x", 1.5), (2, "M_z", 1.4)):
            values = [found[coarse * times][k] for times in (1, 2, 4)]
            order = np.log2((values[0] - values[1]) / (values[1] - values[2]))
            rows.append(Row(f"order of {words}, {coarse} to {4 * coarse} across, up to {least}", "", least, min(order, least), 1e-9))
    first = [bench.run(f"benchmark_9_first_{n}", "cases/benchmark9.toml", ["halfspace"], {
        "contact_grid.elements_across": n, "rolling.spin": '1e-4\nupwind_order = "first"'})["halfspace"].points[0]["longitudinal_force"]
        for n in (40, 80)]
    return [*rows, Row("F_x of first order, extrapolated", "N", found[80][0], 2 * first[1] - first[0], 0.003, by="second order, 80 across"),
            at_most("error of F_x of first order, 80 over 40 across", "",
                    abs((first[1] - found[80][0]) / (first[0] - found[80][0])), 0.6)]


def _given_rows(bench):
    """A given pressure carries its force on any grid; where all slips friction does, but for the elastic slip's turn below 1e-2."""
    rows, largest = [], 1.5 * 82e3 / (np.pi * 24)
    for across in (8, 15, 32, 63):
        point = bench.run(f"given_{across}", "cases/benchmark9.toml", ["halfspace"], {
            "given_pressure.semi_axis_x": 6.0, "given_pressure.semi_axis_y": 4.0, "rolling.longitudinal_creepage": 0.0, "rolling.lateral_creepage": 0.5, "rolling.spin": 0.0,
            "contact_grid.elements_across": across})["halfspace"].points[0]
        approach = closed_forms.hertz(*closed_forms.hertz_curvatures(6.0, 4.0, 82e3, published.CONTACT_MODULUS), 82e3, published.CONTACT_MODULUS)[3]
        # Elements are fewer than the bar can be told from on 8 across.
        bar = point.bar("max_pressure") / largest if across > 8 else 1.0
        rows.append([Row(f"given pressure, {across} across: {words}", unit, exact, reached, allowed) for words, unit, exact, reached, allowed in (
            ("F_z", "N", 82e3, point["normal_force"], 1e-12), ("F_y in full slip", "N", -0.3 * 82e3, point["lateral_force"], 5e-5),
            ("p0", "MPa", largest, point["max_pressure"], min(across**-1.5, bar)),
            ("approach", "mm", approach, point["approach"], 0.5 * across**-1.5))])
        assert point.no_bar["normal_force"] == "given"
    return [closest(same) for same in zip(*rows)]


def benchmark_9(bench):
    """Partial slip with creepage and spin against CONTACT"""
    found, cost = {}, []
    for n in (10, 20, 40, 80, 160):
        model = bench.run(f"benchmark_9_{n}", "cases/benchmark9.toml", ["halfspace"],
                          {"contact_grid.elements_across": n})["halfspace"]
        point = model.points[0]
        found[n] = (point["longitudinal_force"], point["lateral_force"], point["spin_moment"])
        cost.append(Cost(f"{n} across", model.seconds["total"], model.unknowns))
    rows = []
    plain = bench.run("benchmark_9_plain", "cases/benchmark9.toml", ["halfspace"], {
        "contact_grid.elements_across": 20, "rolling.spin": '1e-4\nleading_edge = "plain"'})["halfspace"].points[0]
    for n, values, allowed in (("20 across, plain edge", [plain[key] for key in ("longitudinal_force", "lateral_force", "spin_moment")],
                                (0.005, 0.01, 0.06)), *((f"{n} across", found[n], (0.002, 0.003, 0.04)) for n in (80, 160))):
        for (words, unit), value, reached, most in zip((("F_x", "N"), ("F_y", "N"), ("M_z", "N mm")), published.EXTRAPOLATED_BENCHMARK_9,
                                                       values, allowed):
            rows.append(Row(f"{words}, {n}", unit, value, reached, most))
    rows += [*_order_rows(bench, found), *_digit_rows(bench), *_given_rows(bench)]
    name = bench.save(_draw_benchmark_9(found), "benchmark_9")
    return Chapter(
        "benchmark-9", "Partial slip with creepage and spin",
        "A circle of 6 mm under Hertz's pressure of 82 kN, mu = 0.3, xi = -0.1 %, eta = 0.05 %, spin 1e-4 rad/mm "
        "([case](../../cases/benchmark9.toml)).",
        "CONTACT rev 2707 on 20 to 120 elements across with its first-order difference, extrapolated in 1/n (some 0.1 % in "
        "the forces, a few percent in the moment). Two sequences of rollfem enclose 10 250 +- 2 N and -1168 +- 6 N mm. On CONTACT's "
        "elements with its difference the digits that it prints, also of its example of an ellipse (user guide).",
        rows, figures=[(name, "Longitudinal force and spin moment against the grid, as differences from CONTACT's extrapolation")], cost=cost,
        tests=["verification.SteadyRolling.NewtonTakesFewStepsAndEndsFast", "verification.LeadingEdge.IsFoundFromTheBoundOnly"])


def fastsim(bench):
    """FASTSIM against CONTACT's"""
    model = bench.run("fastsim", "cases/verification/fastsim_a.toml")["fastsim"]
    found = bench.test("verification:FastsimAgainstContact.ParabolicBoundOfCaseA")
    rows, beside = [], []
    for xi, (force, traction) in published.CONTACT_FASTSIM_A.items():
        at = f"at xi = {100 * xi:g} %"
        rows.append(Row(f"-F_x/F_z {at}", "", force, found[f"force_160_{xi:g}"], 2e-5))
        rows.append(Row(f"largest traction {at}", "MPa", traction, found[f"traction_160_{xi:g}"], 2e-5))
        own = model.nearest(xi)["traction_coefficient"]
        beside.append([f"{100 * xi:g} %", number(force, 5), number(own, 5), percent(own / force - 1)])
    return Chapter(
        "fastsim", "FASTSIM against CONTACT's",
        "Case a, parabolic traction bound, 160 by 160 elements of one grid, as CONTACT divides the patch, with the "
        "flexibilities of Kalker's printed table, as in CONTACT (test); the "
        "[case](../../cases/verification/fastsim_a.toml) has those of the computed table.",
        "CONTACT rev 2707's own FASTSIM on the same elements: the same algorithm (Kalker 1982).", rows,
        tables=[Table("-F_x/F_z with the flexibilities of the computed table, used by all runs:",
                      ["xi", "CONTACT", "computed table", "difference"], beside)],
        cost=[Cost("six load points", model.seconds["total"], model.unknowns or None), Cost("the test", found["seconds"])],
        tests=["verification.FastsimAgainstContact.ParabolicBoundOfCaseA",
               "verification.FastsimAgainstContact.ParabolicBoundOfCaseC",
               "verification.FastsimAgainstContact.EllipticBound"])
