// SPDX-License-Identifier: LGPL-2.1-or-later
// Polach's closed form: its limits, its reductions, and friction that falls with the slip velocity.
#include "contact/case/case_reader.hpp"
#include "theories/closed_forms.hpp"

#include "support/case_examples.hpp"
#include "support/half_space_models.hpp"
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
  for (const char* rolling : {"longitudinal_creepage = 1e-8", "lateral_creepage = -1e-8",
                              "longitudinal_creepage = 1e-8\nlateral_creepage = 2e-8"}) {
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
