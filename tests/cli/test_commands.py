# SPDX-License-Identifier: LGPL-2.1-or-later
"""check, new-case, docs, --version, keys changed by --set, wrong calls: exit status and message."""

import os

import pytest
from program import PROGRAM, SMALL, SOURCE, rolling, says

CASES = sorted((SOURCE / "cases").glob("*.toml"))


@pytest.mark.parametrize("file", CASES, ids=lambda file: file.stem)
def test_check_accepts_every_committed_case(rollfem, file):
    outcome = rollfem.done("check", file)
    if file.stem.startswith("conformal_"):
        assert outcome.err.startswith("warning: the patch is not small against the bodies")
    else:
        assert outcome.err == ""
    if file.stem.startswith("thesis_"):
        says(outcome.out, "load.normal_force              50000 N", "models that take it: auto, hertz")
        says(rollfem.done("check", file, "--all").out, "[load]\n  normal_force           50000 N", "(default)", "\n  E* ")
    assert len(outcome.out.splitlines()) <= 36 and "(default)" not in outcome.out
    assert rollfem.made() == []


def test_check_does_not_load_the_libraries_of_finite_elements(rollfem):
    # Loading them takes longer than everything else in check.
    loaded = rollfem.done("check", rollfem.case(SMALL), LD_DEBUG="files").err
    says(loaded, "librollfem_contact")
    assert not [name for name in ("librollfem_fem", "libdeal", "libtrilinos", "libgmsh") if name in loaded]


def test_new_case_writes_an_accepted_file_but_never_over_another(rollfem):
    rollfem.done("check", rollfem.file("printed.toml", rollfem.done("new-case").out))
    rollfem.done("new-case", "-o", "new.toml")
    rollfem.done("check", "new.toml")
    rollfem.refuses("new-case", "-o", "new.toml", says="already exists")
    rollfem.refuses("new-case", "-o", "no/such/folder.toml", says="cannot write")
    # A file that does not fit is not left truncated.
    full = rollfem.execute("/bin/sh", "-c", 'ulimit -f 4; exec "$0" new-case -o full.toml', PROGRAM)
    assert full.status == 1  # the call is right
    says(full.err, "ulimit -f")
    assert not rollfem.holds("full.toml")


@pytest.mark.parametrize("page", ["case-file", "models"])
def test_committed_pages_are_the_generated_ones(rollfem, page):
    assert rollfem.done("docs", page).out == (SOURCE / f"docs/{page}.md").read_text("utf-8"), \
        f"run: rollfem docs {page} > docs/{page}.md"


def test_version_and_help_are_answered(rollfem):
    assert rollfem.done("--version").out.startswith("rollfem 0.1.0")
    says(rollfem.done("--help").out, "run", "check", "new-case")
    assert rollfem.call("help").out == rollfem.call("--help").out
    assert rollfem.call("help", "run").out == rollfem.done("run", "--help").out


@pytest.mark.parametrize("words, said", [
    ("", "no command given"),
    ("bogus", "bogus: unknown command"),
    ("rnu", "rnu: unknown command; did you mean run? "),
    ("hlep", "did you mean help? "),
    ("--bogus", "do: rollfem --help"),
    ("check", "case is required"),
    ("check CASE more", "more"),
    ("run", "no case file"),
    ("run CASE --model fme", "--model fme: no such model; did you mean fem? "),
    ("run CASE --model", "--model"),
    ("run CASE --bogus", "--bogus"),
    ("run CASE --modle=hertz", "did you mean --model?"),
    ("run CASE --ouput x", "--ouput: unknown option; did you mean --output? allowed: --help"),
    ("run CASE --set friction.coeficient=0.1", "did you mean `coefficient`?"),
    ("run CASE --set friction", "expected KEY=VALUE"),
    ("run CASE --threads 0", "--threads"),
    ("run CASE --threads -1", "--threads"),
    ("run CASE --threads many", "--threads"),
    ("docs novel", "novel"),
    ("docs schem", "schem is not allowed; did you mean schema? "),
    ("study CASE --vary gird", "did you mean grid? "),
    ("profile S1003", "did you mean S1002? "),
    *((f"{command} {'x' * 300}", "xxx") for command in ("run", "profile", "report", "mesh", "stress")),
    (f"new-case -o {'x' * 300}", "xxx: File name too long; do: correct the path"),
])
def test_wrong_calls_are_refused(rollfem, words, said):
    file = rollfem.case(SMALL)
    rollfem.refuses(*words.replace("CASE", file).split(), says=said)
    assert rollfem.made() == []


