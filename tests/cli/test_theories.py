# SPDX-License-Identifier: LGPL-2.1-or-later
"""Theories as models: options of the case, given pressures, what all have in common, the stress maxima of the half-space; FaStrip
and Polach's formula against Kalker's forces, Carter's line contact and half-spaces solved by CONTACT."""

import math

import numpy as np
import pytest
from program import SMALL, package, rolling, solved

THEORIES = "linear vermeulen-johnson polach carter fastsim fastrip strip".split()
CURVE = SMALL | rolling([0.001, 0.002], 20)
FULL = 0.3 * 82e3  # friction of `ellipse`


def ellipse(model, a, b, strips=200, **creepage):
    """The first point under Hertz's pressure of 82 kN on an ellipse; mu = 0.3, G = 82 000 MPa."""
    steel = {f"{body}.{name}": value for body in ("wheel", "rail") for name, value in
             (("young_modulus", 209920.0), ("poisson_ratio", 0.28))}
    return solved({"load.normal_force": 82e3, "friction.coefficient": 0.3, "given_pressure.semi_axis_x": a,
                   "given_pressure.semi_axis_y": b, "contact_grid.elements_across": 40, "fastsim.strips": strips,
                   "fastsim.strip_elements": 2 * strips} | steel | {f"rolling.{name}": value for name, value in creepage.items()},
                  model=model).points[0]


def forces(point):
    return np.array([point.longitudinal_force, point.lateral_force])


@pytest.mark.parametrize("a, b", [(8.0, 4.0), (5.0, 5.0), (3.0, 9.0)])
@pytest.mark.parametrize("creepage", [
    {"longitudinal_creepage": 1e-7}, {"lateral_creepage": 1e-7}, {"spin": 1e-8},
    {"longitudinal_creepage": 1e-7, "lateral_creepage": -2e-7, "spin": 1e-8}])
def test_small_creepages_of_fastrip_have_kalkers_forces(a, b, creepage):
    linear = forces(ellipse("linear", a, b, **creepage))
    assert forces(ellipse("fastrip", a, b, **creepage)) == pytest.approx(linear, abs=1e-3 * np.hypot(*linear))


def test_large_creepages_of_fastrip_slide_under_the_whole_bound():
    point = ellipse("fastrip", 8.0, 4.0, longitudinal_creepage=0.03, lateral_creepage=0.04)
    assert forces(point) / FULL == pytest.approx([-0.6, -0.8], abs=0.005) and point.adhesion_area == 0.0


@pytest.mark.parametrize("xi", [1e-4, 3e-4, 6e-4])
def test_a_very_wide_patch_of_fastrip_is_carters(xi):
    """A patch a hundred times as wide as long is Carter's line contact strip by strip."""
    strip, carter = (ellipse(model, 1.0, 100.0, longitudinal_creepage=xi) for model in ("fastrip", "carter"))
    assert strip.longitudinal_force == pytest.approx(carter.longitudinal_force, abs=0.01 * FULL)
    assert strip.adhesion_area == pytest.approx(carter.adhesion_area, abs=0.02 * carter.contact_area)


def test_fastrip_is_nearer_to_the_half_space_under_spin_than_fastsim():
    """CONTACT's example fastsim, cases 1 (half-space) and 7 (its FaStrip, which changes flexibilities with the creepages):
    lateral creepage against spin."""
    against = {"lateral_creepage": -0.000625, "spin": 0.000625}
    strip, brush = (ellipse(model, 8.0, 4.0, **against) for model in ("fastrip", "fastsim"))
    assert abs(strip.lateral_force) / FULL == pytest.approx(0.6074, abs=0.01)
    assert abs(strip.lateral_force) / FULL == pytest.approx(0.6442, abs=0.04)
    assert abs(strip.spin_moment) == pytest.approx(4.821e4, rel=0.02)
    assert abs(abs(brush.lateral_force) / FULL - 0.6074) > 0.02


def test_combined_creepage_and_spin_of_fastrip():
    """Benchmark 9 on a circle, extrapolated from CONTACT."""
    point = ellipse("fastrip", 6.0, 6.0, longitudinal_creepage=-1e-3, lateral_creepage=5e-4, spin=1e-4)
    assert forces(point) == pytest.approx([10240.0, -7060.0], abs=0.03 * FULL)


