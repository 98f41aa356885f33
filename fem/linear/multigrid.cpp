// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/multigrid.hpp"

#include "base/errors.hpp"
#include "base/pieces.hpp"
#include "base/spares.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/cholmod.hpp"
#include "fem/linear/flush_subnormals.hpp"
#include "fem/linear/level_transfer.hpp"
#include "fem/linear/memory.hpp"
#include "fem/linear/root_process.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mpi.h>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

// One level of geometric multigrid above the coarsest: its smoother and the transfer to the next
// coarser one. Single precision, it only preconditions.

class MultigridLevel {
 public:
  /// Vectors of one solve.
  struct Work {
    FloatVector solution, right, product, before;
  };
  MultigridLevel(const LocalCells& cells, std::unique_ptr<LevelTransfer> to_coarser);
  Work make_work() const;
  /// The Chebyshev iteration (Saad, Iterative Methods for Sparse Linear Systems, algorithm 12.1)
  /// towards K^-1 right for the eigenvalues of D^-1 K in the range of the smoother,
  /// `smoother_degree` products; from a solution of zero one of them is saved, and `solution` need
  /// not be set.
  void smooth(Work& at, bool from_zero) const;
  /// Sets the right-hand side of the next coarser level to the restricted residual.
  void restrict_residual(Work& at, FloatVector& coarser) const;
  void prolongate(Work& at, const FloatVector& correction) const {
    to_coarser_->prolongate_and_add(at.solution, correction);
  }

 private:
  void advance(Work& at, double along, double step) const;

  ElasticityOperator<float> stiffness_;
  std::unique_ptr<LevelTransfer> to_coarser_;
  FloatVector inverse_diagonal_;
  double middle_ = 0.0, half_width_ = 0.0;  ///< of the range of eigenvalues
};

/// Matrix products before, and again after, the coarse correction.
constexpr int smoother_degree = 6;

/// Ratio of largest to smallest damped eigenvalue for one degree of the polynomial. Isotropic cells
/// need less; with the cells of aspect 3 that graded meshes have, wider ranges save a third of the
/// iterations (measured: degree 4 to 8, ratios 15 to 100; flat from 8 to 20 times the degree).
constexpr double range_per_degree = 10;

/// Cells bent by less than this are parallelepipeds in the preconditioner: the range of eigenvalues
/// widens by twice as much, without additional iterations.
constexpr double straightened = 0.02;

/// The stiffness in the interface through which deal.II estimates its eigenvalues.
struct ScaledMatrix : dealii::Subscriptor {
  explicit ScaledMatrix(const ElasticityOperator<float>& of)
      : stiffness(of), rows(of.make_vector().size()) {}
  void vmult(FloatVector& product, const FloatVector& x) const { stiffness.vmult(product, x); }
  FloatVector::size_type m() const { return rows; }
  /// Required by deal.II only if no diagonal is given, but one is.
  float el(FloatVector::size_type, FloatVector::size_type) const {
    throw std::logic_error("the smoother's diagonal is given");
  }

  const ElasticityOperator<float>& stiffness;
  FloatVector::size_type rows;
};

/// The estimate of the largest eigenvalue of D^-1 K by conjugate gradients, with deal.II's margin.
double largest_eigenvalue(const ElasticityOperator<float>& stiffness, const FloatVector& diagonal) {
  using Diagonal = dealii::DiagonalMatrix<FloatVector>;
  dealii::PreconditionChebyshev<ScaledMatrix, FloatVector, Diagonal> estimate;
  const ScaledMatrix matrix(stiffness);
  decltype(estimate)::AdditionalData data;
  data.eig_cg_n_iterations = 15;
  data.smoothing_range = range_per_degree;
  data.degree = 1;
  data.preconditioner = std::make_shared<Diagonal>(diagonal);
  estimate.initialize(matrix, data);
  double largest = 0.0;
  one_at_a_time([&] {  // deal.II's stores of vectors are the process's
    largest = estimate.estimate_eigenvalues(diagonal).max_eigenvalue_estimate;
  });
  return largest;
}

