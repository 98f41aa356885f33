# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creep curves that were measured."""
import numpy as np
from matplotlib import pyplot as plt

from .. import closed_forms, layered_cylinders, published, style
from ..chapter import Chapter, Cost, Row, Table
from ..page import number, percent
from ..runs import RunFailed
from .carter import LARGEST, LOAD, ROLLERS, STEEL

FRICTION, RADIUS, WIDTH = 0.46, 23.5, 10.0  # mm; of cases/twin_disc.toml
MODULUS = 210e3 / (2 * (1 - 0.3**2))
LAYER = 0.02, 12000.0  # thickness in mm, shear modulus in MPa: fitted
LAYER_TEXT = f"\n[layer]\nthickness = {LAYER[0]}\nshear_modulus = {LAYER[1]}\n"


def _traction_measured():
    """{slip: traction coefficient} from the heat of friction."""
    return {slip: heat / (slip * published.TWIN_DISC_SPEED * published.TWIN_DISC_FORCE)
            for slip, heat in published.TWIN_DISC.items()}


def _patch():
    """(a, p0) of the discs in line contact."""
    force = published.TWIN_DISC_FORCE / WIDTH
    a = np.sqrt(4 * force * RADIUS / 2 / (np.pi * MODULUS))
    return a, 2 * force / (np.pi * a)


def _carter(slip):
    a, pressure = _patch()
    return closed_forms.carter_force(a, pressure, FRICTION, MODULUS, slip) * WIDTH / published.TWIN_DISC_FORCE


def _layered(slip, elements=600):
    a, pressure = _patch()
    return layered_cylinders.creep_force(a, pressure, FRICTION, MODULUS, slip, LAYER[0] / LAYER[1],
                                         elements) * WIDTH / published.TWIN_DISC_FORCE


def _draw(bench, elastic, layered):
    """The measured curve over the computed ones: on a logarithmic scale of slip, and where it begins."""
    measured = _traction_measured()
    figure, axes = plt.subplots(1, 2, figsize=(8.8, 3.6), sharey=True, gridspec_kw={"width_ratios": [1.5, 1]})
    wide, small = np.geomspace(1e-3, 0.25, 120), np.linspace(0, 0.0125, 60)
    for axis, slip in zip(axes, (wide, small)):
        axis.plot(100 * slip, [_carter(s) for s in slip], color="#0072B2", linewidth=style.LINE,
                  label="elastic discs (Carter)")
        axis.plot(100 * slip, [_layered(s, 150) for s in slip], color="#D55E00", linewidth=style.LINE, linestyle=(0, (5, 2)),
                  label="with a layer, fitted")
        for model, colour, marker in ((elastic, "#0072B2", "s"), (layered, "#D55E00", "D")):
            axis.plot([100 * p["longitudinal_creepage"] for p in model.points],
                      [p["traction_coefficient"] for p in model.points], linestyle="none", marker=marker, markersize=4.5,
                      markerfacecolor="none", color=colour, label="the same by half-space")
        axis.plot([100 * s for s in measured], list(measured.values()), linestyle="none", marker="o", markersize=6.5,
                  color="black", label="measured", zorder=4)
        axis.set_xlabel("slip [%]")
    axes[0].set_xscale("log")
    axes[0].set_xticks([0.1, 0.2, 0.5, 1, 3, 10, 20], ["0.1", "0.2", "0.5", "1", "3", "10", "20"])
    axes[0].minorticks_off()
    axes[0].set_ylabel("traction coefficient $T/N$")
    axes[0].set_ylim(0, 0.56)
    axes[0].set_title("the whole curve")
    axes[1].set_xlim(0, 1.25)
    axes[1].set_title("small slip")
    handles, labels = axes[0].get_legend_handles_labels()
    order = (4, 0, 2, 1, 3)
    axes[1].legend([handles[k] for k in order], [labels[k] for k in order], loc="lower right")
    figure.tight_layout()
    return bench.save(figure, "measured")


