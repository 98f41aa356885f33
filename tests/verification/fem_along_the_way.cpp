// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite elements and the hybrid on rails that change along the track: they take the section at the
// contact, which is the plain profile where sections are equal, and close to it where they change
// slowly.
#include "contact/solve/model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_model.hpp"
#include "modelling/registry.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/mpi_environment.hpp"
#include "support/temporary_folder.hpp"
#include "support/wheel_rail_cases.hpp"

namespace {

/// mm, a third of the patch's half length.
constexpr double coarse_cell = 1.2;

/// S1002 by itself, 4 mm towards the field side from the middle of a rail, frictionless.
contact::Case single_wheel() {
  contact::Case input = manchester_case(-4.0, 0.0);
  input.load.vertical_force = 20e3;
  input.wheelset.on_rail = true;
  input.wheelset.side = contact::WheelSide::right;
  input.wheelset.track_position = {0.0};
  input.rolling.problem = contact::Problem::frictionless;
  input.options.set<fem::FemOptions>().mesh = fem::MeshFamily::structured;
  input.body_extent = 15.0;
  input.options.set<fem::FemOptions>().degree = 1;
  input.options.set<fem::FemOptions>().linear_solver = fem::LinearMethod::factorisation;
  return input;
}

/// On sections of the benchmark's rail that are raised by height(x).
contact::Scene on_sections(const std::function<double(double)>& height) {
  track::ProfilePair pair = manchester_pair();
  std::vector<profiles::PlacedSection> sections;
  for (double x = -60.0; x <= 60.0; x += 5.0)
    sections.push_back({x, pair.rail.moved(0.0, 0.0, -height(x)), {}});
  pair.rail_sections = std::make_shared<const profiles::SectionSurface>(
      std::move(sections), profiles::SectionSpline::through);
  const contact::Case input = single_wheel();
  return track::make_scenes(input, track::make_search_scene(input, pair)).at(0).scene;
}

contact::Scene on_profile() {
  const contact::Case input = single_wheel();
  return track::make_scenes(input, track::make_search_scene(input, manchester_pair())).at(0).scene;
}

using Solve = contact::PointResult (*)(contact::Scene scene);

contact::PointResult by_elements(contact::Scene scene) {
  return fem::run_level(scene, {coarse_cell, "", false}, {}).points.front();
}

contact::PointResult by_half_space(contact::Scene scene) {
  scene.contact_grid.cell_size = {{coarse_cell, coarse_cell}};
  return halfspace::run_halfspace(scene, {}).points.front();
}

contact::PointResult by_hybrid(contact::Scene scene) {
  scene.contact_grid.cell_size = {{coarse_cell, coarse_cell}};
  scene.follows_surface = 1.0;
  return hybrid::run_hybrid(scene, {}, nullptr, hybrid::find_smooth_parts).points.front();
}

double variation_of(const contact::Scene& scene) {
  return scene.geometry.surface.profiles->variation();
}

/// Rises at 1:100, and is hollow with a radius of 100 m.
double gently(double x) {
  return 0.01 * x + x * x / 2e5;
}

double steeply(double x) {
  return 0.1 * x + x * x / 2e3;
}

}  // namespace

TEST(FemAlongTheWay, SectionsAreTakenAtTheContact) {
  const contact::Scene plain = on_profile(), equal = on_sections([](double) { return 0.0; }),
                       gentle = on_sections(gently);
  ASSERT_TRUE(equal.geometry.surface.profiles->varies());
  EXPECT_GT(variation_of(gentle), 1e-3);
  EXPECT_LT(variation_of(gentle), 1e-2);
  const contact::PointResult half_plain = by_half_space(plain), half_gentle = by_half_space(gentle);
  for (const Solve solve : {by_elements, by_hybrid}) {
    const contact::PointResult on_plain = solve(plain), on_equal = solve(equal),
                               on_gentle = solve(gentle);
    for (const auto value :
         {&contact::PointResult::max_pressure, &contact::PointResult::approach,
          &contact::PointResult::semi_axis_x, &contact::PointResult::semi_axis_y}) {
      EXPECT_NEAR(on_equal.*value / (on_plain.*value), 1.0, 1e-6);
      // Slow changes are those of the half-space, but for what elements do not see of them.
      EXPECT_NEAR(on_gentle.*value / (on_plain.*value), half_gentle.*value / (half_plain.*value),
                  3e-3);
    }
  }
}

TEST(FemAlongTheWay, FastChangesAreRefused) {
  const contact::Scene steep = on_sections(steeply);
  EXPECT_GT(variation_of(steep), 1e-2);
  const contact::ModelRegistry models = modelling::built_in_models();
  for (const char* name : {"fem", "hybrid"}) {
    const auto wrong = models.at(name).cannot(steep);
    EXPECT_TRUE(wrong && says(*wrong, "profiles that change over the patch by more than 1 %"))
        << name;
    EXPECT_FALSE(models.at(name).cannot(on_sections(gently))) << name;
  }
  EXPECT_FALSE(models.at("halfspace").cannot(steep));
}
