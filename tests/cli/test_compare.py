# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands compare and bench: several models and cases, skipped and failed models, resuming; errors and seconds."""
import re

import pytest
from program import SMALL, rolling, says

QUICK = SMALL | rolling([0.0, 0.001], 10)
# Which theories cannot take.
FORCES = SMALL | {"rolling.longitudinal_force": -1000.0, "contact_grid.elements_across": 10}


def test_lays_models_of_several_cases_beside_each_other(rollfem):
    one, two = (rollfem.case({"title": f"<{name}>"} | QUICK, f"{name}.toml") for name in ("one", "two"))
    outcome = rollfem.done("compare", one, two, "--model", "hertz", "fastsim", "halfspace")
    assert "warning" not in outcome.err
    for name in "compare.json", "compare.csv", "compare.html", "one/summary.json", "one/results.h5", "two/report.html":
        assert rollfem.holds(f"results/compare/{name}"), name
    says(outcome.out, "Within the error bars of halfspace, hertz: ")
    found = rollfem.json("results/compare/compare.json")
    assert len(found["cases"]) == 2
    says(outcome.out, found["verdict"])
    page = rollfem.text("results/compare/compare.html")
    says(page, "Comparison of models on 2 cases", "&lt;two&gt;", "Within the error bars of half-space, ", "Cost", 'id="one"',
         "largest longitudinal traction |p<sub>x</sub>|<br><span class=d>% of μ p<sub>0</sub>")
    assert "<two>" not in page and "bars of halfspace" not in page and " of mu" not in page
    # The same numbers as run's own, and the half-space within a coarse grid's error of Hertz, which is exact.
    first = {model["name"]: model["points"][0]["max_pressure"] for model in rollfem.models("results/compare/one")}
    rows = {row["model"]: row for row in rollfem.rows("results/compare/compare.csv")
            if (row["case"], row["quantity"], row["point"]) == ("one", "max_pressure", "1")}
    assert {name: float(row["value"]) for name, row in rows.items()} == first and len(first) == 3
    assert -2.0 < float(rows["halfspace"]["difference"]) < 0.0  # percent


def test_models_may_stand_before_the_case_and_the_reference_is_chosen(rollfem):
    outcome = rollfem.done("compare", "--no-report", "--reference", "hertz", "--model", "hertz", "halfspace",
                           rollfem.case(QUICK, "one.toml"))
    says(outcome.out, "error bars of hertz: ")
    assert rollfem.holds("results/compare_one/compare.json") and not rollfem.holds("results/compare_one/compare.html")


def test_a_model_that_cannot_take_a_case_is_left_out_with_a_sentence(rollfem):
    outcome = rollfem.done("compare", rollfem.case(FORCES), "--model", "hertz", "polach", "halfspace", "-o", "out")
    says(outcome.out, "polach: left out: ")
    assert "do: run with" not in outcome.out
    missing, = rollfem.json("out/compare.json")["cases"][0]["missing"]
    assert not missing["failed"]
    says(rollfem.text("out/compare.html"), "is left out")


def test_a_case_that_no_model_takes_is_an_error_that_names_each_with_its_reason(rollfem):
    none, more = rollfem.case(FORCES, "forces.toml"), ["--no-report", "--model", "polach", "linear", "-o", "out"]
    alone = rollfem.call("compare", none, *more)
    assert alone.status == 2
    says(alone.err, "none of the models can solve forces: polach: ", "; linear: ", "prescribed tangential force", "; do: name one")
    # Beside a case that they can take, which is written.
    both = rollfem.call("compare", none, rollfem.case(QUICK, "good.toml"), *more)
    assert both.status == 2
    says(both.err, "none of the models can solve forces")
    says(rollfem.text("out/compare.csv"), '\n"good",')
    assert not rollfem.json("out/compare.json")["cases"][0]["complete"]
    assert not list(rollfem.work.rglob("*.lock"))


def test_a_failure_keeps_the_other_results_and_is_reported_last(rollfem):
    # The half-space ends at 320 elements across, short of this accuracy.
    bad = rollfem.case({"accuracy": 1e-5} | SMALL | rolling(0.001, 20), "bad.toml")
    outcome = rollfem.call("compare", bad, rollfem.case(QUICK, "good.toml"), "--no-report", "--model", "hertz", "halfspace", "-o", "out")
    assert outcome.status == 1
    says(outcome.err, "rollfem: the comparison was written without the models that failed: bad, halfspace: accuracy = 1e-05 was "
         "not reached")
    first, second = rollfem.json("out/compare.json")["cases"]
    assert first["missing"][0]["failed"] and not second["missing"]
    says(rollfem.text("out/compare.csv"), '\n"good",')


