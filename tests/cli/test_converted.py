# SPDX-License-Identifier: LGPL-2.1-or-later
"""The keys of converted cases of CONTACT: load points, signs, grids, bodies, friction, wheels and rails. A change of an input
is a list of (piece, what takes its place)."""

import math
import tomllib

import numpy as np
import pytest
from program import SOURCE, package, says

BALL, ELLIPSE, ROLLER, PUSHED_ELLIPSE, WHEEL = (
    (SOURCE / f"tests/support/contact/{name}.inp").read_text()
    for name in ("pushed_ball", "rolling_ellipse", "driven_roller", "pushed_ellipse", "left_wheel"))
MODULUS = 300.0 / 0.75  # E* of the ball
APPROACH = (9 * 20.0**2 / (16 * 25.0 * MODULUS**2)) ** (1 / 3)  # Hertz, under 20 N


def changed(text, *changes):
    for piece, other in changes:
        assert piece in text, piece
        text = text.replace(piece, other, 1)
    return text


def flat(table, path=""):
    """{"section.key": value} of a case file; of displacements, which are pairs, that of the left wheel."""
    found = {}
    for name, value in table.items():
        if isinstance(value, dict):
            found |= flat(value, f"{path}{name}.")
        else:
            found[path + name] = value[0] if path.endswith("_displacement.") else value
    return found


@pytest.fixture
def converted(rollfem):
    """The case files that the program makes of an input: (path, keys, text) of each. Each is read as a case."""
    def convert(text):
        folder = f"made{len(list(rollfem.work.iterdir()))}"
        rollfem.done("convert", rollfem.file("made.inp", text), "-o", folder)
        files = sorted(rollfem.work.glob(f"{folder}/*.toml"))
        for file in files:
            package()._core.read_case(str(file), [])
        return [(file, flat(tomllib.loads(file.read_text())), file.read_text()) for file in files]
    return convert


def listed(value):
    return value if isinstance(value, list) else [value]


def expect(found, keys):
    """A number may stand for a list of equal ones; None is no key."""
    for name, value in keys.items():
        given = found.get(name)
        if isinstance(value, (float, list)) and given is not None:
            given, value = listed(given), listed(value)
            given = given * len(value) if len(given) == 1 else given
            assert given == pytest.approx(value, rel=1e-9, abs=1e-15, nan_ok=True), name
        else:
            assert given == value, name


NAN = math.nan
ROLLED_ON = """ 3 module
 002100
 102000
 0111341
 20.0 0.0001 0.0 0.0
 0.0 0.1 1000.
 0.25 0.25 300. 300.
 0 module"""
ONSET = """ 3 module
 002120
 102000
 0111341
 20.0 -0.5 0.0 0.0
 0.0 0.1 1000.
 0.25 0.25 300. 300.
 3 module
 002120
 100000
 0111341
 20.0 -0.6 0.0 0.0
 0 module"""
REDUCED_SLOPE = """ 3 module
 233100   P-B-T-N-F-S
 422320   L-D-C-M-Z-E
 0100341  H-G-I-A-O-W-R
 100e3 0.001 0.0 0.0              FN CKSI CETA CPHI
 0.13 0.22 900. 0.0 0.0           FKIN FEXP1 SABSH1 FEXP2 SABSH2
 0.002 1.5                        MEMDST MEM_S0
 0.0 0.5 10000.                   CHI DQ VELOC
 0.28 0.28 82000. 82000.
 0.5 0.02 0.6                     K0_MF ALFAMF BETAMF
  -2
 44 22 0.0008 0.5 1.1             MX MY A1 AOB SCALE
 0
"""
IPOTCN = "   1                              IPOTCN\n 36 36  -1.35 -1.35 0.075 0.075"
PARABOLA = " 1 1\n 0.0016666666666667 0.0 0.0 0.0 0.0 0.0"
# Debugging digits (X = 1), settings of GDsteady, stresses in two blocks of points: no such case has them.
SKIPPED = [(" 203100 ", " 203103 "), (" 0001341  H-G-I-A-O-W-R", "10501341\n 1000005 P-S-F-L-R-I-N"),
           (" 200 100 30 1 1e-6", " 200 100 30 1 1e-6\n 1 0.5 1 1.0 0.0 1.0 1.0 1.0"),
           ("1.1                MX MY AA BB SCALE\n",
            "1.1\n 1 1\n 2\n 1 1 45\n 23 1 23\n 1 1e-6 1e-6\n 9\n 1 2 3\n 0.\n 0. 1.\n 0. 0.5\n 1.\n 0\n")]
