# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layer between wheel and rail that yields."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import PLASTIC

from ..chapter import Chapter, Cost, Row

_CASE = """[load]
normal_force = 100e3
[friction]
coefficient = {mu!r}
[wheel]
rolling_radius = 460.0
transverse_radius = inf
[rail]
transverse_radius = 300.0
[rolling]
longitudinal_creepage = {creepages}
{rolling}
[contact_grid]
elements_across = {across}
[layer]
{layer}
"""


def _run(bench, name, creepages, across, elastic=(0.02, 800.0), yields=None, mu=0.4, rolling="", more=""):
    """A wheel on a rail with a layer (thickness, G) that yields at (stress in MPa, hardening in MPa/mm)."""
    layer = (f"thickness = {elastic[0]}\nshear_modulus = {elastic[1]}\n" if elastic else "")
    layer += f"yield_stress = {yields[0]}\nhardening = {yields[1]}\n" if yields else ""
    text = _CASE.format(mu=mu, creepages=creepages, rolling=rolling, across=across, layer=layer + more)
    return bench.run_text(f"yielding_{name}", text, ["halfspace"])["halfspace"]


def _forces(model):
    return np.array([-point["longitudinal_force"] for point in model.points])


def _elastic_rows(bench):
    """Layers that are strong, or harden fast, are elastic."""
    creepages, rows = [0.001, 0.004, 0.02], []
    elastic = _forces(_run(bench, "elastic", creepages, 20))
    for hardening in (0.0, 1e3, -1e3):
        strong = _forces(_run(bench, f"strong_{hardening:g}", creepages, 20, yields=(1e6, hardening)))
        rows.append(Row(f"strong layer, hardening {hardening:g}: force, farthest", "", 1.0,
                        1 + max(strong / elastic - 1, key=abs), 1e-6, by="elastic layer"))
    missing = {k: 1 - _forces(_run(bench, f"hardens_{k:g}", creepages[:2], 20, yields=(50.0, k))) / elastic[:2]
               for k in (1e6, 1e7, 1e8)}
    rows += [Row(f"missing force at hardening {k:g} over that at a tenth, xi = {xi} %", "", 0.1, missing[k][n] / missing[k / 10][n], 0.15)
             for k in (1e7, 1e8) for n, xi in enumerate((0.1, 0.4))]
    return [*rows, Row("missing force at hardening 1e8", "", 0.0, missing[1e8][0], 1e-4, of=1.0, of_words="the force")]


def _plateau_rows(bench):
    """A perfectly plastic layer bears its yield stress on the whole patch; friction is lower at the rim only."""
    rows = []
    for across, allowed in ((40, 0.02), (160, 5e-3)):
        model = _run(bench, f"plateau_{across}", [0.001, 0.01, 1.0], across, None, (150.0, 0.0), 100.0)
        last, by = model.points[-1], f"{across} across"
        pressure = last.fields["pressure"]
        cell = (model.x[1] - model.x[0]) * (model.y[1] - model.y[0])
        rows += [Row("perfectly plastic: largest traction", "MPa", 150.0, max(p["max_traction"] for p in model.points[1:]), 1e-6, by=by),
                 Row("perfectly plastic: force", "N", np.sum(np.minimum(100 * pressure, 150.0)) * cell, -last["longitudinal_force"], 1e-6,
                     by=f"{by}, sum over elements"),
                 Row("perfectly plastic: force", "N", 150 * np.pi * last["semi_axis_x"] * last["semi_axis_y"],
                     -last["longitudinal_force"], allowed, by=by),
                 Row("perfectly plastic: area of adhesion", "mm²", 0.0, last["adhesion_area"], 1e-9, of=1.0, of_words="1 mm²", by=by)]
        assert np.sum(last.fields["state"] == PLASTIC) > 800
    return rows


def _brush(d, hardening, compliance=1000 / 8.2, stress=0.02):
    """Traction of the layer alone under xi = 1, d behind the leading edge of a row."""
    past = np.maximum(d - stress * compliance, 0.0)
    plastic = stress + (past / (compliance + 1 / hardening) if hardening else 0.0)
    return np.where(past > 0, np.maximum(plastic, 0.0), d / compliance)


