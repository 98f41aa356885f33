// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/multigrid.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/threads.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/cholmod.hpp"
#include "fem/linear/first_process.hpp"
#include "fem/linear/flush_subnormals.hpp"
#include "fem/linear/level_transfer.hpp"
#include "fem/linear/memory.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/vector_memory.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mpi.h>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;

/// Ratio of largest to smallest damped eigenvalue for one degree of the polynomial. Isotropic cells
/// need less; with the cells of aspect 3 that graded meshes have, wider ranges save a third of the
/// iterations (measured: degree 4 to 8, ratios 15 to 100; flat from 8 to 20 times the degree).
constexpr double range_per_degree = 10;

/// Cells bent by less than this are parallelepipeds in the preconditioner: the range of eigenvalues
/// widens by twice as much, without additional iterations.
constexpr double straightened = 0.02;

/// Counts of all processes in order.
struct Shares {
  std::vector<int> counts, offsets;

  Shares(std::size_t mine, MPI_Comm communicator)
      : counts(dealii::Utilities::MPI::all_gather(communicator, static_cast<int>(mine))),
        offsets(counts.size(), 0) {
    std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
  }
  std::size_t sum() const { return static_cast<std::size_t>(offsets.back() + counts.back()); }
};

/// The contributions of all processes, on the first one.
std::vector<MatrixEntry> gather(const std::vector<MatrixEntry>& mine, MPI_Comm communicator) {
  const Shares shares(mine.size(), communicator);
  if (shares.counts.size() == 1) return mine;
  MPI_Datatype entry;
  MPI_Type_contiguous(sizeof(MatrixEntry), MPI_BYTE, &entry);
  MPI_Type_commit(&entry);
  std::vector<MatrixEntry> all(
      dealii::Utilities::MPI::this_mpi_process(communicator) == 0 ? shares.sum() : 0);
  MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), entry, all.data(), shares.counts.data(),
              shares.offsets.data(), entry, 0, communicator);
  MPI_Type_free(&entry);
  return all;
}

/// Direct solution on the coarsest level: its matrix is gathered and factorised on the first
/// process, because iterations fail on the stretched cells of a graded coarse mesh.
class CoarseSolver {
 public:
  /// `entries`: contributions of this process to the lower triangle; `owned`: number of unknowns it
  /// owns, numbered consecutively over the processes. Collective. Throws contact::SolveError when
  /// the matrix is not positive definite (the body is not clamped) or memory runs out.
  CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t owned, MPI_Comm communicator);

  /// x = K^-1 b in owned entries, collective.
  void solve(FloatVector& x, const FloatVector& b) const;

 private:
  MPI_Comm communicator_;
  // On the first process only.
  std::unique_ptr<CholeskyFactor> factor_;
  std::vector<int> counts_, offsets_;  ///< ranges owned by the processes
  mutable std::vector<float> gathered_;
  mutable std::vector<double> right_;
};

CoarseSolver::CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t owned,
                           MPI_Comm communicator)
    : communicator_(communicator) {
  const std::vector<MatrixEntry> all = gather(entries, communicator);
  Shares shares(owned, communicator);
  FirstProcess(communicator).run([&] {
    right_.resize(shares.sum());
    factor_ = std::make_unique<CholeskyFactor>(
        all, right_.size(),
        FactorMessages{"coarse solve of the multigrid", "use a coarser fem.cell_size"});
  });
  if (shares.counts.size() == 1) return;
  gathered_.resize(right_.size());
  counts_ = std::move(shares.counts);
  offsets_ = std::move(shares.offsets);
}

/// A single process does not call MPI (Multigrid::runs_beside_others).
void CoarseSolver::solve(FloatVector& x, const FloatVector& b) const {
  const auto size = static_cast<int>(b.locally_owned_size());
  if (!counts_.empty())
    MPI_Gatherv(b.begin(), size, MPI_FLOAT, gathered_.data(), counts_.data(), offsets_.data(),
                MPI_FLOAT, 0, communicator_);
  if (factor_) {
    const float* const right = counts_.empty() ? b.begin() : gathered_.data();
    std::copy_n(right, right_.size(), right_.begin());
    const double* const solution = factor_->solve(right_);
    std::transform(solution, solution + right_.size(),
                   counts_.empty() ? x.begin() : gathered_.data(),
                   [](double value) { return static_cast<float>(value); });
  }
  if (!counts_.empty())
    MPI_Scatterv(gathered_.data(), counts_.data(), offsets_.data(), MPI_FLOAT, x.begin(), size,
                 MPI_FLOAT, 0, communicator_);
}

