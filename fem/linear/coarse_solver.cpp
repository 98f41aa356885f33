#include "fem/linear/coarse_solver.hpp"

#include "fem/linear/cholmod.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

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

CoarseSolver::CoarseSolver(const std::vector<MatrixEntry>& entries, std::size_t size,
                           std::size_t first, MPI_Comm communicator)
    : factor_(gather(entries, communicator), size,
              {"coarse solve of the multigrid", "use a coarser fem.cell_size"}),
      right_(size),
      first_(first),
      communicator_(communicator) {}

void CoarseSolver::solve(VectorType& x, const VectorType& b) const {
  std::fill(right_.begin(), right_.end(), 0.0);
  std::copy(b.begin(), b.end(), right_.begin() + static_cast<std::ptrdiff_t>(first_));
  if (dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1)
    MPI_Allreduce(MPI_IN_PLACE, right_.data(), static_cast<int>(right_.size()), MPI_DOUBLE, MPI_SUM,
                  communicator_);
  const double* const solution = factor_.solve(right_) + first_;
  std::transform(solution, solution + x.locally_owned_size(), x.begin(),
                 [](double value) { return static_cast<float>(value); });
}

double CoarseSolver::memory_bytes() const {
  return factor_.memory_bytes() + static_cast<double>(right_.size() * sizeof(double));
}

}  // namespace rollfem::fem
