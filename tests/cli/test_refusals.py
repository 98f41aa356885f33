# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every error in an input gives one message with file, line, key, value, allowed values and advice; none crashes. The
inputs are rows of tests/refusals, each a test of its own."""

import math
import os
import re

import pytest
from program import SMALL, SOURCE, package, says, toml


def plain(text):
    """A text of the rows as bytes: with the escapes of C."""
    return text.encode().decode("unicode_escape").encode("latin-1")


def changed(text, change):
    """A base with the changes of a row."""
    for step in re.split(r"(?:^|(?<= ))&& ", change) if change else []:
        step = step.removesuffix(" ")
        if step[:2] in ("+ ", "^ "):
            lines = plain(step[2:]) + b"\n"
            text = text + lines if step[0] == "+" else lines + text
        else:
            piece, _, other = (step + " ").partition(" => ")
            assert plain(piece) in text, f"no {piece}"
            text = text.replace(plain(piece), plain(other[:-1] if other else ""), 1)
    return text


def rows(name):
    """(text, parts of the message) of the rows of a file, named by line and change."""
    bases, base, entries = {}, "", []
    for number, line in enumerate((SOURCE / "tests/refusals" / name).read_text("utf-8").splitlines(), 1):
        if line.startswith("@"):
            base = line[1:]
            file = SOURCE / f"tests/support/contact/{base}.inp"
            bases[base] = file.read_bytes() if file.exists() else b""
        elif line.startswith("    ! "):
            entries[-1][3].extend(line[6:].split(" ! "))
        elif line.startswith("    "):
            bases[base] += line[4:].encode() + b"\n"
        elif line and not line.startswith("# "):
            change, *parts = re.split(r"(?:^| )! ", line)
            entries.append((number, base, change, parts))
    assert len(entries) > 5
    return [pytest.param(bases[base], change, parts, id=f"{number}: {change[:60]}") for number, base, change, parts in entries]


def refusal(call, *arguments):
    """What the compiled module of the package says against a call, "" if nothing."""
    package()
    from rollfem import _core, errors
    try:
        getattr(_core, call)(*arguments)
    except (errors.InputError, errors.FileError) as error:
        return str(error)
    return ""


def message(text):
    return refusal("parse_case", text, "case.toml")


def expect(said, parts):
    """One line without control characters that has the parts and says what to do; nothing where there are none."""
    if parts:
        says(said, *parts, "; do: ")
        assert said.isprintable()
    else:
        assert said == ""


@pytest.mark.parametrize("base, change, parts", rows("case.txt"))
def test_case(base, change, parts):
    expect(message(changed(base, change)), parts)


@pytest.mark.parametrize("base, change, parts", rows("convert.txt"))
def test_input_of_contact(rollfem, base, change, parts):
    outcome = rollfem.call("convert", rollfem.file("a.inp", changed(base, change)), "-o", "made")
    assert outcome.status == 2 and rollfem.made() == []
    says(outcome.err, *parts)


def test_input_of_contact_cut_short(rollfem):
    whole = (SOURCE / "tests/support/contact/pushed_ball.inp").read_text()
    rollfem.refuses("convert", rollfem.file("a.inp", whole.partition("0.02 0.0")[0]),
                    says="a.inp:12: the file ends before B1; do: check that it is complete")


def shortly(value):
    """The name of a parameter: CTest's environment takes no long ones."""
    return ascii(value)[1:40] if isinstance(value, str) else ""


DEEP = "a" + 63 * ".a"


