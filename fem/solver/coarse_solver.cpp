#include "fem/solver/coarse_solver.hpp"

#include "contact/base/errors.hpp"

#include <deal.II/base/mpi.h>
#include <suitesparse/cholmod.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace rollfem::fem {

namespace {

/// The contributions of all processes, on all processes.
std::vector<MatrixEntry> gather(const std::vector<MatrixEntry>& mine, MPI_Comm communicator) {
  const auto processes = dealii::Utilities::MPI::n_mpi_processes(communicator);
  if (processes == 1) return mine;
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(processes), offsets(processes, 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
  std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
  MPI_Datatype entry;
  MPI_Type_contiguous(sizeof(MatrixEntry), MPI_BYTE, &entry);
  MPI_Type_commit(&entry);
  std::vector<MatrixEntry> all(static_cast<std::size_t>(offsets.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, entry, all.data(), counts.data(), offsets.data(), entry,
                 communicator);
  MPI_Type_free(&entry);
  return all;
}

}  // namespace

struct CoarseSolver::Implementation {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *right = nullptr, *solution = nullptr, *work1 = nullptr, *work2 = nullptr;
  std::size_t first = 0;
  MPI_Comm communicator = MPI_COMM_NULL;

  Implementation() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
  }
  ~Implementation() {
    for (auto* dense : {&right, &solution, &work1, &work2}) cholmod_free_dense(dense, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void factorise(const std::vector<MatrixEntry>& entries, std::size_t size);
};

void CoarseSolver::Implementation::factorise(const std::vector<MatrixEntry>& entries,
                                             std::size_t size) {
  cholmod_triplet* triplets =
      cholmod_allocate_triplet(size, size, entries.size(), -1, CHOLMOD_REAL, &common);
  if (triplets == nullptr) throw contact::SolveError("coarse solve: out of memory");
  auto* row = static_cast<int*>(triplets->i);
  auto* column = static_cast<int*>(triplets->j);
  auto* value = static_cast<double*>(triplets->x);
  for (const auto& entry : entries) {
    *row++ = static_cast<int>(entry.row);
    *column++ = static_cast<int>(entry.column);
    *value++ = entry.value;
  }
  triplets->nnz = entries.size();
  cholmod_sparse* matrix = cholmod_triplet_to_sparse(triplets, entries.size(), &common);
  cholmod_free_triplet(&triplets, &common);
  if (matrix != nullptr) {
    factor = cholmod_analyze(matrix, &common);
    if (factor != nullptr) cholmod_factorize(matrix, factor, &common);
    cholmod_free_sparse(&matrix, &common);
  }
  if (common.status == CHOLMOD_NOT_POSDEF)
    throw contact::SolveError(
        "coarse solve: the stiffness is not positive definite; is a boundary clamped?");
  if (common.status < CHOLMOD_OK || factor == nullptr)
    throw contact::SolveError("coarse solve: factorisation of " + std::to_string(size) +
                              " unknowns failed (CHOLMOD status " + std::to_string(common.status) +
                              "); make the coarse mesh smaller");
  right = cholmod_zeros(size, 1, CHOLMOD_REAL, &common);
}

CoarseSolver::CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t size,
                           std::size_t first, MPI_Comm communicator)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->first = first;
  implementation_->communicator = communicator;
  implementation_->factorise(gather(entries, communicator), size);
}

CoarseSolver::~CoarseSolver() = default;

void CoarseSolver::solve(VectorType& x, const VectorType& b) const {
  auto& it = *implementation_;
  auto* right = static_cast<double*>(it.right->x);
  const int size = static_cast<int>(it.right->nrow);
  std::fill_n(right, size, 0.0);
  std::copy(b.begin(), b.end(), right + it.first);
  if (dealii::Utilities::MPI::n_mpi_processes(it.communicator) > 1)
    MPI_Allreduce(MPI_IN_PLACE, right, size, MPI_DOUBLE, MPI_SUM, it.communicator);
  const int done = cholmod_solve2(CHOLMOD_A, it.factor, it.right, nullptr, &it.solution, nullptr,
                                  &it.work1, &it.work2, &it.common);
  if (done == 0) throw contact::SolveError("coarse solve: CHOLMOD failed");
  const auto* solution = static_cast<const double*>(it.solution->x) + it.first;
  std::transform(solution, solution + x.locally_owned_size(), x.begin(),
                 [](double value) { return static_cast<float>(value); });
}

double CoarseSolver::memory_bytes() const {
  return static_cast<double>(implementation_->common.memory_inuse);
}

}  // namespace rollfem::fem
