#include "halfspace/closed_forms/point_loads.hpp"

#include "halfspace/elasticity/influence.hpp"

#include <cmath>

namespace rollfem::halfspace {

namespace {

constexpr double pi = 3.14159265358979323846;

double distance(const Position& at) {
  return std::sqrt(at.x * at.x + at.y * at.y + at.z * at.z);
}

}  // namespace

/// Johnson 1985, eq. 3.18.
Displacement boussinesq_displacement(const ElasticHalfspace& body, double force,
                                     const Position& at) {
  const double rho = distance(at);
  const double scale = force / (4.0 * pi * body.shear_modulus);
  const double lateral =
      at.z / (rho * rho * rho) - (1.0 - 2.0 * body.poisson_ratio) / (rho * (rho + at.z));
  const double vertical = at.z * at.z / (rho * rho * rho) + 2.0 * (1.0 - body.poisson_ratio) / rho;
  return {scale * at.x * lateral, scale * at.y * lateral, scale * vertical};
}

/// Johnson 1985, eq. 3.19, in a form that holds on the axis: the factors x^2 and x y take the place
/// of the differences that vanish there.
Stress boussinesq_stress(const ElasticHalfspace& body, double force, const Position& at) {
  const double rho = distance(at);
  const double rho3 = rho * rho * rho;
  const double scale = force / (2.0 * pi);
  const double direct = -3.0 / (rho3 * rho * rho);
  const double factor = 1.0 - 2.0 * body.poisson_ratio;
  const double sum = rho + at.z;
  const double isotropic = at.z / rho3 - 1.0 / (rho * sum);
  const double turning = (2.0 * rho + at.z) / (rho3 * sum * sum);
  const double in_plane = direct * at.z + factor * turning;
  Stress stress;
  stress.xx = scale * (at.x * at.x * in_plane + factor * isotropic);
  stress.yy = scale * (at.y * at.y * in_plane + factor * isotropic);
  stress.xy = scale * at.x * at.y * in_plane;
  stress.zz = scale * direct * at.z * at.z * at.z;
  stress.xz = scale * direct * at.x * at.z * at.z;
  stress.yz = scale * direct * at.y * at.z * at.z;
  return stress;
}

/// Johnson 1985, eq. 3.75.
Displacement cerruti_displacement(const ElasticHalfspace& body, double force, const Position& at) {
  const double rho = distance(at);
  const double rho3 = rho * rho * rho;
  const double sum = rho + at.z;
  const double factor = 1.0 - 2.0 * body.poisson_ratio;
  const double scale = force / (4.0 * pi * body.shear_modulus);
  const double shared = 1.0 / rho3 - factor / (rho * sum * sum);
  return {scale * (1.0 / rho + factor / sum + at.x * at.x * shared), scale * at.x * at.y * shared,
          scale * at.x * (at.z / rho3 + factor / (rho * sum))};
}

/// Johnson 1985, eq. 3.76.
Stress cerruti_stress(const ElasticHalfspace& body, double force, const Position& at) {
  const double rho = distance(at);
  const double rho2 = rho * rho;
  const double sum = rho + at.z;
  const double sum2 = sum * sum;
  const double scale = force / (2.0 * pi);
  const double factor = 1.0 - 2.0 * body.poisson_ratio;
  const double direct = -3.0 / (rho2 * rho2 * rho);
  const double cubic = direct + factor * (1.0 / (rho2 * rho * sum2) + 2.0 / (rho2 * sum2 * sum));
  const double linear = factor / (rho * sum2);
  const double radial = factor / (rho2 * rho);
  Stress stress;
  stress.xx = scale * at.x * (at.x * at.x * cubic + radial - 3.0 * linear);
  stress.yy = scale * at.x * (at.y * at.y * cubic + radial - linear);
  stress.xy = scale * at.y * (at.x * at.x * cubic - linear);
  stress.zz = scale * direct * at.x * at.z * at.z;
  stress.yz = scale * direct * at.x * at.y * at.z;
  stress.xz = scale * direct * at.x * at.x * at.z;
  return stress;
}

Displacement line_load_displacement(const ElasticHalfspace& body, const LineLoad& load, double x,
                                    double z) {
  const double nu = body.poisson_ratio;
  const double r2 = x * x + z * z;
  const double logarithm = (1.0 - nu) * std::log(r2);
  const double angle = (1.0 - 2.0 * nu) * std::atan2(x, z);
  const double scale = 1.0 / (2.0 * pi * body.shear_modulus);
  const double cross = x * z / r2;
  return {scale * (load.normal * (cross - angle) + load.tangential * (x * x / r2 - logarithm)), 0.0,
          scale * (load.normal * (z * z / r2 - logarithm) + load.tangential * (cross + angle))};
}

/// A radial field: Johnson 1985, eqs. 2.21 and 2.22 for the normal load, 2.30 for the tangential.
Stress line_load_stress(const ElasticHalfspace& body, const LineLoad& load, double x, double z) {
  const double r2 = x * x + z * z;
  const double radial = -2.0 * (load.normal * z + load.tangential * x) / (pi * r2 * r2);
  Stress stress;
  stress.xx = radial * x * x;
  stress.zz = radial * z * z;
  stress.xz = radial * x * z;
  stress.yy = body.poisson_ratio * (stress.xx + stress.zz);
  return stress;
}

double love_displacement(const ElasticHalfspace& body, double pressure, double length_x,
                         double length_y, double x, double y) {
  // The influence coefficients are those of two bodies: twice as soft as one.
  contact::CombinedMaterial one_body;
  one_body.shear_modulus = 2.0 * body.shear_modulus;
  one_body.poisson_ratio = body.poisson_ratio;
  return pressure * rectangle_influence(x, y, length_x, length_y, one_body).nn;
}

}  // namespace rollfem::halfspace
