// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear solvers on half a rail of case a with shrinking cells: unknowns, set-up, one solve to 1e-8
// (the best of five) and, for a factorisation, one of sixteen at once, iterations, memory per
// process. "CPU s" is the maximum over the processes. Runs under mpirun; the first process prints
// one table row per size. "Products" (of a cell with a vector, on all levels) and "sent" (bytes
// that a process passes to MPI) are maxima over the processes for one solve: they show the
// distribution of work on a machine with fewer cores than processes.
//   benchmark_fem_solvers multigrid|algebraic|factorisation CELL_MM ...
#include "base/progress.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/algebraic_multigrid.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/linear/multigrid.hpp"
#include "fem/trace/fem_compliance.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <exception>
#include <fstream>
#include <mpi.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

using namespace rollfem;

namespace {

std::uint64_t bytes_sent = 0;

/// Counts as if every collective call sent its data once.
void count(int items, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  bytes_sent += static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(items);
}

}  // namespace

// PETSc, whose headers come with deal.II's, counts by macros of these names.
#undef MPI_Isend
#undef MPI_Allreduce
#undef MPI_Gatherv
#undef MPI_Scatterv

// MPI's profiling interface: the program's MPI calls arrive here first.
extern "C" {
int MPI_Isend(const void* data, int items, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  count(items, type);
  return PMPI_Isend(data, items, type, to, tag, comm, request);
}
int MPI_Allreduce(const void* data, void* sum, int items, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  count(items, type);
  return PMPI_Allreduce(data, sum, items, type, op, comm);
}
int MPI_Gatherv(const void* data, int items, MPI_Datatype type, void* all, const int* counts,
                const int* offsets, MPI_Datatype each, int root, MPI_Comm comm) {
  count(items, type);
  return PMPI_Gatherv(data, items, type, all, counts, offsets, each, root, comm);
}
int MPI_Scatterv(const void* all, const int* counts, const int* offsets, MPI_Datatype each,
                 void* data, int items, MPI_Datatype type, int root, MPI_Comm comm) {
  int rank = 0, processes = 1;
  PMPI_Comm_rank(comm, &rank);
  PMPI_Comm_size(comm, &processes);
  for (int k = 0; rank == root && k < processes; ++k)
    if (k != root) count(counts[k], each);
  return PMPI_Scatterv(all, counts, offsets, each, data, items, type, root, comm);
}
}

namespace {

/// Hertz's ellipse of case a, mm and MPa (reference/benchmarks.md).
constexpr double semi_axis_x = 3.79236, semi_axis_y = 10.87295, max_pressure = 578.967;

contact::SurfaceField hertz_pressure(const contact::ContactGrid& grid) {
  const contact::Field zero = contact::Field::Zero(grid.size());
  return {zero, zero, grid.sample([](double x, double y) {
            const double rest = 1 - std::pow(x / semi_axis_x, 2) - std::pow(y / semi_axis_y, 2);
            return rest > 0 ? max_pressure * std::sqrt(rest) : 0.0;
          })};
}

std::unique_ptr<fem::LinearSolver> make_solver(const std::string& name, const fem::Body& body) {
  if (name == "factorisation") return fem::make_factorisation(body.problem());
  if (name == "algebraic") return fem::make_algebraic_multigrid(body.problem());
  return fem::make_multigrid(body.problem());
}

/// Resident now, GB.
double memory_gb() {
  std::ifstream status("/proc/self/statm");
  double program = 0.0, resident = 0.0;
  status >> program >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 30);
}

double peak_memory_gb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

/// CPU time of this process so far.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double most(std::uint64_t count) {
  return dealii::Utilities::MPI::max(static_cast<double>(count), MPI_COMM_WORLD);
}

/// Shortest time of five solves; the first one touches memory for the first time.
struct SolveTime {
  double seconds = contact::infinity, cpu = contact::infinity;
  double products = 0.0, sent = 0.0;  ///< maximum over the processes