CURVE = {"rolling.longitudinal_creepage": [0.0004, 0.0008, 0.0012], "rolling.lateral_creepage": [-0.0002] * 3,
         "rolling.spin": [0.0003] * 3}
MOVING = "".join(  # h = 0.02 (x - s)^2 + 0.02 y^2 with s = 0.075 and 0.15 mm, the approach of 20 N
    f" 3\n 001010\n 100020\n 0101341\n {APPROACH:.5g} -0.6 0. 0.\n 1 1\n 0.02 0. 0.02 {-0.04 * s:.7g} 0. {0.02 * s * s:.7g}\n"
    for s in (0.075, 0.15))


@pytest.mark.parametrize("text, changes, keys", [
    # Forces in newtons, and the grid of the file.
    (BALL, [], {"rolling.problem": "shift", "rolling.longitudinal_force": -0.5 * 0.3 * 20.0, "rolling.lateral_force": 0.0,
                "history.normal_force": 20.0, "wheel.young_modulus": 750.0, "contact_grid.cell_size": [0.075, 0.075],
                "contact_grid.extent": [2.7, 2.7], "undeformed_distance.quadratic": [0.02, 0.02]}),
    # However the potential contact is given.
    *((BALL, [(IPOTCN, given)], {"contact_grid.cell_size": [0.075, 0.075]}) for given in (
        "   2\n 36 36 -1.35 -1.35 1.35 1.35", "   3\n 36 36 -1.3125 -1.3125 0.075 0.075",
        "   4\n 36 36 -1.3125 -1.3125 1.3125 1.3125")),
    # Numbers in Fortran's ways.
    (BALL, [("0.02 0.0 0.02\n", ".2-1,0d0 , 2.D-2 % half of 1/R\n"), ("20.0  -0.5", "+2.0E1  -5-1")],
     {"undeformed_distance.quadratic": [0.02, 0.02], "history.normal_force": 20.0, "rolling.longitudinal_force": -3.0}),
    # Cases that differ in creepage are load points, also where the module line is left out or blocks are skipped.
    (ELLIPSE, [], CURVE | {"rolling.upwind_order": "first", "contact_grid.cell_size": [0.5, 0.3], "friction.coefficient": 0.35,
                           "wheel.young_modulus": 2 * 82000.0 * 1.28}),
    (ELLIPSE, [(" 0001341 ", " 0001340 "), ("AA BB SCALE\n 3 module\n", "AA BB SCALE\n"),
               (" 0101341\n 40000. 0.0008 -0.0002 0.0003\n 3 module\n", " 0101342\n 40000. 0.0008 -0.0002 0.0003\n")], CURVE),
    (ELLIPSE, SKIPPED, CURVE),
    (ELLIPSE, [("40000. 0.0008", "40000. 0.0004")], {"rolling.longitudinal_creepage": [0.0004, 0.0004, 0.0012]}),
    (ELLIPSE, [("40000. 0.0008", "40000. 0.0004"), ("40000. 0.0012", "40000. 0.0004")],
     {"rolling.longitudinal_creepage": [0.0004] * 3, "rolling.problem": None}),
    # Backwards: turned by half a turn.
    *((ELLIPSE, [(" 0.0 0.5 20000.", f" {angle} 0.5 20000.")],
       {"rolling.longitudinal_creepage": [-0.0004, -0.0008, -0.0012], "rolling.lateral_creepage": [0.0002] * 3,
        "rolling.spin": [0.0003] * 3}) for angle in ("180.0d", "3.14159265358979R")),
    (PUSHED_ELLIPSE, [], {"rolling.problem": "shift", "given_pressure.semi_axis_x": 5.0, "load.normal_force": 40000.0,
                          "rolling.longitudinal_force": 0.5 * 0.35 * 40000.0}),
    (BALL, [(" 0 module", ROLLED_ON)], {"rolling.problem": "transient", "rolling.longitudinal_force": [-3.0, NAN],
                                        "rolling.longitudinal_creepage": [0.0, 1e-4]}),
    (BALL, [(" 0 module", ONSET)], {"rolling.problem": "transient", "history.step_length": [0.1] * 3,
                                    "rolling.longitudinal_force": [-3.0, -3.0, -3.6]}),
    # Forces under an approach are parts of Hertz's force.
    (BALL, [(" 201120 ", " 201020 "), (" 20.0  -0.5", f" {APPROACH:.15g} -0.5")],
     {"history.approach": APPROACH, "rolling.longitudinal_force": -3.0}),
    (REDUCED_SLOPE, [], {"models": ["fastsim"], "fastsim.slope_reduction": [0.5, 0.02, 0.6], "fastsim.strip_elements": 40,
                         "friction.coefficient": 0.35, "friction.half_velocity": 900.0, "friction.memory_distance": 0.002}),
    # Layers: the later cases keep them, with their numbers. With TAU_C0 = 0 CONTACT's layer does not yield.
    *((ELLIPSE, [(" 022020 ", " 022420 "), ("82000. 82000.\n", f"82000. 82000.\n {numbers}\n"), *[(" 100000\n", " 100400\n")] * 2],
       {f"layer.{name}": value for name, value in zip(("shear_modulus", "thickness", "yield_stress", "hardening"), keys)})
      for numbers, keys in (("176.63 0.02 0. 0.", (176.63, 0.02, None, None)), ("0. 0. 400. -195.", (None, None, 400.0, -195.0)),
                            ("8200. 1.25 0.0 0.0", (8200.0, 1.25, None, None)), ("8200. 0.0 0.0 0.0", (None,) * 4))),
    # One row of long elements is a line contact, given by a parabola or a circle.
    *((ROLLER, changes, {"geometry.shape": "line", "geometry.width": 250.0, "geometry.relative_radius": 300.0,
                         "geometry.reference_distance": math.inf, "contact_grid.extent": [2.4, 250.0],
                         "rolling.longitudinal_force": -0.4 * 0.25 * 30000.0})
      for changes in ([], [(PARABOLA, " 2 1\n 2 0.0 300.0 -125. 250.\n 0.0 0.0")])),
    # FaStrip.
    (ELLIPSE, [("022020", "022520"), ("82000. 82000.\n", "82000. 82000.\n 1.0 1.0 1.0\n"), *[(" 203100", " 223100")] * 3,
               *[(" 100000\n", " 100500\n")] * 2],
     {"models": ["fastrip"]})])
