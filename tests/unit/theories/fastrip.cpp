// SPDX-License-Identifier: LGPL-2.1-or-later
// FaStrip: Kalker's initial slopes, the friction bound, Carter's line contact, and combined
// creepage and spin against half-spaces solved by CONTACT.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include <fmt/format.h>

#include "support/half_space_models.hpp"
#include "support/test.hpp"
#include <cmath>
#include <string>

namespace {

/// Hertz's pressure of 82 kN on an ellipse; mu = 0.3, G = 82 000 MPa.
contact::PointResult point_of(const std::string& model, double a, double b,
                              const std::string& rolling) {
  const std::string text = fmt::format(
      "[load]\nnormal_force = 82e3\n[friction]\ncoefficient = 0.3\n"
      "[wheel]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[given_pressure]\nsemi_axis_x = {}\nsemi_axis_y = {}\n"
      "[contact_grid]\nelements_across = 40\n[fastsim]\nstrips = 200\nstrip_elements = 400\n"
      "[rolling]\n{}",
      a, b, rolling);
  return half_space_models().run(model, contact::parse_case(text, "ellipse.toml"), {}).points[0];
}

constexpr double friction_force = 0.3 * 82e3;

TEST(Fastrip, SmallCreepagesHaveKalkersForces) {
  for (const auto& [a, b] : {std::pair{8.0, 4.0}, {5.0, 5.0}, {3.0, 9.0}})
    for (const char* rolling :
         {"longitudinal_creepage = 1e-7", "lateral_creepage = 1e-7", "spin = 1e-8",
          "longitudinal_creepage = 1e-7\nlateral_creepage = -2e-7\nspin = 1e-8"}) {
      const auto strip = point_of("fastrip", a, b, rolling);
      const auto linear = point_of("linear", a, b, rolling);
      const double size = std::hypot(linear.longitudinal_force, linear.lateral_force);
      EXPECT_NEAR(strip.longitudinal_force / size, linear.longitudinal_force / size, 1e-3)
          << rolling;
      EXPECT_NEAR(strip.lateral_force / size, linear.lateral_force / size, 1e-3) << rolling;
    }
}

TEST(Fastrip, LargeCreepageSlidesUnderTheWholeBound) {
  const auto point =
      point_of("fastrip", 8.0, 4.0, "longitudinal_creepage = 0.03\nlateral_creepage = 0.04");
  EXPECT_NEAR(point.longitudinal_force / friction_force, -0.6, 0.005);
  EXPECT_NEAR(point.lateral_force / friction_force, -0.8, 0.005);
  EXPECT_EQ(point.adhesion_area, 0.0);
}

/// A patch a hundred times as wide as long is Carter's line contact strip by strip.
TEST(Fastrip, AVeryWidePatchIsCarters) {
  for (const char* xi : {"1e-4", "3e-4", "6e-4"}) {
    const std::string rolling = std::string("longitudinal_creepage = ") + xi;
    const auto strip = point_of("fastrip", 1.0, 100.0, rolling);
    const auto carter = point_of("carter", 1.0, 100.0, rolling);
    EXPECT_NEAR(strip.longitudinal_force, carter.longitudinal_force, 0.01 * friction_force) << xi;
    EXPECT_NEAR(strip.adhesion_area, carter.adhesion_area, 0.02 * carter.contact_area) << xi;
  }
}

/// CONTACT's example fastsim, cases 1 (half-space) and 7 (its FaStrip, which changes flexibilities
/// with the creepages): lateral creepage against spin.
TEST(Fastrip, IsNearerToTheHalfSpaceUnderSpinThanFastsim) {
  const char* rolling = "lateral_creepage = -0.000625\nspin = 0.000625";
  const auto strip = point_of("fastrip", 8.0, 4.0, rolling);
  EXPECT_NEAR(std::abs(strip.lateral_force) / friction_force, 0.6074, 0.01);
  EXPECT_NEAR(std::abs(strip.lateral_force) / friction_force, 0.6442, 0.04);
  EXPECT_NEAR(std::abs(strip.spin_moment), 4.821e4, 0.02 * 4.821e4);
  const auto brush = point_of("fastsim", 8.0, 4.0, rolling);
  EXPECT_GT(std::abs(std::abs(brush.lateral_force) / friction_force - 0.6074), 0.02);
}

/// Benchmark 9 on a circle, extrapolated from CONTACT: 10 240 N, -7060 N.
TEST(Fastrip, CombinedCreepageAndSpin) {
  const auto point = point_of(
      "fastrip", 6.0, 6.0, "longitudinal_creepage = -1e-3\nlateral_creepage = 5e-4\nspin = 1e-4");
  EXPECT_NEAR(point.longitudinal_force, 10240.0, 0.03 * friction_force);
  EXPECT_NEAR(point.lateral_force, -7060.0, 0.03 * friction_force);
}

/// Where |P| >= 1 the leading edge slips under spin alone. Half-space of 80 kN on a circle of 5 mm:
/// 0.14120 +- 0.00018.
TEST(Fastrip, SpinAgainstLateralCreepageStaysWithinFriction) {
  const std::string circle =
      "[load]\nnormal_force = 80e3\n[friction]\ncoefficient = 0.3\n"
      "[given_pressure]\nsemi_axis_x = 5.0\nsemi_axis_y = 5.0\n"
      "[rolling]\nlateral_creepage = -0.001\nspin = 0.002\n";
  const auto point =
      half_space_models().run("fastrip", contact::parse_case(circle, "circle.toml"), {}).points[0];
  EXPECT_NEAR(std::abs(point.lateral_force) / 80e3, 0.1412, 0.05 * 0.3);
  for (const auto& [a, b] : {std::pair{3.0, 9.0}, {5.0, 5.0}, {9.0, 4.0}})
    for (const double xi : {0.0, 1e-3, 1e-2})
      for (const double eta : {-3e-3, -1e-3, 1e-3})
        for (const double spin : {-3e-3, 1e-3, 2e-3, 3e-3}) {
          const std::string rolling = fmt::format(
              "longitudinal_creepage = {:e}\nlateral_creepage = {:e}\nspin = {:e}", xi, eta, spin);
          contact::PointResult all;
          ASSERT_NO_THROW(all = point_of("fastrip", a, b, rolling)) << a << '\n' << rolling;
          const auto& traction = all.fields.traction;
          const auto size = (traction.x.array().square() + traction.y.array().square()).sqrt();
          EXPECT_LE((size - all.fields.traction_bound.array()).maxCoeff(), 1e-9 * all.max_pressure)
              << a << '\n'
              << rolling;
          EXPECT_LT(std::hypot(all.longitudinal_force, all.lateral_force), friction_force);
        }
}

TEST(TheoriesOfStrips, FindTheCreepageOfAForce) {
  for (const char* model : {"fastsim", "fastrip", "strip"}) {
    const auto given = point_of(
        model, 5.0, 4.0, "longitudinal_creepage = 0.002\nlateral_creepage = -0.001\nspin = 1e-4");
    for (const bool both : {false, true}) {
      const auto found = point_of(
          model, 5.0, 4.0,
          fmt::format("spin = 1e-4\nlongitudinal_force = {:.12g}\n{}", given.longitudinal_force,
                      both ? fmt::format("lateral_force = {:.12g}", given.lateral_force)
                           : std::string("lateral_creepage = -0.001")));
      EXPECT_NEAR(found.longitudinal_force, given.longitudinal_force, 1e-5 * friction_force);
      EXPECT_NEAR(found.creepage.longitudinal, 0.002, 2e-7) << model;
      EXPECT_NEAR(found.creepage.lateral, -0.001, 2e-7) << model;
    }
    EXPECT_THROW(point_of(model, 5.0, 4.0, "longitudinal_force = 25e3"), contact::InputError);
  }
}

}  // namespace
