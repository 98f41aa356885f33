// SPDX-License-Identifier: LGPL-2.1-or-later
// The C entry point of this library, which rollfem opens at run time.
#include "base/threads.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"
#include "fem/elasticity/fem_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector_memory.h>
#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace {

template <class Number>
using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> session;

void start() {
  if (session) return;
  // deal.II also starts PETSc, which by default reads options from .petscrc in the current folder
  // (one of them starts a program) and from the command line; both are disabled here.
  static std::string program = "rollfem", option = "-skip_petscrc";
  static std::array<char*, 3> call{program.data(), option.data(), nullptr};
  int count = 2;
  char** own = call.data();
  // deal.II limits oneTBB for the whole process, and cuts its sums into pieces by this number:
  // always the same, so that results do not depend on the threads in use (within_threads).
  constexpr unsigned int most_threads = 64;
  session = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(count, own, most_threads);
  // The end of the session empties deal.II's stores of vectors, so they must outlive it. Objects
  // created first are destroyed last.
  dealii::GrowingVectorMemory<Vector<double>>::release_unused_memory();
  dealii::GrowingVectorMemory<Vector<float>>::release_unused_memory();
}

void stop() {
  session.reset();
}

std::string from_first(const std::string& text) {
  return dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, text);
}

/// A function of this library, with the caller's threads for deal.II too.
template <auto function>
struct OnThreads;
template <class Result, class... Arguments, Result (*function)(Arguments...)>
struct OnThreads<function> {
  static Result call(Arguments... arguments) {
    std::optional<Result> result;
    rollfem::contact::within_threads([&] { result.emplace(function(arguments...)); });
    return *std::move(result);
  }
};

rollfem::fem::About about() {
  char mpi[MPI_MAX_LIBRARY_VERSION_STRING] = {};
  int length = 0;
  MPI_Get_library_version(mpi, &length);
  const std::string text(mpi, static_cast<std::size_t>(length));
  return {fmt::format("deal.II {}, Trilinos {}.{}.{}, p4est {}.{}.{}, CHOLMOD {}.{}.{}",
                      DEAL_II_PACKAGE_VERSION, DEAL_II_TRILINOS_VERSION_MAJOR,
                      DEAL_II_TRILINOS_VERSION_MINOR, DEAL_II_TRILINOS_VERSION_SUBMINOR,
                      DEAL_II_P4EST_VERSION_MAJOR, DEAL_II_P4EST_VERSION_MINOR,
                      DEAL_II_P4EST_VERSION_SUBMINOR, CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION,
                      CHOLMOD_SUBSUB_VERSION),
          text.substr(0, text.find_first_of(",\n")), rollfem::fem::simd_variants(),
          rollfem::fem::simd_variant()};
}

const rollfem::fem::Entry entry{start,
                                stop,
                                from_first,
                                OnThreads<&rollfem::fem::run_fem>::call,
                                OnThreads<&rollfem::fem::mesh_case>::call,
                                OnThreads<&rollfem::hybrid::find_smooth_parts>::call,
                                about};

}  // namespace

extern "C" const rollfem::fem::Entry* rollfem_fem_entry() {
  return &entry;
}
