# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tables are filled with: Kalker's theory and full sliding at their ends, single solutions of ellipses and wheels, the
table of the ellipse, mirror images, jumps of the contact, loads and speeds, falling friction; and wrong calls."""

import functools
import itertools
import math
import tempfile
import tomllib

import h5py
import numpy as np
import pytest
from program import package, says, solved, toml

ELLIPSE = {"load.normal_force": 50e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 450.0,
           "wheel.transverse_radius": math.inf, "wheel.poisson_ratio": 0.25, "rail.transverse_radius": 300.0,
           "rail.poisson_ratio": 0.25}
OWN = ELLIPSE | {"table.points": [3, 2, 3], "table.largest": [2.0, 3.0, 4.0], "table.check_points": 0}
# A wheel with a hollow tread, of which a rail touches the rim where the wheelset is shifted.
WHEEL = {"load.normal_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.profile": "arcs",
         "rail.profile": "arcs", "wheel_profile.radii": [50.0, -150.0, 50.0], "wheel_profile.ends": [-50.0, -10.0, 10.0, 50.0],
         "rail_profile.radii": [200.0, 20.0], "rail_profile.ends": [22.0, 39.0], "rail_profile.symmetric": True,
         "track.inclination": "none", "wheelset.flange_back_position": -76.0, "wheelset.roll": 0.0,
         "contact_grid.elements_across": 16}
RIM = WHEEL | {"table.lateral_shift": [0.8, 1.0, 1.2], "table.points": [2, 2, 3], "table.check_points": 20}
ONE = RIM | {"table.lateral_shift": [1.0], "table.check_points": 0}
FALLING = {"friction.law": "exponential", "friction.kinetic_coefficient": 0.1, "friction.half_velocity": 300.0,
           "friction.memory_distance": 0.003, "rolling.speed": 20e3}
NAMES = "longitudinal_creepage", "lateral_creepage", "spin"


@functools.cache
def _table(text):
    return package().table(package().Case(tomllib.loads(text)))


def table(keys):
    return _table(toml(keys))


@functools.cache
def _scales(text):
    with tempfile.TemporaryDirectory() as folder:
        _table(text).write(folder)
        with h5py.File(f"{folder}/table.h5") as file:
            return np.reshape(file["axes/scale"], (-1, 3))


def creepages_of(keys, row, scaled, bound, a, b, modulus=None):
    """Longitudinal and lateral creepage and spin of scaled ones, of the table's first axis at `row`."""
    unit = bound / ((modulus or table(keys).shear_modulus) * a * b)
    return unit * np.array(scaled) / _scales(toml(keys))[row] / [1.0, 1.0, math.sqrt(a * b)]


def forces(found):
    return np.array([found.longitudinal_force, found.lateral_force])


def test_a_table_begins_as_kalkers_theory_and_ends_in_full_sliding():
    """Creepages are scaled so that the linear forces are -3 xi', -3 eta' and, of spin, the coefficient's share."""
    keys = ELLIPSE | {"table.axis_ratio": [0.4], "table.longitudinal_values": [0.0, 0.002, 300.0], "table.check_points": 0,
                      "table.lateral_values": [0.0, 0.002, 400.0], "table.spin_values": [0.0, 0.004]}
    made = table(keys)
    linear = solved({"load.normal_force": 50e3, "friction.coefficient": 0.3, "given_pressure.semi_axis_x": math.sqrt(40.0),
                     "given_pressure.semi_axis_y": math.sqrt(250.0), "rolling.spin": 1e-9, "wheel.poisson_ratio": 0.25,
                     "rail.poisson_ratio": 0.25}, "linear").points[0]
    c23, c33 = abs(linear.lateral_force) * math.sqrt(linear.semi_axis_x * linear.semi_axis_y), abs(linear.spin_moment)
    assert made.scaled(0.002).longitudinal_force / -0.006 == pytest.approx(1.0, abs=0.015)
    assert made.scaled(0.0, 0.002).lateral_force / -0.006 == pytest.approx(1.0, abs=0.015)
    turning = made.scaled(spin=0.004)
    assert turning.lateral_force / (-0.004 * c23 / math.hypot(c23, c33)) == pytest.approx(1.0, abs=0.02)
    assert turning.spin_moment / (-0.004 * c33 / math.hypot(c23, c33)) == pytest.approx(1.0, abs=0.03)
    # Sliding against the direction of the creepages themselves.
    direction = [300.0, 400.0] / _scales(toml(keys))[0, :2]
    assert forces(made.scaled(300.0, 400.0)) == pytest.approx(-direction / np.hypot(*direction), abs=1e-4)
    assert np.hypot(*forces(made.scaled(300.0, 400.0))) == pytest.approx(1.0, abs=1e-6)


