# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stress below a line contact: McEwen's closed form, antiplane shear, and Norton's crane wheel."""
import numpy as np
from rollfem.stresses import stress_measures as measures

from .. import closed_forms
from ..chapter import Row, at_most, closest
from .carter import LARGEST, LOAD, ROLLERS, STEEL

NU = 0.28
# Norton (Machine Design, example 7-2): N on 22.225 mm, p0 in MPa, a in mm.
CRANE_FORCE, CRANE_WIDTH, CRANE_PRESSURE, CRANE_AXIS = 22241.11, 22.225, 484.31, 1.3157
_CRANE = """[load]
{load}
[friction]
coefficient = 0.3
[wheel]
rolling_radius = 152.4
young_modulus = 206843.0
poisson_ratio = 0.28
[rail]
young_modulus = 206843.0
poisson_ratio = 0.28
[geometry]
shape = "line"
width = {width}
{reference}
{more}
"""


def _below(bench, across, rolling, friction, points):
    """{depth: (x, stresses over p0)} in the wheel of sliding cylinders of a = 1 mm."""
    text = ROLLERS.format(load=LOAD, friction=friction, wheel=STEEL, geometry="", rolling=rolling, across=across)
    text += "".join(f'[[subsurface.line]]\nbody = "wheel"\nfrom = [{first}, 3.3, {z}]\nto = [{last}, 3.3, {z}]\npoints = {count}\n'
                    for z, first, last, count in points)
    point = bench.run_text(f"line_stress_{across}_{rolling.split('_')[0]}_{friction:g}", text, ["halfspace"])["halfspace"].points[0]
    return {z: (line["points"][:, 0], line["stress"] / LARGEST) for (z, *_), line in zip(points, point.subsurface)}


def _mcewen_rows(bench):
    """All components of sliding cylinders against McEwen, and the order of the elements."""
    rows = []
    points = [(0.1, -1.6, 1.6, 33), (0.3, -1.6, 1.6, 33), (0.786, -1.6, 1.6, 33), (2.0, -1.6, 1.6, 33), (20.0, -12.0, 12.0, 25)]
    for friction in (0.0, 0.2, 0.4):
        worst = {across: max(np.abs(stress - closed_forms.mcewen(x, z, -friction, NU)).max() for z, (x, stress) in _below(
            bench, across, "longitudinal_creepage = 0.05", friction, points).items()) for across in (50, 200)}
        order = np.log(worst[50] / worst[200]) / np.log(4)
        rows += [Row(f"line, mu = {friction:g}: largest difference of a component", "p0", 0.0, worst[200], 2e-4, of=1.0, of_words="p0",
                     by="200 elements"),
                 Row(f"line, mu = {friction:g}: order, 50 to 200 elements, up to 1.6", "", 1.6, min(order, 1.6), 1e-9)]
    # Johnson (1985): 0.3003 p0 of shear at 0.786 a, on the axis; von Mises at nu = 0.3.
    axis = np.linspace(0.5, 1.0, 501)
    shear = 0.5 * measures(closed_forms.mcewen(0.0, axis, 0.0, 0.3))["tresca"]
    mises = measures(closed_forms.mcewen(0.0, np.array([0.704]), 0.0, 0.3))["von_mises"][0]
    edge = closed_forms.mcewen(np.array([0.866]), 0.5, 0.0, NU)[0, 5]
    rows += [Row(f"closed form: {words}", unit, value, found, 1e-4, of=1.0, of_words=of, by="Johnson") for words, unit, value, found, of in (
        ("largest shear", "p0", 0.3003, shear.max(), "p0"), ("von Mises stress at 0.704 a", "p0", 0.5576, mises, "p0"),
        ("orthogonal shear at (0.866, 0.5) a", "p0", -0.25, edge, "p0"))]
    return [*rows, Row("closed form: depth of the largest shear", "a", 0.786, axis[shear.argmax()], 1e-3, of=1.0, of_words="a", by="Johnson")]


def _antiplane_rows(bench):
    """yz + i xy is -q0 times sqrt(1 - w^2) + i w, w = x + i z, under q0 sqrt(1 - x^2) along y."""
    worst = 0.0
    for z, (x, stress) in _below(bench, 400, "lateral_creepage = 0.05", 0.25, [(0.2, -1.3, 1.3, 27), (0.8, -1.3, 1.3, 27)]).items():
        w = x + 1j * z
        field = 0.25 * (np.sqrt(1 - w * w) + 1j * w)
        worst = max(worst, np.abs(stress[:, 4] - field.real).max(), np.abs(stress[:, 3] - field.imag).max())
    return [Row("line, friction across: largest difference of the antiplane shear", "p0", 0.0, worst, 1e-4, of=1.0, of_words="p0",
                by="400 elements")]