def test_spin_against_lateral_creepage_of_fastrip_stays_within_friction():
    """Where |P| >= 1 the leading edge slips under spin alone. Half-space of 80 kN on a circle of 5 mm: 0.14120 +- 0.00018."""
    circle = solved({"load.normal_force": 80e3, "friction.coefficient": 0.3, "given_pressure.semi_axis_x": 5.0,
                     "given_pressure.semi_axis_y": 5.0, "rolling.lateral_creepage": -0.001, "rolling.spin": 0.002}, model="fastrip")
    assert abs(circle.points[0].lateral_force) / 80e3 == pytest.approx(0.1412, abs=0.05 * 0.3)
    for a, b in (3.0, 9.0), (5.0, 5.0), (9.0, 4.0):
        for xi in 0.0, 1e-3, 1e-2:
            for eta in -3e-3, -1e-3, 1e-3:
                for spin in -3e-3, 1e-3, 2e-3, 3e-3:
                    point = ellipse("fastrip", a, b, 40, longitudinal_creepage=xi, lateral_creepage=eta, spin=spin)
                    over = np.hypot(point.traction_x, point.traction_y) - point.fields["traction_bound"]
                    assert over.max() <= 1e-9 * point.max_pressure and np.hypot(*forces(point)) < FULL, (a, b, xi, eta, spin)


@pytest.mark.parametrize("model", ["fastsim", "fastrip", "strip"])
def test_theories_of_strips_find_the_creepage_of_a_force(model):
    given = ellipse(model, 5.0, 4.0, longitudinal_creepage=0.002, lateral_creepage=-0.001, spin=1e-4)
    for other in {"lateral_force": given.lateral_force}, {"lateral_creepage": -0.001}:
        found = ellipse(model, 5.0, 4.0, spin=1e-4, longitudinal_force=given.longitudinal_force, **other)
        assert found.longitudinal_force == pytest.approx(given.longitudinal_force, abs=1e-5 * FULL)
        assert [found.longitudinal_creepage, found.lateral_creepage] == pytest.approx([0.002, -0.001], abs=2e-7)
    with pytest.raises(package().InputError):
        ellipse(model, 5.0, 4.0, longitudinal_force=25e3)


# Polach.
def polach(creepages, more=None, model="polach"):
    """The point of the thesis's case a with creepage, lateral creepage and spin."""
    keys = dict(zip(("rolling.longitudinal_creepage", "rolling.lateral_creepage", "rolling.spin"), creepages))
    return solved(SMALL | keys | (more or {}), model=model).points[0]


@pytest.mark.parametrize("creepages", [(1e-8, 0.0, 0.0), (0.0, -1e-8, 0.0)])
def test_small_creepages_of_polach_have_kalkers_forces(creepages):
    linear = forces(polach(creepages, model="linear"))
    assert forces(polach(creepages)) == pytest.approx(linear, abs=1e-4)
    reduced = polach(creepages, {"polach.adhesion_reduction": 0.6, "polach.slip_reduction": 0.2})
    assert forces(reduced) == pytest.approx(0.4 * linear, abs=1e-4)


def test_the_force_of_polach_is_against_the_creepage():
    for size in 1e-4, 0.02:
        point = polach((size, size, 0.0))
        assert point.longitudinal_force == pytest.approx(point.lateral_force, rel=1e-12)


def test_small_spin_of_polach_has_kalkers_lateral_force():
    point = polach((0.0, 0.0, 1e-9))
    assert point.lateral_force == pytest.approx(polach((0.0, 0.0, 1e-9), model="linear").lateral_force, rel=1e-4)
    assert point.longitudinal_force == 0.0


