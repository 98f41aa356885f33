# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases with profiles from the command line: check prints the contacts of the wheels, run solves every patch of a lateral
sweep; wheels on crossings, above their rail and off it; contacts on the built-in rails."""

import math

import h5py
import numpy as np
import pytest
from program import SOURCE, TWO_POSITIONS, WHEEL_ON_RAIL, says

TWENTY_ACROSS = {"title": "two positions", "models": ["halfspace"]} | TWO_POSITIONS | {"contact_grid.elements_across": 20}
CYLINDER = {"wheel.rolling_radius": 460.0, "wheel.profile": "arcs", "wheel_profile.radii": [math.inf],
            "wheel_profile.ends": [-60.0, 60.0]}


def numbers(row):
    """The cells of a row that are numbers."""
    def number(cell):
        try:
            return float(cell)
        except ValueError:
            return cell
    return {name: number(cell) for name, cell in row.items()}


def test_check_tells_where_the_wheels_touch(rollfem):
    says(rollfem.done("check", rollfem.case(TWENTY_ACROSS)).out, "where wheel and rail touch", "UIC60-manchester",
         "y track mm")


def test_the_report_says_that_the_height_is_given_in_place_of_a_load(rollfem):
    rollfem.done("run", SOURCE / "cases/guard_rail.toml", "-o", "out", "--set", "contact_grid.elements_across=12", "--set",
                 "placement.lateral_position=85.4")
    says(rollfem.text("out/report.html"), "the height of the wheel is given")


def expect_one_resultant(contact, point):
    """Patch frame and track frame are turned about x: both pairs of forces have one resultant, and the pressure pushes a
    wheel to where its contact plane falls."""
    lateral, track, angle = contact["lateral_force"], contact["lateral_force_track"], contact["contact_angle"]
    assert math.hypot(track, contact["vertical_force"]) == pytest.approx(math.hypot(lateral, contact["normal_force"]),
                                                                         abs=1e-6)
    side = 1.0 if contact["wheel"] == "left" else -1.0
    assert track + lateral == pytest.approx(side * contact["normal_force"] * angle,
                                            abs=0.01 * contact["normal_force"] * angle)
    assert (point["lateral_force"], point["lateral_force_track"]) == (lateral, track)
    bars = point["error_estimate"]
    assert bars["lateral_force_track"] == pytest.approx(
        bars["normal_force"] * abs(math.sin(angle)) + bars["lateral_force"] * math.cos(angle), abs=1e-9)
    assert bars["lateral_force_track"] > 0


def test_run_solves_every_patch_and_row_has_one_line_a_position_with_both_wheels(rollfem):
    out = rollfem.done("run", rollfem.case(TWENTY_ACROSS), "-o", "out", "--no-report").out
    models = rollfem.models("out")
    assert len(models) == 4
    left = models[2]
    assert (left["place"]["wheel"], left["place"]["position"]) == ("left", 2)
    # CONTACT on this scene: 1011.2 MPa and 16.2 mm (wheelrail_left_patch.csv).
    assert left["points"][0]["max_pressure"] == pytest.approx(1011.2, rel=0.005)
    assert left["points"][0]["contact_width"] == pytest.approx(16.2, abs=0.4)
    says(out, "y rail mm")
    # The terminal shows one line per position, one per patch, and notes common to all patches once.
    for words in ("the wheelset, by halfspace at the first load point", "\n   2         2   ", "halfspace: error bars: ",
                  "(left wheel, position 1; values differ for 2 other patches)"):
        assert out.count(words) == 1, out
    assert out.count("\nleft ") + out.count("\nright") == 4
    first, second = map(numbers, rollfem.rows("out/wheelset.csv"))
    # In the middle of the track the wheels are mirror images: their forces to the side balance.
    assert first["left lateral_force_track"] == pytest.approx(-first["right lateral_force_track"], abs=0.01)
    assert first["left vertical_force"] == pytest.approx(100e3, abs=1.0)
    assert list(first.values())[4] == 1  # load points count from 1
    contacts = list(map(numbers, rollfem.rows("out/contacts.csv")))
    assert len(contacts) == 4
    for contact, model in zip(contacts, models):
        expect_one_resultant(contact, model["points"][0])
    assert second["radius_difference"] == pytest.approx(
        second["right rolling_radius"] - second["left rolling_radius"], abs=1e-9)
    assert second["wave_length"] == pytest.approx(
        2 * math.pi * math.sqrt(1500.0 * 450.0 / (2 * second["conicity_wave"])), abs=1e-6)
    assert rollfem.text("out/wheelset_rigid.csv").startswith("lateral_shift [mm],")
    # The patches of 100 kN are near where the rigid bodies touch.
    assert second["radius_difference"] == pytest.approx(second["rigid_radius_difference"], abs=0.2)


@pytest.mark.parametrize("side", ["left", "right"])
def test_stands_lower_under_load_by_the_approach(rollfem, side):
    # A cylinder on a rail of radius 300 mm: the approach by Hertz, vertically.
    rollfem.done("run", rollfem.case(CYLINDER | {
        "load.vertical_force": 80e3, "friction.coefficient": 0.0, "rail.profile": "arcs", "rail_profile.radii": [300.0],
        "rail_profile.ends": [36.0], "rail_profile.symmetric": True, "placement.side": side,
        "rolling.problem": "frictionless", "contact_grid.elements_across": 40}),
        "-o", "a", "-m", "hertz", "halfspace", "--no-report")
    models = rollfem.models("a")
    hertz, solved = (model["points"][0] for model in models)
    assert hertz["loaded_height"] == pytest.approx(models[0]["place"]["height"] + hertz["approach"], abs=1e-12)
    bar = solved["error_estimate"]["loaded_height"]
    assert bar == solved["error_estimate"]["approach"] < 1e-3 * hertz["approach"]
    assert solved["loaded_height"] == pytest.approx(hertz["loaded_height"], abs=max(bar, 1e-4 * hertz["approach"]))


@pytest.mark.parametrize("side, shift", [("left", -5.0), ("right", 5.0)])
def test_at_its_loaded_height_carries_its_load(rollfem, side, shift):
    # The load is a result where the height is given: on the root of S1002.
    at = WHEEL_ON_RAIL | {"wheelset.side": side, "wheelset.lateral_shift": shift, "wheelset.roll": 0.0,
                          "friction.coefficient": 0.0, "rolling.problem": "frictionless", "contact_grid.elements_across": 12}
    how = "-m", "halfspace", "--no-report"
    rollfem.done("run", rollfem.case(at), "-o", "a", *how)
    contact, = map(numbers, rollfem.rows("a/contacts.csv"))
    height = contact["loaded_height"]
    assert contact["contact_angle"] > 0.05 and height > contact["height"]
    rollfem.done("run", rollfem.case(at | {"load.vertical_force": None, "wheelset.height": height}), "-o", "b", *how)
    point = rollfem.point("b")
    assert point["vertical_force"] == pytest.approx(100e3, abs=1e2)
    assert point["loaded_height"] == pytest.approx(height, abs=1e-4)
    assert point["no_bar"]["loaded_height"] == "given"


def test_without_a_free_rotation_the_key_is_named(rollfem):
    in_metres = WHEEL_ON_RAIL | {"wheel.rolling_radius": 0.46, "wheelset.side": "both", "wheelset.free_rolling": "torque"}
    outcome = rollfem.call("run", rollfem.case(in_metres), "-o", "out", "-m", "halfspace")
    assert outcome.status == 1
    says(outcome.err, 'case.toml: wheelset.free_rolling = "torque": no rotation_change',
         "do: check wheel.rolling_radius = 0.46 mm")


def test_a_wheel_above_its_rail_carries_nothing(rollfem):
    def at(heights):
        return rollfem.case({"models": ["halfspace"], "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0,
                             "wheel.profile": "S1002", "rail.profile": "60E1", "placement.side": "right",
                             "placement.height": heights, "contact_grid.elements_across": 10, "output.fields": False})

    both = rollfem.done("run", at([-0.4, -0.6]), "-o", "out", "--no-report")
    says(both.out, "warning: position 2: the right wheel is 0.1009 mm above its rail")
    point = rollfem.point("out")
    assert point["vertical_force"] > 1e3 and point["error_estimate"]["vertical_force"] > 0
    says(rollfem.done("run", at(-0.6), "-o", "none").out, "carries no load")
    assert rollfem.models("none") == []


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_load_moves_from_the_wing_to_the_nose_of_a_crossing(rollfem, side):
    crossing = SOURCE / "cases/crossing.toml"
    check = rollfem.done("check", crossing)
    says(check.out, "where wheel and rail touch")
    assert check.err == ""
    out = rollfem.done("run", crossing, "-o", "out", "--set", "contact_grid.elements_across=8", "--set", f'placement.side="{side}"', "--set",
                       "placement.track_position=[50.0, 80.0, 110.0]").out
    says(out, "along mm", "height mm")
    assert "shift mm" not in out and "lateral mm" not in out  # the same at every position
    at, down = zip(*((float(row["track_position"]), float(row[f"{side} loaded_height"])) for row in rollfem.rows("out/wheelset.csv")))
    dip = 1e3 * ((down[1] - down[0]) / (at[1] - at[0]) + (down[1] - down[2]) / (at[2] - at[1]))
    says(out, f"{side} wheel: lowest at 80 mm, {down[1]:.3f} mm down; dip angle {dip:.2f} mrad")
    stored, = rollfem.json("out/summary.json")["dips"]
    assert stored == {"model": "halfspace", "wheel": side, "track_position": 80.0, "loaded_height": pytest.approx(down[1], rel=1e-9),
                      "dip_angle": pytest.approx(1e-3 * dip, rel=1e-6)}
    with h5py.File(rollfem.work / "out/results.h5") as file:
        for position in (1, 3):  # each on the section of the rail where the wheel is
            rail, wheel = (np.array(sorted(file[f"profiles/{side}_{position}/{part}"][()].tolist())) for part in ("rail", "wheel"))
            apart = np.interp(rail[:, 0], *rail.T) - np.interp(rail[:, 0], *wheel.T)
            assert min(apart) == pytest.approx(0.0, abs=0.03), position
    contacts = list(map(numbers, rollfem.rows("out/contacts.csv")))
    assert len(contacts) == 4
    wing, nose = ({each["track_position"]: each["vertical_force"] for each in contacts if (each["y_rail"] > 40) == on_wing}
                  for on_wing in (True, False))
    for each in contacts:
        if each["y_rail"] <= 40:  # the nose rises by 1:120 and is met ahead of the axle, the wing is met behind it
            assert each["climb"] == pytest.approx(1 / 120, abs=1e-4)
            assert each["x_track"] == pytest.approx(461.3 / 120, abs=0.1)
    assert [wing[50.0], wing[80.0] + nose[80.0], nose[110.0]] == pytest.approx([80e3] * 3, abs=80.0)
    assert min(wing[80.0], nose[80.0]) > 15e3
    rows = rollfem.rows("out/wheelset.csv")
    assert len(rows) == 3 and (rows[1]["track_position"], rows[1][f"{side} patches"]) == ("80", "2")
    says(rollfem.text("out/report.html"), "position along the track [mm]", "followed from position to position",
         "contact at y = 64 to 65 mm on the rail")
    says(rollfem.text("out/figures/positions.svg"), "height of the wheel")


def test_a_wheel_off_the_rail_is_reported_in_one_line(rollfem):
    outcome = rollfem.call("run", rollfem.case(TWENTY_ACROSS | {"wheelset.lateral_shift": -60.0}), "-o", "out")
    assert outcome.status == 1
    says(outcome.err, "wheelset.lateral_shift = -60")
    assert not rollfem.holds("out")


def contacts_on(rollfem, rail, inclination, wheel):
    """The left and the right contact on a rail of this name."""
    rollfem.done("run", rollfem.case(wheel | {
        "load.vertical_force": 10e3, "friction.coefficient": 0.3, "rail.profile": rail, "track.inclination": inclination,
        "wheelset.side": "both", "rolling.longitudinal_creepage": 0.001}), "-o", "out", "--no-report")
    found = list(map(numbers, rollfem.rows("out/contacts.csv")))
    assert len(found) == 2
    return found


@pytest.mark.parametrize("rail, radius", [("60E2", 200.0), ("54E1", 300.0), ("56E1", 305.0)])
def test_a_cylinder_on_the_crown_is_hertzs(rollfem, rail, radius):
    """The band of the crown's radius is wider than the patch."""
    found = contacts_on(rollfem, rail, "none", CYLINDER)
    rollfem.done("run", rollfem.case({
        "models": ["hertz"], "load.normal_force": 10e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0,
        "wheel.transverse_radius": math.inf, "rail.transverse_radius": radius, "rolling.longitudinal_creepage": 0.001}),
        "-o", "hertz", "--no-report")
    hertz = numbers(rollfem.rows("hertz/creep_curve.csv")[0])
    for contact in found:
        assert contact["y_rail"] == pytest.approx(0.0, abs=1e-9)
        for size in "max_pressure", "contact_length", "contact_width":
            assert contact[size] == pytest.approx(hertz[size], abs=contact[f"error_estimate {size}"])


@pytest.mark.parametrize("rail", ["60E2", "54E1", "56E1"])
def test_s1002_touches_left_and_right_alike_within_one_percent(rollfem, rail):
    left, right = contacts_on(rollfem, rail, "1:40", {"wheel.rolling_radius": 460.0, "wheel.profile": "S1002"})
    for name in "y_rail", "y_wheel", "max_pressure", "longitudinal_force":
        assert left[name] == pytest.approx(right[name], abs=1e-6 * (1 + abs(left[name])))
    assert left["lateral_force"] == pytest.approx(-right["lateral_force"], abs=1e-3)
    assert left["error_estimate max_pressure"] < 0.01 * left["max_pressure"]
