# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verification book as called by `./rollfem book` after the build."""

import os
import sys

import pytest
from program import BUILD, SOURCE, says
from resuming import killed


@pytest.fixture
def book(rollfem):
    """The book with results and output in the folder where it is started; `script` runs before its main."""
    def call(*options, script="", by=None):
        code = f"import sys; from book import published\n{script}\nfrom book.__main__ import main; sys.exit(main())"
        paths = f"{SOURCE}/benchmarks:{SOURCE}/postprocess"
        words = ("-c", code, f"--root={SOURCE}", f"--build={BUILD}", "--results=results", "--output=out", *options)
        how = {"PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1", "program": sys.executable}
        return killed(rollfem, by, *words, **how) if by else rollfem.call(*words, **how)
    return call


def test_holds_closed_form_number_reached_and_test_of_every_chapter_asked_for(rollfem, book):
    assert book("--only", "hertz", "fastsim").status == 0
    chapters = rollfem.json("out/book.json")["chapters"]
    assert len(chapters) == 2
    row, = (row for row in chapters[0]["rows"] if (row["quantity"], row["by"]) == ("rail 80 mm: p0", "half-space"))
    # The closed form of the book against the benchmark's table; what was reached is another number.
    assert row["reference"] == pytest.approx(1920.375, abs=1e-3)
    assert row["reached"] == pytest.approx(1920.375, rel=1e-3)
    assert abs(row["reached"] - 1920.375) > 0.1 and row["holds"]
    says(rollfem.text("out/README.md"), "[1. Hertz's ellipses](hertz.md)", "50 numbers are judged")
    says(rollfem.text("out/hertz.md"), "# 1. Hertz's ellipses", "| rail 80 mm: p0, MPa | half-space | 1920.37 |",
         "`unit.Hertz.GivesTheBenchmarkTable`", "Cost: ")


def test_a_number_beyond_its_limit_is_named_and_ends_with_status_one(rollfem, book):
    made = book("--only", "fastsim", script="published.CONTACT_FASTSIM_A[0.002] = (0.36, 329.48376)")
    assert made.status == 1
    says(made.err, "-F_x/F_z at xi = 0.2 %")
    says(rollfem.text("out/fastsim.md"), "**beyond**")


def test_takes_up_runs_of_the_same_program_and_case(rollfem, book):
    assert book("--only", "fastsim").status == 0
    says(book("--only", "fastsim").out, "fastsim: kept")
    assert "kept" not in book("--only", "fastsim", "--fresh").out
    # A truncated result is not accepted.
    (rollfem.work / "results/fastsim.stamp").unlink()
    assert "fastsim: kept" not in book("--only", "fastsim").out


def chapter_of(elements):
    """Reduces the book's first chapter to one run on a given number of elements."""
    return ("from book import chapters\ndef one(bench):\n  bench.run('one', 'cases/thesis_a.toml', ['halfspace'], "
            f"{{'contact_grid.elements_across': {elements}}})\n  return chapters.fastsim(bench)\nchapters.ALL[0] = one\n")


def test_has_one_owner_whose_runs_end_with_it(rollfem, book):
    lock, seen = rollfem.work / "results/one.lock", []

    def at_work():
        if not lock.exists() or not lock.stat().st_size:
            return False
        seen.extend([book("--only", "fastsim"), lock.exists()])
        return True

    book("--only", "one", script=chapter_of(400), by=at_work)
    second, still_at_work = seen
    assert still_at_work, "the second waited for the first"
    assert second.status == 2
    says(second.err, "error: another run is writing ", "out: process ", ", started 20", "--only one; do: wait for it")
    # Killing the book also killed its run, so the folder is free.
    assert book("--only", "one", script=chapter_of(10)).status == 0
    assert [name for name in rollfem.made() if name.endswith(".lock")] == []


def test_names_the_error_of_a_call(rollfem, book):
    unknown = book("--only", "hertzz")
    assert unknown.status == 2
    says(unknown.err, "hertzz: unknown chapter; allowed: hertz,")
    whole = '{"chapters": [{"name": "hertz"}, {"name": "fastsim"}]}'
    rollfem.file("work/out/book.json", whole)
    part = book("--only", "fastsim")
    assert part.status == 2
    says(part.err, "would remove the other chapters (1) of", "do: name another folder")
    assert rollfem.text("out/book.json") == whole
    os.remove(rollfem.work / "out/book.json")
    unbuilt = book("--only", "fastsim", "--build", "nowhere")
    assert unbuilt.status == 1
    says(unbuilt.err, "do: ./rollfem build")
    says(book("--list").out, "wheel-on-rail")


def test_a_run_that_fails_leaves_its_chapter_out_and_the_others_are_there(rollfem, book):
    failed = book("--only", "hertz", "fastsim", script="from book import runs; runs.with_settings = "
                  "lambda text, settings: text + '[unknown]' * bool(settings)")
    assert failed.status == 1
    says(failed.err, "error: hertz: hertz_300: ")
    says(rollfem.text("out/README.md"), "Left out: hertz")
