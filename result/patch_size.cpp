// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/patch_size.hpp"

#include "result/result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::contact {

namespace {

/// Pressures along one line of elements, positions in elements.
using Line = std::vector<double>;

/// Memory that is used again.
struct PatchLines {
  Line line, squares, backwards, last, minus_first, last_roots, first_roots;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance of an edge beyond the centre of the last element, and its error, in elements.
struct Edge {
  double at = 0.5;
  double unsure = 0.5;
  double root = 0.0;  ///< that gave `at` by edge_of_solution; 0 where another rule gave it
};

/// Ends of the contact along one line: the outermost edges and the covered length.
struct Chord {
  bool any = false;
  Edge first{};  ///< at: from the middle of element 0
  Edge last{};
  double covered = 0.0;
};

/// Largest number of elements of a parabola.
constexpr int most_for_parabola = 12;

/// The first root, from the edge element outwards, of the least-squares parabola through p^2 of the
/// elements `first` to `first` + count - 1, counted inwards; none where p^2 does not fall towards
/// the edge.
std::optional<double> root_of_parabola(const Line& inward, int first, int count) {
  // By polynomials that are orthogonal on the elements: 1, s and s^2 - spread.
  const double middle = first + 0.5 * (count - 1), spread = (count * count - 1.0) / 12.0;
  double mean = 0.0, slope = 0.0, bend = 0.0, slopes = 0.0, bends = 0.0;
  for (int k = first; k < first + count; ++k) {
    const double s = middle - k, q = s * s - spread, value = inward[static_cast<std::size_t>(k)];
    mean += value / count;
    slope += s * value;
    bend += q * value;
    slopes += s * s;
    bends += q * q;
  }
  slope /= slopes;
  bend /= bends;
  const double c[] = {mean + slope * middle + bend * (middle * middle - spread),
                      slope + 2.0 * bend * middle, bend};
  const double discriminant = c[1] * c[1] - 4.0 * c[0] * c[2];
  if (discriminant < 0.0 || c[1] - 2.0 * c[2] > 0.0) return {};
  const double root = 2.0 * c[0] / (-c[1] + std::sqrt(discriminant));
  if (!std::isfinite(root)) return {};
  return root;
}

/// Position of the edge when the parabola through the last three elements ends at `root`. A contact
/// solved with elements of constant pressure has p^2 = 0 until the true edge is 0.17 of an element
/// behind the centre of the last one; beyond that the root moves smoothly with the edge. Fitted to
/// Hertz's line contact on 240 elements, with the edge at 160 positions in an element, within 2e-4.
/// The same holds for h = A x^4 + B x^2 and for finite elements within the error of the third
/// element.
double edge_of_solution(double root) {
  const double s = std::sqrt(root);
  return -0.17437 + s * (0.98287 + s * (0.68687 + s * (-0.68403 + s * (-0.22103 + s * 0.22967))));
}

/// The same for the parabola through the second to the fourth element: its end if p^2 is a
/// parabola.
double second_root(double root) {
  const double s = std::sqrt(root);
  return edge_of_solution(root) +
         (0.19810 + s * (-0.31719 + s * (-0.11603 + s * (0.55610 - 0.27475 * s))));
}

/// Error of edge_of_solution for h = A x^4 + B x^2, divided by the error of second_root: up to 0.1
/// with 12 to 24 elements across, 0.12 to 0.2 with 40 to 80.
constexpr double unsure_share = 0.1;

/// Distance of the edge beyond the centre of the last element of a run, in elements: `inward[k]` is
/// p^2 of the element k positions inside the edge element. Deeper than three elements, p^2 is a
/// parabola only for ellipsoids; where that parabola and the one of the last three elements end at
/// the same point, the pressure is a smooth function sampled at the centres, not a contact
/// solution.
Edge edge_beyond(const Line& inward) {
  constexpr double same_place = 0.02, farthest = 2.0, largest_of_solutions = 0.91;
  const int available = static_cast<int>(inward.size());
  if (available < elements_for_edge) return {};
  const std::optional<double> outer = root_of_parabola(inward, 0, 3);
  if (!outer || *outer > farthest) return {};
  const int skipped = available < 12 ? 1 : 2;
  const std::optional<double> inner = root_of_parabola(
      inward, skipped,
      std::clamp(available / 3, 3, std::min(most_for_parabola, available - skipped)));
  if (inner && std::abs(*inner - *outer) < same_place) return {*inner, same_place};
  const double root = std::clamp(*outer, 0.0, largest_of_solutions);
  const std::optional<double> second = root_of_parabola(inward, 1, 3);
  const double beside = second ? std::abs(*second - second_root(root)) : 1.0;
  return {edge_of_solution(root), unsure_share * beside + std::abs(*outer - root), root};
}

Chord chord_of(PatchLines& lists) {
  const Line& pressure = lists.line;
  Chord chord;
  const int n = static_cast<int>(pressure.size());
  for (int begin = 0; begin < n; ++begin) {
    if (!(pressure[static_cast<std::size_t>(begin)] > 0.0)) continue;
    int end = begin;
    Line& squares = lists.squares;
    squares.clear();
    for (; end < n && pressure[static_cast<std::size_t>(end)] > 0.0; ++end)
      squares.push_back(pressure[static_cast<std::size_t>(end)] *
                        pressure[static_cast<std::size_t>(end)]);
    Edge first = edge_beyond(squares);
    first.at = begin - first.at;
    lists.backwards.assign(squares.rbegin(), squares.rend());
    Edge last = edge_beyond(lists.backwards);
    last.at += end - 1;
    if (!chord.any) chord.first = first;
    chord.last = last;
    chord.covered += std::max(0.0, last.at - first.at);
    chord.any = true;
    begin = end;
  }
  return chord;
}

/// Curvature of the edges at line `top`, per element: from the lines an element's length to both
/// sides, or the last ones with an edge. `slenderness`: length of an element, which lies along the
/// line, over its width.
double curvature_at(const Line& edges, int top, double slenderness) {
  const int count = static_cast<int>(edges.size());
  double sum = 0.0;
  int sides = 0;
  for (const int side : {-1, 1}) {
    int lines = std::max(1, static_cast<int>(std::lround(std::min(slenderness, 1.0 * count))));
    const auto there = [&] {
      const int line = top + side * lines;
      return line >= 0 && line < count ? edges[static_cast<std::size_t>(line)] : -infinity;
    };
    while (lines > 1 && there() == -infinity) --lines;
    if (there() == -infinity) continue;
    sum +=
        2.0 * (edges[static_cast<std::size_t>(top)] - there()) * std::pow(slenderness / lines, 2);
    ++sides;
  }
  return sides > 0 ? sum / sides : 0.0;
}

/// What edge_of_solution leaves out where the outline of the patch is curved. Along an outline that
/// turns within an element's length, elements carry pressure like the springs of a Winkler
/// foundation, and the edge follows the root itself. Fitted to Hertz's ellipses of axis ratios 1:40
/// to 40:1 on 12 to 80 elements anywhere on the grid: the error of a semi-axis falls from 0.006 to
/// 0.003 (round) and from 0.05 to 0.007 of an element (1:40), rms.
double beside_straight_edge(double root, double curvature) {
  constexpr double size = 0.211, saturation = 0.36, middle = 0.354, shift = 0.112, ramp = 0.12;
  const double w = std::sqrt(std::max(0.0, curvature));
  const double bend = w / (1.0 + saturation * w);
  return size * bend * (root - middle - shift * bend) * std::min(1.0, root / ramp);
}

/// The outermost edge, at the vertex of the parabola through the largest and its neighbours: the
/// outermost point of the patch usually lies between two lines. Adds to `edges` what their
/// curvature adds.
double outermost_between_lines(Line& edges, const Line& roots, double slenderness) {
  const auto largest = std::max_element(edges.begin(), edges.end());
  const int top = static_cast<int>(largest - edges.begin());
  const double curvature = curvature_at(edges, top, slenderness);
  const std::size_t first = static_cast<std::size_t>(std::max(0, top - 2));
  for (std::size_t k = first; k < std::min(edges.size(), first + 5); ++k)
    edges[k] += beside_straight_edge(roots[k], curvature);
  const auto at = std::max_element(edges.begin(), edges.end());
  const double peak = *at;
  if (at == edges.begin() || at + 1 == edges.end()) return peak;
  const double before = *(at - 1);
  const double after = *(at + 1);
  const double bend = before - 2.0 * peak + after;
  if (!std::isfinite(bend) || bend >= 0.0) return peak;
  const double slope = 0.5 * (after - before);
  return peak - 0.5 * slope * slope / bend;
}

struct Extent {
  double first = 0.0;    ///< in elements, from the middle of element 0
  double last = 0.0;     ///< in elements
  double covered = 0.0;  ///< in elements, summed over the lines
  double unsure = 0.0;   ///< in elements, of last - first
};

/// For `count` lines of `length` elements; `value(line, element)`.
template <class Value>
Extent extent_of(int count, int length, double slenderness, PatchLines& lists, Value&& value) {
  constexpr double nowhere = -infinity;
  Line& last = lists.last;
  Line& minus_first = lists.minus_first;
  for (Line* list : {&last, &minus_first, &lists.last_roots, &lists.first_roots}) list->clear();
  Extent extent;
  bool any = false;
  Edge outermost_first{nowhere, 0.0}, outermost_last{nowhere, 0.0};
  for (int line = 0; line < count; ++line) {
    lists.line.clear();
    for (int k = 0; k < length; ++k) lists.line.push_back(value(line, k));
    const Chord chord = chord_of(lists);
    last.push_back(chord.any ? chord.last.at : nowhere);
    minus_first.push_back(chord.any ? -chord.first.at : nowhere);
    lists.last_roots.push_back(chord.last.root);
    lists.first_roots.push_back(chord.first.root);
    extent.covered += chord.covered;
    any = any || chord.any;
    if (last.back() > outermost_last.at) outermost_last = chord.last;
    if (minus_first.back() > outermost_first.at)
      outermost_first = {minus_first.back(), chord.first.unsure};
  }
  extent.unsure = std::hypot(outermost_first.unsure, outermost_last.unsure);
  if (any) {
    extent.first = -outermost_between_lines(minus_first, lists.first_roots, slenderness);
    extent.last = outermost_between_lines(last, lists.last_roots, slenderness);
  }
  return extent;
}

}  // namespace

PatchSize patch_size(const ContactGrid& grid, const Field& pressure) {
  thread_local PatchLines lists;
  for (Line* list : {&lists.line, &lists.squares, &lists.backwards, &lists.last, &lists.minus_first,
                     &lists.last_roots, &lists.first_roots})
    list->reserve(static_cast<std::size_t>(std::max(grid.nx, grid.ny)));
  const Extent along_x = extent_of(grid.ny, grid.nx, grid.dx / grid.dy, lists,
                                   [&](int j, int i) { return pressure[grid.index(i, j)]; });
  const Extent along_y = extent_of(grid.nx, grid.ny, grid.dy / grid.dx, lists,
                                   [&](int i, int j) { return pressure[grid.index(i, j)]; });
  PatchSize size;
  size.length = (along_x.last - along_x.first) * grid.dx;
  size.width = (along_y.last - along_y.first) * grid.dy;
  size.length_unsure = along_x.unsure * grid.dx;
  size.width_unsure = along_y.unsure * grid.dy;
  size.x_lower = grid.x_first + along_x.first * grid.dx;
  size.x_upper = grid.x_first + along_x.last * grid.dx;
  size.y_lower = grid.y_first + along_y.first * grid.dy;
  size.y_upper = grid.y_first + along_y.last * grid.dy;
  size.area = 0.5 * (along_x.covered + along_y.covered) * grid.element_area();
  if (grid.is_line()) {
    size.width_unsure = 0.0;
    size.area = along_x.covered * grid.element_area();
  }
  return size;
}

bool touches_border(const ContactGrid& grid, const Field& pressure) {
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const bool end = !grid.is_line() && (j == 0 || j == grid.ny - 1);
      const bool border = end || i == 0 || i == grid.nx - 1;
      if (border && pressure[grid.index(i, j)] > 0.0) return true;
    }
  return false;
}

