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

/// Height, slope and second derivative of a curve at a place.
struct CurveValue {
  double value = 0.0;   ///< mm
  double slope = 0.0;   ///< dz/dy
  double second = 0.0;  ///< d2z/dy2, 1/mm; of the piece on the right at a knot
};

/// Cubic Hermite pieces between knots; beyond the first and the last knot the tangent goes on.
class HeightCurve {
 public:
  HeightCurve() = default;
  /// Knots in mm with y rising; lists of one length, at least 2. Throws std::invalid_argument.
  HeightCurve(std::vector<double> y, std::vector<double> z, std::vector<double> slope);

  CurveValue at(double y) const;
  /// Mean height between two places, from < to, mm; exact for the pieces.
  double mean(double from, double to) const;
  /// What means over a width change the height at y by, mm. The height is taken from the means of
  /// three neighbouring elements as those of a parabola, so that a smooth curve changes by a part
  /// of width^4 z'''' only, while waves shorter than the width leave nothing that depends on where
  /// in the wave y lies.
  double averaging(double y, double width) const;
  double first() const { return y_.front(); }  ///< mm, lower end of what is known
  double last() const { return y_.back(); }    ///< mm, upper end
  bool contains(double y) const { return !y_.empty() && y >= first() && y <= last(); }
  /// From 0 to both sides, how far it is known and no steeper than that: lower and upper end, mm.
  std::array<double, 2> gentle_part(double steepest) const;
  const std::vector<double>& knots() const { return y_; }

 private:
  std::vector<double> y_;
  std::vector<double> z_;
  std::vector<double> slope_;

  /// The piece between knots k and k + 1 that holds a place between the first and the last knot.
  std::size_t piece_of(double y) const;
  std::size_t stretch_of(double y) const;

  /// From the first knot to the last there are as many stretches of one length as knots: how many
  /// knots are in those before each. A place is looked for among the few knots of its own.
  std::vector<std::uint32_t> knots_before_;
  double stretches_per_length_ = 0.0;  ///< 1/mm
};

}  // namespace rollfem::contact
