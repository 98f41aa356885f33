# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 2012 study's cases a to f by every model, and the model error of half-spaces in e and f."""
import os

import numpy as np
from matplotlib import pyplot as plt

from .. import closed_forms, published, style
from ..chapter import Chapter, Cost, Row, Table, at_most, closest
from ..page import number, percent
from .conditions import condition_rows
from .work import force_rows, work_rows

MODELS = ("hertz", "fastsim", "strip", "halfspace", "fem")
MU = 0.55
RADII = {"a": (2000.0, np.inf), "b": (500.0, np.inf), "c": (100.0, np.inf), "d": (2000.0, 105.263),
         "e": (100.0, -105.263), "f": (50.0, -51.282)}  # rail, wheel across, mm
WORDS = {"a": "a flat wheel on a gently crowned rail", "b": "a nearly circular patch",
         "c": "a flat wheel on a sharp rail", "d": "two convex bodies, the patch of c",
         "e": "concave on sharp, curved", "f": "the same, stronger"}


def _compared(bench):
    """(compare.json, {letter: Result}) of the six cases, shared by two chapters."""
    models = [m for m in MODELS if m != "fem" or bench.has_fem]
    comparison, results = bench.compare("thesis", [f"cases/thesis_{c}.toml" for c in RADII], models)
    return comparison, {name[-1]: result for name, result in results.items()}


def _exact(letter):
    """Hertz's (a, b, p0, approach) of a case."""
    rail, wheel = RADII[letter]
    return closed_forms.hertz(1 / 810, 0.5 * (1 / rail + 1 / wheel), 50e3, 210e3 / (2 * (1 - 0.3**2)))


def _normal_rows(results):
    """p0 and semi-axes of half-space and FEM against Hertz for nearly flat bodies."""
    rows = []
    for letter in "abcd":
        exact = dict(zip(("semi_axis_x", "semi_axis_y", "max_pressure", "approach"), _exact(letter)))
        for model in results[letter].models:
            if model.name not in ("halfspace", "fem"):
                continue
            point = model.points[0]
            small = model.name == "halfspace"
            for key, words, unit, most in (("max_pressure", "p0", "MPa", 0.001 if small else 0.003),
                                           ("semi_axis_x", "a", "mm", 0.002 if small else 0.01),
                                           ("semi_axis_y", "b", "mm", 0.002 if small else 0.01)):
                rows.append(Row(f"case {letter}: {words}", unit, exact[key], point[key], most,
                                by=style.label(model)))
    return rows


def _curve_rows(bench, results):
    rows = []
    for model in results["a"].models:
        if model.name in ("halfspace", "fem"):
            for xi, value in published.CONTACT_CURVE_A.items():
                rows.append(Row(f"case a: -F_x/F_z at xi = {100 * xi:g} %", "", value,
                                model.nearest(xi)["traction_coefficient"], 0.005 if model.name == "halfspace" else 0.01,
                                of=0.55, of_words="mu", by=style.label(model)))
            rows.append(Row("case a: largest |p_x| at xi = 0.2 %", "MPa", published.CONTACT_TRACTION_A,
                            model.nearest(0.002)["max_traction_x"], 0.0053 if model.name == "halfspace" else 0.03,
                            by=style.label(model)))
    half = results["c"]["halfspace"]
    finer = bench.run("finer_c", "cases/thesis_c.toml", ["halfspace"], {"contact_grid.elements_across": 80})["halfspace"]
    for xi, (coarse, fine) in published.CONTACT_CURVE_C.items():
        for model, allowed, by in ((half, 0.005, "half-space"), (finer, 0.002, "half-space, 80 across")):
            rows.append(Row(f"case c: -F_x/F_z at xi = {100 * xi:g} %", "", 2 * fine - coarse,
                            model.nearest(xi)["traction_coefficient"], allowed, of=0.55, of_words="mu", by=by))
        rows.append(Row(f"case c: largest |p_x| at xi = {100 * xi:g} %", "MPa", published.CONTACT_TRACTION_C[xi],
                        finer.nearest(xi)["max_traction_x"], 0.005, by="half-space, 80 across"))
    return rows


