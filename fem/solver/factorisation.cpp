#include "fem/solver/factorisation.hpp"

#include "contact/base/errors.hpp"
#include "fem/solver/cholmod.hpp"
#include "fem/solver/elasticity_assembly.hpp"
#include "fem/solver/mirrored_halves.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

/// A residual above this after the factorisation means that the factor is not to be trusted.
constexpr double largest_residual = 1e-9;

/// A stiffness in the free unknowns and its factor.
class Part {
 public:
  Part(const ElasticProblem& problem, FreeUnknowns unknowns) : unknowns_(std::move(unknowns)) {
    const auto matrix = assemble(problem, unknowns_);
    factor_ = std::make_unique<CholeskyFactor>(
        matrix, FactorMessages{"factorisation of the stiffness",
                               "use a coarser fem.cell_size or linear_solver = \"multigrid\""});
    verify(matrix);
  }
  /// u += weight C K^-1 C^T b.
  void add_solution(double weight, const Vector& b, Vector& u) const {
    unknowns_.condense(b, condensed_);
    for (double& value : condensed_) value *= weight;
    unknowns_.expand_and_add(factor_->solve(condensed_), u);
  }
  int unknowns() const { return unknowns_.count; }
  double memory_bytes() const {
    return factor_->memory_bytes() + 12.0 * static_cast<double>(unknowns_.column.size());
  }

 private:
  /// The factor does not change afterwards, so that one check vouches for all later solves and the
  /// matrix need not be kept.
  void verify(const SymmetricMatrix& matrix) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> b(matrix.size);
    for (double& value : b) value = uniform(random);
    const double* const x = factor_->solve(b);
    std::vector<double> product;
    matrix.multiply(std::vector<double>(x, x + matrix.size), product);
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
  mutable std::vector<double> condensed_;
};

class Factorisation : public LinearSolver {
 public:
  explicit Factorisation(const ElasticProblem& problem) {
    if (problem.dofs.n_locally_owned_dofs() != problem.dofs.n_dofs())
      throw contact::InputError(
          "the factorisation runs in one process; use linear_solver = \"multigrid\" under MPI");
    if (auto halves = find_mirrored_halves(problem)) {
      parts_.emplace_back(problem, std::move(halves->even));
      parts_.emplace_back(problem, std::move(halves->odd));
    } else {
      parts_.emplace_back(problem, number_free_unknowns(problem.dofs, problem.constraints));
    }
  }
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;

  void solve(Vector& u, const Vector& b) const override {
    u = 0.0;
    const double weight = 1.0 / static_cast<double>(parts_.size());
    for (const Part& part : parts_) part.add_solution(weight, b, u);
    u.update_ghost_values();
  }
  int last_iterations() const override { return 0; }
  bool runs_beside_others() const override { return true; }
  double memory_bytes() const override {
    return std::accumulate(parts_.begin(), parts_.end(), 0.0,
                           [](double sum, const Part& part) { return sum + part.memory_bytes(); });
  }
  std::string description() const override {
    const int unknowns =
        std::accumulate(parts_.begin(), parts_.end(), 0,
                        [](int sum, const Part& part) { return sum + part.unknowns(); });
    return fmt::format("CHOLMOD factorisation{}, {} free unknowns, {:.2f} GB",
                       parts_.size() > 1 ? " of mirrored halves" : "", unknowns,
                       1e-9 * memory_bytes());
  }

 private:
  std::vector<Part> parts_;
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