@pytest.mark.parametrize("x, y, spin", [(1e-3, 5e-4, 2e-4), (1e-3, -2e-3, 2e-4), (0.0, 1e-3, -3e-4), (2e-3, 0.0, 1e-3)])
def test_spin_of_polach_is_that_of_the_paper(x, y, spin):
    """Polach (1999) written out, with K_M and the modified creepage s_yC."""
    hertz = polach((0.0, 0.0, 0.0), model="hertz")
    a, b, bound = hertz.semi_axis_x, hertz.semi_axis_y, 0.55 * 50e3
    lateral = y + spin * a if abs(y + spin * a) > abs(y) else y
    rigid, modified = math.hypot(x, y), math.hypot(x, lateral)
    eps = math.pi / 4 * np.hypot(*forces(polach((x, y, 0.0), model="linear"))) * modified / rigid / bound
    force = 2 / math.pi * bound * (eps / (1 + eps * eps) + math.atan(eps))
    # (ab)^(3/2) G C23 from the linear theory's force by spin.
    by_spin = abs(polach((0.0, 0.0, 1e-9), model="linear").lateral_force) / 1e-9
    scale = 1 + 6.3 * (1 - math.exp(-a / b))
    of_spin = 8 / 3 * by_spin / a * abs(lateral) / (bound * scale)
    delta = (of_spin**2 - 1) / (of_spin**2 + 1)
    k = of_spin * (delta**3 / 3 - delta**2 / 2 + 1 / 6) - (1 - delta**2) ** 1.5 / 3
    more = 9 / 16 * a * bound * k * scale * spin / modified
    point = polach((x, y, spin))
    assert point.longitudinal_force == pytest.approx(-force * x / modified, abs=1e-6 * bound)
    assert point.lateral_force == pytest.approx(-force * y / modified + more, abs=1e-4 * bound)
    assert point.spin_moment == 0.0


def test_large_creepages_of_polach_slide_under_the_friction_that_is_left():
    sliding = np.hypot(*forces(polach((0.3, 0.4, 0.0), {"rolling.speed": 10e3})))
    assert sliding == pytest.approx(0.55 * 50e3, rel=1e-3)
    # Polach's A = 0.4 and B = 0.1 s/m at 5 m/s.
    falling = {"rolling.speed": 10e3, "friction.law": "exponential", "friction.polach_a": 0.4, "friction.polach_b": 0.1}
    assert np.hypot(*forces(polach((0.3, 0.4, 0.0), falling))) / sliding == pytest.approx(0.6 * math.exp(-0.5) + 0.4, abs=1e-3)


# FASTSIM.
CREEPAGES = "longitudinal_creepage", "lateral_creepage", "spin"


def creeping(model, radius, *creepages, across=40, **more):
    """Load points of the thesis's wheel on a rail of this radius, with creepages, lateral creepages and spins."""
    given = {f"rolling.{name}": list(values) for name, values in zip(CREEPAGES, zip(*creepages)) if any(values)}
    return solved(SMALL | {"rail.transverse_radius": radius, "contact_grid.elements_across": across} | given
                  | {f"{model}.{name}": value for name, value in more.items()}, model=model)


def fine(count):
    return {"strips": count, "strip_elements": count}


@pytest.mark.parametrize("bound, creepage, quantity, least", [
    ("parabolic", (1e-3, 0, 0), "longitudinal_force", 1.8), ("elliptic", (1e-3, 0, 0), "longitudinal_force", 1.2),
    ("parabolic", (0, 0, 5e-4), "lateral_force", 0.85)])
def test_order_of_convergence_of_fastsim(bound, creepage, quantity, least):
    """Over two doublings: the edge of the slip area moves by whole elements and makes single ones uneven."""
    coarse, finer, exact = (creeping("fastsim", 500.0, creepage, bound=bound, **fine(n)).points[0][quantity] for n in (50, 200, 1600))
    assert math.log2(abs(coarse - exact) / abs(finer - exact)) / 2 > least


def test_one_flexibility_of_fastsim_is_the_same_for_one_creepage():
    alone = (1e-3, 0, 0), (0, 1e-3, 0), (0, 0, 2e-4), (1e-3, 1e-3, 0)
    three, one = (np.array([forces(point) for point in creeping("fastsim", 500.0, *alone, flexibilities=count).points])
                  for count in ("three", "one"))
    assert one[:3] == pytest.approx(three[:3], abs=1e-6) and abs(one[3, 1] - three[3, 1]) > 1.0


def test_fastsim_is_mirrored_with_the_scene():
    here, there = creeping("fastsim", 500.0, (1e-3, 5e-4, 1e-4), (1e-3, -5e-4, -1e-4)).points
    assert forces(there) == pytest.approx(forces(here) * [1, -1], rel=1e-8)
    assert there.spin_moment == pytest.approx(-here.spin_moment, rel=1e-7)


def test_bars_of_fastsim_cover_the_error_of_resolution():
    creepages = (1e-3, 0, 0), (1e-3, 5e-4, 1e-4), (0, 0, 5e-4)
    for point, exact in zip(creeping("fastsim", 500.0, *creepages).points, creeping("fastsim", 500.0, *creepages, **fine(1600)).points):
        for name in "longitudinal_force", "lateral_force":
            assert abs(exact[name]) < 1.0 or abs(point[name] - exact[name]) < 1.5 * point.error_estimate[name]