def _rail_drop(bench):
    """A file with the extra slip given to CONTACT in case e, -y^2/(2 R_rail R): the drop of the rail."""
    path = os.path.join(bench.folder, "rail_drop.csv")
    places = np.arange(-30.0, 31.0, 20.0)
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"{x}, {y}, {-y * y / (2 * 100.0 * 405.0)!r}, 0.0\n" for y in places for x in places)
    return os.path.abspath(path)


def _rows_with_contacts_slip(bench):
    """Case e with the slip given to CONTACT: against its limit, and digit by digit with its difference scheme on its
    grid."""
    slip = f"0.0\nextra_slip = \"file\"\nextra_slip_file = \"{_rail_drop(bench)}\""
    xi = {"rolling.longitudinal_creepage": sorted(published.CONTACT_CURVE_E)}
    second, first, finer = (bench.run(name, "cases/thesis_e.toml", ["halfspace"],
                                      {"rolling.spin": slip + order, "contact_grid.elements_across": across, **xi})["halfspace"]
                            for name, order, across in (("drop_e", "", 40), ("first_order_e", "\nupwind_order = \"first\"", 40),
                                                        ("finer_e", "", 80)))

    def row(model, xi, value, allowed, words):
        return Row(f"case e, the rail's drop as slip: -F_x/F_z at xi = {100 * xi:g} %", "", value,
                   model.nearest(xi)["traction_coefficient"], allowed, of=0.55, of_words="mu", by=words)
    return [*(row(model, xi, 2 * fine - published.CONTACT_CURVE_E[xi], allowed, by)
              for model, allowed, by in ((second, 0.005, "half-space"), (finer, 0.0028, "half-space, 80 across"))
              for xi, fine in published.CONTACT_CURVE_E_80.items()),
            *(row(first, xi, value, 4.7e-4, "half-space, first order") for xi, value in published.CONTACT_CURVE_E.items())]


def _grid_rows(bench):
    """Case c with CONTACT's first-order difference on its grids."""
    rows = []
    for across, curve in ((40, published.CONTACT_CURVE_C_40), (80, {xi: coarse for xi, (coarse, _) in published.CONTACT_CURVE_C.items()})):
        model = bench.run(f"first_order_c_{across}", "cases/thesis_c.toml", ["halfspace"], {
            "contact_grid.elements_across": across, "rolling.spin": '0.0\nupwind_order = "first"',
            "rolling.longitudinal_creepage": list(curve)})["halfspace"]
        rows.append(closest([Row(f"case c, first order, {across} across: -F_x/F_z at xi = {100 * xi:g} %", "", value,
                                 model.nearest(xi)["traction_coefficient"], 2e-4, of=1.0, of_words="1", by="half-space, CONTACT's grid")
                             for xi, value in curve.items()]))
    return rows


