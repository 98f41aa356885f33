# SPDX-License-Identifier: LGPL-2.1-or-later
"""Built-in profiles and profiles of formulas. Rails of EN 13674-1:2017 against what the standard and makers' catalogues print
beside the drawings: width of the head, area and second moment of the whole section. The profiles give the head; web and foot
are here from the drawings. An arc of the head that ends 0.01 mm off, or whose radius is off by 0.1 %, fails. S1002 and the
rail of the Manchester benchmark against its lists. Points are complex numbers y + i z."""

import math
import os
import pathlib
import re
from typing import NamedTuple

import numpy as np
import pytest
from profiles import along, height
from program import SMALL, SOURCE, package, says, toml

rollfem = package()


class Line(NamedTuple):
    """A straight line of the right half of an outline, followed downwards."""
    point: complex
    way: complex

    def shifted(self, distance):
        """To the right of the way: out of the section where the way turns to the middle."""
        return Line(self.point - 1j * distance * self.way, self.way)

    def nearest(self, point):
        return self.point + ((point - self.point) * self.way.conjugate()).real * self.way


def line(point, way):
    return Line(point, way / abs(way))


def crossing(a, b):
    def cross(u, v):
        return (u.conjugate() * v).imag
    return a.point + cross(b.point - a.point, b.way) / cross(a.way, b.way) * a.way


def arc(centre, start, end):
    turn = np.angle((end - centre) / (start - centre))
    return centre + (start - centre) * np.exp(1j * turn * np.linspace(0, 1, 401))


def fillet(a, b, radius):
    """Between two lines; hollow ones (> 0) have their centre outside the section."""
    centre = crossing(a.shifted(radius), b.shifted(radius))
    return arc(centre, a.nearest(centre), b.nearest(centre))


def small_circle(at, radius, large, large_radius, near):
    """Touches a line, and from within a larger circle of the web; both hollow. Of the two such circles the one nearer to
    `near`: its centre and where it touches the larger circle."""
    shifted = at.shifted(radius)
    foot = shifted.nearest(large)
    half = math.sqrt((large_radius - radius)**2 - abs(foot - large)**2)
    centre = min((foot + sign * half * shifted.way for sign in (-1, 1)), key=lambda place: abs(place - near))
    return centre, large + large_radius * (centre - large) / abs(centre - large)


def head(profile, underside):
    """Right half of the head, and its lower corner of radius 3; the profile goes on to the sharp corner."""
    points = along(profile, np.linspace(profile.length / 2, profile.length, 4001)) @ [1, 1j]
    return [points[points.imag <= 30.0], fillet(line(points[-1], 1 + 20j), underside, -3.0)]


def foot(upper, height, half, edge, slope, hollow, top, bottom):
    lower, side = line(half + 1j * edge, slope + 1j), line(half, 1j)
    return [fillet(upper, lower, hollow), fillet(lower, side, -top), fillet(side, line(1j * height, -1), -bottom), [1j * height]]


def upper_of_foot(depth):
    return line(1j * depth, 2.75 + 1j)


def underside(depth):
    return line(1j * depth, -2.75 + 1j)


def section_60(profile):
    under, upper = underside(51.0), upper_of_foot(140.5)
    above, below, aside = 128.25 + 79.75j, 128.25 + 111.75j, complex(math.sqrt(85.0**2 - 19.5**2), 19.5)
    above_35, below_35 = above - aside, below - aside.conjugate()
    above_7, touches = small_circle(under, 7.0, above_35, 35.0, 15 + 52j)
    below_7, leaves = small_circle(upper, 7.0, below_35, 35.0, 15 + 135j)
    joint_above, joint_below = (centre + 35 / 85 * (centre - web) for centre, web in ((above_35, above), (below_35, below)))
    return [*head(profile, under), arc(above_7, under.nearest(above_7), touches), arc(above_35, touches, joint_above),
            arc(above, joint_above, 8.25 + 79.75j), arc(below, 8.25 + 111.75j, joint_below),
            arc(below_35, joint_below, leaves), arc(below_7, leaves, upper.nearest(below_7)),
            *foot(upper, 172.0, 75.0, 160.5, 14.0, 40.0, 4.0, 2.0)]


