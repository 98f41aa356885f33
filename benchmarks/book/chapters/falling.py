# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction that falls with the slip velocity, its memory, and an elastic layer between the bodies."""
import numpy as np
from matplotlib import pyplot as plt
from rollfem.point import ADHESION

from .. import closed_forms, published
from ..chapter import Chapter, Cost, Row, closest, printed
from .over_rail import over_rail_rows

FORCE, MODULUS, SPEED = 106.7e3, published.CONTACT_MODULUS, 10e3  # N, E* in MPa, mm/s
_CASE = """[load]
normal_force = {force!r}
[friction]
coefficient = {mu!r}
{fall}
""" + published.CONTACT_BODIES + """[undeformed_distance]
quadratic = {quadratic}
[rolling]
speed = {speed!r}
longitudinal_creepage = {creepages}
{rolling}
[contact_grid]
{grid}
{more}
"""
_LAYER = "[layer]\nthickness = 1.25\nshear_modulus = 8200.0"


def _patch():
    """(A, B, a, b) of the ellipse with A = 8e-4 1/mm and a/b = 1/2."""
    first, second = closed_forms.elliptic_integrals(0.75)
    quadratic = 8e-4, 8e-4 * (first - second) / (4 * second - first)
    return (*quadratic, *closed_forms.hertz(*quadratic, FORCE, MODULUS)[:2])


def _fall(kinetic=0.14, half_velocity=1250.0, memory=3e-3):
    return (f'law = "exponential"\nkinetic_coefficient = {kinetic}\nhalf_velocity = {half_velocity}\nmemory_distance = {memory}'
            + ("\nmemory_velocity = 1.0" if memory else ""))


def _sliding(creepage, half_velocity=1250.0):
    """Friction of full sliding by the law."""
    return 0.14 + 0.19 * 2 ** (-SPEED * creepage / half_velocity)


def _run(bench, name, creepages, across=None, fall="", rolling="", more="", model="halfspace", mu=0.33):
    """The model on CONTACT's elements, or on this many across."""
    x, y, a, _ = _patch()
    grid = (f"elements_across = {across}" if across else
            f"extent = [{2.2 * a}, {4.4 * a}]\ncell_size = [{2.2 * a / 48}, {4.4 * a / 44}]")
    text = _CASE.format(force=FORCE, mu=mu, fall=fall, quadratic=[float(x), float(y)], speed=SPEED, creepages=list(creepages),
                        rolling=rolling, grid=grid, more=more)
    return bench.run_text(f"falling_{name}", text, [model])[model]


def _forces(model):
    return np.array([-point["longitudinal_force"] for point in model.points])


def _farthest(words, curve, reached, allowed, by, **scale):
    xi = max(curve, key=lambda at: abs(reached[at] - curve[at]) / (1 if scale else curve[at]))
    return Row(f"{words}: farthest, at {100 * xi:g} %", "", curve[xi], reached[xi], allowed, by=by, **scale)


def _coulomb_rows(bench):
    """CONTACT's curve without fall or layer, digit by digit."""
    curve = published.CONTACT_LOCOMOTIVE_COULOMB
    points = _run(bench, "digits", curve, rolling='upwind_order = "first"').points
    adhering = [np.sum(point.fields["state"] == ADHESION) for point in points]
    assert adhering == [elements for _, elements in curve.values()], adhering
    forces = [printed(f"F_x/(mu F_z) without fall or layer, at {100 * xi:g} %", "", force, point["longitudinal_force"] / (0.33 * FORCE))
              for point, (xi, (force, _)) in zip(points, curve.items())]
    return [closest(forces), closest([printed("p0", "MPa", 640.7, point["max_pressure"]) for point in points])]


