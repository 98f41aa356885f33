// SPDX-License-Identifier: LGPL-2.1-or-later
// Bracketed roots of functions of one variable.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace rollfem::contact {

/// Where `f` passes zero between `a` and `b`, at which its values differ in sign or vanish: within
/// `tolerance` of the argument, or to its last digits where they are coarser. Where `f` jumps past
/// zero that place counts. Throws SolveError that begins with `what` ("roll of the wheelset") when
/// the signs are equal or a value is not finite.
double bracketed_root(const std::function<double(double)>& f, double a, double b, double tolerance,
                      const char* what);

// The largest value of a smooth function of position near a good start, by a pattern search
// with shrinking steps. Many positions are evaluated at a time.

/// A value and where it is. Places outside of the body have the value -infinity.
struct ValueAt {
  double value = 0.0;
  std::array<double, 3> place{};  ///< mm
};

/// Values at places, in their order; a place may be moved, as one onto a surface.
using ValuesAt = std::function<std::vector<ValueAt>(const std::vector<std::array<double, 3>>&)>;

/// Local maximum uphill of `start`: the 26 places around the best one at distance `step` (mm) and
/// its diagonals, halving the step where none is better, down to a hundredth of it.
ValueAt local_maximum(const ValuesAt& values, ValueAt start, double step);

// Positive scalar fixed points by the secant method: plain iteration is slow where
// the slope is near one and diverges where it is steep.

class PositiveFixedPoint {
 public:
  /// The argument to be tried after `at` has come out as `image`. The first step is a plain one.
  double next(double at, double image) {
    const double change = image - at;
    double step = change;
    if (known_ && at != last_at_) {
      const double slope = (change - last_change_) / (at - last_at_);
      if (slope < 0.0) step = -change / slope;
    }
    known_ = true;
    last_at_ = at;
    last_change_ = change;
    // What is searched for is positive; a step beyond that is shortened.
    return at + step > 0.0 ? at + step : 0.25 * at;
  }

 private:
  bool known_ = false;
  double last_at_ = 0.0;
  double last_change_ = 0.0;
};

}  // namespace rollfem::contact
