// Positive scalar fixed points by the secant method: plain iteration is slow where
// the slope is near one and diverges where it is steep.
#pragma once

#include <cmath>

namespace rollfem::contact {

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
