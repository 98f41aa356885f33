// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `run`: the models of a case one after the other, then results and report.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>

namespace rollfem::app {

/// Empty `models`: those of the case file. Empty `directory`: results/<case file without .toml>.
struct RunRequest : ComputingRequest {
  std::string case_file;
};

/// Throws contact::InputError or contact::SolveError and then writes nothing.
void run(RunRequest request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