/// Stiffness of a level in the interface of deal.II's smoother. Compared with the own smoother that
/// it replaced: the same iterations, 1.01 times the time, 1.01 times the memory (0.2 to 0.7 million
/// unknowns).
struct SmoothedMatrix : dealii::Subscriptor {
  explicit SmoothedMatrix(const LocalCells& cells)
      : stiffness(cells, straightened), rows(stiffness.make_vector().size()) {}
  void vmult(FloatVector& product, const FloatVector& x) const { stiffness.vmult(product, x); }
  /// Interface through which deal.II does the vector updates of its iterations within the product.
  void vmult(FloatVector& product, const FloatVector& x,
             const ElasticityOperator<float>::Work& before,
             const ElasticityOperator<float>::Work& after) const {
    if (in_one_piece) {
      const auto all = static_cast<unsigned int>(x.locally_owned_size());
      before(0, all);
      stiffness.vmult(product, x);
      after(0, all);
    } else {
      stiffness.vmult(product, x, before, after);
    }
  }
  FloatVector::size_type m() const { return rows; }
  /// Required by deal.II only if no diagonal is given, but one is.
  float el(FloatVector::size_type, FloatVector::size_type) const {
    throw std::logic_error("the smoother's diagonal is given");
  }

  ElasticityOperator<float> stiffness;
  FloatVector::size_type rows;
  /// Conjugate gradients add up their products in `before` and `after`, which the ranges of several
  /// threads would spoil.
  bool in_one_piece = true;
};

using Diagonal = dealii::DiagonalMatrix<FloatVector>;
using Smoother = dealii::PreconditionChebyshev<SmoothedMatrix, FloatVector, Diagonal>;

/// One level above the coarsest; single precision, it only preconditions.
struct Level {
  Level(const LocalCells& cells, std::unique_ptr<LevelTransfer> transfer, int smoother_degree)
      : matrix(cells),
        to_coarser(std::move(transfer)),
        solution(matrix.stiffness.make_vector()),
        right(solution),
        residual(solution) {
    Smoother::AdditionalData data;
    data.degree = static_cast<unsigned int>(std::max(smoother_degree, 1));
    data.smoothing_range = range_per_degree * data.degree;
    data.eig_cg_n_iterations = 15;
    data.preconditioner = std::make_shared<Diagonal>(matrix.stiffness.inverse_diagonal());
    smoother.initialize(matrix, data);
    smoother.estimate_eigenvalues(solution);
    matrix.in_one_piece = false;
  }
  SmoothedMatrix matrix;
  Smoother smoother;
  std::unique_ptr<LevelTransfer> to_coarser;
  mutable FloatVector solution, right, residual;
};

/// From coarse to fine, the body's mesh last. Coarsened meshes keep the memory of the original
/// mesh; their copies have only the memory they need.
std::vector<std::shared_ptr<const dealii::Triangulation<3>>> coarsened_meshes(
    const ElasticProblem& problem) {
  using Mesh = dealii::parallel::distributed::Triangulation<3>;
  auto meshes = dealii::MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(
      problem.dofs.get_triangulation());
  for (std::size_t i = meshes.size() - 1; i-- > 0;) {
    auto copy =
        std::make_shared<Mesh>(problem.dofs.get_communicator(), meshes[i]->get_mesh_smoothing());
    copy->copy_triangulation(*meshes[i]);
    meshes[i] = std::move(copy);
  }
  return meshes;
}