def test_interpolation_is_judged_at_points_that_were_solved_for():
    made = table(ELLIPSE | {"table.axis_ratio": [0.7, 1.4], "table.points": [4, 3, 7], "table.largest": [2.0, 1.5, 2.0],
                            "table.check_points": 20})
    assert made.checked.shape[0] == 20 and (0.7 <= made.checked[:, 0]).all() and (made.checked[:, 0] <= 1.4).all()
    ratio, creepage, interpolated, exact = made.checked[:, 0], made.checked[:, 1:4], made.checked[:, 4:7], made.checked[:, 7:10]
    found = made.scaled(*creepage.T, axis_ratio=ratio)
    assert np.allclose(forces(found).T, interpolated[:, :2], rtol=0, atol=1e-9)
    apart = np.hypot(*(interpolated - exact)[:, :2].T)
    assert made.interpolation["force_max"] == pytest.approx(apart.max(), abs=1e-9)
    assert 0 < made.interpolation["force_rms"] and made.interpolation["force_95"] <= made.interpolation["force_max"]


def test_the_ratio_is_that_of_the_case_unless_ratios_are_named():
    own = table(OWN).axes
    # Rolling radius 450 across a rail of 300 mm: longer along rolling.
    assert 1.0 < own["axis_ratio"][0] < 1.5 and own["longitudinal"].size == 3
    assert own["lateral"][-1] == 3.0 and own["spin"].tolist() == [-4.0, 0.0, 4.0]


def test_ratios_and_values_are_those_listed():
    listed = table(ELLIPSE | {"table.axis_ratio": [0.5, 2.0], "table.longitudinal_values": [0.0, 1.0],
                              "table.lateral_values": [0.0, 1.0], "table.spin_values": [0.5, 1.0], "table.check_points": 0}).axes
    assert listed["axis_ratio"].tolist() == [0.5, 2.0] and listed["spin"].tolist() == [-1.0, -0.5, 0.5, 1.0]


@pytest.mark.parametrize("signs", itertools.product([-1, 1], repeat=3))
def test_signs_of_creepages_are_those_of_single_solutions(signs):
    """A table holds positive longitudinal and lateral values only."""
    made, bound = table(OWN), 0.3 * 50e3
    hertz = solved(ELLIPSE, "hertz").points[0]
    a, b, modulus = hertz.semi_axis_x, hertz.semi_axis_y, 210e3 / 2.5
    scaled = np.array(signs) * [made.axes["longitudinal"][1], made.axes["lateral"][1], made.axes["spin"][2]]
    creepages = creepages_of(OWN, 0, scaled, bound, a, b, modulus)
    point = solved(ELLIPSE | {f"rolling.{name}": value for name, value in zip(NAMES, creepages)}, "halfspace").points[0]
    found = made.forces(semi_axis_x=a, semi_axis_y=b, shear_modulus=modulus, friction_bound=bound, **dict(zip(NAMES, creepages)))
    assert forces(found) == pytest.approx([point.longitudinal_force, point.lateral_force], abs=0.004 * bound)
    assert found.spin_moment == pytest.approx(point.spin_moment, abs=0.01 * bound * math.sqrt(a * b))


@pytest.mark.parametrize("keys", [lambda: OWN, lambda: RIM, lambda: bodies(1.0, 80e3) | LOADS], ids=["ellipse", "wheel", "loads"])
def test_a_table_comes_back_from_its_file_to_the_last_bit(tmp_path, keys):
    made = table(keys())
    made.write(tmp_path / "table")
    back = package().Table(tmp_path / "table")
    for name in "longitudinal_force", "lateral_force", "spin_moment", "force_along_normal", "force_bar", "moment_bar", "checked":
        np.testing.assert_array_equal(getattr(back, name), getattr(made, name), err_msg=name)
    for one, other in (back.axes, made.axes), (back.wheels or {}, made.wheels or {}):
        assert one.keys() == other.keys()
        for name in one:
            np.testing.assert_array_equal(one[name], other[name], err_msg=name)
    assert (back.interpolation, back.title, back.case_text) == (made.interpolation, made.title, made.case_text)
    assert [back.shear_modulus, back.friction_coefficient] == pytest.approx([made.shear_modulus, made.friction_coefficient], nan_ok=True)