def section_54(profile):
    under, upper = underside(49.4), upper_of_foot(128.8)
    web, above = 516 + 82.8j, 516 - math.sqrt(486.0**2 - 25.4**2) + 57.4j
    joint = above + 22 / 486 * (above - web)
    corner, touches = small_circle(under, 8.0, above, 22.0, 15 + 52j)
    root, leaves = small_circle(upper, 16.0, web, 508.0, 24 + 110j)
    return [*head(profile, under), arc(corner, under.nearest(corner), touches), arc(above, touches, joint),
            arc(web, joint, leaves), arc(root, leaves, upper.nearest(root)),
            *foot(upper, 159.0, 70.0, 148.0, 10.0, 20.0, 3.0, 2.0)]


def section_56(profile):
    under, upper, web = underside(49.21), upper_of_foot(128.59), line(10.0, 1j)
    return [*head(profile, under), fillet(under, web, 8.0), fillet(web, upper, 15.0),
            *foot(upper, 158.75, 70.0, 147.55, 10.0, 20.0, 3.0, 1.5)]


def properties(outline):
    """Area (cm^2) and second moment about the horizontal axis through the centroid (cm^4) of both halves."""
    points = np.concatenate(outline)
    (y, z), (v, w) = ((part.real, part.imag) for part in (points[:-1], points[1:]))
    area, first, second = (np.sum((w - z) * part) for part in (
        (y + v) / 2, (y * (2 * z + w) + v * (z + 2 * w)) / 6,
        (y * (3 * z * z + 2 * z * w + w * w) + v * (z * z + 2 * z * w + 3 * w * w)) / 12))
    return 2 * area / 1e2, 2 * (second - first**2 / area) / 1e4


# EN 13674-1:2017, annex A: width of the head (mm), area (cm^2), second moment and its last digit (cm^4). 60E1 is here for the
# method.
@pytest.mark.parametrize("name, section, width, area, moment, digit", [
    ("60E1", section_60, 72.0, 76.70, 3038.3, 0.1), ("60E2", section_60, 72.0, 76.48, 3021.5, 0.1),
    ("54E1", section_54, 70.0, 69.77, 2337.9, 0.1), ("56E1", section_56, 69.85, 71.69, 2321.0, 1.0)])
def test_rails_have_the_published_width_area_and_second_moment(name, section, width, area, moment, digit):
    rail = rollfem.Profile(name)
    found = properties(section(rail))
    assert found[0] == pytest.approx(area, abs=0.5 * 0.01) and found[1] == pytest.approx(moment, abs=0.5 * digit)
    # The head has its nominal width where the sides of 1:20 begin; the drawings give the widths of the arcs with three
    # decimals.
    assert [rail.joints[0], rail.joints[-1]] == pytest.approx([-0.5 * width, 0.5 * width], abs=2e-4)
    assert math.tan(math.radians(rail.angle[-1])) == pytest.approx(20.0, abs=1e-6)
    # Symmetric with tangent arcs.
    y = np.arange(0.3, 35.0, 0.7)
    assert height(rail, 0.0) == pytest.approx(0.0, abs=1e-12) and np.allclose(height(rail, y), height(rail, -y), atol=1e-9)
    jumps = np.flatnonzero(np.diff(rail.s) == 0.0)
    assert len(jumps) > 4 and np.allclose(rail.angle[jumps], rail.angle[jumps + 1], atol=1e-6)


@pytest.mark.parametrize("older, name", [("UIC60", "60E1"), ("UIC54", "54E1"), ("BS113A", "56E1")])
def test_older_names_of_rails_are_the_same_profiles(older, name):
    one, other = rollfem.Profile(older), rollfem.Profile(name)
    assert (one.y == other.y).all() and (one.z == other.z).all()


@pytest.mark.parametrize("name", ["S1002", "60E1", "60E2", "54E1", "56E1"])
def test_mirrored_has_every_height_and_the_opposite_slope_on_the_other_side(name):
    profile, image = rollfem.Profile(name), rollfem.Profile(name, "wheel" if name == "S1002" else "rail", mirror=True)
    assert [image.y[0], image.y[-1]] == pytest.approx([-profile.y[-1], -profile.y[0]], abs=1e-12)
    at = np.linspace(0.0, profile.length, 60)
    assert np.allclose(along(image, image.s[-1] - at), along(profile, at) * [-1, 1], rtol=0, atol=1e-9)


