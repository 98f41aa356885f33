// SPDX-License-Identifier: LGPL-2.1-or-later
// A friction law of one's own: mu falls with the square of the slip velocity, as 2^(-(s/s_h)^2).
// Case files then take it by its word. Braked at 10 m/s with a creepage of 5 %, the patch slides at
// s_h nearly everywhere, where half of the fall is left.
#include <cmath>
#include <cstdio>
#include <rollfem/rollfem.hpp>

using rollfem::contact::FallShape;

/// What is left of the fall, and its derivative, at s / s_h; the same for both parts of the law.
FallShape::Left bell(std::size_t /*part*/, double s) {
  const double left = std::exp2(-s * s);
  return {left, -2.0 * std::log(2.0) * s * left};
}

int main() try {
  rollfem::contact::fall_shapes().push_back({"bell", bell});
  const rollfem::Case input = rollfem::parse_case(R"(
    [load]
    normal_force = 50e3
    [friction]
    coefficient = 0.4
    law = "bell"
    kinetic_coefficient = 0.2
    half_velocity = 500.0
    [wheel]
    rolling_radius = 405.0
    transverse_radius = inf
    [rail]
    transverse_radius = 2000.0
    [rolling]
    speed = 10e3
    longitudinal_creepage = 0.05
  )");
  const rollfem::Result result = rollfem::solve(input, {"halfspace"});
  const double mu = result.models.front().points.front().traction_coefficient;
  std::printf("-F_x/F_z = %.4f, mu at s_h = 0.3\n", mu);
  return std::abs(mu / 0.3 - 1.0) < 0.01 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
