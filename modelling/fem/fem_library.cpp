// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/fem/fem_library.hpp"

#include "base/errors.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <string>

namespace rollfem::modelling {

namespace {

#if ROLLFEM_WITH_FEM

/// The fastest kernels of OpenBLAS for this processor; null where its own choice is right.
const char* openblas_kernels() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

/// Defaults of variables that libraries read while they are loaded, before any of their functions
/// can be called; this is the only place that changes the environment. The two bodies are
/// factorised side by side, one core each, and MPI processes share the cores: threads inside
/// OpenBLAS would only compete with them. Waiting threads sleep or yield (app/program.cpp), because
/// a spinning core is lost to the other body, the other process or other users. On processors newer
/// than itself OpenBLAS falls back to SSE3, a quarter of the speed.
void set_defaults() {
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  setenv("OMP_WAIT_POLICY", "passive", 0);
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  // A process without mpirun needs no daemon of its own to start others.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  if (const char* const kernels = openblas_kernels()) setenv("OPENBLAS_CORETYPE", kernels, 0);
}

void* open_library() {
  set_defaults();
  const std::filesystem::path program = program_directory(), code = code_directory();
  std::string problems;
  for (const auto& folder :
       {program / ".." / "fem", program / ".." / ROLLFEM_LIBDIR, code / ".." / "fem", code}) {
    const std::filesystem::path file = folder / ROLLFEM_FEM_LIBRARY;
    // Global symbols: MPI and PETSc open plug-ins at run time that look for them. Lazy: to look up
    // all 140 000 functions, of which few are called, takes 0.15 s.
    if (void* library = dlopen(file.c_str(), RTLD_LAZY | RTLD_GLOBAL)) return library;
    problems += fmt::format("\n  {}", dlerror());
  }
  throw contact::InputError(
      "model fem: the finite-element library cannot be opened; do: build or install rollfem again" +
      problems);
}

#endif

}  // namespace

#if ROLLFEM_WITH_FEM

const fem::Entry& open_fem_library(const std::string&) {
  static void* const library = open_library();  // once: it changes the environment
  using EntryFunction = const fem::Entry* (*)();
  const auto entry = reinterpret_cast<EntryFunction>(dlsym(library, "rollfem_fem_entry"));
  if (entry == nullptr)
    throw contact::InputError(
        "model fem: the finite-element library belongs to another version; do: build or install "
        "rollfem again");
  return *entry();
}

#else

const fem::Entry& open_fem_library(const std::string& asked_by) {
  throw contact::InputError(
      fmt::format("{}: this build has no finite elements, because it was made without deal.II; "
                  "allowed: commands that need none; do: build with ROLLFEM_FEM=ON",
                  asked_by));
}

#endif

FemLock lock_fem() {
  static std::recursive_mutex one_at_a_time;
  return FemLock(one_at_a_time);
}

const fem::Entry& parallel_session(const std::string& asked_by) {
  static const fem::Entry& session = [&]() -> const fem::Entry& {
    const fem::Entry& entry = open_fem_library(asked_by);
    entry.start();
    // Ends the session before its libraries are unloaded.
    std::atexit([] { session.stop(); });
    return entry;
  }();
  return session;
}

}  // namespace rollfem::modelling
