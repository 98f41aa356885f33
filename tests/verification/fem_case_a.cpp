// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element model on the thesis's case a, with cells of 0.47 mm: against exact Hertz and
// against CONTACT's extrapolated creep curve. This is the program's main job.
#include "fem/elasticity/fem_model.hpp"
#include "result/stress_measures.hpp"

#include "support/committed_cases.hpp"
#include "support/contact_laws.hpp"
#include "support/contact_of_case_a.hpp"
#include "support/mpi_environment.hpp"

namespace {

using namespace contact::component;

using case_a::coefficients, case_a::creepages;
constexpr double exact_p0 = case_a::p0, exact_a = case_a::semi_axis_x,
                 exact_b = case_a::semi_axis_y;

/// Of the wheel's surface under load at xi = 0, by a first-order perturbation of the half-space.
constexpr double slip_of_strain = 1.45e-5;

/// CONTACT's curve between its points, by the parabola through three of them.
double contact_at(double xi) {
  double x[7] = {0.0}, f[7] = {0.0};
  std::copy(std::begin(creepages), std::end(creepages), x + 1);
  std::copy(std::begin(coefficients), std::end(coefficients), f + 1);
  int k = 0;
  while (k < 4 && xi > x[k + 1]) ++k;
  const double one = (f[k + 1] - f[k]) / (x[k + 1] - x[k]);
  const double two = (f[k + 2] - f[k + 1]) / (x[k + 2] - x[k + 1]);
  return f[k] + (xi - x[k]) * (one + (xi - x[k + 1]) * (two - one) / (x[k + 2] - x[k]));
}

contact::Case case_with_stresses() {
  contact::Case input = committed_case("thesis_a");
  input.output.fields = false;
  input.output.stress_maxima = true;
  // Below the middle, in both bodies, where CONTACT's values are.
  for (const bool wheel : {true, false})
    for (const case_a::Below& row : case_a::below) {
      contact::SubsurfaceRequest request;
      request.wheel = wheel;
      request.from = {0.0, 0.0, wheel ? row.z : -row.z};
      input.subsurface.push_back(request);
    }
  return input;
}

/// Solved once for all tests of this program.
const contact::ModelResult& solution() {
  static const contact::ModelResult result = fem::run_fem(case_with_stresses(), {});
  return result;
}

/// Root mean square of the difference to Hertz's pressure where that exceeds half its maximum,
/// relative to p0.
double pressure_deviation(const contact::ModelResult& result) {
  const contact::Field& pressure = result.points.front().fields.traction.n;
  double sum = 0.0;
  int count = 0;
  for (int j = 0; j < result.grid.ny; ++j)
    for (int i = 0; i < result.grid.nx; ++i) {
      const double x = result.grid.x(i) / exact_a;
      const double y = result.grid.y(j) / exact_b;
      const double hertz = exact_p0 * std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
      if (hertz < 0.5 * exact_p0) continue;
      sum += std::pow(pressure[result.grid.index(i, j)] - hertz, 2);
      ++count;
    }
  return std::sqrt(sum / count) / exact_p0;
}

}  // namespace

TEST(FemCaseA, PressureAndPatchAgreeWithHertz) {
  const contact::PointResult& point = solution().points.front();
  EXPECT_NEAR(point.max_pressure / exact_p0, 1.0, 3e-3);
  EXPECT_NEAR(point.semi_axis_x / exact_a, 1.0, 1e-2);
  EXPECT_NEAR(point.semi_axis_y / exact_b, 1.0, 1e-2);
  EXPECT_LT(pressure_deviation(solution()), 8e-3);
}

TEST(FemCaseA, CreepCurveIsContactsMovedByTheStrainOfTheLoadedWheel) {
  const contact::ModelResult& result = solution();
  ASSERT_EQ(result.points.size(), 7u);
  // To first order in curvature a half-space bent to case a has a slip of 1.45e-5 at xi = 0 and a
  // coefficient of 0.0030; CONTACT's slope there makes 0.0033 of the slip.
  EXPECT_GT(result.points[0].traction_coefficient, 0.0030 - 3e-4);
  EXPECT_LT(result.points[0].traction_coefficient, 0.0033 + 4e-4);
  for (int k = 0; k < 6; ++k) {
    const contact::PointResult& point = result.points[k + 1];
    EXPECT_EQ(point.creepage.longitudinal, creepages[k]);
    // Beyond that slip: CONTACT's extrapolation (+-5e-4) and the grid, 0.2 % of mu. Flat bodies
    // have 0.0031 less at the first of them.
    EXPECT_NEAR(point.traction_coefficient, contact_at(creepages[k] + slip_of_strain), 1.4e-3)
        << "xi = " << creepages[k];
  }
  // 307.64 MPa: CONTACT at 160 elements across.
  EXPECT_NEAR(result.points[3].max_traction_x / 307.64, 1.0, 0.03);
}