/// Unknowns and constraints of a level, needed during set-up; on the finest level those of the
/// body.
class Discretisation {
 public:
  explicit Discretisation(const ElasticProblem& problem) : problem_(problem) {}
  Discretisation(const dealii::Triangulation<3>& mesh, const ElasticProblem& problem)
      : dofs_(std::make_unique<dealii::DoFHandler<3>>(mesh)),
        constraints_(std::make_unique<dealii::AffineConstraints<double>>()),
        problem_{*dofs_,
                 problem.mapping,
                 *constraints_,
                 problem.boundary,
                 problem.material,
                 problem.motion,
                 problem.project_dilatation} {
    dofs_->distribute_dofs(problem.dofs.get_fe());
    *constraints_ = make_constraints(*dofs_, problem.mapping, problem.boundary);
  }
  LocalCells cells() const { return make_local_cells(problem_); }
  std::unique_ptr<LevelTransfer> transfer_to(const Discretisation& coarse) const {
    return make_level_transfer(problem_, coarse.problem_);
  }

 private:
  std::unique_ptr<dealii::DoFHandler<3>> dofs_;
  std::unique_ptr<dealii::AffineConstraints<double>> constraints_;
  ElasticProblem problem_;
};

class Multigrid : public LinearSolver {
 public:
  Multigrid(const ElasticProblem& problem, const MultigridOptions& options);

  void solve(Vector& u, const Vector& b) const override;
  int last_iterations() const override { return iterations_; }
  std::string description() const override;
  /// MPI allows one thread only; a single process does not call it.
  bool runs_beside_others() const override {
    return coarse_right_.get_partitioner()->n_mpi_processes() == 1;
  }

  /// Interface of a deal.II preconditioner.
  void vmult(Vector& z, const Vector& r) const;

 private:
  void factorise_coarsest(const LocalCells& cells);
  void cycle(std::size_t level) const;
  void iterate(Vector& x, const Vector& b, double target) const;

  MultigridOptions options_;
  std::unique_ptr<ElasticityOperator<double>> stiffness_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< from coarse to fine, without the coarsest
  std::unique_ptr<CoarseSolver> coarse_;
  mutable FloatVector coarse_solution_, coarse_right_;
  mutable int iterations_ = 0;
};

Multigrid::Multigrid(const ElasticProblem& problem, const MultigridOptions& options)
    : options_(options) {
  if (problem.material.poisson_ratio > largest_multigrid_poisson_ratio)
    throw contact::InputError(fmt::format(
        "poisson_ratio = {}: multigrid does not converge for nearly incompressible bodies; "
        "allowed: up to {}; do: linear_solver = \"factorisation\", without mpirun",
        problem.material.poisson_ratio, largest_multigrid_poisson_ratio));
  auto meshes = coarsened_meshes(problem);
  std::vector<std::unique_ptr<Discretisation>> discretised;
  for (std::size_t i = 0; i + 1 < meshes.size(); ++i)
    discretised.push_back(std::make_unique<Discretisation>(*meshes[i], problem));
  discretised.push_back(std::make_unique<Discretisation>(problem));
  std::vector<std::unique_ptr<LevelTransfer>> transfers(1);
  for (std::size_t i = 1; i < discretised.size(); ++i)
    transfers.push_back(discretised[i]->transfer_to(*discretised[i - 1]));
  hand_back_memory();
  LocalCells cells = discretised.front()->cells();
  factorise_coarsest(cells);
  for (std::size_t i = 1; i < discretised.size(); ++i) {
    discretised[i - 1].reset();
    cells = {};
    cells = discretised[i]->cells();
    levels_.push_back(
        std::make_unique<Level>(cells, std::move(transfers[i]), options.smoother_degree));
  }
  discretised.clear();
  meshes.clear();
  stiffness_ = std::make_unique<ElasticityOperator<double>>(std::move(cells));
  cells = {};
  hand_back_memory();
}

void Multigrid::factorise_coarsest(const LocalCells& cells) {
  const ElasticityOperator<double> stiffness(cells);
  const auto& owned = cells.dofs->owned_only;
  coarse_ = std::make_unique<CoarseSolver>(stiffness.assemble(), owned->locally_owned_size(),
                                           owned->get_mpi_communicator());
  coarse_solution_.reinit(owned);
  coarse_right_.reinit(owned);
}

