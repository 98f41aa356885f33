// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/factorisation.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"
#include "fem/linear/cholmod.hpp"
#include "fem/linear/mirrored_halves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

/// A residual above this after the factorisation means that the factor is unreliable.
constexpr double largest_residual = 1e-9;

/// More do not help and take memory.
constexpr std::size_t right_sides_at_once = 16;

/// A stiffness in the free unknowns and its factor.
class Part {
 public:
  /// Matrix of the unknowns, numbered in elimination order.
  Part(FreeUnknowns unknowns, const SymmetricMatrix& matrix) : unknowns_(std::move(unknowns)) {
    factor_ = std::make_unique<CholeskyFactor>(
        matrix, FactorMessages{"factorisation of the stiffness",
                               "use a coarser fem.cell_size or linear_solver = \"multigrid\""});
    verify(matrix);
  }
  /// weight K^-1 C^T b, for `count` right-hand sides at once.
  std::vector<double> solutions(double weight, const Vector* b, std::size_t count) const {
    const auto size = static_cast<std::size_t>(unknowns_.count);
    std::vector<double> condensed, right(count * size);
    for (std::size_t k = 0; k < count; ++k) {
      unknowns_.condense(b[k], condensed);
      std::transform(condensed.begin(), condensed.end(), right.begin() + k * size,
                     [=](double value) { return weight * value; });
    }
    factor_->solve(right, count);
    return right;
  }
  /// The part of the factor for these unknowns of the body.
  PartialFactor part(const std::vector<dealii::types::global_dof_index>& of_unknowns) const {
    std::vector<bool> wanted(unknowns_.count, false);
    for (const auto i : of_unknowns)
      for (auto k = unknowns_.row_start[i]; k < unknowns_.row_start[i + 1]; ++k)
        wanted[unknowns_.column[k]] = true;
    return factor_->part(wanted);
  }
  /// The first of solutions() by part of the factor.
  std::vector<double> solution(double weight, const Vector& b, const PartialFactor& part) const {
    std::vector<double> x;
    unknowns_.condense(b, x);
    Eigen::Map<Eigen::VectorXd> all(x.data(), unknowns_.count);
    Eigen::VectorXf single = (weight * all).cast<float>();
    part.solve(single);
    all = single.cast<double>();
    return x;
  }
  /// u += C x.
  void add(const std::vector<double>& x, std::size_t count, Vector* u) const {
    for (std::size_t k = 0; k < count; ++k)
      unknowns_.expand_and_add(&x[k * static_cast<std::size_t>(unknowns_.count)], u[k]);
  }
  int unknowns() const { return unknowns_.count; }
  double memory_bytes() const {
    return factor_->memory_bytes() + 12.0 * static_cast<double>(unknowns_.column.size());
  }

 private:
  /// The factor does not change afterwards, so that one check covers all later solves and the
  /// matrix need not be kept.
  void verify(const SymmetricMatrix& matrix) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> b(matrix.size);
    for (double& value : b) value = uniform(random);
    std::vector<double> x = b, product;
    factor_->solve(x);
    matrix.multiply(x, product);
    double residual = 0.0;
    double scale = 0.0;
    for (int i = 0; i < matrix.size; ++i) {
      residual += (product[i] - b[i]) * (product[i] - b[i]);
      scale += b[i] * b[i];
    }
    if (!(std::sqrt(residual) <= largest_residual * std::sqrt(scale)))
      throw contact::SolveError(
          fmt::format("factorisation of the stiffness: relative residual {:.1e} is above {:.0e}",
                      std::sqrt(residual / scale), largest_residual));
  }

  FreeUnknowns unknowns_;
  std::unique_ptr<CholeskyFactor> factor_;
};

using Parts = std::vector<std::unique_ptr<Part>>;

/// u = sum over the parts of C solution(part, weight).
template <class Solution>
void solve_parts(const Parts& parts, Vector* u, std::size_t count, const Solution& solution) {
  std::for_each(u, u + count, [](Vector& of_one) { of_one = 0.0; });
  const double weight = 1.0 / static_cast<double>(parts.size());
  std::vector<std::vector<double>> x(parts.size());
  contact::for_each_index(parts.size(), [&](std::size_t k) { x[k] = solution(k, weight); });
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k]->add(x[k], count, u);
  std::for_each(u, u + count, [](const Vector& of_one) { of_one.update_ghost_values(); });
}

