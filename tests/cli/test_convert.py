# SPDX-License-Identifier: LGPL-2.1-or-later
"""convert: from an input file of CONTACT to a result with a known closed form."""

import math

import pytest
from profiles import columns, points_of
from program import SOURCE, says

BALL, ELLIPSE, ROLLER, PUSHED_ELLIPSE, LEFT_WHEEL = (
    (SOURCE / f"tests/support/contact/{name}.inp").read_text()
    for name in ("pushed_ball", "rolling_ellipse", "driven_roller", "pushed_ellipse", "left_wheel"))


def replaced(text, piece, by):
    assert piece in text
    return text.replace(piece, by, 1)


# The ball, pressed on in a second step: by Hertz the patches are 0.156 and 1.96 mm across, 2 and 26 elements of 0.075 mm.
PRESSED_TWICE = replaced(replaced(BALL, " 20.0  -0.5", " 0.01 -0.5"), " 0 module",
                         " 3\n 001120\n 100000\n 0011111\n 200 100 30 1 1d-6\n 20.0 -0.5 0.0 0.0\n 0\n")
PUSHED_THEN_ROLLED = replaced(BALL, " 0 module", " 3 module\n 002100\n 102000\n 0111341\n 20.0 0.0001 0.0 0.0\n"
                              " 0.0 0.1 1000.\n 0.25 0.25 300. 300.\n 0 module")
USUAL_WHEEL = replaced(LEFT_WHEEL, "'wheel.csv' 1 1.0 0.0 1", "'wheel.csv' 0 1.0 0.0")


def test_a_pushed_ball_has_the_shift_of_cattaneo_and_mindlin(rollfem):
    made = rollfem.done("convert", rollfem.file("ball.inp", BALL))
    assert made.err == "" and made.out.startswith("ball_cases/ball.toml: case 1\n")
    rollfem.done("run", "ball_cases/ball.toml", "-o", "out", "--no-report")
    point = rollfem.point("out")
    # Hertz: R = 25 mm, E* = G / (1 - nu). Mindlin: shift for a force of half of mu F_z.
    force, shear, nu, mu = 20.0, 300.0, 0.25, 0.3
    radius = (0.75 * force * 25.0 * (1 - nu) / shear) ** (1 / 3)
    shift = 3 * mu * force * (2 - nu) / (8 * shear * radius) * (1 - 0.25 ** (1 / 3))
    assert point["max_pressure"] == pytest.approx(1.5 * force / (math.pi * radius**2), rel=0.002)
    assert point["longitudinal_force"] == pytest.approx(-0.5 * mu * force, abs=1e-5 * mu * force)
    assert point["longitudinal_shift"] == pytest.approx(shift, rel=0.005)


def test_writes_the_others_when_told_to(rollfem):
    file = rollfem.file("two.inp", replaced(
        ELLIPSE, " 0\n", " 3\n 203100\n 000000\n 0101341\n 40000. 0.002 0. 0.\n 0.4 0.3\n 0\n"))
    refused = rollfem.call("convert", file, "-o", "made")
    assert refused.status == 2 and rollfem.made() == []
    says(refused.err, "case 4: no equivalent: FSTAT = 0.4 and FKIN = 0.3 differ", "convert the others with --partial")
    rollfem.done("convert", file, "-o", "made", "--partial")
    assert rollfem.made() == ["made", "made/two_1.toml"]
    rollfem.done("check", "made/two_1.toml")
    # Never overwrites a file.
    again = rollfem.call("convert", file, "-o", "made", "--partial")
    assert again.status == 2 and len(rollfem.made()) == 2
    says(again.err, "made/two_1.toml exists already")


def test_takes_the_cases_that_are_named(rollfem):
    file = rollfem.file("roll.inp", ELLIPSE)
    assert rollfem.done("convert", file, "--cases", "2-3").out.startswith("roll_cases/roll_2.toml: cases 2, 3\n")
    rollfem.done("convert", file, "--cases", "3,1", "-o", "other")
    for number in 1, 3:  # not consecutive: a file each
        assert rollfem.text(f"other/roll_{number}.toml").startswith(f"# Made by rollfem convert of roll.inp, case {number}")


@pytest.mark.parametrize("cases, said", [
    ("4", "--cases 4: 4: there is no case 4; allowed: numbers and ranges from 1 to 3"),
    ("1-9", "there is no case 9"), ("0", "there is no case 0"), ("3-1", "the range runs backwards"),
    ("1;2", "1;2: not a number or a range")])
def test_cases_that_are_not_there_are_refused(rollfem, cases, said):
    rollfem.refuses("convert", rollfem.file("roll.inp", ELLIPSE), "-o", "wrong", "--cases", cases, says=said)
    assert rollfem.made() == []


