// Tables of rolling on ellipses: every point is what it is alone, and full sliding and small
// creepage are what theory says.
#include "halfspace/model/many.hpp"

#include "contact/base/errors.hpp"
#include "halfspace/closed_forms/kalker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace rollfem;
using halfspace::CreepPoint;
using halfspace::EllipseShape;
using halfspace::ManyForces;
using halfspace::ManyOptions;

ManyOptions coarse(int threads) {
  ManyOptions options;
  options.most_across = 20;
  options.threads = threads;
  return options;
}

/// Neighbours in turn, on three ellipses, more than one chain of the second.
std::vector<CreepPoint> some_points() {
  std::vector<CreepPoint> points;
  for (int k = 0; k < 90; ++k) {
    const std::size_t shape = k < 10 ? 0 : k < 80 ? 1 : 2;
    const double s = 0.01 + 0.005 * k;
    points.push_back({shape, s, 0.3 * s - 0.02, 0.2 - 0.004 * k});
  }
  return points;
}

const std::vector<EllipseShape> three{{0.3, 0.28}, {1.0, 0.28}, {4.0, 0.25}};

TEST(SolveMany, IsEachPointAloneWhateverTheThreads) {
  const std::vector<CreepPoint> points = some_points();
  const auto together = halfspace::solve_many(three, points, coarse(1));
  const auto threaded = halfspace::solve_many(three, points, coarse(3));
  ASSERT_EQ(together.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(together[k].limit.longitudinal, threaded[k].limit.longitudinal) << k;
    EXPECT_EQ(together[k].limit.spin_moment, threaded[k].limit.spin_moment) << k;
    const ManyForces alone = halfspace::solve_many(three, {points[k]}, coarse(1))[0];
    EXPECT_NEAR(together[k].limit.longitudinal, alone.limit.longitudinal, 1e-10) << k;
    EXPECT_NEAR(together[k].limit.lateral, alone.limit.lateral, 1e-10) << k;
    EXPECT_NEAR(together[k].limit.spin_moment, alone.limit.spin_moment, 1e-10) << k;
  }
}

TEST(SolveMany, SmallCreepageIsKalkersLinearTheory) {
  for (const double ratio : {0.3, 1.0, 3.0}) {
    const double a = std::sqrt(ratio);
    constexpr double nu = 0.25;  // a value of the table: nothing is interpolated
    const auto c = halfspace::kalker_coefficients(a, 1.0 / a, nu);
    constexpr double small = 2e-3;
    const auto forces =
        halfspace::solve_many({{ratio, nu}}, {{0, small, 0.0, 0.0}, {0, 0.0, small, 0.0}});
    EXPECT_NEAR(forces[0].limit.longitudinal / (-c.c11 * small), 1.0, 0.015) << ratio;
    EXPECT_NEAR(forces[1].limit.lateral / (-c.c22 * small), 1.0, 0.015) << ratio;
  }
}

TEST(SolveMany, FullSlidingIsTheBoundOfFriction) {
  for (const double ratio : {0.1, 10.0}) {
    const auto forces = halfspace::solve_many({{ratio, 0.28}}, {{0, 3e5, 4e5, 0.0}});
    EXPECT_NEAR(forces[0].limit.longitudinal, -0.6, 1e-6);
    EXPECT_NEAR(forces[0].limit.lateral, -0.8, 1e-6);
  }
}

TEST(SolveMany, RefusesWhatItCannotSolve) {
  EXPECT_THROW(halfspace::solve_many({{0.0, 0.28}}, {}), contact::InputError);
  EXPECT_THROW(halfspace::solve_many({{1.0, 0.6}}, {}), contact::InputError);
  EXPECT_THROW(halfspace::solve_many({{1.0, 0.3}}, {{1, 0.1, 0.0, 0.0}}), contact::InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(halfspace::solve_many({{1.0, 0.3}}, {{0, nan, 0.0, 0.0}}), contact::InputError);
  EXPECT_THROW(halfspace::solve_many({{1.0, 0.3}}, {}, {0.003, 10, 1}), contact::InputError);
}

}  // namespace
