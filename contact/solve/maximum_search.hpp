// The largest value of a smooth function of position near a good start, by a pattern search
// with shrinking steps. Many positions are evaluated at a time.
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace rollfem::contact {

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

}  // namespace rollfem::contact
