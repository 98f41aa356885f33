// SPDX-License-Identifier: LGPL-2.1-or-later
// Polach's closed form: its limits, its reductions, and friction that falls with the slip velocity.
#include "case/reading/case_reader.hpp"
#include "theories/closed_forms.hpp"

#include <fmt/format.h>

#include "support/case_examples.hpp"
#include "support/half_space_models.hpp"
#include <array>
#include <cmath>

namespace {

using theories::polach_saturation;

contact::PointResult point_of(const std::string& model, const std::string& more) {
  return half_space_models().run(model, contact::parse_case(plus(more), "a.toml"), {}).points[0];
}

TEST(Polach, ClosedFormHasItsLimits) {
  EXPECT_NEAR(polach_saturation(1e-6, 1.0, 1.0) / 1e-6, 4.0 / M_PI, 1e-9);
  EXPECT_NEAR(polach_saturation(1e-6, 0.7, 0.3) / 1e-6, 2.0 / M_PI, 1e-9);
  EXPECT_NEAR(polach_saturation(1.0, 1.0, 1.0), 1.0 / M_PI + 0.5, 1e-15);
  EXPECT_NEAR(polach_saturation(1e9, 1.0, 1.0), 1.0, 1e-8);
}

TEST(Polach, SmallCreepagesHaveKalkersForces) {
  for (const char* rolling : {"longitudinal_creepage = 1e-8", "lateral_creepage = -1e-8"}) {
    const std::string text = std::string("[rolling]\n") + rolling;
    const auto linear = point_of("linear", text);
    const auto polach = point_of("polach", text);
    EXPECT_NEAR(polach.longitudinal_force, linear.longitudinal_force, 1e-4) << rolling;
    EXPECT_NEAR(polach.lateral_force, linear.lateral_force, 1e-4) << rolling;
    const auto reduced =
        point_of("polach", text + "\n[polach]\nadhesion_reduction = 0.6\nslip_reduction = 0.2");
    EXPECT_NEAR(reduced.longitudinal_force, 0.4 * linear.longitudinal_force, 1e-4) << rolling;
  }
}

TEST(Polach, TheForceIsAgainstTheCreepage) {
  for (const char* rolling : {"longitudinal_creepage = 1e-4\nlateral_creepage = 1e-4",
                              "longitudinal_creepage = 0.02\nlateral_creepage = 0.02"}) {
    const auto point = point_of("polach", std::string("[rolling]\n") + rolling);
    EXPECT_NEAR(point.longitudinal_force / point.lateral_force, 1.0, 1e-12) << rolling;
  }
}

TEST(Polach, SmallSpinHasKalkersLateralForce) {
  const std::string spin = "[rolling]\nspin = 1e-9";
  const auto linear = point_of("linear", spin);
  EXPECT_NEAR(point_of("polach", spin).lateral_force / linear.lateral_force, 1.0, 1e-4);
  EXPECT_EQ(point_of("polach", spin).longitudinal_force, 0.0);
}

/// Polach (1999) written out, with K_M and the modified creepage s_yC.
TEST(Polach, SpinIsThatOfThePaper) {
  const auto hertz = point_of("hertz", "[rolling]\nlongitudinal_creepage = 0.0");
  const double a = hertz.semi_axis_x, b = hertz.semi_axis_y, bound = 0.55 * 50e3;
  for (const auto& [x, y, spin] :
       {std::array{1e-3, 5e-4, 2e-4}, {1e-3, -2e-3, 2e-4}, {0.0, 1e-3, -3e-4}, {2e-3, 0.0, 1e-3}}) {
    const std::string rolling =
        fmt::format("[rolling]\nlongitudinal_creepage = {:e}\nlateral_creepage = {:e}\n", x, y);
    const double lateral = std::abs(y + spin * a) > std::abs(y) ? y + spin * a : y;
    const double rigid = std::hypot(x, y), modified = std::hypot(x, lateral);
    const auto linear = point_of("linear", rolling);
    const double eps = M_PI / 4.0 * std::hypot(linear.longitudinal_force, linear.lateral_force) *
                       modified / rigid / bound;
    const double force = 2.0 / M_PI * bound * (eps / (1.0 + eps * eps) + std::atan(eps));
    // (ab)^(3/2) G C23 from the linear theory's force by spin.
    const double by_spin =
        std::abs(point_of("linear", "[rolling]\nspin = 1e-9").lateral_force) / 1e-9;
    const double scale = 1.0 + 6.3 * (1.0 - std::exp(-a / b));
    const double of_spin = 8.0 / 3.0 * by_spin / a * std::abs(lateral) / (bound * scale);
    const double delta = (of_spin * of_spin - 1.0) / (of_spin * of_spin + 1.0);
    const double k = of_spin * (std::pow(delta, 3) / 3.0 - delta * delta / 2.0 + 1.0 / 6.0) -
                     std::pow(1.0 - delta * delta, 1.5) / 3.0;
    const double more = 9.0 / 16.0 * a * bound * k * scale * spin / modified;
    const auto polach = point_of("polach", rolling + fmt::format("spin = {:e}\n", spin));
    EXPECT_NEAR(polach.longitudinal_force, -force * x / modified, 1e-6 * bound);
    EXPECT_NEAR(polach.lateral_force, -force * y / modified + more, 1e-4 * bound);
    EXPECT_EQ(polach.spin_moment, 0.0);
  }
}

TEST(Polach, LargeCreepagesSlideUnderTheFrictionThatIsLeft) {
  const std::string text =
      "[rolling]\nspeed = 10e3\nlongitudinal_creepage = 0.3\nlateral_creepage = 0.4";
  const auto point = point_of("polach", text);
  const double bound = std::hypot(point.longitudinal_force, point.lateral_force);
  EXPECT_NEAR(bound / (0.55 * 50e3), 1.0, 1e-3);
  // Polach's A = 0.4 and B = 0.1 s/m at 5 m/s.
  contact::Case input = contact::parse_case(plus(text), "a.toml");
  input.friction_fall.shape = contact::FallShape::exponential;
  input.friction_fall.polach_a = 0.4;
  input.friction_fall.polach_b = 0.1;
  const auto slower = half_space_models().run("polach", contact::Scene(input), {}).points[0];
  EXPECT_NEAR(std::hypot(slower.longitudinal_force, slower.lateral_force) / bound,
              0.6 * std::exp(-0.5) + 0.4, 1e-3);
}

}  // namespace
