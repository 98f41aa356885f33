// SPDX-License-Identifier: LGPL-2.1-or-later
// One level of the finite-element model: bodies and contact grid with cells of one size, every load
// point of the scene solved on them. fem_model.hpp runs two levels to estimate the error.
#pragma once

#include "base/checkpoint.hpp"
#include "contact/solve/model.hpp"

namespace rollfem::fem {

struct LevelOptions {
  double cell_size = 0.0;    ///< mm, FE cells in the patch and contact elements
  std::string stage_prefix;  ///< prefix of stage names in progress reports
  bool body_fields =
      false;  ///< displacement and stress of the bodies according to [output] body_fields
  contact::Checkpoint* checkpoint = nullptr;  ///< of process 0; null: none
};

/// Collective over all MPI processes; the first one solves the contact problem and has the load
/// points. Throws contact::SolveError, contact::InputError.
contact::ModelResult run_level(const contact::Scene& scene, const LevelOptions& options,
                               const contact::Progress& progress);

}  // namespace rollfem::fem
