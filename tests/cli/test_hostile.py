# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are not what their names say: devices, FIFOs, links, other people's files. Nothing hangs, nothing of
theirs is quoted or deleted, and no spreadsheet computes what a name says."""

import math
import os

import pytest
from program import SMALL, refused, says, toml


def test_no_device_and_no_fifo_is_read(rollfem):
    work, quick = rollfem.work, rollfem.case(SMALL)

    def pipe(name):
        os.mkfifo(work / name)
        return name

    def device(name):
        (work / name).symlink_to("/dev/zero")
        return name

    for name in [make(start + end) for start, make in (("p", pipe), ("z", device)) for end in (".sections", ".slcs", ".csv")]:
        rollfem.refuses("profile", name, "--rail", says="is not a regular file")
    for name in pipe("p"), device("z"):
        given = rollfem.case(SMALL | {"undeformed_distance.file": f"work/{name}"}, "given.toml")
        for words in ["convert", name, "-o", "made"], ["check", name], ["stress", name], ["run", given]:
            rollfem.refuses(*words, says="is not a regular file")
        rollfem.refuses("stress", "somewhere", "--places", name, says="")
    pipe("o.lock")
    rollfem.refuses("run", quick, "-o", "o", says="is in the way")
    assert (work / "o.lock").is_fifo()
    (work / "s").mkdir()
    pipe("s/summary.json")
    rollfem.refuses("run", quick, "-o", "s", says="not an earlier result")
    (work / "u.unfinished").mkdir()
    pipe("u.unfinished/about.txt")
    pipe("u.unfinished/halfspace-0001.point")
    for option in "--resume", "--quiet":
        rollfem.refuses("run", quick, "-o", "u", option, says="which rollfem did not write")
    assert (work / "u.unfinished/halfspace-0001.point").is_fifo()


@pytest.mark.parametrize("name, words, said", [
    ("a.toml", ["check"], "is not a case file"),
    ("b.toml", ["run"], "is not a case file"),
    ("a.inp", ["convert"], "is not an input file of CONTACT"),
    ("a.csv", ["profile", "--wheel"], "is not a profile"),
    ("a.sections", ["profile", "--wheel"], "is not a list of sections"),
    ("a.slcs", ["profile"], "is not a list of sections")])
def test_other_peoples_files_are_not_quoted(rollfem, name, words, said):
    secret = rollfem.file(name, "root:$6$verysecret=:19000:0:::\ndaemon:*:19:0\nname\n")
    outcome = rollfem.call(*words, secret)
    refused(outcome, said)
    assert "secret" not in outcome.err and "root" not in outcome.err


def test_a_case_with_a_mistake_is_quoted_so_that_the_mistake_is_found(rollfem):
    rollfem.refuses("check", rollfem.file("c.toml", toml(SMALL) + "wrong line\n"), says="`wrong line`")


def test_no_name_is_a_formula_of_a_spreadsheet(rollfem):
    names = ["=cmd|calc!A1.toml", "@sum.toml", "+1.toml", "-2.toml"]
    for name in names:
        rollfem.case(SMALL, f"work/{name}")
    rollfem.done("compare", *(f"./{name}" for name in names), "-m", "hertz", "--no-report", "-o", "out")
    for row in rollfem.text("out/compare.csv").splitlines():
        assert row.startswith(("case,", "\"'"))


@pytest.mark.parametrize("command, other", [("study", "table.h5"), ("compare", "table.h5"), ("table", "study.json")])
def test_a_result_of_another_command_is_not_joined(rollfem, command, other):
    rollfem.file(f"work/f/{other}", "")
    rollfem.refuses(command, rollfem.case(SMALL), "-o", "f", says="holds the result of another command")


def test_an_impossible_number_of_threads_is_named(rollfem):
    rollfem.refuses("run", rollfem.case(SMALL), "-o", "o", "--no-report", OMP_NUM_THREADS="999999999",
                    says="OMP_NUM_THREADS = 999999999; allowed: 1 to 1024")


def test_positions_of_sections_are_bounded(rollfem):
    rollfem.refuses("profile", rollfem.file("far.sections", "-1e308 60E1\n1e308 60E1\n"), "--rail",
                    says="far.sections:1: position -1e+308; allowed: up to 1e+09")


def test_a_tiny_patch_far_from_where_the_bodies_touch_first_needs_no_memory(rollfem):
    outcome = rollfem.call("run", rollfem.case({
        "models": ["halfspace"], "load.vertical_force": 1e-6, "friction.coefficient": 1e-12,
        "wheel.rolling_radius": 50.0, "wheel.profile": "arcs", "rail.profile": "60E1",
        "contact_grid.elements_across": 10, "placement.side": "right",
        "placement.lateral_position": 2.792686301844646, "placement.yaw": -0.28101079231916926,
        "placement.roll": -0.44850217825619976, "wheel_profile.radii": [math.inf],
        "wheel_profile.ends": [-5.0, 5.0], "wheel_profile.free_ends": True}, "edge.toml"),
        "-o", "out", "--no-report", "--quiet")
    assert outcome.status == 1
    says(outcome.err, "edge.toml", "; do: ")
    assert "out of memory" not in outcome.err
