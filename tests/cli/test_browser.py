# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports in a real browser, where Chromium is installed: at the width of a phone and of a screen nothing is clipped, no two
words of a figure overlap, the table of the answer shows every wheel without a scroll bar, and the console has no error."""

import browser
import program
import pytest
from program import SMALL, SOURCE

pytestmark = pytest.mark.skipif(browser.CHROMIUM is None, reason="Chromium is not installed")

S1002 = {"title": "free rolling", "models": ["halfspace"], "load.vertical_force": 100e3, "friction.coefficient": 0.35,
         "wheel.rolling_radius": 460.0, "wheel.profile": "S1002", "rail.profile": "60E1", "track.gauge": 1435.0,
         "track.inclination": "1:40", "wheelset.side": "both", "wheelset.lateral_shift": 0.0, "contact_grid.elements_across": 16}
PAGES = {
    "creep curves of four models": SMALL | {"models": ["hertz", "fastsim", "strip", "halfspace"], "contact_grid.elements_across": 16,
                                            "rolling.longitudinal_creepage": [0.0, 0.0005, 0.001, 0.002, 0.004]},
    "both wheels with spin": S1002 | {"wheelset.free_rolling": "torque"},  # long creepages in the titles of narrow patches
    "a lateral sweep": S1002 | {"wheelset.lateral_shift": [0.0, 2.0, 4.0, 6.0], "contact_grid.elements_across": 10}}


@pytest.fixture(scope="module", params=[*PAGES, "a crossing"])
def report(request):
    with program.folder() as made:
        if request.param in PAGES:
            made.done("run", made.case(PAGES[request.param]), "-o", "out")
        else:
            made.done("run", SOURCE / "cases/crossing.toml", "-o", "out", "--set", "contact_grid.elements_across=8", "--set",
                      "placement.track_position=[50.0, 76.0, 80.0, 84.0, 110.0]")
        yield made.work / "out/report.html"


@pytest.mark.parametrize("width", [400, 1400])
def test_nothing_is_clipped_and_no_words_overlap(report, width):
    found = browser.measured(report, width)
    assert found["errors"] == [] and found["clipped"] == [] and found["over"] == []
    assert found["wide"] <= width  # the page itself does not scroll sideways


def test_the_measurement_sees_a_clipped_word_and_two_on_each_other(tmp_path):
    page = tmp_path / "page.html"
    page.write_text('<meta charset=utf-8><svg class=plot width=80 height=40><text x=40 y=20>much wider than that</text>'
                    '<text x=2 y=20>one</text><text x=4 y=21>other</text></svg>', "utf-8")
    found = browser.measured(page, 400)
    assert [words.split(" ")[0] for words in found["clipped"]] == ["much"] and "one | other" in found["over"]