# Wheels.
def wheel(shift, creepages, keys=RIM):
    """The patch of the wheel at a shift."""
    without = {name: value for name, value in keys.items() if not name.startswith("table.")}
    return solved(without | {"wheelset.lateral_shift": shift} | {f"rolling.{name}": value for name, value in zip(NAMES, creepages)},
                  "halfspace").points[0]


@pytest.mark.parametrize("row, i, j, k", [(0, 0, 2, 0), (1, 1, 0, 2), (2, 2, 2, 1), (1, 2, 1, 0)])
def test_points_of_a_wheel_are_single_solutions(row, i, j, k):
    made, shift = table(RIM), [0.8, 1.0, 1.2][row]
    at = made.wheel_at(shift)
    bound, a, b = 0.3 * 80e3, at["semi_axis_x"], at["semi_axis_y"]
    node = made.axes["longitudinal"][i], made.axes["lateral"][j], made.axes["spin"][k]
    creepages = creepages_of(RIM, row, node, bound, a, b)
    point, scaled = wheel(shift, creepages), made.scaled(*node, lateral_shift=shift)
    solution = [point.longitudinal_force, point.lateral_force, point.spin_moment / math.sqrt(a * b)]
    assert [*forces(scaled), scaled.spin_moment] == pytest.approx(np.array(solution) / bound, abs=1e-9)
    bars = point.error_estimate
    assert math.hypot(bars["longitudinal_force"], bars["lateral_force"]) <= bound * scaled.force_bar
    # Physical creepages find it again.
    found = made.forces(lateral_shift=shift, friction_bound=bound, **dict(zip(NAMES, creepages)))
    assert [*forces(found), found.spin_moment / math.sqrt(a * b)] == pytest.approx(solution, abs=1e-8 * bound)
    place = point.place
    assert at["contact_angle"] == pytest.approx(place["contact_angle"], abs=1e-12)
    assert at["rolling_radius"] == pytest.approx(place["rolling_radius"], abs=1e-9)


def test_interpolation_of_a_wheel_is_judged_at_shifts_between():
    made = table(RIM)
    assert made.checked.shape[0] == 20 and len(set(made.checked[:, 0])) > 1
    assert (0.8 <= made.checked[:, 0]).all() and (made.checked[:, 0] <= 1.2).all() and 0 < made.interpolation["force_rms"] < 1


def test_of_circular_profiles_it_is_the_table_of_the_ellipse():
    """A cylinder on a rail of radius 200 mm: Hertz's ellipse."""
    keys = WHEEL | {"wheel_profile.radii": [math.inf], "wheel_profile.ends": [-60.0, 60.0], "track.gauge_height": 8.0,
                    "wheelset.flange_back_position": -70.0, "rail_profile.ends": [28.0, 45.0], "contact_grid.elements_across": 24,
                    "table.lateral_shift": [0.0], "table.points": [3, 3, 5], "table.check_points": 0}
    cylinder = table(keys)
    at = cylinder.wheel_at(0.0)
    radii = {"load.normal_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": float(at["rolling_radius"]),
             "wheel.transverse_radius": math.inf, "rail.transverse_radius": 200.0}
    hertz = solved(radii, "hertz").points[0]
    a, b, bound = hertz.semi_axis_x, hertz.semi_axis_y, 0.3 * 80e3
    assert [at["semi_axis_x"], at["semi_axis_y"]] == pytest.approx([a, b], rel=0.01)
    assert at["contact_angle"] == pytest.approx(0.0, abs=1e-6)
    ellipse = table(radii | {"table.points": [3, 3, 5], "table.check_points": 0})
    # The same nodes but for the 1 % of the axes; a cylinder's rolling radius is the same everywhere.
    x, z = cylinder.axes["longitudinal"][3], cylinder.axes["spin"][3]
    for node in (3, 0, 0), (0, -3, 0), (0, 0, 5), (-x, x, 0), (0, -x, z):
        given = dict(zip(NAMES, creepages_of(keys, 0, node, bound, a, b))) | {"friction_bound": bound}
        found = cylinder.forces(lateral_shift=0.0, **given)
        expected = ellipse.forces(semi_axis_x=a, semi_axis_y=b, shear_modulus=cylinder.shear_modulus, **given)
        assert forces(found) == pytest.approx(forces(expected), abs=0.008 * bound), node
        assert found.spin_moment == pytest.approx(expected.spin_moment, abs=0.015 * bound * math.sqrt(a * b)), node


