// SPDX-License-Identifier: LGPL-2.1-or-later
// The model "fem": wheel and rail segments in 3D finite elements. This header is free of deal.II;
// rollfem opens the library at run time through rollfem_fem_entry.
#pragma once

#include "base/checkpoint.hpp"
#include "contact/solve/model.hpp"
#include "fem/elasticity/mesh_report.hpp"

#include <string>
#include <vector>

namespace rollfem::hybrid {
struct SmoothParts;
}

namespace rollfem::fem {

/// Runs the case. Every MPI process of the run calls it; the result is complete on process 0.
/// Finished load points are stored in the `checkpoint` of process 0 and restored from there (null:
/// none).
contact::ModelResult run_fem(const contact::Scene& scene, const contact::Progress& progress,
                             contact::Checkpoint* checkpoint = nullptr);

/// What the library consists of, for --version.
struct About {
  std::string libraries;                   ///< "deal.II 9.4.1, ..."
  std::string mpi;                         ///< "Open MPI 4.1.4"
  std::vector<std::string> simd_variants;  ///< of this machine
  std::string simd_variant;                ///< the one in use
};

/// Functions that rollfem takes from the opened library.
struct Entry {
  void (*start)();  ///< MPI_Init, once, before any model
  void (*stop)();   ///< MPI_Finalize
  /// Collective: the text of process 0 on every process.
  std::string (*from_first)(const std::string& text);
  contact::ModelResult (*run)(const contact::Scene&, const contact::Progress&,
                              contact::Checkpoint*);
  std::vector<MeshedBody> (*mesh)(const contact::Scene&);
  /// By this process alone: corrections of bodies to half-spaces
  /// (hybrid/correction/smooth_parts.hpp).
  hybrid::SmoothParts (*find_smooth_parts)(const contact::Scene&, const contact::Progress&);
  About (*about)();  ///< without MPI started
};

}  // namespace rollfem::fem

extern "C" const rollfem::fem::Entry* rollfem_fem_entry();
