# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command study: levels, orders, references, patches of profiles, refusals, and what it takes up after a kill."""
import json
import math
import pathlib

import pytest
from program import FEM, SMALL, SOURCE, WHEEL_ON_RAIL, rolling, says
from resuming import killed, records, timeless

QUICK = SMALL | rolling([0.0, 0.001], 20)
# Levels of 10, 20, 40 and 80 across; the last takes a second or so.
SLOW = SMALL | rolling([0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004], 96) | {"rolling.spin": 1e-4}


def wheel(side, shifts, across=20):
    return WHEEL_ON_RAIL | {"models": ["halfspace"], "wheelset.side": side, "wheelset.lateral_shift": shifts,
                            "wheelset.roll": 0.0} | rolling(0.001, across)


def pressures(rollfem, table):
    return [row for row in rollfem.rows(table) if row["quantity"] == "max_pressure"]


def test_shows_the_order_of_the_half_spaces_pressure(rollfem):
    outcome = rollfem.done("study", rollfem.case(QUICK, "quick.toml"))
    assert "warning" not in outcome.err
    for name in "study.csv", "study.html", "figures/speed_error.svg":
        assert rollfem.holds(f"results/quick_study/{name}"), name
    place, = rollfem.json("results/quick_study/study.json")["places"]
    assert place["references"]["max_pressure"]["kind"] == "exact"
    assert [level["label"] for level in place["series"][0]["levels"]] == [f"{5 << k} across" for k in range(5)]
    # docs/counts.md: p0 converges with order 2; the error at 80 across is 1.4e-4.
    rows = pressures(rollfem, "results/quick_study/study.csv")
    assert [float(row["order"]) for row in rows[2:]] == pytest.approx([2.0] * 3, abs=0.35)
    assert float(rows[4]["error"]) == pytest.approx(1.4e-4, abs=0.4e-4)
    says(outcome.out, "80 across")
    # Without a checksum its numbers may be damaged.
    sealed = rollfem.text("results/quick_study/study.json")
    (rollfem.work / "results/quick_study/study.json").write_text(sealed[:sealed.rfind(",")] + "\n}\n", "utf-8")
    says(rollfem.call("report", "results/quick_study").err, "its checksum")


def test_a_finer_level_is_the_reference_where_the_levels_show_no_limit(rollfem):
    case, key = rollfem.case(QUICK), "traction_coefficient:2"

    def rows_and_series(*more):
        out = rollfem.done("study", case, "--levels", "2", "--reference", "finest", "--no-report", "-o", "out", *more).out
        rows = [row for row in rollfem.rows("out/study.csv") if row["quantity"] == key]
        return out, rows, rollfem.json("out/study.json")["places"][0]["series"][0]

    out, rows, series = rows_and_series()
    rollfem.done("run", case, "-m", "halfspace", "--set", "contact_grid.elements_across=20", "-o", "fine")  # the levels: 5, 10
    fine = rollfem.models("fine")[0]["points"][1]["traction_coefficient"]
    level, = series["reference_level"]
    assert (level["label"], series["references"][key]["kind"]) == ("20 across", "finer level") and level["seconds"] > 0
    says(out, "(20 across)")
    assert len(rows) == 2
    for row in rows:
        assert float(row["error"]) == pytest.approx(abs(float(row["value"]) - fine) / 0.55, rel=1e-6) and float(row["error"]) > 1e-6
    out, rows, series = rows_and_series("--reference-seconds", "0")
    assert series["reference_level"] == [] and float(rows[1]["error"]) == 0.0
    out, rows, series = rows_and_series("--reference-seconds", "1e-9")
    says(out, "no finer level as a reference: 20 across would take some")