MultigridLevel::MultigridLevel(const LocalCells& cells, std::unique_ptr<LevelTransfer> to_coarser)
    : stiffness_(cells, straightened),
      to_coarser_(std::move(to_coarser)),
      inverse_diagonal_(stiffness_.inverse_diagonal()) {
  const double largest = largest_eigenvalue(stiffness_, inverse_diagonal_);
  const double smallest = largest / (range_per_degree * smoother_degree);
  middle_ = 0.5 * (largest + smallest);
  half_width_ = 0.5 * (largest - smallest);
}

MultigridLevel::Work MultigridLevel::make_work() const {
  Work work;
  for (FloatVector* vector : {&work.solution, &work.right, &work.product, &work.before})
    *vector = stiffness_.make_vector();
  return work;
}

/// x <- x + along (x - before) + step D^-1 (right - K x).
void MultigridLevel::advance(Work& at, double along, double step) const {
  const float *const x = at.solution.begin(), *const b = at.right.begin(),
                     *const scale = inverse_diagonal_.begin(), *const product = at.product.begin();
  float* const before = at.before.begin();
  const auto of_before = static_cast<float>(along), of_residual = static_cast<float>(step),
             of_x = static_cast<float>(1.0 + along);
  stiffness_.vmult(at.product, at.solution, {}, [&](unsigned int first, unsigned int end) {
    for (unsigned int i = first; i < end; ++i)
      before[i] =
          of_x * x[i] - of_before * before[i] + of_residual * scale[i] * (b[i] - product[i]);
  });
  at.solution.swap(at.before);
}

void MultigridLevel::smooth(Work& at, bool from_zero) const {
  const double first_step = 1.0 / middle_;
  if (from_zero) {
    contact::for_each_element(at.solution.locally_owned_size(), [&](std::ptrdiff_t i) {
      at.before.begin()[i] = 0.0F;
      at.solution.begin()[i] =
          static_cast<float>(first_step) * inverse_diagonal_.begin()[i] * at.right.begin()[i];
    });
  } else {
    advance(at, 0.0, first_step);
  }
  double along = half_width_ / middle_;
  for (int k = 1; k < smoother_degree; ++k) {
    const double next = 1.0 / (2.0 * middle_ / half_width_ - along);
    advance(at, next * along, 2.0 * next / half_width_);
    along = next;
  }
}

void MultigridLevel::restrict_residual(Work& at, FloatVector& coarser) const {
  stiffness_.residual(at.product, at.right, at.solution);
  std::fill(coarser.begin(), coarser.end(), 0.0F);
  to_coarser_->restrict_and_add(coarser, at.product);
}

/// Counts of all processes in order, and where each begins in a gathered list.
struct GatherLayout {
  std::vector<int> counts, offsets;

  GatherLayout(std::size_t mine, MPI_Comm communicator)
      : counts(dealii::Utilities::MPI::n_mpi_processes(communicator) == 1
                   ? std::vector<int>{static_cast<int>(mine)}
                   : dealii::Utilities::MPI::all_gather(communicator, static_cast<int>(mine))),
        offsets(counts.size(), 0) {
    std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
  }
  std::size_t sum() const {
    return static_cast<std::size_t>(offsets.back()) + static_cast<std::size_t>(counts.back());
  }
};

/// Direct solution on the coarsest level, where iterations fail on the stretched cells of a graded
/// mesh: its matrix is gathered and factorised on the root process.
class CoarseSolver {
 public:
  /// `entries`: contributions of this process to the lower triangle; `owned`: number of unknowns it
  /// owns, consecutive over the processes. Collective. Throws contact::SolveError when the matrix
  /// is not positive definite (the body is not clamped) or memory runs out.
  CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t owned, MPI_Comm communicator);

  /// x = K^-1 b in owned entries, collective.
  void solve(FloatVector& x, const FloatVector& b) const;

 private:
  MPI_Comm communicator_;
  // On the root process only.
  std::unique_ptr<CholeskyFactor> factor_;
  std::vector<int> counts_, offsets_;  ///< ranges owned by the processes
  std::size_t size_ = 0;               ///< of the matrix
};

