// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem bench`: error and run time of each model on this machine in cases with known
// solutions, and the speed of the machine relative to the one that predictions are based on.
#pragma once

#include "app/frame/command_frame.hpp"
#include "contact/solve/model.hpp"

namespace rollfem::app {

struct BenchRequest : ComputingRequest {
  double seconds = 30.0;  ///< what is expected to take longer altogether is left out
  bool quick = false;     ///< one case on coarse grids, nothing kept
};

/// Prints a table and keeps the machine's speed. Throws contact::InputError for seconds that are
/// not positive.
void bench(const BenchRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