def test_keys_of_single_contacts(converted, text, changes, keys):
    (_, found, _), = converted(changed(text, *changes))
    expect(found, keys)


def test_the_ellipse_is_hertzs_however_it_is_given(converted):
    (file, found, _), = converted(ELLIPSE)
    point = package().solve(package().Case(file), model="hertz").points[0]
    assert [point.semi_axis_x, point.semi_axis_y] == pytest.approx([5.0, 3.0], abs=1e-6)
    along, across = found["undeformed_distance.quadratic"]
    for given in f"  -1\n 22 22 {along} {across}", f"  -2\n 22 22 {along} 1.6666666667":
        (_, other, _), = converted(changed(ELLIPSE, ("  -3\n 22 22 5.0 3.0", given)))
        assert other["undeformed_distance.quadratic"][1] == pytest.approx(across, rel=1e-3)
        assert other["contact_grid.extent"][0] == pytest.approx(11.0, abs=0.01)


def test_pressed_alone_a_file_has_one_load_point(converted):
    pressed = changed(ELLIPSE, *[(" 203100", " 200100")] * 3, (" 0.0 0.5 20000.                   CHI DQ VELOC\n", ""))
    assert len(converted(pressed)) == 3


def test_a_patch_that_moves_over_fixed_axes_rolls(converted):
    (_, found, _), = converted(changed(BALL, (" 0 module", MOVING + " 0 module")))
    expect(found, {"rolling.problem": "transient", "undeformed_distance.quadratic": [0.02, 0.02]})
    assert listed(found["history.step_length"])[-1] == pytest.approx(0.075, abs=1e-9)
    assert listed(found["history.approach"])[-1] == pytest.approx(APPROACH, rel=1e-4)
    assert found["rolling.longitudinal_force"][-1] == pytest.approx(-0.6 * 0.3 * 20.0, abs=1e-3)