TEST(FemCaseA, EveryPointIsInEquilibriumClosedUnderPressureAndWithinTheTractionBound) {
  const contact::ModelResult& result = solution();
  for (const contact::PointResult& point : result.points) {
    EXPECT_LE(point.iterations, 10);
    EXPECT_NEAR(point.normal_force / 50e3, 1.0, 1e-8);
    const contact::ContactFields& f = point.fields;
    for (int k = 0; k < result.grid.size(); ++k) {
      // Parabolas' distance and the displacement of the bodies, counted again; their circles are
      // 1e-4 of it off at the border of the grid.
      const double x = result.grid.x(k % result.grid.nx), y = result.grid.y(k / result.grid.nx);
      const double distance = x * x / (2.0 * 405.0) + y * y / (2.0 * 2000.0);
      const double gap = distance + f.displacement.n[k] - point.approach;
      EXPECT_NEAR(f.gap[k], gap, 2e-4 * distance + 1e-9);
    }
    expect_contact_laws(point, 0.55, exact_p0);
  }
}

TEST(FemCaseA, ErrorEstimatesCoverTheTrueErrorsAndAreOfTheirSize) {
  const contact::PointResult& point = solution().points.front();
  // Hertz's bodies are half-spaces. These are curved, b/R_y = 0.005 and a/R = 0.009, and end: less
  // than 0.1 % of difference, which is no error of theirs.
  const auto check = [&](const char* name, double value, double exact) {
    const double estimate = point.error_estimate.at(name);
    EXPECT_LE(std::abs(value - exact), estimate + 1e-3 * exact) << name;
    EXPECT_LT(estimate, 0.02 * exact) << name;
  };
  check("max_pressure", point.max_pressure, exact_p0);
  check("approach", point.approach, 0.0473108);
  // The far boundary moves as a half-space's: clamped it lacked 5 %.
  EXPECT_LT(point.error_estimate.at("approach"), 0.01 * point.approach);
  check("semi_axis_x", point.semi_axis_x, exact_a);
  check("semi_axis_y", point.semi_axis_y, exact_b);
}

TEST(FemCaseA, StressBelowTheMiddleAgreesWithContactWithinOnePercentOfThePressure) {
  // The first load point has no creepage: CONTACT's has no friction, ours all but none.
  const contact::PointResult& point = solution().points.front();
  ASSERT_EQ(point.subsurface.size(), 2 * std::size(case_a::below));
  for (std::size_t k = 0; k < point.subsurface.size(); ++k) {
    const case_a::Below& row = case_a::below[k % std::size(case_a::below)];
    const contact::SymmetricTensor s = point.subsurface[k].stress.front();
    const double differences[] = {s[xx] - row.xx,
                                  s[yy] - row.yy,
                                  s[zz] - row.zz,
                                  s[xy],
                                  s[yz],
                                  s[xz],
                                  contact::von_mises(s) - row.von_mises};
    for (const double difference : differences)
      EXPECT_LT(std::abs(difference), 0.01 * exact_p0) << "request " << k << ", depth " << row.z;
  }
}

TEST(FemCaseA, LargestStressesAreBelowTheMiddle) {
  // Hertz's largest von Mises stress by the half-space: 348.03 MPa at 2.532 mm.
  int found = 0;
  for (const contact::StressMaximum& maximum : solution().points.front().stress_maxima) {
    if (maximum.measure != "von_mises") continue;
    ++found;
    EXPECT_NEAR(maximum.value, 348.03, 0.01 * exact_p0);
    EXPECT_NEAR(std::abs(maximum.place[2]), 2.532, 0.02 * exact_a);
    EXPECT_LT(std::abs(maximum.place[0]), 0.1 * exact_a);
    EXPECT_EQ(maximum.place[2] > 0.0, maximum.body == "wheel");
  }
  EXPECT_EQ(found, 2);
}

TEST(FemCaseA, LateralForceVanishesAndTractionsMirrorInY) {
  const contact::ModelResult& result = solution();
  const contact::PointResult& point = result.points[3];
  // The iteration stops at 1e-4; nothing in it keeps the mirror symmetry exactly.
  const double tolerance = 1e-4 * point.max_traction_x;
  EXPECT_LT(std::abs(point.lateral_force), 1e-5 * point.normal_force);
  const contact::SurfaceField& p = point.fields.traction;
  for (int j = 0; j < result.grid.ny; ++j)
    for (int i = 0; i < result.grid.nx; ++i) {
      const int k = result.grid.index(i, j);
      const int image = result.grid.index(i, result.grid.ny - 1 - j);
      EXPECT_NEAR(p.x[k], p.x[image], tolerance);
      EXPECT_NEAR(p.y[k], -p.y[image], tolerance);
    }
}
