// SPDX-License-Identifier: LGPL-2.1-or-later
// The interface of elasticity for the contact solvers: linear maps from tractions on the contact
// grid to displacement differences (wheel minus rail) on the same grid, from half-spaces or finite
// elements alike.
#pragma once

#include "base/choices.hpp"
#include "base/grid.hpp"

#include <memory>

namespace rollfem::contact {

/// The whole compliance A: tractions on the wheel (MPa) -> u_wheel - u_rail (mm), all three
/// components. Symmetric positive definite in the inner product sum over elements, each times its
/// true area (dx dy, and the stretch of PatchShape where the patch is curved).
class Compliance {
 public:
  virtual ~Compliance() = default;
  virtual const ContactGrid& grid() const = 0;
  virtual SurfaceField apply(const SurfaceField& traction) const = 0;

  /// The displacement and its further effect on the slip of steady rolling.
  virtual Response respond(const SurfaceField& traction) const { return {apply(traction), {}}; }
  /// Relative distance of the last response from that of bodies in balance, which bodies that yield
  /// approach from one response to the next.
  virtual double imbalance() const { return 0.0; }
};

/// The normal block A_nn with an approximate inverse for conjugate gradients.
class NormalMap {
 public:
  virtual ~NormalMap() = default;
  /// u_n = A_nn p_n.
  virtual void apply(const Field& pressure, Field& displacement) const = 0;
  /// Symmetric positive definite approximation of A_nn^-1.
  virtual void precondition(const Field& residual, Field& result) const = 0;
};

/// The same on a contact grid.
class NormalOperator : public NormalMap {
 public:
  virtual const ContactGrid& grid() const = 0;
};

/// A tangential operator T that gives slip (steady rolling: T = D A_tt, dimensionless per MPa) or
/// shift (T = A_tt, mm per MPa) from tangential tractions.
class TangentialOperator {
 public:
  virtual ~TangentialOperator() = default;
  virtual const ContactGrid& grid() const = 0;
  virtual TangentialField apply(const TangentialField& traction) const = 0;
  /// Mean diagonal entry of T, the scale of the projection parameter r = 1 / diagonal.
  virtual double diagonal() const = 0;
  /// h/G of the layer between the bodies in A_tt, mm/MPa.
  virtual double layer() const { return 0.0; }
  /// Approximate inverse of (r T + shift I) with every element in adhesion; the solver restricts it
  /// to the adhesion set.
  virtual TangentialField precondition(const TangentialField& residual, double r,
                                       double shift) const = 0;
};

/// A compliance with blocks that the contact solvers can invert approximately: half-space and
/// half-plane.
class SolvableCompliance : public Compliance {
 public:
  virtual const NormalOperator& normal() const = 0;
  /// T = A_tt: shift problems.
  virtual const TangentialOperator& shift() const = 0;
  /// T = D A_tt: steady rolling.
  virtual const TangentialOperator& rolling(UpwindOrder order) const = 0;
};

/// D u: the upwind difference along the streamline (upstream is +x) of a displacement difference
/// known on the whole grid, approximating -du/dx. Elements without enough upstream neighbours use
/// the highest order that fits; the last column copies its neighbour.
TangentialField upwind_difference(const ContactGrid& grid, const TangentialField& displacement,
                                  UpwindOrder order);

/// Distance upstream of an element's centre at which the spin is evaluated, mm, for a difference
/// over `step` mm. First order: a sixth of the step, CONTACT's default, to reproduce its numbers
/// (docs/theory.md); second order: 0.
double upstream_of_spin(UpwindOrder order, double step);

}  // namespace rollfem::contact
