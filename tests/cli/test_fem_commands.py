# SPDX-License-Identifier: LGPL-2.1-or-later
"""compare and study of finite elements on several processes: the numbers of one process, files of the first alone, and a
failure that ends the call with nothing half-written. stress on stored bodies: for any load point of a creep curve they
equal a run with that creepage alone."""

import xml.etree.ElementTree

import h5py
import numpy as np
import pytest
from program import SMALL, package, says
from test_results import vtk_arrays


def flat(cell_size):
    return SMALL | {"rail.transverse_radius": 500.0, "rolling.longitudinal_creepage": 0.001,
                    "contact_grid.elements_across": 20, "fem.extent": 30, "fem.fine_extent": 1.0,
                    "fem.linear_solver": "multigrid", "fem.cell_size": cell_size, "output.fields": False}


@pytest.mark.parametrize("command, options", [("study", ["--model", "fem", "halfspace", "--levels", "2"]),
                                              ("compare", ["--model", "halfspace", "fem"])])
def test_two_processes_give_the_numbers_of_one(rollfem, command, options):
    file = rollfem.case(flat(1.7))
    for processes in 1, 2:
        assert rollfem.done(command, file, "-o", f"on_{processes}", "-q", "--no-report", *options,
                            processes=processes).out == ""
    assert [name for name in rollfem.made() if "partial" in name] == []
    one, two = (rollfem.rows(f"on_{processes}/{command}.csv") for processes in (1, 2))
    assert len(one) == len(two) > 8
    for first, second in zip(one, two):
        for cell in "quantity", "model", "unknowns":
            assert first.get(cell) == second.get(cell)
        assert float(second["value"]) == pytest.approx(float(first["value"]), rel=1e-8, abs=0), first["quantity"]
    if command == "study":
        assert rollfem.json("on_2/study.json")["processes"] == 2
        series = rollfem.json("on_1/study.json")["places"][0]["series"]
        # The first level of finite elements has too few cells across the patch.
        assert [len(each["levels"]) for each in series] == [1, 2]


@pytest.mark.parametrize("command", ["study", "compare"])
def test_a_failure_on_two_processes_ends_the_call_and_writes_nothing(rollfem, command):
    # More unknowns than any memory holds, which shows before a mesh is made.
    outcome = rollfem.call(command, rollfem.case(flat(0.001)), "-o", "out", "--no-report", "-m", "fem", processes=2)
    assert outcome.status == 1, outcome
    says(outcome.err, "model fem")
    assert rollfem.made() == []


@pytest.fixture
def run(rollfem):
    """Solves small bodies of case a."""
    def solve(name, creepages, bodies=None, **more):
        rollfem.done("run", rollfem.case({"models": ["fem"]} | SMALL | {
            "rolling.longitudinal_creepage": creepages, "fem.cell_size": 1.9, "fem.extent": 23,
            "fem.linear_solver": "factorisation", "output.body_fields": bodies} | more), "-o", name, "-q", "--no-report")
    return solve


@pytest.fixture
def stress(rollfem):
    """The numbers of stress.csv, row by row, from x on."""
    def ask(result, *arguments):
        places = rollfem.case({"subsurface.line": [{"from": [-6, 1, -2], "to": [6, 1, -2], "points": 25, "body": "rail"}]},
                              "places.toml")
        rollfem.done("stress", result, "--no-figures", "--depth-profile", "--depth", "10", "--places", places, "-o", "out",
                     *arguments)
        return np.array([list(row.values())[4:] for row in rollfem.rows("out/stress.csv")], float)
    return ask


def test_stresses_of_the_hybrid_are_computed_again_where_no_correction_is_kept(run, stress):
    run("h", 0.001, models=["hybrid"], **{"fem.degree": 1, "contact_grid.elements_across": 12})
    assert stress("h").size > 1000


def test_stresses_at_any_load_point_are_those_of_a_run_with_it_alone(rollfem, run, stress):
    run("curve", [0.001, 0.003, 0.006], "all")
    run("first", [0.001], "all")
    run("second", [0.003], "all")
    p0 = rollfem.point("curve")["max_pressure"]
    # Both begin from the frictionless solution: the same numbers.
    first = stress("curve", "--point", "1")
    assert first.size > 1000 and (first == stress("first")).all()
    # From the point before and from the frictionless solution: to the tolerance of the iteration.
    second, alone = stress("curve", "--creepage", "0.003"), stress("second")
    assert abs(second - alone).max() < 1e-4 * p0
    assert abs(second - first).max() > 0.05 * p0, "the load points are not told apart"
    # The same bodies for ParaView.
    fields = rollfem.work / "curve/fields"
    series = xml.etree.ElementTree.parse(fields / "fem_bodies.pvd").getroot()
    assert [tuple(part.get(name) for name in ("timestep", "part", "file")) for part in series.iter("DataSet")] == [
        (creepage, part, f"fem_{body}_{k:04}.vtu") for k, creepage in enumerate(("0.001", "0.003", "0.006"))
        for part, body in (("0", "wheel"), ("1", "rail"))]
    assert rollfem.holds("curve/fields/fem_wheel.vtu")
    with h5py.File(rollfem.work / "curve/results.h5") as file:
        bodies, point = file["models/fem/bodies"], file["models/fem/points/0000/bodies"]
        for body in "wheel", "rail":
            found = vtk_arrays(fields / f"fem_{body}_0000.vtu")
            assert (found["Points"] == bodies[f"{body}/points"][()]).all()
            assert found["types"].size == len(bodies[f"{body}/cells"]) and (found["types"] == 12).all()  # hexahedra
            assert found["displacement [mm]"] == pytest.approx(point[f"{body}/displacement"][()], rel=1e-6, abs=1e-9)
            stored = point[f"{body}/stress"][()]
            assert found["stress [MPa]"] == pytest.approx(stored, rel=1e-6, abs=1e-6)
            von_mises = package().stress_measures(stored)["von_mises"]
            assert found["von Mises stress [MPa]"] == pytest.approx(von_mises, rel=1e-5, abs=1e-6)


def test_bodies_are_kept_as_the_case_says(rollfem, run, stress):
    run("last", [0.001, 0.003], "last")
    assert rollfem.holds("last/fields/fem_wheel_0001.vtu") and not rollfem.holds("last/fields/fem_wheel_0000.vtu")
    assert stress("last").size
    rollfem.refuses("stress", "last", "--point", "1", says="stores its bodies only for these load points: 2; do: ")
    run("none", [0.001, 0.003])
    assert rollfem.holds("none/fields/fem_contact_0001.vtu") and not rollfem.holds("none/fields/fem_wheel.vtu")
    rollfem.refuses("stress", "none", says='do: run the case again with [output] body_fields = "all"')
