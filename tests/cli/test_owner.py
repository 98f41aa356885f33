# SPDX-License-Identifier: LGPL-2.1-or-later
"""One owner of a result at a time, from the start of a command to its end, and the messages when a signal ends it or
nobody reads its output."""

import shutil

import pytest
from program import PROGRAM, SMALL, interrupt_after, refused, says
from resuming import killed

SLOW = {"models": ["halfspace"]} | SMALL | {
    "rolling.longitudinal_creepage": [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004],
    "rolling.spin": 1e-4, "contact_grid.elements_across": 100}


def second_of(rollfem, first, lock, second):
    """Runs `second` while `first` has just begun, then lets `first` be killed."""
    outcomes = []

    def begun():
        if not rollfem.holds(lock) or not rollfem.text(lock):
            return False
        outcomes.append(rollfem.call(*second))
        return True

    killed(rollfem, begun, *first)
    return outcomes[0]


def test_a_second_run_is_refused_at_once_and_told_by_whom(rollfem):
    file = rollfem.case(SLOW)
    run = "run", file, "-o", "out", "--no-report"
    second = second_of(rollfem, run, "out.lock", run)
    refused(second, "another run is writing this result: process ")
    says(second.err, ", started 20", f"run {file} -o out")
    # The first was killed and has left its file: the next run takes it over and removes it.
    assert rollfem.holds("out.lock")
    rollfem.done(*run, "-m", "hertz", "--quiet")
    assert not rollfem.holds("out.lock")


@pytest.mark.parametrize("first, lock, second", [
    ("compare CASE -o c -m halfspace --no-report", "c/case.lock", "run CASE -o c/case"),  # a folder of the comparison
    ("study CASE -o s --no-report", "s.lock", "study CASE -o ./s/../s")])
def test_other_commands_own_their_folders_too(rollfem, first, lock, second):
    file = rollfem.case(SLOW)
    first, second = (words.replace("CASE", file).split() for words in (first, second))
    refused(second_of(rollfem, first, lock, second), "another run is writing")


def test_an_interruption_names_the_kept_work_and_how_to_resume(rollfem):
    file = rollfem.case(SLOW)

    def interrupted(signal):
        """By a signal once load points are stored; most users run it in a shell script, which is interrupted too."""
        return rollfem.execute("/bin/bash", "-c", '"$0" run "$1" -o out --no-report --resume & child=$!\n'
                               "until ls out.unfinished/*-000[23].point >/dev/null 2>&1; do\n"
                               "kill -0 $child || exit 9; sleep 0.01; done\n"
                               f"kill -{signal} $child; wait $child; exit $?", PROGRAM, file)

    # A shell starts background commands with Ctrl-C ignored, and it stays ignored.
    outcome = interrupted("INT")
    assert outcome.status == 0, outcome
    shutil.rmtree(rollfem.work / "out")
    outcome = interrupted("TERM")
    assert outcome.status == 143, outcome
    says(outcome.err, "rollfem: interrupted: ", "finished solutions are kept in ", "--resume continues from them")
    assert not rollfem.holds("out.lock")
    resumed = rollfem.done("run", file, "-o", "out", "--no-report", "--resume")
    says(resumed.err, "solutions of an earlier run")
    assert not rollfem.holds("out.unfinished")


def test_an_interruption_with_nothing_kept_says_so(rollfem):
    file = rollfem.case(SLOW | {"contact_grid.elements_across": 400})
    outcome = rollfem.call("run", file, "-o", "deep/out", watch=interrupt_after(0.3))
    assert outcome.status == 130, outcome
    says(outcome.err, "interrupted: no finished work was stored")
    assert rollfem.made() == []


def in_shell(rollfem, line):
    return rollfem.execute("/bin/bash", "-o", "pipefail", "-c", line, PROGRAM, rollfem.case(SMALL))


@pytest.mark.parametrize("line", ['"$0" run "$1" -m hertz -o out --no-report | true', '"$0" check "$1" | true',
                                  "trap '' PIPE; \"$0\" check \"$1\" | true",
                                  '"$0" run "$1" -m hertz -o out --no-report >&-'])
def test_a_closed_output_is_no_failure(rollfem, line):
    outcome = in_shell(rollfem, line)
    assert outcome.status == 0 and "rollfem: " not in outcome.err, outcome
    assert rollfem.holds("out/summary.json") == ("run" in line)


def test_a_full_output_is_a_failure(rollfem):
    full = in_shell(rollfem, '"$0" check "$1" >/dev/full')
    assert full.status == 1
    says(full.err, "standard output cannot be written")
