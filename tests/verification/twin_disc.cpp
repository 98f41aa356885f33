// SPDX-License-Identifier: LGPL-2.1-or-later
// A disc of a twin-disc machine with sharp ends on a wide roller.
#include "base/pi.hpp"
#include "result/bars.hpp"
#include "result/free_ends.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/committed_cases.hpp"
#include "support/half_space_models.hpp"

namespace {

/// A disc 10 mm wide, ends sharp, on a roller of the same radius and 60 mm, on cells of this width.
Case sharp_disc(double cell_width, double lateral_position = 0.0) {
  Case input = committed_case("verification/twin_disc_ends");
  for (contact::ProfileSource* profile : {&input.wheel.profile, &input.rail.profile})
    profile->radii = {contact::infinity};
  input.wheel.profile.ends = {-5.0, 5.0};
  input.wheel.profile.free_ends = true;
  input.rail.profile.ends = {-30.0, 30.0};
  input.wheelset.lateral_shift = {lateral_position};
  input.rolling.problem = contact::Problem::frictionless;
  input.contact_grid.cell_size = {0.04, cell_width};
  return input;
}

struct PressedDisc {
  contact::Scene scene;
  ModelResult result;
  const PointResult& point() const { return result.points.at(0); }
  /// Largest pressure of a row of elements, MPa, and its line load, N/mm; from below.
  std::vector<double> pressure, load;
};

PressedDisc pressed(const Case& input) {
  PressedDisc disc{track::make_scenes(input).at(0).scene, {}, {}, {}};
  disc.result = half_space_models().run("halfspace", disc.scene, {});
  const contact::ContactGrid& grid = disc.result.grid;
  for (int j = 0; j < grid.ny; ++j) {
    const auto row = disc.point().fields.traction.n.segment(grid.index(0, j), grid.nx);
    if (!(row.maxCoeff() > 0.0)) continue;
    disc.pressure.push_back(row.maxCoeff());
    disc.load.push_back(row.sum() * grid.dx);
  }
  return disc;
}

TEST(TwinDisc, WithSharpEndsIsAPunchAcrossAndHertzInItsMiddle) {
  const PressedDisc disc = pressed(sharp_disc(0.125));
  EXPECT_NEAR(disc.point().normal_force, 7198.0, 1e-3);
  const std::size_t rows = disc.pressure.size();
  ASSERT_EQ(rows, 80u);
  for (std::size_t j = 0; j < rows; ++j)
    EXPECT_NEAR(disc.pressure[j], disc.pressure[rows - 1 - j], 1e-4 * disc.pressure[j]) << j;
  // The ends carry more than the mean of 719.8 N/mm.
  const double load = disc.load[rows / 2];
  EXPECT_GT(load, 0.85 * 719.8);
  EXPECT_LT(load, 719.8);
  const double modulus = disc.scene.material.contact_modulus, radius = 11.75;
  EXPECT_NEAR(disc.pressure[rows / 2], std::sqrt(load * modulus / (contact::pi * radius)),
              5e-3 * disc.pressure[rows / 2]);
}

TEST(TwinDisc, PressureAtASharpEndGrowsWithoutLimit) {
  // As over the edge of a punch, with the root of the distance: by 1.41 on cells half as wide.
  const PressedDisc coarse = pressed(sharp_disc(0.0625)), fine = pressed(sharp_disc(0.03125));
  EXPECT_NEAR(fine.pressure.front() / coarse.pressure.front(), std::sqrt(2.0), 0.07);
  EXPECT_EQ(fine.point().no_bar.at("max_pressure"), contact::NoBar::no_limit);
  EXPECT_EQ(fine.point().error_estimate.count("max_pressure"), 0u);
  // What is no edge converges.
  EXPECT_NEAR(fine.point().approach / coarse.point().approach, 1.0, 2e-3);
  EXPECT_GT(fine.point().error_estimate.at("approach"), 0.0);
}

TEST(TwinDisc, EndsAreWarnedOfWhereTheyCarry) {
  const auto warned = [](const Case& input) {
    const contact::ModelResult result = pressed(input).result;
    const contact::Note* note = result.note_about("free_ends");
    return note != nullptr && note->severity == contact::Note::warning;
  };
  EXPECT_TRUE(warned(sharp_disc(0.25)));
  // A crown keeps the patch away from the ends.
  Case crowned = sharp_disc(0.25);
  crowned.wheel.profile.radii = {200.0};
  crowned.load.vertical_force = 500.0;
  EXPECT_FALSE(warned(crowned));
}

TEST(TwinDisc, HalfBesideTheRollerTouchesBetweenTwoEnds) {
  Case input = sharp_disc(0.125, 27.0);
  input.rail.profile.free_ends = true;
  const PressedDisc disc = pressed(input);
  EXPECT_NEAR(disc.point().contact_width, 8.0, 0.15);
  ASSERT_EQ(contact::loaded_ends(disc.scene, disc.result.grid, disc.point()).ends.size(), 2u);
  EXPECT_THROW(track::make_scenes(sharp_disc(0.125, 27.0)), contact::InputError);
}

TEST(TwinDisc, TiltedDiscEndsWhereItsCornersAre) {
  Case input = sharp_disc(0.1);
  input.wheelset.roll = {0.0005};
  const PressedDisc disc = pressed(input);
  EXPECT_NEAR(disc.point().contact_width, 10.0, 0.01);
  EXPECT_GT(disc.pressure.back(), 1.2 * disc.pressure.front());
}

}  // namespace