def test_the_distance_of_every_element_goes_into_a_file(converted):
    def first_row(distance):
        (file, _, _), = converted(changed(BALL, (" 1 1                            IBASE IPLAN\n 0.02 0.0 0.02\n 0.0 0.0 0.0", distance)))
        head, row = (file.parent / "made_distance.csv").read_text().splitlines()[:2]
        assert head == "x, y, h"
        return [float(number) for number in row.split(",")]

    # The first element is at (-1.3125, -1.3125): 0.041 * 1.3125^2.
    x = -1.3125
    assert first_row(" 1 1\n 0.02 0.001 0.02\n 0.0 0.0 0.0") == [x, x, 0.07062890625]
    # A circle of 25 mm about x = 0.2, 1 mm more height for each mm across, whose pieces go on beyond their ends.
    assert first_row(" 2 1\n 3 0.2 25. -1. 1.\n 0. 1. 3.") == pytest.approx([x, x, 1.5125**2 / 50 - 0.3125])
    assert first_row(" 2 1\n 3 0.2 25. -2. 1.\n 0. 1. 3.") == pytest.approx([x, x, 1.5125**2 / 50 + 0.6875])
    assert first_row(" 3 1\n 2. 0.5 0.1 0.3 4. -0.2 50. 40.") == pytest.approx(
        [x, x, 2 * math.sin(0.5 * (x - 0.1)) - 0.3 * math.sin(4 * (x + 0.2)) + x * x / 50 + x * x / 40])


def test_points_below_the_surface_are_lines_and_points(converted):
    # Below elements 11 and 12 of row 11, at two depths; three depths at one place.
    (_, _, text), = converted(changed(ELLIPSE, (" 203100 ", " 203103 "), (
        "1.1                MX MY AA BB SCALE\n",
        "1.1\n 1 1\n 6\n 11 1 12\n 11 1 11\n 2\n 0.5 1.5\n 9\n 1 1 3\n 0.\n 0.25\n -0.1 -0.2 -0.4\n 0\n")))
    says(text, '[[subsurface.line]]\nbody = "wheel"\nfrom = [-0.25, -0.15, 0.5]\nto = [0.25, -0.15, 0.5]\npoints = 2\n',
         '[[subsurface.point]]\nbody = "rail"\nat = [0, 0.25, -0.4]\n')


def test_few_elements_are_noted(converted):
    # 0.02 N: a diameter of 0.20 mm on cells of 0.075 mm.
    says(converted(changed(BALL, ("20.0  -0.5", "0.02  0.0 ")))[0][2], "# note: the patch is only 3 by 3 elements")


def test_what_continues_a_refused_case_is_refused(rollfem):
    text = changed(BALL, ("0.30  0.30", "0.30  0.20"), (
        " 0 module", " 3 module\n 001120\n 100000\n 0001341\n 200 100 30 1 1e-6\n 20. -0.6 0. 0.\n 0 module"))
    outcome = rollfem.call("convert", rollfem.file("a.inp", text), "--partial", "-o", "made")
    assert outcome.status == 2 and rollfem.made() == []
    says(outcome.err, "cases 1, 2")


# Friction: FKIN F1 SABSH1 F2 SABSH2; MEMDST MEM_S0.
FALLING = (" 0.35 0.35\n", " 0.10 0.20 1500. 0.05 90.   FKIN ...\n 0.004 2.0\n")


@pytest.mark.parametrize("digit, law, left", [
    (2, "linear", lambda s, half: np.maximum(0, 1 - 0.5 * s / half)),
    (3, "rational", lambda s, half: 1 / (1 + s / half)), (4, "exponential", lambda s, half: 2 ** (-s / half))])
