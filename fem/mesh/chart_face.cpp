// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/chart_face.hpp"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace rollfem::fem {

namespace {

using Corner = dealii::Point<2>;
using Polygon = std::vector<Corner>;

double cross(const dealii::Tensor<1, 2>& a, const dealii::Tensor<1, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Interval range(const std::array<Corner, 4>& corners, unsigned int axis) {
  Interval result{corners[0][axis], corners[0][axis]};
  for (const auto& corner : corners) {
    result.lower = std::min(result.lower, corner[axis]);
    result.upper = std::max(result.upper, corner[axis]);
  }
  return result;
}

/// Keeps the part of the polygon where sign * (p[axis] - bound) >= 0 (Sutherland and Hodgman).
Polygon clipped(const Polygon& polygon, unsigned int axis, double bound, double sign) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner& here = polygon[k];
    const Corner& next = polygon[(k + 1) % polygon.size()];
    const double a = sign * (here[axis] - bound);
    const double b = sign * (next[axis] - bound);
    if (a >= 0) kept.push_back(here);
    if ((a < 0) != (b < 0)) kept.push_back(here + a / (a - b) * (next - here));
  }
  return kept;
}

}  // namespace

ChartFace::ChartFace(const std::array<dealii::Point<2>, 4>& corners)
    : corners_(corners), s_(range(corners, 0)), t_(range(corners, 1)) {
  const double small = 1e-9 * (s_.length() + t_.length());
  const auto along = [&](unsigned int from, unsigned int to) {
    const auto side = corners_[to] - corners_[from];
    return std::abs(side[0]) < small || std::abs(side[1]) < small;
  };
  rectangle_ = along(0, 1) && along(2, 3) && along(0, 2) && along(1, 3);
  constexpr unsigned int around[4] = {0, 1, 3, 2};
  int turns = 0;
  for (unsigned int k = 0; k < 4; ++k) {
    const auto& before = corners_[around[(k + 3) % 4]];
    const auto& here = corners_[around[k]];
    const auto& after = corners_[around[(k + 1) % 4]];
    const double turn = cross(here - before, after - here);
    if (std::abs(turn) > small * small) turns += turn > 0 ? 1 : -1;
  }
  convex_ = std::abs(turns) == 4;
}

dealii::Point<2> ChartFace::reference(const dealii::Point<2>& chart) const {
  const auto a = corners_[1] - corners_[0];
  const auto b = corners_[2] - corners_[0];
  const auto twist = corners_[3] - corners_[2] - corners_[1] + corners_[0];
  dealii::Point<2> at(0.5, 0.5);
  for (int step = 0; step < 20; ++step) {
    const auto miss = chart - corners_[0] - at[0] * a - at[1] * b - at[0] * at[1] * twist;
    const auto along_first = a + at[1] * twist;
    const auto along_second = b + at[0] * twist;
    const double area = cross(along_first, along_second);
    const dealii::Point<2> change(cross(miss, along_second) / area,
                                  cross(along_first, miss) / area);
    at += change;
    if (change.square() < 1e-30) break;
  }
  return at;
}

double ChartFace::rectangle_overlap(const Interval& s, const Interval& t, unsigned int points,
                                    std::vector<FacePoint>& rule) const {
  const dealii::QGauss<2> gauss(points);
  const double area = s.length() * t.length();
  for (unsigned int q = 0; q < gauss.size(); ++q) {
    const dealii::Point<2> at(s.lower + gauss.point(q)[0] * s.length(),
                              t.lower + gauss.point(q)[1] * t.length());
    rule.push_back({at[0], at[1], reference(at), gauss.weight(q) * area});
  }
  return area;
}

double ChartFace::overlap(const Interval& s, const Interval& t, unsigned int points,
                          std::vector<FacePoint>& rule) const {
  rule.clear();
  const Interval part_s{std::max(s.lower, s_.lower), std::min(s.upper, s_.upper)};
  const Interval part_t{std::max(t.lower, t_.lower), std::min(t.upper, t_.upper)};
  // Ignores slivers from rounding.
  if (part_s.length() < 1e-9 * s.length() || part_t.length() < 1e-9 * t.length()) return 0.0;
  if (rectangle_) return rectangle_overlap(part_s, part_t, points, rule);

  Polygon polygon{corners_[0], corners_[1], corners_[3], corners_[2]};
  polygon = clipped(polygon, 0, s.lower, 1.0);
  polygon = clipped(polygon, 0, s.upper, -1.0);
  polygon = clipped(polygon, 1, t.lower, 1.0);
  polygon = clipped(polygon, 1, t.upper, -1.0);
  // A fan of triangles, each the image of a square collapsed at the common corner.
  const dealii::QGauss<2> gauss(points);
  double area = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const auto a = polygon[k] - polygon[0];
    const auto b = polygon[k + 1] - polygon[0];
    const double twice = std::abs(cross(a, b));
    if (twice < 1e-18 * s.length() * t.length()) continue;
    area += 0.5 * twice;
    for (unsigned int q = 0; q < gauss.size(); ++q) {
      const double u = gauss.point(q)[0];
      const double v = gauss.point(q)[1];
      const Corner at = polygon[0] + u * ((1.0 - v) * a + v * b);
      rule.push_back({at[0], at[1], reference(at), gauss.weight(q) * u * twice});
    }
  }
  return area;
}

}  // namespace rollfem::fem
