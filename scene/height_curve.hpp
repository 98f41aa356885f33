// SPDX-License-Identifier: LGPL-2.1-or-later
// A smooth curve z(y) through knots with given slopes: the section of a rail or
// wheel in some frame, or the wheel's radius along its axle. Jumps of curvature
// stay sharp, because every piece is its own cubic.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rollfem::contact {

/// Height, slope and second derivative of a curve at a point.
struct CurveValue {
  double value = 0.0;   ///< mm
  double slope = 0.0;   ///< dz/dy
  double second = 0.0;  ///< d2z/dy2, 1/mm; of the piece on the right at a knot
};

/// The cubic of a piece of length h at the fraction t of it, by the values a and b and the slopes
/// da and db at its ends.
inline CurveValue hermite(double h, double t, double a, double b, double da, double db) {
  // Newton's form: the chord, then corrections from the slopes at both ends.
  const double by_h = 1.0 / h;
  const double chord = (b - a) * by_h;
  const double left = da - chord, right = db - chord, sum = left + right;
  return {a + h * t * (chord + (1.0 - t) * (left - t * sum)),
          chord + left * (1.0 - 2.0 * t) - sum * t * (2.0 - 3.0 * t),
          (-2.0 * left - sum * (2.0 - 6.0 * t)) * by_h};
}

struct HeightKnot {
  double y = 0.0, z = 0.0;  ///< mm
  double slope = 0.0;       ///< dz/dy
};

/// Cubic Hermite pieces between knots, extrapolated by the tangents.
class HeightCurve {
 public:
  HeightCurve() = default;
  /// At least two knots with y increasing. Throws std::invalid_argument.
  explicit HeightCurve(std::vector<HeightKnot> knots);

  CurveValue at(double y) const;
  /// Mean height between two y, from < to, mm; exact for the pieces.
  double mean(double from, double to) const;
  /// Change of the height at y by averaging over a width, mm. The height follows from the means of
  /// three neighbouring elements as those of a parabola, so that a smooth curve changes only in
  /// proportion to width^4 z'''', while waves shorter than the width have no effect that depends on
  /// the position of y in the wave.
  double averaging(double y, double width) const;
  double first() const { return knots_.front().y; }  ///< mm, lower end of the curve
  double last() const { return knots_.back().y; }    ///< mm, upper end of the curve
  bool contains(double y) const { return !knots_.empty() && y >= first() && y <= last(); }
  /// Range around 0 in which the curve is known and not steeper than this: lower and upper end, mm.
  std::array<double, 2> gentle_part(double steepest) const;
  const std::vector<HeightKnot>& knots() const { return knots_; }

 private:
  std::vector<HeightKnot> knots_;

  /// Index k of the piece between knots k and k + 1 that contains a point between the first and the
  /// last knot.
  std::size_t piece_of(double y) const;
  std::size_t stretch_of(double y) const;

  /// The range is divided into as many equal intervals as there are knots: number of knots before
  /// each interval. A point is searched only among the few knots of its interval.
  std::vector<std::uint32_t> knots_before_;
  double stretches_per_length_ = 0.0;  ///< 1/mm
};

}  // namespace rollfem::contact