def _law_rows(bench):
    """Full sliding, nothing that falls, order, steps."""
    rows = []
    free = _run(bench, "sliding", [0.1, 0.25], fall=_fall(memory=0.0))
    for point, force in zip(free.points, _forces(free)):
        xi = point["longitudinal_creepage"]
        rows += [Row(f"-F_x/F_z in full sliding, xi = {100 * xi:g} %", "", _sliding(xi), force / FORCE, 5e-3, by="law"),
                 Row(f"area of adhesion in full sliding, xi = {100 * xi:g} %", "mm²", 0.0, point["adhesion_area"], 1e-9, of=1.0,
                     of_words="1 mm²")]
    plain = _forces(_run(bench, "coulomb", [0.002, 0.004]))
    same = _forces(_run(bench, "none", [0.002, 0.004], fall=_fall(kinetic=0.33)))
    rows += [Row(f"F_x with nothing to fall, xi = {xi} %", "N", *pair, 1e-6, by="Coulomb") for xi, pair in zip((0.2, 0.4), zip(plain, same))]
    by_grid = [_forces(_run(bench, f"memory_{n}", [0.008], n, _fall(half_velocity=60.0)))[0] for n in (12, 24, 48, 96)]
    order = np.log2((by_grid[1] - by_grid[0]) / (by_grid[2] - by_grid[1]))
    rows += [Row("memory within the slip area: order of the force, 12 to 48 across, up to 2", "", 2.0, min(order, 2.0), 0.25),
             Row("memory within the slip area: force at 48 across", "N", by_grid[3], by_grid[2], 1e-3, by="96 across")]
    steady = _forces(_run(bench, "steady", [0.008], 24, _fall(), more=_LAYER))[0]
    rolled = _forces(_run(bench, "steps", [0.008], 24, _fall(), 'problem = "transient"',
                          "[history]\nsteps = 40\nstep_length = 0.5\n" + _LAYER))[-1]
    return [*rows, Row("force after 20 mm of steps from rest", "N", steady, rolled, 0.01, by="steady rolling")]


_ROLLERS = """[load]
normal_force = 622216.0
[friction]
coefficient = 0.3
law = "exponential"
kinetic_coefficient = 0.18
half_velocity = 100.0
branch = "sliding"
""" + published.CONTACT_BODIES + """[geometry]
shape = "line"
width = 200.0
relative_radius = 460.0
reference_distance = 200.0
[rolling]
problem = "transient"
speed = 45e3
upwind_order = "first"
longitudinal_creepage = {creepages}
[history]
start = "steady"
step_length = 0.1
[contact_grid]
cell_size = [0.1, 200.0]
extent = [9.2, 200.0]
middle = [-0.05, 0.0]
"""


def _roller_rows(bench):
    """Rollers of several states that fast sliding slows down to, step by step, as CONTACT prints F_x/(mu F_z); endless rollers in place
    of elements of 200 mm make 0.13 % here."""
    printed_forces = published.CONTACT_ROLLERS_SLIDING
    points = bench.run_text("falling_rollers", _ROLLERS.format(creepages=[-0.0009999] + [-0.001] * (len(printed_forces) - 1)),
                            ["halfspace"])["halfspace"].points
    assert len(points) == len(printed_forces)
    return [closest([Row(f"rollers of several states, step {k}: F_x/(mu F_z)", "", value, point["longitudinal_force"] / (0.3 * 622216.0),
                         3e-3, of=1.0, of_words="1", by="CONTACT") for k, (value, point) in enumerate(zip(printed_forces, points))])]


def _layer_rows(bench):
    """A layer much softer than the bodies is Winkler's; both are in series."""
    rows = []
    for across, allowed in ((40, 0.02), (160, 3e-3)):
        point = _run(bench, f"winkler_{across}", [1e-6], across, more="[layer]\nthickness = 1000.0\nshear_modulus = 8.2").points[0]
        exact = 8 / 3 * point["semi_axis_x"] ** 2 * point["semi_axis_y"] * 1e-6 * 8.2 / 1000
        rows.append(Row("soft layer: force of its springs alone", "N", exact, -point["longitudinal_force"],
                        min(allowed, point.bar("longitudinal_force") / exact), by=f"{across} across"))
    order = 'upwind_order = "first"'
    without, with_layer = (_forces(_run(bench, f"slope_{k}", [1e-5], rolling=order, more=more))[0] for k, more in enumerate(("", _LAYER)))
    printed = published.CONTACT_LOCOMOTIVE_SLOPE
    return [*rows, Row("F_x at xi = 1e-5 without a layer", "N", printed[0], without, 1.2e-3, by="CONTACT"),
            Row("F_x at xi = 1e-5 with a layer", "N", printed[1], with_layer, 1.5e-3, by="CONTACT"),
            Row("F_x at xi = 1e-5 with a layer", "N", 1 / (1 / 247.0 + 1 / 87.6), with_layer, 0.03, by="bodies and layer in series")]