@pytest.mark.parametrize("radius", [0.5, 3e5])
@pytest.mark.parametrize("friction", [1e-4, 500.0])
@pytest.mark.parametrize("force", [1.0, 1e7])
def test_fastsim_holds_from_narrow_to_wide_patches_and_from_little_to_much_friction(radius, friction, force):
    keys = SMALL | {"rail.transverse_radius": radius, "friction.coefficient": friction, "load.normal_force": force,
                    "rolling.longitudinal_creepage": [1e-12, 1.0], "rolling.lateral_creepage": [2e-12, 0.0]}
    small, large = solved(keys, model="fastsim").points
    assert abs(math.log(small.semi_axis_x / small.semi_axis_y)) > math.log(50)
    assert forces(small) == pytest.approx(forces(solved(keys, model="linear").points[0]), rel=1e-3)
    if friction < 1:  # the largest creepage of a case is not full sliding under much friction
        assert -large.longitudinal_force / (friction * force) == pytest.approx(1.0, abs=1e-4)


# Strips.
@pytest.mark.parametrize("radius", [300.0, 80.0, 30.0, 13.0])
@pytest.mark.parametrize("load", [{"load.approach": 0.0181818}, {"load.normal_force": 5e3}])
def test_virtual_penetration_of_radii_needs_no_profiles(radius, load):
    """Radii: an ellipse of Hertz's ratio as wide as the undeformed overlap, whose pressure gives the approach at its middle; on
    patches up to six times as long as wide too."""
    bodies = {"friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.transverse_radius": math.inf,
              "rail.transverse_radius": radius}
    result = solved(bodies | load | {"strip.virtual_penetration": 0.55}, model="strip")
    point, unit = result.points[0], solved(bodies | {"load.normal_force": 1.0}, model="hertz").points[0]
    b = math.sqrt(0.55 * point.approach * 2.0 * radius)
    scale = b / unit.semi_axis_y
    pressure = unit.max_pressure * point.approach / (unit.approach * scale)
    assert point.semi_axis_y == pytest.approx(b, rel=2e-3)
    assert point.semi_axis_x == pytest.approx(scale * unit.semi_axis_x, rel=1e-2)
    assert point.max_pressure == pytest.approx(pressure, rel=1e-2)
    assert point.normal_force == pytest.approx(2 / 3 * math.pi * point.semi_axis_x * point.semi_axis_y * pressure, rel=1e-2)
    assert result.x.size * result.dx > point.contact_length and result.y.size * result.dy > point.contact_width


def test_strips_on_an_ellipse_are_vermeulen_johnson():
    """A strip with a parabola of force mu P(y) slips over the same share of every strip, and the sum is 1 - (1 - tau/3)^3:
    Vermeulen and Johnson's law, for any creepage without spin."""
    creepages = (1e-4, 0, 0), (1e-3, 0, 0), (0, 3e-3, 0), (0.02, 0, 0)
    strip, closed = (creeping(model, 2000.0, *creepages).points for model in ("strip", "vermeulen-johnson"))
    for here, there in zip(strip, closed):
        assert forces(here) == pytest.approx(forces(there), abs=3e-4 * 27500)
    assert strip[3].max_traction == pytest.approx(3 * math.pi / 8 * 0.55 * strip[3].max_pressure, rel=1e-3)


def test_strips_run_for_a_given_approach():
    approach = SMALL | {"load.normal_force": None, "load.approach": 0.0473108}
    assert solved(approach, model="strip").points[0].normal_force == pytest.approx(50e3, abs=50.0)


# Shen, Hedrick and Elkins.
@pytest.mark.parametrize("creepage", [(1e-3, 5e-4, 1e-4), (0, 0, 3e-4)])
def test_vermeulen_johnson_is_the_cubic_of_the_linear_force_with_spin(creepage):
    linear, cubic = (forces(creeping(model, 500.0, creepage).points[0]) for model in ("linear", "vermeulen-johnson"))
    size = np.hypot(*linear)
    tau = size / 27500
    assert tau < 3
    force = 27500 * (tau - tau**2 / 3 + tau**3 / 27)
    assert cubic == pytest.approx(force * linear / size, abs=1e-6 * force)