def test_follows_the_creepage_found_for_a_force(rollfem):
    # For a small force on a circle with nu = 0.25: Kalker's C11 = 4.12 (1967, table of the thesis), with the part of
    # Vermeulen and Johnson's law that is beyond linear.
    circle = SMALL | {"wheel.poisson_ratio": 0.25, "rail.transverse_radius": 405.0, "rail.poisson_ratio": 0.25,
                      "rolling.longitudinal_force": -275.0}
    outcome = rollfem.done("study", rollfem.case(circle, "force.toml"), "--levels", "3")
    says(outcome.out, "longitudinal creepage found at load point 1", "creepage ")
    place, = rollfem.json("results/force_study/study.json")["places"]
    assert "traction_coefficient:1" not in place["references"]
    a = (0.75 * 50e3 * 405.0 / (210e3 / (2.0 * (1.0 - 0.0625)))) ** (1 / 3)
    bound = 0.55 * 50e3
    creepage = 3.0 * bound / (84e3 * a * a * 4.12) * (1.0 - (1.0 - 275.0 / bound) ** (1 / 3))
    assert place["series"][0]["limits"]["longitudinal_creepage:1"]["value"] == pytest.approx(creepage, rel=0.02)
    assert rollfem.holds("results/force_study/figures/values.svg")


def test_takes_all_models_and_given_references(rollfem):
    several = ["hertz", "linear", "fastsim", "strip", "halfspace"]
    rollfem.done("study", rollfem.case(QUICK), "--levels", "2", "--no-report", "-o", "out", "--reference", "max_pressure=1000",
                 "traction_coefficient:2=0.1", "--models", *(several if FEM else ["all"]))  # with finite elements minutes
    place, = rollfem.json("out/study.json")["places"]
    assert place["references"]["max_pressure"]["kind"] == "given"
    models = [series["model"] for series in place["series"]]
    assert [models.count(name) for name in several] == [1] * 5
    for row in pressures(rollfem, "out/study.csv"):
        assert float(row["error"]) == pytest.approx(abs(float(row["value"]) / 1000.0 - 1.0), abs=1e-9)


def test_the_pressure_of_the_left_wheel_converges_with_order_two(rollfem):
    outcome = rollfem.done("study", rollfem.case(wheel("left", 2.0, 40)), "--no-report", "-o", "out")
    says(outcome.out, "left wheel, position 1: halfspace, refined in grid")
    study = rollfem.json("out/study.json")
    place, = study["places"]
    assert (place["key"], place["lateral_shift"]) == ("left_1_1", 2.0) and study["notes"]
    # Between neighbouring grids the order jumps, as the kink in curvature lies differently in their elements: all levels
    # together show it.
    limit = place["series"][0]["limits"]["max_pressure"]
    assert "order" in limit
    values = [float(row["value"]) for row in pressures(rollfem, "out/study.csv")]
    assert len(values) == 5
    assert math.log2(abs(values[0] - limit["value"]) / abs(values[3] - limit["value"])) / 3 == pytest.approx(2.0, abs=0.3)
    assert limit["uncertainty"] < 0.3  # MPa, 3e-4 of the value
    # CONTACT: 1011.2 MPa and 16.2 mm.
    assert [limit["value"], values[4]] == pytest.approx([1011.2] * 2, rel=0.001)
    rows = rollfem.rows("out/study.csv")
    assert [float(row["value"]) for row in rows if row["quantity"] == "contact_width"][4] == pytest.approx(16.2, abs=0.1)
    assert not any(row["quantity"] == "semi_axis_x" for row in rows)


def test_every_patch_is_a_series_with_one_balance(rollfem):
    outcome = rollfem.done("study", rollfem.case(wheel("both", [0.0, 2.0])), "--levels", "3", "-o", "out", "--reference",
                           "right_2_1.max_pressure=1510.7")
    places = rollfem.json("out/study.json")["places"]
    assert [place["key"] for place in places] == ["left_1_1", "right_1_1", "left_2_1", "right_2_1"]
    for place in places:
        assert len(place["series"][0]["levels"]) == 3
        assert (place["references"]["max_pressure"]["kind"] == "given") == (place["key"] == "right_2_1")
        assert rollfem.holds(f"out/figures/error_unknowns_{place['key']}.svg")
    # Found once, not for each of the twelve levels.
    assert outcome.err.count("balance") == 1
    says(rollfem.text("out/study.html"), "Largest pressure of every patch", "right wheel, position 2")
    says(rollfem.text("out/study.csv"), "\nright_2_1,halfspace,grid,")