@pytest.mark.parametrize("text, parts", [
    (toml({"title": "x" * 300} | SMALL), ["longer than 200"]),
    (toml({"title": "." * 150} | SMALL) + "# " + "." * 150, []),
    (toml(SMALL | {"rolling.spin": [0] * 1001}), ["rolling.spin", "more than 1000 entries"]),
    ("a." * 100000 + "a = 1\n", ["case.toml:1: the line is longer than"]),
    ("a = " + "[" * 9000, ["case.toml:1:70: ", "nested more than 64 deep"]),
    ("a = " + ("[" * 9000 + "\n") * 100, ["case.toml:1:70: not valid TOML", "nested more than 64 deep"]),
    ("a = " + "[" * 70 + "]" * 70, ["case.toml:1:70: not valid TOML in `", "nested more than 64"]),
    ("a" + "." * 200, ["case.toml:1:3: not valid TOML in `", "expected a key"]),
    (DEEP + " = 1", ["case.toml:1:1: a: is not a key"]),
    (f"[{DEEP}.a]", ["case.toml:1:130: not valid TOML", "nested more than 64 deep"]),
    # Whatever stands before it in quotes or in a comment.
    *((f"{before}{DEEP}.a = 1", [f"case.toml:{1 + before.count(chr(10))}:129: not valid", "nested more than 64 deep"])
      for before in ("", "x = '''\n'a''''\n", "x = \"\\\"\" # '\n", "'=\"'.x = 1\n", 'x = \"\"\"\\\"\"\"\"\n')),
    ("title = 'a\x1b[31m\x07'\n" + toml(SMALL), ["control characters"]),
    ('"\\u001b[2J\\n" = 1\n' + toml(SMALL), ["case.toml:1:1: ?[2J?: is not a key"]),
    ("a = i\n", ["case.toml:1:6: not valid TOML"]),
    ("#" * (2**20 + 1), ["larger than 1 MB"]),
    ("", ["case.toml: is empty"]),
    (" \r\n\t\n", ["case.toml: is empty"])], ids=shortly)
def test_extreme_case(text, parts):
    expect(message(text), parts)


def test_a_case_may_have_letters_beyond_ascii_in_texts_and_comments():
    text = "# \u00b5 = friction\ntitle = '\u00dcbergang, \u00b5 = 0.3'\n" + toml(SMALL)
    assert package()._core.parse_case(text, "case.toml").title == "\u00dcbergang, \u00b5 = 0.3"


@pytest.mark.parametrize("file, said", [("/nowhere/case.toml", "/nowhere/case.toml: there is no such file"),
                                        ("/", "/: is a folder"), ("/dev/zero", "is not a regular file"),
                                        ("", "there is no such file")])
def test_what_is_no_file_is_refused(file, said):
    says(refusal("read_case", file, []), said)


def test_a_huge_file_is_refused_without_reading_it(tmp_path):
    huge = tmp_path / "huge.toml"
    huge.touch()
    os.truncate(huge, 2**40)  # sparse: takes no space
    says(refusal("read_case", str(huge), []), "larger than 1 MB")


LATTICE = "".join(f"{-2 + 0.5 * i}, {-1 + 0.25 * j}, {i * j}\n" for j in range(4) for i in range(4))
DISTANCE = {"load.normal_force": 1.0, "friction.coefficient": 0.3, "undeformed_distance.file": "points.csv"}
RESIDUAL = SMALL | {"rail_plasticity.yield_stress": 520.0, "rail_plasticity.residual_file": "points.csv"}


@pytest.mark.parametrize("keys, content, parts", [
    (DISTANCE, LATTICE, []),
    (DISTANCE, LATTICE + "1, 2\n", ["points.csv:17: has 2 numbers, not 3"]),
    (DISTANCE, "0, 0, nan\n" + LATTICE, ["points.csv:1: 'nan' is not"]),
    (DISTANCE, LATTICE + "0.1, 0, 1\n", ["regular lattice"]),
    (DISTANCE, LATTICE + "-2, -1, 1\n", ["points.csv:17: the point (-2, -1) was given before, in line 1"]),
    (DISTANCE, LATTICE.partition("\n")[2], ["lacks (-2, -1)"]),
    (DISTANCE, "".join(line for line in LATTICE.splitlines(True) if line[:4] != "-0.5"), ["3 different values of x"]),
    (DISTANCE, "", ["has no points"]),
    (DISTANCE, "x,y,h\nonly,words,here\n", ["has no points"]),
    (DISTANCE | {"undeformed_distance.file": "none.csv"}, "", ["none.csv: there is no such file"]),
    (RESIDUAL, "0, 1, 2\n1, 2\n", ["points.csv:2: has 2 numbers, not 3: depth, along"]),
    (RESIDUAL, "0, 1, 2\n1, 2, x\n", ["points.csv:2: 'x' is not a finite number"]),
    (RESIDUAL, "0, 1, 2\n3, 1, 2\n3, 2, 1\n", ["points.csv:3: the depth 3 does not"]),
    (RESIDUAL, "-1, 1, 2\n", ["points.csv:1: the depth -1 does not ascend from 0"]),
    (RESIDUAL, "# nothing\n", ["points.csv: has no points", "depth, along, across"]),
    (RESIDUAL | {"rail_plasticity.residual_along": 3.0}, "0, 1, 2\n",
     ["rail_plasticity.residual_file", "stands beside lists", "do: remove one of the two"]),
    (RESIDUAL | {"rail_plasticity.residual_file": "no.csv"}, "", ["no.csv: there is no such file"])], ids=shortly)