def difference(one, other, mirrored=False):
    """The largest of forces and moments, scaled; `mirrored`: of the mirror image."""
    fields = [(made.longitudinal_force, made.lateral_force, made.spin_moment) for made in (one, other)]
    if mirrored:
        fields[1] = [sign * field[..., ::-1, ::-1] for sign, field in zip((1, -1, -1), fields[1])]
    return max(np.abs(here - there).max() for here, there in zip(*fields))


def test_of_the_other_wheel_it_is_the_mirror_image():
    left, right = table(ONE), table(ONE | {"wheelset.side": "right", "table.lateral_shift": [-1.0]})
    assert left.wheels["contact_angle"][0] == pytest.approx(right.wheels["contact_angle"][0], abs=1e-9)
    assert difference(left, right) > 0.1
    assert difference(left, right, mirrored=True) < 2e-4  # the mirrored grid has its corner elsewhere


def test_without_slip_of_its_surface_it_holds_for_any_friction():
    slippery = {"friction.coefficient": 0.1}
    assert difference(table(ONE), table(ONE | slippery)) > 1e-3
    plain = ONE | {"rolling.extra_slip": "none"}
    assert difference(table(plain), table(plain | slippery)) < 1e-6


ROOT = -26.0 - 37.0 * (math.sin(math.pi / 3) - math.sin(math.atan(0.05)))


def test_it_knows_where_another_contact_comes():
    """At -13.9 mm tread and root are two contacts, 0.01 mm further one."""
    made = table({"load.vertical_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.profile": "arcs",
                  "wheel_profile.radii": [12.0, math.inf, -37.0, math.inf], "wheel_profile.slope": -0.05,
                  "wheel_profile.ends": [ROOT - 18.0, ROOT - 3.0, ROOT, -26.0, 60.0], "rail.profile": "60E1",
                  "track.inclination": "1:40", "wheelset.roll": 0.0, "contact_grid.elements_across": 16,
                  "table.lateral_shift": [-13.9, -13.89], "table.points": [2, 2, 2], "table.check_points": 10})
    assert made.wheels["contacts"].tolist() == [2.0, 1.0]
    assert made.wheels["jump_after"].tolist() == [1.0, 0.0]
    assert set(made.checked[:, 0]) <= {-13.9, -13.89}
    left, right, between = (made.forces(lateral_shift=shift, longitudinal_creepage=0.002, lateral_creepage=0.001)
                            for shift in (-13.9, -13.89, -13.897))
    apart = np.hypot(*(forces(left) - forces(right)))
    assert (forces(between) == forces(left)).all() and between.force_bar >= apart > 0.01 * 0.3 * made.wheels["normal_force"][0]


def test_a_step_stands_for_the_shifts_between():
    made = table(ONE | {"table.lateral_shift": [0.8, 1.2], "table.lateral_shift_step": 0.2})
    assert made.axes["lateral_shift"] == pytest.approx([0.8, 1.0, 1.2]) and made.axes["longitudinal"].tolist() == [-3.0, 0.0, 3.0]


# Loads and speeds.
LOADS = {"friction.coefficient": 0.3, "table.load": [50e3, 80e3], "table.speed": [15e3, 20e3, 30e3],
         "table.longitudinal_values": [0.0, 1.0, 3.0], "table.lateral_values": [0.0, 1.0], "table.spin_values": [0.5],
         "table.check_points": 10} | FALLING


def bodies(size, force):
    """Steel, radii in the same ratio whatever `size` is."""
    return {"load.normal_force": force, "wheel.rolling_radius": size * 450.0, "wheel.transverse_radius": math.inf,
            "rail.transverse_radius": size * 300.0}


