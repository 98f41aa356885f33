// SPDX-License-Identifier: LGPL-2.1-or-later
// Scalar measures of a stress tensor against states whose values are known by hand.
#include "result/stress_measures.hpp"

#include <Eigen/Geometry>

#include "support/test.hpp"

namespace {

using namespace contact::component;

SymmetricTensor rotated(const SymmetricTensor& s, const Eigen::Matrix3d& q) {
  Eigen::Matrix3d tensor;
  tensor << s[xx], s[xy], s[xz], s[xy], s[yy], s[yz], s[xz], s[yz], s[zz];
  const Eigen::Matrix3d t = q * tensor * q.transpose();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

}  // namespace

TEST(StressMeasures, UniaxialTensionIsItsOwnEquivalentStress) {
  const SymmetricTensor stress{0.0, 120.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_NEAR(von_mises(stress), 120.0, 1e-12);
  EXPECT_NEAR(tresca(stress), 120.0, 1e-12);
  EXPECT_NEAR(hydrostatic(stress), 40.0, 1e-12);
  EXPECT_EQ(orthogonal_shear(stress), 0.0);
}

TEST(StressMeasures, PureShear) {
  const SymmetricTensor stress{0.0, 0.0, 0.0, 0.0, 3.0, 4.0};
  EXPECT_NEAR(von_mises(stress), 5.0 * std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(tresca(stress), 10.0, 1e-13);
  EXPECT_NEAR(orthogonal_shear(stress), 5.0, 1e-13);
  EXPECT_NEAR(principal(stress)[0], 5.0, 1e-13);
  EXPECT_NEAR(principal(stress)[1], 0.0, 1e-13);
  EXPECT_NEAR(principal(stress)[2], -5.0, 1e-13);
}

TEST(StressMeasures, HydrostaticPressureHasNoEquivalentStress) {
  const SymmetricTensor stress{-700.0, -700.0, -700.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(von_mises(stress), 0.0);
  EXPECT_NEAR(tresca(stress), 0.0, 1e-12);
  EXPECT_NEAR(hydrostatic(stress), -700.0, 1e-12);
}

TEST(StressMeasures, PrincipalStressesSurviveRotationAndCoincidence) {
  const Eigen::Matrix3d q =
      (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized())).toRotationMatrix();
  for (const SymmetricTensor& diagonal : {SymmetricTensor{-300.0, -900.0, 50.0, 0.0, 0.0, 0.0},
                                          SymmetricTensor{-300.0, -300.0, -900.0, 0.0, 0.0, 0.0}}) {
    const SymmetricTensor stress = rotated(diagonal, q);
    const auto expected = principal(diagonal);
    const auto found = principal(stress);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12 * 900.0);
    EXPECT_NEAR(von_mises(stress), von_mises(diagonal), 1e-10);
    EXPECT_NEAR(hydrostatic(stress), hydrostatic(diagonal), 1e-10);
    // Von Mises lies between sqrt(3)/2 and 1 times Tresca.
    EXPECT_LE(von_mises(stress), tresca(stress) * (1.0 + 1e-12));
    EXPECT_GE(von_mises(stress), 0.5 * std::sqrt(3.0) * tresca(stress) * (1.0 - 1e-12));
  }
}