def test_falling_friction_is_that_of_contacts_formulas(converted, digit, law, left):
    """User guide, L = 2 to 4; the second part of the rational law falls with the square of the velocity."""
    (file, found, _), = converted(changed(ELLIPSE, ("022020", f"{digit}22020"), FALLING))
    expect(found, {"friction.law": law, "friction.coefficient": 0.35, "friction.kinetic_coefficient": 0.10,
                   "friction.half_velocity": 1500.0, "friction.second_part": 0.05, "friction.second_half_velocity": 90.0,
                   "friction.memory_distance": 0.004, "friction.memory_velocity": 2.0, "rolling.speed": 20000.0})
    slip, coefficient = package().solve(package().Case(file), model="hertz").friction_law.T
    second = 1 / (1 + (slip / 90.0) ** 2) if digit == 3 else left(slip, 90.0)
    assert np.allclose(coefficient, 0.10 + 0.20 * left(slip, 1500.0) + 0.05 * second, rtol=0, atol=1e-12)


@pytest.mark.parametrize("initial_slip, branch", [(1, None), (-1, "sliding")])
def test_a_step_after_a_steady_case_starts_with_it(converted, initial_slip, branch):
    """A fourth case continues the third in a step with this INISLP; negative ones come from fast sliding."""
    step = f" 3 module\n 002100\n 100000\n 0401341\n 200 100 30 1 1e-6\n {initial_slip} 1.1\n 40000. 0.0014 -0.0002 0.0003\n 0\n"
    (_, first, _), (_, steps, text) = converted(changed(ELLIPSE, ("022020", "422020"), FALLING, (" 0\n", step)))
    assert "history.start" not in first and len(first["rolling.longitudinal_creepage"]) == 2
    expect(steps, {"rolling.problem": "transient", "history.start": "steady", "friction.branch": branch,
                   "history.normal_force": [40000.0] * 2, "rolling.longitudinal_creepage": [0.0012, 0.0014]})
    assert listed(steps["history.step_length"])[-1] == 0.5
    assert ("INISLP of case 3 is taken" in text) == (branch is not None)


def test_rows_of_elements_keep_their_friction(converted):
    rows = "".join(f" 0.{20 + row} 0.{20 + row}\n" for row in range(22))  # of 0.3 mm from -3.3 mm on
    text = changed(ELLIPSE, (" 0.35 0.35\n", ""), (" 022020 ", " 3022020 "),
                   ("1.1                MX MY AA BB SCALE\n", "1.1                MX MY AA BB SCALE\n" + rows))

    def at(text, y):
        (_, found, _), = converted(text)
        return np.interp(y, found["friction.lateral_position"], found["friction.coefficient"])

    assert at(text, [-3.15, 2.85]) == pytest.approx([0.20, 0.40], abs=1e-12)
    assert at(changed(text, (" 0.0 0.5 20000.", " 180d 0.5 20000.")), -3.15) == pytest.approx(0.41, abs=1e-12)


# Wheels on rails. In module 1 the first body is the rail.
OVER_RAIL = " 2\n -30d 0.15 0.15\n 0.0 0.30 0.30\n"
ON_ROLLERS = [(" 0203100 ", " 4203100 "), (" 1435.0 0.025 ", " 1435.0 750. "), (" 9000. 18. ", " 12. 18. ")]
MOTION = "VROLL VYAW VPITCH\n"


