// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity of one discretised body: unknowns, constraints, material; vectors of its
// unknowns.
#pragma once

#include "contact/scene/scene.hpp"
#include "fem/discretisation/material_motion.hpp"

#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <map>
#include <optional>
#include <set>

namespace rollfem::fem {

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
