// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem bench`: error and run time of each model on this machine in cases with known
// solutions, and the speed of the machine relative to the one that predictions are based on.
#pragma once

#include "app/frame/command_frame.hpp"
#include "contact/solve/model.hpp"

namespace rollfem::app {

struct BenchRequest : ComputingRequest {
  double seconds = 30.0;  ///< time limit; runs expected to exceed it are skipped
  bool json = false;      ///< print JSON, and progress of the models on stderr
  bool quick = false;     ///< one case on coarse grids, nothing stored
};

/// Prints a table and stores the machine's speed. Throws contact::InputError if `seconds` is not
/// positive.
void bench(const BenchRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
