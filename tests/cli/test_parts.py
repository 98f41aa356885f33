# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work divided among calls (--part, --merge): the merged result equals that of one call to the last bit, missing parts
are named, and cases that cannot be divided are refused."""

import shutil

import pytest
from program import SMALL, WHEEL_ON_RAIL, says
from resuming import records, same_results

# The balance of each position is solved for, too.
POSITIONS = {"models": ["halfspace"]} | WHEEL_ON_RAIL | {
    "friction.coefficient": 0.3, "wheelset.side": "both", "wheelset.lateral_shift": [0.0, 2.0, 3.0],
    "wheelset.free_rolling": "torque", "contact_grid.elements_across": 16}
TABLE = SMALL | {"table.points": [4, 3, 5], "table.axis_ratio": [0.5, 2.0], "table.largest": [2.0, 2.0, 2.0],
                 "table.check_points": 10}


def test_parts_of_a_row_of_positions_are_one_run(rollfem):
    run = "run", rollfem.case(POSITIONS), "--no-report", "-o"
    rollfem.done(*run, "whole")
    says(rollfem.done(*run, "out", "--part", "2/2").err, "part 2 of 2 is done")
    assert not rollfem.holds("out")
    rollfem.refuses(*run, "out", "--merge", "2", says="missing beside out: 1; do: run the same")
    rollfem.done(*run, "out", "--part", "1/2")
    assert records(rollfem.work / "out.part-1-of-2.unfinished", "balance-") >= 1
    rollfem.done(*run, "out", "--merge", "2")
    same_results(rollfem.work / "whole", rollfem.work / "out")
    assert not list(rollfem.work.glob("out.part-*"))


@pytest.mark.skipif(not shutil.which("mpirun"), reason="no mpirun")
def test_under_mpirun_a_row_is_divided_among_the_processes(rollfem):
    run = "run", rollfem.case(POSITIONS), "--no-report", "-o"
    rollfem.done(*run, "whole")
    says(rollfem.done(*run, "out", processes=2).err, "part 1 of 2 is done")
    same_results(rollfem.work / "whole", rollfem.work / "out")
    assert not rollfem.holds("out.part-2-of-2.unfinished")


def test_parts_of_a_table_are_one_table(rollfem):
    table = "table", rollfem.case(TABLE), "--no-report", "-o"
    rollfem.done(*table, "whole")
    for more in ["--part", "1/2"], ["--part", "2/2"], ["--merge", "2"]:
        rollfem.done(*table, "out", *more)
    for name in "table.csv", "interpolation.csv":
        assert rollfem.text(f"out/{name}") == rollfem.text(f"whole/{name}")


def levels_of_study(rollfem):
    return len(rollfem.json("out/study.json")["places"][0]["series"][0]["levels"])


def test_parts_of_a_study_are_its_levels(rollfem):
    study = "study", rollfem.case(SMALL), "--levels", "3", "--no-report", "-o", "out"
    for part in "1/2", "2/2":
        rollfem.done(*study, "--part", part)
    says(rollfem.done(*study, "--merge", "2").err, "resumed")
    assert levels_of_study(rollfem) == 3


def test_an_empty_part_says_so(rollfem):
    study = "study", rollfem.case(SMALL), "--levels", "2", "--no-report", "-o", "out"
    for part in "1/3", "2/3":
        assert "is empty" not in rollfem.done(*study, "--part", part).err
    says(rollfem.done(*study, "-q", "--part", "3/3").err, "warning: part 3 of 3 is empty")
    rollfem.done(*study, "--merge", "3")
    assert levels_of_study(rollfem) == 2


@pytest.mark.parametrize("options, said", [
    ("--part 1/2", "nothing to divide"), ("--merge 2", "nothing to divide"),
    ("--part 1/2 --merge 2", "--part with --merge"),
    *((f"--part {wrong}", "K/N") for wrong in ("3/2", "0/2", "1/1", "1", "a/b", "1/", "/"))])
def test_what_cannot_be_divided_is_refused(rollfem, options, said):
    rollfem.refuses("run", rollfem.case(SMALL), *options.split(), says=said)
