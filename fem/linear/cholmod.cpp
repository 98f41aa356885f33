// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/cholmod.hpp"

#include "base/errors.hpp"
#include "base/spares.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/discretisation/node_order.hpp"

#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <algorithm>
#include <dlfcn.h>
#include <limits>
#include <utility>
#include <vector>

namespace rollfem::fem {

namespace {

/// Disables OpenMP regions in this scope. CHOLMOD opens one with four threads at every large
/// supernode regardless of OMP_NUM_THREADS: with two bodies in parallel the threads wait for each
/// other, and on busy cores a factorisation took five times its CPU time. The OpenMP runtime loaded
/// by CHOLMOD is called dynamically, so that none is needed to build.
class SerialRegions {
 public:
  SerialRegions() {
    if (get_ == nullptr || set_ == nullptr) return;
    before_ = get_();
    set_(0);
  }
  ~SerialRegions() {
    if (get_ != nullptr && set_ != nullptr) set_(before_);
  }
  SerialRegions(const SerialRegions&) = delete;
  SerialRegions& operator=(const SerialRegions&) = delete;

 private:
  int (*get_)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
  void (*set_)(int) = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT,
                                                            "omp_set_max_active_levels"));
  int before_ = 1;
};

/// The nodes of a matrix from its columns: below the diagonal, the column of the next component of
/// a node has the same rows as the previous one, except its own.
Nodes find_nodes(const cholmod_sparse& lower) {
  const int size = static_cast<int>(lower.ncol);
  const auto* start = static_cast<const int*>(lower.p);
  const auto* row = static_cast<const int*>(lower.i);
  Nodes nodes;
  for (int c = 0; c < size; ++c)
    nodes.add(c > 0 && std::equal(row + start[c], row + start[c + 1],
                                  row + std::min(start[c - 1] + 1, start[c]), row + start[c]));
  return nodes;
}

}  // namespace

/// Objects allocated by CHOLMOD, also freed when a constructor fails half-way.
struct CholeskyFactor::Cholmod {
  /// Of one solve.
  struct Solve {
    cholmod_common common{};
    cholmod_dense *solution = nullptr, *work = nullptr, *more_work = nullptr;

    Solve() {
      cholmod_start(&common);
      common.print = 0;
    }
    Solve(const Solve&) = delete;
    Solve& operator=(const Solve&) = delete;
    ~Solve() {
      for (auto* dense : {&solution, &work, &more_work}) cholmod_free_dense(dense, &common);
      cholmod_finish(&common);
    }
  };

  explicit Cholmod(FactorMessages texts) : messages(std::move(texts)) {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.nmethods = 1;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() {
    cholmod_free_sparse(&matrix, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  void require(bool done) const { require(done, common); }
  void require(bool done, const cholmod_common& of) const {
    if (done && of.status == CHOLMOD_OK) return;
    throw contact::SolveError(fmt::format("{} failed: {}", messages.what, reason(of.status)));
  }
  std::string reason(int status) const {
    switch (status) {
      case CHOLMOD_NOT_POSDEF:
        return "the stiffness is not positive definite (is the body clamped at its far boundary?)";
      case CHOLMOD_OUT_OF_MEMORY:
        return "memory ran out; do: " + messages.remedy;
      case CHOLMOD_TOO_LARGE:
        return "the factor is too large for 32-bit indices; do: " + messages.remedy;
      default:
        return fmt::format("CHOLMOD status {}", status);
    }
  }

  /// `order`: elimination order, first to last; empty: the numbering.
  void factorise(cholmod_sparse* lower, std::vector<int> order) {
    const SerialRegions serial;
    common.method[0].ordering = order.empty() ? CHOLMOD_NATURAL : CHOLMOD_GIVEN;
    common.postorder = order.empty() ? 0 : 1;
    factor = cholmod_analyze_p(lower, order.empty() ? nullptr : order.data(), nullptr, 0, &common);
    require(factor != nullptr);
    require(cholmod_factorize(lower, factor, &common) != 0);
  }

  FactorMessages messages;
  cholmod_common common{};
  cholmod_sparse* matrix = nullptr;  ///< while it is factorised
  cholmod_factor* factor = nullptr;
  contact::Spares<Solve> solves;
};

CholeskyFactor::CholeskyFactor(const SymmetricMatrix& matrix, FactorMessages messages)
    : cholmod_(std::make_unique<Cholmod>(std::move(messages))) {
  if (matrix.column_start.back() > std::numeric_limits<int>::max()) {
    cholmod_->common.status = CHOLMOD_TOO_LARGE;
    cholmod_->require(false);
  }
  // CHOLMOD needs 32-bit column starts; nothing else is copied.
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
  cholmod_->factorise(&view, {});
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
  const Nodes nodes = find_nodes(*it.matrix);
  const auto* start = static_cast<const int*>(it.matrix->p);
  const auto* below = static_cast<const int*>(it.matrix->i);
  const NodeGraph graph(nodes, [&](int c, const auto& reach) {
    std::for_each(below + start[c], below + start[c + 1], reach);
  });
  it.factorise(it.matrix, nodes.unknowns(order_of_elimination(graph)));
  cholmod_free_sparse(&it.matrix, &it.common);
}

CholeskyFactor::~CholeskyFactor() = default;

void CholeskyFactor::solve(std::vector<double>& b, std::size_t right_sides) const {
  const Cholmod& it = *cholmod_;
  cholmod_dense right{};
  right.nrow = right.d = b.size() / right_sides;
  right.nzmax = b.size();
  right.ncol = right_sides;
  right.x = b.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  const SerialRegions serial;
  const auto own = it.solves.borrow();
  it.require(cholmod_solve2(CHOLMOD_A, it.factor, &right, nullptr, &own->solution, nullptr,
                            &own->work, &own->more_work, &own->common) != 0,
             own->common);
  std::copy_n(static_cast<const double*>(own->solution->x), b.size(), b.begin());
}

PartialFactor CholeskyFactor::part(const std::vector<bool>& of_unknowns) const {
  return {*cholmod_->factor, of_unknowns};
}

double CholeskyFactor::memory_bytes() const {
  return static_cast<double>(cholmod_->common.memory_inuse);
}

double CholeskyFactor::operations() const {
  return cholmod_->common.fl;
}

}  // namespace rollfem::fem
