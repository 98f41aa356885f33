# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command run: its files and messages on success and on failure."""

import pytest
from program import FEM, SMALL, SOURCE, refused, rolling, says

QUICK = {"models": ["hertz", "halfspace"]} | SMALL | rolling([0.0, 0.001], 10)
SHIFT = {"rolling.problem": "shift", "history.longitudinal_shift": 0.001}


def plain(text):
    """Whether a text has no control characters but ends of lines."""
    return not any(c < " " and c != "\n" or c == "\x7f" for c in text)


def test_a_report_that_could_not_be_drawn_is_status_1_with_the_results_written(rollfem):
    for words in ["run", rollfem.case(QUICK), "-o", "out"], ["profile", "S1002", "-o", "out"]:
        rollfem.done(*words)
        outcome = rollfem.call(*words, ROLLFEM_PYTHON="/nowhere/python3")
        assert outcome.status == 1
        says(outcome.err, "not drawn: ")
    assert rollfem.holds("out/summary.json") and rollfem.holds("out/profile.csv")


def test_leaves_results_and_says_where(rollfem):
    outcome = rollfem.done("run", rollfem.case(QUICK, "quick.toml"))
    assert "warning" not in outcome.err
    for name in "summary.json", "results.h5", "creep_curve.csv", "report.html":
        assert rollfem.holds(f"results/quick/{name}"), name
    hertz, halfspace = rollfem.models("results/quick")
    assert (hertz["name"], halfspace["name"], len(halfspace["points"])) == ("hertz", "halfspace", 2)
    # The printed table and the file are the same numbers.
    says(outcome.out, "results: results/quick\n", f"{hertz['points'][0]['max_pressure']:12.3f}")


def test_leaves_no_file_of_an_earlier_run_in_its_folder(rollfem):
    for directory, friction in ("fresh", 0.1), ("again", 0.5), ("again", 0.1):
        rollfem.done("run", rollfem.case(QUICK | {"friction.coefficient": friction}), "--no-report", "-o", directory)
    for name in "pass_work.csv", "path_x.csv", "path_y.csv":
        assert rollfem.text(f"again/{name}") == rollfem.text(f"fresh/{name}")


def test_a_report_is_drawn_of_a_file_whose_name_is_not_utf8(rollfem):
    rollfem.done("run", rollfem.case(QUICK, "latin\udce9.toml"), "-o", "out")
    assert rollfem.holds("out/report.html")


@pytest.mark.parametrize("problem, stage, note", [
    ({"rolling.problem": "frictionless"}, "frictionless", "; normal problem only"),
    (SHIFT | {"history.longitudinal_shift": [0.001, 0.001]}, "shift              2/2 ", "; shift without rolling")])
def test_says_which_problem_is_solved(rollfem, problem, stage, note):
    file = rollfem.case(SMALL | problem | {"contact_grid.elements_across": 10})
    outcome = rollfem.done("run", file, "--model", "halfspace", "--no-report")
    says(outcome.err, stage)
    says(outcome.out, note)
    assert " xi " not in outcome.err and "rolling " not in outcome.err and "upwind" not in outcome.out


def test_takes_models_from_the_command_line_in_any_place(rollfem):
    file = rollfem.case(QUICK)
    for words in (["--model", "hertz", file, "-q"], [file, "-q", "-m", "hertz"], ["-q", "--model=hertz", file],
                  ["-q", "--model", "hertz", "--model", "hertz", file]):
        rollfem.done("run", "--no-report", *words)
        assert len(rollfem.models("results/case")) == 1


def test_without_a_terminal_prints_no_control_characters_and_a_plain_line_per_stage(rollfem):
    outcome = rollfem.done("run", "--no-report", rollfem.case(QUICK), TERM="xterm")
    assert plain(outcome.err) and plain(outcome.out), outcome
    says(outcome.err, "halfspace")
    assert outcome.err.count("\n") < 20


def test_without_a_report_gets_it_later(rollfem):
    rollfem.done("run", "--no-report", rollfem.case(QUICK), "-o", "result")
    assert not rollfem.holds("result/report.html")
    rollfem.done("report", "result")
    assert rollfem.holds("result/report.html")
    (rollfem.work / "empty").mkdir()
    for folder in "nowhere", "empty":
        rollfem.refuses("report", folder, says=f"{folder} holds no result; do: ")


def test_quiet_prints_nothing_and_writes_to_the_named_folder(rollfem):
    outcome = rollfem.done("run", "--quiet", "--no-report", "--model", "hertz", "-o", "a/b", rollfem.case(QUICK))
    assert outcome.out + outcome.err == ""
    assert rollfem.holds("a/b/summary.json")


