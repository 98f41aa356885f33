// SPDX-License-Identifier: LGPL-2.1-or-later
// A friction law of one's own: mu falls as 2^(-(s/s_h)^n) with the slip velocity s. Its word and
// its constant n are then keys of case files. Braked at 10 m/s with a creepage of 5 %, the patch
// slides at 500 mm/s nearly everywhere, sqrt(2) times s_h: a quarter of the fall is left with n
// = 2.
#include <cmath>
#include <cstdio>
#include <rollfem/rollfem.hpp>

using rollfem::contact::FallShape;

/// What is left of the fall, and its derivative, at s / s_h; the same for both parts of the law.
FallShape::Left bell(std::size_t /*part*/, double s, const FallShape::Constants& own) {
  const double n = own[0], left = std::exp2(-std::pow(s, n));
  return {left, -std::log(2.0) * n * std::pow(s, n - 1.0) * left};
}

int main() try {
  rollfem::contact::fall_shapes().push_back(
      {"bell", bell, false, {{{"bell_power", "n", 1.0, 10.0, 1.0, "Power of s over s_h1."}}}});
  const rollfem::Case input = rollfem::parse_case(R"(
    [load]
    normal_force = 50e3
    [friction]
    coefficient = 0.4
    law = "bell"
    kinetic_coefficient = 0.2
    half_velocity = 353.553391
    bell_power = 2.0
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
  std::printf("-F_x/F_z = %.4f, mu at this velocity = 0.25\n", mu);
  return std::abs(mu / 0.25 - 1.0) < 0.01 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