def _fastsim_rows(bench):
    """FASTSIM with layer, memory and the reduced slope."""
    a, b = _patch()[2:]
    bodies = _forces(_run(bench, "linear", [1e-5], model="linear"))[0]
    layer = 8 / 3 * a**2 * b * 1e-5 * 8200 / 1.25
    rows = [Row("F_x at xi = 1e-5 with a layer", "N", 1 / (1 / bodies + 1 / layer),
                _forces(_run(bench, "fastsim_slope", [1e-5], more=_LAYER, model="fastsim"))[0], 1e-3, by="FASTSIM, brushes in series")]
    sliding = (0.05, 0.1, 0.25)
    rows += [Row(f"-F_x/F_z in full sliding, xi = {100 * xi:g} %", "", _sliding(xi), force / FORCE, 0.01, by="FASTSIM, with a layer")
             for xi, force in zip(sliding, _forces(_run(bench, "fastsim_sliding", sliding, fall=_fall(), more=_LAYER, model="fastsim")))]
    # Where all slides friction falls along the row: mu_s + (mu - mu_s) exp(-xi d/d_c), d behind the leading edge.
    u = np.linspace(-0.995, 0.995, 200)[None, :]
    row = np.sqrt(1 - u.T**2)
    there, pressure = _sliding(0.1, 500.0), row**2 * np.sqrt(1 - u**2)
    exact = np.sum(pressure * (there + (0.33 - there) * np.exp(-0.1 * a * row * (1 - u) / 0.5))) / np.sum(pressure)
    assert exact > 1.2 * there
    for model in ("fastsim", "halfspace"):
        found = _forces(_run(bench, f"remembers_{model}", [0.1], fall=_fall(half_velocity=500.0, memory=0.5),
                             more='[fastsim]\nbound = "elliptic"', model=model))[0] / FORCE
        rows.append(Row("-F_x/F_z remembered along every row, xi = 10 %", "", exact, found, 0.01, by=model))
    curve = published.CONTACT_LOCOMOTIVE_FASTSIM
    more = '[fastsim]\nelements = "grid"\nstrips = 40\nstrip_elements = 44\nslope_reduction = [0.54, 0.02, 0.62]'
    reduced = _forces(_run(bench, "reduced", curve, fall=_fall(0.1368, 990.0), more=more, model="fastsim", mu=0.36))
    reached = dict(zip(curve, reduced / (0.36 * FORCE)))
    by = "FASTSIM, reduced slope, against CONTACT's"
    return [*rows, _farthest("-F_x/(mu F_z)", curve, reached, 0.003, by, of=1.0, of_words="1"),
            Row("-F_x/(mu F_z) at xi = 1e-5", "", curve[1e-5], reached[1e-5], 0.01, by=by)]


def falling_friction(bench):
    """Falling friction: the traction curve of a locomotive"""
    curve = published.CONTACT_LOCOMOTIVE
    model = _run(bench, "curve", curve, fall=_fall(), rolling='upwind_order = "first"', more=_LAYER)
    reached = dict(zip(curve, _forces(model) / (0.33 * FORCE)))
    figure, axis = plt.subplots(figsize=(4.8, 3.3))
    axis.plot([100 * xi for xi in curve], list(curve.values()), linestyle="none", marker="o", markersize=7, markerfacecolor="none",
              color="black", label="CONTACT")
    axis.plot([100 * xi for xi in reached], list(reached.values()), color="#0072B2", label="half-space")
    axis.set_xlabel(r"$\xi$ [%]")
    axis.set_ylabel(r"$-F_x/(\mu F_z)$")
    axis.legend()
    return Chapter(
        "falling-friction", "Falling friction: the traction curve of a locomotive",
        "An ellipse of A = 8e-4 1/mm, a/b = 1/2, under 106.7 kN at 10 m/s; mu falls from 0.33 to 0.14, by half over 1.25 m/s, over a "
        "sliding distance of 3 µm; a layer of 1.25 mm with G = 8200 MPa.",
        "CONTACT's printed curve (user guide, section 5.9) on its elements with its first-order difference; the law itself in full "
        "sliding; closed forms of layers much softer than the bodies; CONTACT's modified FASTSIM (flexibilities of Kalker's printed "
        "table) for the reduced slope.",
        [_farthest("-F_x/(mu F_z) with layer and memory", curve, reached, 3e-3, "half-space, against CONTACT"),
         *_coulomb_rows(bench), *_law_rows(bench), *_roller_rows(bench), *_layer_rows(bench), *_fastsim_rows(bench), *over_rail_rows(bench)],
        figures=[(bench.save(figure, "falling_friction"), "Traction curve with layer and memory")],
        cost=[Cost("the curve of 30 load points", model.seconds["total"], model.unknowns)],
        tests=["verification.FallingFriction.OfCurvedBodiesHoldsTheLawAtEveryElement", "unit.FrictionState.MemoryIsOfSecondOrderAlongTheRow"])
