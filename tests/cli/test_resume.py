# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command run after a kill: it resumes from finished load points with a result identical to the last bit; records
that are damaged, belong to another case or cannot be written are reported and do no harm."""

import os
import subprocess

import program
import pytest
from program import PROGRAM, SMALL, says
from resuming import killed, records, same_results

CREEPAGES = {"rolling.longitudinal_creepage": [0.0005 * k for k in range(1, 13)], "rolling.spin": 1e-4}


def slow(rolling):
    """A case whose load points are kept, which they are from half a second on: enough of them, and on a grid fine
    enough, for a quick machine too."""
    return {"models": ["halfspace"]} | SMALL | rolling | {"contact_grid.elements_across": 120}


def run(file, directory, *options):
    return "run", file, "-o", directory, "--no-report", *options


@pytest.fixture(scope="module")
def whole():
    """The result of the case without a kill."""
    with program.folder() as made:
        made.done(*run(made.case(slow(CREEPAGES)), "whole"))
        yield made.work / "whole"


def leave_unfinished(rollfem, file, directory="out"):
    """Kills a run once it has kept a few load points; their number."""
    unfinished = rollfem.work / f"{directory}.unfinished"
    killed(rollfem, lambda: records(unfinished) >= 3, *run(file, directory))
    assert not rollfem.holds(directory)
    return records(unfinished)


@pytest.fixture
def left(rollfem):
    """The case of a killed run, and the number of load points that it has kept."""
    file = rollfem.case(slow(CREEPAGES))
    return file, leave_unfinished(rollfem, file)


HISTORIES = {
    "steps": {"rolling.problem": "transient", "rolling.longitudinal_creepage": 0.002, "history.step_length": [0.5] * 12},
    "friction that remembers": {
        "friction.law": "exponential", "friction.kinetic_coefficient": 0.4, "friction.half_velocity": 1000.0,
        "friction.memory_distance": 0.003, "rolling.problem": "transient", "rolling.speed": 1e4,
        "rolling.longitudinal_creepage": 0.01, "history.step_length": [0.1] * 8, "layer.thickness": 1.0,
        "layer.shear_modulus": 8200.0}}


@pytest.mark.parametrize("rolling", [CREEPAGES, *HISTORIES.values()], ids=["creepages", *HISTORIES])
def test_after_a_kill_the_result_is_the_same_to_the_last_bit(rollfem, whole, rolling):
    file = rollfem.case(slow(rolling))
    if rolling is not CREEPAGES:
        rollfem.done(*run(file, "whole"))
        whole = rollfem.work / "whole"
    kept = leave_unfinished(rollfem, file)
    says(rollfem.done(*run(file, "out", "--resume")).err, f"resume: {kept} solutions")
    same_results(whole, rollfem.work / "out")
    assert not rollfem.holds("out.unfinished")


def test_without_it_the_run_starts_anew_and_says_that_it_need_not(rollfem, left):
    outcome = rollfem.done(*run(left[0], "out"))
    says(outcome.err, "--resume would continue from them", "until it is done they are kept in out.unfinished.earlier")
    assert not rollfem.holds("out.unfinished") and not rollfem.holds("out.unfinished.earlier")
    assert rollfem.holds("out/summary.json")


def test_without_it_nothing_is_lost_before_the_new_run_is_done(rollfem, left):
    file, kept = left
    killed(rollfem, lambda: rollfem.holds("out.unfinished.earlier"), *run(file, "out"))
    assert records(rollfem.work / "out.unfinished.earlier") == kept


def test_load_points_of_a_changed_case_are_refused(rollfem, left):
    file, kept = left
    rollfem.case(slow(CREEPAGES | {"rolling.spin": 2e-4}))
    rollfem.refuses(*run(file, "out", "--resume"), says="case.toml (or a file that it names) has changed")
    assert records(rollfem.work / "out.unfinished") == kept


def sealed(place, record):
    """A record behind its checksum, 64-bit FNV-1a of both."""
    seal = 0xcbf29ce484222325
    for byte in place + record:
        seal = (seal ^ byte) * 0x100000001b3 % 2**64
    return b"%016x" % seal + record


def forged(place, content):
    """A load point that lacks numbers, sealed as if it were whole."""
    assert sealed(place, content[16:]) == content
    return sealed(place, content[16:-8 * 100])


@pytest.mark.parametrize("change", [lambda place, content: content[:len(content) // 2], forged], ids=["cut", "forged"])
def test_a_damaged_load_point_is_computed_again(rollfem, left, whole, change):
    unfinished = rollfem.work / "out.unfinished"
    point, = unfinished.glob("*-0002.point")
    point.write_bytes(change((unfinished / "about.txt").read_bytes() + point.stem.encode() + b"\n", point.read_bytes()))
    says(rollfem.done(*run(left[0], "out", "--resume")).err, "-0002.point is damaged")
    same_results(whole, rollfem.work / "out")


def test_records_without_their_file_are_somebody_elses(rollfem, left):
    file, kept = left
    (rollfem.work / "out.unfinished/about.txt").unlink()
    for option in "--resume", "--quiet":
        rollfem.refuses(*run(file, "out", option), says="which rollfem did not write")
    assert records(rollfem.work / "out.unfinished") == kept


def test_a_link_in_the_place_of_the_folder_is_not_followed(rollfem, left):
    file, kept = left
    mine = (rollfem.work / "out.unfinished").rename(rollfem.work / "mine")
    for name in "out.unfinished", "out.unfinished.earlier":
        (rollfem.work / name).symlink_to("mine")
        for option in "--resume", "--quiet":
            rollfem.refuses(*run(file, "out", option), says="is a symbolic link")
        (rollfem.work / name).unlink()
    assert records(mine) == kept and (mine / "about.txt").exists()


def test_with_nothing_to_take_up_it_is_an_ordinary_run(rollfem):
    outcome = rollfem.done(*run(rollfem.case(slow(CREEPAGES)), "out", "--resume", "-m", "hertz"))
    says(outcome.err, "no load points")


def test_a_full_disk_is_reported_once_and_the_run_continues(rollfem):
    # Records need more than the limit, the files of the result less, except results.h5.
    outcome = rollfem.execute("/bin/sh", "-c", 'ulimit -f 200; exec "$0" "$@"', PROGRAM,
                              *run(rollfem.case(slow(CREEPAGES)), "out", "--quiet"))
    assert outcome.err.count("warning: finished load points are no longer stored") == 1, outcome.err
    says(outcome.err, "ulimit -f")
    # The result does not fit either: nothing half-written is left of it.
    assert outcome.status == 1 and not rollfem.holds("out")
    assert records(rollfem.work / "out.unfinished") == 0


def test_what_a_killed_process_left_while_writing_is_cleaned_up_and_a_living_ones_is_not(rollfem):
    gone = subprocess.Popen("true")
    gone.wait()
    stale, living, other = (rollfem.work / f"out.partial-{whose}" for whose in (gone.pid, os.getpid(), "notes"))
    for path in stale, living, other:
        path.mkdir()
        (path / "summary.json").write_text("{")
    rollfem.done(*run(rollfem.case(slow(CREEPAGES)), "out", "-m", "hertz"))
    assert not stale.exists() and living.exists() and other.exists()
