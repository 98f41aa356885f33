// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/algebraic_multigrid.hpp"

#include "base/errors.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <fmt/format.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <new>

namespace rollfem::fem {

namespace {

void assemble_matrix(const ElasticProblem& problem,
                     dealii::TrilinosWrappers::SparseMatrix& matrix) {
  const auto& dofs = problem.dofs;
  {
    dealii::DynamicSparsityPattern pattern(relevant_dofs(dofs));
    dealii::DoFTools::make_sparsity_pattern(dofs, pattern, problem.constraints, false);
    dealii::SparsityTools::distribute_sparsity_pattern(
        pattern, dofs.locally_owned_dofs(), dofs.get_communicator(), relevant_dofs(dofs));
    matrix.reinit(dofs.locally_owned_dofs(), dofs.locally_owned_dofs(), pattern,
                  dofs.get_communicator());
  }
  const unsigned int n = dofs.get_fe().dofs_per_cell;
  CellStiffness stiffness(problem);
  dealii::FullMatrix<double> cell_matrix(n, n);
  std::vector<dealii::types::global_dof_index> indices(n);
  for (const auto& cell : dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell_matrix.fill(stiffness.compute(cell).data());
    cell->get_dof_indices(indices);
    problem.constraints.distribute_local_to_global(cell_matrix, indices, matrix);
  }
  matrix.compress(dealii::VectorOperation::add);
}

/// The six rigid motions, which smoothed aggregation must represent on every level; zero where
/// constraints fix an unknown.
std::unique_ptr<Epetra_MultiVector> rigid_motions(
    const ElasticProblem& problem, const dealii::TrilinosWrappers::SparseMatrix& matrix) {
  const auto& dofs = problem.dofs;
  const auto& element = dofs.get_fe();
  auto modes =
      std::make_unique<Epetra_MultiVector>(matrix.trilinos_matrix().OperatorDomainMap(), 6);
  const auto owned = dofs.locally_owned_dofs();
  std::vector<dealii::types::global_dof_index> indices(element.dofs_per_cell);
  for (const auto& cell : dofs.active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i) {
      if (!owned.is_element(indices[i]) || problem.constraints.is_constrained(indices[i])) continue;
      const auto row = static_cast<int>(owned.index_within_set(indices[i]));
      const unsigned int c = element.system_to_component_index(i).first;
      const auto p =
          problem.mapping.transform_unit_to_real_cell(cell, element.unit_support_point(i));
      const unsigned int next = (c + 1) % 3, after = (c + 2) % 3;
      (*modes)[c][row] = 1.0;
      (*modes)[3 + after][row] = -p[next];  // about the axis `after`: u = (-y, x) in its plane
      (*modes)[3 + next][row] = p[after];
    }
  }
  return modes;
}

Teuchos::ParameterList parameters(Epetra_MultiVector& modes) {
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", 3);  // the three unknowns of a node are adjacent
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 1e-3);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 3);
  list.set("smoother: pre or post", "both");
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 2000);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", modes.NumVectors());
  list.set("null space: vectors", modes.Values());
  list.set("null space: add default vectors", false);
  return list;
}

class AlgebraicMultigrid : public LinearSolver {
 public:
  AlgebraicMultigrid(const ElasticProblem& problem, const IterationLimits& limits)
      : constraints_(problem.constraints),
        dofs_(problem.dofs),
        limits_(limits),
        with_masters_(relevant_dofs(problem.dofs)) {
    for (const auto i : dofs_.locally_owned_dofs())
      if (const auto* entries = constraints_.get_constraint_entries(i))
        for (const auto& entry : *entries) with_masters_.add_index(entry.first);
    try {
      assemble_matrix(problem, matrix_);
      const auto modes = rigid_motions(problem, matrix_);
      preconditioner_.initialize(matrix_.trilinos_matrix(), parameters(*modes));
    } catch (const std::bad_alloc&) {
      throw contact::SolveError("algebraic multigrid: memory ran out; use a coarser fem.cell_size");
    }
  }

  void solve(Vector& u, const Vector& b) const override {
    // Trilinos has neither vectors for several solves nor threads of its own, and calls MPI.
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    const auto owned = dofs_.locally_owned_dofs();
    const Vector load = condensed(b);
    Vector x(owned, dofs_.get_communicator());
    const double scale = load.l2_norm();
    dealii::SolverControl control(static_cast<unsigned int>(limits_.max_iterations),
                                  limits_.tolerance * scale);
    try {
      if (scale > 0) dealii::SolverCG<Vector>(control).solve(matrix_, x, load, preconditioner_);
    } catch (const dealii::SolverControl::NoConvergence& failure) {
      throw contact::SolveError(fmt::format(
          "algebraic multigrid: relative residual {:.2e} after {} iterations, required {:.1e}",
          failure.last_residual / scale, failure.last_step, limits_.tolerance));
    }
    iterations_ = scale > 0 ? static_cast<int>(control.last_step()) : 0;
    // The recursive residual may have drifted from the true one.
    Vector residual(x);
    matrix_.vmult(residual, x);
    residual.sadd(-1.0, 1.0, load);
    if (!(residual.l2_norm() <= 10 * limits_.tolerance * scale))
      throw contact::SolveError(fmt::format("algebraic multigrid: the true residual is {:.2e}",
                                            residual.l2_norm() / scale));
    u.zero_out_ghost_values();
    std::copy(x.begin(), x.end(), u.begin());
    constraints_.distribute(u);
    u.update_ghost_values();
  }

  int last_iterations() const override { return iterations_; }
  std::string description() const override {
    return "conjugate gradients, algebraic multigrid (Trilinos ML)";
  }

 private:
  /// C^T b: the owner of a constrained unknown passes its load to the masters on any process.
  Vector condensed(const Vector& b) const {
    const auto owned = dofs_.locally_owned_dofs();
    Vector sum(owned, with_masters_, dofs_.get_communicator());
    for (const auto i : owned) {
      const auto* entries = constraints_.get_constraint_entries(i);
      if (entries == nullptr) {
        sum(i) += b(i);
        continue;
      }
      for (const auto& [master, weight] : *entries) sum(master) += weight * b(i);
    }
    sum.compress(dealii::VectorOperation::add);
    Vector result(owned, dofs_.get_communicator());
    std::copy_n(sum.begin(), result.locally_owned_size(), result.begin());
    return result;
  }

  const dealii::AffineConstraints<double>& constraints_;
  const dealii::DoFHandler<3>& dofs_;
  IterationLimits limits_;
  dealii::IndexSet with_masters_;  ///< relevant unknowns, and masters of the owned ones
  dealii::TrilinosWrappers::SparseMatrix matrix_;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
  mutable int iterations_ = 0;
};

}  // namespace

std::unique_ptr<LinearSolver> make_algebraic_multigrid(const ElasticProblem& problem,
                                                       const IterationLimits& limits) {
  return std::make_unique<AlgebraicMultigrid>(problem, limits);
}

}  // namespace rollfem::fem