  SolveTime(const fem::LinearSolver& solver, const fem::Vector& load, fem::Vector& u) {
    const auto products_before = fem::cell_products(), sent_before = bytes_sent;
    solver.solve(u, load);
    products = most(fem::cell_products() - products_before);
    sent = most(bytes_sent - sent_before);
    for (int k = 0; k < 5; ++k) {
      const contact::Stopwatch watch;
      const double begin = cpu_seconds();
      solver.solve(u, load);
      cpu = std::min(cpu, dealii::Utilities::MPI::max(cpu_seconds() - begin, MPI_COMM_WORLD));
      seconds = std::min(seconds, watch.seconds());
    }
  }
};

/// Seconds per solve of sixteen at once.
double seconds_of_sixteen(const fem::LinearSolver& solver, const fem::Vector& load) {
  const std::vector<fem::Vector> loads(16, load);
  std::vector<fem::Vector> solutions = loads;
  solver.solve_all(solutions, loads);
  const contact::Stopwatch watch;
  solver.solve_all(solutions, loads);
  return watch.seconds() / static_cast<double>(loads.size());
}

void measure(const std::string& solver_name, double cell) {
  const MPI_Comm world = MPI_COMM_WORLD;
  const int half_x = static_cast<int>(std::ceil(semi_axis_x / cell));
  const int half_y = static_cast<int>(std::ceil(semi_axis_y / cell));
  const auto grid = contact::ContactGrid::centred(2 * half_x, 2 * half_y, cell, cell);
  fem::BodyOptions options;
  options.cell_size = cell;
  options.fine_half_length = 1.1 * half_x * cell;
  options.fine_half_width = 1.1 * half_y * cell;
  options.extent = 8 * semi_axis_y;
  options.half = true;
  const contact::Stopwatch mesh_watch;
  const fem::Body body({false, contact::infinity, 2000.0}, {}, options, world);
  const double mesh = mesh_watch.seconds();
  const contact::Stopwatch setup_watch;
  const double setup_begin = cpu_seconds();
  const auto solver = make_solver(solver_name, body);
  const double setup = setup_watch.seconds();
  const double setup_cpu = dealii::Utilities::MPI::max(cpu_seconds() - setup_begin, world);
  const fem::SurfaceCoupling coupling(body, grid, {contact::infinity, -2000.0, 2000.0});
  auto load = fem::make_vector(body.dofs());
  auto u = fem::make_vector(body.dofs());
  coupling.load(hertz_pressure(grid), load);
  const SolveTime solve(*solver, load, u);
  const double memory = dealii::Utilities::MPI::max(peak_memory_gb(), world);
  const double stays = dealii::Utilities::MPI::max(memory_gb(), world);
  const std::string sixteen = solver_name == "factorisation"
                                  ? fmt::format("{:.3f}", seconds_of_sixteen(*solver, load))
                                  : "";
  const double approach = coupling.sample(u).n.cwiseAbs().maxCoeff();
  if (dealii::Utilities::MPI::this_mpi_process(world) == 0)
    fmt::print(
        "| {} | {} | {:.4g} | {} | {:.1f} | {:.1f} | {:.1f} | {:.3f} | {:.3f} | {} | {} | {:.3f} | "
        "{:.3f} | {:.4g} | {:.4g} | {:.9g} |\n",
        solver_name, dealii::Utilities::MPI::n_mpi_processes(world), cell, body.unknowns(), mesh,
        setup, setup_cpu, solve.seconds, solve.cpu, sixteen, solver->last_iterations(), memory,
        stays, solve.products, solve.sent, approach);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      fmt::print(
          "| solver | processes | cell mm | unknowns | mesh s | set-up s | CPU s | solve s | CPU s "
          "| "
          "each of 16 | iterations | peak GB per process | GB retained | products | bytes sent | "
          "largest displacement mm |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int k = 2; k < argc; ++k) measure(argv[1], std::stod(argv[k]));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