def _beside(elastic, layered):
    """What was measured beside what is computed, slip by slip."""
    rows = []
    for slip, measured in _traction_measured().items():
        computed = [model.nearest(slip)["traction_coefficient"] for model in (elastic, layered)]
        rows.append([f"{100 * slip:g} %", number(measured, 3), number(computed[0], 3), percent(measured / computed[0] - 1),
                     number(computed[1], 3), percent(measured / computed[1] - 1)])
    return Table("T/N; in percent: measured over computed, less 1:",
                 ["slip", "measured", "elastic", "", "with a layer", ""], rows)


def _ends(model):
    """T/N of discs with ends beside endless ones."""
    rows = [[f"{100 * slip:g} %", number(_carter(slip), 4), number(model.nearest(slip)["traction_coefficient"], 4)]
            for slip in (0.002, 0.005, 0.01)]
    return Table("The width of the discs: T/N of endless discs, and of 10 mm with [ends rounded with 0.5 "
                 "mm](../../cases/verification/twin_disc_ends.toml) (half-space, 80 across):",
                 ["slip", "endless", "10 mm wide"], rows)


def _adhering(bench):
    """Rollers of a = 1 mm that adhere, with layers from soft to stiff beside the bodies, and both limits of collocation."""
    modulus, xi, rows = published.CONTACT_MODULUS, 1e-7, []

    def collocated(compliance):
        return layered_cylinders.creep_force(1.0, LARGEST, 0.3, modulus, xi, compliance, 400)
    rows += [Row("collocation, stiff layer: force in full adhesion", "N/mm", closed_forms.carter_force(1.0, LARGEST, 0.3, modulus, xi),
                 collocated(1e-3 / modulus), 2e-3, by="against Carter"),
             Row("collocation, soft layer: force in full adhesion", "N/mm", 2 * xi / (1e6 / modulus), collocated(1e6 / modulus),
                 5e-5, by="against rigid bodies")]
    for ratio in (0.1, 1.0, 10.0):
        compliance = 2 / (np.pi * modulus * ratio)
        for across, allowed in ((40, 5e-3), (80, 2e-3)):
            text = ROLLERS.format(load=LOAD, friction=0.3, wheel=STEEL, geometry="", across=across,
                                  rolling=f"longitudinal_creepage = {xi}")
            text += f"[layer]\nthickness = {82e3 * compliance!r}\nshear_modulus = 82e3\n"
            point = bench.run_text(f"layer_{ratio:g}_{across}", text, ["halfspace"])["halfspace"].points[0]
            rows.append(Row(f"2/(pi E* c) = {ratio:g}: force in full adhesion", "N/mm", collocated(compliance),
                            -point["longitudinal_force"], allowed, by=f"half-space, {across} across, against collocation"))
    return rows


def _sharp(bench, name, cell, place=0.0, wheel="radii = [inf]", rail="", roll="", force=7198.0):
    """(model, largest pressure and line load of every row of elements) of a disc of 10 mm with sharp ends on a roller of 60 mm."""
    text = bench.case_text("cases/verification/twin_disc_ends.toml", {
        "load.vertical_force": force, "friction.coefficient": 0.0, "wheel_profile.ends": "[-5.0, 5.0]\nfree_ends = true",
        "rail_profile.radii": "[inf]", "rail_profile.ends": f"[-30.0, 30.0]{rail}", "placement.lateral_position": f"{place}{roll}",
        "rolling.longitudinal_creepage": 0.0}).replace("radii = [0.5, inf, 0.5]", wheel).replace(
            "elements_across = 80", f"cell_size = [0.04, {cell}]")
    model = bench.run_text(f"sharp_{name}", text, ["halfspace"])["halfspace"]
    pressure = model.points[0].fields["pressure"]
    pressure = pressure[pressure.max(axis=1) > 0]
    return model, pressure.max(axis=1), pressure.sum(axis=1) * model.dx


