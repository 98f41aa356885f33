// SPDX-License-Identifier: LGPL-2.1-or-later
// Step 1: a body and its compliance. Hertz's pressure on two half-spaces moves their surfaces by
// the approach less the undeformed distance. The compliance of a grid gives this displacement from
// the pressure of its elements, with an error that falls with the size of the elements.
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include <cstdio>

using namespace rollfem;

int main() {
  // A case holds what a case file says, a scene what a model solves.
  const contact::Scene scene(contact::parse_case(R"(
    [load]
    normal_force = 50e3
    [friction]
    coefficient = 0.0
    [wheel]
    rolling_radius = 450.0
    transverse_radius = inf
    [rail]
    transverse_radius = 300.0
  )",
                                                 "step 1"));
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(scene);
  std::printf("patch of %.3f by %.3f mm, p_0 = %.1f MPa, approach %.5f mm\n\n", hertz.semi_axis_x,
              hertz.semi_axis_y, hertz.max_pressure, hertz.approach);
  std::printf("elements across   largest error / approach\n");
  double error = 1.0, ratio = 1.0;
  for (const int across : {10, 20, 40, 80}) {
    const int n = across + across / 5;  // the grid is larger than the patch
    const contact::ContactGrid grid = contact::ContactGrid::centred(
        n, n, 2.0 * hertz.semi_axis_x / across, 2.0 * hertz.semi_axis_y / across);
    const halfspace::HalfspaceCompliance bodies(grid, scene.material);
    const contact::Field pressure =
        grid.sample([&](double x, double y) { return hertz.pressure(x, y); });
    const contact::Field none = contact::Field::Zero(grid.size());
    const contact::SurfaceField moved = bodies.apply({none, none, pressure});
    const contact::Field exact = grid.sample([&](double x, double y) {
      return halfspace::hertz_displacement(hertz, scene.material.contact_modulus, x, y);
    });
    const double coarser = error;
    error = (moved.n - exact).cwiseAbs().maxCoeff() / hertz.approach;
    ratio = coarser / error;
    std::printf("%15d   %.5f\n", across, error);
  }
  return error < 1e-3 && ratio > 2.0 ? 0 : 1;  // better than first order
}
