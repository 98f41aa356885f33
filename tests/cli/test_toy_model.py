# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model registered by one line (tests/support/toy_program.cpp) is there in every command, in help, messages, tables
and reports."""

import h5py
import pytest
from program import SMALL, TOY_PROGRAM, refused, rolling, says

QUICK = SMALL | rolling([0.0, 0.001], 10)


@pytest.fixture
def toy(rollfem):
    return lambda *arguments: rollfem.call(*arguments, program=TOY_PROGRAM)


@pytest.fixture
def done(rollfem):
    return lambda *arguments: rollfem.done(*arguments, program=TOY_PROGRAM)


def test_is_in_help_docs_checks_and_messages(rollfem, toy, done):
    file = rollfem.case({"models": ["stiff"]} | QUICK, "q.toml")
    for command in "run", "compare", "study":
        says(done(command, "--help").out, "the half-space, less compliant")
    says(done("docs", "models").out, "| `stiff` | stiff half-space |")
    says(done("docs", "case-file").out, "halfspace, hybrid, fem, stiff |")
    says(done("check", file, "--all").out, "stiff                  the half-space, less compliant")
    says(toy("run", file, "--model", "stif").err, "halfspace, hybrid, fem, stiff; do: ")
    # Without it the same file is refused, with line, key, value and allowed values.
    without = rollfem.call("check", file)
    for part in "q.toml:1:", 'models = ["stiff"]: is not known', "strip, halfspace, hybrid, fem":
        refused(without, part)
    # Other models name it for cases that only it can take; it refuses cases that it cannot take.
    shift = rollfem.case(SMALL | {"rolling.problem": "shift", "history.lateral_shift": 0.01})
    refused(toy("run", shift, "--model", "fastsim"),
            "allowed: hertz, halfspace, hybrid, fem, stiff; do: run with --model halfspace")
    fast = rollfem.case(SMALL | {"rolling.speed": 5e4, "fem.inertia": True})
    refused(toy("run", fast, "--model", "stiff"), "model stiff: fem.inertia: it cannot handle the inertia of moving bodies; "
            "allowed: fem; do: run with --model fem")
    assert rollfem.made() == []


def test_brings_its_own_section_of_the_case_file(rollfem, toy, done):
    keys = {"stiff.compliance": 0.5}
    file = rollfem.case(QUICK | keys, "k.toml")
    says(done("docs", "case-file").out, "## [stiff]\n\nModel `stiff`.", "| `compliance` | 0.1 to 1 | 0.9 | Compliance over")
    says(done("new-case").out, "[stiff]\n# Compliance over that of the bodies.")
    says(done("check", file, "--all").out, "[stiff]\n  compliance             0.5\n")
    refused(toy("check", file, "--set", "stiff.compliance=2"), "stiff.compliance=2: is out of bounds; allowed: a number from 0.1 to 1; do: ")
    refused(toy("check", file, "--set", "stiff.complyance=0.6"), "did you mean `compliance`?")
    layer = rollfem.case(QUICK | keys | {"layer.thickness": 0.02, "layer.shear_modulus": 800.0}, "l.toml")
    refused(toy("check", layer), "stiff.compliance = 0.5: is too small for a layer; allowed: above 0.5")
    refused(rollfem.call("check", file), "stiff: is not a key of a case file")
    done("run", file, "-m", "halfspace", "stiff", "--no-report", "-o", "out")
    soft, stiff = (model["points"][0]["max_pressure"] for model in rollfem.models("out"))
    assert stiff / soft == pytest.approx(0.5 ** (-2 / 3), abs=1e-6)
    with h5py.File(rollfem.work / "out/results.h5") as stored:
        assert stored["case/keys"].attrs["stiff.compliance"] == 0.5


def test_the_constant_of_a_law_is_a_key_of_that_law(rollfem, toy, done):
    def law(name, power=None):
        return rollfem.case(SMALL | {
            "friction.coefficient": 0.4, "friction.law": name, "friction.kinetic_coefficient": 0.2,
            "friction.half_velocity": 500.0, "friction.power_of_slip": power, "rolling.speed": 10e3})

    says(done("check", law("power", 2.0)).out, "power_of_slip")
    done("check", law("power"))
    refused(toy("check", law("power", 0.5)), "friction.power_of_slip = 0.5")
    refused(toy("check", law("linear", 2.0)),
            'is of the law power, but friction.law is linear; allowed: with law = "power"')
    says(done("docs", "case-file").out, "1 with the law `power`")


def test_runs_beside_the_others_with_its_report(rollfem, done):
    outcome = done("run", rollfem.case(QUICK), "-m", "hertz", "halfspace", "stiff", "-o", "out")
    assert "warning" not in outcome.err
    says(outcome.out, "stiff  ")
    says(outcome.err, "stiff      normal")  # progress
    models = rollfem.models("out")
    assert len(models) == 3 and (models[2]["name"], models[2]["label"]) == ("stiff", "stiff half-space")
    # Pressure goes with the modulus to the power 2/3.
    soft, stiff = (model["points"][0]["max_pressure"] for model in models[1:])
    assert stiff / soft == pytest.approx(0.9 ** (-2 / 3), abs=1e-6)
    says(rollfem.text("out/report.html"), "stiff half-space")


@pytest.mark.parametrize("command", ["compare", "study"])
def test_is_not_in_the_package_that_compares_and_studies(rollfem, toy, command):
    refused(toy(command, rollfem.case(QUICK)), "does not have the model stiff of this program")


def test_goes_on_from_its_checkpoint_and_gives_stresses(rollfem, done):
    done("run", rollfem.case(QUICK), "-m", "stiff", "--no-report", "--resume", "-o", "out")
    places = rollfem.case({"subsurface.point": [{"at": [0, 0, 2]}]}, "places.toml")
    says(done("stress", "out", "--places", places, "--no-figures").out, "stiff")
