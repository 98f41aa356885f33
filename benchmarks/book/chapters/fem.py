# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finite-element model against Hertz on finer cells; the hybrid against CalculiX."""
import numpy as np
from calculix.curved_patch import PAIRS, fitted
from matplotlib import pyplot as plt

from .. import closed_forms, published
from ..chapter import Chapter, Cost, Row, Table
from ..page import number


def fem_hertz(bench):
    """Finite elements on finer cells: Hertz's case a"""
    study = bench.study("study_fem_a", "cases/thesis_a.toml", ["--model", "fem", "--vary", "cell"],
                        {"rolling.longitudinal_creepage": "[0.0, 0.002]"})
    series = study["places"][0]["series"][0]
    exact = dict(zip(("semi_axis_x", "semi_axis_y", "max_pressure", "approach"),
                     closed_forms.hertz(1 / 810, 1 / 4000, 50e3, 210e3 / (2 * (1 - 0.3**2)))))
    finest = series["levels"][-1]
    rows = [Row(words, unit, exact[key], finest["values"][key], most, by=f"cells of {finest['parameter']:g} mm")
            for key, words, unit, most in (("max_pressure", "p0", "MPa", 0.003), ("semi_axis_x", "a", "mm", 0.01),
                                           ("semi_axis_y", "b", "mm", 0.01), ("approach", "approach", "mm", 0.002))]
    for before, level in zip(series["levels"], series["levels"][1:]):
        rows.append(Row(f"error of p0 over that on cells of {before['parameter']:g} mm", "", 0.0,
                        abs(level["values"]["max_pressure"] - exact["max_pressure"])
                        / abs(before["values"]["max_pressure"] - exact["max_pressure"]), of=1.0,
                        by=f"cells of {level['parameter']:g} mm"))
    figure, axis = plt.subplots(figsize=(4.6, 3.3))
    unknowns = [level["unknowns"] for level in series["levels"]]
    for key, words, ink, mark in (("max_pressure", "$p_0$", "#0072B2", "o"), ("semi_axis_x", "a", "#D55E00", "s"),
                                  ("semi_axis_y", "b", "#009E73", "^"), ("approach", "approach", "#CC79A7", "v")):
        errors = [100 * abs(level["values"][key] / exact[key] - 1) for level in series["levels"]]
        axis.loglog(unknowns, errors, color=ink, marker=mark, markersize=5, linewidth=1.2, label=words)
    axis.set_xticks(unknowns, [f"{level['parameter']:g} mm\n{level['unknowns'] / 1000:.0f} k"
                               for level in series["levels"]])
    axis.minorticks_off()
    axis.set_xlabel("cells in the patch, unknowns")
    axis.set_ylabel("error against Hertz [%]")
    axis.legend()
    name = bench.save(figure, "fem_hertz")
    return Chapter(
        "fem-hertz", "Finite elements on finer cells: Hertz's case a",
        "Case a, degree 2, segments with the far boundary of a half-space under a point load; cells and contact "
        "elements of 1.88, 0.94 and "
        "0.47 mm (a/2, a/4, a/8), `rollfem study cases/thesis_a.toml --model fem --vary cell`.",
        "Hertz's closed form. The bodies are nearly half-spaces, so the remaining error is discretisation.", rows,
        figures=[(name, "Errors against Hertz on three meshes")],
        cost=[Cost(f"{level['label']}, two load points", level["seconds"], level["unknowns"])
              for level in series["levels"]],
        tests=["verification.fem_case_a", "verification.FlatBodies.DisplacementMatchesTheHalfSpaceUpToTheFarBoundary"])


fem_hertz.needs_fem = True


def _normal_contact(bench, case, friction):
    """{model: p0, b by the fit, sum of p dA over the force, bar of p0} of a case at xi = 0."""
    result = bench.run(f"calculix_{case}_{friction:g}", f"cases/thesis_{case}.toml", ["halfspace", "hybrid"],
                       {"rolling.longitudinal_creepage": 0.0, "friction.coefficient": friction})
    found = {}
    for model in result.models:
        point = model.points[0]
        x, arc = np.meshgrid(model.x, model.y)
        _, _, b = fitted(PAIRS["f"][0], x.ravel(), arc.ravel(), point.fields["pressure"].ravel())
        area = (model.x[1] - model.x[0]) * (model.y[1] - model.y[0])
        found[model.name] = {"p0": point["max_pressure"], "b": b, "sum_over_force": point.fields["pressure"].sum() * area / 5e4,
                             "seconds": model.seconds["total"], "unknowns": model.unknowns}
    return found


