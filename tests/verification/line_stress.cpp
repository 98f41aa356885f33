// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress below a line contact in plane strain: McEwen's closed forms of Hertz's pressure and of
// sliding friction, antiplane shear, long elements of a half-space, and the crane wheel of R. L.
// Norton (Machine Design, example 7-2).
#include "case/reading/case_reader.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/stress_measures.hpp"

#include <fmt/format.h>

#include "support/half_space_models.hpp"
#include "support/random_field.hpp"
#include "support/temporary_folder.hpp"

namespace {

using contact::Stress;
using halfspace::LoadedBody;
using halfspace::SubsurfacePoint;

constexpr double nu = 0.28;

/// Stress over p0 under p0 sqrt(1 - x^2) and `friction` times this along +x on a half-width of 1
/// (McEwen; Johnson 1985, sections 4.2 and 7.1).
Stress mcewen(double x, double z, double friction, double poisson) {
  const double half = 1.0 - x * x + z * z, root = std::hypot(half, 2.0 * x * z);
  const double m = std::sqrt(0.5 * (root + half));
  const double n = std::copysign(std::sqrt(std::max(0.0, 0.5 * (root - half))), x);
  const double share = (z * z + n * n) / (m * m + n * n);
  const double xx = -m * (1.0 + share) + 2.0 * z, zz = -m * (1.0 - share);
  const double xz = n * (m * m - z * z) / (m * m + n * n);
  Stress s;
  s.xx = xx + friction * (n * (2.0 - (z * z - m * m) / (m * m + n * n)) - 2.0 * x);
  s.zz = zz - friction * xz;
  s.xz = -xz + friction * xx;
  s.yy = poisson * (s.xx + s.zz);
  return s;
}

/// Hertz's pressure on a half-width of 1, constant on each of n elements with its mean there, and
/// `friction` times it along x and `across` times along y on the wheel.
LoadedBody hertzian_line(int n, double friction, double across = 0.0) {
  LoadedBody body;
  body.material = {210e3, nu};
  body.grid = ContactGrid::centred(n, 1, 2.0 / n, 7.0);
  body.grid.line_reference = 100.0;
  const auto integral = [](double x) {
    const double t = std::clamp(x, -1.0, 1.0);
    return 0.5 * (t * std::sqrt(1.0 - t * t) + std::asin(t));
  };
  body.traction.n = body.grid.sample(
      [&](double x, double) { return 0.5 * n * (integral(x + 1.0 / n) - integral(x - 1.0 / n)); });
  body.traction.x = friction * body.traction.n;
  body.traction.y = across * body.traction.n;
  return body;
}

double largest_error(int n, double friction) {
  double worst = 0.0;
  const LoadedBody body = hertzian_line(n, friction);
  for (const double z : {0.1, 0.3, 0.786, 2.0, 20.0})
    for (const double x : {-1.6, -1.0, -0.37, 0.0, 0.8, 1.1, 12.0}) {
      const auto found = halfspace::subsurface_at(body, {{x, 3.3, z}}).front().stress.as_array();
      const auto exact = mcewen(x, z, friction, nu).as_array();
      for (std::size_t c = 0; c < 6; ++c) worst = std::max(worst, std::abs(found[c] - exact[c]));
    }
  return worst;
}

TEST(LineStress, IsMcEwensOfSecondOrder) {
  for (const double friction : {0.0, 0.2, 0.4}) {
    const double coarse = largest_error(50, friction), fine = largest_error(200, friction);
    EXPECT_LT(fine, 2e-4) << friction;
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.6) << friction;
  }
}

TEST(LineStress, OfTheCircleOfMohrIsTheKnownOne) {
  // Johnson 1985: 0.3003 p0 of shear at 0.786 a, on the axis; von Mises at nu = 0.3.
  LoadedBody body = hertzian_line(400, 0.0);
  const auto at = [&](double x, double z) {
    return halfspace::subsurface_at(body, {{x, 0.0, z}}).front().stress;
  };
  EXPECT_NEAR(contact::tresca(at(0.0, 0.786)), 0.6006, 1e-4);
  EXPECT_GT(contact::tresca(at(0.0, 0.786)), contact::tresca(at(0.0, 0.75)));
  EXPECT_GT(contact::tresca(at(0.0, 0.786)), contact::tresca(at(0.0, 0.82)));
  body.material.poisson_ratio = 0.3;
  EXPECT_NEAR(contact::von_mises(at(0.0, 0.704)), 0.5576, 1e-4);
  EXPECT_NEAR(at(0.866, 0.5).xz, -0.25, 1e-4);
}