def _brush_rows(bench):
    """A layer much softer than the bodies is a brush; elements are coarser than its kinks, of which one loses all stress."""
    rows = []
    for hardening in (0.0, 0.0082, 0.1, -0.001, -0.004):
        worst = {}
        for across in (40, 80):
            model = _run(bench, f"brush_{hardening:g}_{across}", [1.0], across, (1000.0, 8.2), (0.02, hardening))
            point = model.points[0]
            a, b = point["semi_axis_x"], point["semi_axis_y"]
            x, y = np.meshgrid(model.x, model.y)
            inside = (np.abs(y / b) <= 0.5) & ((x / a) ** 2 + (y / b) ** 2 <= 0.81)
            exact = _brush(a * np.sqrt(1 - (y[inside] / b) ** 2) - x[inside], hardening)
            worst[across] = np.max(np.abs(-point.fields["traction_x"][inside] - exact)) / 0.02
        kinks = 2 if hardening == -0.004 else 1
        rows += [Row(f"soft layer, hardening {hardening:g}: largest difference from its brush", "", 0.0, worst[across], allowed * kinks,
                     of=1.0, of_words="the yield stress", by=f"{across} across") for across, allowed in ((40, 0.04), (80, 0.02))]
        rows.append(Row(f"soft layer, hardening {hardening:g}: part of the difference that 80 across leave", "", 0.0,
                        worst[80] / worst[40], 0.7, of=1.0, of_words="that at 40"))
    return rows


def _order_rows(bench):
    rows = []
    for hardening in (2e3, -400.0):
        points = [_run(bench, f"order_{hardening:g}_{n}", [0.004], n, yields=(100.0, hardening)).points[0] for n in (12, 24, 48, 96)]
        at = [-point["longitudinal_force"] for point in points]
        rows.append(Row(f"hardening {hardening:g}: order of the force, 12 to 48 across, up to 2", "", 2.0,
                        min(2.0, np.log2((at[1] - at[0]) / (at[2] - at[1]))), 0.25))
        limit = at[3] + (at[3] - at[2]) / 3
        rows += [Row(f"hardening {hardening:g}: force, {n} across", "N", limit, at[k], points[k].bar("longitudinal_force") / limit,
                     by="extrapolated, within its bar") for k, n in ((1, 24), (2, 48), (3, 96))]
    steady = _forces(_run(bench, "steady", [0.004], 48, yields=(100.0, 2e3)))[0]
    off = {}
    for length in (0.5, 0.25):
        rolled = _run(bench, f"steps_{length}", [0.004], 48, yields=(100.0, 2e3), rolling='problem = "transient"',
                      more=f"[history]\nsteps = {round(20 / length)}\nstep_length = {length}\n")
        off[length] = _forces(rolled)[-1] / steady - 1
    return [*rows, Row("force after 20 mm of steps of 0.25 mm from rest", "N", steady, steady * (1 + off[0.25]), 0.01, by="steady rolling"),
            Row("its difference over that of steps of 0.5 mm", "", 0.0, abs(off[0.25] / off[0.5]), 1.0, of=1.0, of_words="1")]


def yielding_layer(bench):
    """A layer that yields: limits, a brush in closed form, order"""
    figure, axis = plt.subplots(figsize=(4.8, 3.3))
    d = np.linspace(0, 12, 400)
    for hardening, ink in ((0.1, "#D55E00"), (0.0082, "#009E73"), (0.0, "#0072B2"), (-0.001, "#CC79A7"), (-0.004, "#E69F00")):
        axis.plot(d, _brush(d, hardening) / 0.02, color=ink, label=f"k = {hardening:g} MPa/mm")
    axis.set_xlabel("distance behind the leading edge [mm]")
    axis.set_ylabel("traction over the yield stress")
    axis.legend(fontsize="small")
    rows = [*_elastic_rows(bench), *_plateau_rows(bench), *_brush_rows(bench), *_order_rows(bench)]
    model = _run(bench, "order_2000_96", [0.004], 96, yields=(100.0, 2e3))
    return Chapter(
        "yielding-layer", "A layer that yields: limits, a brush in closed form, order",
        "100 kN on a wheel of 460 mm and a flat rail head of 300 mm, mu = 0.4, with a layer (mostly 0.02 mm, G = 800 MPa) that yields and "
        "hardens or softens.",
        "the elastic layer where it is strong or hardens fast (what it gives way falls as 1/k); the yield stress times the patch where it "
        "is perfectly plastic; the brush of a layer a million times softer than the bodies, row by row; its own limits on finer grids "
        "and steady rolling for steps in time.",
        rows, figures=[(bench.save(figure, "yielding_layer"), "The brush in closed form at xi = 100 %")],
        cost=[Cost("96 across", model.seconds["total"], model.unknowns)],
        tests=["verification.PlasticLayer.SeriesOfContactOnOneElement", "verification.PlasticLayer.OfCurvedBodiesHoldsTheYieldStressAtEveryElement"])