def calculix(bench):
    """The effect of a curved patch by an independent finite-element program: CalculiX on cases a and f"""
    recorded, finest = published.calculix("f")
    stored = {by: line for by, line in recorded.items() if by.startswith("CalculiX")}
    runs = {friction: {case: _normal_contact(bench, case, friction) for case in "af"} for friction in (0.0, 0.55)}

    def change(line, key):
        return line["f"][key] - line["a"][key]
    lines = [(by, 0.0, line) for by, line in stored.items()]
    lines += [({"halfspace": "half-space", "hybrid": "hybrid"}[name], friction, {c: found[c][name] for c in "af"})
              for friction, found in runs.items() for name in ("halfspace", "hybrid")]
    table = Table("All by the same fit of p² inside half of the patch (b), p0 of CalculiX by that fit too:",
                  ["by", "mu", "p0(a), MPa", "p0(f), MPa", "f - a", "b(a), mm", "b(f), mm", "f - a",
                   "sum of p dA over F_z, f"],
                  [[by, f"{mu:g}", number(line["a"]["p0"], 5), number(line["f"]["p0"], 5), f"{change(line, 'p0'):+.2f}",
                    number(line["a"]["b"], 5), number(line["f"]["b"], 5), f"{change(line, 'b'):+.3f}",
                    f"{line['f']['sum_over_force']:.4f}"] for by, mu, line in lines])
    hybrid = {c: runs[0.0][c]["hybrid"] for c in "af"}
    rubbed = {c: runs[0.55][c]["hybrid"] for c in "af"}
    rows = [Row("p0(f) - p0(a)", "MPa", change(finest, "p0"), change(hybrid, "p0"), 0.3, of=1.0, of_words="1 MPa", by="hybrid"),
            Row("b(f) - b(a)", "mm", change(finest, "b"), change(hybrid, "b"), 0.03, of=1.0, of_words="1 mm", by="hybrid"),
            Row("f: sum of p dA over F_z", "", finest["f"]["sum_over_force"], hybrid["f"]["sum_over_force"], 3e-4, by="hybrid")]
    return Chapter(
        "calculix", "A curved patch by another finite-element program",
        "Cases a and f without friction, 50 kN: the same Hertzian ellipse, in f on a rail of 50 mm under a concave wheel of "
        "51.282 mm. CalculiX 2.20 (Debian's `calculix-ccx`) on quarter bodies of 60 mm: one mesh of bricks (C3D8I) mapped onto "
        "both shapes, so that its errors cancel in the difference; gap elements whose clearance is the undeformed distance "
        "by formula (`benchmarks/calculix/curved_patch.py`, which writes the decks, runs `ccx` and prints this table). The hybrid "
        "at xi = 0 on 40 across.",
        "CalculiX, whose elements, contact and solver share nothing with this program: " + ", ".join(
            f"{by.split(', ')[1]} {line['a']['cpu_seconds']} CPU s a case" for by, line in stored.items())
        + ". A plane half-space has no difference between both cases.",
        rows, tables=[table],
        cost=[Cost("half-space and hybrid, four cases", sum(r[c][m]["seconds"] for r in runs.values() for c in "af" for m in r[c]))],
        tests=["verification.Hybrid.MeetsTheLimitOfFiniteElements"],
        after=f"**What curvature does.** p0 rises by {change(hybrid, 'p0'):.1f} MPa and the patch becomes narrower, although "
              "Hertz has the same ellipse: pressure on the flanks of the arc points inwards, so that its sum along the arc is "
              "0.45 % more than the vertical load, and bodies that curve with the patch are not half-spaces. CalculiX's "
              f"difference grows from {change(stored[max(stored)], 'p0'):.2f} to {change(finest, 'p0'):.2f} MPa from cells of "
              "0.95 to 0.63 mm.\n\n"
              f"**What friction does.** With mu = 0.55 the hybrid has {change(rubbed, 'p0'):+.1f} MPa instead of "
              f"{change(hybrid, 'p0'):+.1f}, all of it in f ({rubbed['f']['p0'] - hybrid['f']['p0']:+.1f} MPa there, "
              f"{rubbed['a']['p0'] - hybrid['a']['p0']:+.2f} in a). Friction across the arc points up the flanks: pressure then "
              f"sums to {rubbed['f']['sum_over_force']:.4f} of the load instead of {hybrid['f']['sum_over_force']:.4f}, so that "
              f"friction bears {100 * (1 - rubbed['f']['sum_over_force'] / hybrid['f']['sum_over_force']):.2f} % of it, and the "
              f"patch is {rubbed['f']['b'] - hybrid['f']['b']:.2f} mm wider in b. A comparison with a program without friction "
              "must be made without it.")


calculix.needs_fem = True
