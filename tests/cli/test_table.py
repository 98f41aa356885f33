# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command table: its files, resuming an interrupted call, and its refusals."""

import math

import h5py
import numpy as np
import pytest
from program import SMALL, SOURCE, package, says
from resuming import killed, records
from test_filled_tables import RIM

QUICK = SMALL | {"table.points": [4, 3, 5], "table.largest": [2.0, 2.0, 2.0], "table.check_points": 10}


def read(rollfem, name):
    return package().Table(rollfem.work / name)


def filled(rollfem, keys, *options, name="out"):
    return rollfem.done("table", rollfem.case(keys), "-o", name, *options)


def test_is_written_with_its_errors_and_a_report(rollfem):
    says(filled(rollfem, QUICK).out, "60 points", "4 values of xi'", "interpolation error at 10 random points")
    for name in ("table.h5", "figures/table_surfaces.svg", "figures/table_curves.svg", "figures/table_errors.svg",
                 "interpolation.csv"):
        assert rollfem.holds(f"out/{name}"), name
    table = read(rollfem, "out")
    assert table.longitudinal_force.size == 60 and table.interpolation["points"] == 10
    assert table.scaled(longitudinal=50.0).longitudinal_force == pytest.approx(-1.0, abs=0.005)
    assert len(rollfem.rows("out/table.csv")) == 60
    says(rollfem.text("out/table.html"), "95 of 100 points")


def error_and_text(rollfem, points):
    """The interpolation error that 95 of 100 random points of a table with these numbers of values stay below, and
    what the command says."""
    name = "-".join(map(str, points))
    outcome = filled(rollfem, SMALL | {"table.check_points": 20, "table.points": points}, "--no-report", name=name)
    error = read(rollfem, name).interpolation
    return max(error["force_95"], error["moment_95"]), outcome.out + outcome.err


def test_names_the_axis_whose_refinement_helps(rollfem):
    coarse, said = error_and_text(rollfem, [9, 8, 3])
    says(said, "by axis, in 95 of 100: xi'", "refine phi' first", "5 values instead of 3", "216 points: about ")
    assert "a/b 0" not in said  # a single ratio
    # The advice against tables with more values on one axis or the other.
    assert error_and_text(rollfem, [9, 8, 5])[0] < 0.7 * coarse
    assert error_and_text(rollfem, [17, 8, 3])[0] > 0.9 * coarse
    says(error_and_text(rollfem, [2, 6, 9])[1], "refine xi' first")


@pytest.mark.parametrize("keys", [
    SMALL | {"table.axis_ratio": [0.5, 2.0], "table.points": [5, 4, 5], "table.check_points": 20}, RIM])
def test_an_ended_call_is_taken_up_and_is_the_same(rollfem, keys):
    file = rollfem.case(keys)
    table = "table", file, "--no-report", "-o"
    unfinished = rollfem.work / "out.unfinished"
    killed(rollfem, lambda: records(unfinished) >= 3, *table, "out")
    assert not rollfem.holds("out")
    kept = records(unfinished)
    says(rollfem.done(*table, "out", "--resume").err, f"resume: {kept} solutions")
    assert not unfinished.exists()
    rollfem.done(*table, "whole")
    for name in "table.csv", "interpolation.csv":
        assert rollfem.text(f"out/{name}") == rollfem.text(f"whole/{name}")


def test_forces_are_those_of_the_model_halfspace(rollfem):
    """Which solves with other grids, levels and pressure."""
    filled(rollfem, SMALL | {"table.points": [12, 2, 2], "table.lateral_values": [0.0, 0.3, 0.6],
                             "table.spin_values": [0.0, 0.4, 0.8], "table.check_points": 0}, "--no-report")
    table = read(rollfem, "out")
    bound, a, b = 0.55 * 50e3, 3.79236, 10.87295  # Hertz's exact semi-axes of this case
    ellipse = {"semi_axis_x": a, "semi_axis_y": b, "shear_modulus": 210e3 / 2.6, "friction_bound": bound}
    # A grid point of all three.
    stiffness = ellipse["shear_modulus"] * a * b / bound
    with h5py.File(rollfem.work / "out/table.h5") as file:
        scale = np.array([stiffness, stiffness, stiffness * math.sqrt(a * b)]) * np.ravel(file["axes/scale"])[:3]
    grid_point = np.array([table.axes["longitudinal"][2], -0.3, 0.4]) / scale
    for xi, eta, phi in (0.0005, 0, 0), (0.0015, 0, 0), (0.004, 0, 0), grid_point.tolist():
        found = table.forces(**ellipse, longitudinal_creepage=xi, lateral_creepage=eta, spin=phi)
        rollfem.done("run", rollfem.case(SMALL | {"rolling.longitudinal_creepage": xi, "rolling.lateral_creepage": eta,
                                                  "rolling.spin": phi}), "-m", "halfspace", "-o", "run", "--no-report")
        point = rollfem.point("run")
        assert found.longitudinal_force == pytest.approx(point["longitudinal_force"], abs=0.004 * bound)
        assert found.lateral_force == pytest.approx(point["lateral_force"], abs=0.004 * bound)
        assert found.spin_moment == pytest.approx(point["spin_moment"], abs=0.01 * bound * math.sqrt(a * b))


def test_over_lateral_shifts_has_the_contacts_and_its_figures(rollfem):
    source = (SOURCE / "cases/s1002_uic60_left.toml").read_text("utf-8")
    changes = ["table.lateral_shift=[0.0,1.0,2.0]", "table.points=[2,2,3]", "table.check_points=10",
               "contact_grid.elements_across=12"]
    outcome = filled(rollfem, source, *(word for change in changes for word in ("--set", change)))
    says(outcome.out, "81 points", "3 values of lateral shift 0 to 2 mm", "radius mm", "interpolation error at 10")
    for name in ("table.csv", "shifts.csv", "interpolation.csv", "table.html", "figures/table_shifts.svg",
                 "figures/table_wheels.svg"):
        assert rollfem.holds(f"out/{name}"), name
    lines = rollfem.text("out/shifts.csv").splitlines()
    assert len(lines) == 4 and lines[0].startswith("lateral_shift [mm],semi_axis_x [mm]")
    table = read(rollfem, "out")
    assert table.longitudinal_force.size == 81 and len(table.wheels["rolling_radius"]) == 3
    # The radius at the case's own position (docs/track.md).
    assert table.wheel_at(2.0)["rolling_radius"] == pytest.approx(449.82, abs=0.02)


@pytest.mark.parametrize("change, said", [
    ({"table.axis_ratio": [2.0, 1.0]}, "table.axis_ratio = [2.0, 1.0]: does not ascend"),
    ({"table.points": [1, 8, 11]}, "table.points"),
    ({"table.point": [8, 8, 11]}, "points"),
    ({"table.spin_values": [-1.0, 1.0]}, "table.spin_values"),
    (QUICK | {"undeformed_distance.file": "none.csv"}, "none.csv"),
    ({"rail.poisson_ratio": 0.4}, "unlike materials"),
    ({"friction.coefficient": 0.0}, "friction.coefficient = 0")])
def test_wrong_input_is_reported_in_one_line(rollfem, change, said):
    rollfem.refuses("table", rollfem.case(SMALL | change), "-o", "out", says=said)
    assert not rollfem.holds("out")
