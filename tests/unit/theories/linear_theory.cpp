// Kalker's coefficients: the table, between its entries, beyond it; the forces that follow.
#include "contact/base/errors.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "theories/brush.hpp"
#include "theories/vermeulen_johnson.hpp"

#include <gtest/gtest.h>

#include "support/thesis_cases.hpp"
#include <array>
#include <cmath>
#include <vector>

namespace rollfem::theories {

using namespace halfspace;
namespace {

struct Entry {
  double a, b, nu, c11, c22, c23, c33;
};

TEST(KalkerCoefficients, AreTheTabulatedOnesAtItsEntries) {
  // Kalker 1990, table E.3.
  for (const Entry& e :
       {Entry{1, 10, 0.0, 2.51, 2.51, 0.334, 6.42}, Entry{3, 10, 0.25, 3.44, 2.75, 0.715, 2.96},
        Entry{1, 1, 0.0, 3.40, 3.40, 1.33, 1.21}, Entry{1, 1, 0.25, 4.12, 3.67, 1.47, 1.19},
        Entry{1, 1, 0.5, 5.20, 3.98, 1.63, 1.16}, Entry{2, 1, 0.25, 5.10, 4.90, 2.62, 0.819},
        Entry{10, 7, 0.5, 5.58, 4.67, 2.18, 0.852}, Entry{10, 1, 0.5, 12.9, 16.0, 18.0, 0.228}}) {
    const KalkerCoefficients k = kalker_coefficients(e.a, e.b, e.nu);
    EXPECT_NEAR(k.c11, e.c11, 1e-12 * e.c11) << e.a << "/" << e.b << " nu " << e.nu;
    EXPECT_NEAR(k.c22, e.c22, 1e-12 * e.c22);
    EXPECT_NEAR(k.c23, e.c23, 1e-12 * e.c23);
    EXPECT_NEAR(k.c33, e.c33, 1e-12 * e.c33);
  }
}

TEST(KalkerCoefficients, TakeTheParabolaOfTheReciprocalBetweenPoissonsRatios) {
  // nu = 0.3 on the circle by hand: Lagrange weights -0.08, 0.96, 0.12.
  const double reciprocal = -0.08 / 3.40 + 0.96 / 4.12 + 0.12 / 5.20;
  EXPECT_NEAR(kalker_coefficients(6, 6, 0.3).c11, 1.0 / reciprocal, 1e-12);
}

TEST(KalkerCoefficients, AreContinuousInTheAspectRatio) {
  for (const double nu : {0.0, 0.13, 0.3, 0.5})
    for (const double ratio : {0.1, 0.3, 1.0, 10.0 / 3.0, 10.0}) {
      const KalkerCoefficients below = kalker_coefficients(ratio * (1 - 1e-9), 1, nu);
      const KalkerCoefficients above = kalker_coefficients(ratio * (1 + 1e-9), 1, nu);
      EXPECT_NEAR(below.c11 / above.c11, 1.0, 1e-7) << "a/b " << ratio << " nu " << nu;
      EXPECT_NEAR(below.c22 / above.c22, 1.0, 1e-7) << "a/b " << ratio << " nu " << nu;
      EXPECT_NEAR(below.c23 / above.c23, 1.0, 1e-7) << "a/b " << ratio << " nu " << nu;
      EXPECT_NEAR(below.c33 / above.c33, 1.0, 1e-7) << "a/b " << ratio << " nu " << nu;
    }
}

/// Kalker 1990, table E.3, for a/b -> 0 when a < b and for b/a -> 0 otherwise.
KalkerCoefficients asymptotes(double a, double b, double nu) {
  const double pi = std::acos(-1.0);
  if (a < b) {
    const double g = a / b;
    return {pi * pi / 4 / (1 - nu), pi * pi / 4,
            pi * std::sqrt(g) / 3 / (1 - nu) * (1 + nu * (std::log(16 / g) - 5)),
            pi * pi / 16 / (1 - nu) / g};
  }
  const double g = b / a;
  const double log = std::log(16 / (g * g));
  const double top = 3 - std::log(4.0);
  const double turning = (1 - nu) * log - 2 + 4 * nu;
  return {2 * pi / (log - 2 * nu) / g * (1 + top / (log - 2 * nu)),
          2 * pi / g * (1 + (1 - nu) * top / ((1 - nu) * log + 2 * nu)) / ((1 - nu) * log + 2 * nu),
          2 * pi / 3 / std::pow(g, 1.5) / turning, pi / 4 * (1 - nu * (log - 2) / turning)};
}

TEST(KalkerCoefficients, MeetTheAsymptotes) {
  const auto compare = [](double ratio, double nu, const std::array<double, 4>& tolerance) {
    for (const auto& [a, b] : {std::array{ratio, 1.0}, std::array{1.0, ratio}}) {
      const KalkerCoefficients k = kalker_coefficients(a, b, nu);
      const KalkerCoefficients limit = asymptotes(a, b, nu);
      EXPECT_NEAR(limit.c11 / k.c11, 1.0, tolerance[0]) << a << "/" << b << " nu " << nu;
      EXPECT_NEAR(limit.c22 / k.c22, 1.0, tolerance[1]) << a << "/" << b << " nu " << nu;
      EXPECT_NEAR(limit.c23 / k.c23, 1.0, tolerance[2]) << a << "/" << b << " nu " << nu;
      EXPECT_NEAR(limit.c33 / k.c33, 1.0, tolerance[3]) << a << "/" << b << " nu " << nu;
    }
  };
  for (const double nu : {0.0, 0.25, 0.5}) {
    // The table and the asymptotes are independent: at a ratio of 0.1 they agree to a few per cent.
    compare(0.1, nu, {0.05, 0.03, 0.06, 0.12});
    compare(1e-5, nu, {2e-5, 2e-5, 2e-5, 2e-5});
  }
}

TEST(KalkerCoefficients, TendToTheLineContact) {
  // a/b -> 0: F_x = -G a b C11 xi is Carter's slope -(pi/2) a G/(1 - nu) on strips of the ellipse.
  const double nu = 0.3;
  const double pi = std::acos(-1.0);
  const KalkerCoefficients k = kalker_coefficients(1e-5, 1.0, nu);
  EXPECT_NEAR(k.c11, pi * pi / (4.0 * (1.0 - nu)), 1e-5);
  EXPECT_NEAR(k.c22, pi * pi / 4.0, 1e-5);
}

TEST(KalkerCoefficients, RiseWithTheLengthOfThePatch) {
  // C22 and C23 rise over five decades, C33 falls as far as the table goes: no axis is exchanged.
  for (const double nu : {0.0, 0.25, 0.4, 0.5}) {
    KalkerCoefficients before = kalker_coefficients(0.003, 1.0, nu);
    for (double ratio = 0.004; ratio < 300.0; ratio *= 1.07) {
      const KalkerCoefficients k = kalker_coefficients(ratio, 1.0, nu);
      EXPECT_GT(k.c22, before.c22) << ratio << " nu " << nu;
      EXPECT_GT(k.c23, before.c23) << ratio << " nu " << nu;
      if (ratio < 10.0) {
        EXPECT_LT(k.c33, before.c33) << ratio << " nu " << nu;
      }
      before = k;
    }
  }
}

TEST(KalkerCoefficients, RefuseWhatIsNoEllipse) {
  EXPECT_THROW(kalker_coefficients(0.0, 1.0, 0.3), contact::InputError);
  EXPECT_THROW(kalker_coefficients(1.0, INFINITY, 0.3), contact::InputError);
  EXPECT_THROW(kalker_coefficients(1.0, 1.0, 0.51), contact::InputError);
  EXPECT_THROW(kalker_coefficients(1.0, 1.0, NAN), contact::InputError);
}

TEST(LinearTheory, HasTheSignsOfForcesOnTheWheel) {
  const CreepForces braking = linear_creep_forces(6, 6, 82000, 0.25, {1e-4, 0, 0});
  EXPECT_NEAR(braking.longitudinal, -82000 * 36 * 4.12e-4, 1e-9);
  const CreepForces sideways = linear_creep_forces(6, 6, 82000, 0.25, {0, 1e-4, 0});
  EXPECT_NEAR(sideways.lateral, -82000 * 36 * 3.67e-4, 1e-9);
  EXPECT_NEAR(sideways.spin_moment, 82000 * 216 * 1.47e-4, 1e-8);
  const CreepForces turning = linear_creep_forces(6, 6, 82000, 0.25, {0, 0, 1e-4});
  EXPECT_NEAR(turning.lateral, -82000 * 216 * 1.47e-4, 1e-8);
  EXPECT_NEAR(turning.spin_moment, -82000.0 * 1296 * 1.19e-4, 1e-7);
}

TEST(LinearTheory, ModelHasTractionsWithTheForcesOfTheCoefficients) {
  contact::Case input = testing::thesis_case('b');
  input.rolling.creepages = {{1e-4, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e-5}};
  input.contact_grid.elements_across = 80;
  const contact::ModelResult result = run_linear(input, {});
  ASSERT_EQ(result.points.size(), 3u);
  for (const contact::PointResult& point : result.points) {
    const double area = result.grid.element_area();
    const double size = std::hypot(point.longitudinal_force, point.lateral_force);
    EXPECT_NEAR(area * point.fields.traction.x.sum(), point.longitudinal_force, 2e-3 * size);
    EXPECT_NEAR(area * point.fields.traction.y.sum(), point.lateral_force, 2e-3 * size);
  }
  EXPECT_GT(result.points[0].traction_coefficient, 0.0);
}

TEST(LinearTheory, ModelRefusesExtraSlipFromAFile) {
  contact::Case input = testing::thesis_case('b');
  input.rolling.extra_slip = contact::ExtraSlip::file;
  input.rolling.extra_slip_values = contact::Lattice{"slip.csv", 4, 4, -20, -20, 13, 13, {}};
  input.rolling.extra_slip_values->values.assign(2, std::vector<double>(16, 1e-4));
  EXPECT_THROW(run_linear(input, {}), contact::InputError);
}

}  // namespace
}  // namespace rollfem::theories
