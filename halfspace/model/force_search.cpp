#include "halfspace/model/force_search.hpp"

#include "halfspace/theories/linear_theory.hpp"

#include <cmath>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::PatchSize;
using Eigen::Vector2d;

Vector2d rolling_stiffness(const PatchSize& patch, const CombinedMaterial& material) {
  const double a = 0.5 * patch.length;
  const double b = 0.5 * patch.width;
  const KalkerCoefficients kalker = kalker_coefficients(a, b, material.poisson_ratio);
  return material.shear_modulus * a * b * Vector2d(kalker.c11, kalker.c22);
}

Vector2d shift_stiffness(const PatchSize& patch, const CombinedMaterial& material) {
  const double c = 0.5 * std::sqrt(patch.length * patch.width);
  return Vector2d::Constant(4.0 * c * material.shear_modulus / (2.0 - material.poisson_ratio));
}

Vector2d first_creepage(const contact::PrescribedForce& wanted, const Vector2d& given,
                        const Vector2d& stiffness, double bound) {
  const Vector2d force(wanted.longitudinal.value_or(0.0), wanted.lateral.value_or(0.0));
  const double size = force.norm() / bound;
  const double stretch = size > 0.0 ? contact::creepage_of_force(size) / size : 1.0;
  Vector2d creepage = given;
  if (wanted.longitudinal) creepage.x() = -stretch * force.x() / stiffness.x();
  if (wanted.lateral) creepage.y() = -stretch * force.y() / stiffness.y();
  return creepage;
}

}  // namespace rollfem::halfspace
