// SPDX-License-Identifier: LGPL-2.1-or-later
// Anderson acceleration: exact for linear maps once its depth spans the space, and plain iteration
// at depth 0.
#include "contact/iteration/anderson.hpp"

#include <Eigen/Dense>

#include "support/test.hpp"

namespace {

/// d <- M d + c with eigenvalues 0.9, -0.7, 0.5: the plain iteration gains a decimal in 22 steps.
struct LinearMap {
  Eigen::Matrix3d matrix;
  Eigen::Vector3d constant{1.0, -2.0, 0.5};

  LinearMap() {
    Eigen::Matrix3d basis;
    basis << 1.0, 0.3, 0.0, -0.2, 1.0, 0.4, 0.1, 0.0, 1.0;
    matrix = basis * Eigen::Vector3d(0.9, -0.7, 0.5).asDiagonal() * basis.inverse();
  }
  Eigen::VectorXd operator()(const Eigen::VectorXd& d) const { return matrix * d + constant; }
  Eigen::Vector3d fixed_point() const {
    return (Eigen::Matrix3d::Identity() - matrix).lu().solve(constant);
  }
};

double error_after(int steps, int depth) {
  const LinearMap map;
  Anderson anderson(depth);
  Eigen::VectorXd iterate = Eigen::VectorXd::Zero(3);
  for (int k = 0; k < steps; ++k) iterate = anderson.next(iterate, map(iterate));
  return (iterate - map.fixed_point()).norm() / map.fixed_point().norm();
}

}  // namespace

TEST(Anderson, SolvesALinearProblemInAsManyStepsAsItHasDimensions) {
  EXPECT_LT(error_after(5, 3), 1e-9);
}

TEST(Anderson, DepthZeroIsThePlainIteration) {
  const LinearMap map;
  Anderson anderson(0);
  Eigen::VectorXd iterate = Eigen::VectorXd::Zero(3);
  for (int k = 0; k < 4; ++k) {
    const Eigen::VectorXd image = map(iterate);
    EXPECT_EQ((anderson.next(iterate, image) - image).norm(), 0.0);
    iterate = image;
  }
  EXPECT_GT(error_after(5, 0), 1e-2);
}

TEST(Anderson, ARestartForgets) {
  const LinearMap map;
  Anderson anderson(3);
  Eigen::VectorXd iterate = Eigen::VectorXd::Zero(3);
  for (int k = 0; k < 3; ++k) iterate = anderson.next(iterate, map(iterate));
  anderson.restart();
  const Eigen::VectorXd image = map(iterate);
  EXPECT_EQ((anderson.next(iterate, image) - image).norm(), 0.0);
}