@pytest.mark.parametrize("size, force, speed", [(1.0, 62e3, 17e3), (0.7, 60e3, 17e3), (1.5, 75e3, 26e3)])
def test_loads_and_speeds_of_ellipses_hold_for_bodies_of_other_curvature(size, force, speed):
    made = table(bodies(1.0, 80e3) | LOADS)
    # Few check points are at many loads and speeds; otherwise the bars would be those of a single one.
    assert len({tuple(row) for row in made.checked[:, 10:]}) == 10
    case = bodies(size, force) | FALLING | {"friction.coefficient": 0.3, "rolling.speed": speed, "contact_grid.elements_across": 40}
    hertz = solved(case, "hertz").points[0]
    a, b, bound = hertz.semi_axis_x, hertz.semi_axis_y, 0.3 * force
    creepages = dict(zip(NAMES, creepages_of(bodies(1.0, 80e3) | LOADS, 0, [1.0, 1.0, 0.5], bound, a, b)))
    point = solved(case | {f"rolling.{name}": value for name, value in creepages.items()}, "halfspace").points[0]
    found = made.forces(semi_axis_x=a, semi_axis_y=b, shear_modulus=made.shear_modulus, friction_bound=bound, speed=speed,
                        **creepages)
    error = np.hypot(*(forces(found) - [point.longitudinal_force, point.lateral_force]))
    assert error < 0.005 * bound and error < found.force_bar  # bars of the table's points and of the solution
    assert found.spin_moment == pytest.approx(point.spin_moment, abs=0.005 * bound * math.sqrt(a * b))


def test_at_its_values_it_is_the_table_of_that_load_and_speed():
    made = table(bodies(1.0, 80e3) | LOADS)
    one = table(bodies(1.0, 80e3) | LOADS | {"table.load": None, "table.speed": None, "table.check_points": 0})
    creepage = one.axes["longitudinal"][:, None], 1.0, one.axes["spin"]
    assert np.allclose(forces(made.scaled(*creepage, load=80e3, speed=20e3)), forces(one.scaled(*creepage)), rtol=0, atol=1e-9)
    # Alone it holds for its own pressure and size.
    hertz = solved(bodies(1.0, 80e3) | {"friction.coefficient": 0.3}, "hertz").points[0]
    ellipse = {"semi_axis_x": hertz.semi_axis_x, "semi_axis_y": hertz.semi_axis_y, "shear_modulus": one.shear_modulus}
    one.forces(friction_bound=24e3, **ellipse)
    with pytest.raises(package().InputError, match="load"):
        one.forces(friction_bound=25e3, **ellipse)
    for place, said in (({"load": 49e3, "speed": 20e3}, "load 49000 N.*allowed: 50000 to 80000"),
                        ({"load": 60e3, "speed": 31e3}, "speed 31000 mm/s.*allowed: 15000 to 30000"),
                        ({"load": 60e3}, "give it, or make a table")):
        with pytest.raises(package().InputError, match=said):
            made.scaled(**place)


def test_loads_and_speeds_of_a_wheel_are_those_of_its_own_table():
    few = {"table.lateral_shift": [1.0], "table.longitudinal_values": [0.0, 1.0], "table.lateral_values": [0.0, 1.0],
           "table.spin_values": [0.5], "contact_grid.elements_across": 12}
    own = table(WHEEL | FALLING | few | {"rolling.speed": 17e3, "table.check_points": 0})
    made = table(WHEEL | FALLING | few | {"table.load": [70e3, 90e3], "table.speed": [15e3, 20e3], "table.check_points": 10})
    assert made.longitudinal_force.size == 4 * own.longitudinal_force.size
    at = made.wheel_at(1.0, 80e3)
    assert at["contacts"] == 1.0 and at["normal_force"] == pytest.approx(80e3, abs=1e-6)
    creepage = own.axes["longitudinal"][:, None, None], own.axes["lateral"][:, None], own.axes["spin"]
    found = made.scaled(*creepage, lateral_shift=1.0, load=80e3, speed=17e3)
    assert np.hypot(*(forces(found) - forces(own.scaled(*creepage, lateral_shift=1.0)))).max() < 0.01
    with pytest.raises(package().InputError, match="load"):
        made.forces(lateral_shift=1.0, friction_bound=24e3)


