// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials of a smooth map are reproduced on any grid.
#include "hybrid/smooth_map.hpp"

#include "support/test.hpp"

namespace {

constexpr hybrid::SmoothBox box{4.0, 9.0, 1.5};

Field along(const ContactGrid& grid) {
  return grid.sample([](double x, double) { return x; });
}
Field across(const ContactGrid& grid) {
  return grid.sample([](double, double y) { return y; });
}

/// u_n = c (integral of p_x) x y^2, everything else 0; x and y in units of the box.
hybrid::SmoothMap one_entry(double c) {
  constexpr int degree = 3;
  const auto powers = hybrid::polynomial_powers(degree);
  const auto count = static_cast<Eigen::Index>(powers.size());
  hybrid::SmoothMap map{box, box, degree, degree, Eigen::MatrixXd::Zero(3 * count, 3 * count)};
  // x y^2 = T_1 (T_0 + T_2) / 2.
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& p = powers[static_cast<std::size_t>(k)];
    if (p[0] == 1 && (p[1] == 0 || p[1] == 2)) map.coefficients(2 * count + k, 0) = 0.5 * c;
  }
  return map;
}

}  // namespace

TEST(SmoothMap, PolynomialsAreChebyshevsOfTotalDegree) {
  const ContactGrid grid = ContactGrid::centred(5, 7, 1.3, 2.1, 0.2, 1.0);
  const auto powers = hybrid::polynomial_powers(4);
  ASSERT_EQ(powers.size(), 15u);
  const Eigen::MatrixXd values = hybrid::polynomials(box, 4, along(grid), across(grid));
  for (std::size_t k = 0; k < powers.size(); ++k)
    for (int e = 0; e < grid.size(); ++e) {
      const double x = std::min(1.0, std::max(-1.0, along(grid)[e] / box.half_length));
      const double y = (across(grid)[e] - box.middle) / box.half_width;
      if (std::abs(y) > 1.0) continue;
      EXPECT_NEAR(values(e, static_cast<Eigen::Index>(k)),
                  std::cos(powers[k][0] * std::acos(x)) * std::cos(powers[k][1] * std::acos(y)),
                  1e-12);
    }
}

TEST(SmoothMap, TakesMomentsAndGivesPolynomialsOnAnyGrid) {
  for (const int n : {8, 32}) {
    const ContactGrid grid = ContactGrid::centred(n, n, 8.0 / n, 18.0 / n, 0.0, 1.5);
    const hybrid::SmoothMapOnGrid map(one_entry(2e-7), grid);
    const Field none = Field::Zero(grid.size());
    const SurfaceField u = map.apply({Field::Constant(grid.size(), 10.0), none, none});
    EXPECT_EQ(u.x.cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ(u.y.cwiseAbs().maxCoeff(), 0.0);
    const double force = 10.0 * 8.0 * 18.0;
    for (int e = 0; e < grid.size(); ++e) {
      const double x = along(grid)[e] / box.half_length;
      const double y = (across(grid)[e] - box.middle) / box.half_width;
      EXPECT_NEAR(u.n[e], 2e-7 * force * x * y * y, 1e-15 * force);
    }
  }
}

TEST(SmoothMap, BeyondItsBoxItHasTheValuesOfTheNearestPlace) {
  // x y^2 would be 1000 times as large at ten times the box.
  const ContactGrid grid = ContactGrid::centred(41, 41, 2.0, 4.5, 0.0, 1.5);
  const hybrid::SmoothMapOnGrid map(one_entry(2e-7), grid);
  const Field none = Field::Zero(grid.size());
  SurfaceField load{none, none, none};
  load.x[grid.index(20, 20)] = 10.0;
  const double force = 10.0 * grid.element_area();
  const SurfaceField u = map.apply(load);
  for (int e = 0; e < grid.size(); ++e) {
    const double x = std::clamp(along(grid)[e] / box.half_length, -1.0, 1.0);
    const double y = std::clamp((across(grid)[e] - box.middle) / box.half_width, -1.0, 1.0);
    EXPECT_NEAR(u.n[e], 2e-7 * force * x * y * y, 1e-15 * force);
  }
}
