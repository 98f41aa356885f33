// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/stress_measures.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace rollfem::contact {

namespace {

using Eigen::Matrix3d;
using namespace component;

Matrix3d tensor_of(const SymmetricTensor& s) {
  Matrix3d tensor;
  tensor << s[xx], s[xy], s[xz], s[xy], s[yy], s[yz], s[xz], s[yz], s[zz];
  return tensor;
}

/// A row for each axis.
Matrix3d rows_of(const Axes& axes) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(axes[0].data());
}

/// A column for each axis.
Matrix3d columns_of(const Axes& axes) {
  return Eigen::Map<const Matrix3d>(axes[0].data());
}

std::array<double, 3> turned(const Matrix3d& q, const std::array<double, 3>& vector) {
  const Eigen::Vector3d result = q * Eigen::Map<const Eigen::Vector3d>(vector.data());
  return {result[0], result[1], result[2]};
}

/// q stress q'
SymmetricTensor turned(const Matrix3d& q, const SymmetricTensor& stress) {
  const Matrix3d t = q * tensor_of(stress) * q.transpose();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

}  // namespace

double hydrostatic(const SymmetricTensor& stress) {
  return trace(stress) / 3.0;
}

double von_mises(const SymmetricTensor& stress) {
  const double a = stress[xx] - stress[yy];
  const double b = stress[yy] - stress[zz];
  const double c = stress[zz] - stress[xx];
  const double shear = stress[xy] * stress[xy] + stress[yz] * stress[yz] + stress[xz] * stress[xz];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * shear);
}

std::array<double, 3> principal(const SymmetricTensor& stress) {
  // The iterative solver, because the closed form loses half of the digits where two values
  // coincide, as on the axis of a circular contact.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(tensor_of(stress), Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& values = solver.eigenvalues();
  return {values[2], values[1], values[0]};
}

double tresca(const SymmetricTensor& stress) {
  const std::array<double, 3> values = principal(stress);
  return values[0] - values[2];
}

double orthogonal_shear(const SymmetricTensor& stress) {
  return std::hypot(stress[xz], stress[yz]);
}

const std::array<StressMeasure, 4>& reported_measures() {
  static const std::array<StressMeasure, 4> measures{
      {{"von_mises", von_mises},
       {"tresca", tresca},
       {"orthogonal_shear", orthogonal_shear},
       {"principal_1", [](const SymmetricTensor& stress) { return principal(stress)[0]; }}}};
  return measures;
}

std::array<double, 3> into_axes(const Axes& axes, const std::array<double, 3>& vector) {
  return turned(rows_of(axes), vector);
}

SymmetricTensor into_axes(const Axes& axes, const SymmetricTensor& stress) {
  return turned(rows_of(axes), stress);
}

std::array<double, 3> out_of_axes(const Axes& axes, const std::array<double, 3>& vector) {
  return turned(columns_of(axes), vector);
}

SymmetricTensor out_of_axes(const Axes& axes, const SymmetricTensor& stress) {
  return turned(columns_of(axes), stress);
}

}  // namespace rollfem::contact
