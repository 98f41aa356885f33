# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of figures and pages of the Python package, one by one: scales, contours, words, the structure of a page."""

import html.parser
import math
import re

import numpy as np
import pytest
from program import TWO_POSITIONS, package, says

package()  # puts it on the path
from rollfem.figures import labels, positions
from rollfem.figures.outline import at_points, contour_lines
from rollfem.figures.panel import Axis, nice_step, tick_text
from rollfem.figures.profiles import on_scale
from rollfem.reader import read_result


def range_of(values, **how):
    axis = Axis(**how)
    axis.see(values)
    return axis.range()


def test_a_scale_does_not_blow_up_a_constant_and_has_round_ticks():
    low, high = range_of([10000.0, 10000.0 + 1e-6, 10000.0 - 1e-6])  # rounding
    assert high - low >= 200 and (low + high) / 2 == pytest.approx(10000, abs=1e-3)
    low, high = range_of([0.0, 1e-17], least=0.5)
    assert 0.5 <= high - low < 0.6
    assert range_of([1.0, 2.0]) == pytest.approx((0.95, 2.05))  # what does differ keeps its scale
    assert [nice_step(8.04, 5), nice_step(1.0, 4), nice_step(0.03, 3)] == [2, 0.5, 0.01]
    assert [tick_text(value, 0.05) for value in (-0.1, 0.0, 0.15)] == ["−0.10", "0", "0.15"]
    assert tick_text(2e-7, 1e-7) == "2·10⁻⁷"
    axis = Axis(log=True)
    axis.see([0.02, 0.0, 3.0])  # 0 is nowhere on it
    assert axis.range() == pytest.approx((0.01, 10.0))
    assert [text for _, text in axis.marks(300, False)] == ["0.01", "0.1", "1", "10"]


def test_contours_are_the_lines_of_the_field():
    x, y = np.linspace(-2, 2, 81), np.linspace(-3, 3, 91)
    ring, = contour_lines(x, y, 1 - x[None, :] ** 2 - (y[:, None] / 2) ** 2, 0.0)
    assert np.allclose(ring[0], ring[-1])  # closed
    a, b = np.transpose(ring)
    assert np.abs(a ** 2 + (b / 2) ** 2 - 1).max() < 2e-3
    assert 0.5 * abs(np.sum(a[:-1] * b[1:] - a[1:] * b[:-1])) == pytest.approx(2 * np.pi, abs=5e-3)
    # Two ends at the border, and a saddle makes two lines that do not cross.
    assert len(contour_lines(x, y, x[None, :] + 0 * y[:, None], 0.3)) == 1
    assert len(contour_lines(x, y, x[None, :] * y[:, None] + 1e-3, 0.0)) == 2
    points = np.array([[0.31, -1.7], [-1.99, 2.99]])
    assert np.allclose(at_points(x, y, 3 * x[None, :] - y[:, None], points), 3 * points[:, 0] - points[:, 1])
    assert np.allclose(on_scale([0, 1e-3, -1e-2, 1e-1]), [0, 0.6, -1.6, 2.6])


def test_labels_have_their_symbols_in_svg_html_and_words():
    label = "coefficient $-F_x/F_z$ at $\\xi$ < 1 %"
    assert labels.plain(label) == "coefficient −Fx/Fz at ξ < 1 %"
    assert labels.html(label) == "coefficient −<i>F</i><sub>x</sub>/<i>F</i><sub>z</sub> at <i>ξ</i> &lt; 1 %"
    assert labels.svg(label).count('class="sub"') == 2 and "&lt;" in labels.svg(label)
    assert labels.plain(labels.math("phi")) == "φ" and labels.plain(labels.math("p_0")) == "p0"


class Tags(html.parser.HTMLParser):
    """Those of a page, with their attributes."""

    def __init__(self, text):
        super().__init__()
        self.all = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.all.append((tag, dict(attributes)))

    def of(self, name):
        return [attributes for tag, attributes in self.all if tag == name]