TEST(LineStress, FrictionAcrossIsAntiplaneShear) {
  // yz + i xy is -q0 times the boundary value of sqrt(1 - w^2) + i w, w = x + i z.
  const LoadedBody body = hertzian_line(400, 0.0, 0.25);
  for (const double z : {0.2, 0.8})
    for (const double x : {-1.3, -0.4, 0.6}) {
      const std::complex<double> w(x, z);
      const std::complex<double> field =
          std::sqrt(1.0 - w * w) + std::complex<double>(0.0, 1.0) * w;
      const Stress s = halfspace::subsurface_at(body, {{x, 0.0, z}}).front().stress;
      EXPECT_NEAR(s.yz, -0.25 * field.real(), 1e-4) << x << ' ' << z;
      EXPECT_NEAR(s.xy, -0.25 * field.imag(), 1e-4) << x << ' ' << z;
    }
}

TEST(LineStress, IsThatOfLongElements) {
  // Any tractions, all components and the displacements of both bodies; the middle of elements as
  // long as the line's width, relative to distant points.
  for (const auto side : {halfspace::Body::wheel, halfspace::Body::rail}) {
    LoadedBody strips{side, {180e3, 0.33}, ContactGrid::centred(9, 1, 0.3, 2e5), {}};
    strips.traction = random_field(strips.grid, 11);
    LoadedBody line = strips;
    line.grid.line_reference = contact::infinity;
    std::vector<SubsurfacePoint> points{{0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}};
    for (const double z : {0.05, 0.7, 3.0})
      for (const double x : {-2.0, -0.45, 0.1, 1.9}) points.push_back({x, 0.0, z});
    const auto one = halfspace::subsurface_at(line, points);
    const auto other = halfspace::subsurface_at(strips, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      SCOPED_TRACE(k);
      const auto a = one[k].stress.as_array(), b = other[k].stress.as_array();
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a[c], b[c], 1e-6);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(one[k].displacement[c], other[k].displacement[c], 1e-9);
    }
  }
}

/// Norton's crane wheel on `width` mm of a flat rail.
std::string crane_wheel(double width, const std::string& load, const std::string& more = "") {
  const std::string steel = "young_modulus = 206843.0\npoisson_ratio = 0.28\n";
  return fmt::format(
             "[geometry]\nshape = \"line\"\nwidth = {}\n[load]\n{}\n[friction]\n"
             "coefficient = 0.3\n[wheel]\nrolling_radius = 152.4\n{}[rail]\n{}",
             width, load, steel, steel) +
         more;
}

std::string force_on(double width) {
  return fmt::format("normal_force = {:.12g}", 22241.11 / 22.225 * width);
}

ModelResult solved(const std::string& text) {
  return rollfem::testing::half_space_models().run(
      "halfspace", contact::Scene(contact::parse_case(text, "crane.toml")), {});
}

