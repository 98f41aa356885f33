// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity of one discretised body: unknowns, constraints, material; vectors of its
// unknowns.
#pragma once

#include "scene/scene.hpp"

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <map>
#include <optional>
#include <set>

namespace rollfem::fem {

// The rigid flow of material through a mesh that is fixed in the frame of the contact.

struct SurfaceShape;

/// v(x) = velocity + rotation x (x - centre): divergence-free, so that steady inertia has the
/// symmetric form in docs/theory.md. All zero: material at rest.
struct MaterialMotion {
  dealii::Tensor<1, 3> velocity;  ///< mm/s
  dealii::Tensor<1, 3> rotation;  ///< rad/s
  dealii::Point<3> centre;        ///< mm, on the axle

  bool at_rest() const { return velocity.norm_square() == 0 && rotation.norm_square() == 0; }
  dealii::Tensor<1, 3> at(const dealii::Point<3>& place) const {
    return velocity + dealii::cross_product_3d(rotation, place - centre);
  }
};

/// Material comes from +x at the contact: the rail moves rigidly with -speed along x, the wheel
/// turns about its axle with speed / rolling_radius (a flat "wheel" moves like the rail). mm/s.
MaterialMotion material_motion(const SurfaceShape& shape, double speed);

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Homogeneous displacement conditions by boundary id.
struct BoundaryConditions {
  std::set<dealii::types::boundary_id> clamped;
  /// Symmetry planes: the displacement component that vanishes there (1 for the plane y = 0).
  std::map<dealii::types::boundary_id, unsigned int> vanishing_component;
};

/// A discretised body: FE_Q(degree)^3 dofs on a parallel::distributed triangulation. All referenced
/// objects must outlive the solver. `constraints` holds hanging nodes and boundary conditions.
struct ElasticProblem {
  const dealii::DoFHandler<3>& dofs;
  const dealii::Mapping<3>& mapping;
  const dealii::AffineConstraints<double>& constraints;
  BoundaryConditions boundary;
  contact::Material material;
  MaterialMotion motion = {};  ///< for material with a density: adds inertia to K
  /// Whether the dilatation is projected (cell_terms.hpp); unset: according to Poisson's ratio.
  std::optional<bool> project_dilatation = {};
};

/// Unknowns of the cells of this process and of adjacent cells.
dealii::IndexSet relevant_dofs(const dealii::DoFHandler<3>& dofs);

/// Hanging nodes and boundary conditions for any level of a body.
dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<3>& dofs,
                                                   const dealii::Mapping<3>& mapping,
                                                   const BoundaryConditions& boundary);

/// Ghosted vector laid out for `dofs` (locally relevant).
Vector make_vector(const dealii::DoFHandler<3>& dofs);

}  // namespace rollfem::fem
