// Linear elasticity K u = b on one body, solved many times with the same K. The interface of the
// solvers; factorisation.hpp and multigrid.hpp implement it.
#pragma once

#include "contact/scene/scene.hpp"
#include "fem/body/material_motion.hpp"

#include <deal.II/base/index_set.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rollfem::fem {

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Homogeneous displacement conditions by boundary id.
struct BoundaryConditions {
  std::set<dealii::types::boundary_id> clamped;
  /// Symmetry planes: the displacement component that vanishes there (1 for the plane y = 0).
  std::map<dealii::types::boundary_id, unsigned int> vanishing_component;
};

/// A discretised body: FE_Q(degree)^3 dofs on a parallel::distributed triangulation.
/// All references outlive the solver. `constraints` holds hanging nodes and boundary conditions.
struct ElasticProblem {
  const dealii::DoFHandler<3>& dofs;
  const dealii::Mapping<3>& mapping;
  const dealii::AffineConstraints<double>& constraints;
  BoundaryConditions boundary;
  contact::Material material;
  MaterialMotion motion = {};  ///< of material with a density: adds inertia to K
  /// Whether the dilatation is projected (cell_terms.hpp); unset: where Poisson's ratio asks for
  /// it.
  std::optional<bool> project_dilatation = {};
};

/// Unknowns of the cells of this process and of those beside it.
dealii::IndexSet relevant_dofs(const dealii::DoFHandler<3>& dofs);

/// Hanging nodes and boundary conditions for any level of a body.
dealii::AffineConstraints<double> make_constraints(const dealii::DoFHandler<3>& dofs,
                                                   const dealii::Mapping<3>& mapping,
                                                   const BoundaryConditions& boundary);

/// Ghosted vector laid out for `dofs` (locally relevant).
Vector make_vector(const dealii::DoFHandler<3>& dofs);

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// u = K^-1 b, constraints distributed and ghosts updated on return. `b` need not respect the
  /// constraints (it is condensed here). Throws contact::SolveError when the residual stays above
  /// the tolerance the solver was made with.
  virtual void solve(Vector& u, const Vector& b) const = 0;
  /// The same for several right-hand sides, which a factorisation reads its factor once for.
  virtual void solve_all(std::vector<Vector>& u, const std::vector<Vector>& b) const;
  virtual int last_iterations() const = 0;  ///< 0 for a factorisation
  virtual double memory_bytes() const = 0;  ///< on this process
  virtual std::string description() const = 0;
  /// Whether a solve may run on one thread while another solver's runs on the next.
  virtual bool runs_beside_others() const { return false; }
};

}  // namespace rollfem::fem
