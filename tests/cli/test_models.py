# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each model of the program refuses, in one message that names those that can."""

import json
import math

import pytest
from program import FEM, SMALL, refused, says

THEORIES = "linear vermeulen-johnson polach carter fastsim fastrip strip".split()
SOLVERS = ["halfspace", "hybrid", "fem"]
BELOW = {"subsurface.point": [{"body": "rail", "at": [0, 0, -1]}]}
INERTIA = {"rolling.speed": 5e4, "fem.inertia": True}
RIGID = {"rail.young_modulus": math.inf}
PRESSURE = {"friction.coefficient": 0.4, "wheel.rolling_radius": 500.0, "given_pressure.semi_axis_x": 6.0,
            "given_pressure.semi_axis_y": 4.0, "given_pressure.max_pressure": 1e3}
# A wheel of -40 mm across: its surface is 0.453 mm below z = 0 at y = 6.
HOLLOW = SMALL | {"wheel.transverse_radius": -40.0, "rail.transverse_radius": 35.0,
                  "subsurface.point": [{"at": [0, 6, -0.4]}]}


@pytest.mark.parametrize("keys, able, refusals", [
    (SMALL, [*THEORIES, *SOLVERS], {}),
    (SMALL | {"rolling.problem": "shift", "history.lateral_shift": 0.1}, SOLVERS,
     {model: ["allowed: hertz, halfspace, hybrid, fem; do: run with --model halfspace"] for model in THEORIES}),
    (SMALL | {"rolling.longitudinal_force": 1.0}, [*SOLVERS, "fastsim", "fastrip", "strip"],
     {model: ["prescribed tangential force"] for model in THEORIES[:4]}),
    (PRESSURE, ["halfspace", "fem", "fastsim"], {"hybrid": [""]}),
    (SMALL | RIGID, ["fem"], {}),
    (SMALL | RIGID | BELOW, [], {"fem": ["subsurface: it cannot handle the stress in a rigid body; allowed: hertz, linear"]}),
    # A speed alone is no more than that, however high.
    (SMALL | {"rolling.speed": 5e6}, ["hertz", "carter", *SOLVERS], {}),
    (SMALL | INERTIA, ["fem"], {model: [
        "fem.inertia: it cannot handle the inertia of moving bodies; allowed: fem; do: run with --model fem"]
        for model in ("hertz", "carter", "halfspace", "hybrid")}),
    (SMALL | {"rolling.spin": 1e-4}, ["linear"], {"carter": [
        "rolling.spin: it cannot handle spin; allowed: hertz, linear, vermeulen-johnson, polach, fastsim, fastrip, strip, "
        "halfspace, hybrid, fem; do: run with --model halfspace"]}),
    (SMALL | {"rolling.lateral_creepage": 1e-4}, [], {"carter": [
        "rolling.lateral_creepage: it cannot handle lateral creepage; allowed: hertz, linear, vermeulen-johnson, polach, "
        "fastsim, fastrip, strip, halfspace, hybrid, fem"]}),
    # Slip from a file, but not what the surface brings.
    (SMALL | {"rolling.extra_slip": "file", "rolling.extra_slip_file": "slip.csv"}, [], {"linear": [
        "rolling.extra_slip: it cannot handle extra slip from a file; allowed: hertz, carter, fastsim, fastrip, strip, "
        "halfspace, hybrid, fem; do: run with --model halfspace"]}),
    # Others take the stress in a rigid body, but not the inertia that is asked for beside it.
    (SMALL | RIGID | INERTIA | BELOW, [], {"fem": ["allowed: no model can solve all of this case"]}),
    # Half-spaces end at their surface.
    (HOLLOW, ["hybrid", "fem"], {"halfspace": ["model halfspace", "beyond z = 0", "--model hybrid"]})])
def test_models_refuse_what_they_leave_out_and_name_those_that_can(rollfem, keys, able, refusals):
    rollfem.file("slip.csv", "".join(f"{x} {y} 0 0\n" for y in range(-40, 41) for x in range(-40, 41)))
    file = rollfem.case(keys)
    cannot = json.loads(rollfem.done("check", "--json", file).out)["cannot"]
    assert {cannot[model] for model in able if FEM or model not in ("hybrid", "fem")} <= {""}
    for model, parts in refusals.items():
        assert cannot[model]
        if FEM or model != "fem":
            outcome = rollfem.call("run", file, "--model", model)
            refused(outcome, "")
            says(outcome.err, *parts)