# MBench_S1002_v3.prw, y mirrored as its header says. It prints eight digits; where the flank rises with 70 degrees, half a last
# digit of y is 1.4e-6 mm of z.
def test_s1002_meets_points_of_the_manchester_list():
    y = [-69.612628, -69.225256, -66.126280, -62.639932, -57.604097]
    assert height(rollfem.Profile("S1002"), y) == pytest.approx([13.485642, 15.101756, 21.511624, 25.253725, 27.714038], abs=2e-6)


def listed(name):
    """Points of one of the benchmark's files, which may not be here."""
    file = pathlib.Path(os.environ.get("ROLLFEM_REFERENCE") or SOURCE.parent / "shared/reference") / name
    if not file.exists():
        pytest.skip("the benchmark's files are not here")
    rows = re.search(r"point\.begin[^\n]*\n(.*?)point\.end", file.read_text("latin-1"), re.S)[1]
    return np.array([row.split()[:2] for row in rows.splitlines() if re.match(r"\s*[-+.\d]", row)], float), str(file)


def test_s1002_meets_all_points_of_the_manchester_list():
    points, file = listed("MBench_S1002_v3.prw")
    assert len(points) == 399
    y, z = -points[:, 0], points[:, 1]
    joined = (y > -35.0) & (y < -26.0)  # zone C
    plain, smooth = (np.abs(height(rollfem.Profile(name), y) - z) for name in ("S1002", "S1002-smooth"))
    assert plain.max() < 2e-6 and smooth[~joined].max() < 2e-6 and smooth[joined].max() < 1.3e-4
    read = rollfem.Profile(file)
    assert read.points == 399
    at = np.arange(-35.0, 55.0, 0.7)
    assert np.abs(height(read, at) - height(rollfem.Profile("S1002"), at)).max() < 1e-4


def test_the_rail_of_the_benchmark_meets_its_list():
    points, file = listed("MBench_UIC60_v3.prr")
    # In the list the rail is inclined 1:40, its crown at (-7.49170, 0.09371).
    rail = rollfem.Profile("UIC60-manchester", "rail", rotation=-math.atan(1 / 40), shift=[-7.49170, 0.09371])
    points = points[points[:, 1] < 37.4]
    dense = along(rail, at := np.arange(rail.s[0], rail.s[-1], 0.01))
    nearest = np.array([np.argmin(np.hypot(*(dense - point).T)) for point in points])
    tangent = np.gradient(dense, at, axis=0)[nearest]
    away = points - dense[nearest]
    assert len(points) >= 450 and np.abs(away[:, 0] * tangent[:, 1] - away[:, 1] * tangent[:, 0]).max() < 5e-5
    # Its sides end in points that lie a thousandth of a millimetre from each other.
    read = rollfem.Profile(file)
    assert read.points > 450 and np.interp(60.0, read.s, read.curvature) == pytest.approx(1 / 80, abs=1.0)


# Formulas.
HEAD = {"radii": [300.0, 80.0, 13.0], "ends": [10.228, 26.0265, 35.99], "symmetric": True}


def test_arcs_make_the_head_of_60e1():
    y, truth = np.arange(-30.0, 30.0, 0.7), rollfem.Profile("60E1")
    both = {"radii": [13.0, 80.0, 300.0, 80.0, 13.0], "ends": [-35.99, -26.0265, -10.228, 10.228, 26.0265, 35.99]}
    for rail in rollfem.Profile("arcs", "rail", **HEAD), rollfem.Profile("arcs", "rail", **both):
        assert np.abs(height(rail, y) - height(truth, y)).max() < 1e-9
    # As a wheel, whose convex side is the other one.
    wheel = rollfem.Profile("arcs", "wheel", **both)
    assert height(wheel, 20.0) == pytest.approx(-height(rail, 20.0), abs=1e-12)
    assert np.interp(20.0, wheel.y, wheel.curvature) == pytest.approx(-1 / 80, abs=1e-6)


def test_a_cone_is_a_straight_arc_with_a_slope():
    cone = rollfem.Profile("arcs", "wheel", radii=[math.inf], ends=[-30.0, 50.0], slope=-0.05)
    y = np.array([-30.0, -7.0, 0.0, 50.0])
    assert np.allclose(height(cone, y), -0.05 * y, rtol=0, atol=1e-12)


