# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that the program refuses, and results with a warning."""

import math

import pytest
from program import says

CROWNED = {"friction.coefficient": 0.3, "wheel.rolling_radius": 460, "wheel.transverse_radius": math.inf,
           "rail.transverse_radius": 300}
FORCE = {"load.normal_force": 50e3}


@pytest.mark.parametrize("model", "hertz linear vermeulen-johnson polach carter fastsim fastrip strip halfspace".split())
def test_cells_larger_than_the_patch_are_refused_in_every_model(rollfem, model):
    file = rollfem.case(FORCE | CROWNED | {"rolling.longitudinal_creepage": 0.001, "contact_grid.cell_size": [1e3, 1e3]})
    outcome = rollfem.call("run", "-q", "--no-report", "--model", model, file)
    assert outcome.status == 1
    says(outcome.err, f"case.toml: model {model}: load point 1 of 1: the patch has only 1 by 1 contact elements of 1000 by "
         "1000 mm")
    assert not rollfem.holds("results")


def test_a_step_of_a_history_that_the_grid_does_not_see_is_refused(rollfem):
    file = rollfem.case(CROWNED | {
        "rolling.problem": "transient", "rolling.longitudinal_creepage": 0.001, "history.normal_force": [50e3, 1e-3, 50e3],
        "history.step_length": 1.0, "contact_grid.elements_across": 20})
    outcome = rollfem.call("run", "-q", "--no-report", "--model", "halfspace", file)
    assert outcome.status == 1
    says(outcome.err, "load point 2 of 3: the patch has only 2 by 2 contact elements")


def test_a_patch_as_large_as_the_bodies_is_warned_of_everywhere(rollfem):
    file = rollfem.case(CROWNED | {"load.normal_force": 1e10, "contact_grid.elements_across": 10})
    outcome = rollfem.done("run", "--model", "hertz", "--model", "halfspace", file, "-o", "out")
    warnings = ["warning: the patch is not small against the bodies",
                "warning: the approach is not small against the radii", "warning: the largest pressure, 5."]
    for model in rollfem.models("out"):
        says("\n".join(f"{note['severity']}: {note['text']}" for note in model["notes"]), *warnings)
        says(outcome.out, *(f"{model['name']}: {warning}" for warning in warnings))
    says(rollfem.text("out/report.html"), *warnings)


@pytest.mark.parametrize("words", [["check"], ["run", "-q", "--no-report", "--model", "hertz"]], ids=["check", "run"])
def test_check_and_run_warn_of_wrong_units(rollfem, words):
    kilonewtons = rollfem.case(CROWNED | {"load.normal_force": 80, "rolling.longitudinal_creepage": 0.6,
                                          "rolling.spin": 1.0})
    says(rollfem.done(*words, kilonewtons).err, "warning: ", "case.toml: load.normal_force = 80 N",
         "rolling.longitudinal_creepage = 0.6", "rolling.spin = 1 rad/mm")


def test_a_wheel_in_metres_under_its_load_in_newtons_bears_what_no_steel_does(rollfem):
    metres = CROWNED | {"load.normal_force": 80e3, "wheel.rolling_radius": 0.46, "rail.transverse_radius": 0.3}
    says(rollfem.done("check", rollfem.case(metres)).err, "wheel.rolling_radius = 0.46 mm",
         "rail.transverse_radius = 0.3 mm", "MPa, which no rail or wheel steel carries")