def test_a_wrong_case_is_refused_before_anything_is_computed(rollfem):
    good, bad = rollfem.case(QUICK, "good.toml"), rollfem.case(QUICK | {"rolling.no_such_key": 0}, "bad.toml")
    rollfem.refuses("compare", good, bad, "--model", "hertz", "-o", "out", says="no_such_key")
    assert rollfem.made() == []


def test_resume_keeps_finished_runs(rollfem):
    one, two = (rollfem.case(QUICK, f"{name}.toml") for name in ("one", "two"))
    more = ["--model", "hertz", "halfspace", "--no-report", "-o", "out"]
    rollfem.done("compare", one, *more)
    before = (rollfem.work / "out/one/results.h5").stat().st_mtime_ns
    # The state after a kill between writing the result and removing its records.
    rollfem.file("work/out/one.unfinished/halfspace-0001.point", "record")
    rollfem.file("work/out/one.unfinished/about.txt", "Load points of an unfinished run of rollfem.")
    first = rollfem.rows("out/compare.csv")
    says(rollfem.done("compare", one, two, "--resume", *more).err, "compare: one was already done")
    assert (rollfem.work / "out/one/results.h5").stat().st_mtime_ns == before
    assert not rollfem.holds("out/one.unfinished")
    assert len(rollfem.json("out/compare.json")["cases"]) == 2
    assert [row for row in rollfem.rows("out/compare.csv") if row["case"] == "one"] == first


def test_resume_computes_again_once_a_file_that_the_case_names_has_changed(rollfem):
    def distance(curvature):
        rollfem.file("distance.csv", "".join(f"{2 * i},{2 * j},{curvature * 4 * (i * i + j * j)}\n"
                                             for j in range(-5, 6) for i in range(-5, 6)))

    def pressure():
        return rollfem.point("out/one")["max_pressure"]

    distance(1e-3)
    case = rollfem.case({"load.normal_force": 5e4, "friction.coefficient": 0.3, "undeformed_distance.file": "distance.csv",
                         "contact_grid.elements_across": 8}, "one.toml")
    call = "compare", case, "--model", "halfspace", "--no-report", "-o", "out"
    rollfem.done(*call)
    before = pressure()
    says(rollfem.done(*call, "--resume").err, "compare: one was already done")
    distance(2e-3)
    rollfem.done(*call, "--resume")
    assert pressure() > 1.2 * before


def test_refuses_what_makes_no_sense(rollfem):
    one = rollfem.case(QUICK, "one.toml")
    rollfem.refuses("compare", says="no case file is named")
    rollfem.refuses("compare", one, "--model", "hertzz", says="no such model")
    rollfem.refuses("compare", one, "--model", "hertz", "--reference", "strip", says="not among the models compared")
    rollfem.refuses("compare", one, rollfem.file("other/one.toml", QUICK), "--model", "hertz", says="would both be written to")
    rollfem.done("run", one, "--model", "hertz", "--no-report", "-o", "out")
    rollfem.refuses("compare", one, "--model", "hertz", "-o", "out", says="the result of another command")


@pytest.mark.parametrize("command", [["compare"], ["study"], ["bench", "--quick"]])
def test_says_at_once_what_is_missing_without_python(rollfem, command):
    case = [] if command[0] == "bench" else [rollfem.case(QUICK)]
    rollfem.refuses(*command, *case, ROLLFEM_PYTHON="/nowhere/python3", says=f"{command[0]}: cannot run /nowhere/python3")
    assert rollfem.made() == []


def test_bench_quickly_says_errors_and_seconds_of_the_models(rollfem):
    outcome = rollfem.done("bench", "--quick", ROLLFEM_CACHE="cache")
    says(outcome.out, "seconds", "\nhertz ", "\nlinear ", "\nstrip ")
    force = {(model, across): abs(float(error)) for model, across, error in
             re.findall(r"^(\S+) +(\S+) .*?([+-][\d.]+) % +[\d.]+$", outcome.out, re.M)}
    # Errors fall with the grid; theories keep their model error.
    assert force["halfspace", "24"] < 0.6 and force["halfspace", "40"] < 0.25
    assert force["linear", "-"] > 5.0
    assert not rollfem.holds("cache")
