// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/cell_stress.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

namespace {

/// Distance in longer sides beyond which point sources are summed by the Gauss rule.
constexpr double far_distance = 20.0;

/// A point this close to the line of an edge (in units of the longer side) lies on it: coordinates
/// are sums, and rounding must not decide on which side the point lies.
constexpr double on_the_edge = 1e-11;

double snapped(double offset) {
  return std::abs(offset) < on_the_edge ? 0.0 : offset;
}

/// asinh(along/across) up to terms of `across` alone, which the caller's differences cancel; on the
/// edge, its finite part.
double edge_logarithm(double along, double r, double across) {
  const double length = std::abs(along) + r;
  if (length == 0.0) return 0.0;
  const double logarithm = std::log(across > 0.0 ? length / across : length);
  return along < 0.0 ? -logarithm : logarithm;
}

double ratio_or_zero(double numerator, double denominator) {
  return denominator > 0.0 ? numerator / denominator : 0.0;
}

}  // namespace

Potentials corner_potentials(double X_given, double Y_given, double z) {
  const double X = snapped(X_given);
  const double Y = snapped(Y_given);
  const double X2 = X * X;
  const double Y2 = Y * Y;
  const double z2 = z * z;
  const double r = std::sqrt(X2 + Y2 + z2);
  const double across_x = std::sqrt(X2 + z2);
  const double across_y = std::sqrt(Y2 + z2);
  const double log_x = edge_logarithm(Y, r, across_x);
  const double log_y = edge_logarithm(X, r, across_y);
  const double log_z = r > 0.0 ? std::log(r + z) : 0.0;
  const double over_rz = r > 0.0 ? 1.0 / (r + z) : 0.0;
  const double over_r = r > 0.0 ? 1.0 / r : 0.0;
  // atan(Y/X) - atan(zY/(Xr)) without the cancellation; within [-pi/2, pi/2] since the second
  // argument is not negative, and half of the jump on the edge.
  const double product = X * Y * (X2 + Y2) * over_rz;

  Potentials p;
  p[phi_x] = log_x;
  p[phi_y] = log_y;
  p[phi_z] = -std::atan2(X * Y, z * r);
  p[chi_xx] = std::atan2(product, X2 * r + z * Y2);
  p[chi_yy] = std::atan2(product, Y2 * r + z * X2);
  p[chi_xy] = log_z;
  p[phi] = X * log_x + Y * log_y + z * p[phi_z];
  p[chi_x] = Y * log_z + z * log_x + X * p[chi_xx];
  p[chi_y] = X * log_z + z * log_y + Y * p[chi_yy];
  p[omega_xx] = z * p[chi_xx] - X * log_x;
  p[omega_yy] = z * p[chi_yy] - Y * log_y;
  p[omega_xy] = z * log_z - r;
  p[omega_xxy] = -X * over_rz;
  p[omega_xyy] = -Y * over_rz;
  const double edge_x = -Y * ratio_or_zero(z * over_r, across_x * across_x);
  const double edge_y = -X * ratio_or_zero(z * over_r, across_y * across_y);
  p[z_phi_xx] = X * edge_x;
  p[z_phi_yy] = Y * edge_y;
  p[z_phi_xy] = z * over_r;
  p[z_phi_xz] = z * edge_x;
  p[z_phi_yz] = z * edge_y;
  p[z_chi_xxy] = X * z * over_r * over_rz;
  p[z_chi_xyy] = Y * z * over_r * over_rz;
  return p;
}

Potentials edge_potentials(double X_given, double z, double reference, bool finite) {
  const double X = snapped(X_given);
  const double across2 = X * X + z * z;
  const double logarithm = across2 > 0.0 ? std::log(across2) : 0.0;
  const double angle = 2.0 * std::atan2(X, z);
  const double far = 2.0 * X * std::log(reference);
  Potentials p = Potentials::Zero();
  p[phi_x] = -logarithm;
  p[phi_z] = -angle;
  p[chi_xx] = angle;
  p[chi_x] = X * angle - z * logarithm;
  p[phi] = far + 2.0 * X - X * logarithm - z * angle;
  p[omega_xx] = (finite ? 2.0 * X : 0.0) - p[phi];
  p[omega_yy] = finite ? -2.0 * X : 0.0;
  p[z_phi_xx] = -2.0 * X * ratio_or_zero(z, across2);
  p[z_phi_xz] = -2.0 * z * ratio_or_zero(z, across2);
  return p;
}

