// SPDX-License-Identifier: LGPL-2.1-or-later
// A flat rail of finite elements under Hertz's pressure on a circle, with friction, and the stress
// recovered in it.
#pragma once

#include "fem/linear/multigrid.hpp"
#include "fem/stress/stress_output.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "halfspace/stress/subsurface.hpp"

#include "support/fem_test_support.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

using contact::SymmetricTensor;

struct LoadedRail {
  static constexpr double p0 = 1000.0;
  static constexpr double a = 4.0;
  static constexpr double cell = 0.5;
  static constexpr contact::Material material{210e3, 0.3};

  /// Pressure of an element: its mean at `parts` by `parts` places; of 20 it is the mean that a
  /// contact solver finds, of 1 what is in the middle.
  contact::SurfaceField hertz(const contact::ContactGrid& on) const {
    contact::SurfaceField field;
    field.n = on.sample([&](double x, double y) {
      double sum = 0.0;
      for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
          const double u = (x + on.dx * ((i + 0.5) / parts - 0.5)) / a;
          const double v = (y + on.dy * ((j + 0.5) / parts - 0.5)) / a;
          sum += std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
        }
      return p0 * sum / (parts * parts);
    });
    field.x = -friction * field.n;
    field.y = 0.0 * field.n;
    return field;
  }

  LoadedRail(double with_friction, int with_parts, double fine_half, double extent)
      : friction(with_friction), parts(with_parts), traction(hertz(grid)) {
    fem::BodyOptions options;
    options.cell_size = cell;
    options.fine_half_length = options.fine_half_width = fine_half;
    options.extent = extent;
    options.half = true;
    body = std::make_unique<fem::Body>(rail_shape(contact::infinity), material, options,
                                       MPI_COMM_WORLD);
    displacement = fem::make_vector(body->dofs());
    auto load = fem::make_vector(body->dofs());
    own_coupling(*body, grid).load({-traction.x, -traction.y, -traction.n}, load);
    fem::make_multigrid(body->problem(), {1e-9})->solve(displacement, load);
    displacement.update_ghost_values();
    locator = std::make_unique<fem::BodyLocator>(*body);
    stress = fem::StressRecovery(*body).recover(displacement);
  }

  std::vector<SymmetricTensor> recovered(const fem::BodyPoints& points) const {
    return fem::stress_at(points, stress);
  }

  /// The half-space under the same tractions on elements so small that their steps do not show.
  std::vector<SymmetricTensor> of_half_space(const std::vector<fem::Place>& places) const {
    const auto fine = contact::ContactGrid::centred(86, 86, 0.1, 0.1);
    std::vector<halfspace::SubsurfacePoint> points;
    for (const fem::Place& place : places) points.push_back({place[0], place[1], -place[2]});
    std::vector<SymmetricTensor> result;
    for (const auto& state :
         halfspace::subsurface_at({halfspace::Body::rail, material, fine, hertz(fine)}, points))
      result.push_back(state.stress);
    return result;
  }

  /// Largest difference of a component, in p0.
  static double largest_difference(const std::vector<SymmetricTensor>& one,
                                   const std::vector<SymmetricTensor>& other) {
    double largest = 0.0;
    for (std::size_t k = 0; k < one.size(); ++k)
      for (std::size_t c = 0; c < 6; ++c)
        largest = std::max(largest, std::abs(one[k][c] - other[k][c]) / p0);
    return largest;
  }

  double friction;
  int parts;
  contact::ContactGrid grid = contact::ContactGrid::centred(20, 20, cell, cell);
  contact::SurfaceField traction;
  std::unique_ptr<fem::Body> body;
  std::unique_ptr<fem::BodyLocator> locator;
  fem::Vector displacement;
  fem::NodalStress stress;
};

}  // namespace rollfem::testing