CoarseSolver::CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t owned,
                           MPI_Comm communicator)
    : communicator_(communicator) {
  GatherLayout layout(owned, communicator);
  std::vector<MatrixEntry> all = entries;
  if (layout.counts.size() > 1) {
    all.clear();
    for (const auto& part : dealii::Utilities::MPI::gather(communicator, entries, 0))
      all.insert(all.end(), part.begin(), part.end());
  }
  RootProcess(communicator).run([&] {
    size_ = layout.sum();
    factor_ = std::make_unique<CholeskyFactor>(
        all, size_, FactorMessages{"coarse solve of the multigrid", "use a coarser fem.cell_size"});
  });
  if (layout.counts.size() == 1) return;
  counts_ = std::move(layout.counts);
  offsets_ = std::move(layout.offsets);
}

/// A single process does not call MPI (Multigrid::runs_beside_others).
void CoarseSolver::solve(FloatVector& x, const FloatVector& b) const {
  const auto owned = static_cast<int>(b.locally_owned_size());
  std::vector<float> gathered(counts_.empty() ? 0 : size_);
  if (!counts_.empty())
    MPI_Gatherv(b.begin(), owned, MPI_FLOAT, gathered.data(), counts_.data(), offsets_.data(),
                MPI_FLOAT, 0, communicator_);
  if (factor_) {
    const float* const right = counts_.empty() ? b.begin() : gathered.data();
    std::vector<double> values(right, right + size_);
    factor_->solve(values);
    std::transform(values.begin(), values.end(), counts_.empty() ? x.begin() : gathered.data(),
                   [](double value) { return static_cast<float>(value); });
  }
  if (!counts_.empty())
    MPI_Scatterv(gathered.data(), counts_.data(), offsets_.data(), MPI_FLOAT, x.begin(), owned,
                 MPI_FLOAT, 0, communicator_);
}

/// a b, of all processes.
double product_of(const Vector& a, const Vector& b) {
  const double sum = contact::sum_in_pieces(a.locally_owned_size(), [&](auto first, auto count) {
    return std::inner_product(a.begin() + first, a.begin() + first + count, b.begin() + first, 0.0);
  });
  const auto& partitioner = *a.get_partitioner();
  return partitioner.n_mpi_processes() == 1
             ? sum
             : dealii::Utilities::MPI::sum(sum, partitioner.get_mpi_communicator());
}

double norm_of(const Vector& a) {
  return std::sqrt(product_of(a, a));
}

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
  Multigrid(const ElasticProblem& problem, const IterationLimits& limits);

  void solve(Vector& u, const Vector& b) const override;
  void solve_all(std::vector<Vector>& u, const std::vector<Vector>& b) const override;
  int last_iterations() const override { return iterations_; }
  std::string description() const override;
  /// MPI allows one thread only; a single process does not call it.
  bool runs_beside_others() const override {
    return coarse_vector_.get_partitioner()->n_mpi_processes() == 1;
  }

 private:
  /// Vectors of one solve.
  struct Work {
    std::vector<MultigridLevel::Work> levels;
    FloatVector coarse_solution, coarse_right;
    Vector right, solution, residual, preconditioned, direction, product;
    int iterations = 0;

    FloatVector& right_of(std::size_t level) {
      return level == 0 ? coarse_right : levels[level - 1].right;
    }
    const FloatVector& solution_of(std::size_t level) const {
      return level == 0 ? coarse_solution : levels[level - 1].solution;
    }
  };
  void factorise_coarsest(const LocalCells& cells);
  std::unique_ptr<Work> make_work() const;
  void cycle(std::size_t level, Work& work) const;
  void precondition(Work& work, double norm) const;
  void iterate(Work& work, double target) const;

  IterationLimits limits_;
  std::unique_ptr<ElasticityOperator<double>> stiffness_;
  std::vector<std::unique_ptr<MultigridLevel>>
      levels_;  ///< from coarse to fine, without the coarsest
  std::unique_ptr<CoarseSolver> coarse_;
  FloatVector coarse_vector_;  ///< of the coarsest level's layout
  contact::Spares<Work> work_;
  mutable std::atomic<int> iterations_{0};
};

