// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of figures and pages, tested one by one in Debian's Python: scales, contours, words, the
// structure of a page.
#include "support/drawn_pages.hpp"
#include "support/output_placed_run.hpp"

namespace rollfem::postprocess {
namespace {

class PartsTest : public DrawnPages {};

TEST_F(PartsTest, AScaleDoesNotBlowUpAConstantAndHasRoundTicks) {
  EXPECT_EQ(said(R"(
from rollfem.figures.panel import Axis, nice_step, tick_text
axis = Axis()
axis.see([10000.0, 10000.0 + 1e-6, 10000.0 - 1e-6])      # rounding
low, high = axis.range()
assert high - low >= 200 and low < 10000 < high, (low, high)
assert abs((low + high) / 2 - 10000) < 1e-3
axis = Axis(least=0.5)
axis.see([0.0, 1e-17])
low, high = axis.range()
assert 0.5 <= high - low < 0.6
axis = Axis()                                             # what does differ keeps its scale
axis.see([1.0, 2.0])
assert np.allclose(axis.range(), (0.95, 2.05))
assert nice_step(8.04, 5) == 2 and nice_step(1.0, 4) == 0.5 and nice_step(0.03, 3) == 0.01
assert [tick_text(v, 0.05) for v in (-0.1, 0.0, 0.15)] == ['−0.10', '0', '0.15']
assert tick_text(2e-7, 1e-7) == '2·10⁻⁷'
axis = Axis(log=True)
axis.see([0.02, 0.0, 3.0])                                # 0 is nowhere on it
assert np.allclose(axis.range(), (0.01, 10.0)) and [t for _, t in axis.marks(300, False)] == ['0.01', '0.1', '1', '10']
)"),
            "");
}

TEST_F(PartsTest, ContoursAreTheLinesOfTheField) {
  EXPECT_EQ(said(R"(
from rollfem.figures.outline import at_points, contour_lines
from rollfem.figures.profiles import on_scale
x, y = np.linspace(-2, 2, 81), np.linspace(-3, 3, 91)
rings = contour_lines(x, y, 1 - x[None, :] ** 2 - (y[:, None] / 2) ** 2, 0.0)
assert len(rings) == 1 and np.allclose(rings[0][0], rings[0][-1])   # closed
a, b = rings[0].T
assert np.abs(a ** 2 + (b / 2) ** 2 - 1).max() < 2e-3
area = 0.5 * abs(np.sum(a[:-1] * b[1:] - a[1:] * b[:-1]))
assert abs(area - 2 * np.pi) < 5e-3
# Two ends at the border, and a saddle makes two lines that do not cross.
assert len(contour_lines(x, y, x[None, :] + 0 * y[:, None], 0.3)) == 1
assert len(contour_lines(x, y, x[None, :] * y[:, None] + 1e-3, 0.0)) == 2
points = np.array([[0.31, -1.7], [-1.99, 2.99]])
assert np.allclose(at_points(x, y, 3 * x[None, :] - y[:, None], points), 3 * points[:, 0] - points[:, 1])
assert np.allclose(on_scale([0, 1e-3, -1e-2, 1e-1]), [0, 0.6, -1.6, 2.6])
)"),
            "");
}

TEST_F(PartsTest, LabelsHaveTheirSymbolsInSvgHtmlAndWords) {
  EXPECT_EQ(said(R"(
from rollfem.figures import labels
label = 'coefficient $-F_x/F_z$ at $\\xi$ < 1 %'
assert labels.plain(label) == 'coefficient −Fx/Fz at ξ < 1 %', labels.plain(label)
assert labels.html(label) == 'coefficient −<i>F</i><sub>x</sub>/<i>F</i><sub>z</sub> at <i>ξ</i> &lt; 1 %'
assert labels.svg(label).count('class="sub"') == 2 and '&lt;' in labels.svg(label)
assert labels.plain(labels.math('phi')) == 'φ' and labels.plain(labels.math('p_0')) == 'p0'
)"),
            "");
}

TEST_F(PartsTest, APageIsReadByEarAndHasEveryPatchOfARow) {
  const std::string folder = draw(placed_run(3)).string();
  EXPECT_EQ(said(R"(
import re
from html.parser import HTMLParser
from rollfem.reader import read_result
text = open(sys.argv[1] + '/report.html', encoding='utf-8').read()
tags = []
class Reader(HTMLParser):
    def handle_starttag(self, tag, attributes):
        tags.append((tag, dict(attributes)))
Reader().feed(text)
ids = [a['id'] for _, a in tags if 'id' in a]
assert len(ids) == len(set(ids)), 'two of one id'
for mark in ('header', 'nav', 'main', 'footer'):
    assert sum(tag == mark for tag, _ in tags) == 1, mark
assert all(a.get('scope') in ('row', 'col') for tag, a in tags if tag == 'th')
figures = [a for _, a in tags if a.get('role') == 'img']
assert figures and len(figures) == text.count('<figure>')
assert all(re.search(r'\d', a['aria-label']) for a in figures), 'an alternative without a number'
targets = [a['href'][1:] for tag, a in tags if tag == 'a' and a.get('href', '').startswith('#')]
assert len(targets) > 4 and set(targets) <= set(ids), set(targets) - set(ids)
for need in ('prefers-color-scheme:dark', '@media print', 'max-width:40rem', 'overflow-x:auto'):
    assert need in text, need
scenes = read_result(sys.argv[1]).scenes()
picks = [a for tag, a in tags if tag == 'input']
labels = [a['for'] for tag, a in tags if tag == 'label']
assert len(picks) == len(scenes) > 3
assert sorted(labels) == sorted(a['id'] for a in picks), 'a patch that cannot be chosen'
assert [a['id'] for a in picks if 'checked' in a] == [picks[0]['id']]
for a in picks:
    assert '#' + a['id'] + ':checked~#of-' + a['id'] + '{display:block}' in text
    assert 'of-' + a['id'] in ids
row = open(sys.argv[1] + '/figures/positions.svg', encoding='utf-8').read()
assert 'lateral shift of the wheelset [mm]' in row and 'NaN' not in row and 'nan' not in row
)",
                 folder),
            "");
}

/// A cone of 1:20 at each position of a row, and every 0.1 mm between.
RunRecord with_cones(RunRecord run) {
  const auto at = [](double shift) {
    RigidWheelset cone{shift, 0.0, 460.0 - 0.05 * shift, 460.0 + 0.05 * shift, 0.05, 0.05, 0, 0};
    if (shift != 0.0) {
      cone.conicity_harmonic = 0.05;
      cone.conicity_wave = 0.05 + 1e-12;  // rounding
      cone.wave_length = 16504.0;
    }
    return cone;
  };
  run.input.wheelset.lateral_shift = {0.0, 1.0, 2.0};
  run.input.wheelset.yaw = {0.0, 0.0, 0.0};
  for (const double shift : run.input.wheelset.lateral_shift) run.wheelset.push_back(at(shift));
  for (int k = 0; k <= 20; ++k) run.rigid_row.push_back(at(0.1 * k));
  return run;
}

TEST_F(PartsTest, ARowOfShiftsHasItsWheelsetInATableAndAFigure) {
  const std::string folder = draw(with_cones(placed_run(3))).string();
  EXPECT_EQ(said(R"(
import csv, re
text = open(sys.argv[1] + '/report.html', encoding='utf-8').read()
part = text[text.index('Wheelset over lateral shift'):text.index('<h2 id="where-wheel-and-rail-touch"')]
rows = re.findall(r'<tr><th scope=row>(.*?)</th>(.*?)</tr>', part)
at = sorted({float(r['lateral_shift [mm]']) for r in csv.DictReader(open(sys.argv[1] + '/wheelset.csv'))})
assert [float(shift.replace('−', '-')) for shift, _ in rows] == at, rows
assert '0.05000' in rows[-1][1] and '16.50' in rows[-1][1], rows
from rollfem.figures import positions
from rollfem.reader import read_result
result = read_result(sys.argv[1])
figure = positions.wheelset(result)
assert 'amplitude of 2 mm is 0.05 by the wave and 0.05 by' in figure.seen, figure.seen
names = {panel.title: panel for panel in figure.panels}
low, high = names['equivalent conicity'].y.range()          # a constant is a straight line
assert 0.05 <= high - low < 0.06 and abs((low + high) / 2 - 0.05) < 1e-6, (low, high)
low, high = names['contact angles'].y.range()
assert high - low >= 0.5
for name in ('wheelset', 'positions'):
    drawn = open(f'{sys.argv[1]}/figures/{name}.svg', encoding='utf-8').read()
    assert '[mm]' in drawn and 'nan' not in drawn.lower().replace('nance', ''), name
assert 'on the wheel, to the right' in drawn and 'width of the patch' in drawn
)",
                 folder),
            "");
}

}  // namespace
}  // namespace rollfem::postprocess
