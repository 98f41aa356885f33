// SPDX-License-Identifier: LGPL-2.1-or-later
// A finite-element face of the contact surface in chart coordinates (s, t): the part of a contact
// element on it, and quadrature over that part. Internal to fem/.
#pragma once

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rollfem::fem {

struct Interval {
  double lower;
  double upper;
  double length() const { return upper - lower; }
};

/// Quadrature point on a face: position in the chart and on the reference face, and part of the
/// area ds dt.
struct FacePoint {
  double s;
  double t;
  dealii::Point<2> reference;
  double weight;
};

/// A convex quadrilateral in (s, t). Refined nodes are means in the chart, so that faces have
/// straight sides there and their map from the reference face is bilinear: overlaps with contact
/// elements are polygons, computed exactly.
class ChartFace {
 public:
  /// Corners in deal.II's order: 0 1 along the first reference axis, 2 3 above them.
  explicit ChartFace(const std::array<dealii::Point<2>, 4>& corners);

  const Interval& s() const { return s_; }
  const Interval& t() const { return t_; }
  /// False for a folded or non-convex face.
  bool is_convex() const { return convex_; }

  /// Area ds dt of the overlap with the box s x t. `rule` receives Gauss points over it, `points`
  /// in each direction of every piece; exact for polynomials on parallelograms.
  double overlap(const Interval& s, const Interval& t, unsigned int points,
                 std::vector<FacePoint>& rule) const;

  /// Position on the reference face of a point in the chart, by Newton's method.
  dealii::Point<2> reference(const dealii::Point<2>& chart) const;

 private:
  double rectangle_overlap(const Interval& s, const Interval& t, unsigned int points,
                           std::vector<FacePoint>& rule) const;

  std::array<dealii::Point<2>, 4> corners_;
  Interval s_;
  Interval t_;
  bool rectangle_;  ///< sides along s and t
  bool convex_;
};

}  // namespace rollfem::fem