# All of them.
@pytest.mark.parametrize("model, bound", [(name, None) for name in THEORIES if name != "polach"] + [("fastsim", "elliptic")])
def test_forces_are_the_sums_of_tractions(model, bound):
    creepages = [(0, 0, 0), (1e-3, 5e-4, 1e-4), (0.05, 0, 0)]
    if model == "carter":
        creepages[1] = (1e-3, 0, 0)
    if model == "vermeulen-johnson":
        creepages[1] = (1e-3, 5e-4, 0)
    if model == "linear":
        creepages = [(1e-4, 0, 0), (0, 1e-4, 0), (0, 0, 1e-5)]
    result = creeping(model, 100.0, *creepages, across=120, **({"bound": bound} if bound else {}))
    area = result.dx * result.dy
    for point in result.points:
        size = np.hypot(*forces(point)) if model == "linear" else 27500
        assert area * point.traction_x.sum() == pytest.approx(point.longitudinal_force, abs=2e-3 * size)
        assert area * point.traction_y.sum() == pytest.approx(point.lateral_force, abs=2e-3 * size)
        assert area * point.pressure.sum() == pytest.approx(50e3, rel=1e-3)
        if model == "vermeulen-johnson":
            moment = area * (result.x * point.traction_y - result.y[:, None] * point.traction_x).sum()
            assert moment == pytest.approx(point.spin_moment, abs=2e-3 * size * point.semi_axis_x)
    first, last = result.points[0], result.points[-1]
    if model == "linear":
        assert first.traction_coefficient > 0
    else:
        assert first.longitudinal_force == 0.0 and all(point.adhesion_area <= (1 + 1e-12) * point.contact_area for point in result.points)
        assert last.traction_coefficient == pytest.approx(0.55, abs=1e-3)
    if model == "carter":
        assert first.adhesion_area == pytest.approx(first.contact_area, rel=1e-14) and last.adhesion_area == 0.0
        assert last.traction_coefficient == pytest.approx(0.55, abs=1e-6)


@pytest.mark.parametrize("name", THEORIES + ["halfspace"])
def test_every_model_solves_case_a(name):
    points = solved(CURVE, model=name).points
    assert len(points) == 2 and points[0].normal_force == pytest.approx(50e3, abs=50.0)
    # CONTACT's Richardson value is 0.21565; theories stay within 5 % where they have a bound, the linear one above. Polach's
    # formula rises as steeply but bends later.
    first = points[0].traction_coefficient
    if name == "linear":
        assert first > 0.216
    else:
        assert first == pytest.approx(0.21565, rel=0.06 if name == "polach" else 0.05)


@pytest.mark.parametrize("model, options, more", [
    ("fastsim", {"fastsim.bound": "elliptic"}, {}), ("fastsim", {"fastsim.elements": "grid"}, {}),
    ("fastsim", {"fastsim.strips": 8, "fastsim.strip_elements": 8}, {}), ("strip", {"strip.strips": 16}, {}),
    ("carter", {"carter.strips": 8}, {}),
    # One flexibility or three are the same when only one creepage is there, not with spin.
    ("fastsim", {"fastsim.flexibilities": "one"}, {"rolling.spin": 2e-4})])
def test_options_of_the_case_reach_the_theories(model, options, more):
    plain, other = (solved(CURVE | more | keys, model=model).points[1] for keys in ({}, options))
    assert (forces(plain) != forces(other)).any()
    if "fastsim.bound" in options:
        assert abs(other.traction_coefficient / plain.traction_coefficient - 1) > 0.01


def test_theories_say_what_they_leave_out():
    def subjects(name, memory):
        notes = solved(CURVE | {"output.stress_maxima": True, "rolling.speed": 10e3, "friction.law": "exponential",
                                "friction.kinetic_coefficient": 0.1, "friction.half_velocity": 500.0,
                                "friction.memory_distance": memory}, model=name).notes
        return {note.about for note in notes} & {"stress", "memory_distance"}

    assert subjects("hertz", 3e-3) >= {"stress"} and subjects("halfspace", 3e-3) == set()
    assert subjects("polach", 3e-3) == {"stress", "memory_distance"}
    assert subjects("fastsim", 3e-3) == subjects("polach", 0.0) == {"stress"}