TEST(LineStress, BelowNortonsCraneWheelOfAnyWidth) {
  for (const double width : {1.0, 22.225}) {
    SCOPED_TRACE(width);
    const PointResult point =
        solved(crane_wheel(width, force_on(width),
                           "[output]\nstress_maxima = true\n[[subsurface.line]]\nbody = \"rail\"\n"
                           "from = [0, 0, 0]\nto = [0, 0, -2]\npoints = 5\n"))
            .points.front();
    const double p0 = 484.31, a = 1.3157;
    for (const contact::StressMaximum& maximum : point.stress_maxima) {
      SCOPED_TRACE(maximum.body + " " + maximum.measure);
      const double over = maximum.value / p0;
      EXPECT_EQ(maximum.place[1], 0.0);
      const std::string bar = "max_" + maximum.measure + "_" + maximum.body;
      const auto expect = [&](double exact) {
        EXPECT_NEAR(over, exact, 2e-3);
        EXPECT_NEAR(maximum.value, exact * p0, point.error_estimate.at(bar));
      };
      if (maximum.measure == "tresca") {
        expect(0.6006);
        EXPECT_NEAR(std::abs(maximum.place[2]), 0.786 * a, 0.02 * a);
      }
      if (maximum.measure == "von_mises") {
        const double z = std::abs(maximum.place[2]) / a;
        expect(contact::von_mises(mcewen(0.0, z, 0.0, nu)));
      }
      if (maximum.measure == "orthogonal_shear") expect(0.25);
      if (maximum.measure == "xz_range") expect(0.5);
      if (maximum.measure == "principal_1") {
        EXPECT_LT(over, 5e-3);
      }
    }
    for (std::size_t k = 1; k < 5; ++k) {
      const auto exact = mcewen(0.0, 0.5 * static_cast<double>(k) / a, 0.0, nu).as_array();
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(point.subsurface.front().stress[k][c] / p0, exact[c], 2e-3);
    }
  }
}

TEST(LineStress, DisplacementsAddUpToTheApproach) {
  const std::string places =
      "[[subsurface.point]]\nbody = \"wheel\"\nat = [0, 0, 0]\n"
      "[[subsurface.point]]\nbody = \"rail\"\nat = [0, 0, 0]\n";
  for (const char* reference : {"reference_distance = 400.0\n", "reference_distance = inf\n"}) {
    std::string text = crane_wheel(22.225, force_on(22.225), places);
    text.insert(text.find("width"), reference);
    const PointResult point = solved(text).points.front();
    const double together =
        point.subsurface[0].displacement[0][2] - point.subsurface[1].displacement[0][2];
    EXPECT_NEAR(together / point.approach, 1.0, 2e-4) << reference;
  }
}

TEST(LineLoad, ApproachAndLargestPressureGiveHertzsForce) {
  for (const char* reference : {"", "reference_distance = inf\n"}) {
    std::string by_force = crane_wheel(22.225, force_on(22.225));
    by_force.insert(by_force.find("width"), reference);
    const PointResult given = solved(by_force).points.front();
    std::string text = crane_wheel(22.225, fmt::format("approach = {:.12g}", given.approach));
    text.insert(text.find("width"), reference);
    const PointResult pressed = solved(text).points.front();
    EXPECT_NEAR(pressed.normal_force / 22241.11, 1.0, 1e-5) << reference;
    EXPECT_EQ(pressed.error_estimate.count("approach"), 0U);
  }
  const PointResult stated = solved(crane_wheel(22.225, "max_pressure = 484.31")).points.front();
  EXPECT_NEAR(stated.normal_force / 22241.11, 1.0, 2e-4);  // Norton's digits
  EXPECT_NEAR(stated.max_pressure, 484.31, stated.error_estimate.at("max_pressure"));
}

TEST(LineLoad, LargestPressureOfEllipsesIsHertzs) {
  for (const double radius : {60.0, 450.0, 3000.0}) {
    const std::string text = fmt::format(
        "[load]\nmax_pressure = 1200.0\n[friction]\ncoefficient = 0.3\n[wheel]\nrolling_radius = "
        "450.0\ntransverse_radius = inf\n[rail]\ntransverse_radius = {}\n",
        radius);
    const PointResult point = solved(text).points.front();
    EXPECT_NEAR(point.max_pressure, 1200.0, point.error_estimate.at("max_pressure"));
    EXPECT_NEAR(point.max_pressure, 1200.0, 2.0);
    // p0 = 3 F/(2 pi a b), and the circle's a = pi p0 R/(2 E*).
    const double pressure =
        1.5 * point.normal_force / (M_PI * point.semi_axis_x * point.semi_axis_y);
    EXPECT_NEAR(pressure, 1200.0, 12.0);
    if (radius != 450.0) continue;
    const double a = 0.5 * M_PI * 1200.0 * 450.0 / (210e3 / (2.0 * (1.0 - 0.3 * 0.3)));
    EXPECT_NEAR(point.normal_force / (2.0 / 3.0 * M_PI * a * a * 1200.0), 1.0, 1e-9);
  }
}

}  // namespace
