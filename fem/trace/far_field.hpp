// SPDX-License-Identifier: LGPL-2.1-or-later
// The far boundary of a segment of wheel or rail, which represents the remainder of the body: it
// moves like that of a half-space under the force on the patch as a point load. Linear in the
// force: three elastic fields, solved once and together. Derivation: docs/theory.md, "Far
// boundary".
#pragma once

#include "fem/linear/linear_solver.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "scene/scene.hpp"

#include <deal.II/base/function.h>

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::fem {

// A displacement prescribed on the far boundary, for a solver whose own conditions are homogeneous.

/// A vector given as a function of position (mm), as deal.II takes it.
class VectorField : public dealii::Function<3> {
 public:
  using Values = std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>;
  explicit VectorField(Values values) : Function(3), values_(std::move(values)) {}
  double value(const dealii::Point<3>& place, unsigned int component) const override {
    return values_(place)[component];
  }

 private:
  Values values_;
};

/// A displacement given as a function of position (mm), at every node. Ghost values are set.
/// Collective.
Vector nodal_values(const ElasticProblem& problem, const VectorField::Values& displacement);

/// For several displacements, solved together: the solution under `load` (null: none) with the
/// values of `prescribed` where the solver's conditions would be zero, g + K^-1 (b - K g). Hanging
/// nodes of `prescribed` are first made consistent with their neighbours. `solver`: solver of
/// `problem`. Ghost values are set. Collective. Throws like the solver.
std::vector<Vector> solve_with_prescribed(const ElasticProblem& problem, const LinearSolver& solver,
                                          const std::vector<Vector>& prescribed,
                                          const Vector* load = nullptr);

/// Displacement (mm/N) at `place` of a half-space of this material under a unit force along axis x,
/// y or z (0, 1, 2) at the origin (Boussinesq, Cerruti). The wheel is the half-space z > 0, the
/// rail z < 0; points beyond the plane are projected onto it. Not at the origin.
dealii::Tensor<1, 3> point_load_displacement(const SurfaceShape& shape,
                                             const contact::Material& material, unsigned int axis,
                                             const dealii::Point<3>& place);

/// Force of tractions on the contact surface along the axes x, y, z, N (neglecting the rotation of
/// the wheel's frame along rolling, a relative error of (s/R)^2 / 2, as in
/// contact::integrate_tractions).
std::array<double, 3> resultant_force(const contact::PatchShape& shape,
                                      const contact::ContactGrid& grid,
                                      const contact::SurfaceField& traction);

/// One body's fields: displacement with that of the point load on the far boundary and no load
/// inside, for unit forces on this body along the axes. The field for y is zero in half a body.
/// Collective.
class FarField {
 public:
  /// `solver` is that of body.problem().
  FarField(const Body& body, const LinearSolver& solver, const SurfaceCoupling& coupling);
  /// Adds the displacement due to the far boundary for a force on this body, N: as sampled by the
  /// coupling, and in the whole body.
  void add(const std::array<double, 3>& force, contact::SurfaceField& displacement) const;
  void add(const std::array<double, 3>& force, Vector& displacement) const;

 private:
  std::array<Vector, 3> fields_;
  std::array<contact::SurfaceField, 3> sampled_;
};

// The choice of the far boundary of a case, and the error of the approach due to it.

/// As given in the case; by default that of a half-space under a point load if rollfem meshes both
/// bodies as boxes on the surface or around it, and clamped otherwise (true sections have free
/// sides, unlike a half-space).
FarBoundary far_boundary_of(const contact::Scene& scene);

/// Upper estimate, mm, of the change of the approach at this force (N) in segments larger than
/// `extent` (mm). Clamped: the half-spaces' displacement there. Point load: error of its
/// displacement there, from the spread of the pressure and the curvature of the bodies. Derivation:
/// docs/theory.md, "Far boundary".
double approach_left_out(const contact::Scene& scene, double normal_force, double extent);

/// Note for the results.
std::string far_boundary_note(const contact::Scene& scene, double extent);

}  // namespace rollfem::fem
