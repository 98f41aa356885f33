// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/memory.hpp"

#include "base/available_memory.hpp"
#include "base/errors.hpp"
#include "fem/linear/factorisation.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rollfem::fem {

namespace {

// Bytes, measured as largest resident memory.
constexpr double program = 0.26e9;          ///< libraries, MPI, the contact problem
constexpr double mesh_per_unknown = 200.0;  ///< triangulation, numbering, constraints
/// With several processes, each also stores neighbouring cells of others, and the first the factor
/// of the coarsest level.
constexpr double multigrid_per_unknown = 280.0, multigrid_per_unknown_of_several = 300.0;
constexpr double single_part = 0.46;  ///< of a factor in single precision, on the streamlines
constexpr double algebraic_per_unknown = 5000.0;
constexpr double solve_per_unknown = 120.0;  ///< vectors of each further solve at the same time
constexpr double fields_per_unknown = 70.0;
constexpr double fields_per_unknown_and_point = 35.0;

/// Total need and available memory of the processes on one machine, for the machine with the least
/// margin.
struct Balance {
  double needed = 0.0;
  double available = 0.0;
  int processes = 1;  ///< on that machine
};

Balance balance(const MemoryDemand& demand, MPI_Comm communicator) {
  MPI_Comm machine;
  MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  Balance here;
  here.processes = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(machine));
  here.needed = here.processes * predicted_bytes(demand);
  here.available = dealii::Utilities::MPI::min(contact::available_bytes(), machine);
  MPI_Comm_free(&machine);
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) return here;
  const auto machines = dealii::Utilities::MPI::all_gather(
      communicator, std::array{here.available - here.needed, here.needed});
  const auto [spare, needed] = *std::min_element(machines.begin(), machines.end());
  here.needed = needed;
  here.available = needed + spare;
  return here;
}

double per_unknown(const MemoryDemand& demand) {
  if (demand.algebraic) return algebraic_per_unknown;
  return demand.processes > 1 ? multigrid_per_unknown_of_several : multigrid_per_unknown;
}

}  // namespace

double predicted_bytes(const MemoryDemand& demand) {
  const double unknowns = demand.unknowns[0] + demand.unknowns[1];
  double shared = mesh_per_unknown * unknowns;
  // The matrix beside the factors is covered by the overestimate of the factors: the total was 3 to
  // 15 % below the prediction for cells of 1.88 to 0.47 mm, for half and whole bodies.
  for (std::size_t k = 0; k < 2 && demand.factorisation; ++k)
    shared +=
        predicted_factor_bytes(demand.unknowns[k]) * (demand.yields[k] ? 1.0 + single_part : 1.0);
  if (!demand.factorisation) shared += per_unknown(demand) * unknowns;
  double bytes = program + shared / demand.processes;
  if (!demand.factorisation && !demand.algebraic) bytes += demand.coarse_factors;
  // Process 0 gathers the fields of all.
  if (demand.body_fields > 0)
    bytes += (fields_per_unknown + fields_per_unknown_and_point * demand.body_fields) * unknowns *
             (demand.half ? 2.0 : 1.0);
  return bytes;
}

bool fits_memory(const MemoryDemand& demand, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  return at.needed <= at.available;
}

std::string memory_note(const MemoryDemand& demand, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  return fmt::format("needs about {} of {}", contact::in_gigabytes(at.needed),
                     contact::in_gigabytes(at.available));
}

void refuse_beyond_memory(const MemoryDemand& demand, double cell_size, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  if (at.needed <= at.available) return;
  std::string advice = fmt::format("a [fem] cell_size larger than {:.4g} mm", cell_size);
  const auto advise = [&](const char* key, const char* word, const MemoryDemand& other) {
    advice += fmt::format(", {} = \"{}\" (about {})", key, word,
                          contact::in_gigabytes(at.processes * predicted_bytes(other)));
  };
  MemoryDemand iterative = demand, fewer = demand;
  iterative.factorisation = false;
  fewer.body_fields = demand.body_fields > 1 ? 1 : 0;
  if (demand.factorisation) advise("[fem] linear_solver", "multigrid", iterative);
  if (demand.body_fields > 0)
    advise("[output] body_fields", fewer.body_fields > 0 ? "last" : "none", fewer);
  throw contact::SolveError(
      fmt::format("this run needs about {} and {} are available: about {:.3g} million unknowns in "
                  "cells of {:.4g} mm, by {}; do: use {}, or mpirun over several machines",
                  contact::in_gigabytes(at.needed), contact::in_gigabytes(at.available),
                  1e-6 * (demand.unknowns[0] + demand.unknowns[1]), cell_size,
                  demand.factorisation ? "factorisation" : "multigrid", advice));
}

std::size_t solves_in_memory(double unknowns) {
  return 1 + static_cast<std::size_t>(contact::available_bytes() / (solve_per_unknown * unknowns));
}

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace rollfem::fem
