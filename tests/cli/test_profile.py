# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands profile and wheelset: their output, files, figures and refusals."""

import json
import math
import random
import re

import pytest
from profiles import columns, points_of
from program import SOURCE, refused, says

SECTIONS = SOURCE / "cases/profiles/crossing.sections"


def s1002_on(rail, **rail_profile):
    """A case of S1002 on this rail."""
    return {"load.vertical_force": 50e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0,
            "wheel.profile": "S1002", "track.inclination": "1:40", "rail.profile": rail} | {
                f"rail_profile.{key}": value for key, value in rail_profile.items()}


def test_tells_what_the_standard_says_of_s1002(rollfem):
    outcome = rollfem.done("profile", "S1002", "-o", "out")
    assert outcome.err == "" and rollfem.made() == ["out", "out/profile.csv", "out/profile.svg"]
    # EN 13715: flange 28 high, its tip at y = -55, 32.5 thick at 10 below the tape line (-70 + 32.5).
    says(outcome.out, "y = -55.0000, z = 28.0000", "flange face at z = 10, mm           y = -37.5000", "12.000 at",
         "y = 32.1580, z = -0.7795")
    says(rollfem.text("out/profile.svg"), "<svg")


def test_sections_along_the_way_are_drawn_with_their_features(rollfem):
    out = rollfem.done("profile", SECTIONS, "-o", "out").out
    says(out, f"rail {SECTIONS}", "sections                            25", "0 to 240, 10 apart", "a cubic spline",
         "10 given in the list")
    # The nose's crown begins at y = 8 in all sections and rises with it.
    assert re.search(r" 2 +8\.000, +3\.\d+  -> +8\.000, +2\.", out), out
    assert rollfem.made() == ["out", "out/sections.csv", "out/sections.svg"]
    says(rollfem.text("out/sections.svg"), "height of the surface, upper 6 mm [mm]; lines: features")
    says(rollfem.done("profile", SECTIONS, "--json").out, '"features": 10')


def test_features_are_found_where_a_list_gives_none(rollfem):
    # Of the crossing, whose nose begins at 0 here: before it there is only the wing.
    crossing = SOURCE / "cases/profiles/crossing"
    whole = (crossing / "000.csv").read_text().splitlines(keepends=True)
    rollfem.file("wing.csv", "".join(line for line in whole if float(re.split("[ ,;]+", line.strip())[0]) > 34.0))
    file = rollfem.file("nose.sections", "-20 wing.csv\n-10 wing.csv\n"
                        + "".join(f"{at} {crossing}/{at}.csv\n" for at in ("000", "010", "020")))
    says(rollfem.done("profile", file, "-o", "out").out, "5 found, bends and kinks", "  from 0 to 20\n")
    says(rollfem.text("out/sections.svg"), "lines: features")
    says(rollfem.text("out/sections.csv"), "-20,1,,\n")
    says(rollfem.done("profile", file, "--json").out, "null", '"features": 5')
    # Equal sections have one height everywhere along the way.
    rollfem.done("profile", rollfem.file("equal.sections", "0 wing.csv\n1 wing.csv\n"), "-o", "equal")
    assert rollfem.holds("equal/sections.svg")


@pytest.mark.parametrize("model", ["fem", "hybrid"])
def test_sections_that_change_over_the_patch_are_not_for_finite_elements(rollfem, model):
    outcome = rollfem.call("run", SOURCE / "cases/crossing.toml", "--model", model, "-o", "out", "--set",
                           "placement.track_position=[80.0]")
    refused(outcome, "it cannot handle profiles that change over the patch by more than 1 %")
    says(outcome.err, "do: run with --model halfspace")


def test_the_table_is_a_profile_again(rollfem):
    rollfem.done("profile", "60E1", "-o", "one")
    # Every joint has two rows in the table, one for each side of it, which are one point.
    rollfem.done("profile", "one/profile.csv", "--rail", "-o", "again")
    rollfem.done("profile", "S1002", "-o", "wheel")
    rollfem.done("profile", "wheel/profile.csv", "--wheel", "-o", "wheel_again")
    outcome = rollfem.done("profile", rollfem.case(s1002_on("work/one/profile.csv")), "--rail", "-o", "two")
    says(outcome.out, "gauge face 14 mm below the top, mm  y = -35.8712")
    assert rollfem.holds("two/rail.svg")


def simpack(smooth, weight):
    """A circle of 40 mm as SIMPACK writes it, with this weight of one point."""
    rows = "".join(f"{0.5 * k} {40 - math.sqrt(1600 - 0.25 * k * k):.9f} {1 if k else weight}\n" for k in range(-70, 71))
    return (f"header.begin\ntype = 0\nheader.end\nspline.begin\napprox.smooth = {smooth}\nunits.len.f = 1000\n"
            f"point.begin\n{rows}point.end\nspline.end\n")


