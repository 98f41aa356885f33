# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a case file becomes: its keys as the program has read them, and the load points, motions and loads that follow, seen in
results. Case files that are refused: tests/refusals."""

import json
import math
import tomllib

import numpy as np
import pytest
from program import SMALL, WHEEL_ON_RAIL, package, rolling, says, solved, toml

EIGHT = SMALL | {"contact_grid.elements_across": 8}
PLACED = {"friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.profile": "S1002", "rail.profile": "60E1"}
OVER_RAIL = PLACED | {"load.normal_force": 50e3, "track.inclination": "1:40", "rolling.speed": 10e3, "friction.law": "linear",
                      "friction.coefficient": [0.1, 0.4, 0.2], "friction.kinetic_coefficient": [0.05, 0.2, 0.1],
                      "friction.half_velocity": 500.0, "friction.inclination": [-1.2, -0.4, 0.0]}
WINDOWS = ("load.normal_force = 1_000\r\nfriction = {coefficient = 0.3}\r\nwheel.rolling_radius = 405\r\n"
           "wheel.transverse_radius = inf\r\nrail.transverse_radius = 300\r\n[rolling]\r\n"
           "longitudinal_creepage = [ # braking\r\n 0.0,\r\n 0.001,\r\n]\r\n")


def inclined(inclination):
    return WHEEL_ON_RAIL | {"track.inclination": inclination}


@pytest.mark.parametrize("content, keys", [
    (SMALL, {"load.normal_force": 50e3, "wheel.transverse_radius": "inf", "rail.young_modulus": 210e3, "wheel.poisson_ratio": 0.3,
             "rolling.upwind_order": "second", "rolling.extra_slip": "auto", "contact_grid.elements_across": 40, "fem.degree": 2,
             "output.paths": ["x", "y"], "output.fields": True}),
    (WINDOWS, {"load.normal_force": 1000.0, "friction.coefficient": 0.3, "rolling.longitudinal_creepage": [0.0, 0.001]}),
    (SMALL | {"output.paths": []}, {"output.paths": []}),
    (SMALL | {"title": 'quoted: "x"', "rail.transverse_radius": 250, "friction.coefficient": 0, "fem.cell_size": 0.5},
     {"title": 'quoted: "x"', "rail.transverse_radius": 250, "friction.coefficient": 0.0, "fem.cell_size": 0.5}),
    # Standard gauge; inclinations are tangents or angles.
    (WHEEL_ON_RAIL, {"track.gauge": 1435.0, "track.gauge_height": 14.0, "wheelset.flange_back_distance": 1360.0,
                     "wheelset.flange_back_position": -70.0, "track.inclination": "1:40"}),
    (inclined("none"), {"track.inclination": "none"}), (inclined(0.05), {"track.inclination": 0.05}),
    (inclined(-0.01), {"track.inclination": -0.01}),
    (WHEEL_ON_RAIL | {"wheelset.lateral_shift": [0.0, 1.0, 2.0], "wheelset.yaw": 0.001, "wheelset.roll": [0.0, 1e-4, 2e-4],
                      "wheelset.rotation_change": [-0.001, 0.001], "rolling.lateral_creepage": 0.002},
     {"wheelset.yaw": [0.001], "wheelset.roll": [0.0, 1e-4, 2e-4], "wheelset.rotation_change": [-0.001, 0.001]}),
    (WHEEL_ON_RAIL | {"wheelset.side": "both", "wheelset.free_rolling": "torque"},
     {"wheelset.side": "both", "wheelset.free_rolling": "torque"}),
    (PLACED | {"placement.side": "right", "placement.lateral_position": [1.0, 2.0], "placement.height": 0.1},
     {"placement.side": "right", "placement.height": [0.1], "placement.lateral_position": [1.0, 2.0]}),
    (OVER_RAIL, {name: value for name, value in OVER_RAIL.items() if name.startswith("friction.")}),
    (SMALL | {"geometry.shape": "line", "geometry.relative_radius": 25.0, "wheel.transverse_radius": None,
              "wheel.rolling_radius": None, "rail.transverse_radius": None},
     {"geometry.shape": "line", "geometry.width": 1.0, "geometry.relative_radius": 25.0})])
def test_keys_have_their_values_and_defaults(rollfem, content, keys):
    found = json.loads(rollfem.done("check", "--json", rollfem.case(content)).out)["keys"]
    assert {name: found.get(name) for name in keys} == keys


def test_check_tells_values_units_defaults_and_what_follows(rollfem):
    out = rollfem.done("check", "--all", rollfem.case(SMALL | {"rail.young_modulus": 210000.0})).out
    # E* = 210000 / (2 (1 - 0.09)), G = 210000 / 2.6; a given value is no default even where it equals one.
    says(out, "normal_force           50000 N\n", "young_modulus          210000 MPa  (default)", "young_modulus          210000 MPa\n",
         "A                      0.00123457 1/mm", "B                      0.00025 1/mm", "E*                     115385 MPa",
         "G                      80769.2 MPa")
    assert "approach  " not in out
    says(rollfem.done("check", "--all", rollfem.case(WHEEL_ON_RAIL | {"wheelset.lateral_shift": [0.0, 1.0]})).out, "[track]", '"1:40"',
         "1435", "[wheelset]", "[0, 1]", "vertical_force", "both wheels touch their rails")
    says(rollfem.done("check", "--all", rollfem.case(EIGHT | {"rolling.longitudinal_force": [-1e3, math.nan],
                                                     "rolling.longitudinal_creepage": [0.7, 0.001]})).out, "[-1000, nan]")
    pressed = {"load.max_pressure": 1e3, "load.normal_force": None}
    says(rollfem.done("check", "--all", rollfem.case(SMALL | pressed)).out, "load.max_pressure by Hertz")


@pytest.fixture
def points(tmp_path):
    """The load points of a case."""
    def solve(keys, model="halfspace"):
        (tmp_path / "case.toml").write_text(toml(keys))
        return package().solve(tmp_path / "case.toml", model=model).points
    return solve


def values(points, *names):
    return [[point[name] for point in points] for name in names]


@pytest.mark.parametrize("curve", [{"rolling.spin": [1e-4, 2e-4, 3e-4], "rolling.longitudinal_creepage": 0.01},
                                   {"rolling.longitudinal_creepage": [0.01], "rolling.spin": [1e-4, 2e-4, 3e-4]}])
def test_numbers_serve_all_load_points_whatever_the_order_of_the_lists(points, curve):
    found = values(points(EIGHT | curve, "linear"), "longitudinal_creepage", "lateral_creepage", "spin")
    assert found == [[0.01] * 3, [0.0] * 3, [1e-4, 2e-4, 3e-4]]


def test_shifts_of_a_history_add_up(points):
    found = values(points(EIGHT | {"rolling.problem": "shift", "history.longitudinal_shift": [0.001, -0.002, 0.0],
                                   "history.spin_shift": 1e-4}), "step", "longitudinal_shift", "spin_shift")
    assert found[0] == [1, 2, 3]
    assert np.allclose(found[1:], [[0.001, -0.001, -0.001], [1e-4, 2e-4, 3e-4]], rtol=1e-12, atol=0)


def test_the_number_of_steps_stretches_numbers(points):
    found = points(EIGHT | {"rolling.problem": "transient", "rolling.lateral_creepage": 0.002, "rolling.longitudinal_force": -1e3,
                            "history.step_length": 0.5, "history.steps": 4})
    assert values(found, "lateral_creepage", "distance") == [[0.002] * 4, [0.5, 1.0, 1.5, 2.0]]
    assert values(found, "longitudinal_force")[0] == pytest.approx([-1e3] * 4, abs=1.0)


def test_loads_of_steps_are_solved_on_the_grid_of_the_largest(points):
    found = points(EIGHT | {"load.normal_force": None, "rolling.problem": "shift", "history.normal_force": [1e3, 3e4, 2e4],
                            "contact_grid.elements_across": 20})
    assert values(found, "normal_force")[0] == pytest.approx([1e3, 3e4, 2e4], rel=1e-6)


def test_loads_without_friction_are_steps_that_nothing_shifts(points):
    loads = EIGHT | {"load.normal_force": None, "history.normal_force": [1e3, 3e4, 2e4], "contact_grid.elements_across": 10}
    without, none = (points(loads | {"rolling.problem": problem, "friction.coefficient": mu})
                     for problem, mu in (("frictionless", 0.3), ("shift", 0.0)))
    assert values(without, "step", "normal_force", "max_pressure") == values(none, "step", "normal_force", "max_pressure")


def test_forces_are_prescribed_at_every_load_point_that_has_one(points):
    found = points(EIGHT | {"rolling.longitudinal_force": [-1e3, -2e3], "rolling.lateral_creepage": 0.001})
    assert values(found, "longitudinal_force")[0] == pytest.approx([-1e3, -2e3], abs=1.0)
    assert values(found, "lateral_creepage") == [[0.001, 0.001]]
    # nan leaves a load point to its creepage.
    found = points(EIGHT | {"rolling.longitudinal_force": [-1e3, math.nan], "rolling.longitudinal_creepage": [0.7, 0.001]})
    assert found[0].longitudinal_force == pytest.approx(-1e3, abs=1.0) and 0 < found[0].longitudinal_creepage < 0.01
    assert found[1].longitudinal_creepage == 0.001


def test_a_given_pressure_has_force_or_pressure_and_needs_no_radii(points):
    ellipse = {"friction.coefficient": 0.3, "given_pressure.semi_axis_x": 6.0, "given_pressure.semi_axis_y": 3.0}
    assert points(ellipse | {"load.normal_force": 82e3}, "hertz")[0].max_pressure == pytest.approx(1.5 * 82e3 / (math.pi * 18))
    assert points(ellipse | {"given_pressure.max_pressure": 1e3}, "hertz")[0].normal_force == pytest.approx(2e3 / 3 * math.pi * 18)


def test_a_largest_pressure_is_that_of_hertz(points):
    """2/3 pi a^2 p0 with a = pi p0 R/(2 E*), R = 100 mm."""
    point, = points({"load.max_pressure": 1e3, "friction.coefficient": 0.3, "undeformed_distance.quadratic": [0.005, 0.005]}, "hertz")
    a = 0.5 * math.pi * 1e5 / (210e3 / (2 * 0.91))
    assert point.normal_force == pytest.approx(2e3 / 3 * math.pi * a * a, rel=1e-12)


def test_distance_and_slip_of_files_are_found_beside_the_case(points, tmp_path):
    """A distance of parabolas is that of their coefficients, a slip of rotation that of spin."""
    lattice = [(x, y) for y in range(-12, 13) for x in range(-12, 13)]
    (tmp_path / "h.csv").write_text("".join(f"{x},{y},{0.01 * x * x + 0.02 * y * y!r}\n" for x, y in lattice))
    (tmp_path / "slip.csv").write_text("".join(f"{x},{y},{-1e-4 * y!r},{1e-4 * x!r}\n" for x, y in lattice))
    given = {"load.normal_force": 1e4, "friction.coefficient": 0.3, "contact_grid.cell_size": [0.5, 0.5],
             "contact_grid.extent": [12.0, 10.0], "rolling.longitudinal_creepage": 0.001}
    by_file, = points(given | {"undeformed_distance.file": "h.csv", "rolling.extra_slip": "file", "rolling.extra_slip_file": "slip.csv"})
    by_keys, = points(given | {"undeformed_distance.quadratic": [0.01, 0.02], "rolling.spin": 1e-4})
    for name in "max_pressure", "longitudinal_force", "lateral_force":
        assert by_file[name] == pytest.approx(by_keys[name], rel=1e-6), name


def test_points_below_the_surface_come_in_the_order_of_the_kinds(points):
    line = {"from": [0, 0, 0.1], "to": [0, 0, 5], "points": 50}
    found = points(EIGHT | {"subsurface.line": [line, {"body": "rail", "from": [0, 0, 0], "to": [1, 0, -1], "points": 3}],
                            "subsurface.point": [{"body": "rail", "at": [1, 2, -3]}],
                            "subsurface.plane": [{"from": [0, 0, 1], "to": [2, 0, 1], "across": [0, 2, 1], "points": [3, 4]}]})
    parts = {len(part["points"]): part["points"] for part in found[0].subsurface}
    assert sorted(parts) == [1, 3, 12, 50]
    assert parts[1].tolist() == [[1, 2, -3]] and parts[3][-1].tolist() == [1, 0, -1] and parts[12][-1].tolist() == [2, 2, 1]


def friction_law(tmp_path, keys):
    """Coefficients of the law over the slip velocity."""
    (tmp_path / "case.toml").write_text(toml(SMALL | {"friction.coefficient": 0.4, "rolling.speed": 10e3} | keys))
    return package().solve(tmp_path / "case.toml", model="hertz").friction_law


def test_polachs_spelling_is_the_exponential_law(tmp_path):
    given = friction_law(tmp_path, {"friction.law": "exponential", "friction.kinetic_coefficient": 0.2,
                                    "friction.half_velocity": 900.0})
    polach = friction_law(tmp_path, {"friction.law": "exponential", "friction.polach_a": 0.5, "friction.polach_b": 0.7701635339554948})
    assert np.allclose(given, polach, rtol=1e-12)


def test_a_layer_may_yield_without_being_elastic(points):
    """At full sliding the tractions are those of the yield stress, where friction would bear more."""
    slides = SMALL | {"layer.yield_stress": 100.0, "layer.hardening": 0.0} | rolling(0.05, 16)
    assert points(slides)[0].max_traction == pytest.approx(100.0, rel=1e-6)


# Keys changed in the text of a file.
WRITTEN = """title = "a wheel"   # told

