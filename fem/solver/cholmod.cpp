#include "fem/solver/cholmod.hpp"

#include "contact/base/errors.hpp"
#include "fem/solver/elasticity_assembly.hpp"
#include "fem/solver/elasticity_operator.hpp"

#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <limits>
#include <mutex>
#include <utility>

namespace rollfem::fem {

/// What CHOLMOD allocates, freed also when a constructor fails half-way.
struct CholeskyFactor::Cholmod {
  explicit Cholmod(FactorMessages texts) : messages(std::move(texts)) {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    // Nested dissection alone: trying AMD as well costs seconds and never won in 3D.
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() {
    cholmod_free_sparse(&matrix, &common);
    for (auto* dense : {&solution, &work, &more_work}) cholmod_free_dense(dense, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  void require(bool done) const {
    if (done && common.status == CHOLMOD_OK) return;
    throw contact::SolveError(fmt::format("{} failed: {}", messages.what, reason()));
  }
  std::string reason() const {
    switch (common.status) {
      case CHOLMOD_NOT_POSDEF:
        return "the stiffness is not positive definite (is the body held at its far boundary?)";
      case CHOLMOD_OUT_OF_MEMORY:
        return "memory ran out; do: " + messages.remedy;
      case CHOLMOD_TOO_LARGE:
        return "the factor is too large for 32-bit indices; do: " + messages.remedy;
      default:
        return fmt::format("CHOLMOD status {}", common.status);
    }
  }

  void factorise(cholmod_sparse* lower) {
    {
      // METIS draws from the one random sequence of the process: two orderings at a time would
      // differ from run to run, and with them the last digits of every result.
      static std::mutex one_at_a_time;
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      factor = cholmod_analyze(lower, &common);
    }
    require(factor != nullptr);
    require(cholmod_factorize(lower, factor, &common) != 0);
  }

  FactorMessages messages;
  cholmod_common common{};
  cholmod_sparse* matrix = nullptr;  ///< while it is factorised
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *more_work = nullptr;
};

CholeskyFactor::CholeskyFactor(const SymmetricMatrix& matrix, FactorMessages messages)
    : cholmod_(std::make_unique<Cholmod>(std::move(messages))) {
  if (matrix.column_start.back() > std::numeric_limits<int>::max()) {
    cholmod_->common.status = CHOLMOD_TOO_LARGE;
    cholmod_->require(false);
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
  cholmod_->factorise(&view);
}

CholeskyFactor::CholeskyFactor(const std::vector<MatrixEntry>& entries, std::size_t size,
                               FactorMessages messages)
    : cholmod_(std::make_unique<Cholmod>(std::move(messages))) {
  Cholmod& it = *cholmod_;
  cholmod_triplet* triplets =
      cholmod_allocate_triplet(size, size, entries.size(), -1, CHOLMOD_REAL, &it.common);
  it.require(triplets != nullptr);
  auto* row = static_cast<int*>(triplets->i);
  auto* column = static_cast<int*>(triplets->j);
  auto* value = static_cast<double*>(triplets->x);
  for (const MatrixEntry& entry : entries) {
    *row++ = static_cast<int>(entry.row);
    *column++ = static_cast<int>(entry.column);
    *value++ = entry.value;
  }
  triplets->nnz = entries.size();
  it.matrix = cholmod_triplet_to_sparse(triplets, entries.size(), &it.common);
  cholmod_free_triplet(&triplets, &it.common);
  it.require(it.matrix != nullptr);
  it.factorise(it.matrix);
  cholmod_free_sparse(&it.matrix, &it.common);
}

CholeskyFactor::~CholeskyFactor() = default;

const double* CholeskyFactor::solve(const std::vector<double>& b) const {
  Cholmod& it = *cholmod_;
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = b.size();
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  it.require(cholmod_solve2(CHOLMOD_A, it.factor, &right, nullptr, &it.solution, nullptr, &it.work,
                            &it.more_work, &it.common) != 0);
  return static_cast<const double*>(it.solution->x);
}

double CholeskyFactor::memory_bytes() const {
  return static_cast<double>(cholmod_->common.memory_inuse);
}

}  // namespace rollfem::fem
