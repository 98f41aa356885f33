# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rolling step by step: from rest, under a force, and on from steady rolling."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import ADHESION

from .. import closed_forms, style
from ..chapter import Chapter, Cost, Row, closest, printed
from .rolling import ellipse

SLIDING = 0.55 * 50e3  # N, of case b
PATCH = 2 * closed_forms.hertz(1 / 810, 1 / 1000, 50e3, 210e3 / (2 * (1 - 0.3**2)))[0]  # mm, its length
_CASE_B = """[load]
normal_force = 50e3
[friction]
coefficient = {friction}
[wheel]
rolling_radius = 405.0
transverse_radius = inf
[rail]
transverse_radius = 500.0
[rolling]
{rolling}
[contact_grid]
elements_across = {across}
"""


def _rolled(bench, name, rolling, across=24, steps="", friction="0.55"):
    """Case b; `steps`: those of a transient."""
    text = _CASE_B.format(rolling=rolling + ('\nproblem = "transient"' if steps else ""), across=across, friction=friction)
    return bench.run_text(f"rolled_{name}", text + (f"[history]\n{steps}\n" if steps else ""), ["halfspace"])["halfspace"].points


def _apart(point, other):
    return np.hypot(*(point[key] - other[key] for key in ("longitudinal_force", "lateral_force")))


def _beyond(point):
    """Largest part of a traction beyond mu p, MPa."""
    fields = point.fields
    return (np.hypot(fields["traction_x"], fields["traction_y"]) - 0.55 * fields["pressure"]).max()


def _limit_rows(bench):
    """Steps of one element tend to the steady solution with the same difference everywhere, others to it within the grid's error."""
    rows, creepage = [], "longitudinal_creepage = 0.002\nlateral_creepage = 0.001\nleading_edge = \"plain\""
    for order in ("first", "second"):
        motion = f'{creepage}\nupwind_order = "{order}"'
        steady = _rolled(bench, f"steady_{order}", motion)[0]
        points = _rolled(bench, f"far_{order}", motion, steps=f"steps = 144\nstep_length = {PATCH / 24!r}")
        rows.append(Row(f"force after six patches in steps of an element, {order} order", "N", 0.0, _apart(points[-1], steady), 5e-5,
                        of=SLIDING, of_words="mu F_z", by="steady rolling"))
        rises = np.diff([0.0, *(-point["longitudinal_force"] for point in points[:60])])
        assert _apart(points[23], steady) > 0.02 * SLIDING and rises.min() >= -1e-4 * SLIDING
        assert abs(points[-1]["distance"] - 6 * points[23]["distance"]) < 1e-9
    for length in (0.5, 1.7):
        steps = f"steps = {round(24 * 5 / length)}\nstep_length = {length * PATCH / 24!r}"
        last = _rolled(bench, f"step_{length}", creepage, steps=steps)[-1]
        rows.append(closest([Row(f"force after five patches in steps of {length} elements", "N", steady[key], last[key], 0.008,
                                 of=SLIDING, of_words="mu F_z", by="steady rolling") for key in ("longitudinal_force", "lateral_force")]))
    return rows


def _forced_rows(bench):
    """Half of mu F_z from Cattaneo's shift to Carter's steady state: the creepage falls, rises until the first adhering particles
    leave, and settles."""
    forces = f"longitudinal_force = {-0.5 * SLIDING}"
    steady = _rolled(bench, "forced_steady", forces, 20)[0]["longitudinal_creepage"]
    points = _rolled(bench, "forced", forces, 20, f"steps = 100\nstep_length = {PATCH / 20!r}")
    xi = np.array([point["longitudinal_creepage"] for point in points])
    assert xi[0] > 3 * steady and (np.diff(xi[1:14]) > 0).all()
    return [closest([Row("under half of mu F_z: force of a step", "N", -0.5 * SLIDING, point["longitudinal_force"], 1e-4, of=SLIDING,
                         of_words="mu F_z") for point in points]),
            # At a quarter of element and step in either order; a second-order difference across the first step's jump gave -0.0126.
            Row("under half of mu F_z: creepage of the second step", "", 1.05e-3, xi[1], 0.06, by="quarter of element and step"),
            # The steady model is fitted to the leading edge, the steps are not.
            Row("under half of mu F_z: creepage after five patches", "", steady, xi[-1], 0.02, by="steady rolling"),
            Row("under half of mu F_z: the same, an element patch before", "", xi[80], xi[-1], 1e-3, by="after four")]


