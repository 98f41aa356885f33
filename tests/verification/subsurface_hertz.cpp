// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress below Hertzian contact: CONTACT's values of case a, and the closed forms of the circle
// with the order at which the grid converges to them (of the line: line_stress.cpp).
#include "halfspace/stress/subsurface.hpp"
#include "scene/geometry.hpp"

#include "support/contact_of_case_a.hpp"

using halfspace::LoadedBody;
using halfspace::SubsurfaceState;

namespace {

/// Hertzian pressure with semi-axes a, b on n by n elements (average of 2 by 2 points each would
/// not converge faster: the edge decides).
LoadedBody hertzian(double a, double b, double p0, double nu, int n) {
  LoadedBody body;
  body.material = {210e3, nu};
  body.grid = ContactGrid::centred(n, n, 2.0 * a / n, 2.0 * b / n);
  body.traction.n = body.grid.sample([&](double x, double y) {
    return p0 * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a) - y * y / (b * b)));
  });
  return body;
}

SubsurfaceState below(const LoadedBody& body, double x, double y, double depth) {
  return halfspace::subsurface_at(body, {{x, y, depth}}).front();
}

/// Largest value on [low, high] of a function with one maximum, by golden section.
struct Maximum {
  double at = 0.0;
  double value = 0.0;
};
Maximum maximise(const std::function<double(double)>& function, double low, double high) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-5) {
    const double left = high - ratio * (high - low);
    const double right = low + ratio * (high - low);
    if (function(left) > function(right))
      high = right;
    else
      low = left;
  }
  return {0.5 * (low + high), function(0.5 * (low + high))};
}

}  // namespace

TEST(SubsurfaceHertz, CaseAOfContact) {
  const LoadedBody body = hertzian(case_a::semi_axis_x, case_a::semi_axis_y, case_a::p0, 0.3, 80);
  for (const case_a::Below& row : case_a::below) {
    const SubsurfaceState state = below(body, 0.0, 0.0, row.z);
    const contact::Stress& s = state.stress;
    const auto check = [&](double found, double expected) {
      EXPECT_NEAR(found, expected, 2e-4 * case_a::p0) << "z = " << row.z;
    };
    check(s.xx, row.xx);
    check(s.yy, row.yy);
    check(s.zz, row.zz);
    check(s.xy, 0.0);
    check(s.yz, 0.0);
    check(s.xz, 0.0);
    check(contact::hydrostatic(s), row.hydrostatic);
    check(contact::von_mises(s), row.von_mises);
    EXPECT_NEAR(state.displacement[2], row.uz, 5e-4 * row.uz);
  }
}

TEST(SubsurfaceHertz, StressOnTheAxisOfTheCircleConverges) {
  const double p0 = 1.0, nu = 0.3;
  const auto error = [&](int n) {
    const LoadedBody body = hertzian(1.0, 1.0, p0, nu, n);
    double worst = 0.0;
    for (const double z : {0.1, 0.25, 0.4809, 1.0, 2.0, 5.0}) {
      const contact::Stress s = below(body, 0.0, 0.0, z).stress;
      const double radial = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) + 0.5 / (1.0 + z * z);
      worst = std::max({worst, std::abs(s.xx - radial), std::abs(s.yy - radial),
                        std::abs(s.zz + 1.0 / (1.0 + z * z))});
    }
    return worst;
  };
  const double e20 = error(20), e80 = error(80);
  EXPECT_LT(e80, 1.5e-4);
  EXPECT_GT(std::log(e20 / e80) / std::log(4.0), 1.7);  // order
}

TEST(SubsurfaceHertz, LargestShearBelowTheCircle) {
  struct Row {
    double nu, shear, depth, von_mises;
  };
  for (const Row& row :
       {Row{0.25, 0.32168, 0.4643, 0.64336}, Row{0.28, 0.31465, 0.4742, 0.62929},
        Row{0.30, 0.31002, 0.4809, 0.62004}, Row{0.50, 0.26635, 0.5479, 0.53270}}) {
    const LoadedBody body = hertzian(1.0, 1.0, 1.0, row.nu, 80);
    const Maximum shear = maximise(
        [&](double z) { return 0.5 * contact::tresca(below(body, 0.0, 0.0, z).stress); }, 0.2, 1.0);
    EXPECT_NEAR(shear.value, row.shear, 1e-3 * row.shear);
    EXPECT_NEAR(shear.at, row.depth, 2e-3);
    const Maximum mises = maximise(
        [&](double z) { return contact::von_mises(below(body, 0.0, 0.0, z).stress); }, 0.2, 1.0);
    EXPECT_NEAR(mises.value, row.von_mises, 1e-3 * row.von_mises);
  }
}

TEST(SubsurfaceHertz, TensionOutsideTheCircle) {
  // On the surface: radial (1 - 2 nu) p0 a^2/(3 r^2), hoop the opposite; at the edge (1 - 2 nu)/3.
  // The row of elements through the middle, so that no point lies on an edge of an element.
  const double nu = 0.3;
  const int n = 81;
  const LoadedBody body = hertzian(1.0, 1.0, 1.0, nu, n);
  for (const double r : {1.05, 1.2, 1.5, 3.0}) {
    const contact::Stress s = below(body, r, 0.0, 0.0).stress;
    const double exact = (1.0 - 2.0 * nu) / (3.0 * r * r);
    EXPECT_NEAR(s.xx, exact, 5e-3 * exact + 1e-3) << r;
    EXPECT_NEAR(s.yy, -exact, 5e-3 * exact + 1e-3) << r;
    EXPECT_NEAR(s.zz, 0.0, 1e-14);
  }
  EXPECT_NEAR(below(body, 1.0 + 0.5 / n, 0.0, 0.0).stress.xx, (1.0 - 2.0 * nu) / 3.0, 6e-3);
}
