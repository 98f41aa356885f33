// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/coarse_solver.hpp"

#include "fem/linear/first_process.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

namespace rollfem::fem {

namespace {

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

}  // namespace

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
void CoarseSolver::solve(VectorType& x, const VectorType& b) const {
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

}  // namespace rollfem::fem
