# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and pages of the Python package: their parts one by one, scales, contours, words, the structure of a page; what
is drawn of a result, whatever it holds; results that are damaged."""

import html.parser
import math
import os
import re
import shutil

import numpy as np
import program
import pytest
from program import SMALL, TOY_PROGRAM, TWO_POSITIONS, package, says

package()  # puts it on the path
from rollfem.figures import curves, labels, load_points, maps, page, positions
from rollfem.figures.maps import at_points, contour_lines
from rollfem.figures.figure import Axis, Panel, broken, nice_step, tick_text
from rollfem.figures.profiles import on_scale
from rollfem.reader import read_result
from rollfem.stresses import stress_measures


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


def test_words_that_do_not_fit_are_broken_outside_symbols_and_never_cut():
    assert broken("along the track", 1000) == ["along the track"]
    rows = broken("largest pressure $p_0$ at $x$ = 0 [MPa]", 110)
    assert len(rows) > 1 and " ".join(rows) == "largest pressure $p_0$ at $x$ = 0 [MPa]"
    assert all(row.count("$") % 2 == 0 for row in rows)
    panel = Panel(60, 60, "a title much wider than its narrow field, unbreakablewordthatislong")
    wide, _, content = panel.svg()
    assert wide > labels.width("unbreakablewordthatislong") and content.count('class="t"') > 1


def test_markers_at_the_end_of_an_axis_with_one_given_limit_are_not_cut():
    axis = Axis()
    axis.limits = (0.0, None)
    axis.see([80.047, 80.048])
    assert axis.range()[0] == 0.0 and axis.range()[1] > 80.048 * 1.04


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
    part = text[text.index('<h2 id="wheelset-over-lateral-shift"'):text.index('<h2 id="where-wheel-and-rail-touch"')]
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


TITLE = "<b>markup</b> & \"quotes\""
CREEPAGES = [0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]
SOLVED = {"title": TITLE, "models": ["hertz", "strip", "halfspace"]} | SMALL | {
    "rolling.longitudinal_creepage": CREEPAGES, "contact_grid.elements_across": 16, "output.stress_maxima": True,
    "subsurface.line": [{"from": [0, 0, 0.5], "to": [0, 0, 6], "points": 5}],
    "subsurface.plane": [{"from": [-4, 0, 1], "to": [4, 0, 1], "across": [-4, 0, 5], "points": [5, 5]}],
    "subsurface.surface": [{"body": "rail", "from": [0, -5], "to": [0, 5], "points": 5}]}


@pytest.fixture(scope="module")
def solved():
    """A folder with a result, of which every test reads its own."""
    with program.folder() as made:
        made.done("run", made.case(SOLVED), "-o", "out")
        yield made


def drawn(result, folder):
    """The names of the figures of a result, which the test has changed, and its report."""
    figures = page.draw(result, str(folder))
    return {name.removesuffix(".svg") for name in figures.figures}, (folder / "report.html").read_text("utf-8")


def test_all_are_drawn_and_the_report_holds_them_without_the_network(solved):
    figures = {path.stem: path.read_text("utf-8") for path in (solved.work / "out/figures").iterdir()}
    assert figures.keys() >= {"creep_curve", "path_x", "path_y", "path_lateral", "outlines", "contact_area", "strip_force",
                              "pressure_map_strip", "pressure_map_halfspace", "pressure_map_hertz", "stress_1", "stress_3"}
    # A frictionless model has no tangential tractions to draw, but a pressure; a plane is no line.
    assert "tangential" not in figures["pressure_map_hertz"] and "tangential" in figures["pressure_map_strip"]
    assert "stress_2" not in figures
    assert all("</svg>" in text and len(text) < 1500000 for text in figures.values())
    text = solved.text("out/report.html")
    assert [link for link in ("http:", "https:", 'src="/', "<script", "@import", "url(", "<img") if link in text] == []
    assert text.count("<figure>") == text.count('role="img" aria-label=') == len(figures)
    says(text, "name=viewport", "@media print", "normal_force = 50000.0", "&lt;b&gt;markup",
         "<th scope=row>largest pressure p<sub>0</sub> [MPa]", "<th scope=col>−F<sub>x</sub>/F<sub>z</sub></th>",
         "<th scope=col>|p<sub>t</sub>| [MPa]</th>", "<th scope=row>contact area [mm²]")
    assert "not converged" not in text.lower() and "<b>markup" not in text


def test_stress_along_lines_is_drawn_and_the_largest_is_tabulated(solved):
    points = {model["name"]: model["points"] for model in solved.models("out")}["halfspace"]
    value, creepage = max((each["value"], point["longitudinal_creepage"]) for point in points
                          for each in point["stress_maxima"] if (each["body"], each["measure"]) == ("wheel", "von_mises"))
    text = solved.text("out/report.html")
    says(text, "Stress in the bodies", "wheel: von Mises", "rail: Tresca", "On the surface of the rail")
    row = text.partition("wheel: von Mises [MPa]")[2].partition("</tr>")[0]
    assert float(re.search(r"<td>([\d.]+)", row)[1]) == pytest.approx(value, rel=1e-3)
    says(row, f"mm, ξ = {100 * creepage:g} %")
    # The measures of the figures are those of the result.
    part = read_result(str(solved.work / "out"))["halfspace"].points[4].subsurface[0]
    assert np.allclose(stress_measures(part["stress"])["von_mises"], part["von_mises"])


def test_hertz_alone_has_no_creep_curve_and_breaks_nothing(solved, tmp_path):
    result = read_result(str(solved.work / "out"))
    result.models = result.models[:1]
    names, text = drawn(result, tmp_path)
    assert {"path_x", "outlines"} <= names and not names & {"creep_curve", "path_lateral", "contact_area"}
    assert "Traction coefficient" not in text


@pytest.mark.parametrize("count", [2, 1, 0, None])
def test_points_without_fields_and_models_without_points_break_nothing(solved, tmp_path, count):
    result = read_result(str(solved.work / "out"))
    result.models = [] if count is None else [result["halfspace"]]
    for model in result.models:
        model.points = model.points[:count]
        for point in model.points:
            point.fields, point.subsurface = {}, []
    assert drawn(result, tmp_path)


def test_a_measured_curve_lies_over_the_creep_curve(solved, rollfem):
    table = rollfem.file("measured.csv", "# twin disc, dry\ncreepage [%],traction coefficient,bar\n0.1,0.11,0.01\n0.4,0.25,0.02\n")
    shutil.copytree(solved.work / "out", rollfem.work / "out")
    rollfem.done("report", "out", "--overlay", table)
    says(rollfem.text("out/figures/creep_curve.svg"), "twin disc, dry", "twin disc, dry 0.11 to 0.25")
    says(rollfem.text("out/report.html"), "twin disc, dry")
    name, values = curves.read_overlay(table)
    assert name == "twin disc, dry" and values.tolist() == [pytest.approx([0.001, 0.11, 0.01]), pytest.approx([0.004, 0.25, 0.02])]
    rollfem.refuses("report", "out", "--overlay", rollfem.file("words.csv", "creepage,value\nhigh,low\n"), says="is no table of numbers")


def test_a_model_that_did_not_converge_is_named(solved, tmp_path):
    result = read_result(str(solved.work / "out"))
    result["halfspace"].points[3].scalars["converged"] = False
    says(drawn(result, tmp_path)[1], "half-space at ξ = 0.2 %")


def test_lateral_creepage_spin_and_an_unknown_model_are_drawn(rollfem):
    file = rollfem.case(SMALL | {"rolling.lateral_creepage": CREEPAGES, "rolling.spin": 1e-4,
                                 "contact_grid.elements_across": 10})
    rollfem.done("run", file, "-m", "stiff", "-o", "out", "--no-report", program=TOY_PROGRAM)
    rollfem.done("report", "out")
    assert rollfem.holds("out/figures/creep_curve.svg")
    says(rollfem.text("out/report.html"), "Lateral force", "stiff half-space")


def test_lines_go_through_the_largest_pressure_and_maps_have_room_for_it(rollfem):
    """A patch that lies 8 mm beside the contact point, as between tread and flange."""
    rollfem.file("beside.csv", "".join(f"{x} {y} {x * x / 400 + (y - 8) ** 2 / 1000}\n"
                                       for y in range(-20, 36) for x in range(-20, 21)))
    rollfem.done("run", rollfem.case({
        "models": ["halfspace"], "load.normal_force": 50e3, "friction.coefficient": 0.3,
        "undeformed_distance.file": "beside.csv", "rolling.longitudinal_creepage": 0.001,
        "contact_grid.cell_size": [0.5, 0.5], "contact_grid.extent": [20.0, 40.0]}), "-o", "out", "--no-report")
    result = read_result(str(rollfem.work / "out"))
    models = load_points.with_pressure(result)
    at = curves.line_place(models, "x")
    assert at == pytest.approx(8, abs=models[0].dy) and curves.line_place(models, "y") == pytest.approx(0, abs=models[0].dx)
    model, = models
    pressure = model.points[0].fields["pressure"]
    assert np.nanmax(curves.line_of("x", at)(model, model.points[0], "pressure")[1]) > 0.98 * pressure.max()
    assert model.line(pressure, "x").max() < 0.9 * pressure.max()
    assert re.search(r'at <tspan class="it">y</tspan> = [78]', curves.path(result, "x").svg())
    panel = maps.pressure(result, model).panels[0]
    assert panel.y.limits[1] > model.y[(pressure > 0).any(axis=1)].max() > 8


def test_a_falling_law_is_drawn_with_initial_slope_and_peak_of_the_creep_curve(rollfem, tmp_path):
    """The rise is Vermeulen and Johnson's with the slope 0.55 * 300, the summit a parabola's."""
    rollfem.done("run", rollfem.case({"models": ["halfspace"]} | SMALL | {
        "friction.law": "exponential", "friction.kinetic_coefficient": 0.2, "friction.half_velocity": 1000.0,
        "friction.memory_distance": 0.003, "rolling.speed": 10e3, "rolling.longitudinal_creepage": CREEPAGES,
        "contact_grid.elements_across": 10}), "-o", "out", "--no-report")
    result = read_result(str(rollfem.work / "out"))
    assert np.allclose(np.interp([0, 1000, 1e9], *result.friction_law.T), [0.55, 0.375, 0.2], rtol=1e-12)
    for point in result.models[0].points:
        xi = point["longitudinal_creepage"]
        tau = 300 * xi
        point.scalars["traction_coefficient"] = (
            0.55 * (tau - tau**2 / 3 + tau**3 / 27) if xi < 0.0025 else 0.5 - 2000 * (xi - 0.0042) ** 2)
        point.scalars["longitudinal_force"] = -point["traction_coefficient"] * point["normal_force"]
    _, text = drawn(result, tmp_path)
    says((tmp_path / "figures/friction_law.svg").read_text("utf-8"), "at rest: 0.55", "kinetic: 0.2", "memory: 3 µm")
    says((tmp_path / "figures/creep_curve.svg").read_text("utf-8"), "0.5 at 0.42 %")
    says(text, "0.55 at rest, falling (exponential) by 0.35 to 0.2", "memory 0.003 mm",
         "<td>165</td><td>0.500</td><td>90.9 %</td><td>0.420</td>")


def test_a_file_cut_short_is_recognised_and_said(rollfem):
    rollfem.done("run", rollfem.case(SMALL), "-m", "halfspace", "-o", "out", "--no-report")
    file = rollfem.work / "out/results.h5"
    os.truncate(file, file.stat().st_size // 2)
    outcome = rollfem.call("report", "out")
    assert outcome.status == 2 and outcome.err.count("\n") == 1, outcome
    says(outcome.err, "is truncated or damaged", "run the case again")
    file.unlink()
    rollfem.refuses("report", "out", says="out holds no result")
