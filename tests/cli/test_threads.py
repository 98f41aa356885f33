# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results are the same to the last bit for 1, 2, 3 and 16 threads, on every kind of problem."""

import pytest
from program import SMALL, WHEEL_ON_RAIL, says
from resuming import same_results, timeless

CURVE = {"rolling.longitudinal_creepage": [0.0, 0.0005, 0.001, 0.004]}
ONE = {"rolling.longitudinal_creepage": 0.001}
WHEELSET = WHEEL_ON_RAIL | {"friction.coefficient": 0.3, "wheelset.side": "both",
                            "wheelset.lateral_shift": [0.0, 3.0, 5.5]}
KINDS = {
    "curve": (100, SMALL | CURVE),  # transforms in pieces
    "large grid": (200, SMALL | ONE),  # sums over its elements in pieces
    "unlike bodies": (20, SMALL | CURVE | {"wheel.young_modulus": 70e3, "friction.coefficient": 0.3}),
    "falling friction": (16, SMALL | CURVE | {"friction.law": "linear", "friction.kinetic_coefficient": 0.4,
                                              "friction.half_velocity": 500.0, "rolling.speed": 10e3}),
    "prescribed forces": (16, SMALL | {"rolling.longitudinal_force": [1e3, 5e3, 10e3]}),
    "transient": (16, SMALL | ONE | {"rolling.problem": "transient", "history.steps": 3, "history.step_length": 0.5}),
    "stress below": (24, SMALL | ONE | {"output.stress_maxima": True}),
    "wheelset": (12, WHEELSET | {"wheelset.free_rolling": "torque"}),
    "roller at heights": (12, {"friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.profile": "S1002",
                               "rail.rolling_radius": 500.0, "rail.profile": "60E1", "placement.yaw": 0.002,
                               "placement.height": [-0.42, -0.4]})}


@pytest.mark.parametrize("across, keys", KINDS.values(), ids=KINDS)
def test_the_bits_are_the_same_for_any_number_of_threads(rollfem, across, keys):
    file = rollfem.case({"models": ["halfspace"]} | keys | {"contact_grid.elements_across": across})
    for threads in "1", "2", "3", "16":
        rollfem.done("run", file, "--no-report", "--threads", threads, "-o", f"on{threads}")
        if threads != "1":
            same_results(rollfem.work / "on1", rollfem.work / f"on{threads}")


def test_threads_fill_the_same_table(rollfem):
    file = rollfem.case(SMALL | {"table.points": [4, 3, 5], "table.axis_ratio": [0.5, 2.0],
                                 "table.largest": [2.0, 2.0, 2.0], "table.check_points": 10})
    for threads in "1", "16":
        rollfem.done("table", file, "--no-report", "--threads", threads, "-o", f"on{threads}")
    for name in "table.csv", "interpolation.csv":
        assert rollfem.text(f"on16/{name}") == rollfem.text(f"on1/{name}")


def test_threads_solve_a_plan_of_several_contacts_alike(rollfem):
    file = rollfem.case({"models": ["auto"], "accuracy": 0.05} | WHEELSET)

    def points(threads):
        rollfem.done("run", file, "--no-report", "--threads", threads, "-o", f"on{threads}")
        found = [point for model in rollfem.models(f"on{threads}") for point in model["points"]]
        return [{key: value for key, value in point.items() if key != "seconds"} for point in found]

    alone = points("1")
    assert len(alone) >= 6 and points("16") == alone


def test_threads_find_the_same_levels_of_a_study(rollfem):
    for threads in "1", "16":
        rollfem.done("study", rollfem.case(SMALL), "-m", "halfspace", "fastsim", "--levels", "3", "--no-report",
                     "--threads", threads, "-o", f"on{threads}")
    assert timeless(rollfem.work / "on16/study.json") == timeless(rollfem.work / "on1/study.json")


def test_threads_throw_the_error_of_a_serial_run(rollfem):
    # The second position lies beyond the rail, the third too.
    file = rollfem.case({"models": ["halfspace"]} | WHEELSET | {"wheelset.lateral_shift": [0.0, 60.0, 70.0]})
    alone, many = (rollfem.call("run", file, "--threads", threads, "-o", "out") for threads in ("1", "16"))
    assert many.status == alone.status != 0
    says(alone.err, "position 2")
    says(many.err, "position 2")
