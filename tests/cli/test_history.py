# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wheels whose positions follow each other, from the command line: both wheels side by side, a row for each step, a run that
goes on after a kill, and what is refused."""

import pytest
from program import WHEEL_ON_RAIL, says
from resuming import killed, records, same_results

STEPS = {"title": "steps", "models": ["halfspace"]} | WHEEL_ON_RAIL | {
    "wheelset.roll": 0.0, "wheelset.rotation_change": -0.001, "wheelset.lateral_shift": [0.1 * k for k in range(12)],
    "rolling.problem": "transient", "history.step_length": 1.0, "history.motion": "positions",
    "contact_grid.elements_across": 10}


def forces(models, wheel):
    return [[model["points"][0][name] for name in ("normal_force", "longitudinal_force", "lateral_force")]
            for model in models if model["place"]["wheel"] == wheel]


def test_two_wheels_roll_as_each_does_alone_and_every_step_has_a_row(rollfem):
    rollfem.done("run", rollfem.case(STEPS | {"wheelset.side": "both"}), "-o", "both")
    models = rollfem.models("both")
    for wheel in "left", "right":
        rollfem.done("run", rollfem.case(STEPS | {"wheelset.side": wheel}), "-o", wheel, "--no-report")
        alone = rollfem.models(wheel)
        assert len(alone) == 12
        for one, other in zip(forces(models, wheel), forces(alone, wheel)):
            assert one == pytest.approx(other, rel=0.01, abs=200)  # the size of the elements is that of all patches
    rows = rollfem.rows("both/wheelset.csv")
    assert [float(row["distance"]) for row in rows] == [float(k) for k in range(1, 13)]
    assert models[-1]["points"][0]["step"] == 12
    says(rollfem.text("both/report.html"), "distance rolled", "share of slip")


def test_after_a_kill_the_result_is_the_same_to_the_last_bit(rollfem):
    file = rollfem.case(STEPS | {"wheelset.lateral_shift": [0.02 * k for k in range(80)], "contact_grid.elements_across": 40})
    run = "run", file, "--no-report", "-o"
    rollfem.done(*run, "whole")
    killed(rollfem, lambda: records(rollfem.work / "out.unfinished") >= 5, *run, "out")
    says(rollfem.done(*run, "out", "--resume").err, "resume:")
    same_results(rollfem.work / "whole", rollfem.work / "out")


@pytest.mark.parametrize("change, text", [
    ({"models": ["hertz"]}, "allowed: halfspace"),
    ({"history.step_length": [1.0, 2.0]}, "12 positions, but the history has 2 steps"),
    ({"history.step_length": None}, "step_length"),
    ({"history.step_length": None, "history.time": [float(k) for k in range(12)]}, "rolling.speed"),
    ({"wheelset.lateral_velocity": 0.001}, "difference of the positions"),
    ({"wheelset.longitudinal_force": -1e3}, "free_rolling"),
    ({"wheelset.rotation_change": None, "wheelset.free_rolling": "force", "wheelset.longitudinal_force": -90e3},
     "no rotation transmits the given longitudinal_force"),
    ({"track.rail_force": [1e3, 0.0]}, "rail_stiffness"),
])
def test_wrong_input_is_refused(rollfem, change, text):
    outcome = rollfem.call("run", rollfem.case(STEPS | change), "-o", "out", "--no-report")
    assert outcome.status != 0
    says(outcome.err, text)