Multigrid::Multigrid(const ElasticProblem& problem, const IterationLimits& limits)
    : limits_(limits) {
  if (problem.material.poisson_ratio > largest_multigrid_poisson_ratio)
    throw contact::InputError(fmt::format(
        "poisson_ratio = {}: multigrid does not converge for nearly incompressible bodies; "
        "allowed: up to {}; do: linear_solver = \"factorisation\", without mpirun",
        problem.material.poisson_ratio, largest_multigrid_poisson_ratio));
  std::vector<std::shared_ptr<const dealii::Triangulation<3>>> meshes;
  std::vector<std::unique_ptr<Discretisation>> discretised;
  one_at_a_time([&] {
    meshes = coarsened_meshes(problem);
    for (std::size_t i = 0; i + 1 < meshes.size(); ++i)
      discretised.push_back(std::make_unique<Discretisation>(*meshes[i], problem));
    discretised.push_back(std::make_unique<Discretisation>(problem));
  });
  std::vector<std::unique_ptr<LevelTransfer>> transfers(discretised.size());
  beside_or_in_turn(problem.dofs.get_communicator(), transfers.size() - 1, [&](std::size_t i) {
    transfers[i + 1] = discretised[i + 1]->transfer_to(*discretised[i]);
  });
  return_freed_memory();
  LocalCells cells = discretised.front()->cells();
  factorise_coarsest(cells);
  for (std::size_t i = 1; i < discretised.size(); ++i) {
    discretised[i - 1].reset();
    cells = {};
    cells = discretised[i]->cells();
    levels_.push_back(std::make_unique<MultigridLevel>(cells, std::move(transfers[i])));
  }
  discretised.clear();
  one_at_a_time([&] { meshes.clear(); });
  stiffness_ = std::make_unique<ElasticityOperator<double>>(std::move(cells));
  cells = {};
  return_freed_memory();
}

void Multigrid::factorise_coarsest(const LocalCells& cells) {
  const ElasticityOperator<double> stiffness(cells);
  const auto& owned = cells.dofs->owned_only;
  coarse_ = std::make_unique<CoarseSolver>(stiffness.assemble(), owned->locally_owned_size(),
                                           owned->get_mpi_communicator());
  coarse_vector_.reinit(owned);
}

std::unique_ptr<Multigrid::Work> Multigrid::make_work() const {
  auto work = std::make_unique<Work>();
  for (const auto& level : levels_) work->levels.push_back(level->make_work());
  work->coarse_solution = work->coarse_right = coarse_vector_;
  for (Vector* vector : {&work->right, &work->solution, &work->residual, &work->preconditioned,
                         &work->direction, &work->product})
    *vector = stiffness_->make_vector();
  return work;
}

/// V-cycle: solution on level `level` (the coarsest is 0) from its right-hand side.
void Multigrid::cycle(std::size_t level, Work& work) const {
  if (level == 0) return coarse_->solve(work.coarse_solution, work.coarse_right);
  const MultigridLevel& fine = *levels_[level - 1];
  MultigridLevel::Work& at = work.levels[level - 1];
  fine.smooth(at, true);
  fine.restrict_residual(at, work.right_of(level - 1));
  cycle(level - 1, work);
  fine.prolongate(at, work.solution_of(level - 1));
  fine.smooth(at, false);
}

/// V-cycle of the residual, scaled by its norm to stay within single precision.
void Multigrid::precondition(Work& work, double norm) const {
  const FlushSubnormals flush;
  const std::size_t finest = levels_.size(), size = work.residual.locally_owned_size();
  FloatVector& right = work.right_of(finest);
  contact::for_each_element(size, [&](std::ptrdiff_t i) {
    right.begin()[i] = static_cast<float>(work.residual.begin()[i] / norm);
  });
  cycle(finest, work);
  const float* const solution = work.solution_of(finest).begin();
  contact::for_each_element(size, [&](std::ptrdiff_t i) {
    work.preconditioned.begin()[i] = norm * static_cast<double>(solution[i]);
  });
}

