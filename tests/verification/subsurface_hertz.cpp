// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress below Hertzian contact: CONTACT's values of case a, the closed forms of the circle and of
// the line, with the order at which the grid converges to them.
#include "contact/base/pi.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/stress/subsurface.hpp"

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

/// Hertz for given F and A < B by bisection on the axis ratio (Johnson 1985, section 4.2).
struct Ellipse {
  double long_axis, short_axis, p0;
};
Ellipse hertz_ellipse(double A, double B, double modulus, double force) {
  double low = 1e-6, high = 1.0;  // short/long axis; B/A falls with it
  const auto curvature_ratio = [](double ratio) {
    const double k = std::sqrt(1.0 - ratio * ratio);
    const double K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
    return (E / (ratio * ratio) - K) / (K - E);
  };
  while (high - low > 1e-14)
    (curvature_ratio(0.5 * (low + high)) > B / A ? low : high) = 0.5 * (low + high);
  const double ratio = 0.5 * (low + high), k2 = 1.0 - ratio * ratio;
  const double K = std::comp_ellint_1(std::sqrt(k2)), E = std::comp_ellint_2(std::sqrt(k2));
  // A = (p0/E*) ratio (K - E)/(k2 a), p0 = 3F/(2 pi ratio a^2).
  const double a = std::cbrt(1.5 * force / (pi * modulus) * (K - E) / (k2 * A));
  return {a, ratio * a, 1.5 * force / (pi * ratio * a * a)};
}

}  // namespace

TEST(SubsurfaceHertz, CaseAOfContact) {
  const contact::Material steel{210e3, 0.3};
  const double modulus = contact::combine(steel, steel).contact_modulus;
  const Ellipse ellipse = hertz_ellipse(1.0 / 4000.0, 1.0 / 810.0, modulus, 50e3);
  EXPECT_NEAR(ellipse.p0, 578.97, 0.01);
  const LoadedBody body = hertzian(ellipse.short_axis, ellipse.long_axis, ellipse.p0, 0.3, 80);
  for (const case_a::Below& row : case_a::below) {
    const SubsurfaceState state = below(body, 0.0, 0.0, row.z);
    const contact::Stress& s = state.stress;
    const auto check = [&](double found, double expected) {
      EXPECT_NEAR(found, expected, 2e-4 * ellipse.p0) << "z = " << row.z;
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

TEST(SubsurfaceHertz, LineContactFromALongPatch) {
  // Elements of 2000 half widths: plane strain in the middle. Benchmark section 7.
  LoadedBody body;
  const int n = 100;
  body.material = {210e3, 0.3};
  body.grid = ContactGrid::centred(n, 1, 2.0 / n, 2000.0);
  body.traction.n =
      body.grid.sample([](double x, double) { return std::sqrt(std::max(0.0, 1.0 - x * x)); });
  for (const double z : {0.1, 0.5, 1.0, 2.0}) {
    const contact::Stress s = below(body, 0.0, 0.0, z).stress;
    const double root = std::sqrt(1.0 + z * z);
    EXPECT_NEAR(s.xx, -((1.0 + 2.0 * z * z) / root - 2.0 * z), 1e-3);
    EXPECT_NEAR(s.zz, -1.0 / root, 1e-3);
    EXPECT_NEAR(s.yy, 0.3 * (s.xx + s.zz), 1e-3);
  }
  const Maximum shear = maximise(
      [&](double z) { return 0.5 * contact::tresca(below(body, 0.0, 0.0, z).stress); }, 0.4, 1.2);
  EXPECT_NEAR(shear.value, 0.30028, 1e-3 * 0.30028);
  EXPECT_NEAR(shear.at, 0.78615, 3e-3);
  const Maximum mises = maximise(
      [&](double z) { return contact::von_mises(below(body, 0.0, 0.0, z).stress); }, 0.4, 1.2);
  EXPECT_NEAR(mises.value, 0.5575, 1e-3 * 0.5575);
  EXPECT_NEAR(mises.at, 0.704, 3e-3);
  const Maximum orthogonal =
      maximise([&](double x) { return contact::orthogonal_shear(below(body, x, 0.0, 0.5).stress); },
               0.5, 1.2);
  EXPECT_NEAR(orthogonal.value, 0.25, 1e-3 * 0.25);
  EXPECT_NEAR(orthogonal.at, 0.865, 3e-3);
}

TEST(SubsurfaceHertz, SlidingLineContact) {
  // Tangential traction q0 sqrt(1 - x^2) on the wheel, McEwen's fields (Johnson 1985, section 7.1):
  // on the surface inside the patch xx = -2 q0 x in the wheel and the opposite in the rail; below
  // the middle xz = -q0 [(1 + 2 z^2)/sqrt(1 + z^2) - 2 z] in both.
  const double q0 = 0.3;
  const auto errors = [&](halfspace::Body side, int n) {
    LoadedBody body;
    body.body = side;
    body.grid = ContactGrid::centred(n, 1, 2.0 / n, 2000.0);
    body.traction.x = body.grid.sample(
        [&](double x, double) { return q0 * std::sqrt(std::max(0.0, 1.0 - x * x)); });
    const double sign = side == halfspace::Body::wheel ? 1.0 : -1.0;
    std::array<double, 2> worst{};
    for (int i = 0; i < n; ++i) {
      const double x = body.grid.x(i);
      if (std::abs(x) > 0.7) continue;
      const double xx = below(body, x, 0.0, 0.0).stress.xx;
      worst[0] = std::max(worst[0], std::abs(xx + sign * 2.0 * q0 * x) / q0);
    }
    for (const double z : {0.1, 0.5, 1.5}) {
      const double exact = -q0 * ((1.0 + 2.0 * z * z) / std::sqrt(1.0 + z * z) - 2.0 * z);
      const double xz = below(body, 0.0, 0.0, z).stress.xz;
      worst[1] = std::max(worst[1], std::abs(xz - exact) / q0);
    }
    return worst;
  };
  for (const halfspace::Body side : {halfspace::Body::wheel, halfspace::Body::rail}) {
    const auto coarse = errors(side, 101), fine = errors(side, 404);
    EXPECT_LT(fine[0], 3e-3);
    EXPECT_LT(fine[1], 2e-4);
    EXPECT_GT(std::log(coarse[0] / fine[0]) / std::log(4.0), 0.9);
  }
}