class PartialFactorisation : public LinearSolver {
 public:
  PartialFactorisation(const Parts& parts,
                       const std::vector<dealii::types::global_dof_index>& unknowns)
      : parts_(parts), factors_(parts.size()) {
    contact::for_each_index(parts.size(), [&](std::size_t k) {
      factors_[k] = std::make_unique<PartialFactor>(parts[k]->part(unknowns));
    });
  }
  void solve(Vector& u, const Vector& b) const override {
    solve_parts(parts_, &u, 1, [&](std::size_t k, double weight) {
      return parts_[k]->solution(weight, b, *factors_[k]);
    });
  }
  int last_iterations() const override { return 0; }
  bool runs_beside_others() const override { return true; }
  std::string description() const override {
    double bytes = 0.0;
    for (const auto& factor : factors_) bytes += factor->memory_bytes();
    return fmt::format("single precision, {:.2f} GB", 1e-9 * bytes);
  }

 private:
  const Parts& parts_;
  std::vector<std::unique_ptr<PartialFactor>> factors_;
};

class Factorisation : public LinearSolver {
 public:
  explicit Factorisation(const ElasticProblem& problem) {
    if (problem.dofs.n_locally_owned_dofs() != problem.dofs.n_dofs())
      throw contact::InputError(
          "the factorisation runs in one process; use linear_solver = \"multigrid\" under MPI");
    std::vector<FreeUnknowns> unknowns;
    if (auto halves = find_mirrored_halves(problem))
      unknowns = {std::move(halves->even), std::move(halves->odd)};
    else
      unknowns = {number_free_unknowns(problem.dofs, problem.constraints)};
    std::vector<const FreeUnknowns*> of_parts;
    for (FreeUnknowns& of_part : unknowns) {
      order_for_elimination(problem.dofs, of_part);
      of_parts.push_back(&of_part);
    }
    std::vector<SymmetricMatrix> matrices = assemble(problem, of_parts);
    parts_.resize(unknowns.size());
    contact::for_each_index(parts_.size(), [&](std::size_t k) {
      parts_[k] = std::make_unique<Part>(std::move(unknowns[k]), matrices[k]);
      matrices[k] = {};
    });
  }
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;

  void solve(Vector& u, const Vector& b) const override { solve_some(&u, &b, 1); }
  void solve_all(std::vector<Vector>& u, const std::vector<Vector>& b) const override {
    for (std::size_t first = 0; first < b.size(); first += right_sides_at_once)
      solve_some(&u[first], &b[first], std::min(right_sides_at_once, b.size() - first));
  }
  std::unique_ptr<LinearSolver> in_part(
      const std::vector<dealii::types::global_dof_index>& unknowns) const override {
    return std::make_unique<PartialFactorisation>(parts_, unknowns);
  }
  int last_iterations() const override { return 0; }
  bool runs_beside_others() const override { return true; }
  std::string description() const override {
    int unknowns = 0;
    double bytes = 0.0;
    for (const auto& part : parts_) {
      unknowns += part->unknowns();
      bytes += part->memory_bytes();
    }
    return fmt::format("CHOLMOD factorisation{}, {} free unknowns, {:.2f} GB",
                       parts_.size() > 1 ? " of mirrored halves" : "", unknowns, 1e-9 * bytes);
  }

 private:
  void solve_some(Vector* u, const Vector* b, std::size_t count) const {
    solve_parts(parts_, u, count, [&](std::size_t k, double weight) {
      return parts_[k]->solutions(weight, b, count);
    });
  }

  Parts parts_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_factorisation(const ElasticProblem& problem) {
  return std::make_unique<Factorisation>(problem);
}

double predicted_factor_bytes(double unknowns) {
  // n^(4/3) is the growth of a nested-dissection factor in 3D; the constant is measured on graded
  // bodies of 41 000 to 325 000 unknowns (97 to 111).
  return 110.0 * std::pow(unknowns, 4.0 / 3.0);
}

}  // namespace rollfem::fem