/// Conjugate gradients from the solution and its residual. The Polak-Ribiere formula for beta
/// tolerates a preconditioner in single precision (Golub and Ye, SIAM J. Sci. Comput. 21, 1999).
void Multigrid::iterate(Work& work, double target) const {
  double before = 0.0, step = 0.0;
  for (; work.iterations < limits_.max_iterations; ++work.iterations) {
    const double norm = norm_of(work.residual);
    if (!(norm > target)) return;
    precondition(work, norm);
    const double along = product_of(work.preconditioned, work.residual);
    // The residual has changed by -step times the last product.
    const double beta =
        before == 0.0 ? 0.0 : -step * product_of(work.preconditioned, work.product) / before;
    stiffness_->vmult(work.product, work.direction,
                      [&](unsigned int first, unsigned int end) {
                        double* const direction = work.direction.begin();
                        for (unsigned int i = first; i < end; ++i)
                          direction[i] = work.preconditioned.begin()[i] + beta * direction[i];
                      },
                      {});
    step = along / product_of(work.direction, work.product);
    contact::for_each_element(work.residual.locally_owned_size(), [&](std::ptrdiff_t i) {
      work.solution.begin()[i] += step * work.direction.begin()[i];
      work.residual.begin()[i] -= step * work.product.begin()[i];
    });
    before = along;
  }
}

void Multigrid::solve(Vector& u, const Vector& b) const {
  const auto borrowed = work_.borrow([&] { return make_work(); });
  Work& work = *borrowed;
  std::copy_n(b.begin(), work.right.locally_owned_size(), work.right.begin());
  stiffness_->condense(work.right);
  const double scale = norm_of(work.right), target = limits_.tolerance * scale;
  if (!std::isfinite(scale))
    throw contact::SolveError("multigrid: the load is not a finite number");
  std::fill(work.solution.begin(), work.solution.end(), 0.0);
  std::fill(work.direction.begin(), work.direction.end(), 0.0);
  std::copy(work.right.begin(), work.right.end(), work.residual.begin());
  work.iterations = 0;
  double norm = scale;
  // The true residual decides; a second pass corrects rounding errors of the recursive one.
  for (int pass = 0; pass < 3 && norm > target && scale > 0; ++pass) {
    iterate(work, pass == 0 ? target : 0.5 * target);
    stiffness_->residual(work.residual, work.right, work.solution);
    norm = norm_of(work.residual);
    if (!std::isfinite(norm)) break;
  }
  iterations_ = work.iterations;
  if (!(norm <= target))
    throw contact::SolveError(fmt::format(
        "multigrid: relative residual {:.2e} after {} iterations, required {:.1e} ({} unknowns)",
        norm / scale, work.iterations, limits_.tolerance, work.right.size()));
  stiffness_->distribute(work.solution);
  std::copy(work.solution.begin(), work.solution.end(), u.begin());
  u.update_ghost_values();
}

void Multigrid::solve_all(std::vector<Vector>& u, const std::vector<Vector>& b) const {
  const std::size_t side_by_side =
      runs_beside_others() ? std::min(b.size(), solves_in_memory(u.front().size())) : 1;
  contact::for_each_index(side_by_side, [&](std::size_t first) {
    for (std::size_t k = first; k < b.size(); k += side_by_side) solve(u[k], b[k]);
  });
}

std::string Multigrid::description() const {
  return fmt::format(
      "conjugate gradients, geometric multigrid of {} levels, {} unknowns on the coarsest",
      levels_.size() + 1, coarse_vector_.size());
}

}  // namespace

std::unique_ptr<LinearSolver> make_multigrid(const ElasticProblem& problem,
                                             const IterationLimits& limits) {
  return std::make_unique<Multigrid>(problem, limits);
}

}  // namespace rollfem::fem