Potentials point_potentials(double X, double Y, double z) {
  const double r = std::sqrt(X * X + Y * Y + z * z);
  const double s = 1.0 / (r + z);
  const double r1 = 1.0 / r;
  const double r2 = r1 * r1;
  const double r3 = r1 * r2;
  const double r5 = r3 * r2;
  // Derivatives of 1/(r + z): with f = s^2/r, f_X = -X g.
  const double f = r1 * s * s;
  const double g = (3.0 * r + z) * r3 * s * s * s;
  const double f_z = -(2.0 * r + z) * r3 * s * s;
  const double g_z = -(8.0 * r * r + 9.0 * r * z + 3.0 * z * z) * r5 * s * s * s;

  Potentials p;
  p[phi] = r1;
  p[phi_x] = -X * r3;
  p[phi_y] = -Y * r3;
  p[phi_z] = -z * r3;
  p[z_phi_xx] = z * (3.0 * X * X * r5 - r3);
  p[z_phi_yy] = z * (3.0 * Y * Y * r5 - r3);
  p[z_phi_xy] = z * 3.0 * X * Y * r5;
  p[z_phi_xz] = z * 3.0 * X * z * r5;
  p[z_phi_yz] = z * 3.0 * Y * z * r5;
  p[chi_x] = X * r1 * s;
  p[chi_y] = Y * r1 * s;
  p[chi_xx] = r1 * s + X * X * f_z;
  p[chi_yy] = r1 * s + Y * Y * f_z;
  p[chi_xy] = X * Y * f_z;
  p[omega_xx] = -s + X * X * f;
  p[omega_yy] = -s + Y * Y * f;
  p[omega_xy] = X * Y * f;
  p[omega_xxy] = Y * f - X * X * Y * g;
  p[omega_xyy] = X * f - X * Y * Y * g;
  p[z_chi_xxy] = z * (Y * f_z - X * X * Y * g_z);
  p[z_chi_xyy] = z * (X * f_z - X * Y * Y * g_z);
  return p;
}

namespace {

/// In units of the longer side.
Potentials near_rectangle(double x, double y, double z, double a, double b) {
  return corner_potentials(x + a, y + b, z) - corner_potentials(x - a, y + b, z) -
         corner_potentials(x + a, y - b, z) + corner_potentials(x - a, y - b, z);
}

Potentials far_rectangle(double x, double y, double z, double a, double b) {
  constexpr std::array<double, 4> node{-0.86113631159405258, -0.33998104358485626,
                                       0.33998104358485626, 0.86113631159405258};
  constexpr std::array<double, 4> weight{0.34785484513745386, 0.65214515486254614,
                                         0.65214515486254614, 0.34785484513745386};
  Potentials sum = Potentials::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum += weight[i] * weight[j] * point_potentials(x - a * node[i], y - b * node[j], z);
  return sum * (a * b);
}

}  // namespace

Potentials rectangle_potentials(double x, double y, double z, double dx, double dy) {
  const double length = std::max(dx, dy);
  const double X = x / length;
  const double Y = y / length;
  const double Z = z / length;
  const double a = 0.5 * dx / length;
  const double b = 0.5 * dy / length;
  const bool far = X * X + Y * Y + Z * Z > far_distance * far_distance;
  Potentials p = far ? far_rectangle(X, Y, Z, a, b) : near_rectangle(X, Y, Z, a, b);
  p.head<first_dimensionless>() *= length;
  return p;
}

void check_half_space(double z, double shear_modulus, double poisson_ratio) {
  if (!(z >= 0.0))
    throw contact::InputError(fmt::format(
        "depth = {} mm; allowed: 0 (the surface) or more; the depth is positive in either body",
        z));
  if (!(shear_modulus > 0.0))
    throw contact::InputError(fmt::format(
        "shear modulus = {} MPa; allowed: positive, inf for a rigid body", shear_modulus));
  if (!(poisson_ratio > -1.0 && poisson_ratio <= 0.5))
    throw contact::InputError(
        fmt::format("Poisson's ratio = {}; allowed: above -1 and up to 0.5", poisson_ratio));
}

}  // namespace rollfem::halfspace