def test_polynomials_are_their_formula():
    """y^2 / 600 up to 12, then the tangent there."""
    pieces = {"coefficients": [0.0, 0.0, 1 / 600, -144 / 600, 24 / 600, 0.0], "limits": [-30.0, 12.0, 40.0]}
    profile = rollfem.Profile("polynomial", "rail", **pieces)
    y = profile.y[np.abs(profile.y - 12.0) > 0.1]
    z, curvature = profile.z[np.abs(profile.y - 12.0) > 0.1], profile.curvature[np.abs(profile.y - 12.0) > 0.1]
    assert np.allclose(z, np.where(y < 12.0, y**2, 24 * y - 144) / 600, rtol=0, atol=1e-10)
    assert np.allclose(curvature, np.where(y < 12.0, (1 + y**2 / 9e4)**-1.5 / 300, 0.0), rtol=0, atol=1e-8)
    pieces["coefficients"][3] += 0.01
    with pytest.raises(rollfem.InputError):
        rollfem.Profile("polynomial", "rail", **pieces)


@pytest.mark.parametrize("name, mend", [
    ("arcs", {}), ("arcs", {"radii": [300.0, 80.0], "ends": [-10.0, 10.0]}),
    ("arcs", {"radii": [300.0, 80.0], "ends": [-10.0, 10.0, 5.0]}),
    ("arcs", {"radii": [300.0, 80.0], "ends": [-10.0, 10.0, 95.0]}),  # beyond the vertical tangent
    ("polynomial", {"radii": [300.0, 80.0], "ends": [-10.0, 10.0, 60.0]})])
def test_wrong_lists_of_formulas_are_refused(name, mend):
    with pytest.raises(rollfem.InputError) as refused:
        rollfem.Profile(name, "rail", **mend)
    says(str(refused.value), "rail_profile", "do: ")


@pytest.mark.parametrize("name", ["S1003", "no/such/file.txt", "60E1"])
def test_names_that_are_not_known_and_bodies_that_do_not_fit_are_refused(name):
    with pytest.raises(rollfem.InputError, match="S1002"):
        rollfem.Profile(name, "wheel")


def test_rotation_and_shift_are_applied_in_this_order():
    """The crown is at the shift, and its tangent rises by the rotation from y to z."""
    moved = rollfem.Profile("60E1", "rail", rotation=0.025, shift=[3.0, -2.0])
    assert height(moved, 3.0) == pytest.approx(-2.0, abs=1e-9)
    assert np.radians(np.interp(3.0, moved.y, moved.angle)) == pytest.approx(0.025, abs=1e-9)


def test_a_radius_is_an_arc(tmp_path):
    (tmp_path / "case.toml").write_text(toml(SMALL | {"rail.transverse_radius": 300.0}))
    wheel, rail = (rollfem.Profile.of(tmp_path / "case.toml", body) for body in ("wheel", "rail"))
    assert height(wheel, 20.0) == 0.0 and height(rail, 20.0) == pytest.approx(300.0 - math.sqrt(9e4 - 400.0), abs=1e-10)


@pytest.mark.parametrize("body, inwards", [("wheel", -1.0), ("rail", 1.0)])
def test_side_faces_of_free_ends_go_inwards_from_where_the_points_end(tmp_path, body, inwards):
    """A face as high as 0.3 times the width of 20 mm, up of a wheel and down of a rail."""
    def profile(**more):
        (tmp_path / "case.toml").write_text(toml({
            "load.vertical_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0, "wheel.profile": "arcs",
            "rail.profile": "arcs", "placement.lateral_position": 0.0} | {
                f"{each}_profile.{key}": value for each in ("wheel", "rail") for key, value in (
                    {"radii": [400.0], "ends": [-8.0, 12.0], "shift": [1.0, 2.0]} | more).items()}))
        return rollfem.Profile.of(tmp_path / "case.toml", body)

    opened, whole = profile(), profile(free_ends=True)
    for end, outwards in (0, -1.0), (-1, 1.0):
        assert inwards * (whole.z[end] - opened.z[end]) == pytest.approx(6.0, abs=0.02)
        assert outwards * (whole.y[end] - opened.y[end]) == pytest.approx(2.0, abs=0.02)
        assert math.tan(math.radians(whole.angle[end])) == pytest.approx(3.0 * inwards * outwards, abs=1e-9)
    y = np.array([-6.9, 1.0, 12.9])
    assert np.allclose(height(whole, y), height(opened, y), rtol=0, atol=1e-9)