namespace {

/// Number of the region of each element from 1, 0 outside; and how many there are.
std::pair<std::vector<int>, int> labelled(const ContactGrid& grid, const Field& pressure) {
  std::vector<int> label(static_cast<std::size_t>(grid.size()), 0);
  std::vector<std::array<int, 2>> open;
  int count = 0;
  const auto take = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= grid.nx || j >= grid.ny) return;
    const int k = grid.index(i, j);
    int& here = label[static_cast<std::size_t>(k)];
    if (here != 0 || !(pressure[k] > 0.0)) return;
    here = count;
    open.push_back({i, j});
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (label[static_cast<std::size_t>(k)] != 0 || !(pressure[k] > 0.0)) continue;
      ++count;
      take(i, j);
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u) take(x + u, y + v);
      }
    }
  return {std::move(label), count};
}

double sum_over(const Field& values, const Field& mask) {
  return values.size() == mask.size() ? values.dot(mask) : 0.0;
}

}  // namespace

int count_parts(const ContactGrid& grid, const Field& pressure) {
  return labelled(grid, pressure).second;
}

std::vector<PatchPart> patch_parts(const ContactGrid& grid, const ContactFields& fields) {
  const SurfaceField& traction = fields.traction;
  if (traction.n.size() != grid.size()) return {};
  const auto [label, count] = labelled(grid, traction.n);
  const Field x = grid.sample([](double at, double) { return at; });
  const Field y = grid.sample([](double, double at) { return at; });
  std::vector<PatchPart> parts;
  for (int number = 1; number <= count; ++number) {
    Field mask = Field::Zero(grid.size());
    for (int k = 0; k < grid.size(); ++k)
      if (label[static_cast<std::size_t>(k)] == number) mask[k] = 1.0;
    const Field pressure = traction.n.cwiseProduct(mask);
    const PatchSize size = patch_size(grid, pressure);
    const double sum = pressure.sum();
    PatchPart part;
    part.x = x.dot(pressure) / sum;
    part.y = y.dot(pressure) / sum;
    part.length = size.length;
    part.width = size.width;
    part.normal_force = grid.element_area() * sum;
    part.longitudinal_force = grid.element_area() * sum_over(traction.x, mask);
    part.lateral_force = grid.element_area() * sum_over(traction.y, mask);
    part.max_pressure = pressure.maxCoeff();
    parts.push_back(part);
  }
  std::stable_sort(parts.begin(), parts.end(), [](const PatchPart& a, const PatchPart& b) {
    return a.normal_force > b.normal_force;
  });
  return parts;
}

}  // namespace rollfem::contact
