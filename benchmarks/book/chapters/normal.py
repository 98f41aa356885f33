"""Normal contact of half-spaces: Hertz's ellipses, and the order of the discretisation."""
from matplotlib import pyplot as plt

from rollfem_figures import style

from .. import closed_forms, published
from ..chapter import Chapter, Cost, Row

STEEL = 82000 / (1 - 0.28)  # E* = G/(1 - nu), MPa


def hertz(bench):
    """Hertz's ellipses: pressure, semi-axes, approach"""
    rows, cost, tested = [], [], []
    for radius in (300.0, 80.0, 13.0):
        result = bench.run(f"hertz_{radius:.0f}", "cases/verification/hertz.toml",
                           settings={"rail.transverse_radius": radius})
        exact = closed_forms.hertz(1 / 920, 1 / (2 * radius), 82e3, STEEL)
        for name, allowed in (("hertz", (1e-6,) * 4), ("halfspace", (1e-3, 1e-3, 1e-3, 3e-4))):
            point = result.model(name).points[0]
            for key, words, unit, value, most in zip(
                    ("semi_axis_x", "semi_axis_y", "max_pressure", "approach"), ("a", "b", "p0", "approach"),
                    ("mm", "mm", "MPa", "mm"), exact, allowed):
                if name == "halfspace" or key == "max_pressure":
                    rows.append(Row(f"rail {radius:g} mm: {words}", unit, value, point[key], most,
                                    by=style.label(result.model(name))))
        half = result.model("halfspace")
        cost.append(Cost(f"rail {radius:g} mm", half.seconds["total"], half.unknowns))
    tested += ["unit.Hertz.GivesTheBenchmarkTable", "unit.Hertz.HoldsForAnyAspectRatioBothWays",
               "verification.HalfspaceNormal.PatchSizeIsFoundBelowTheElementSize"]
    return Chapter(
        "hertz", "Hertz's ellipses",
        "A wheel of 460 mm on rails of three radii across, 82 kN, G = 82 000 MPa, nu = 0.28, no friction; 40 elements "
        "across the smaller extent of the patch ([case](../../cases/verification/hertz.toml)).",
        "Hertz's closed form (Johnson 1985, chapter 4) with elliptic integrals by the arithmetic-geometric mean.",
        rows, cost=cost, tests=tested)


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
    return Chapter(
        "grid-order", "Order of the half-space's pressure",
        "Case a of the seed study (Hertz: p0 578.967 MPa) on 10 to 160 elements across, "
        "`rollfem study cases/thesis_a.toml`.",
        "Hertz's closed form; CONTACT rev 2707 on the same grids (its discretisation of the normal problem is the "
        "same, so that digits agree); order 2 of constant elements (Kalker 1990).",
        rows, figures=[(_figure(bench, levels, exact), "Errors in p0 and approach against elements across the patch")],
        cost=[Cost(f"{n} across, seven load points", levels[n]["seconds"], levels[n]["unknowns"]) for n in (40, 160)],
        tests=["verification.HalfspaceNormal.MaxPressureConvergesToHertzWithOrderTwoAsInContact",
               "verification.HalfspaceNormal.ApproachConvergesToHertz"])


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
