// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/solver_choice.hpp"

#include "base/available_memory.hpp"
#include "base/errors.hpp"
#include "fem/linear/algebraic_multigrid.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/linear/multigrid.hpp"
#include "fem/linear/root_process.hpp"
#include "fem/mesh/body_mesh.hpp"
#include "fem/mesh/run_layout.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <dlfcn.h>
#include <string>

namespace rollfem::fem {

using contact::Scene;

namespace {

/// Seconds of both linear solvers on a body of n unknowns, one core each: half a rail of case a,
/// cells of 0.94 to 0.2 mm, on AVX-512; the kernel forced to AVX2 takes 1.1 times as long, OpenBLAS
/// with its kernels for AVX2 the same (docs/benchmarks.md). Only their ratio matters.
double factorisation_seconds(double n) {
  return 1.8 * std::pow(n / 105e3, 1.55);
}
double factor_solve_seconds(double n) {
  return 0.056 * std::pow(n / 105e3, 1.35);
}
double multigrid_setup_seconds(double n) {
  return 0.2 + 0.24 * n / 105e3;
}
double multigrid_solve_seconds(double n) {
  return 0.115 * n / 105e3;
}

/// What a slow BLAS adds to these times.
struct Slowness {
  double more = 0.0;   ///< s, to a factorisation of 105 000 unknowns; with their square
  double solve = 1.0;  ///< factor of a solve
};

/// Where another program (numpy) has loaded OpenBLAS before its kernels could be chosen, it may
/// have taken those for SSE3, "Prescott", not knowing the processor. Any other library counts as
/// the reference BLAS. Measured on 60 000 to 127 000 unknowns; products of matrices reach 43, 12
/// and 3 GFLOP/s.
Slowness blas_slowdown() {
  const auto core_name =
      reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (core_name == nullptr) return {12.0, 1.9};
  return std::string(core_name()) == "Prescott" ? Slowness{2.4, 1.2} : Slowness{};
}

/// The coarse mesh of a true section has about 120 000 unknowns, which adds a solve with its factor
/// in each of about ten multigrid iterations.
constexpr double coarse_unknowns_of_section = 120e3;
constexpr double multigrid_iterations = 10.0;

/// Largest memory of a factor, bytes; multigrid needs a tenth. Passes need so many solves that
/// CHOLMOD's indices of 32 bits limit theirs, and the memory of the machine.
constexpr double largest_factor = 5e9, largest_factor_of_passes = 16e9;

/// FE solves of a body per load point and for the normal problem: case a takes 13 for its seven
/// points and 4.
constexpr double solves_per_point = 2.0;
constexpr double solves_for_normal = 4.0;
constexpr double solves_per_pass = 60.0;
/// Time of these relative to solves with the whole factor, most of them by part of it.
constexpr double part_in_passes = 0.5;

/// Geometric multigrid factorises the coarse mesh of a body; a given mesh may be too large for
/// that, and algebraic multigrid then coarsens further. A factor of this many unknowns takes 14 s
/// and 3.2 GB and its ten solves per iteration 3 s, while algebraic multigrid takes 18 s per solve
/// and 3.5 GB on the refined body of 700 000.
constexpr double most_coarse_unknowns = 400e3;

/// Estimated number of unknowns of the body before refinement towards the patch.
double coarse_unknowns(const Body& body) {
  // For sections of 4200 cells: degree^3 nodes per cell, and a tenth more on the outside.
  return 1.1 * 3.0 * std::pow(body.options().degree, 3) *
         body.dofs().get_triangulation().n_cells(0);
}

/// Whether algebraic multigrid is used when the body is not factorised: as given in the case, or
/// for a coarse mesh too large for geometric multigrid.
bool takes_algebraic(const Scene& scene, const Body& body) {
  return options_of(scene).linear_solver == LinearMethod::algebraic ||
         (options_of(scene).linear_solver == LinearMethod::automatic &&
          coarse_unknowns(body) > most_coarse_unknowns);
}

std::unique_ptr<LinearSolver> make_iterative_solver(const Scene& scene, const Body& body) {
  // Five digits beyond the tolerance of the contact iteration: 1e-10 took a tenth more iterations.
  constexpr IterationLimits limits{1e-9, 200};
  if (!takes_algebraic(scene, body)) return make_multigrid(body.problem(), limits);
  std::unique_ptr<LinearSolver> solver;
  one_at_a_time([&] { solver = make_algebraic_multigrid(body.problem(), {limits.tolerance}); });
  return solver;
}

bool takes_factorisation(const Scene& scene, MemoryDemand demand) {
  switch (options_of(scene).linear_solver) {
    case LinearMethod::factorisation:
      if (demand.processes > 1)
        throw contact::InputError(scene.where(),
                                  "[fem] linear_solver = \"factorisation\" runs in one process "
                                  "only; allowed with mpirun: \"multigrid\", \"algebraic\" or "
                                  "\"automatic\"; do: change it or run without mpirun");
      return true;
    case LinearMethod::multigrid:
    case LinearMethod::algebraic:
      return false;
    case LinearMethod::automatic:
      break;
  }
  if (demand.processes > 1) return false;
  for (const contact::Material& material : {scene.wheel.material, scene.rail.material})
    if (!material.rigid() && material.poisson_ratio > largest_multigrid_poisson_ratio)
      return true;  // multigrid rejects it
  const double solves = solves_for_normal + (scene.yields() ? solves_per_pass : solves_per_point) *
                                                static_cast<double>(scene.points.size());
  const double weight = scene.yields() ? part_in_passes : 1.0;
  const double largest = scene.yields() ? largest_factor_of_passes : largest_factor;
  const Slowness slow = blas_slowdown();
  const double coarse =
      has_true_sections(scene)
          ? multigrid_iterations * slow.solve * factor_solve_seconds(coarse_unknowns_of_section)
          : 0.0;
  for (const double n : demand.unknowns)
    if (predicted_factor_bytes(n) >= largest ||
        factorisation_seconds(n) + slow.more * std::pow(n / 105e3, 2.0) +
                weight * solves * slow.solve * factor_solve_seconds(n) >
            multigrid_setup_seconds(n) + solves * (multigrid_solve_seconds(n) + coarse))
      return false;
  demand.factorisation = true;
  return fits_memory(demand, MPI_COMM_WORLD);
}

/// Adds what does not depend on the bodies, and the choice of the solver.
MemoryDemand completed(const Scene& scene, MemoryDemand demand, const BodyOptions& options,
                       bool body_fields) {
  const std::size_t count = scene.points.size();
  for (std::size_t k = 0; k < count && body_fields; ++k)
    demand.body_fields += scene.output.keeps_bodies(k, count) ? 1 : 0;
  demand.half = options.half;
  demand.yields = {scene.wheel.plasticity.has_value(), scene.rail.plasticity.has_value()};
  demand.processes = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  demand.factorisation = takes_factorisation(scene, demand);
  return demand;
}

}  // namespace

/// Two factorisations side by side, one core each: faster than one after the other with two BLAS
/// threads.
Solvers make_solvers(const Scene& scene, const BodyPair& bodies, bool factorisation) {
  const auto make = [&](const Body* body) -> std::unique_ptr<LinearSolver> {
    if (body == nullptr) return nullptr;
    return factorisation ? make_factorisation(body->problem())
                         : make_iterative_solver(scene, *body);
  };
  Solvers solvers;
  beside_or_in_turn(MPI_COMM_WORLD, 2, [&](std::size_t k) { solvers[k] = make(bodies[k]); });
  return solvers;
}

MemoryDemand memory_demand(const Scene& scene, const BodyOptions& options, const BodyPair& bodies,
                           bool body_fields) {
  MemoryDemand demand;
  for (std::size_t k = 0; k < 2; ++k) {
    if (bodies[k] == nullptr) continue;
    const Body& body = *bodies[k];
    demand.unknowns[k] = static_cast<double>(body.unknowns());
    demand.algebraic = demand.algebraic || takes_algebraic(scene, body);
    if (has_true_sections(scene) || !(k == 0 ? scene.wheel : scene.rail).mesh.empty())
      demand.coarse_factors += predicted_factor_bytes(coarse_unknowns(body));
  }
  return completed(scene, demand, options, body_fields);
}

namespace {

/// Of a level before its meshes are made.
MemoryDemand expected_demand(const Scene& scene, double cell_size) {
  const BodyOptions bodies = run_layout(scene, cell_size).bodies;
  constexpr double beyond_all_memory = 2e9;
  const auto unknowns = [&](bool is_wheel) {
    if ((is_wheel ? scene.wheel : scene.rail).material.rigid()) return 0.0;
    return predicted_unknowns(options_of(scene, is_wheel, bodies), beyond_all_memory);
  };
  MemoryDemand demand;
  demand.unknowns = {unknowns(true), unknowns(false)};
  demand.algebraic = options_of(scene).linear_solver == LinearMethod::algebraic;
  return completed(scene, demand, bodies, true);
}

}  // namespace

void refuse_beyond_memory(const Scene& scene, double cell_size) {
  refuse_beyond_memory(expected_demand(scene, cell_size), cell_size, MPI_COMM_WORLD);
}

std::optional<contact::Note> fit_surface_rows(Scene& scene, double cell_size) {
  if (!scene.yields() || options_of(scene).surface_layer || fit_together(scene, {cell_size}))
    return {};
  const BodyOptions bodies = run_layout(scene, cell_size).bodies;
  const auto first_row = [&](bool is_wheel) {
    return options_of(scene, is_wheel, bodies).rows.depth(cell_size);
  };
  const double chosen = std::min(first_row(true), first_row(false));
  double row = chosen;
  do {
    row *= 1.25;
    auto& options = scene.options.set<FemOptions>();
    options.surface_layer = row;
    options.thick_rows = true;
  } while (row < cell_size && !fit_together(scene, {cell_size}));
  contact::Note note{"surface_layer",
                     fmt::format("the first row of cells is {:.2g} mm high instead of {:.2g} mm, "
                                 "for which memory does not suffice: the strain at the surface is "
                                 "not resolved",
                                 std::min(row, cell_size), chosen),
                     contact::Note::warning};
  return note;
}

bool fit_together(const Scene& scene, const std::vector<double>& cell_sizes) {
  double bytes = 0.0;
  for (const double cell_size : cell_sizes)
    bytes += predicted_bytes(expected_demand(scene, cell_size));
  return bytes <= contact::available_bytes();
}

}  // namespace rollfem::fem