def test_keys_that_do_not_apply_are_named():
    with pytest.warns(UserWarning, match="does not use wheelset.lateral_shift, wheelset.free_rolling") as warned:
        table(ONE | {"wheelset.lateral_shift": 3.0, "wheelset.free_rolling": "force", "wheelset.yaw": 0.002})
    assert "yaw" not in str(warned[0].message)  # a table is of one yaw


def test_falling_friction_in_full_sliding_is_that_of_the_slip_velocity():
    keys = ONE | FALLING | {"layer.thickness": 1.0, "layer.shear_modulus": 8200.0, "rolling.extra_slip": "none",
                            "table.largest": [10.0, 10.0, 10.0]}
    made = table(keys)
    at = made.wheel_at(1.0)
    bound = 0.3 * at["normal_force"]
    end = creepages_of(keys, 0, [10.0, 0.0, 0.0], bound, at["semi_axis_x"], at["semi_axis_y"])[0]
    found = made.forces(lateral_shift=1.0, friction_bound=bound, longitudinal_creepage=0.999999 * end)
    mu = 0.1 + 0.2 * 2 ** (-20e3 * end / 300.0)
    assert mu < 0.2 and -found.longitudinal_force / at["normal_force"] == pytest.approx(mu, rel=0.01)
    for other, creepage, said in ((0.5, 0.5, "falling friction at a speed of 20000 mm/s and a layer"),
                                  (1.0, 2.0, "2 times those at the end")):
        with pytest.raises(package().InputError, match=said):
            made.forces(lateral_shift=1.0, friction_bound=other * bound, longitudinal_creepage=creepage * end)


@pytest.mark.filterwarnings("ignore:.*does not use wheelset.lateral_shift")
@pytest.mark.parametrize("keys, said", [
    (RIM | {"table.axis_ratio": [1.0]}, "over axis ratios or"), (RIM | {"table.lateral_shift_step": 0.1}, "has 3 values"),
    (RIM | {"table.lateral_shift": [0.0, 1.0], "table.lateral_shift_step": 0.3}, "3.33333 steps"),
    (RIM | {"table.lateral_shift": None}, "lateral_shift = ["), (RIM | {"wheelset.side": "both"}, "wheelset.side"),
    (RIM | {"wheelset.yaw": [0.0, 0.01]}, "wheelset.yaw"), (RIM | {"wheelset.lateral_shift": [0.0, 1.0]}, "shifts under [table]"),
    (ELLIPSE | {"table.lateral_shift": [0.0, 1.0]}, "by radii"),
    (RIM | {"rail_plasticity.yield_stress": 400.0, "rail_plasticity.hardening": [1000.0]}, "of elastic bodies"),
    (RIM | {"friction.coefficient": 0.0}, "friction.coefficient"), (RIM | {"rolling.problem": "frictionless"}, "rolling.problem"),
    (RIM | {"table.lateral_shift": [1.0, 90.0]}, "lateral shift of 90 mm"),
    (ELLIPSE | {"table.axis_ratio": [1.0, 0.5]}, "axis_ratio"), (ELLIPSE | {"table.longitudinal_values": [0.0, 2.0, 1.0]}, "values"),
    (ELLIPSE | {"table.longitudinal_values": [0.5, 1.0]}, "longitudinal_values"), (ELLIPSE | {"table.lateral_values": [0.0]}, "values"),
    (ELLIPSE | {"table.spin_values": [0.0]}, "spin_values"),
    (ELLIPSE | {"table.points": [200, 200, 200], "table.axis_ratio": [0.5, 1.0, 2.0]}, "points"),
    (ELLIPSE | {"geometry.shape": "line", "wheel.transverse_radius": None, "rail.transverse_radius": None}, "line"),
    (bodies(1.0, 80e3) | LOADS | {"friction.memory_distance": None}, "list table.speed instead"),
    (bodies(1.0, 80e3) | {"friction.coefficient": 0.3, "table.speed": [15e3, 20e3]}, "do not depend on the speed")])
def test_wrong_tables_are_refused(keys, said):
    with pytest.raises((package().InputError, package().SolveError)) as refused:
        table(keys)
    says(str(refused.value), said, "do: ")