def _zigzag(bench, letter, xi, edge):
    """Part of p_x that alternates from row to row at x = 0, over its largest: the root mean square of the fourth difference across rows
    over 16, which passes the alternating part whole and a smooth one hardly at all."""
    model = bench.run(f"zigzag_{letter}_{edge}", f"cases/thesis_{letter}.toml", ["halfspace"], {
        "rolling.longitudinal_creepage": xi, "rolling.spin": f'0.0\nleading_edge = "{edge}"'})["halfspace"]
    p = model.points[0].fields["traction_x"][:, len(model.x) // 2]
    fourth = (p[:-4] - 4 * p[1:-3] + 6 * p[2:-2] - 4 * p[3:-1] + p[4:]) / 16
    inside = np.abs(model.y[2:-2]) <= 0.8 * _exact(letter)[1]
    return np.sqrt(np.mean(fourth[inside] ** 2)) / np.abs(p).max()


def _zigzag_rows(bench):
    """Elements of dy/dx = 2.9 (a) and 0.33 (c), where the plain difference gives 1.3 % and 3.8 %."""
    rows = []
    for letter, xi, most, times in (("a", 5e-4, 0.005, 3.0), ("c", 1e-3, 0.015, 2.5)):
        fitted, plain = (_zigzag(bench, letter, xi, edge) for edge in ("fitted", "plain"))
        rows.append(at_most(f"case {letter}: zigzag of p_x across rolling", "", fitted, min(most, plain / times), by="fitted leading edge"))
    return rows


def _bar_rows(bench, results):
    """The error bars hold against exact values, and are not uselessly large."""
    exact = dict(zip(("semi_axis_x", "semi_axis_y", "max_pressure", "approach"), _exact("a")))
    coarse = bench.run("coarse_a", "cases/thesis_a.toml", ["halfspace"], {"contact_grid.elements_across": 20})["halfspace"]
    rows = []
    for across, model in ((20, coarse), (40, results["a"]["halfspace"])):
        held = []
        for xi, value in published.CONTACT_CURVE_A.items():
            point = model.nearest(xi)
            for key, truth, open_by in (*((key, number, 0.0) for key, number in exact.items()), ("traction_coefficient", value, 5e-4)):
                held.append(Row(f"case a: difference of {key} in its bar", "", 0.0, point[key] - truth, 1.0,
                                of=point.bar(key) + open_by, of_words="the bar", by=f"half-space, {across} across"))
                assert point.bar(key) < 0.05 * truth
        rows.append(closest(held))
    return [*rows, *(_bars_with_spin(bench, *case) for case in (("b", (2e-3, 1e-3, 2e-4)), ("c", (1e-3, 1e-3, 3e-4))))]


def _bars_with_spin(bench, letter, creepage):
    """Against first-order differences, which do not fit the leading edge, extrapolated from 40 and 80 across with their order."""
    def solved(across, order):
        settings = dict(zip(("rolling.longitudinal_creepage", "rolling.lateral_creepage", "rolling.spin"), creepage))
        settings["rolling.spin"] = f'{creepage[2]}\nupwind_order = "{order}"'
        return bench.run(f"spin_{letter}_{across}_{order}", f"cases/thesis_{letter}.toml", ["halfspace"],
                         {**settings, "contact_grid.elements_across": across})["halfspace"].points[0]
    middle, fine = solved(40, "first"), solved(80, "first")
    # What the extrapolation leaves open.
    left = {"longitudinal_force": 30.0, "lateral_force": 30.0, "spin_moment": 100.0}
    return closest([Row(f"case {letter}, all creepages: difference of {key} in its bar", "", 0.0, point[key] - (2 * fine[key] - middle[key]),
                        1.0, of=point.bar(key) + open_by, of_words="the bar", by=f"half-space, {across} across")
                    for across in (20, 40) for point in [solved(across, "second")] for key, open_by in left.items()])


def _theory_rows(bench):
    """The theories within what the study found, and the shift of a curved patch in their creep curves."""
    names = {"fastsim": (-0.055, 0.0), "strip": (-0.04, 0.0), "vermeulen-johnson": (-0.04, 0.0), "carter": (-0.05, 0.002)}
    rows, curve = [], published.CONTACT_CURVE_A
    result = bench.run("theories_a", "cases/thesis_a.toml", list(names), {"rolling.longitudinal_creepage": [*curve, 0.02]})
    for name, (low, high) in names.items():  # plane strain is somewhat stiff for a/b = 0.35
        rows.append(closest([Row(f"case a: over CONTACT at xi = {100 * xi:g} %", "", (low + high) / 2,
                                 result[name].nearest(xi)["traction_coefficient"] / value - 1, (high - low) / 2, of=1.0, of_words="1",
                                 by=style.label(result[name])) for xi, value in curve.items()]))
    # WheelsetContact has 562.2 MPa, which is less than 3 F/(2 pi a b) = 582 for its own axes: its strips must be coarse. Its largest
    # traction of 364 MPa is 3 pi/8 mu p0 of its pressure, which is the bound here.
    strip = result["strip"].nearest(0.02)
    rows += [Row(f"case a: {words}", unit, value, strip[key], allowed / value, by="strips; thesis: WSC, p0 Hertz")
             for words, unit, key, value, allowed in (("a", "mm", "semi_axis_x", 3.78, 0.015), ("b", "mm", "semi_axis_y", 10.85, 0.03),
                                                      ("p0", "MPa", "max_pressure", 578.967, 0.1))]
    rows.append(Row("case a: largest traction over p0", "", 364.0 / 562.2, strip["max_traction"] / strip["max_pressure"], 1.5e-3,
                    by="strips; thesis: WSC"))
    slip = f'0.0\nextra_slip = "file"\nextra_slip_file = "{_rail_drop(bench)}"'
    curve = published.CONTACT_CURVE_E
    shifted = bench.run("theories_e", "cases/thesis_e.toml", ["carter", "fastsim", "strip"],
                        {"rolling.spin": slip, "rolling.longitudinal_creepage": list(curve)})
    return [*rows, *(closest([Row(f"case e, the rail's drop as slip: -F_x/F_z at xi = {100 * xi:g} %", "", value,
                                  model.nearest(xi)["traction_coefficient"], 0.06, of=0.55, of_words="mu", by=style.label(model))
                              for xi, value in curve.items()]) for model in shifted.models)]


def _beside(results):
    """Tables of rollfem's values beside the thesis's."""
    rows = []
    for letter, result in results.items():
        exact = _exact(letter)
        entries = [("Hertz, exact", exact[:3])]
        entries += [(style.label(m), tuple(m.points[0][k] for k in ("semi_axis_x", "semi_axis_y", "max_pressure")))
                    for m in result.models if m.name != "hertz"]
        entries += [(f"*thesis: {name}*", v) for name, v in published.THESIS.get(letter, {}).items()]
        for name, values in entries:
            cells = [f"{number(v, 5)} ({percent(v / e - 1)})" if v is not None and name != "Hertz, exact"
                     else number(v) for v, e in zip(values, exact)]
            rows.append([f"{letter}: {WORDS[letter]}" if name == "Hertz, exact" else "", name, *cells])
    head = ["case", "by", "a in mm", "b in mm", "p0 in MPa"]
    patch = Table("Patches beside those of the 2012 study (difference from exact Hertz, which does not hold in e "
                  "and f). FASTSIM "
                  "works on Hertz's ellipse.", head, rows)
    tractions = [[f"{style.label(m)}", number(m.nearest(0.002)["max_traction_x"], 4)] for m in results["a"].models
                 if m.name != "hertz"]
    tractions += [["CONTACT today, 160 across", number(published.CONTACT_TRACTION_A, 4)]]
    tractions += [[f"*thesis: {name}*", number(v, 4)] for name, v in published.THESIS_TRACTION_A.items()]
    return [patch, Table("Case a, largest |p_x| at xi = 0.2 % (the 2012 study has FASTSIM at 0.4 %: 424.2 MPa):",
                         ["by", "MPa"], tractions)]


def _costs(results):
    """Seconds of every model and case beside the thesis's 8 to 12 hours."""
    names = [m.name for m in results["a"].models]
    rows = [[style.label(results["a"][n])] + [number(results[c][n].seconds["total"], 2) for c in results]
            for n in names]
    rows.append(["*thesis: SRS (FE)*"] + ["28 800 to 43 200"] * len(results))
    return Table("Seconds for the creep curve of seven points, error estimates included:",
                 ["by", *results], rows)


def _curves(bench, results):
    """The half-space's curves above, and below for every case what the others differ by."""
    figure = plt.figure(figsize=(9.0, 8.6))
    rows = figure.add_gridspec(3, 3, height_ratios=(1.25, 1, 1))
    top, below = figure.add_subplot(rows[0, :]), None
    for number, (letter, result) in enumerate(results.items()):
        own = {round(p["longitudinal_creepage"], 9): p for p in result["halfspace"].points}
        percent = [100 * xi for xi in own]
        top.plot(percent, [p["traction_coefficient"] for p in own.values()], marker="osD^vP"[number], markersize=4,
                 linewidth=1.2, label=f"{letter}: {WORDS[letter]}")
        below = figure.add_subplot(rows[1 + number // 3, number % 3], sharex=top, sharey=below)
        bars = [100 * (p.bar("traction_coefficient") or 0.0) / MU for p in own.values()]
        shown = {"error bar, half-space": below.fill_between(percent, bars, [-bar for bar in bars], color="#0072B2", alpha=0.25,
                                                             linewidth=0)}
        others = {style.label(m): ([(p["longitudinal_creepage"], p["traction_coefficient"]) for p in m.points],
                                   {"marker": style.marker(m), "markersize": 3.5, **style.line(m)})
                  for m in result.models if m.name not in ("hertz", "halfspace")}
        others["CONTACT"] = ({"a": published.CONTACT_CURVE_A, "e": published.CONTACT_CURVE_E,
                              "c": {xi: 2 * f - c for xi, (c, f) in published.CONTACT_CURVE_C.items()}}.get(letter, {}).items(),
                             {"linestyle": "none", "marker": "o", "markerfacecolor": "none", "markersize": 7, "color": "black"})
        for words, (curve, look) in others.items():
            differences = [(100 * xi, 100 * (value - own[round(xi, 9)]["traction_coefficient"]) / MU)
                           for xi, value in curve if round(xi, 9) in own]
            shown[words] = below.plot(*(zip(*differences) if differences else ([], [])), **look)[0]
        below.axhline(0, color=style.GREY, linewidth=0.6)
        below.set_title(f"{letter}: minus half-space")
        if number % 3 == 0:
            below.set_ylabel(r"difference [% of $\mu$]")
        if number > 2:
            below.set_xlabel(r"longitudinal creepage $\xi$ [%]")
    top.set(xlabel=r"longitudinal creepage $\xi$ [%]", ylabel="$-F_x/F_z$", title="Half-space")
    top.legend()
    figure.tight_layout(rect=(0, 0.04, 1, 1))
    figure.legend(shown.values(), shown.keys(), loc="lower center", ncol=len(shown))
    return bench.save(figure, "thesis_curves")


def _paths(bench, results):
    """p_x and its bound through the middle along x at 0.2 %."""
    figure, axes = plt.subplots(2, 3, figsize=(10.2, 6.4))
    shown = {}
    for axis, (letter, result) in zip(axes.flat, results.items()):
        for model in result.models:
            if model.name == "hertz":
                continue
            point = model.nearest(0.002)
            shown[style.label(model)] = axis.plot(model.x, -model.line(point.fields["traction_x"], "x"),
                                                  **style.line(model))[0]
        half = result["halfspace"]
        shown["bound, half-space"] = axis.plot(
            half.x, half.line(half.nearest(0.002).fields["traction_bound"], "x"), color=style.GREY,
            linewidth=0.9, linestyle=(0, (1, 1.5)))[0]
        axis.set_title(f"{letter}: {WORDS[letter]}")
    for axis in axes[1]:
        axis.set_xlabel("x, rolling to the right [mm]")
    for axis in axes[:, 0]:
        axis.set_ylabel(r"$-p_x$ at $\xi$ = 0.2 % [MPa]")
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    figure.legend(shown.values(), shown.keys(), loc="upper center", ncol=len(shown))
    return bench.save(figure, "thesis_paths")


def thesis_cases(bench):
    """Cases a to f of the study of 2012 by every model"""
    _, results = _compared(bench)
    cost = [Cost(style.label(model), sum(r[model.name].seconds["total"] for r in results.values()))
            for model in results["a"].models]
    return Chapter(
        "thesis-cases", "Cases a to f of the study of 2012",
        "Wheel radius 405 mm, 50 kN, E = 210 000 MPa, nu = 0.3, mu = 0.55, creepage 0 to 0.6 %; half-space at 40 "
        "across, finite elements on cells of a/8, `rollfem compare cases/thesis_*.toml`.",
        "Hertz's closed form in a to d; CONTACT rev 2707: case a on 80 and 160 elements across, extrapolated "
        "(+-0.0005), case c on 80 and 160, case e on 40 and 80 with the extra slip of the rail's drop, "
        "extrapolated; case e "
        "also at 40 with CONTACT's first-order difference in both programs. FEM minus half-space, 0.6 % of mu at small "
        "creepage (next chapter), is within the tolerance. The 2012 study (TU Graz) is shown for comparison only.",
        [*_normal_rows(results), *_curve_rows(bench, results), *_rows_with_contacts_slip(bench), *_grid_rows(bench), *_zigzag_rows(bench),
         *_bar_rows(bench, results), *_theory_rows(bench), *force_rows(bench), *work_rows(bench), *condition_rows(bench)], tables=[*_beside(results), _costs(results)],
        figures=[(_curves(bench, results), "Creep curves of the six cases, and what other models and CONTACT differ by from the half-space"),
                 (_paths(bench, results), "Tangential traction along rolling through the middle at 0.2 % creepage")],
        cost=cost,
        tests=["verification.fem_case_a"])


QUANTITIES = (("max_pressure", "p0", "MPa"), ("semi_axis_x", "a along rolling", "mm"),
              ("semi_axis_y", "b across", "mm"), ("contact_area", "area", "mm²"), ("approach", "approach", "mm"))


def _with_bar(value, bar):
    return f"{number(value, 5)} ± {number(bar, 2)}" if bar else number(value, 5)


def _limit_table(letter, result, bent):
    """Half-space, the half-space on the curved surface, and FEM; FEM minus half-space."""
    half, fem = result["halfspace"], result["fem"]
    rows = []

    def line(words, key, index, scale=None):
        ours, theirs, third = (m.points[index] for m in (half, fem, bent))
        difference = (theirs[key] - ours[key]) / abs(scale or ours[key])
        bars = ours.error_estimate.get(key, 0) + theirs.error_estimate.get(key, 0)
        rows.append([words, _with_bar(ours[key], ours.error_estimate.get(key)), number(third[key], 5),
                     _with_bar(theirs[key], theirs.error_estimate.get(key)), percent(difference),
                     "yes" if abs(theirs[key] - ours[key]) > bars else "no"])

    for key, words, unit in QUANTITIES:
        line(f"{words}, {unit}", key, 0)
    for index, point in enumerate(half.points):
        line(f"-F_x/F_z at xi = {100 * point['longitudinal_creepage']:g} % (of mu)", "traction_coefficient", index, 0.55)
    line("largest |p_x| at xi = 0.2 %, MPa", "max_traction_x", 3)
    return Table(f"Case {letter}:", ["", "half-space", "half-space on the curved surface", "FEM",
                                     "FEM minus half-space", "beyond both bars"], rows)


def _largest_principal(stress):
    """Largest principal stress of stresses [n, 6] (xx, yy, zz, xy, yz, xz)."""
    largest = np.linalg.eigvalsh(stress[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3))[:, -1]
    return np.where(np.abs(largest) < 1e-9 * np.abs(stress).max(), 0.0, largest)  # rounding, not stress


def _below(bench):
    """Runs of a, e and f with very low friction: [(letter, model, body, tension at three places, largest von Mises
    stress and its depth)], and their cost."""
    lines = "".join(f"\n[[subsurface.surface]]\nbody = \"{body}\"\nfrom = [0.0, 12.0]\nto = [0.0, 16.0]\npoints = 3\n"
                    for body in ("wheel", "rail"))
    rows, cost = [], []
    for letter in "aef":
        result = bench.run(f"below_{letter}", f"cases/thesis_{letter}.toml", ["halfspace", "fem"],
                           {"rolling.longitudinal_creepage": "[0.0]", "friction.coefficient": 0.001,
                            "fem.cell_size": 0.94, "output.paths": "[\"x\"]\nstress_maxima = true", "+": lines})
        cost.append(Cost(f"stress, case {letter}", sum(m.seconds["total"] for m in result.models)))
        for model in result.models:
            if model.name == "halfspace" and letter != "a":
                continue  # the same in all three cases
            for body in ("wheel", "rail"):
                point = model.points[0]
                tension = _largest_principal(next(s for s in point.subsurface if s["body"] == body)["stress"])
                most = next(m for m in point.stress_maxima if (m["body"], m["measure"]) == (body, "von_mises"))
                rows.append((letter, model, body, tension, most["value"], abs(most["place"][2])))
    return rows, cost


def _stress_tables(rows):
    """Tension beside the patch and the largest von Mises stress, beside the half-space's."""
    half = next(row for row in rows if row[1].name == "halfspace")
    tension = [["half-space, all cases"] + [number(v, 3) for v in half[3]]]
    mises = [["half-space, all cases", number(half[4], 4), number(half[5], 3)]]
    for letter, model, body, values, most, depth in rows:
        if model.name == "halfspace":
            continue
        by = f"{style.label(model)}, case {letter}, {body}"
        tension.append([by] + [f"{number(v, 3)} ({percent(v / h - 1)})" for v, h in zip(values, half[3])])
        mises.append([by, f"{number(most, 4)} ({percent(most / half[4] - 1)})", number(depth, 3)])
    return [Table("Largest tension at the surface beside the patch, MPa (across rolling, along the surface), x = 0, "
                  "xi = 0 with very low friction (the patch ends at y = 10.9 mm; cells of 0.94 mm; case a, with "
                  "nearly flat bodies, is the control). A concave wheel is opened, a convex rail is not; a "
                  "half-space shows neither:",
                  ["by", "y = 12 mm", "14 mm", "16 mm"], tension),
            Table("The largest von Mises stress in the same runs:", ["by", "MPa", "depth in mm"], mises)]


def _limits_figure(bench, results):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.4, 3.6))
    inks = dict(zip("abcdef", ("#999999", "#56B4E9", "#009E73", "#CC79A7", "#0072B2", "#D55E00")))
    for letter, result in results.items():
        half, fem = result["halfspace"], result["fem"]
        xi = [100 * p["longitudinal_creepage"] for p in half.points]
        change = [100 * (q["traction_coefficient"] - p["traction_coefficient"]) / 0.55
                  for p, q in zip(half.points, fem.points)]
        left.plot(xi, change, color=inks[letter], marker="o", markersize=3.5, linewidth=1.3, label=letter)
    left.axhline(0, color=style.GREY, linewidth=0.6)
    left.set_xlabel(r"longitudinal creepage $\xi$ [%]")
    left.set_ylabel(r"$-F_x/F_z$: FEM minus half-space [% of $\mu$]")
    left.legend(ncol=3, title="case", loc="upper right")
    left.set_ylim(top=left.get_ylim()[1] * 1.25)
    for name in ("halfspace", "fem"):
        model = results["f"][name]
        right.plot(model.y, model.line(model.points[0].fields["pressure"], "y"), label=f"{style.label(model)}, case f",
                   **style.line(model))
    right.set_xlabel("y across rolling [mm]")
    right.set_ylabel("pressure at x = 0 [MPa]")
    right.set_ylim(top=right.get_ylim()[1] * 1.2)
    right.legend(loc="upper center", ncol=2)
    figure.tight_layout()
    return bench.save(figure, "half_space_limits")


def half_space_limits(bench):
    """The model error of half-space theory in cases e and f"""
    _, results = _compared(bench)
    tables, cost, words = [], [], []
    for letter in "ef":
        bent = bench.run(f"curved_{letter}", f"cases/thesis_{letter}.toml", ["halfspace"],
                         {"+": "\n[halfspace]\nsurface = \"curved\"\n"})
        tables.append(_limit_table(letter, results[letter], bent["halfspace"]))
        half, fem = results[letter]["halfspace"], results[letter]["fem"]
        words.append(_words(letter, half, fem))
        cost.append(Cost(f"case {letter}: half-space", half.seconds["total"], half.unknowns))
        cost.append(Cost(f"case {letter}: FEM", fem.seconds["total"], fem.unknowns))
    below, below_cost = _below(bench)
    flat = [results[c]["fem"].points[0]["traction_coefficient"]
            - results[c]["halfspace"].points[0]["traction_coefficient"] for c in "abcd"]
    return Chapter(
        "half-space-limits", "The model error of half-space theory in e and f",
        "The same normal force, grid and friction in both models; the half-space has the extra slip of the rolling "
        "radius, so the remaining difference is due to the elasticity and geometry of the true, curved bodies.",
        "each other: two independent methods, with their error bars; a to d, whose bodies are flat or convex, show "
        f"the part unrelated to curvature (FEM minus half-space at xi = 0: {number(min(flat), 2)} to "
        f"{number(max(flat), 2)} in -F_x/F_z, the circumferential strain of a loaded wheel, [verification](../verification.md)).",
        tables=tables + _stress_tables(below),
        figures=[(_limits_figure(bench, results), "FEM minus half-space along the creep curve in all cases, and the "
                  "pressure of case f across rolling")],
        cost=cost + below_cost,
        tests=["verification.fem_curved", "verification.CurvedHalfspace.SlipIsThatOfTheTurningWheel"],
        after="\n\n".join(words))


half_space_limits.needs_fem = True


def _words(letter, half, fem):
    """The finding of a case in one sentence, from its numbers."""
    def change(key):
        return percent(fem.points[0][key] / half.points[0][key] - 1)
    shift = fem.points[0]["traction_coefficient"] - half.points[0]["traction_coefficient"]
    most = max((abs(q["traction_coefficient"] - p["traction_coefficient"]), p["longitudinal_creepage"])
               for p, q in zip(half.points, fem.points))
    return (f"Case {letter}: finite elements have {change('max_pressure')} of pressure and {change('semi_axis_y')} "
            "of width "
            f"beside the half-space; at xi = 0 they have {number(fem.points[0]['traction_coefficient'], 3)} where it has "
            f"{number(half.points[0]['traction_coefficient'], 3)}, {percent(shift / 0.55)} of mu; the largest "
            "difference of "
            f"the creep curve is {number(100 * most[0] / 0.55, 2)} % of mu at xi = {100 * most[1]:g} %.")