def _steady_start_rows(bench):
    """Steady rolling goes on where nothing changes, and a change acts as a long way after rest."""
    def on(name, order, rolling, steps, start="steady", friction="0.55"):
        motion = f'{rolling}\nleading_edge = "plain"\nupwind_order = "{order}"'
        length = f"step_length = {PATCH / 12!r}\n" if steps else ""
        return _rolled(bench, f"on_{name}_{order}", motion, 12, f'{length}steps = {steps}\nstart = "{start}"' if steps else "", friction)

    def farthest(words, points, other, allowed, by="steady rolling"):
        return closest([Row(f"{words}: force of a step", "N", 0.0, _apart(point, other), allowed, of=SLIDING, of_words="mu F_z", by=by)
                        for point in points])
    creepage, rows = "longitudinal_creepage = 0.002\nlateral_creepage = 0.001", []
    for order in ("first", "second"):
        points = on("as_before", order, creepage, 8)
        rows.append(farthest(f"steady start, {order} order", [*points, on("alone", order, creepage, 0)[0]], points[0], 5e-5))
        assert points[0]["distance"] == 0 and abs(points[7]["distance"] - 7 * PATCH / 12) < 1e-9
    changed, way = 8, 6 * 12
    halved = [0.001] * changed
    steady = on("halved", "first", f"longitudinal_creepage = {[0.002] + halved}\nlateral_creepage = 0.001", 1 + changed)
    rest = on("way", "first", f"longitudinal_creepage = {[0.002] * way + halved}\nlateral_creepage = 0.001", way + changed, "rest")
    fall = _apart(steady[0], steady[-1])
    assert fall > 0.05 * SLIDING
    rows.append(closest([Row(f"creepage halved: force of step {k}", "N", 0.0, _apart(steady[k], rest[way + k - 1]), 1e-3, of=fall,
                             of_words="the fall", by="a long way from rest") for k in range(1, changed + 1)]))
    forced = on("forced", "second", "longitudinal_force = -12e3", 4)
    rows.append(closest([Row("steady start under a force: creepage of a step", "", forced[0]["longitudinal_creepage"],
                             point["longitudinal_creepage"], 1e-3) for point in forced]))
    # Friction that remembers is followed with second order along the row, over a step with first.
    falls = '0.55\nlaw = "exponential"\nkinetic_coefficient = 0.25\nhalf_velocity = 60.0\nmemory_distance = 1e-2'
    falling = on("falling", "first", f"{creepage}\nspeed = 20e3", 5, friction=falls)
    assert -falling[0]["longitudinal_force"] < 0.8 * SLIDING
    return [*rows, farthest("steady start, friction that remembers", falling, falling[0], 0.01)]


def _long_step_rows(bench):
    """Bars hold the steady start that goes on over steps of any length, and the same way in short ones."""
    motion = "longitudinal_creepage = 0.0015\nlateral_creepage = 0.0007\nspin = 2e-4"

    def force(point):
        return point["longitudinal_force"], point.bar("longitudinal_force")
    steady, rest = [], []
    for part in (0.1, 0.25, 0.5, 1.0, 2.0, 20.0):
        (start, unsure), *others = map(force, _rolled(bench, f"long_{part}", motion, 16,
                                                      f'steps = 5\nstep_length = {part * PATCH!r}\nstart = "steady"'))
        for value, bar in others:
            steady.append(Row(f"steps of {part:g} patches go on: F_x in its bar", "N", start, value, 1.0, of=bar + unsure, of_words="the bar",
                              by="steady start"))
            assert bar < 3 * abs(value - start) + 0.03 * SLIDING
    for part in (0.125, 0.25, 0.5, 1.0, 3.0):
        pieces = round(16 * part)
        whole = _rolled(bench, f"whole_{part}", motion, 16, f"steps = 3\nstep_length = {part * PATCH!r}")
        divided = _rolled(bench, f"divided_{part}", motion, 16, f"steps = {3 * pieces}\nstep_length = {PATCH / 16!r}")
        rest += [Row(f"steps of {part:g} patches from rest: F_x in its bar", "N", divided[(k + 1) * pieces - 1]["longitudinal_force"],
                     value, 1.0, of=bar, of_words="the bar", by="short steps") for k, (value, bar) in enumerate(map(force, whole))]
    return [closest(steady), closest(rest)]


_BALL = """[load]
normal_force = 0.4705
[friction]
coefficient = 0.4013
[wheel]
young_modulus = 2.56
poisson_ratio = 0.28
[rail]
young_modulus = 2.56
poisson_ratio = 0.28
[undeformed_distance]
quadratic = [0.002963, 0.002963]
[rolling]
problem = "transient"
upwind_order = "first"
longitudinal_force = {force!r}
[history]
steps = 57
step_length = 0.25
[contact_grid]
cell_size = [0.25, 0.25]
extent = [8.5, 8.25]
middle = [0.125, 0.0]
"""


