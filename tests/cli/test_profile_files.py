# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of profiles as instruments and programs write them: every format is read; every fault is refused with one message
that names the line and the key that mends it, and the key mends it; steps are bridged and noise is smoothed."""

import math
import re

import numpy as np
import pytest
from profiles import SPLINE, columns, height, off, points_of, read, refusal  # noqa: F401 (fixtures)
from program import WHEEL_ON_RAIL, package, says

WHEEL, RAIL = points_of("S1002"), points_of("60E1")
WHEEL_TEXT, RAIL_TEXT = columns(WHEEL), columns(RAIL)
BODY = {"S1002": "wheel", "60E1": "rail"}
MIRROR, UP = np.array([-1, 1]), np.array([1, -1])


def raised(points, rise):
    """Points with z increased by a function of y."""
    return np.stack([points[:, 0], points[:, 1] + rise(points[:, 0])], axis=1)


def step(y):
    return 0.1 * (y > 5.0)


def swapped(points):
    points = points.copy()
    for k in range(3, len(points) - 8, 9):
        points[[k, k + 6]] = points[[k + 6, k]]
    return points


FAULTS = {
    "empty": ("wheel", "", ["is empty"], None),
    "only comments": ("wheel", "# nothing\n\n", ["is empty"], None),
    "no profile": ("wheel", "Dear Sir,\nplease find\n", ["profile.txt:2: is not a profile", "do not begin with a number"], None),
    "bad number": ("wheel", "1 2\n3 x4\n", ["profile.txt:2:", "`x4`"], None),
    "one column": ("rail", "1\n2\n", ["profile.txt:1:", "two columns"], None),
    "not finite": ("rail", "1 2\n3 nan\n", ["profile.txt:2:", "`nan`"], None),
    "too few points": ("rail", "-20 2\n0 0\n20 2\n", ["has 3 points"], None),
    "three columns": ("rail", "1 2 3\n4 5 6\n", ["profile.txt:1: has 3 numbers"], None),
    "binary": ("rail", b"1 2\0 3", ["binary"], None),
    "metres": ("wheel", columns(WHEEL, unit=1000.0), ["in m?", 'unit = "m"'], {"unit": "m"}),
    "inches": ("rail", columns(RAIL, unit=25.4), ["inches", 'unit = "inch"'], {"unit": "inch"}),
    "mirrored wheel": ("wheel", columns(WHEEL * MIRROR), ["flange is on the wrong side", "mirror = true"], {"mirror": True}),
    "upward wheel": ("wheel", columns(WHEEL * UP), ["upward", "flip = true"], {"flip": True}),
    "upward rail": ("rail", columns(RAIL * UP), ["upward", "flip = true"], {"flip": True}),
    "reversed wheel": ("wheel", columns(WHEEL[::-1]), ["profile.txt:1:", "large to small y", "reverse = true"],
                       {"reverse": True}),
    "unordered": ("rail", columns(swapped(RAIL)), ["unordered", "sort = true"], {"sort": True}),
    "duplicate": ("rail", columns(np.insert(RAIL, 100, RAIL[100], axis=0)),
                  ["profile.txt:102:", "line 101", "drop_duplicates = true"], {"drop_duplicates": True}),
    "zigzag": ("rail", columns(np.insert(RAIL, 131, RAIL[128], axis=0)),
               ["profile.txt:132:", "zig-zag", "drop_zigzag = true"], {"drop_zigzag": True}),
    "gap": ("rail", columns(np.delete(RAIL, range(125, 139), axis=0)), ["profile.txt:126:", "gap of 7.5", "longest_gap = 8"],
            {"longest_gap": 8.0}),
    "kink": ("rail", columns(raised(RAIL, lambda y: 0.5 * np.maximum(0.0, y - 5.0))),
             ["kink of 26", "rounding = 0.05", "largest_kink = 27"], None),
    "wheel as rail": ("rail", WHEEL_TEXT, ["seems to be a wheel", "tip at y = -55.", "tread up to y = 59.",
                                           "do: give it as the profile of the wheel"], None),
    "mirrored wheel as rail": ("rail", columns((WHEEL * MIRROR)[::-1]), ["seems to be a wheel", "tip at y = 55.",
                                                                         "tread up to y = -59."], None),
    "rail as wheel": ("wheel", RAIL_TEXT, ["seems to be the head of a rail", "to both its ends",
                                           "do: give it as the profile of the rail"], None),
    "step": ("rail", columns(raised(RAIL, step)), ["step of 0.1 mm", "y = 4.8", "`rounding = 0.05`"], None)}


@pytest.mark.parametrize("body, text, parts, mend", FAULTS.values(), ids=FAULTS)
def test_a_fault_is_refused_and_read_when_mended(read, refusal, body, text, parts, mend):
    says(refusal(text, body), *parts)
    if mend:
        assert off(read(text, body, **mend), "S1002" if body == "wheel" else "60E1") < 2e-3


def commented(rows):
    """Every third row with a comment behind it and a row of comment after it."""
    marks = [" % 0.1 mm steps", " ! worn", ' "here"', " # 12", " // see 3"]
    return "".join(line if k % 3 else f"{line[:-1]}{marks[k // 3 % 5]}\n% a remark, with 2 numbers 3\n"
                   for k, line in enumerate(rows.splitlines(True)))


def simpack(rows, head="type = 0", spline="units.len.f = 1000"):
    return f"header.begin\n{head}\nheader.end\nspline.begin\n{spline}\npoint.begin\n{rows}point.end\nspline.end\n"


TURN = math.atan(1 / 40)
TURNED = RAIL @ np.array([[math.cos(TURN), -math.sin(TURN)], [math.sin(TURN), math.cos(TURN)]])
COUNT = f"{len(RAIL)}\n"
MINIPROF = "ProgramName=MiniProf\nDate=01-02-2020\nColumnDef=Y,X,A,C\nElevation=0\n\n"
REMARK = RAIL_TEXT.replace("\n", "  added by hand (see 3)\n", 1)
READ = {
    **{f"separator {separator!r}": ("60E1", "a.txt", columns(RAIL, separator), {})
       for separator in (" ", "\t", ",", ";", " ; ", ", ")},
    "heading": ("60E1", "a.txt", "# measured\n% so\n! or so\ny,z\n\n" + columns(RAIL, ","), {}),
    "decimal commas": ("60E1", "a.txt", "y [mm]; z [mm]\r\n" + columns(RAIL, ";").replace(".", ","), {}),
    "named columns": ("60E1", "a.txt", "s [mm],z [mm],y [mm]\n" + "".join(f"0.0,{z:.12g},{y:.12g}\n" for y, z in RAIL), {}),
    "heading of many lines": ("60E1", "a.txt", "Rail 60E1\nmeasured in May\n\ny,z\n[mm],[mm]\n-----,-----\n"
                              + columns(RAIL, ","), {}),
    "words": ("60E1", "a.txt", "Operator: N. N.\ny,z\n" + columns(RAIL, ","), {}),
    "count": ("60E1", "a.txt", COUNT + columns(RAIL, ","), {}),
    "count below words": ("60E1", "a.txt", f"rail\n{COUNT}y,z\n" + columns(RAIL, ","), {}),
    "named columns below words": ("60E1", "a.txt", "Rail\nz,y,n\n(mm),(mm),(-)\n"
                                  + "".join(f"{z:.9f},{y:.9f},7\n" for y, z in RAIL), {}),
    "comments": ("60E1", "a.txt", commented(RAIL_TEXT), {}),
    "SIMPACK with comments": ("60E1", "a.prr", "% by hand\n" + simpack(commented(RAIL_TEXT), "type = 0 % rail",
                                                                    'units.len.f = 1000 "mm"'), {}),
    # Lengths in m, mirrored, upside down and shifted.
    "SIMPACK": ("S1002", "a.prw", "! comment\n" + simpack(
        "! y z weight\n" + columns(-1e-3 * WHEEL + [-0.25, 0.125]), "version = 1\ntype = 1 ! wheel",
        "approx.smooth = 0.0\ncomment = 'none'\nshift.y = 0.25\nshift.z = -0.125\nmirror.y = 1 ! yes\nmirror.z = 1\n"
        "inversion = 1\n! units.len = 'm'\nunits.len.f = +1.0E+00"), {}),
    # `rotate` turns from y to z; angles in degrees.
    "SIMPACK turned": ("60E1", "a.prr", simpack(columns(TURNED), spline="units.len.f = 1000\nunits.ang.f = 57.29577951308232\n"
                                                f"rotate = {math.degrees(TURN)!r}"), {}),
    "MiniProf": ("60E1", "a.ban", MINIPROF + "".join(f"{-z:.12g} {y:.12g} 0.1 0.2\n" for y, z in RAIL), {"flip": True}),
    **{f"MiniProf with comments, {name}": ("60E1", name, "% as measured\nDate=1 % of May\nColumnDef=X,Y % mm\n\n"
                                           + commented(RAIL_TEXT), {})
       for name in ("a.ban", "a.whl", "a.mpt", "A.MPT")},
    **{f"MiniProf, header {k}": ("60E1", "a.ban", header + REMARK, {}) for k, header in enumerate((
        "MINIPROF 101 148 1994 3 24\nWheel ID....:\n32.58 37.11 14.71  (Sd/Sh/qR)\n\n",
        "MINIPROF 2020\n32.58 37.11 14.71\n(Sd/Sh/qR)\n\n", "MINIPROF 2020\n32.58 37.11 14.71\n\n", "Sh=1.2\n", ""))},
    "MiniProf, last remark": ("60E1", "a.ban", REMARK[:-1] + " last\n", {}),
    "MiniProf, one section": ("60E1", "a.ban", "[ProfilePoints]\n" + RAIL_TEXT, {})}


@pytest.mark.parametrize("name, file, text, mend", READ.values(), ids=READ)
def test_every_format_is_read(read, name, file, text, mend):
    profile = read(text, BODY[name], file, **mend)
    assert off(profile, name) < SPLINE
    if not mend and "SIMPACK" not in text and file[-3:] == "ban":
        assert profile.y[0] == pytest.approx(RAIL[0, 0], abs=1e-9)  # numbers of the header are no points


@pytest.mark.parametrize("body, file, text, said", [
    ("rail", "a.txt", f"y z\n{RAIL_TEXT}end of list\n", f"a.txt:{len(RAIL) + 2}: expected a number, got `end`"),
    ("rail", "a.txt", "-36.0 37.x\n" + RAIL_TEXT, "a.txt:1: expected a number, got `37.x`"),
    ("rail", "a.txt", "rail\n-36,0 37,5\n-35,9x 37\n", "a.txt:2: has 4 numbers"),
    ("rail", "a.txt", "1o.5 3\n" + RAIL_TEXT, "a.txt:1: expected a number, got `1o.5`"),
    ("rail", "a.txt", "To whom it may concern:\nno list follows\n", "a.txt:2: is not a profile"),
    ("rail", "passwd", "root:x:0:0:root:/root:/bin/sh\nuser:secret:1000\n", "passwd:2: is not a profile"),
    ("rail", "a.prr", "root:x:0:0\nuser:secret:1000\n", "a.prr"),
    ("rail", "a.txt", "12\n" + RAIL_TEXT, "a.txt:1: only one number"),
    ("rail", "a.ban", "Rail\n-36.0 37..5 0\n" + RAIL_TEXT, "a.ban:2: expected a number, got `37..5`"),
    ("rail", "a.mpt", f"Rail\n{RAIL_TEXT}the end\n", f"a.mpt:{len(RAIL) + 2}: expected a number, got `the`"),
    ("rail", "a.prr", f"spline.begin\nfree text\npoint.begin\n{RAIL_TEXT}point.end\nspline.end\n",
     "a.prr:2: `free text` is not a key"),
    ("rail", "a.prr", "spline.begin\npoint.begin\n1 2\nand so on\npoint.end\n", "a.prr:4: expected a number, got `and`"),
    ("rail", "a.prw", simpack(WHEEL_TEXT, "type = 1"), "profile of a wheel"),
    ("wheel", "a.prw", "1 2\n3 4\n", "point.begin"),
    ("rail", "a.ban", RAIL_TEXT.replace(" ", " -"), "flip = true")], ids=lambda value: ascii(value)[1:30])
def test_text_that_makes_no_sense_is_refused_with_its_line(refusal, body, file, text, said):
    message = refusal(text, body, file)
    says(message, said)
    assert "secret" not in message


def test_a_kink_is_reported_with_its_place_and_angle(read, refusal):
    """A corner right after points in a row: it is where the curve turns, and as large as it is."""
    rows = "".join(f"{0.5 * k} {max(0, 0.5 * k) * math.tan(0.4):.9f}\n" for k in range(-40, 41))
    says(refusal(rows, "rail"), "profile.txt:41: kink of 22.9 degrees at y = 0,", "`largest_kink = 23`")
    read(rows, "rail", largest_kink=23.0)
    assert "kink of 0 " not in refusal(rows, "rail", largest_kink=22.9)


def proposed(message):
    return float(re.search("`smoothing = ([0-9.]+)`", message)[1])


def test_the_least_smoothing_that_suffices_is_proposed(read, refusal):
    """Steps everywhere are scatter: the least that explains them is proposed, and half does not."""
    points = points_of("60E1", 0.1)
    points[:, 1] += 0.01 * np.sin(12.9898 * np.arange(len(points), dtype=float)**2)
    smoothing = proposed(refusal(columns(points), "rail"))
    assert smoothing <= 0.01
    read(columns(points), "rail", smoothing=smoothing)
    refusal(columns(points), "rail", smoothing=0.5 * smoothing)


def test_all_repairs_are_named_in_one_message(read, refusal):
    """Everything is wrong; what the message names mends it in one go."""
    points = points_of("S1002", 0.2)
    chord = np.gradient(points, axis=0)
    noise = np.random.default_rng(3).normal(0.0, 0.01, len(points)) / np.hypot(*chord.T)
    points = -points + noise[:, None] * chord[:, ::-1] * MIRROR[::-1]
    points = np.delete(points, range(400, 430), axis=0)
    points = np.insert(points, 300, points[299], axis=0)
    points = np.insert(points, 200, points[199] + [0.5, 0.1], axis=0)
    text = columns(points, unit=1000.0)
    message = refusal(text, "wheel")
    says(message, "profile.txt:302: the point", "profile.txt:201: zig-zag", "gap of 6.",
         'do: put `unit = "m"`, `flip = true`, `mirror = true`, `drop_duplicates = true`, `drop_zigzag = true`, '
         "`longest_gap = 7`, `smoothing = ")
    smoothing = proposed(message)
    assert smoothing == pytest.approx(0.01, abs=0.0015)
    assert off(read(text, "wheel", smoothing=smoothing, unit="m", flip=True, mirror=True, drop_duplicates=True,
                    drop_zigzag=True, longest_gap=7.0), "S1002") < 0.02


def measured_around(top):
    """S1002 with the back of its flange and its chamfer measured up to this height above the tread."""
    def side(point):
        z = np.arange(point[1] - 0.5, -top, -0.5)
        return np.stack([np.full_like(z, point[0]), z], axis=1)
    return np.concatenate([side(WHEEL[0])[::-1], WHEEL, side(WHEEL[-1])])


@pytest.mark.parametrize("top", [5.0, 23.0, 60.0])
def test_a_wheel_is_known_to_be_upside_down_by_its_flange(read, refusal, top):
    """The flange is what the curve comes back from, however far the sides were measured."""
    points, mend = measured_around(top), {"largest_kink": 100.0}
    read(columns(points), "wheel", **mend)
    says(refusal(columns(points * UP), "wheel", **mend), "upward", "`flip = true`")
    read(columns(points * UP), "wheel", flip=True, **mend)
    # A right wheel that is flipped by mistake.
    says(refusal(columns(points), "wheel", flip=True, **mend), "`flip = false`")
    says(refusal(columns(points), "wheel", flip=True, mirror=True, **mend), "`flip = false`, `mirror = false`")


def test_a_wheel_with_two_flanges_is_not_upside_down(read):
    y = np.arange(-40.0, 40.1, 0.5)
    read(columns(np.stack([y, np.maximum(0.0, 2.0 * (np.abs(y) - 28.0))], axis=1)), "wheel", largest_kink=100.0)


def test_a_measured_tread_without_flange_has_no_tip(read):
    assert read(columns(WHEEL[WHEEL[:, 0] > -45.0]), "wheel").flange_tip is None


def test_a_wheel_measured_from_the_back_of_its_flange_is_told_from_one_that_is_not(rollfem):
    rollfem.file("back.txt", columns(WHEEL + [70.0, 0.0]))
    back = WHEEL_ON_RAIL | {"wheel.profile": "back.txt"}
    outcome = rollfem.call("check", rollfem.case(back))
    assert outcome.status == 2
    says(outcome.err, "the tip of the flange is at y = 15 mm, where the tread should be",
         "put `shift = [-70, 0]` under [wheel_profile]", "flange_back_position under [wheelset]")
    for known in {"wheel_profile.shift": [-70.0, 0.0]}, {"wheelset.flange_back_position": 0.0}:
        rollfem.done("check", rollfem.case(back | known))


def test_a_miniprof_file_of_several_profiles_is_read_by_its_section(read, refusal):
    text = (f"ProgramName=MiniProf\nColumnDef=X,Y\n[Profile1Points]\n{RAIL_TEXT}[Profile2Points]\n"
            + columns(measured_around(5.0)))
    says(refusal(text, "rail", "both.mpt"), "holds 2 profiles", f"Profile1Points ({len(RAIL)} points), Profile2Points",
         "`section = ")
    assert off(read(text, "rail", "both.mpt", section="Profile1Points"), "60E1") < SPLINE
    assert off(read(text, "wheel", "both.mpt", section="Profile2Points", largest_kink=100.0), "S1002") < SPLINE
    says(refusal(text, "wheel", "both.mpt", section="Profile3Points"), '"Profile3Points" is not one')
    says(refusal(RAIL_TEXT, "rail", "rail.txt", section="Profile3Points"), "section cannot be set")


# VAMPIRE: four columns behind a header of four lines.
WHEEL_HEADER = "WHEELPROFILE\nmade by hand\nTREADDATUM EUROPEAN\nFLANGEBACK 1360.0\n"
RAIL_HEADER = "RAILPROFILE\n! made by hand\nGAUGEPOINT EUROPEAN\nGAUGE 1435.0\n"


def vampire(points, lower=0.0):
    """Both sides, of which the left one is lowered."""
    return "".join(f"{-y:.10f} {z + lower:.10f}, {y:.10f}\t{z:.10f}\n" for y, z in points)


def vampire_wheel(datum=70.0, lower=0.0):
    """S1002 with its tape line `datum` mm from the back of the flange, which is 680 mm from the middle of the track."""
    return vampire(WHEEL + [680.0 + datum, 0.0], lower)


def test_wheels_and_rails_of_vampire_get_the_frame_of_profiles(read):
    assert off(read(WHEEL_HEADER + vampire_wheel(), None, "a.whe"), "S1002") < SPLINE
    # z upward, and the crown 36 mm from the gauge.
    rail = vampire([753.5, 171.3] + RAIL * UP)
    assert off(read(RAIL_HEADER + rail, None, "a.RAI", shift=[-36.0, 0.0]), "60E1") < SPLINE
    for word, datum in ("US1", 72.23125), ("US2", 77.7875), ("CUSTOM 66.5", 66.5):
        assert off(read(WHEEL_HEADER.replace("EUROPEAN", word) + vampire_wheel(datum), "wheel", "a.whe"), "S1002") < SPLINE, word


def test_sides_of_vampire_that_differ_are_chosen_by_the_case(read, refusal):
    file = WHEEL_HEADER + vampire_wheel(lower=0.5), "wheel", "a.whe"
    says(refusal(*file), "a.whe: its left and right profiles differ by up to 0.5 mm", 'section = "left"', "[wheel_profile]")
    assert off(read(*file, section="right"), "S1002") < SPLINE
    assert off(read(*file, section="left", shift=[0.0, -0.5]), "S1002") < SPLINE
    says(refusal(*file, section="middle"), '"middle"', "left, right")


def test_wheels_of_vampire_with_z_upward_are_flipped(read, refusal):
    file = WHEEL_HEADER + vampire([750.0, 0.0] + WHEEL * UP), "wheel", "a.whe"
    says(refusal(*file), "flip = true")
    assert off(read(*file, flip=True), "S1002") < SPLINE


LAST = f"a.whe:{5 + len(WHEEL)}: "


@pytest.mark.parametrize("header, more, parts", [
    (RAIL_HEADER, "", ["a.whe:1: the first line is not WHEELPROFILE"]),
    ("", "", ["a.whe:1: "]),
    (WHEEL_HEADER.replace("EUROPEAN", "EAST"), "", ["a.whe:3: ", "US1, US2"]),
    (WHEEL_HEADER.replace("EUROPEAN", "CUSTOM"), "", ["a.whe:3: "]),
    (WHEEL_HEADER.replace("1360.0", ""), "", ["a.whe:4: FLANGEBACK"]),
    ("WHEELPROFILE\n\nTREADDATUM US1\n", "", ["FLANGEBACK is missing"]),
    ("WHEELPROFILE\n\nFLANGEBACK 1360\n", "", ["TREADDATUM is missing"]),
    (WHEEL_HEADER.replace("FLANGEBACK", "BACK"), "", ["a.whe:4: ", "BACK"]),
    (WHEEL_HEADER, "-1 2 3\n", [LAST + "has 3 numbers", "left side"]),
    (WHEEL_HEADER, "1 2 3 4\n", [LAST, "y = 1 (left)"]),
    (WHEEL_HEADER, "-1 2 3 x\n", [LAST, "x"])], ids=lambda value: ascii(value)[1:40] if isinstance(value, str) else "")
def test_wrong_files_of_vampire_are_refused_with_their_line(refusal, header, more, parts):
    says(refusal(header + vampire_wheel() + more, "wheel", "a.whe"), *parts)


def test_other_wrong_files_of_vampire_are_refused(refusal):
    says(refusal("RAILPROFILE\n\nGAUGEPOINT US\n" + vampire(RAIL + [753.5, 0.0]), "rail", "a.rai"), "GAUGE is missing")
    says(refusal(WHEEL_HEADER, "wheel", "a.whe"), "a.whe")
    says(refusal(WHEEL_HEADER + vampire_wheel(), "wheel", "a.whe", unit="inch"), "remove `unit`")


# Steps, noise and many points.
def test_rounding_bridges_a_step_within_the_stated_length(read):
    profile, truth = read(columns(raised(RAIL, step)), "rail", rounding=3.0), package().Profile("60E1")
    y = np.array([-20.0, 0.0, 1.0, 9.0, 20.0])
    assert np.abs(height(profile, y) - height(truth, y) - step(y)).max() < 1e-3
    # A cubic over 6 mm that rises by 0.1 mm bends by 6 * 0.1 / 36 at its ends.
    bridge = (profile.y > 1.0) & (profile.y < 9.0)
    assert np.abs(profile.curvature[bridge]).max() < 2 * 6 * 0.1 / 36


@pytest.mark.parametrize("rise", [0.0, 0.4])
def test_stated_scatter_is_no_kink_but_a_step_is(read, refusal, rise):
    """Noise makes kinks of 40 degrees at this spacing."""
    points = points_of("60E1", 0.1)
    across = np.gradient(points, axis=0)[:, ::-1] * MIRROR
    moved = np.random.default_rng(5).normal(0.0, 0.01, len(points)) + rise * (points[:, 0] > 5.0)
    text = columns(points + across * (moved / np.hypot(*across.T))[:, None])
    refusal(text, "rail")
    (refusal if rise else read)(text, "rail", smoothing=0.01)


def a_million(noise=0.0):
    """A file of a million points of S1002, with normal noise (mm) along z."""
    profile = package().Profile("S1002")
    points = points_of("S1002", profile.length / 999999.5)
    points[:, 1] += noise * np.random.default_rng(7).normal(size=len(points))
    return "\n".join(map("%.12f %.12f".__mod__, map(tuple, points.tolist())))


def test_a_million_points_are_kept_exactly(read):
    assert off(read(a_million(), "wheel"), "S1002") < 1e-8


def test_a_million_noisy_points_are_thinned_and_smoothed(read, refusal):
    text = a_million(0.01)
    refusal(text, "wheel", smoothing=0.01)
    # Means of some 650 points each have noise of 0.01 / sqrt(650) mm.
    profile, truth = read(text, "wheel", smoothing=4e-4, thinning=0.1), package().Profile("S1002")
    assert off(profile, "S1002") < 2e-3
    y = np.arange(-15.0, 25.0, 0.3)
    assert np.abs(np.interp(y, profile.y, profile.curvature) - np.interp(y, truth.y, truth.curvature)).max() < 1e-3
