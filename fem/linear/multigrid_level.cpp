// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/multigrid_level.hpp"

#include "contact/base/pieces.hpp"
#include "fem/linear/first_process.hpp"

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rollfem::fem {

namespace {

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

}  // namespace

MultigridLevel::MultigridLevel(const LocalCells& cells, std::unique_ptr<LevelTransfer> to_coarser,
                               int smoother_degree)
    : stiffness_(cells, straightened),
      to_coarser_(std::move(to_coarser)),
      inverse_diagonal_(stiffness_.inverse_diagonal()),
      degree_(std::max(smoother_degree, 1)) {
  const double largest = largest_eigenvalue(stiffness_, inverse_diagonal_);
  const double smallest = largest / (range_per_degree * degree_);
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
  for (int k = 1; k < degree_; ++k) {
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

}  // namespace rollfem::fem
