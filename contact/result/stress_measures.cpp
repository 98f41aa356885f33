// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/stress_measures.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace rollfem::contact {

double hydrostatic(const Stress& stress) {
  return (stress.xx + stress.yy + stress.zz) / 3.0;
}

double von_mises(const Stress& stress) {
  const double a = stress.xx - stress.yy;
  const double b = stress.yy - stress.zz;
  const double c = stress.zz - stress.xx;
  const double shear = stress.xy * stress.xy + stress.yz * stress.yz + stress.xz * stress.xz;
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * shear);
}

std::array<double, 3> principal(const Stress& stress) {
  Eigen::Matrix3d tensor;
  tensor << stress.xx, stress.xy, stress.xz,  //
      stress.xy, stress.yy, stress.yz,        //
      stress.xz, stress.yz, stress.zz;
  // The iterative solver, because the closed form loses half of the digits where two values
  // coincide, as on the axis of a circular contact.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d values = solver.eigenvalues();
  return {values[2], values[1], values[0]};
}

double tresca(const Stress& stress) {
  const std::array<double, 3> values = principal(stress);
  return values[0] - values[2];
}

double orthogonal_shear(const Stress& stress) {
  return std::hypot(stress.xz, stress.yz);
}

const std::array<StressMeasure, 4>& reported_measures() {
  static const std::array<StressMeasure, 4> measures{
      {{"von_mises", von_mises},
       {"tresca", tresca},
       {"orthogonal_shear", orthogonal_shear},
       {"principal_1", [](const Stress& stress) { return principal(stress)[0]; }}}};
  return measures;
}

}  // namespace rollfem::contact