@pytest.mark.parametrize("changes, keys", [
    ([], {"rail.young_modulus": 2 * 70000.0 * 1.3, "wheel.young_modulus": 2 * 80000.0 * 1.28, "load.vertical_force": 45000.0,
          "wheel.rolling_radius": 450.0, "wheelset.side": "left", "wheelset.lateral_shift": 1.5, "wheelset.yaw": 0.003,
          "wheelset.roll": -0.0001, "wheelset.rotation_change": 0.001, "wheelset.lateral_velocity": 0.002,
          "wheelset.yaw_velocity": 1e-5, "track.inclination": 0.025, "wheel.profile": "../../wheel.csv",
          "wheel_profile.mirror": True, "wheel_profile.flip": True, "contact_grid.cell_size": [0.25, 0.2],
          "halfspace.surface": "planar", "rolling.extra_slip": "none"}),
    ([("'wheel.csv'", "'worn\\wheel.csv'")], {"wheel.profile": "../../worn/wheel.csv"}),
    ([(" 0022033 ", " 0042033 ")], {"halfspace.surface": "curved", "rolling.extra_slip": None}),
    # Friction over the inclination of the rail or along the track; a single point is everywhere.
    ([(" 0.25 0.25\n", OVER_RAIL), (" 0022033 ", " 1022033 ")],
     {"friction.inclination": [-math.pi / 6, 0.0], "friction.coefficient": [0.15, 0.3]}),
    ([(" 0.25 0.25\n", OVER_RAIL), (" -30d 0.15", " -200. 0.15"), (" 0022033 ", " 2022033 "), (" 0.0 1.5 45000.", " 125.0 1.5 45000.")],
     {"friction.track_position": [-200.0, 0.0], "wheelset.track_position": 125.0}),
    ([(" 0.25 0.25\n", " 1\n 0.0 0.25 0.25\n"), (" 0022033 ", " 1022033 ")], {"friction.coefficient": 0.25}),
    ([(" 0.25 0.25\n", " 2\n -30d 0.10 0.05 900. 0.0 1.0\n 0.0 0.2 0.1 1200. 0.02 80.\n 0.002 0.0\n"), (" 0022033 ", " 1422033 ")],
     {"friction.law": "exponential", "rolling.speed": 9000.0, "friction.memory_distance": 0.002,
      "friction.coefficient": [0.15, 0.32], "friction.half_velocity": [900.0, 1200.0],
      "friction.kinetic_coefficient": [0.1, 0.2], "friction.second_part": [0.0, 0.02]}),
    # RAILY0 and RAILZ0 stand where GAUGSQ and GAUGWD do.
    ([(" 14.5 0 1435.0", " 0.0 750. 0.2")], {"track.rail_position": [750.0, 0.2]}),
    ([(" 0203100 ", " 0203000 "), (" 0.0 1.5 45000. ", " 0.0 1.5 0.4 ")],
     {"load.vertical_force": None, "wheelset.height": 0.4, "wheelset.lateral_shift": 1.5}),
    # On rollers the last number of the track is NOMRAD, and VS the rate of the roller.
    (ON_ROLLERS, {"rail.rolling_radius": 750.0, "wheelset.side": "left", "wheelset.lateral_velocity": 0.002}),
    # Each body is displaced by itself; of the wheel the rotation is about the axle.
    ([("\n 0.0 0.0 0.0 0.0 0.0 0.0\n", "\n 0.5 0.1 0.02 9.0 0.0 0.0\n"), (" 0022033 ", " 0022035 "),
      (MOTION, MOTION + " 0.0 0.1 -0.2 0.01 0.0 0.0\n 0.0 0.0 0.0 0.0 0.0 -0.9\n")],
     {"rail_displacement.lateral": 0.5, "rail_displacement.roll": 0.02, "rail_displacement.lateral_velocity": 1e-3,
      "wheel_displacement.vertical": -0.2, "wheelset.vertical_velocity": 0.0}),
    # Tracks of old versions: GAUGWD, GAUGHT, CANT.
    ([(" 14.5 0 1435.0 0.025 ", " 1437.0 14.0 0.03 ")], {"track.gauge": 1437.0, "track.gauge_height": 14.0,
                                                         "track.inclination": 0.03})])
def test_keys_of_wheels(converted, changes, keys):
    (_, found, _), = converted(changed(WHEEL, *changes))
    expect(found, keys)


def test_wheels_are_not_smoothed_as_by_contact(converted):
    says(converted(changed(WHEEL, ("'rail.csv' 0 1.0 0.0", "'rail.csv' 0 1.0 0.6")))[0][2], "see rail_profile.smoothing")