def _crane(bench, name, load, width=CRANE_WIDTH, reference="", more=""):
    text = _CRANE.format(load=load, width=width, reference=reference, more=more)
    return bench.run_text(f"crane_{name}", text, ["halfspace"])["halfspace"].points[0]


def _crane_rows(bench):
    """Maxima, a line below the middle, and displacements of Norton's crane wheel."""
    rows, force = [], CRANE_FORCE / CRANE_WIDTH
    more = ('[output]\nstress_maxima = true\n[[subsurface.line]]\nbody = "rail"\nfrom = [0.0, 0.0, -0.5]\nto = [0.0, 0.0, -2.0]\n'
            "points = 4\n")
    depth = np.linspace(0.2, 1.5, 1301)
    exact = {"tresca": 0.6006, "von_mises": measures(closed_forms.mcewen(0.0, depth, 0.0, NU))["von_mises"].max(),
             "orthogonal_shear": 0.25, "xz_range": 0.5}
    for width in (1.0, CRANE_WIDTH):
        point = _crane(bench, f"{width:g}", f"normal_force = {force * width!r}", width, more=more)
        maxima = {(m["body"], m["measure"]): m for m in point.stress_maxima}
        for measure, value in exact.items():
            rows.append(closest([Row(f"crane wheel of {width:g} mm: largest {measure}", "p0", value, maxima[body, measure]["value"] / CRANE_PRESSURE,
                                     min(2e-3, point.error_estimate[f"max_{measure}_{body}"] / CRANE_PRESSURE), of=1.0, of_words="p0 (Norton)", by=body)
                                 for body in ("wheel", "rail")]))
        rows += [closest([Row(f"crane wheel of {width:g} mm: depth of the largest tresca", "a", 0.786,
                              abs(maxima[body, "tresca"]["place"][2]) / CRANE_AXIS, 0.02, of=1.0, of_words="a", by=body)
                          for body in ("wheel", "rail")]),
                 Row(f"crane wheel of {width:g} mm: largest difference of a component below the middle", "p0", 0.0,
                     np.abs(point.subsurface[0]["stress"] / CRANE_PRESSURE
                            - closed_forms.mcewen(0.0, np.arange(1, 5) / 2 / CRANE_AXIS, 0.0, NU)).max(), 2e-3, of=1.0, of_words="p0"),
                 at_most(f"crane wheel of {width:g} mm: largest tension", "p0",
                         max(maxima[body, "principal_1"]["value"] for body in ("wheel", "rail")) / CRANE_PRESSURE, 5e-3)]
        assert all(m["place"][1] == 0 for m in point.stress_maxima)
    middles = "".join(f'[[subsurface.point]]\nbody = "{body}"\nat = [0.0, 0.0, 0.0]\n' for body in ("wheel", "rail"))
    for reference in ("400.0", "inf"):
        point = _crane(bench, f"middle_{reference}", f"normal_force = {CRANE_FORCE}", reference=f"reference_distance = {reference}", more=middles)
        wheel, rail = (line["displacement"][0, 2] for line in point.subsurface)
        rows.append(Row(f"crane wheel: displacements of both middles, reference at {reference} mm", "mm", point["approach"], wheel - rail, 2e-4,
                        by="approach"))
    return rows


def line_load_rows(bench):
    """An approach or a largest pressure in place of the force gives Hertz's force."""
    rows = []
    for reference in ("", "reference_distance = inf"):
        name = "inf" if reference else "own"
        given = _crane(bench, f"force_{name}", f"normal_force = {CRANE_FORCE}", reference=reference)
        pressed = _crane(bench, f"approach_{name}", f"approach = {given['approach']!r}", reference=reference)
        rows.append(Row(f"line, reference {name}: force of the approach of a force", "N", CRANE_FORCE, pressed["normal_force"], 1e-5))
        assert "approach" not in pressed.error_estimate
    stated = _crane(bench, "pressure", f"max_pressure = {CRANE_PRESSURE}")
    return [*rows, Row("line: force of Norton's p0", "N", CRANE_FORCE, stated["normal_force"], 2e-4),
            Row("line: p0 that is given", "MPa", CRANE_PRESSURE, stated["max_pressure"], stated.bar("max_pressure") / CRANE_PRESSURE)]


def line_rows(bench):
    return [*_mcewen_rows(bench), *_antiplane_rows(bench), *_crane_rows(bench)]