def _sharp_rows(bench):
    """Sharp ends: a punch across, and Hertz in its middle."""
    model, pressure, load = _sharp(bench, "eighth", 0.125)
    middle = len(pressure) // 2
    assert len(pressure) == 80 and 0.85 < load[middle] / 719.8 < 1  # the ends carry more than the mean
    rows = [Row("sharp ends: force", "N", 7198.0, model.points[0]["normal_force"], 1e-3 / 7198, by="0.125 mm"),
            Row("sharp ends: pressure of a row over that of its mirror image, farthest", "", 0.0,
                np.abs(pressure / pressure[::-1] - 1).max(), 1e-4, of=1.0, of_words="1", by="0.125 mm"),
            Row("sharp ends: pressure in the middle", "MPa", np.sqrt(load[middle] * MODULUS / (np.pi * RADIUS / 2)), pressure[middle],
                5e-3, by="Hertz under its line load")]
    # As over the edge of a punch, with the root of the distance.
    (coarse, coarse_edge, _), (fine, fine_edge, _) = _sharp(bench, "16th", 0.0625), _sharp(bench, "32nd", 0.03125)
    tilted, leaning, _ = _sharp(bench, "tilted", 0.1, roll="\nroll = 0.0005")
    beside = _sharp(bench, "beside", 0.125, 27.0, rail="\nfree_ends = true")[0]
    crowned = _sharp(bench, "crowned", 0.25, wheel="radii = [200.0]", force=500.0)[0]
    warned = [any(note.about == "free_ends" and note.severity == "warning" for note in run.notes) for run in (model, beside, crowned)]
    assert warned == [True, True, False] and leaning[-1] > 1.2 * leaning[0], (warned, leaning[[0, -1]])
    assert fine.points[0].no_bar["max_pressure"] == "no limit" and fine.points[0].bar("approach") > 0
    try:
        _sharp(bench, "off_the_end", 0.125, 27.0)
    except RunFailed:
        pass
    else:
        raise AssertionError("a disc over the end of a roller without free ends")
    return [*rows,
            Row("sharp ends: pressure at the end on elements half as wide over that before", "", np.sqrt(2), fine_edge[0] / coarse_edge[0],
                0.049, by="0.031 mm"),
            Row("sharp ends: approach on elements half as wide", "mm", coarse.points[0]["approach"], fine.points[0]["approach"], 2e-3,
                by="0.031 mm"),
            Row("disc half beside its roller: width", "mm", 8.0, beside.points[0]["contact_width"], 0.15 / 8, by="0.125 mm"),
            Row("tilted disc: width", "mm", 10.0, tilted.points[0]["contact_width"], 1e-3, by="0.1 mm")]