/// V-cycle: solution on level `level` (the coarsest is 0) from its right-hand side.
void Multigrid::cycle(std::size_t level) const {
  if (level == 0) {
    coarse_->solve(coarse_solution_, coarse_right_);
    return;
  }
  const Level& fine = *levels_[level - 1];
  FloatVector& right = level > 1 ? levels_[level - 2]->right : coarse_right_;
  const FloatVector& correction = level > 1 ? levels_[level - 2]->solution : coarse_solution_;
  fine.smoother.vmult(fine.solution, fine.right);
  float* const residual = fine.residual.begin();
  const float* const given = fine.right.begin();
  fine.matrix.stiffness.vmult(
      fine.residual, fine.solution, [](unsigned int, unsigned int) {},
      [&](unsigned int begin, unsigned int end) {
        for (unsigned int i = begin; i < end; ++i) residual[i] = given[i] - residual[i];
      });
  right = 0;
  fine.to_coarser->restrict_and_add(right, fine.residual);
  cycle(level - 1);
  fine.to_coarser->prolongate_and_add(fine.solution, correction);
  fine.smoother.step(fine.solution, fine.right);
}

/// z = V-cycle of r, scaled by its norm to stay within single precision.
void Multigrid::vmult(Vector& z, const Vector& r) const {
  const FlushSubnormals flush;
  const double norm = r.l2_norm();
  FloatVector& right = levels_.empty() ? coarse_right_ : levels_.back()->right;
  const FloatVector& solution = levels_.empty() ? coarse_solution_ : levels_.back()->solution;
  std::transform(r.begin(), r.end(), right.begin(),
                 [=](double value) { return static_cast<float>(value / norm); });
  // deal.II's loops on other threads flush subnormal numbers too.
  contact::within_threads([&] { cycle(levels_.size()); });
  std::transform(solution.begin(), solution.end(), z.begin(),
                 [=](float value) { return norm * static_cast<double>(value); });
}

/// Conjugate gradients from x. The Polak-Ribiere formula for beta ("flexible" in deal.II) tolerates
/// a preconditioner in single precision.
void Multigrid::iterate(Vector& x, const Vector& b, double target) const {
  dealii::SolverControl control(static_cast<unsigned int>(options_.max_iterations - iterations_),
                                target, false, false);
  dealii::PrimitiveVectorMemory<Vector> memory;
  try {
    dealii::SolverFlexibleCG<Vector>(control, memory).solve(*stiffness_, x, b, *this);
  } catch (const dealii::SolverControl::NoConvergence&) {
    // Decided by the true residual.
  }
  iterations_ += static_cast<int>(control.last_step());
}

void Multigrid::solve(Vector& u, const Vector& b) const {
  Vector right = stiffness_->make_vector(), x = right;
  std::copy_n(b.begin(), right.locally_owned_size(), right.begin());
  stiffness_->condense(right);
  const double scale = right.l2_norm(), target = options_.tolerance * scale;
  if (!std::isfinite(scale))
    throw contact::SolveError("multigrid: the load is not a finite number");
  iterations_ = 0;
  double norm = scale;
  // The true residual decides; a second pass corrects rounding errors of the recursive one.
  for (int pass = 0; pass < 3 && norm > target && scale > 0; ++pass) {
    iterate(x, right, pass == 0 ? target : 0.5 * target);
    Vector residual(right);
    stiffness_->vmult(residual, x);
    residual.sadd(-1.0, 1.0, right);
    norm = residual.l2_norm();
    if (!std::isfinite(norm)) break;
  }
  if (!(norm <= target))
    throw contact::SolveError(fmt::format(
        "multigrid: relative residual {:.2e} after {} iterations, required {:.1e} ({} unknowns)",
        norm / scale, iterations_, options_.tolerance, right.size()));
  stiffness_->distribute(x);
  std::copy(x.begin(), x.end(), u.begin());
  u.update_ghost_values();
}

std::string Multigrid::description() const {
  return fmt::format(
      "conjugate gradients, geometric multigrid of {} levels, {} unknowns on the coarsest",
      levels_.size() + 1, coarse_right_.size());
}

}  // namespace

std::unique_ptr<LinearSolver> make_multigrid(const ElasticProblem& problem,
                                             const MultigridOptions& options) {
  return std::make_unique<Multigrid>(problem, options);
}

}  // namespace rollfem::fem
