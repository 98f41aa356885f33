# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cached corrections of the model hybrid: found for scenes with the same correction, never for other bodies,
complete or absent, listed and cleared."""

import math
import re

import pytest
from program import says


def coarse(radius=405, force=50e3, friction=0.55, creepage=0.001, models=("hybrid",), **more):
    """On a few hundred finite elements."""
    return {"models": list(models), "load.normal_force": force, "friction.coefficient": friction,
            "wheel.rolling_radius": radius, "wheel.transverse_radius": math.inf, "rail.transverse_radius": 500.0,
            "rolling.longitudinal_creepage": creepage, "contact_grid.elements_across": 12, "fem.degree": 1,
            "fem.extent": 30} | more


@pytest.fixture
def run(rollfem):
    """The model's result."""
    def solve(name, keys, cache="cache", processes=1):
        rollfem.done("run", rollfem.case(keys, f"{name}.toml"), "-o", name, "--no-report", "-q", processes=processes,
                     ROLLFEM_CACHE=cache)
        return rollfem.models(name)[0]
    return solve


@pytest.fixture
def cache(rollfem):
    """What the command cache says."""
    return lambda action: rollfem.done("cache", action, ROLLFEM_CACHE="cache").out


def files(rollfem):
    return list((rollfem.work / "cache").iterdir())


def notes(model, part):
    return any(part in note["text"] for note in model["notes"])


def same_point(one, other, tolerance):
    for name in "max_pressure", "approach", "longitudinal_force", "semi_axis_x":
        assert one["points"][0][name] == pytest.approx(other["points"][0][name], rel=tolerance)


def test_serves_another_load_friction_and_creepage(run):
    assert not notes(run("first", coarse()), "from the cache")
    other = coarse(force=47e3, friction=0.3, creepage=0.002)
    found = run("found", other)
    assert notes(found, "from the cache")
    # The same as without the cache: results do not depend on the origin of the correction.
    computed = run("computed", other, cache="")
    assert not notes(computed, "from the cache")
    same_point(found, computed, 1e-13)
    assert found["seconds"]["correction"] < 0.2 * computed["seconds"]["correction"]


def test_is_of_the_bodies_that_it_was_found_for(rollfem, run, cache):
    says(cache("list"), "0 corrections")
    run("one", coarse())
    assert not notes(run("wheel", coarse(radius=406)), "from the cache")
    assert not notes(run("load", coarse(force=80e3)), "from the cache")
    says(cache("list"), "wheel 406, across inf; rail across 500", "3 corrections")
    says(cache("clear"), "removed 3 corrections")
    assert files(rollfem) == []


def test_is_known_to_the_model_auto(run):
    def seconds(name):  # a half-space suffices
        told = run(name, {key: value for key, value in coarse().items() if key != "models"})["choice"]
        return float(re.search(r"hybrid would take about ([\d.]+)", told)[1])

    anew = seconds("anew")
    assert anew > 3.0
    run("kept", coarse())
    assert seconds("found") < 0.2 * anew


def test_a_damaged_file_is_reported_and_replaced(rollfem, run, cache):
    first = run("first", coarse())
    file, = files(rollfem)
    content = file.read_bytes()
    file.write_bytes(content[:len(content) // 2] + b"damage" + content[len(content) // 2 + 6:])
    says(cache("list"), "is damaged")
    anew = run("anew", coarse())
    assert notes(anew, "is damaged; the correction was recomputed")
    same_point(first, anew, 1e-13)
    assert notes(run("again", coarse()), "from the cache")


def test_a_folder_that_cannot_be_written_is_no_failure(run):
    assert notes(run("case", coarse(), cache="/dev/null/nowhere"), "could not be stored for other runs")


def test_two_processes_share_what_the_first_finds(rollfem, run):
    alone = run("alone", coarse(), cache="")
    two = run("two", coarse(), processes=2)
    assert not notes(two, "from the cache")
    same_point(alone, two, 1e-8)
    assert len(files(rollfem)) == 1
    found = run("found", coarse(), processes=2)
    assert notes(found, "from the cache")
    same_point(two, found, 1e-13)


def test_keeps_stresses_for_cases_that_request_them(rollfem, run):
    plain = coarse(radius=450, friction=0.3)
    asking = plain | {"output.stress_maxima": True}
    run("none", plain)
    anew, again = run("anew", asking), run("again", asking)
    assert not notes(anew, "comes from the cache") and notes(again, "comes from the cache")
    assert anew["points"][0]["stress_maxima"] == again["points"][0]["stress_maxima"]
    assert notes(run("both", plain), "comes from the cache") and len(files(rollfem)) == 1
    # From a stored result: the same largest stresses.
    rollfem.done("stress", "again", "--no-figures", "-o", "stress", ROLLFEM_CACHE="cache")
    assert len(rollfem.json("stress/stress.json")["models"][0]["maxima"]) == 12
