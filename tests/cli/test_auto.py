# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model auto through the program: its choice at 5, 1 and 0.2 %, and where the choice is reported."""

import json
import math

import pytest
from program import FEM, SMALL, SOURCE, TWO_POSITIONS, says
from resuming import killed, records

# A nearly circular patch, one load point: the model error of the half-space is 0.6 % of mu.
QUICK = SMALL | {"rail.transverse_radius": 500.0, "rolling.longitudinal_creepage": 0.001}


def model_of(rollfem, keys, status=0):
    outcome = rollfem.call("run", rollfem.case(keys), "-o", "out", "--no-report", "-q")
    assert outcome.status == status, outcome
    return rollfem.models("out")[0]


def error(point, name):
    """The bar of a number and what its model leaves out."""
    return point["error_estimate"].get(name, 0.0) + point.get("model_error", {}).get(name, 0.0)


def worst(point, friction):
    """The largest error of a point over the number, of the traction over the coefficient of friction."""
    parts = [error(point, name) / point[name] for name in ("max_pressure", "semi_axis_x", "semi_axis_y")]
    return max(*parts, error(point, "traction_coefficient") / friction)


def test_is_the_default_and_takes_a_half_space_where_that_does(rollfem):
    elements = 0
    for accuracy, asked in (0.05, {"accuracy": 0.05}), (0.01, {}):
        model = model_of(rollfem, asked | QUICK)
        assert (model["name"], model["label"], model["chosen_by"]) == ("halfspace", "half-space", "auto")
        assert model["choice"].startswith("half-space, ")
        says(model["choice"], "model 0.")
        says(next(note["text"] for note in model["notes"] if note["about"] == "choice"), model["choice"])
        assert "model_error" in model["points"][0] and worst(model["points"][0], 0.55) <= accuracy
        assert model["contact_elements"] > elements
        elements = model["contact_elements"]


def test_takes_the_half_space_for_a_line_contact(rollfem):
    model = model_of(rollfem, {"load.normal_force": 500.0, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0,
                               "geometry.shape": "line", "rolling.longitudinal_creepage": 0.001})
    assert (model["name"], model["chosen_by"]) == ("halfspace", "auto")
    says(model["choice"], "line contact is not estimated")
    # Hertz: p0 = sqrt(F E* / (pi R)) per mm of width.
    assert model["points"][0]["max_pressure"] == pytest.approx(math.sqrt(500.0 * 115384.615 / (math.pi * 460.0)), rel=0.01)


def test_says_what_it_took_on_the_screen(rollfem):
    outcome = rollfem.done("run", rollfem.case(QUICK), "--model", "auto", "--no-report")
    says(outcome.out, "halfspace: auto, for 1 %: half-space, ", "finite elements")


def test_goes_on_to_the_hybrid_where_the_half_space_leaves_out_too_much(rollfem):
    strict = {"accuracy": 0.003} | QUICK
    if FEM:
        model = model_of(rollfem, strict)
        assert model["name"] == "hybrid" and worst(model["points"][0], 0.55) <= 0.003
        says(model["choice"], "; half-space, ")
    else:  # The best available result and a failure; without a requested accuracy a warning.
        model = model_of(rollfem, strict, status=1)
        assert model["name"] == "halfspace"
        says(model["choice"], "hybrid: not in this build")


def test_tells_last_what_misses_the_accuracy_and_has_one_model_in_all_contacts(rollfem):
    # In 60 s, no other model solves six contacts.
    run = rollfem.done("run", rollfem.case(TWO_POSITIONS | {"friction.coefficient": 0.2,
                                                            "wheelset.lateral_shift": [0.0, 2.0, 3.0]}), "-o", "out")
    models, verdict = rollfem.models("out"), rollfem.json("out/summary.json")["verdict"]
    assert [model["name"] for model in models] == ["halfspace"] * 6
    missed = sum(worst(model["points"][0], 0.2) > 0.01 for model in models)
    assert missed > 1
    says(verdict, f"{missed} of 6 contacts miss 1 %: worst ", "% of mu (-F_x/F_z)")
    assert run.out.endswith(f"warning: {verdict}\n")
    if FEM:
        says(verdict, "`--set accuracy=0.01` allows more time: ")
    for row in rollfem.rows("out/wheelset.csv"):
        assert [name for name, cell in row.items() if name.startswith(("left ", "right ")) and not cell] == []
    # In the report it stands below the title, before any table.
    page = rollfem.text("out/report.html")
    assert 0 <= page.find("<h1") < page.find(" of 6 contacts miss 1 %") < page.find("<table")