def test_an_existing_foreign_folder_is_kept_and_refused_before_computing(rollfem):
    file = rollfem.case(QUICK)
    for precious in "mine/thesis.txt", "out.unfinished/thesis.txt", "locked.lock":
        rollfem.file(f"work/{precious}", "years of work")
    before = rollfem.made()
    for directory, said in {file: "", file + "/below": "", "/proc/no/such": "", ".": "is the current folder",
                            "/": "/ is the root folder", "mine": "holds files that are not", "out": "thesis.txt",
                            "locked": "is in the way"}.items():
        outcome = rollfem.call("run", file, "-o", directory)
        refused(outcome, said)
        assert "normal" not in outcome.err  # no progress line
    assert rollfem.made() == before and rollfem.text("locked.lock") == "years of work"


def test_a_grid_beyond_all_memory_is_an_error_not_a_crash(rollfem):
    vast = {"contact_grid.elements_across": None, "contact_grid.cell_size": [1e-5, 1e-5]}
    outcome = rollfem.call("run", rollfem.case(QUICK | vast))
    assert outcome.status in (1, 2)
    says(outcome.err, "rollfem: ")
    assert rollfem.made() == []


def test_only_the_first_process_of_a_parallel_run_works_on_the_half_space(rollfem):
    other = rollfem.done("run", rollfem.case(QUICK), OMPI_COMM_WORLD_RANK="1", OMPI_COMM_WORLD_SIZE="2")
    assert other.out + other.err == "" and rollfem.made() == []


def test_all_theories_are_models_with_their_curves_and_figures(rollfem):
    models = "hertz linear vermeulen-johnson polach carter fastsim fastrip strip halfspace".split()
    rollfem.done("run", rollfem.case(QUICK), "-o", "out", "-m", *models)
    assert [model["name"] for model in rollfem.models("out")] == models
    says(rollfem.text("out/report.html"), "FASTSIM", "FaStrip", "Vermeulen-Johnson", "Carter", "Polach",
         "linear theory", "strip")


def test_a_model_that_cannot_take_the_case_is_refused_before_any_is_run(rollfem):
    rollfem.refuses("run", rollfem.case(SMALL | SHIFT), "-m", "halfspace", "fastsim", says="model fastsim: rolling.problem")
    assert rollfem.made() == []


def test_points_below_the_surface_come_out_as_a_table(rollfem):
    file = rollfem.case(QUICK | {
        "subsurface.line": [{"from": [0, 0, 0.5], "to": [0, 0, 6], "points": 12}],
        "subsurface.plane": [{"body": "rail", "from": [-4, 0, -1], "to": [4, 0, -1], "across": [-4, 0, -5], "points": [9, 5]}]})
    rollfem.done("run", "-q", file, "-o", "out")
    # Twelve points at each of two load points; planes are in results.h5 alone.
    assert len(rollfem.rows("out/subsurface.csv")) == 2 * 12
    hertz = rollfem.done("run", "--no-report", file, "-m", "hertz")
    says(hertz.out, "no stress below the surface; models that compute it: halfspace")


def test_a_shift_and_a_given_pressure_are_reported_step_by_step(rollfem):
    for name in "cattaneo", "benchmark9":
        assert "warning" not in rollfem.done("run", SOURCE / f"cases/{name}.toml").err
        assert rollfem.holds(f"results/{name}/report.html")
    steps = rollfem.models("results/cattaneo")[1]["points"]
    assert len(steps) == 15
    # Cattaneo: after the shift of 0.008172 mm the force is 7/8 mu F_z.
    assert steps[2]["longitudinal_shift"] == pytest.approx(0.008172, abs=1e-12)
    assert steps[2]["traction_coefficient"] == pytest.approx(0.35, rel=0.003)


def test_creepages_found_for_a_force_are_tabulated_and_give_the_force_back(rollfem):
    def solved(motion):
        keys = {"models": ["halfspace"]} | SMALL | {"contact_grid.elements_across": 16, "rolling.spin": 1e-4} | motion
        return rollfem.done("run", rollfem.case(keys), "-o", "out").out, rollfem.point("out")

    out, _ = solved({"rolling.longitudinal_force": -9e3, "rolling.lateral_force": -6e3})
    found = {}
    for name in "longitudinal_creepage", "lateral_creepage":
        row = out.partition(name.replace("_", " ") + " ")[2].splitlines()[2].split()
        assert row[:2] == ["-9000", "-6000"], out
        found[f"rolling.{name}"] = float(row[3])
    report = rollfem.text("out/report.html")
    says(report, "Lateral creepage η, found for the given force", "ξ, found")
    assert "coefficient -F" not in out and "Traction coefficient −" not in report
    assert rollfem.holds("out/figures/creep_found.svg")
    again, back = solved(found)
    assert [back["longitudinal_force"], back["lateral_force"]] == pytest.approx([-9e3, -6e3], abs=1.0)
    says(again, "traction coefficient -F_x/F_z")


@pytest.mark.skipif(FEM, reason="a build with finite elements")
def test_fem_in_a_build_without_it_is_an_error_not_silence(rollfem):
    file = rollfem.case({"models": ["fem"]} | SMALL)
    rollfem.refuses("run", file, says="case.toml: models: model fem is not in this build")
    rollfem.refuses("run", file, "--model", "fem", says="--model: model fem is not in this build")
    assert rollfem.made() == []
