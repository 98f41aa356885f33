# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction that falls through the commands run with auto, study and stress: at 10 % creepage the whole patch slides, so
that forces and surface stresses are those of the law itself."""

import re

import pytest
from program import SOURCE, says

CASE = SOURCE / "cases/falling_friction.toml"
SLIDING = 0.14 + (0.33 - 0.14) * 2 ** (-1000.0 / 1250.0)  # mu at V xi = 1000 mm/s


def changed(keys):
    return [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]


COARSE = "-o", "out", *changed({"rolling.longitudinal_creepage": [0.002, 0.1], "contact_grid.elements_across": 20})


def test_auto_takes_a_model_with_it(rollfem):
    rollfem.done("run", CASE, *COARSE, "-m", "auto", "--no-report")
    model = rollfem.models("out")[0]
    assert model["chosen_by"] == "auto"
    assert model["points"][1]["traction_coefficient"] == pytest.approx(SLIDING, rel=0.003)


def test_a_study_converges_to_the_law(rollfem):
    rollfem.done("study", CASE, *COARSE, "--levels", "4")
    assert rollfem.holds("out/study.html")
    found = [float(row["value"]) for row in rollfem.rows("out/study.csv") if row["quantity"] == "traction_coefficient:2"]
    assert len(found) == 4 and found[-1] == pytest.approx(SLIDING, rel=0.001)


def test_stresses_of_the_surface_are_those_of_its_tractions(rollfem):
    rollfem.done("run", CASE, *COARSE, "--no-report")
    rollfem.done("stress", "out", "-o", "stress", "--no-figures")
    shear, = (abs(float(row["xz"])) for row in rollfem.rows("stress/stress.csv")
              if (row["set"], row["body"], float(row["z"])) == ("depth_centre", "wheel", 0.0))
    assert shear == pytest.approx(SLIDING * rollfem.models("out")[0]["points"][1]["max_pressure"], rel=0.01)


def steep(memory, creepages=(0.008, 0.014, 0.2)):
    """So steep that the second load point has no stable state; the third slides as a whole."""
    return "run", CASE, "--no-report", *changed({
        "rolling.longitudinal_creepage": list(creepages), "friction.memory_distance": memory, "friction.coefficient": 3,
        "friction.kinetic_coefficient": 0.3, "friction.half_velocity": 100, "layer.shear_modulus": 1e6,
        "contact_grid.elements_across": 10})


def test_a_load_point_without_a_state_is_left_empty_beside_the_others(rollfem):
    outcome = rollfem.call(*steep(0), "-o", "out")
    assert outcome.status == 1
    says(outcome.err, "the results were written, but", "1 of 3 load points are left empty", "load point 2 of 3",
         "no stable steady state")
    model = rollfem.models("out")[0]
    points = model["points"]
    assert [point["converged"] for point in points] == [True, False, True]
    assert points[1]["longitudinal_creepage"] == 0.014
    assert not points[1].keys() & {"normal_force", "max_pressure", "traction_coefficient", "approach"}
    assert ("warning", "unsolved") in [(note["severity"], note["about"]) for note in model["notes"]]
    rows = rollfem.rows("out/creep_curve.csv")
    assert len(rows) == 3 and rows[1]["traction_coefficient"] == ""
    slides = 0.3 + 2.7 * 2 ** (-2000.0 / 100.0)
    assert points[2]["traction_coefficient"] == pytest.approx(slides, rel=0.001)
    rollfem.done(*steep(0, [0.008]), "-o", "alone")
    alone = rollfem.point("alone")["traction_coefficient"]
    assert points[0]["traction_coefficient"] == pytest.approx(alone, rel=1e-6)


def test_the_memory_that_is_named_gives_one_state_everywhere(rollfem):
    outcome = rollfem.call(*steep(0), "-o", "out")
    says(outcome.out, "warning: friction falls so steeply")
    memory = re.findall(r"one state from about ([\d.e-]*\d)", outcome.err)[-1]
    assert "several states" not in rollfem.done(*steep(memory), "-o", "calm").out
    assert all(point["converged"] for point in rollfem.models("calm")[0]["points"])