def test_an_empty_command_is_refused(rollfem):
    rollfem.refuses("", says="")


def test_an_unknown_quantity_of_the_accuracy_is_refused(rollfem):
    rollfem.refuses("check", rollfem.case({"accuracy": 0.01, "accuracy_of": ["beauty"]} | SMALL), says="accuracy_of")


DEEP = ".".join(["a"] * 4001)


@pytest.mark.parametrize("content, said", [
    (bytes(i * 7919 >> 3 & 255 for i in range(4096)), "binary"),
    ("", "is empty"),
    (SMALL | {"load.normal_force": float("nan")}, "load.normal_force = nan"),
    ("[load]\nnormal_force = 1e400\n", "1e400"),
    (f"[{DEEP}]\n{DEEP} = 1\n", "nested more than 64 deep"),
    (os.mkdir, "is a folder"),
    (os.mkfifo, "is not a regular file")], ids=["binary", "empty", "nan", "huge", "deep", "folder", "fifo"])
def test_hostile_files_are_refused_by_check_and_run_alike(rollfem, content, said):
    if callable(content):
        content(rollfem.path / "case.toml")
    else:
        rollfem.case(content)
    for command in "check", "run":
        rollfem.refuses(command, "../case.toml", says=said)
    assert rollfem.made() == []


@pytest.mark.parametrize("file, said", [("/dev/zero", "is not a regular file"), ("", ""), ("x" * 5000, ""),
                                        ("missing.toml", "missing.toml: there is no such file")])
def test_names_of_no_file_are_refused_by_check_and_run_alike(rollfem, file, said):
    for command in "check", "run":
        rollfem.refuses(command, file, says=said)
    assert rollfem.made() == []


def test_output_that_cannot_be_written_is_an_error(rollfem):
    outcome = rollfem.execute("sh", "-c", '"$0" new-case > /dev/full', PROGRAM)
    assert outcome.status == 1
    says(outcome.err, "cannot be written")


def test_set_changes_a_key_of_the_case_that_is_solved_and_stored(rollfem):
    change = ["--set", "friction.coefficient=0.125"]
    says(rollfem.done("check", rollfem.case(SMALL), *change).out, "0.125")
    run = rollfem.done("run", *change, "--set", "title=changed", rollfem.case(SMALL), "--model", "hertz", "--no-report",
                       "-o", "out")
    assert run.out.startswith("changed\n")
    says(rollfem.text("out/case.toml"), "coefficient = 0.125")
    rollfem.done("check", "out/case.toml")


def completed(rollfem, words):
    """Bash's completions after these words, of which the last is incomplete."""
    script = rollfem.file("completion", rollfem.call("docs", "bash").out)
    return rollfem.execute("bash", "-c", f"source {script}; COMP_WORDS=({words}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1));"
                           ' _rollfem; echo "${COMPREPLY[@]}"').out


def test_bash_completes_commands_options_and_models(rollfem):
    rollfem.done("new-case", "-o", "mine.toml")
    (rollfem.work / "mine.inp").touch()
    for words, completion in {"st": "study stress", "study --to": "--together", "run --model fasts": "fastsim",
                              "run mi": "mine.toml", "convert mi": "mine.inp"}.items():
        assert completed(rollfem, f"rollfem {words}") == completion + "\n"


def test_manual_page_names_every_command_and_option(rollfem):
    says(rollfem.call("docs", "man").out, *(f".SS {name}" for name in "run compare study stress mesh profile check docs".split()),
         "\\-\\-resume", "EXIT STATUS")


def with_accuracy(accuracy):
    return {"models": ["halfspace"], "accuracy": accuracy} | SMALL | rolling(0.001, 10)


def test_accuracy_is_reached_by_as_many_elements_as_it_takes(rollfem):
    rollfem.done("run", rollfem.case(with_accuracy(0.005)), "-o", "out", "--no-report")
    point = rollfem.point("out")
    for name in "max_pressure", "semi_axis_x", "semi_axis_y":
        assert point["error_estimate"][name] <= 0.005 * point[name]
    assert point["error_estimate"]["traction_coefficient"] <= 0.005 * 0.55
    assert rollfem.models("out")[0]["contact_elements"] > 320


def test_accuracy_not_reached_is_a_failure_whose_results_are_there(rollfem):
    outcome = rollfem.call("run", rollfem.case(with_accuracy(1e-5)), "-o", "out", "--no-report", "-q")
    assert outcome.status == 1
    says(outcome.err, "the results were written, but model halfspace: accuracy = 1e-05")
    assert rollfem.holds("out/summary.json") and not rollfem.holds("out.unfinished")
