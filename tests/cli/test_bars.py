# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every scalar in the results has an error bar or a reason why it has none, for all models and kinds of problems."""

import math
import re

import pytest
from program import SMALL, SOURCE, needs_fem, rolling

WORDS = {"exact", "given", "counted", "theory", "measured", "one grid", "balance"}
THEORIES = "hertz linear vermeulen-johnson polach carter fastsim fastrip strip halfspace".split()


def solved(rollfem, keys, models):
    """The models of a result by their names."""
    rollfem.done("run", rollfem.case(keys), "-o", "out", "-q", "--no-report", "-m", *models)
    return {model["name"]: model for model in rollfem.models("out")}


def models_of(rollfem, keys, models):
    """The same, each of whose numbers has either a valid bar or a word of the list."""
    found = solved(rollfem, keys, models)
    quantities = re.findall(r"^\| `(\w+)`", rollfem.done("docs", "quantities").out, re.M)
    assert len(quantities) > 20
    for model in found.values():
        assert any(note["about"] == "model_error" and note["text"] for note in model["notes"])
        for point in model["points"]:
            bars, without = point["error_estimate"], point["no_bar"]
            for name in quantities:
                assert (name in bars) + (name in without) == (name in point), (model["name"], name)
            assert [name for name, bar in bars.items() if not 0 <= bar < math.inf] == []
            assert {without[name] for name in quantities if name in without} <= WORDS
            assert [name for name, error in point.get("model_error", {}).items() if not error >= 0] == []
    return found


def test_bars_are_there_for_every_number_of_every_model(rollfem):
    models = models_of(rollfem, SMALL | rolling([0.0, 0.001, 0.02], 20), THEORIES)
    without = models["hertz"]["points"][0]["no_bar"]
    assert {without[name] for name in ("max_pressure", "semi_axis_x", "semi_axis_y", "approach", "contact_area")} == {"exact"}
    linear = models["linear"]["points"][1]["no_bar"]
    assert (linear["max_pressure"], linear["longitudinal_force"]) == ("exact", "theory")
    half = models["halfspace"]["points"][1]
    assert half["no_bar"]["normal_force"] == half["no_bar"]["longitudinal_creepage"] == "given"
    assert "model_error" not in half
    assert half["error_estimate"]["contact_length"] > 0 and half["error_estimate"]["contact_width"] > 0


def test_model_errors_cover_the_errors_of_theories(rollfem):
    """The model error of a theory is at least its distance from the half-space, which a fine grid knows up to its bar;
    Hertz's pressure is the half-space's."""
    points = {name: model["points"][0] for name, model in models_of(rollfem, SMALL | rolling(0.001, 80), THEORIES).items()}
    half = points["halfspace"]
    for name in THEORIES[1:-1]:
        theory, errors = points[name], points[name]["model_error"]
        for quantity in "longitudinal_force", "traction_coefficient", "max_pressure":
            assert errors[quantity] >= abs(theory[quantity] - half[quantity]) - half["error_estimate"][quantity], name
        assert (errors["max_pressure"] == 0) == (name != "strip") and errors["traction_coefficient"] > 0, name
    assert points["hertz"]["model_error"]["max_pressure"] == 0


def test_model_errors_vanish_where_theories_are_exact(rollfem):
    """Like rollers: Hertz's and Carter's closed forms leave nothing of the half-plane out. Unlike ones: friction moves the
    pressure."""
    rollers = {"load.normal_force": 16.2, "friction.coefficient": 0.3, "wheel.young_modulus": 210e3,
               "wheel.poisson_ratio": 0.3, "rail.young_modulus": 210e3, "rail.poisson_ratio": 0.3, "geometry.shape": "line",
               "geometry.relative_radius": 25.0} | rolling([0.0, 5e-4], 20)

    def errors(keys, models):
        return {name: [point["model_error"] for point in model["points"]]
                for name, model in solved(rollfem, keys, models).items()}

    like = errors(rollers, ["hertz", "carter"])
    assert {value for model in like.values() for point in model for value in point.values()} == {0.0}
    assert "longitudinal_force" in like["carter"][1] and "max_pressure" in like["hertz"][0]
    unlike = errors(rollers | {"rail.young_modulus": 70e3}, ["carter"])["carter"][1]
    assert unlike["longitudinal_force"] > 0 and unlike["max_pressure"] > 0


def test_bars_are_there_for_creepages_found_for_a_force(rollfem):
    models = models_of(rollfem, SMALL | {"contact_grid.elements_across": 20, "rolling.longitudinal_force": -10e3},
                       ["hertz", "halfspace"])
    # Without friction there is no force to find.
    assert models["hertz"]["points"][0]["model_error"]["max_pressure"] == 0
    point = models["halfspace"]["points"][0]
    assert point["error_estimate"]["longitudinal_creepage"] > 0 and point["no_bar"]["lateral_creepage"] == "given"


@pytest.mark.parametrize("change", [
    {"load.normal_force": None, "load.approach": 0.05, "output.stress_maxima": True},
    {"rolling.problem": "shift", "history.longitudinal_shift": 0.001}], ids=["approach", "shift"])
def test_bars_are_there_for_other_problems(rollfem, change):
    models_of(rollfem, SMALL | change | {"contact_grid.elements_across": 12}, ["hertz", "halfspace"])


def wheel_with(line):
    """The right wheel of S1002 on UIC60 on few elements, with a line in place of its creepages."""
    text = (SOURCE / "cases/s1002_uic60_right.toml").read_text("utf-8")
    for piece, by in {"longitudinal_creepage = [0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]": "",
                      "elements_across = 40": "elements_across = 12", "lateral_shift = 2.0": line + "\nlateral_shift = 2.0"}.items():
        assert piece in text
        text = text.replace(piece, by)
    return text


def test_bars_are_there_for_patches_of_profiles(rollfem):
    models = models_of(rollfem, wheel_with(""), ["hertz", "fastsim", "strip", "halfspace"])
    for model in models.values():
        assert "vertical_force" in model["points"][0]
    for name in "hertz", "fastsim":  # an ellipse no longer represents the contact of true profiles
        assert models[name]["points"][0]["no_bar"]["max_pressure"] == "theory"


def test_bars_are_there_for_the_balance_of_a_wheelset(rollfem):
    models = models_of(rollfem, wheel_with('free_rolling = "force"'), ["halfspace"])
    assert 0 < models["halfspace"]["points"][0]["error_estimate"]["longitudinal_creepage"] < 1e-4


@needs_fem
def test_bars_are_there_for_finite_elements(rollfem):
    models = models_of(rollfem, SMALL | {"fem.cell_size": 2.0, "fem.extent": 40.0, "rolling.longitudinal_creepage": 0.001,
                                         "output.fields": False}, ["fem"])
    assert models["fem"]["points"][0]["error_estimate"]["max_pressure"] > 0