def measured(bench):
    """Measured: the creep curve of a twin-disc machine"""
    case = "cases/twin_disc.toml"
    run = bench.run("measured_elastic", case, ["hertz", "carter", "halfspace"])
    elastic, theory, hertz = run["halfspace"], run["carter"], run["hertz"]
    layered = bench.run("measured_layer", case, ["halfspace"], {"+": LAYER_TEXT})["halfspace"]
    ends = bench.run("measured_ends", "cases/verification/twin_disc_ends.toml")["halfspace"]
    speed = np.pi * 2 * RADIUS * 1e-3 * 400 / 60
    rows = [Row("p0 of discs of 47 mm under 7198 N", "MPa", published.TWIN_DISC_PRESSURE, hertz.points[0]["max_pressure"], 1e-3,
                by="hertz"),
            Row("surface speed of discs of 47 mm at 400 rpm", "m/s", published.TWIN_DISC_SPEED, speed, 1e-3)]
    for slip in (0.002, 0.005, 0.01, 0.03):
        at = f"T/N at {100 * slip:g} % of slip"
        rows += [Row(f"{at}, elastic", "", _carter(slip), elastic.nearest(slip)["traction_coefficient"], 1e-3,
                     by="half-space, 80 across, against Carter"),
                 Row(f"{at}, elastic", "", _carter(slip), theory.nearest(slip)["traction_coefficient"], 1e-6,
                     by="model carter, against Carter"),
                 Row(f"{at}, with a layer", "", _layered(slip), layered.nearest(slip)["traction_coefficient"], 1e-3,
                     of=FRICTION, of_words="mu", by="half-space, 80 across, against collocation")]
    rows += [*_adhering(bench), *_sharp_rows(bench)]
    slope = _layered(1e-5) / _carter(1e-5)
    return Chapter(
        "measured", "Measured: the creep curve of a twin-disc machine",
        "Two discs of 47 mm in diameter, a wheel steel (R8T) driven against a rail steel (900A), dry, track 10 mm wide, 400 rpm, "
        "1500 MPa ([case](../../cases/twin_disc.toml)): a line contact with both radii. mu = 0.46 is what was measured from 7.5 to "
        f"15 %. The layer of {LAYER[0]} mm and {LAYER[1]:g} MPa was fitted to the curve.",
        "measured by Lewis and Dwyer-Joyce (2004), given as the heat of friction at eight slips (the paper itself was not at "
        "hand): T/N = heat/(slip V N). Load and pressure, and speed and rotation, give 47 mm each (first two rows). "
        "Computed: Carter's closed form, and with a layer collocation (`benchmarks/book/layered_cylinders.py`), which shares nothing with the program. Last rows: rollers of 500 mm under 179 N/mm, mu = 0.3, with a layer of the compliance "
        "c (thickness over shear modulus), at a creepage of 1e-7.",
        rows, tables=[_beside(elastic, layered), _ends(ends)],
        figures=[(_draw(bench, elastic, layered), "Traction over slip: measured, and computed without and with a layer")],
        cost=[Cost("line contact, eight load points", elastic.seconds["total"], elastic.unknowns),
              Cost("discs with ends, four load points", ends.seconds["total"], ends.unknowns)],
        after="**What fits.** From 7.5 to 15 % all is slip, and T/N = mu, because mu was chosen so. With the layer, fitted by one "
              "number (thickness over shear modulus), the points at 0.2 and 1 % lie within 7 %.\n\n"
              "**What does not.** Elastic discs carry too much at small slip: measured are 65 % of it at 0.2 %, 85 % at 0.5 % and 81 % "
              "at 1 %. In the words of the literature, Kalker's initial slope (here Carter's) must be reduced: real "
              "surfaces are rough and covered with wear particles. The fitted layer reduces it to "
              f"{100 * slope:.0f} %. No layer passes through all points: from 0.2 to 0.5 % the measured traction rises more than the slip "
              "does (2.8 against 2.5 times), while every computed curve bends the other way, so at least one of them is some 10 % "
              "off. That friction is higher at 3 and 20 % than in between is beyond a constant mu.\n\n"
              "**What it means.** rollfem solves the given problem to 0.1 %. That elastic bodies with Coulomb's friction describe "
              "your surfaces is not implied: here they do in full slip, for which mu was fitted, and not below. Where the slope at "
              "small creepage matters, as for stability or the control of drives, give a `[layer]` ([friction](../friction.md)), or "
              "`slope_reduction` and Polach's factors in the fast models, from a measurement on your surfaces. One curve of one "
              "machine is no validation; others with geometry, load and numbers were looked for and not found.\n\n"
              "**Ends.** Rounded ends lower T/N by 2 to 4 %. The pressure at the ends is beyond a half-space and "
              f"beyond elastic steel: {ends.points[0]['max_pressure']:.0f} MPa here, 4550 with elements a fourth as large, which its "
              "bar of 60 % tells. Sharp ends are `free_ends = true` ([profiles](../profiles.md#ends-inside-the-patch)).")
