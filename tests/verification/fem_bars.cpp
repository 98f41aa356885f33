// SPDX-License-Identifier: LGPL-2.1-or-later
// The error bars of finite elements on a random contact, which is none of the cases a to f, against
// cells of half the size and their bars. benchmarks/fem_bars.cpp counts how often bars hold.
#include "fem/elasticity/fem_model.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include "support/bar_coverage.hpp"
#include "support/mpi_environment.hpp"
#include "support/random_wheel_rail.hpp"
#include "support/records_in_memory.hpp"

TEST(FemBars, HoldOutsideTheFamilyAndAreNotUseless) {
  RandomWheelRail contacts(1);
  contact::Case input = contacts.contact(0);  // 3.0 by 1.4 mm, half of each body
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(contact::Scene(input));
  input.body_extent = 3.0 * std::max(hertz.semi_axis_x, hertz.semi_axis_y);
  input.subsurface = points_below(hertz.semi_axis_x, hertz.semi_axis_y);
  RecordsInMemory levels;  // those that both runs have are solved once
  const auto run = [&](double parts) {
    input.options.set<fem::FemOptions>().cell_size =
        std::min(hertz.semi_axis_x, hertz.semi_axis_y) / parts;
    return fem::run_fem(contact::Scene(input), {}, &levels).points.front();
  };
  const contact::PointResult point = run(4.0);
  const contact::PointResult fine = run(8.0);
  BarSamples samples;
  add_samples(point, fine, input.friction_coefficient, samples);
  // Of 14 mm^2 one adheres, eight of the coarse elements: it jumps from grid to grid.
  samples.erase("adhesion_area");
  for (const char* name :
       {"longitudinal_force", "traction_coefficient", "max_pressure", "max_traction",
        "max_traction_x", "approach", "semi_axis_x", "semi_axis_y", "contact_area",
        "elastic_energy", "frictional_work", "creepage_work", "subsurface_stress"})
    EXPECT_GE(samples[name].size(), 1u) << name;
  for (const auto& [name, of_name] : samples)
    for (const BarSample& sample : of_name)
      EXPECT_LE(sample.error, std::hypot(sample.bar, sample.fine_bar)) << name;
  // By 8 elements across: a bar of everything would hold, too.
  EXPECT_LT(point.error_estimate.at("max_pressure"), 0.03 * point.max_pressure);
  EXPECT_LT(point.error_estimate.at("semi_axis_y"), 0.05 * point.semi_axis_y);
  EXPECT_LT(point.error_estimate.at("longitudinal_force"),
            0.1 * input.friction_coefficient * point.normal_force);
}