[load]
normal_force = 50e3  # N

[wheel]
rolling_radius = 460.0
transverse_radius = inf
[rail]
transverse_radius = 300.0

[rolling]
longitudinal_creepage = [
  0.0,  # none
  0.001,
]
[friction]
coefficient = 0.3
"""


def edited(folder, *changes, text=WRITTEN):
    """The text of a case read with changes as of --set."""
    file = folder / "case.toml"
    file.write_text(text, "utf-8")
    return package()._core.read_case(str(file), list(changes)).text


@pytest.mark.parametrize("changes, piece, other", [
    (["load.normal_force=80e3"], "50e3", "80e3"), ([" load.normal_force = 7.5e4 "], "50e3", "7.5e4"),
    (["title=worn"], '"a wheel"', '"worn"'), (["title='one word, or two'"], '"a wheel"', "'one word, or two'"),
    (['title="60 E1"'], '"a wheel"', '"60 E1"'),
    (["rolling.longitudinal_creepage=[0.002]", "friction.coefficient=0.25"],
     "[\n  0.0,  # none\n  0.001,\n]\n[friction]\ncoefficient = 0.3", "[0.002]\n[friction]\ncoefficient = 0.25")])
def test_a_change_replaces_a_value_and_nothing_else(tmp_path, changes, piece, other):
    assert edited(tmp_path, *changes) == WRITTEN.replace(piece, other)


def test_a_change_adds_keys_and_sections(tmp_path):
    case = tomllib.loads(edited(tmp_path, "wheel.round_to=0.5", "accuracy=0.01", "output.fields=false"))
    assert (case["wheel"]["round_to"], case["accuracy"], case["output"]["fields"]) == (0.5, 0.01, False)
    dotted = ("friction.coefficient = 0.3\nload.normal_force = 1e4\nwheel.rolling_radius = 460.0\n"
              "wheel.transverse_radius = inf\nrail.transverse_radius = 300.0\n")
    assert edited(tmp_path, "wheel.round_to=0.5", text=dotted) == dotted.replace("wheel.", "wheel.round_to = 0.5\nwheel.", 1)


@pytest.mark.parametrize("change, said", [
    ("friction.coefficient", "expected KEY=VALUE"), ("friction.coefficent=0.3", "friction.coefficent is not a key"),
    ("friction.coefficent=0.3", "did you mean `coefficient`?"), ("friction.coefficient=much", "expected a number"),
    ("friction.coefficient=-1", "is out of bounds"), ("friction.coefficient=", "the value is missing"),
    ("friction.coefficient=[", "not a value in TOML"), ("width=2", "do: write geometry.width or fem.width"),
    ("subsurface.line.points=3", "do: change it in the case file"), ('title="a"\n[load]', "--set"), ("title=\x7f", "--set")])
def test_wrong_changes_are_refused_as_the_words_of_a_call(tmp_path, change, said):
    with pytest.raises(package().InputError) as refused:
        edited(tmp_path, change)
    says(str(refused.value), "--set ", said)


def test_a_file_that_cannot_be_changed_is_refused_with_its_line(tmp_path):
    for text, change, said in (("x = \n", "load.normal_force=1", "case.toml:1"),
                               ("load = {normal_force = 1e4}\n", "load.approach=0.1", "case.toml:1: load: the section is an inline table")):
        with pytest.raises(package().InputError, match=said):
            edited(tmp_path, change, text=text)


# Grids that cannot hold or resolve the patch, before any iteration fails to converge on them.
@pytest.mark.parametrize("grid, said", [
    *(({"contact_grid.extent": extent}, "contact_grid.extent")
      for extent in ([1e-6, 2.65e8], [2.65e8, 1e-6], [20.0, 2.65e8], [1e9, 1e9], [1e-6, 1e-6])),
    ({"contact_grid.extent": [20.0, 50.0], "contact_grid.middle": [20.0, 0.0]}, "contact_grid.extent"),
    ({"contact_grid.middle": [1e6, 0.0]}, "contact_grid.extent"),
    *(({"contact_grid.cell_size": size}, "contact_grid.cell_size") for size in ([1e-6, 1e6], [1e6, 1e-6], [1e-6, 1e-6], [0.001, 2.0]))])
def test_extreme_grids_are_refused_at_once(grid, said):
    with pytest.raises(package().InputError, match=said):
        solved(SMALL | grid, model="halfspace")


@pytest.mark.parametrize("grid", [
    {"contact_grid.extent": [10.0, 25.0], "contact_grid.middle": [0.5, -0.5], "contact_grid.cell_size": [0.5, 1.0]},
    {"contact_grid.cell_size": [0.1, 2.0]}, {"contact_grid.middle": [1.0, 0.0], "contact_grid.elements_across": 10}])
def test_grids_that_hold_the_patch_are_not_extreme(grid):
    """Hertz's ellipse is 7.58 by 21.75 mm; the middle may be off where the area still holds it."""
    assert solved(SMALL | grid, model="halfspace").points[0].normal_force == pytest.approx(50e3, rel=1e-6)


def test_grids_beyond_the_memory_of_the_machine_are_refused_at_once(monkeypatch):
    monkeypatch.setenv("ROLLFEM_MEMORY_GB", "5")
    with pytest.raises(package().SolveError, match="needs about 6.03 GB and 5 GB are available: 4 million"):  # 1.5 kB for each
        solved(SMALL | {"contact_grid.elements_across": 2000}, model="halfspace")


def test_an_accuracy_is_not_climbed_for_beyond_that_memory(monkeypatch):
    monkeypatch.setenv("ROLLFEM_MEMORY_GB", "0.04")  # some 6 700 elements; 320 across would have 100 000
    case = package().Case(tomllib.loads(toml(SMALL | {"accuracy": 1e-5, "contact_grid.elements_across": 20})))
    with pytest.warns(package().AccuracyWarning, match="accuracy = 1e-05 was not reached.*0.04 GB are available"):
        result = package().solve(case, model="halfspace")[0]
    assert result.x.size * result.y.size < 10000
