// SPDX-License-Identifier: LGPL-2.1-or-later
// A law of friction outside the library, with a constant of its own: falls as 2^(-(s/s_h)^n).
#pragma once

#include "case/fall_shape.hpp"

#include <cmath>

namespace rollfem::test {

inline void add_power_law() {
  const auto power = [](std::size_t, double s, const contact::FallShape::Constants& own) {
    const double n = own[0], left = std::exp2(-std::pow(s, n));
    return contact::FallShape::Left{left, -std::log(2.0) * n * std::pow(s, n - 1.0) * left};
  };
  contact::fall_shapes().push_back(
      {"power", power, false, {{{"power_of_slip", "n", 1.0, 10.0, 1.0, "Power of s over s_h1."}}}});
}

}  // namespace rollfem::test