def _contact_rows(bench):
    """From Cattaneo to Carter as CONTACT prints it: its case 1 is the shift by the force, cases 2 to 57 roll on by an element each."""
    model = bench.run_text("cattaneo_to_carter", _BALL.format(force=-0.657 * 0.4013 * 0.4705), ["halfspace"])["halfspace"]
    first, second, last = model.points[0], model.points[1], model.points[56]
    adhering = [np.sum(point.fields["state"] == ADHESION) for point in (first, second, last)]
    assert model.contact_elements == 621 and adhering == [305, 422, 346], adhering
    motion = "lateral_creepage = -6.25e-4\nspin = 6.25e-4"
    steady = ellipse(bench, "22", (8.0, 4.0), 22, 1.1, motion).points[0]
    rolled = ellipse(bench, "22_steps", (8.0, 4.0), 22, 1.1, f'{motion}\nproblem = "transient"',
                   f"[history]\nsteps = 120\nstep_length = {17.6 / 22}\n").points[-1]
    return [Row("ellipse with spin, 120 steps of an element: F_y", "N", steady["lateral_force"], rolled["lateral_force"], 5e-5, of=24600.0,
                of_words="mu F_z", by="steady rolling"),
            Row("ellipse with spin, 120 steps of an element: M_z", "N mm", steady["spin_moment"], rolled["spin_moment"], 1e-4,
                by="steady rolling"), *(printed(f"CONTACT's ball: {words}", unit, reference, reached) for words, unit, reference, reached in (
        ("shift", "mm", 1.774e-2, 0.25 * first["longitudinal_creepage"]), ("creepage of the first step", "", 1.824e-3, second["longitudinal_creepage"]),
        ("creepage at the end", "", 3.101e-3, last["longitudinal_creepage"]), ("approach", "mm", 7.258e-2, first["approach"]),
        ("p0", "MPa", 1.834e-2, first["max_pressure"])))]


def transient(bench):
    """From rest to steady rolling"""
    result = bench.run("transient", "cases/cattaneo_to_carter.toml")
    model = result["halfspace"]
    steady = bench.run("transient_steady", "cases/thesis_b.toml", ["halfspace"],
                       {"contact_grid.elements_across": 24, "rolling.longitudinal_creepage": "[0.001]"})
    end = steady["halfspace"].points[0]["traction_coefficient"]
    distance = [p["distance"] for p in model.points]
    force = [p["traction_coefficient"] for p in model.points]
    rows = [Row("-F_x/F_z after 28.8 mm", "", end, force[-1], 0.008, of=0.55, of_words="mu"), *_limit_rows(bench),
            *_forced_rows(bench), *_steady_start_rows(bench), *_long_step_rows(bench), *_contact_rows(bench),
            Row("largest traction beyond its bound at any step", "MPa", 0.0, max(_beyond(p) for p in model.points), 1e-12,
                of=0.55 * model.points[0]["max_pressure"], of_words="mu p0")]
    figure, axis = plt.subplots(figsize=(4.6, 3.0))
    axis.axhline(end, color=style.GREY, linestyle=(0, (5, 3)), linewidth=1.2, label="steady rolling")
    axis.plot(distance, force, marker="o", markersize=3.5, color="#0072B2", label="in steps of 0.9 mm")
    axis.axvline(steady["halfspace"].points[0]["contact_length"], color=style.GREY, linewidth=0.8,
                 linestyle=(0, (1, 1.5)))
    axis.annotate("length of the patch", (steady["halfspace"].points[0]["contact_length"], 0.02), rotation=90,
                  ha="right", va="bottom", fontsize=8, color=style.GREY)
    axis.set_xlabel("distance rolled [mm]")
    axis.set_ylabel("$-F_x/F_z$")
    axis.set_ylim(bottom=0)
    axis.legend(loc="lower right")
    name = bench.save(figure, "transient")
    return Chapter(
        "transient", "From rest to steady rolling",
        "Case b rolled from rest at 0.1 % creepage in steps of a tenth of the patch, 24 elements across "
        "([case](../../cases/cattaneo_to_carter.toml)).",
        "the program's own steady solution on the same grid, which is an independent algorithm (no steps) on the same "
        "influence coefficients. With steps of one element and the same difference everywhere the two agree; those of the case "
        "are 1.8 elements long. CONTACT's example of the same way (user guide) on its elements with its first-order difference.",
        rows, figures=[(name, "Force against distance rolled")],
        cost=[Cost("32 steps", model.seconds["total"], model.unknowns)])