def test_a_page_is_read_by_ear_and_has_every_patch_of_a_row(rollfem):
    rollfem.done("run", rollfem.case({"models": ["strip", "halfspace"]} | TWO_POSITIONS
                                     | {"wheelset.lateral_shift": [0.0, 1.0, 2.0], "contact_grid.elements_across": 12,
                                        "output.fields": True}), "-o", "out")
    text = rollfem.text("out/report.html")
    tags = Tags(text)
    ids = [attributes["id"] for _, attributes in tags.all if "id" in attributes]
    assert len(ids) == len(set(ids)), "two of one id"
    assert [len(tags.of(mark)) for mark in ("header", "nav", "main", "footer")] == [1, 1, 1, 1]
    assert all(cell.get("scope") in ("row", "col") for cell in tags.of("th"))
    figures = [attributes for _, attributes in tags.all if attributes.get("role") == "img"]
    assert figures and len(figures) == text.count("<figure>")
    assert all(re.search(r"\d", figure["aria-label"]) for figure in figures), "an alternative without a number"
    targets = {link["href"][1:] for link in tags.of("a") if link.get("href", "").startswith("#")}
    assert len(targets) > 4 and targets <= set(ids)
    for need in "prefers-color-scheme:dark", "@media print", "max-width:40rem", "overflow-x:auto":
        assert need in text, need
    picks = [pick["id"] for pick in tags.of("input")]
    assert len(picks) == len(read_result(str(rollfem.work / "out")).scenes()) > 3
    assert sorted(label["for"] for label in tags.of("label")) == sorted(picks), "a patch that cannot be chosen"
    assert [pick["id"] for pick in tags.of("input") if "checked" in pick] == picks[:1]
    for pick in picks:
        assert f"#{pick}:checked~#of-{pick}{{display:block}}" in text and f"of-{pick}" in ids
    row = rollfem.text("out/figures/positions.svg")
    assert "lateral shift of the wheelset [mm]" in row and "nan" not in row.lower()


def test_a_row_of_shifts_has_its_wheelset_in_a_table_and_a_figure(rollfem):
    # A cone of 1:20 that does not roll: its conicity is constant but for rounding, and the wave is Klingel's.
    rollfem.done("run", rollfem.case({
        "models": ["hertz"], "load.vertical_force": 50e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460.0,
        "wheel.profile": "arcs", "wheel_profile.radii": [math.inf], "wheel_profile.ends": [-60.0, 60.0],
        "wheel_profile.slope": -0.05, "rail.profile": "60E1", "track.inclination": "1:20", "wheelset.side": "both",
        "wheelset.lateral_shift": [0.0, 1.0, 2.0], "wheelset.roll": 0.0, "rolling.longitudinal_creepage": 0.001}),
        "-o", "out")
    text = rollfem.text("out/report.html")
    part = text[text.index("Wheelset over lateral shift"):text.index('<h2 id="where-wheel-and-rail-touch"')]
    rows = re.findall(r"<tr><th scope=row>(.*?)</th>(.*?)</tr>", part)
    assert [float(shift.replace("−", "-")) for shift, _ in rows] == [0.0, 1.0, 2.0]
    wave = 2e-3 * math.pi * math.sqrt(1500.0 * 460.0 / (2 * 0.05))  # m
    says(rows[-1][1], "0.05000", f"{wave:.2f}")
    figure = positions.wheelset(read_result(str(rollfem.work / "out")))
    says(figure.seen, "amplitude of 2 mm is 0.05 by the wave and 0.05 by")
    panels = {panel.title: panel for panel in figure.panels}
    low, high = panels["equivalent conicity"].y.range()  # a constant is a straight line
    assert 0.05 <= high - low < 0.06 and (low + high) / 2 == pytest.approx(0.05, abs=1e-5)
    low, high = panels["contact angles"].y.range()
    assert high - low >= 0.5
    for name in "wheelset", "positions":
        drawn = rollfem.text(f"out/figures/{name}.svg")
        assert "[mm]" in drawn and "nan" not in drawn.lower().replace("nance", ""), name
    assert "on the wheel, to the right" in drawn and "width of the patch" in drawn
