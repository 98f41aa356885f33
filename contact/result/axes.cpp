// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/axes.hpp"

#include <Eigen/Core>

namespace rollfem::contact {

namespace {

Eigen::Matrix3d rows_of(const Axes& axes) {
  Eigen::Matrix3d q;
  q << axes[0][0], axes[0][1], axes[0][2], axes[1][0], axes[1][1], axes[1][2], axes[2][0],
      axes[2][1], axes[2][2];
  return q;
}

Eigen::Matrix3d columns_of(const Axes& axes) {
  Eigen::Matrix3d q;
  q << axes[0][0], axes[1][0], axes[2][0], axes[0][1], axes[1][1], axes[2][1], axes[0][2],
      axes[1][2], axes[2][2];
  return q;
}

std::array<double, 3> product(const Eigen::Matrix3d& q, const std::array<double, 3>& vector) {
  const Eigen::Vector3d turned = q * Eigen::Map<const Eigen::Vector3d>(vector.data());
  return {turned[0], turned[1], turned[2]};
}

/// q stress q'
Stress product(const Eigen::Matrix3d& q, const Stress& s) {
  Eigen::Matrix3d tensor;
  tensor << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  const Eigen::Matrix3d t = q * tensor * q.transpose();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

}  // namespace

std::array<double, 3> into_axes(const Axes& axes, const std::array<double, 3>& vector) {
  return product(rows_of(axes), vector);
}

Stress into_axes(const Axes& axes, const Stress& stress) {
  return product(rows_of(axes), stress);
}

std::array<double, 3> out_of_axes(const Axes& axes, const std::array<double, 3>& vector) {
  return product(columns_of(axes), vector);
}

Stress out_of_axes(const Axes& axes, const Stress& stress) {
  return product(columns_of(axes), stress);
}

}  // namespace rollfem::contact
