"""The finite-element model against Hertz: what refining its cells brings."""
from matplotlib import pyplot as plt

from .. import closed_forms
from ..chapter import Chapter, Cost, Row


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
        "Hertz's closed form. The bodies are nearly half-spaces, so the remaining error is that of discretisation.", rows,
        figures=[(name, "Errors against Hertz on three meshes")],
        cost=[Cost(f"{level['label']}, two load points", level["seconds"], level["unknowns"])
              for level in series["levels"]],
        tests=["verification.fem_case_a", "verification.FlatBodies.DisplacementMatchesTheHalfSpaceUpToTheFarBoundary"])


fem_hertz.needs_fem = True
