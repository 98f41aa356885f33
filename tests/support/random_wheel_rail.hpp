// SPDX-License-Identifier: LGPL-2.1-or-later
// Random wheels on random rails, each from a seed and its number, for the coverage of error bars of
// models with finite bodies. One load point each, outside the family of cases a to f.
#pragma once

#include "case/case.hpp"

#include "tests/support/random_draws.hpp"
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rollfem::testing {

/// Two points in each body, where stresses are large, of a patch with these semi-axes in mm.
inline std::vector<contact::SubsurfaceRequest> points_below(double semi_axis_x,
                                                            double semi_axis_y) {
  std::vector<contact::SubsurfaceRequest> requests;
  for (const bool wheel : {true, false})
    for (const double depth : {0.5, 1.0}) {
      contact::SubsurfaceRequest request;
      request.wheel = wheel;
      const double z = depth * std::min(semi_axis_x, semi_axis_y);
      request.from = {0.2 * semi_axis_x, -0.3 * semi_axis_y, wheel ? z : -z};
      requests.push_back(request);
    }
  return requests;
}

class RandomWheelRail : private RandomDraws {
 public:
  explicit RandomWheelRail(unsigned seed) : RandomDraws(seed) {}

  /// Curvatures along and across differ by a factor of 6 at most; half of the contacts are driven
  /// along rolling alone, and so are symmetric.
  contact::Case contact(unsigned number) {
    begin(number);
    contact::Case input;
    input.title = input.file = "random contact " + std::to_string(number);
    draw_radii(input);
    input.load.normal_force = log_uniform(5e3, 100e3);
    input.friction_coefficient = uniform(0.1, 0.6);
    input.wheel.material = {210e3, uniform(0.2, 0.4)};
    input.rail.material = {chance(0.8) ? 210e3 : 70e3, uniform(0.2, 0.4)};
    contact::Creepage& creepage = input.rolling.creepages.front();
    creepage.longitudinal = sign() * log_uniform(2e-4, 5e-3);
    if (chance(0.5)) {
      creepage.lateral = uniform(-2e-3, 2e-3);
      creepage.spin = uniform(-3e-4, 3e-4);
    }
    input.output.fields = false;
    return input;
  }

 private:
  void draw_radii(contact::Case& input) {
    constexpr double most = 6.0;
    double ratio = 0.0;
    while (!(ratio > 1.0 / most && ratio < most)) {
      const double wheel = uniform(300.0, 500.0), rail = log_uniform(60.0, 2000.0);
      const double kind = uniform(0.0, 3.0);
      const double side = kind < 1.0   ? contact::infinity
                          : kind < 2.0 ? log_uniform(150.0, 2000.0)
                                       : -rail * uniform(1.3, 6.0);
      input.wheel.rolling_radius = wheel;
      input.wheel.transverse_radius = side;
      input.rail.transverse_radius = rail;
      ratio = (1.0 / rail + 1.0 / side) * wheel;
    }
  }
};

}  // namespace rollfem::testing
