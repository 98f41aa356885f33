#include "fem/solver/memory.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/text_fields.hpp"
#include "fem/solver/factorisation.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace rollfem::fem {

namespace {

constexpr double gigabyte = 1e9;
constexpr double unlimited = std::numeric_limits<double>::infinity();

// Bytes, measured as largest resident memory.
constexpr double program = 0.23e9;          ///< libraries, MPI, the contact problem
constexpr double mesh_per_unknown = 200.0;  ///< triangulation, numbering, constraints
/// Assembled matrix and what the ordering works with; gone when the factor is there, but the
/// factor is made beside the matrix.
constexpr double matrix_per_unknown = 1900.0;
constexpr double multigrid_per_unknown = 580.0;
constexpr double algebraic_per_unknown = 5000.0;
constexpr double fields_per_unknown = 70.0;
constexpr double fields_per_unknown_and_point = 35.0;

double number_in(const std::string& file) {
  std::ifstream stream(file);
  double value = unlimited;
  if (!(stream >> value)) return unlimited;  // also "max"
  return value;
}

/// The value of a line "name 123 ...", in its own unit.
double line_in(const std::string& file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string first;
    double value = 0.0;
    if (words >> first >> value && (first == name || first == name + ":")) return value;
  }
  return unlimited;
}

/// What is below a limit; pages of files that the kernel can drop do not count as used.
double left_below(double limit, double used, double droppable) {
  if (!std::isfinite(limit) || !std::isfinite(used)) return unlimited;
  if (!std::isfinite(droppable)) droppable = 0.0;
  return std::max(0.0, limit - used + droppable);
}

double left_in_cgroups(const std::string& proc, const std::string& root) {
  double left = unlimited;
  std::ifstream stream(proc + "/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool unified = controllers.empty();
    if (!unified && controllers.find("memory") == std::string::npos) continue;
    const std::string base = unified ? root : root + "/memory";
    // Limits of the groups above count as well; in a container the path may not exist at all.
    for (std::string path = line.substr(second + 1);; path.resize(path.rfind('/'))) {
      while (!path.empty() && path.back() == '/') path.pop_back();
      const std::string group = base + path;
      left = std::min(left,
                      unified ? left_below(number_in(group + "/memory.max"),
                                           number_in(group + "/memory.current"),
                                           line_in(group + "/memory.stat", "inactive_file"))
                              : left_below(number_in(group + "/memory.limit_in_bytes"),
                                           number_in(group + "/memory.usage_in_bytes"),
                                           line_in(group + "/memory.stat", "total_inactive_file")));
      if (path.empty() || path.find('/') == std::string::npos) break;
    }
  }
  return left;
}

/// What the processes of this machine need and have together, taken where it is tightest.
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
  here.available = dealii::Utilities::MPI::min(available_bytes(), machine);
  MPI_Comm_free(&machine);
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1) return here;
  const double spare = here.available - here.needed;
  const double least = dealii::Utilities::MPI::min(spare, communicator);
  // Machines are told apart by how much they lack; equal ones are alike.
  const double tight = spare == least ? 1.0 : 0.0;
  here.needed = dealii::Utilities::MPI::max(tight * here.needed, communicator);
  here.available =
      dealii::Utilities::MPI::min(tight > 0.0 ? here.available : unlimited, communicator);
  return here;
}

std::string in_gigabytes(double bytes) {
  return std::isfinite(bytes) ? fmt::format("{:.3g} GB", bytes / gigabyte) : "unknown memory";
}

}  // namespace

double predicted_bytes(const MemoryDemand& demand) {
  const double unknowns = demand.unknowns_of_wheel + demand.unknowns_of_rail;
  double shared = mesh_per_unknown * unknowns;
  if (demand.factorisation)
    shared += predicted_factor_bytes(demand.unknowns_of_wheel) +
              predicted_factor_bytes(demand.unknowns_of_rail) + matrix_per_unknown * unknowns;
  else
    shared += (demand.algebraic ? algebraic_per_unknown : multigrid_per_unknown) * unknowns;
  double bytes = program + shared / demand.processes;
  // Process 0 gathers the fields of all.
  if (demand.body_fields > 0)
    bytes += (fields_per_unknown + fields_per_unknown_and_point * demand.body_fields) * unknowns *
             (demand.half ? 2.0 : 1.0);
  return bytes;
}

double available_bytes(const std::string& proc, const std::string& cgroup) {
  const double kilobytes = line_in(proc + "/meminfo", "MemAvailable");
  return std::min(1024.0 * kilobytes, left_in_cgroups(proc, cgroup));
}

double available_bytes() {
  if (const char* text = std::getenv("ROLLFEM_MEMORY_GB")) {
    const std::optional<double> value = contact::number_of(text);
    if (!value || !(*value > 0.0))
      throw contact::InputError(fmt::format(
          "ROLLFEM_MEMORY_GB = {}: allowed: a number of GB above 0; do: change or unset it", text));
    return *value * gigabyte;
  }
  return available_bytes("/proc", "/sys/fs/cgroup");
}

bool fits_memory(const MemoryDemand& demand, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  return at.needed <= at.available;
}

std::string memory_note(const MemoryDemand& demand, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  return fmt::format("needs about {} of {}", in_gigabytes(at.needed), in_gigabytes(at.available));
}

void refuse_beyond_memory(const MemoryDemand& demand, double cell_size, MPI_Comm communicator) {
  const Balance at = balance(demand, communicator);
  if (at.needed <= at.available) return;
  std::string advice = fmt::format("a [fem] cell_size larger than {:.4g} mm", cell_size);
  if (demand.factorisation) {
    MemoryDemand other = demand;
    other.factorisation = false;
    advice += fmt::format(", [fem] linear_solver = \"multigrid\" (about {})",
                          in_gigabytes(at.processes * predicted_bytes(other)));
  }
  if (demand.body_fields > 0) {
    MemoryDemand other = demand;
    other.body_fields = demand.body_fields > 1 ? 1 : 0;
    advice += fmt::format(", [output] body_fields = \"{}\" (about {})",
                          other.body_fields > 0 ? "last" : "none",
                          in_gigabytes(at.processes * predicted_bytes(other)));
  }
  throw contact::SolveError(fmt::format(
      "this run needs about {} and {} are available: about {:.3g} million unknowns in cells of "
      "{:.4g} mm, by {}; do: take {}, or mpirun over several machines",
      in_gigabytes(at.needed), in_gigabytes(at.available),
      1e-6 * (demand.unknowns_of_wheel + demand.unknowns_of_rail), cell_size,
      demand.factorisation ? "factorisation" : "multigrid", advice));
}

}  // namespace rollfem::fem
