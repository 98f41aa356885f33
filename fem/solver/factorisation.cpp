#include "fem/solver/factorisation.hpp"

#include "contact/base/errors.hpp"
#include "fem/solver/elasticity_assembly.hpp"

#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <random>

namespace rollfem::fem {

namespace {

/// A residual above this after the factorisation means that the factor is not to be trusted.
constexpr double largest_residual = 1e-9;

std::string reason(int status) {
  switch (status) {
    case CHOLMOD_NOT_POSDEF:
      return "the stiffness is not positive definite (is the body held at its far boundary?)";
    case CHOLMOD_OUT_OF_MEMORY:
      return "memory ran out; use a coarser fem.cell_size or linear_solver = \"multigrid\"";
    case CHOLMOD_TOO_LARGE:
      return "the factor is too large for 32-bit indices; use linear_solver = \"multigrid\"";
    default:
      return fmt::format("CHOLMOD status {}", status);
  }
}

/// What CHOLMOD allocates, freed also when a constructor fails half-way.
struct Cholmod {
  Cholmod() { cholmod_start(&common); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work, &common);
    cholmod_free_dense(&more_work, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work = nullptr;
  cholmod_dense* more_work = nullptr;
};

class Factorisation : public LinearSolver {
 public:
  explicit Factorisation(const ElasticProblem& problem) {
    if (problem.dofs.n_locally_owned_dofs() != problem.dofs.n_dofs())
      throw contact::InputError(
          "the factorisation runs in one process; use linear_solver = \"multigrid\" under MPI");
    unknowns_ = number_free_unknowns(problem.dofs, problem.constraints);
    choose_method();
    const auto matrix = assemble(problem, unknowns_);
    factorise(matrix);
    verify(matrix);
  }
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;

  void solve(Vector& u, const Vector& b) const override {
    unknowns_.condense(b, condensed_);
    unknowns_.expand(solve_free(condensed_), u);
    u.update_ghost_values();
  }
  int last_iterations() const override { return 0; }
  double memory_bytes() const override {
    const double entries = static_cast<double>(cholmod_.factor->xsize);
    return 8.0 * entries + 4.0 * static_cast<double>(cholmod_.factor->ssize) +
           12.0 * static_cast<double>(unknowns_.column.size());
  }
  std::string description() const override {
    return fmt::format("CHOLMOD factorisation, {} free unknowns, {:.2f} GB", unknowns_.count,
                       1e-9 * memory_bytes());
  }

 private:
  void choose_method() {
    cholmod_.common.supernodal = CHOLMOD_SUPERNODAL;
    cholmod_.common.print = 0;
    // Nested dissection alone: trying AMD as well costs seconds and never won in 3D.
    cholmod_.common.nmethods = 1;
    cholmod_.common.method[0].ordering = CHOLMOD_METIS;
    cholmod_.common.postorder = 1;
  }

  void require(bool done) const {
    if (!done || cholmod_.common.status != CHOLMOD_OK)
      throw contact::SolveError("factorisation of the stiffness failed: " +
                                reason(cholmod_.common.status));
  }

  void factorise(const SymmetricMatrix& matrix) {
    if (matrix.column_start.back() > std::numeric_limits<int>::max()) {
      cholmod_.common.status = CHOLMOD_TOO_LARGE;
      require(false);
    }
    // CHOLMOD wants 32-bit column starts; nothing is copied besides them.
    std::vector<int> column_start(matrix.column_start.begin(), matrix.column_start.end());
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(matrix.size);
    view.nzmax = matrix.row.size();
    view.p = column_start.data();
    view.i = const_cast<int*>(matrix.row.data());
    view.x = const_cast<double*>(matrix.value.data());
    view.stype = -1;  // the lower triangle is stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    {
      // METIS draws from the one random sequence of the process: two orderings at a time would
      // differ from run to run, and with them the last digits of every result.
      static std::mutex one_at_a_time;
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      cholmod_.factor = cholmod_analyze(&view, &cholmod_.common);
    }
    require(cholmod_.factor != nullptr);
    require(cholmod_factorize(&view, cholmod_.factor, &cholmod_.common) != 0);
  }

  /// The factor does not change afterwards, so that one check vouches for all later solves and the
  /// matrix need not be kept.
  void verify(const SymmetricMatrix& matrix) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> b(matrix.size);
    for (double& value : b) value = uniform(random);
    const double* const x = solve_free(b);
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

  /// Solution in CHOLMOD's own buffer, valid until the next call.
  const double* solve_free(std::vector<double>& b) const {
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = b.size();
    right.ncol = 1;
    right.x = b.data();
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    require(cholmod_solve2(CHOLMOD_A, cholmod_.factor, &right, nullptr, &cholmod_.solution, nullptr,
                           &cholmod_.work, &cholmod_.more_work, &cholmod_.common) != 0);
    return static_cast<const double*>(cholmod_.solution->x);
  }

  FreeUnknowns unknowns_;
  mutable Cholmod cholmod_;  // solving writes into its buffers
  mutable std::vector<double> condensed_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_factorisation(const ElasticProblem& problem) {
  return std::make_unique<Factorisation>(problem);
}

bool is_factorisation(const LinearSolver& solver) {
  return dynamic_cast<const Factorisation*>(&solver) != nullptr;
}

double predicted_factor_bytes(double unknowns) {
  // n^(4/3) is the growth of a nested-dissection factor in 3D; the constant is measured on graded
  // bodies of 41 000 to 325 000 unknowns (97 to 111).
  return 110.0 * std::pow(unknowns, 4.0 / 3.0);
}

}  // namespace rollfem::fem