@pytest.mark.parametrize("more, part", [
    (["--vary", "degrees"], "cannot be refined"), (["--vary", "gird"], "did you mean grid? "),
    (["--vary", "domain"], "no model of this study"), (["--levels", "1"], "allowed: 2 to 8"), (["--reference-seconds", "-1"], "allowed: 0 or more"),
    (["--reference", "best"], "not a reference"), (["--reference", "max_pressure=abc"], "not a number"),
    (["--reference", "traction_coefficient:3=0.1"], "unknown quantity in this case"), (["--model", "nope"], "no such model")])
def test_refuses(rollfem, more, part):
    rollfem.refuses("study", rollfem.case(QUICK), *more, says=part)
    assert rollfem.made() == []


def test_refuses_a_call_without_a_case(rollfem):
    rollfem.refuses("study", says="no case file is named")


@pytest.mark.parametrize("more, part", [
    *([(["--model", "fem", "--vary", "domain"], "true sections of rail and rim")] if FEM else []),
    (["--reference", "exact"], "no exact value is known"), (["--reference", "max_pressure=1000"], "the case has several patches"),
    (["--reference", "left_1_1.semi_axis_x=6"], "unknown quantity in this case")])
def test_refuses_what_makes_no_sense_for_patches(rollfem, more, part):
    rollfem.refuses("study", rollfem.case(wheel("both", 2.0)), "-q", *more, says=part)
    assert rollfem.made() == []


def study(case, folder, *more):
    return "study", case, "-o", folder, "--no-report", "--reference-seconds", "0", *(more or ("-q", "--levels", "4"))


def levels_and_points(unfinished):
    """The numbers of stored levels, and of load points of the level at work."""
    points = len(list(unfinished.glob("*-of-*.point")))
    return records(unfinished, "level-") - points, points


def leave_unfinished(rollfem, case):
    """Kills a study in the middle of its last level; the number of levels that it has stored."""
    unfinished = rollfem.work / "out.unfinished"

    def in_the_last_level():
        levels, points = levels_and_points(unfinished)
        return levels >= 2 and points >= 2
    killed(rollfem, in_the_last_level, *study(case, "out"))
    assert not rollfem.holds("out")
    return levels_and_points(unfinished)[0]


def test_finished_levels_and_load_points_are_taken_up(rollfem):
    case = rollfem.case(SLOW)
    rollfem.done(*study(case, "whole"))
    assert not rollfem.holds("whole.unfinished")
    kept = leave_unfinished(rollfem, case)
    outcome = rollfem.done(*study(case, "out", "--levels", "4", "--resume"))
    assert outcome.err.count(" across: resumed\n") == kept
    whole, out = (rollfem.work / name for name in ("whole", "out"))
    assert timeless(whole / "study.json") == timeless(out / "study.json")
    for name in "whole", "out":
        levels = rollfem.json(f"{name}/study.json")["places"][0]["series"][0]["levels"]
        assert all(level["seconds"] > 0 for level in levels)
    first, second = ([{**row, "seconds": ""} for row in rollfem.rows(f"{name}/study.csv")] for name in ("whole", "out"))
    assert first == second
    assert not rollfem.holds("out.unfinished")


def test_levels_of_a_changed_case_are_refused(rollfem):
    leave_unfinished(rollfem, rollfem.case(SLOW))
    changed = rollfem.case(SLOW | {"rolling.spin": 2e-4})
    rollfem.refuses(*study(changed, "out", "-q", "--levels", "4", "--resume"), says="case.toml (or a file that it names) has changed")
    assert not rollfem.holds("out")