def test_smoothing_and_weights_of_a_simpack_file_are_named(rollfem):
    rollfem.file("rail.prr", simpack(0.5, 0.5))
    note = ("rail.prr: approx.smooth = 0.5 and weights other than 1 (of 1 points) are not applied; do: give `smoothing` "
            "under [rail_profile]")
    asked = rollfem.case(s1002_on("rail.prr"))
    for words in (["profile", "../rail.prr", "-o", "out"], ["check", asked],
                  ["run", asked, "--model", "hertz", "--no-report", "-o", "r"]):
        says(rollfem.done(*words).err, note)
    assert "not applied" not in rollfem.done("check", rollfem.case(s1002_on("rail.prr", smoothing=0.001))).err
    rollfem.file("plain.prr", simpack(0, 1))
    assert rollfem.done("profile", "../plain.prr", "-o", "plain").err == ""


def test_profiles_of_a_case_show_both_bodies_and_may_be_asked_for_again(rollfem):
    file = rollfem.case(s1002_on("60E1"))
    for _ in range(2):
        says(rollfem.done("profile", file).out, "wheel S1002", "rail 60E1", "where wheel and rail touch")
    assert rollfem.made() == ["results", "results/case_profile", *(
        f"results/case_profile/{name}.{kind}" for name in ("pair_left", "rail", "wheel") for kind in ("csv", "svg"))]


@pytest.mark.parametrize("words, text, said", [
    ("S1003", None, "S1002, S1002-smooth, 60E1"), ("FILE", "1,2\n", "--wheel or --rail"),
    ("FILE --rail", "1,2\n", "has 1 points"), ("FILE --wheel", "", "is empty"),
    ("60E1 --wheel", None, "belongs to a rail"), ("60E1 --wheel --rail", None, "exclude each other")])
def test_files_without_a_profile_are_refused_and_nothing_is_written(rollfem, words, text, said):
    if text is not None:
        words = words.replace("FILE", rollfem.file("a.csv", text))
    rollfem.refuses("profile", *words.split(), says=said)
    assert rollfem.made() == []


def test_the_keys_of_one_message_mend_a_file(rollfem):
    """A measured rail with every kind of fault: the keys of one message, pasted into the case, mend it."""
    points = [(y, -z) for y, z in reversed(points_of("60E1", 0.2))]
    points.insert(300, (points[299][0] + 0.5, points[299][1] + 0.1))
    points.insert(200, points[199])
    del points[100:130]
    rollfem.file("rail.ban", "Gauge=1437.5\n\n" + columns(points))
    outcome = rollfem.call("profile", rollfem.case(s1002_on("rail.ban")))
    refused(outcome, "under [rail_profile]")
    keys = dict(key.split(" = ") for key in re.findall("`([^`]*)`", outcome.err.partition("do: put")[2]))
    assert keys == {"flip": "true", "drop_duplicates": "true", "drop_zigzag": "true", "longest_gap": "7"}
    mended = rollfem.case(s1002_on("rail.ban", **{key: json.loads(value) for key, value in keys.items()}))
    says(rollfem.done("profile", mended).out, "gauge face 14 mm below the top, mm  y = -35.87")


def test_scatter_is_reported_with_the_smoothing_that_it_needs(rollfem):
    normal = random.Random(2)
    rollfem.file("rail.txt", columns([(y, z + normal.gauss(0, 0.004)) for y, z in points_of("60E1", 0.2)]))
    file = rollfem.case(s1002_on("rail.txt", largest_kink=60))
    says(rollfem.done("profile", file, "--rail").out, "put `smoothing = 0.00")
    says(rollfem.done("check", file).err, f'warning: {file}: rail.profile = "rail.txt": its points scatter by 0.00',
         "do: put `smoothing = 0.00")
    assert "scatter" not in rollfem.done("check", file, "--set", "rail_profile.smoothing=0.004").err


@pytest.mark.parametrize("command", ["profile", "check"])
def test_coarse_rounding_of_dense_points_is_reported(rollfem, command):
    def said_of(spacing, decimals):
        points = points_of("60E1", spacing)
        rollfem.file("rail.txt", "".join(f"{y:.{decimals}f} {z:.{decimals}f}\n" for y, z in points))
        return rollfem.done(command, rollfem.case(s1002_on("rail.txt"))).err

    says(said_of(0.005, 4), "rail.txt: points 0.005 mm apart", "rounded to 0.0001 mm", "`thinning = 0.05`",
         "under [rail_profile]")
    assert "rounded to" not in said_of(0.2, 4) + said_of(0.005, 9)


def test_a_wheelset_tells_radii_angles_and_conicity(rollfem):
    file = rollfem.case(s1002_on("60E1") | {"wheelset.side": "both"})
    outcome = rollfem.done("wheelset", file, "--reach", "4", "-o", "out")
    assert outcome.err == "" and rollfem.made() == ["out", "out/wheelset.csv", "out/wheelset.svg"]
    assert len(rollfem.rows("out/wheelset.csv")) == 41  # 0 to 4 mm by 0.1
    says(outcome.out, "conicity")
    rollfem.refuses("wheelset", file, "--reach", "90", says="0.2 to 30 mm")
