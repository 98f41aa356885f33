# SPDX-License-Identifier: LGPL-2.1-or-later
"""--json on standard output, --quiet, and what --version lists."""

import json

import pytest
from program import FEM, PROGRAM, SMALL, SOURCE, says

MANCHESTER = SOURCE / "cases/manchester_A22.toml"


def test_json_of_check_has_keys_defaults_and_models(rollfem):
    outcome = rollfem.done("check", "--json", rollfem.case(SMALL), "--set", "friction.coefficient=0.25")
    found = json.loads(outcome.out)
    assert found["kind"] == "check"
    for key, value in {"friction.coefficient": 0.25, "wheel.transverse_radius": "inf",
                       "table.check_points": 200}.items():  # the last is a default
        assert found["keys"][key] == value
    assert found["cannot"]["hertz"] == "" and found["contacts"] == []  # contacts: of true profiles
    assert outcome.err == "" and rollfem.made() == []


def test_json_of_check_names_wheels_and_warns(rollfem):
    found = json.loads(rollfem.done("check", "--json", SOURCE / "cases/s1002_uic60_left.toml").out)
    assert found["contacts"][0]["place"]["wheel"] == "left"
    doubtful = rollfem.done("check", "--json", rollfem.case(SMALL | {"load.normal_force": 50.0}))
    assert len(json.loads(doubtful.out)["warnings"]) == 1 and doubtful.err.startswith("warning: ")


def test_json_of_a_wheelset_has_its_table_in_columns(rollfem):
    found = json.loads(rollfem.done("wheelset", "--json", MANCHESTER, "--reach", "2").out)
    columns = found["columns"]
    assert len(columns["lateral_shift"]) == 21 and columns["lateral_shift"][-1] == 2.0
    # A shift to the right raises the right wheel's radius; both are alike in the middle.
    assert columns["radius_left"][0] == pytest.approx(columns["radius_right"][0], abs=1e-9)
    assert columns["radius_right"][20] > columns["radius_left"][20]
    assert found["units"]["radius_left"] == "mm" and columns["conicity_wave"][0] is None
    assert rollfem.made() == []
    rollfem.done("wheelset", "--json", MANCHESTER, "--reach", "2", "-o", "out")
    assert rollfem.holds("out/wheelset.csv")


def test_json_of_a_profile_has_radii_and_points(rollfem):
    rail = json.loads(rollfem.done("profile", "UIC60", "--json").out)["profiles"][0]
    # The smallest arc of the head of UIC 60 (EN 13674-1, 60 E1) has a radius of 13 mm.
    assert rail["smallest_radius_convex"]["radius"] == pytest.approx(13.0, abs=0.05)
    assert len(rail["columns"]["y"]) == len(rail["columns"]["curvature"])
    assert (rail["body"], rail["units"]["curvature"]) == ("rail", "1/mm")
    assert rollfem.made() == []


def test_json_of_bench_has_rows_and_keeps_progress_off_standard_output(rollfem):
    outcome = rollfem.done("bench", "--quick", "--json", ROLLFEM_CACHE="cache")
    errors = [row["force_error"] for row in json.loads(outcome.out)["rows"] if row["model"] == "halfspace"]
    assert errors == pytest.approx([0, 0], abs=0.006)
    says(outcome.err, "halfspace")


def test_json_of_stress_is_its_file(rollfem):
    rollfem.done("run", rollfem.case(SMALL), "-m", "halfspace", "-o", "out", "--no-report")
    before = rollfem.made()
    stress = "stress", "out", "--depth-profile", "--json"
    assert json.loads(rollfem.done(*stress).out)["models"][0]["maxima"]
    assert rollfem.made() == before
    again = rollfem.done(*stress, "-o", "kept", "--no-figures")
    assert again.out == rollfem.text("kept/stress.json")


def test_json_that_cannot_be_written_is_an_error(rollfem):
    assert rollfem.execute("sh", "-c", '"$0" profile UIC60 --json > /dev/full', PROGRAM).status == 1


@pytest.mark.parametrize("words", ["check CASE -q", "bench --quick -q", "cache --quiet", "profile UIC60 -q -o out",
                                   f"wheelset {MANCHESTER} -q -o out"])
def test_quiet_prints_nothing(rollfem, words):
    outcome = rollfem.done(*words.replace("CASE", rollfem.case(SMALL)).split())
    assert outcome.out + outcome.err == "" and rollfem.holds("out") == ("out" in words)


def test_quiet_leaves_warnings_and_json_that_was_asked_for(rollfem):
    doubtful = rollfem.done("check", rollfem.case(SMALL | {"load.normal_force": 50.0}), "-q")
    assert doubtful.out == "" and doubtful.err.startswith("warning: ")
    assert json.loads(rollfem.done("check", rollfem.case(SMALL), "-q", "--json").out)["kind"] == "check"


def test_version_lists_features_and_libraries(rollfem):
    out = rollfem.done("--version").out
    says(out, "\nfinite elements ", "\nPython module ", "\nlibraries ", "Eigen 3.", "HDF5 1.")
    if FEM:
        says(out, "deal.II 9.", "\nMPI              Open MPI", "\nSIMD ", "sse2")
        says(rollfem.done("--version", ROLLFEM_SIMD="sse2").out, "\nSIMD             sse2 (this machine has sse2")
    else:
        says(out, "no (built without deal.II)")
