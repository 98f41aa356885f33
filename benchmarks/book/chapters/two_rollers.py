# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rollers in place of rails: rows for the chapter of Hertz's ellipses."""
import numpy as np

from ..chapter import Row

_CASE = """[load]
{load}
[friction]
coefficient = {friction}
[wheel]
rolling_radius = {wheel[0]}
transverse_radius = {wheel[1]}
young_modulus = {modulus}
[rail]
rolling_radius = {rail[0]}
transverse_radius = {rail[1]}
young_modulus = {modulus}
[rolling]
{rolling}
[contact_grid]
elements_across = {across}
{more}
"""


def _solved(bench, name, wheel=(300.0, 200.0), rail=(500.0, 120.0), load="normal_force = 50e3", creepage=(0.0012, 0.0008, 2e-4), friction=0.55,
            modulus=210e3, across=24, more=""):
    rolling = "\n".join(f"{key} = {value}" for key, value in zip(("longitudinal_creepage", "lateral_creepage", "spin"), creepage))
    text = _CASE.format(load=load, friction=friction, wheel=wheel, rail=rail, modulus=modulus, across=across, more=more, rolling=rolling)
    return bench.run_text(f"rollers_{name}", text, ["halfspace"])["halfspace"].points[0]


def roller_rows(bench):
    """Two spheres, bodies exchanged, lengths scaled, and the relative radius of a line contact."""
    spheres = _solved(bench, "spheres", (50.0, 50.0), (50.0, 50.0), "approach = 4.0", (0.0, 0.0, 0.0), 0.0, 20e3, 60,
                      '[halfspace]\nsurface = "curved"')
    plain = _solved(bench, "plain")
    # Half a turn about x: slip changes its sign, y and z too. V is then the other surface's speed, a difference of second order.
    exchanged = _solved(bench, "exchanged", (500.0, 120.0), (300.0, 200.0), creepage=(-0.0012, 0.0008, 2e-4))
    scaled = _solved(bench, "scaled", (3000.0, 2000.0), (5000.0, 1200.0), "normal_force = 5e6", (0.0012, 0.0008, 2e-5))
    line = _CASE.format(load="normal_force = 180.0", friction=0.3, wheel=(300.0, "inf"), rail=(500.0, "inf"), modulus=210e3, across=40,
                        rolling="longitudinal_creepage = 0.0", more='[geometry]\nshape = "line"').replace("transverse_radius = inf\n", "")
    line = bench.run_text("rollers_line", line, ["halfspace"])["halfspace"].points[0]
    bound, modulus, radius = 0.55 * plain["normal_force"], 210e3 / (2 * (1 - 0.3**2)), 1 / (1 / 300 + 1 / 500)
    rows = [Row("two spheres, approach of 4 mm: F_z", "N", 583850.0, spheres["normal_force"], 1e-3, by="distance along the normal"),
            Row("two spheres: length over width", "", 1.0, spheres["contact_length"] / spheres["contact_width"], 1e-3),
            Row("rollers exchanged: p0", "MPa", plain["max_pressure"], exchanged["max_pressure"], 1e-6),
            Row("rollers exchanged: area of adhesion", "mm²", plain["adhesion_area"], exchanged["adhesion_area"], 2e-3,
                of=plain["contact_area"], of_words="the patch"),
            Row("rollers ten times as large: p0", "MPa", plain["max_pressure"], scaled["max_pressure"], 1e-9),
            Row("rollers ten times as large: length", "mm", 10 * plain["contact_length"], scaled["contact_length"], 1e-9),
            Row("rollers of 300 and 500 mm in line contact: p0", "MPa", np.sqrt(180.0 * modulus / (np.pi * radius)), line["max_pressure"], 5e-4)]
    for words, key, unit, sign, allowed in (("F_x", "longitudinal_force", "N", -1, 1e-4), ("F_y", "lateral_force", "N", 1, 1e-4),
                                            ("M_z", "spin_moment", "N mm", 1, 5e-4)):
        rows.append(Row(f"rollers exchanged: {words}", unit, sign * plain[key], exchanged[key], allowed, of=bound, of_words="mu F_z"))
        if key != "spin_moment":
            rows.append(Row(f"rollers ten times as large: {words}", unit, 100 * plain[key], scaled[key], 1e-6, of=scaled["normal_force"],
                            of_words="F_z"))
    return rows
