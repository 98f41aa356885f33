// SPDX-License-Identifier: LGPL-2.1-or-later
// Step 2: contact on this compliance. One driver, ContactRun, solves normal contact and friction
// for every load point of a scene on any elasticity; here on half-spaces. The largest pressure is
// Hertz's, the force of a small creepage Kalker's, and that of a large one the friction bound.
#include "case/reading/case_reader.hpp"
#include "contact/solve/contact_run.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <cmath>
#include <cstdio>

using namespace rollfem;

int main() {
  const contact::Scene scene(contact::parse_case(R"(
    [load]
    normal_force = 50e3
    [friction]
    coefficient = 0.3
    [wheel]
    rolling_radius = 450.0
    transverse_radius = inf
    [rail]
    transverse_radius = 300.0
    [rolling]
    longitudinal_creepage = [2e-5, 5e-4, 1e-3, 2e-3, 2e-2]
  )",
                                                 "step 2"));
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(scene);
  const contact::ContactGrid grid = contact::ContactGrid::centred(
      48, 48, hertz.semi_axis_x / 20.0, hertz.semi_axis_y / 20.0);  // 40 elements across the patch
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  const contact::Progress silent;
  contact::ContactRun run(scene, geometry, contact::RunOptions(), silent, nullptr);
  if (!run.solve(grid, [&] {
        return std::make_unique<halfspace::PreconditionedElasticity>(scene, grid);
      })) {
    std::fprintf(stderr, "the patch reaches the border of the grid\n");
    return 1;
  }
  const contact::LevelResult result = run.take_result();
  std::printf("creepage   -F_x/F_z    linear theory\n");
  for (const contact::PointResult& point : result.points) {
    const halfspace::CreepForces linear = halfspace::linear_creep_forces(
        hertz.semi_axis_x, hertz.semi_axis_y, scene.material.shear_modulus,
        scene.material.poisson_ratio, point.creepage);
    std::printf("%8.5f   %.5f    %.5f\n", point.creepage.longitudinal, point.traction_coefficient,
                -linear.longitudinal / 50e3);
  }
  const contact::PointResult& small = result.points.front();
  const halfspace::CreepForces linear = halfspace::linear_creep_forces(
      hertz.semi_axis_x, hertz.semi_axis_y, scene.material.shear_modulus,
      scene.material.poisson_ratio, small.creepage);
  const bool as_hertz = std::abs(small.max_pressure / hertz.max_pressure - 1.0) < 2e-3;
  const bool as_kalker = std::abs(small.longitudinal_force / linear.longitudinal - 1.0) < 2e-2;
  const bool slides = std::abs(result.points.back().traction_coefficient / 0.3 - 1.0) < 1e-4;
  return as_hertz && as_kalker && slides ? 0 : 1;
}
