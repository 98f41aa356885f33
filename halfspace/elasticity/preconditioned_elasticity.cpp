// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/preconditioned_elasticity.hpp"

#include "base/pi.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "halfspace/elasticity/neighbours.hpp"

#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::PatchSize;
using Eigen::Vector2d;

Halfspaces::Halfspaces(const CombinedMaterial& of, const contact::ContactGrid& grid)
    : material(of), like(std::make_shared<const HalfspaceCompliance>(grid, of.uncoupled())) {
  if (of.couples()) coupled = std::make_shared<const HalfspaceCompliance>(grid, of);
}

bool Halfspaces::fit(const CombinedMaterial& other, const contact::ContactGrid& grid) const {
  const contact::ContactGrid& own = like->grid();
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(a); };
  return own.nx == grid.nx && own.ny == grid.ny && same(own.dx, grid.dx) && same(own.dy, grid.dy) &&
         own.line_reference == grid.line_reference &&
         material.shear_modulus == other.shear_modulus &&
         material.poisson_ratio == other.poisson_ratio && material.difference == other.difference &&
         material.contact_modulus == other.contact_modulus && material.layer == other.layer;
}

contact::Field PreconditionedElasticity::extra_distance() const {
  return neighbour_displacement(scene_.neighbour_loads, scene_.material, halfspaces_.like->grid());
}

contact::TangentialField PreconditionedElasticity::extra_slip() const {
  return neighbour_slip(scene_.neighbour_loads, scene_.material, halfspaces_.like->grid());
}

namespace {

/// Stiffness of bodies and layer in series; `area` divides the compliance of the layer (mm^2, in
/// rolling mm^3).
Vector2d with_layer(const Vector2d& bodies, double area, const CombinedMaterial& material) {
  if (material.layer == 0.0) return bodies;
  return (bodies.array().inverse() + material.layer / area).inverse();
}

/// For a line contact: Carter's stiffness.
Vector2d line_rolling_stiffness(const PatchSize& patch, const CombinedMaterial& material) {
  const double antiplane = 0.25 * contact::pi * material.shear_modulus * patch.length * patch.width;
  return with_layer({antiplane / (1.0 - material.poisson_ratio), antiplane},
                    0.5 * patch.length * patch.length * patch.width, material);
}

/// Stiffness under Hertz's distribution of tractions; the displacement in the middle is relative to
/// the reference distance.
Vector2d line_shift_stiffness(const PatchSize& patch, double reference,
                              const CombinedMaterial& material) {
  const double antiplane = 0.5 * contact::pi * material.shear_modulus * patch.width /
                           (std::log(4.0 * reference / patch.length) + 0.5);
  return with_layer({antiplane / (1.0 - material.poisson_ratio), antiplane},
                    patch.length * patch.width, material);
}

}  // namespace

Vector2d rolling_stiffness(const PatchSize& patch, const CombinedMaterial& material) {
  const double a = 0.5 * patch.length;
  const double b = 0.5 * patch.width;
  const KalkerCoefficients kalker = kalker_coefficients(a, b, material.poisson_ratio);
  return with_layer(material.shear_modulus * a * b * Vector2d(kalker.c11, kalker.c22),
                    8.0 / 3.0 * a * a * b, material);
}

Vector2d shift_stiffness(const PatchSize& patch, const CombinedMaterial& material) {
  const double c = 0.5 * std::sqrt(patch.length * patch.width);
  return with_layer(
      Vector2d::Constant(4.0 * c * material.shear_modulus / (2.0 - material.poisson_ratio)),
      contact::pi * c * c, material);
}

Vector2d PreconditionedElasticity::rolling_stiffness(const PatchSize& patch) const {
  return scene_.geometry.line ? line_rolling_stiffness(patch, scene_.material)
                              : halfspace::rolling_stiffness(patch, scene_.material);
}

Vector2d PreconditionedElasticity::shift_stiffness(const PatchSize& patch) const {
  return scene_.geometry.line
             ? line_shift_stiffness(patch, reference_of(*scene_.geometry.line), scene_.material)
             : halfspace::shift_stiffness(patch, scene_.material);
}

}  // namespace rollfem::halfspace
