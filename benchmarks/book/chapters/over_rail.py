# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction that varies over the rail: rows for the chapter of falling friction."""
import numpy as np

from .. import closed_forms
from ..chapter import Row
from ..runs import RunFailed

LOAD, RAIL, WHEEL = 80e3, 300.0, 460.0
_CASE = """[load]
normal_force = {load!r}
[friction]
{friction}
[wheel]
rolling_radius = 460.0
profile = "arcs"
[wheel_profile]
radii = [{wheel}]
ends = [{end}, {end_}]
slope = {slope}
[rail]
profile = "arcs"
[rail_profile]
radii = {rail}
ends = {rail_ends}
symmetric = true
[track]
inclination = "none"
[wheelset]
flange_back_position = {back}
side = "{side}"
roll = 0.0
{place}
[rolling]
{rolling}
extra_slip = "none"
[halfspace]
surface = "{surface}"
[contact_grid]
elements_across = 24
"""
_PARTIAL = "longitudinal_creepage = 0.001\nlateral_creepage = {0}0.0005\nspin = {0}1e-4"


def _crowned(bench, name, friction, rolling, slope=0.0, side="left", surface="planar", place="", model="halfspace", **bodies):
    """A wheel of this slope, straight across, on a crowned rail; creepages as given, no other slip."""
    shape = {"load": LOAD, "wheel": "inf", "end": -60.0, "end_": 60.0, "rail": [RAIL, 20.0], "rail_ends": [22.0, 39.9], "back": -76.0}
    text = _CASE.format(friction=friction, rolling=rolling, slope=slope, side=side, surface=surface, place=place, **{**shape, **bodies})
    result = bench.run_text(f"over_rail_{name}", text, [model])
    return result if place else result[model]


def _refused(words, *case, **more):
    try:
        _crowned(*case, **more)
    except RunFailed as error:
        assert words in str(error), error
        return
    raise AssertionError(f"a case that should be refused: {words}")


def _sliding_rows(bench):
    """mu = 0.1 on the side of the gauge face, and rises by 10 per rad from the top to the field. With Hertz's pressure summed along x,
    1 - (y/b)^2, and an inclination of y/R the force is (0.1 + 10 (3 b/16)/R) F_n, and its moment 10 (b^2/10)/R F_n."""
    b = closed_forms.hertz(0.5 / WHEEL, 0.5 / RAIL, LOAD, 210e3 / (2 * (1 - 0.3**2)))[1]
    rows, full = [], "longitudinal_creepage = 0.05\nlateral_creepage = 0.0\nspin = 0.0"
    friction = "coefficient = [0.1, 0.1, 0.5]\ninclination = [-0.04, 0.0, 0.04]"
    for surface in ("planar", "curved"):
        for side, sign in (("left", 1), ("right", -1)):  # y points to the field on the left and to the middle on the right
            point = _crowned(bench, f"{surface}_{side}", friction, full, side=side, surface=surface).points[0]
            rows += [Row(f"mu over the rail, {side} wheel: sliding force", "N", -(0.1 + 10 * 3 * b / (16 * RAIL)) * LOAD,
                         point["longitudinal_force"], 1e-3, by=surface),
                     Row(f"mu over the rail, {side} wheel: its moment", "N mm", sign * b * b / RAIL * LOAD, point["spin_moment"], 5e-3,
                         by=surface)]
    # 90 % of the sliding force, of which the largest coefficient allows 2.5 times as much.
    sliding = _crowned(bench, "sliding", "coefficient = [0.1, 0.1, 0.5]\ninclination = [-0.04, 0.0, 0.04]", full).points[0]["longitudinal_force"]
    forced = f"longitudinal_force = {0.9 * sliding!r}\nlateral_creepage = 0.0\nspin = 0.0"
    rows.append(Row("mu over the rail: a force of 0.9 of sliding", "N", 0.9 * sliding,
                    _crowned(bench, "forced", friction, forced).points[0]["longitudinal_force"], 1e-5, of=LOAD, of_words="F_z"))
    _refused("mu F_z", bench, "beyond", friction, forced.replace(f"{0.9 * sliding!r}", f"{1.1 * sliding!r}"))
    for theory in ("fastsim", "strip", "linear", "vermeulen-johnson"):
        _refused("friction.inclination or lateral_position: it cannot handle friction that varies over the rail", bench, theory, friction,
                 full, model=theory)
    return rows