@pytest.mark.parametrize("name", ["hertz"] + THEORIES)
def test_hertzs_pressure_given_is_hertzs_contact(name):
    """Radii, the ellipse and its pressure, and a quadratic distance are the same contact."""
    hertz = solved(SMALL, model="hertz").points[0]
    bodies = solved(CURVE, model=name).points[-1]
    no_radii = CURVE | {"wheel.transverse_radius": None, "rail.transverse_radius": None, "wheel.rolling_radius": None}
    given = {"given_pressure.semi_axis_x": hertz.semi_axis_x, "given_pressure.semi_axis_y": hertz.semi_axis_y}
    quadratic = {"undeformed_distance.quadratic": [0.5 / 405.0, 0.5 / 2000.0]}
    for other in given, quadratic:
        point = solved(no_radii | other, model=name).points[-1]
        assert point.longitudinal_force == pytest.approx(bodies.longitudinal_force, rel=1e-9)
        assert point.max_pressure == pytest.approx(bodies.max_pressure, rel=1e-9)
    if name == "hertz":
        assert solved(no_radii | given, model=name).points[0].approach == pytest.approx(hertz.approach, rel=1e-9)


@pytest.mark.parametrize("name", ["hertz", "halfspace"] + THEORIES)
def test_without_friction_no_model_has_tangential_tractions(name):
    sideways = {} if name in ("carter", "vermeulen-johnson") else {"rolling.lateral_creepage": 1e-3}
    point = solved(CURVE | sideways | {"rolling.problem": "steady", "friction.coefficient": 0}, model=name).points[0]
    assert [point[each] for each in ("max_traction", "longitudinal_force", "lateral_force", "spin_moment")] == [0.0] * 4
    assert not point.scalars.get("frictional_work") and point.normal_force == pytest.approx(50e3, abs=50.0)


def maxima(point):
    return {(each["body"], each["measure"]): (each["value"], each["place"]) for each in point.stress_maxima}


def test_stress_maxima_of_the_circle_are_hertzs_in_both_bodies():
    """Johnson (1985) section 3.4, nu = 0.3: largest shear 0.31002 p0 at 0.4809 a on the axis. xz, odd in x, ranges over twice its
    largest value, 0.2137 p0."""
    point = solved(SMALL | {"rail.transverse_radius": 405.0, "rolling.problem": "frictionless", "contact_grid.elements_across": 24,
                            "output.stress_maxima": True}, model="halfspace").points[0]
    found, p0, a = maxima(point), point.max_pressure, point.semi_axis_x
    assert len(found) == 12
    for body, side in ("wheel", 1), ("rail", -1):
        assert found[body, "orthogonal_shear_surface"][0] == 0.0
        value, place = found[body, "xz_range"]
        assert value / p0 == pytest.approx(2 * 0.2137, abs=1e-3) and place[1] == pytest.approx(0.0, abs=0.06 * a)
        value, place = found[body, "tresca"]
        assert 0.5 * value / p0 == pytest.approx(0.31002, abs=1e-3)
        assert place[2] / a == pytest.approx(0.4809 * side, abs=0.01) and math.hypot(*place[:2]) < 0.05 * a


def test_shear_is_reported_on_the_surface_and_below_it():
    """Under friction, on a plane along rolling: no place below one element has more shear than the largest below the surface, and
    no line along x a larger range."""
    plane = {"body": "rail", "from": [-8, 0, -0.3], "to": [8, 0, -0.3], "across": [-8, 0, -6.3], "points": [81, 31]}
    point = solved(SMALL | rolling(0.01, 24) | {"friction.coefficient": 0.2, "output.stress_maxima": True,
                                                "subsurface.plane": [plane]}, model="halfspace").points[0]
    stress = np.reshape(point.subsurface[0]["stress"], (31, 81, 6))
    largest = np.abs(package().stress_measures(stress)["orthogonal_shear"]).max()
    ranges = np.maximum(stress[..., 5].max(axis=1), 0) - np.minimum(stress[..., 5].min(axis=1), 0)
    for (body, measure), (value, place) in maxima(point).items():
        bar = f"max_{measure}_{body}"
        if measure == "orthogonal_shear":
            assert value == pytest.approx(largest, abs=2e-3 * point.max_pressure)
            assert abs(place[2]) >= 0.2 and (place[2] > 0) == (body == "wheel")
        elif measure == "orthogonal_shear_surface":
            assert value == pytest.approx(point.max_traction, rel=1e-15)
            assert point.error_estimate[bar] == point.error_estimate["max_traction"]
        elif measure == "xz_range":
            assert value == pytest.approx(ranges.max(), abs=2e-3 * point.max_pressure)
        assert (bar in point.error_estimate) != (bar in point.no_bar)
        assert point.no_bar.get(bar, "near_surface") in ("near_surface", "near surface")