def test_levels_of_a_changed_profile_are_refused(rollfem):
    points = (SOURCE / "cases/profiles/hollow_s1002.csv").read_text("utf-8")
    profile = pathlib.Path(rollfem.file("wheel.csv", points))
    case = rollfem.case(WHEEL_ON_RAIL | {"wheel.profile": "wheel.csv", "rail.profile": "60E1", "load.vertical_force": 80e3}
                        | rolling([0.0, 0.0005, 0.001, 0.0015, 0.002, 0.0025, 0.003], 40))
    leave_unfinished(rollfem, case)
    profile.write_text(points + "\n", "utf-8")
    rollfem.refuses(*study(case, "out", "-q", "--levels", "4", "--resume"), says="has changed")


def test_without_resume_the_study_says_that_there_is_something(rollfem):
    case = rollfem.case(SLOW)
    leave_unfinished(rollfem, case)
    says(rollfem.done(*study(case, "out", "-q", "--levels", "2")).err, "--resume would continue from them")
    assert not rollfem.holds("out.unfinished")


def test_under_mpirun_the_levels_are_divided_among_the_processes(rollfem):
    case = rollfem.case(QUICK)
    rollfem.done(*study(case, "whole", "--levels", "3"))
    rollfem.done(*study(case, "out", "--levels", "3"), processes=2)
    assert timeless(rollfem.work / "whole/study.json") == timeless(rollfem.work / "out/study.json")
    assert json.loads(rollfem.text("out/study.json"))["processes"] == 1
    assert not list(rollfem.work.glob("out.*"))


def test_follows_the_largest_stresses_of_the_case_and_any_other_scalar(rollfem):
    # Hertz on a sphere: the largest orthogonal shear on y = 0 is 0.214 p0 of a circle (Johnson 1985), p0 = 1.5 F / (pi a^2).
    case = SMALL | {"wheel.transverse_radius": 500.0, "wheel.rolling_radius": 500.0, "rail.transverse_radius": math.inf,
                    "output.stress_maxima": True, "rolling.longitudinal_creepage": 0.0, "contact_grid.elements_across": 40}
    rollfem.done("study", rollfem.case(case), "--levels", "2", "--quantity", "contact_area", "elastic_energy", "-o", "out")
    rows = rollfem.rows("out/study.csv")
    found = {row["quantity"]: float(row["value"]) for row in rows if row["level"] == rows[-1]["level"]}
    assert found["max_orthogonal_shear_rail"] / found["max_pressure"] == pytest.approx(0.214, abs=0.004)
    assert found["contact_area"] == pytest.approx(math.pi * found["semi_axis_x"] * found["semi_axis_y"], rel=0.02)
    assert found["elastic_energy"] > 0
    page = rollfem.text("out/study.html")
    assert "largest orthogonal shear stress in the rail" in page and "contact area" in page
    rollfem.refuses("study", rollfem.case(case), "--quantity", "beauty", says="is no scalar of a load point")


@pytest.mark.skipif(not FEM, reason="without finite elements")
def test_levels_begin_where_the_patch_has_enough_cells(rollfem):
    # Hertz: 2 b = 9.09 mm, in which cells of 3.2 mm fit 2.8 times.
    case = SMALL | {"load.normal_force": 60e3, "wheel.rolling_radius": 460.0, "wheel.transverse_radius": math.inf,
                    "rail.transverse_radius": 300.0, "rolling.longitudinal_creepage": 0.0, "fem.cell_size": 0.8}
    outcome = rollfem.done("study", rollfem.case(case), "--model", "fem", "--no-report", "--reference-seconds", "0", "-o", "out")
    assert "study: fem 1.6 mm: " in outcome.err and "study: fem 3.2 mm: " not in outcome.err  # which is not solved
    series, = rollfem.json("out/study.json")["places"][0]["series"]
    says(series["left_out"], "3.2 mm: only 2.8 cells across the patch")
    assert [level["parameter"] for level in series["levels"]] == [1.6, 0.8]