def _surface_rows(bench):
    """Circles of 50 and -60 mm: the grid lies along their mean, y = R sin(s/R), where the rail inclines by asin(y/50). With s in place
    of y mu is off by up to 3e-3."""
    model = _crowned(bench, "arc", "coefficient = [0.1, 5.1]\ninclination = [-0.5, 0.5]",
                     "longitudinal_creepage = 0.05\nlateral_creepage = 0.0\nspin = 0.0", surface="curved", load=400e3, wheel=-60.0,
                     end=-42.0, end_=42.0, rail=[50.0], rail_ends=[42.0], back=-72.1987)
    fields = model.points[0].fields
    column = fields["pressure"][:, len(model.x) // 2] > 0
    radius = 2 / (1 / 50 + 1 / 60)
    y = radius * np.sin(model.y[column] / radius)
    found = (fields["traction_bound"] / np.where(fields["pressure"] > 0, fields["pressure"], 1))[column, len(model.x) // 2]
    assert np.abs(model.y[column]).max() > 7
    return [Row("mu over a rail of 50 mm: largest difference along the arc", "", 0.0, np.abs(found - 2.6 - 5 * np.arcsin(y / 50)).max(), 5e-4,
                of=1.0, of_words="1")]


def _law_rows(bench):
    """Equal points are one law to the last bit, mirrored wheels have mirrored forces."""
    keys = ("longitudinal_force", "lateral_force", "spin_moment")
    fall = 'law = "exponential"\nkinetic_coefficient = {0}\nhalf_velocity = {1}\nmemory_distance = 5e-3'
    for name, one, points, more in (
            ("equal", "coefficient = 0.3", "coefficient = [0.3, 0.3, 0.3]\ninclination = [-0.05, -0.03, -0.01]", ""),
            ("falling", "coefficient = 0.3\n" + fall.format(0.15, 200.0), "coefficient = [0.3, 0.3]\ninclination = [-0.05, -0.01]\n"
             + fall.format([0.15, 0.15], [200.0, 200.0]), "\nspeed = 10e3")):
        same = [_crowned(bench, f"{name}_{k}", friction, _PARTIAL.format("") + more, -0.03).points[0]
                for k, friction in enumerate((one, points))]
        assert [same[0][key] for key in keys] == [same[1][key] for key in keys]
        assert np.array_equal(same[0].fields["traction_bound"], same[1].fields["traction_bound"])
    left, right = (_crowned(bench, f"mirror_{side}", "coefficient = [0.1, 0.2, 0.5]\ninclination = [-0.05, -0.03, -0.01]",
                            _PARTIAL.format(sign), -0.03, side).points[0] for side, sign in (("left", ""), ("right", "-")))
    return [Row(f"mu over the rail, right wheel: {key}", "N", sign * left[key], right[key], 1e-6, of=LOAD, of_words="F_z", by="the left one's")
            for key, sign in zip(keys, (1, -1, -1))]


def _track_rows(bench):
    """Linear between places along the track."""
    result = _crowned(bench, "track", "coefficient = [0.1, 0.5]\ntrack_position = [0.0, 1000.0]",
                      "longitudinal_creepage = 0.05\nlateral_creepage = 0.0\nspin = 0.0", place="track_position = [-5.0, 250.0, 2000.0]")
    return [Row(f"mu along the track, at {place:g} mm: sliding force", "N", -mu * LOAD, model.points[0]["longitudinal_force"], 1e-4)
            for model, place, mu in zip(result.models, (-5.0, 250.0, 2000.0), (0.1, 0.2, 0.5))]


_OVER_Y = """[load]
normal_force = 80e3
[friction]
coefficient = [0.1, 0.5]
lateral_position = [-10.0, 10.0]
[wheel]
rolling_radius = 460.0
transverse_radius = inf
[rail]
transverse_radius = 300.0
[rolling]
longitudinal_creepage = 0.05
[contact_grid]
elements_across = 24
"""


def over_rail_rows(bench):
    """mu = 0.3 + 0.02 y on an ellipse, which holds F_n b^2/5 as the second moment of its pressure, and over the inclination."""
    point = bench.run_text("over_y", _OVER_Y, ["halfspace"])["halfspace"].points[0]
    b = closed_forms.hertz(0.5 / WHEEL, 0.5 / RAIL, LOAD, 210e3 / (2 * (1 - 0.3**2)))[1]
    return [Row("mu over y: sliding force", "N", -0.3 * LOAD, point["longitudinal_force"], 0.005),
            Row("mu over y: its moment", "N mm", 0.02 * LOAD * b * b / 5, point["spin_moment"], 0.01),
            *_sliding_rows(bench), *_surface_rows(bench), *_law_rows(bench), *_track_rows(bench)]