def test_result_elements_keep_their_own_data(converted):
    """The second element begins with its own data; the third case goes on with the first one's."""
    first = changed(WHEEL, (" 1 module", " 1 1 module"), (" 0 module\n", ""))
    second = changed(WHEEL, (" 1 module", " 1 2 module"), (" 0203100 ", " 1203100 "), (" 1358.0 -70.0 450.0 ", " 1358.0 -70.0 400.0 "),
                     (" 0 module\n", ""))
    again = " 1 1 module\n 0203100 \n 0111001 \n 0100321 \n 0.0 2.5 45000. -0.0001 0.003 0.0\n 0 module\n"
    found = [(keys["wheel.rolling_radius"], keys["wheelset.lateral_shift"]) for _, keys, _ in converted(first + second + again)]
    assert found == [(450.0, 1.5), (400.0, 1.5), (450.0, 2.5)]


def turned(angle, axis):
    """Rotation about an axis of coordinates."""
    c, s, (i, j) = math.cos(angle), math.sin(angle), {2: (0, 1), 0: (1, 2)}[axis]
    matrix = np.eye(3)
    matrix[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
    return matrix


def test_displaced_wheels_move_as_in_contact(converted):
    """User guide, velocity of a place Q of the wheel: v_ws + omega_ws x (Q - O_ws) + v_w + omega_w x (Q - O_w), of the
    wheelset about its middle and of the wheel about its profile's origin O_w; here from the keys, about the displaced axle
    (docs/track.md). All of it in the axes of the wheelset, yawed by 30 mrad."""
    (_, found, _), = converted(changed(
        WHEEL, (" 0022033 ", " 0022035 "), (" 0.003 0.0 S Y", " 0.03 0.0 S Y"),
        (MOTION, MOTION + " 2.0 0.1 -0.2 0.001 0.02 0.0\n 90.0 180.0 -9.0 0.009 0.018 -0.9\n")))
    wheel = {name.partition(".")[2]: value for name, value in found.items() if name.startswith("wheel_displacement.")}
    speed, radius, turning = 9000.0, 450.0, 20.02 / 9000.0
    yawed, forward = turned(0.03, 2), np.array([1.0, 0.0, 0.0])
    axle = yawed @ [-math.sin(0.02), math.cos(0.02), math.sin(0.001)]
    ahead = yawed @ [math.cos(0.02), math.sin(0.02), 0.0]
    origin = yawed @ [2.0, -749.0 + 0.1, radius - 0.2]
    for away in np.eye(3) * [5.0, 8.0, -3.0], np.zeros((1, 3)):
        place = origin + away
        in_contact = (forward + np.cross(-turning * yawed @ [0, 1, 0], place) + yawed @ [90.0, 180.0, -9.0] / speed
                      + np.cross(yawed @ [0.009, -0.9, 0.018] / speed, away))
        here = (forward + np.cross(-(turning + wheel["rotation"]) * axle, away + radius * np.cross(ahead, axle))
                + [wheel[f"{name}_velocity"] for name in ("longitudinal", "lateral", "vertical")]
                + np.cross(wheel["roll_velocity"] * ahead + [0.0, 0.0, wheel["yaw_velocity"]], away))
        # To second order in the turns and in the velocities by them.
        assert np.linalg.norm(here - in_contact, axis=1).max() < 5e-5


def test_displaced_rollers_keep_their_axle(converted):
    """What the roller's surface is slower there (1 - z/R), the wheel is slower here, to second order in the yaw of 3 mrad."""
    (_, found, _), = converted(changed(WHEEL, *ON_ROLLERS, ("\n 0.0 0.0 0.0 0.0 0.0 0.0\n", "\n 0.0 0.3 0.02 0.0 0.0 0.0\n")))
    slower = found["wheel_displacement.longitudinal_velocity"] - 450.0 * found.get("wheel_displacement.rotation", 0.0)
    assert slower == pytest.approx(-0.3 / 750.0, abs=1e-9)
    assert found["wheel_displacement.yaw_velocity"] == pytest.approx(math.sin(0.02) / 750.0, abs=1e-12)


@pytest.mark.parametrize("cases, named", [("1", "case 1"), ("1,2", "cases 1, 2"), ("1-3", "cases 1 to 3")])
def test_numbers_of_cases_are_written_as_ranges(rollfem, cases, named):
    says(rollfem.done("convert", rollfem.file("a.inp", ELLIPSE), "--cases", cases).out, named)
