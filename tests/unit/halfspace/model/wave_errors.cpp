// SPDX-License-Identifier: LGPL-2.1-or-later
// The error from waves too short for the elements: detected in profiles that have them, and as
// large as the model finds with elements a quarter as wide.
#include "halfspace/model/wave_errors.hpp"

#include "halfspace/model/halfspace_model.hpp"

#include "support/profile_scenes.hpp"
#include "support/worn_pairs.hpp"

namespace {

contact::ModelResult solved(contact::Scene scene, double dx, double dy) {
  scene.contact_grid.cell_size = {{dx, dy}};
  return halfspace::run_halfspace(scene, {});
}

bool warns(const contact::ModelResult& result) {
  return result.note_about("waves") != nullptr;
}

TEST(WaveErrors, OfNewProfilesAreNone) {
  const contact::Scene scene = left_wheel_scene();
  for (const double cell : {0.4, 0.8}) {
    const contact::ModelResult result = solved(scene, cell, cell);
    EXPECT_FALSE(halfspace::wave_errors(scene, 0, result.grid, result.points.front())) << cell;
    EXPECT_FALSE(warns(result)) << cell;
  }
}

TEST(WaveErrors, AreWhatTheModelChangesOnNarrowerElements) {
  constexpr double cell = 0.4;
  WornPairs pairs(12);
  bool any_warning = false;
  for (const unsigned number : {0u, 1u, 2u}) {
    SCOPED_TRACE(number);
    const contact::Scene scene = pairs.scene(number);
    const contact::ModelResult wide = solved(scene, cell, cell);
    const contact::PointResult& here = wide.points.front();
    const contact::PointResult there = solved(scene, cell, 0.25 * cell).points.front();
    const auto errors = halfspace::wave_errors(scene, 0, wide.grid, here);
    ASSERT_TRUE(errors);
    const double pressure = std::abs(there.max_pressure - here.max_pressure);
    EXPECT_NEAR(errors->at("max_pressure"), pressure, 0.01 * here.max_pressure);
    EXPECT_NEAR(errors->at("contact_area"), std::abs(there.contact_area - here.contact_area),
                0.01 * here.contact_area);
    EXPECT_NEAR(errors->at("approach"), std::abs(there.approach - here.approach),
                1e-3 * here.approach);
    EXPECT_GE(here.error_estimate.at("max_pressure"), pressure);
    EXPECT_TRUE(warns(wide) || pressure < 0.06 * here.max_pressure);
    any_warning = any_warning || warns(wide);
  }
  EXPECT_TRUE(any_warning);
}

}  // namespace