def test_few_elements_are_solved_with_a_warning(rollfem):
    says(rollfem.done("convert", rollfem.file("press.inp", PRESSED_TWICE)).out, "press_cases/press.toml: cases 1, 2",
         "note: the patch is only 2 by 2 elements")
    run = rollfem.done("run", "press_cases/press.toml", "-o", "out", "--no-report")
    says(run.err + run.out, "warning: the patch has only 2 by 2 of the elements")
    # Four elements carry alike.
    assert rollfem.point("out")["max_pressure"] == pytest.approx(0.01 / (4 * 0.075**2), abs=1e-6)


def test_the_history_of_cases_left_out_is_missed(rollfem):
    file = rollfem.file("press.inp", replaced(PRESSED_TWICE, " 0.01 -0.5", " 10.0 -0.5"))
    rollfem.done("convert", file)
    made = rollfem.call("convert", file, "-o", "second", "--cases", "2")
    assert made.status == 2
    says(made.err, "the case continues case 1, which --cases leaves out")


def test_a_pointwise_distance_is_read(rollfem):
    rollfem.done("convert", rollfem.file("turned.inp", replaced(BALL, "0.02 0.0 0.02\n 0.0 0.0", "0.02 0.004 0.02\n 0.0 0.0")),
                 "-o", ".")
    rollfem.done("run", "turned.toml", "-o", "out", "--no-report")
    # An ellipse at 45 degrees: the principal curvatures are those on the diagonals.
    body = {"young_modulus": 750.0, "poisson_ratio": 0.25}
    rollfem.done("run", rollfem.case({"load.normal_force": 20.0, "friction.coefficient": 0.3}
                                     | {f"{name}.{key}": value for name in ("wheel", "rail") for key, value in body.items()}
                                     | {"undeformed_distance.quadratic": [0.022, 0.018]}),
                 "-m", "hertz", "-o", "hertz", "--no-report")
    assert rollfem.point("out")["max_pressure"] == pytest.approx(rollfem.point("hertz")["max_pressure"], rel=0.003)


@pytest.mark.parametrize("text", [
    BALL, ELLIPSE, replaced(ELLIPSE, "40000. 0.0008", "40000. 0.0004"), ROLLER, PUSHED_ELLIPSE, PUSHED_THEN_ROLLED,
    PRESSED_TWICE], ids="ball ellipse twice roller pushed_ellipse rolled pressed".split())
def test_check_accepts_converted_cases(rollfem, text):
    rollfem.done("convert", rollfem.file("a.inp", text), "--partial", "-o", "made")
    made, = rollfem.work.glob("made/*.toml")
    rollfem.done("check", made)


@pytest.fixture
def wheel(rollfem):
    """Profiles of our own beside an input of the left wheel."""
    def write(text, of_rail=lambda y, z: (y, z), more=lambda points: points):
        rollfem.file("work/wheel.csv", columns(more(points_of("S1002"))))
        rollfem.file("work/rail.csv", columns([of_rail(y, z) for y, z in points_of("60E1")]))
        return rollfem.file("work/wheel.inp", text)
    return write


def test_elements_that_are_too_few_are_halved(rollfem, wheel):
    rollfem.done("convert", wheel(USUAL_WHEEL), "-o", "usual")
    says(rollfem.text("usual/wheel.toml"), "cell_size = [0.25, 0.2] ")
    made = rollfem.done("convert", wheel(replaced(USUAL_WHEEL, " 0.25 0.2 ", " 2.5 0.2 ")), "-o", "few")
    says(made.out, "note: elements of 1.25 by 0.2 mm instead of DX by DS")
    says(rollfem.text("few/wheel.toml"), "cell_size = [1.25, 0.2] ", "# note: elements")
    rollfem.done("run", "few/wheel.toml", "-o", "out", "--no-report")


def test_points_of_profiles_are_repaired_with_a_note(rollfem, wheel):
    # A rail whose heights point up and a wheel that repeats a point.
    file = wheel(USUAL_WHEEL, of_rail=lambda y, z: (y, -z), more=lambda points: [*points[:51], *points[50:]])
    says(rollfem.done("convert", file, "-o", "made").out,
         "note: points of the profile of the rail are repaired: flip = true",
         "note: points of the profile of the wheel are repaired: drop_duplicates = true")
    says(rollfem.text("made/wheel.toml"), "\n[rail_profile]\n", "\nflip = true\n",
         "\n[wheel_profile]\ndrop_duplicates = true\n")
    rollfem.done("check", "made/wheel.toml")


def test_profiles_that_are_not_there_are_warned_of(rollfem):
    says(rollfem.done("convert", rollfem.file("wheel.inp", LEFT_WHEEL)).err,
         "warning: the profile rail.csv does not exist", "warning: the profile wheel.csv does not exist")


def test_files_that_are_no_input_are_refused(rollfem):
    rollfem.refuses("convert", "none.inp", says="none.inp")
    rollfem.refuses("convert", rollfem.file("text.inp", "hello\n"), says="is not an input file of CONTACT")
    assert rollfem.made() == []
