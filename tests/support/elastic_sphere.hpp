// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic sphere of 405 mm pressed on a flat rail of the same steel with 50 kN: it slips without
// being driven. Lur'e's series for the sphere and the half-space for the rail give the amount
// (benchmarks/book/elastic_sphere.py).
#pragma once

#include "contact/iteration/compliance.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::testing {

struct ElasticSphere {
  static constexpr double radius = 405.0;
  static constexpr double semi_axis = 5.0868168;  ///< mm
  static constexpr double max_pressure = 922.6121;

  /// The slip in units of p0 a/(G R) at (x, y)/a, positive as creepage: a polynomial through the
  /// series, which it meets within 1e-3. For a/R to 0 it is 0.24740 - 0.04811 x^2 - 0.19929 y^2.
  static double exact_slip(double x, double y) { return 0.24021 - 0.0464 * x * x - 0.1993 * y * y; }

  double mean;   ///< weighted with the pressure, over that of the series
  double shape;  ///< root of the weighted mean of the squared difference, over the mean
  std::vector<double> along, across;  ///< slip beside the middle lines

  /// Slip under Hertz's pressure, from differences of the displacement from neighbour to neighbour:
  /// not the program's upwind difference.
  ElasticSphere(const contact::Compliance& compliance, const contact::ContactGrid& grid) {
    const contact::Field hertz = hertz_pressure(grid, semi_axis, semi_axis, max_pressure);
    const contact::Field none = contact::Field::Zero(grid.size());
    const contact::Response response = compliance.respond({none, none, hertz});
    const contact::Field& u = response.displacement.x;
    const double unit = max_pressure * semi_axis / radius / (210e3 / 2.6);
    double weight = 0.0, sum = 0.0, exact_sum = 0.0, squares = 0.0;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 1; i + 1 < grid.nx; ++i) {
        const int e = grid.index(i, j);
        const double stretch =
            (u[grid.index(i + 1, j)] - u[grid.index(i - 1, j)]) / (2.0 * grid.dx);
        const double slip = (response.curvature_slip.x[e] - stretch) / unit;
        const double exact = exact_slip(grid.x(i) / semi_axis, grid.y(j) / semi_axis);
        weight += hertz[e];
        sum += hertz[e] * slip;
        exact_sum += hertz[e] * exact;
        squares += hertz[e] * (slip - exact) * (slip - exact);
        if (j == grid.ny / 2) along.push_back(slip);
        if (i == grid.nx / 2) across.push_back(slip);
      }
    mean = sum / exact_sum;
    shape = std::sqrt(squares * weight) / exact_sum;
  }
};

}  // namespace rollfem::testing