BOTH = {"models": ["auto", "hertz"]} | QUICK


@pytest.mark.parametrize("command, keys, more, said", [
    ("run", QUICK, ["--model", "auto", "hertz"], "auto cannot be combined"),
    ("compare", QUICK, ["--model", "auto"], "rollfem run --model auto"),
    ("study", QUICK, ["--model", "auto"], "rollfem run --model auto"),
    ("run", BOTH, [], "case.toml: models: auto cannot be combined")])
def test_stands_alone_and_is_nothing_to_compare(rollfem, command, keys, more, said):
    rollfem.refuses(command, rollfem.case(keys), *more, says=said)


YIELDS = QUICK | {"rail_plasticity.yield_stress": 400.0}
DISC_ENDS = SOURCE / "cases/verification/twin_disc_ends.toml"


@pytest.mark.parametrize("keys, more, said, of_model", [
    (YIELDS, [], "model auto: wheel_plasticity or rail_plasticity: it cannot handle bodies",
     "  not auto, hertz, "),
    (BOTH, [], "models: auto cannot be combined", ""),
    (DISC_ENDS, ["--set", 'models=["carter"]'], "model carter: ", "\n  not carter: ")])
def test_check_warns_with_the_sentence_of_the_run_that_refuses(rollfem, keys, more, said, of_model):
    file = rollfem.case(keys) if isinstance(keys, dict) else keys
    run = rollfem.call("run", "--no-report", file, *more)
    assert run.status == 2
    says(run.err, said)
    refusal = run.err.removeprefix("rollfem: ")
    check = rollfem.done("check", file, *more)
    says(check.err, "warning: " + refusal)
    says(check.out, of_model)
    assert json.loads(rollfem.done("check", "--json", file, *more).out)["warnings"][-1] + "\n" == refusal


def test_takes_a_given_pressure_of_bodies_without_radii(rollfem):
    model = model_of(rollfem, {"load.normal_force": 82e3, "friction.coefficient": 0.3, "given_pressure.semi_axis_x": 6.0,
                               "given_pressure.semi_axis_y": 6.0, "rolling.spin": 1e-4})
    assert model["name"] == "halfspace"
    # p0 = 3 F / (2 pi a b)
    assert model["points"][0]["max_pressure"] == pytest.approx(1.5 * 82e3 / (math.pi * 36.0), abs=10.0)


def test_takes_up_what_an_interrupted_run_has_solved(rollfem):
    # The model error of half-spaces is 0.65 %, so that several grids are needed.
    curve = {"accuracy": 0.007} | QUICK | {"rolling.longitudinal_creepage": [0.0005, 0.001, 0.002, 0.004]}
    whole = model_of(rollfem, curve)
    run = "run", rollfem.case(curve), "-o", "killed", "--no-report"
    killed(rollfem, lambda: records(rollfem.work / "killed.unfinished", "halfspace") > 2, *run)
    says(rollfem.done(*run, "--resume").err, "solutions of an earlier run")
    resumed = rollfem.models("killed")[0]
    assert resumed["name"] == whole["name"]
    for name in "max_pressure", "traction_coefficient":
        assert [point[name] for point in resumed["points"]] == [point[name] for point in whole["points"]]
    assert len(whole["points"]) == 4


def test_takes_bodies_that_are_not_known_as_half_spaces(rollfem):
    model = model_of(rollfem, {"load.normal_force": 1e3, "friction.coefficient": 0.3,
                               "undeformed_distance.quadratic": [0.001, 0.002], "rolling.problem": "frictionless"})
    says(model["choice"], "model unknown: only the undeformed distance of the bodies is known")
