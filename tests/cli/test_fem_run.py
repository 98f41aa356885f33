# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finite-element model through the program: memory as predicted; another linear solver, several threads and several
processes give the same numbers; errors keep their exit status under mpirun."""

import re
import resource

import h5py
import numpy as np
import pytest
from program import SMALL, says
from resuming import same_results


def case_a(cell_size, solver):
    return {"models": ["fem"]} | SMALL | {"rolling.problem": "frictionless", "fem.cell_size": cell_size,
                                          "fem.linear_solver": solver}


def test_the_memory_is_within_thirty_percent_of_what_was_told(rollfem):
    # The children's largest memory only grows, so the smaller run comes first, and this test before others.
    for solver in "multigrid", "factorisation":
        err = rollfem.done("run", rollfem.case(case_a(1.88, solver)), "--no-report").err
        told = float(re.findall(r"needs about ([\d.]+)", err)[-1])  # of the finest level, GB
        used = 1024e-9 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        assert told / used == pytest.approx(1.0, abs=0.3), err


def test_a_run_that_does_not_fit_is_refused_before_anything_is_computed(rollfem):
    outcome = rollfem.call("run", rollfem.case(case_a(0.1, "automatic")), ROLLFEM_MEMORY_GB="1")
    assert outcome.status == 1 and "mesh" not in outcome.err and rollfem.made() == []
    says(outcome.err, "1 GB are available", "cell_size larger than 0.1 mm")


def skew(solver):
    """Case b on a coarse mesh with lateral creepage, so that whole bodies are modelled."""
    return {"models": ["fem"]} | SMALL | {
        "rail.transverse_radius": 500.0, "rolling.longitudinal_creepage": 0.001, "rolling.lateral_creepage": 0.0005,
        "fem.cell_size": 2.4, "fem.extent": 26, "fem.linear_solver": solver}


def same_numbers(one, other, tolerance):
    for name in ("longitudinal_force", "lateral_force", "spin_moment", "max_pressure", "max_traction", "approach",
                 "semi_axis_x", "semi_axis_y"):
        assert one[name] == pytest.approx(other[name], rel=tolerance, abs=0), name


def same_bodies(one, other, p0):
    """Nodes, cells, displacement and stress of the bodies are the same but for rounding to single precision."""
    with h5py.File(one) as first, h5py.File(other) as second:
        for body in "wheel", "rail":
            for name, bound in {"points": 1e-11, "cells": 0, "displacement": 1e-9, "stress": 1e-6 * p0}.items():
                a, b = (file[f"models/fem/bodies/{body}/{name}"][()] for file in (first, second))
                assert a.size and a.shape == b.shape and abs(a - b).max() <= bound, (body, name)


def test_factorisation_and_two_processes_of_multigrid_give_the_numbers_of_one(rollfem):
    file = rollfem.case(skew("multigrid") | {
        "output.stress_maxima": True, "output.body_fields": "all",
        "subsurface.line": [{"from": [-3, -2, 0.4], "to": [3, 2, 6], "points": 9}],
        "subsurface.surface": [{"body": "rail", "from": [1, -5], "to": [1, 5], "points": 9}]})
    for name, processes in ("one", 1), ("two", 2):
        rollfem.done("run", file, "-o", name, "--quiet", "--no-report", processes=processes)
    one, two = rollfem.point("one"), rollfem.point("two")
    rollfem.done("run", rollfem.case(skew("factorisation")), "-o", "factorisation", "--quiet", "--no-report")
    same_numbers(rollfem.point("factorisation"), one, 1e-8)
    same_numbers(one, two, 1e-8)
    p0 = one["max_pressure"]
    # Largest stresses, and displacement and stress at the points that the case asks for.
    assert len(one["stress_maxima"]) == len(two["stress_maxima"]) == 12
    for a, b in zip(one["stress_maxima"], two["stress_maxima"]):
        assert a["value"] == pytest.approx(b["value"], abs=1e-8 * p0), a["measure"]
    first, second = ([list(row.values())[4:] for row in rollfem.rows(f"{name}/subsurface.csv")] for name in ("one", "two"))
    assert len(first) >= 18 and len(first[0]) >= 19
    np.testing.assert_allclose(np.array(first, float), np.array(second, float), rtol=0, atol=1e-8 * p0)
    same_bodies(rollfem.work / "one/results.h5", rollfem.work / "two/results.h5", p0)


def test_slow_kernels_of_openblas_make_multigrid_the_choice(rollfem):
    """Measured on 60 000 unknowns: the factorisation takes 1.7 times as long with the kernels for SSE3."""
    file = rollfem.case({"models": ["fem"]} | SMALL | {
        "rolling.longitudinal_creepage": [0.0, 5e-4, 1e-3, 2e-3, 3e-3, 4e-3, 6e-3], "fem.cell_size": 1.6})
    for name, settings, solver in (("fast", {}, "CHOLMOD factorisation"),
                                   ("slow", {"OPENBLAS_CORETYPE": "Prescott"}, "geometric multigrid")):
        rollfem.done("run", file, "-o", name, "--quiet", "--no-report", **settings)
        says(rollfem.text(f"{name}/summary.json"), solver)


def test_a_factorisation_on_two_processes_is_refused_once_with_status_two(rollfem):
    outcome = rollfem.call("run", rollfem.case(skew("factorisation")), "-o", "out", "--no-report", processes=2)
    assert outcome.status == 2 and outcome.err.count("one process only") == 1, outcome
    says(outcome.err, "linear_solver")
    assert not rollfem.holds("out")


@pytest.mark.parametrize("processes", [1, 2, 3])
def test_an_error_of_the_contact_problem_ends_all_processes_with_one_message(rollfem, processes):
    # How much friction can bear is known when the first process has solved the normal problem.
    file = rollfem.case({"models": ["fem"]} | SMALL | {
        "load.normal_force": None, "load.approach": 0.02, "rolling.longitudinal_force": -1e6, "fem.cell_size": 1.8,
        "fem.extent": 20, "fem.linear_solver": "multigrid"})
    outcome = rollfem.call("run", file, "-o", "out", "--no-report", processes=processes)
    assert outcome.status == 1 and outcome.err.count("prescribed force") == 1, outcome
    assert not rollfem.holds("out")


@pytest.mark.parametrize("model, more", [("fem", {"fem.linear_solver": "multigrid"}),
                                         ("fem", {"fem.linear_solver": "factorisation"}),
                                         ("hybrid", {"contact_grid.elements_across": 20, "fem.extent": 20})],
                         ids=["multigrid", "factorisation", "hybrid"])
def test_the_bits_are_the_same_for_any_number_of_threads(rollfem, model, more):
    file = rollfem.case(SMALL | {"rolling.longitudinal_creepage": [0.0, 0.001], "fem.cell_size": 1.8,
                                 "fem.extent": 26, "output.stress_maxima": True} | more)
    for threads in "1", "16":
        rollfem.done("run", file, "-m", model, "--no-report", "--threads", threads, "-o", f"on{threads}")
        if threads != "1":
            same_results(rollfem.work / "on1", rollfem.work / f"on{threads}")
