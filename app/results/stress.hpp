// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `stress`: stress and displacement below the surface from stored results.
#pragma once

#include "contact/solve/model.hpp"
#include "models/stress/stress_request.hpp"

#include <string>

namespace rollfem::app {

struct StressCommand : modelling::StressRequest {
  std::string directory;  ///< empty: <result folder>_stress
  bool quiet = false;
  bool json = false;  ///< print stress.json; files are then written only into `directory`
  bool figures = true;
};

/// Writes stress.csv, stress.json and figures, prints a table. Throws contact::InputError; nothing
/// is written then.
void stress(const StressCommand& request, const contact::ModelRegistry& models, bool& undrawn);

}  // namespace rollfem::app