def test_points_of_a_case(tmp_path, keys, content, parts):
    (tmp_path / "points.csv").write_text(content)
    (tmp_path / "case.toml").write_text(toml(keys))
    expect(refusal("read_case", str(tmp_path / "case.toml"), []), parts)


def test_points_that_are_none_are_not_quoted(tmp_path):
    (tmp_path / "points.csv").write_text("root:x:0:0\nuser:secret:1000\n")
    (tmp_path / "case.toml").write_text(toml(DISTANCE))
    said = refusal("read_case", str(tmp_path / "case.toml"), [])
    assert said and "secret" not in said


def turn(step, *last):
    """A wheel of 8 sections, of which every second one is lower."""
    return "".join(f"{k * step} {1 + k % 2}.txt\n" for k in range(8)) + "".join(last)


@pytest.mark.parametrize("body, sections, parts", [
    ("rail", "0 1.txt\n", ["a.sections:1:", "at least two"]),
    ("rail", "0 1.txt\n0 2.txt\n", ["a.sections:2:", "position 0 after 0", "increasing"]),
    ("rail", "zero 1.txt\n1 2.txt\n", ["a.sections:1:", "zero"]),
    ("rail", "0 1.txt 5\n1 2.txt\n", ["a.sections:2:", "0 features", "as many for each"]),
    ("rail", "0 1.txt 500\n1 2.txt 10\n", ["a.sections:1:", "beyond the end"]),
    ("rail", "0 1.txt\n1 9.txt\n", ["9.txt"]),
    ("rail", "0 1.txt\n1 a.sections\n", ["a.sections:2: a.sections is a list", "files with one profile"]),
    ("rail", "0 1.txt\n1 b.slcs\n", ["a.sections:2: b.slcs is a list", "files with one profile"]),
    ("rail", "".join(f"{k} none.txt\n" for k in range(10001)), ["10001 sections; allowed: at least two, at most 10000"]),
    ("rail", "".join(f"{u} none.txt" + "".join(f" {0.01 * k}" for k in range(1, 1002)) + "\n" for u in (0, 1)),
     ["1001 features", "up to 1000"]),
    ("wheel", turn(math.pi / 4, "6.2832 2.txt\n"),
     ["a.sections:9: a full turn ends with another section", "leave this line out"]),
    ("wheel", turn(math.pi / 4, "6.29 1.txt\n"), ["a.sections:9: angles over 6.29", "2 pi = 6.283185"]),
    ("wheel", turn(45.0), ["angles over 315", "angles in rad"])], ids=shortly)
def test_list_of_sections(rollfem, body, sections, parts):
    for k in 1, 2, 3:
        rollfem.file(f"{k}.txt", "".join(f"{0.5 * i} {300 - math.sqrt(9e4 - 0.25 * i * i) - 0.5 * k}\n"
                                         for i in range(-72, 73)))
    rollfem.file("b.slcs", "0 1\n2\n0 0 0\n2\n0 a.sections\n1 a.sections\n")
    outcome = rollfem.call("profile", rollfem.file("a.sections", sections), f"--{body}", "-o", "out")
    assert outcome.status == 2, outcome
    says(outcome.err, *parts)
