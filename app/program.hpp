// SPDX-License-Identifier: LGPL-2.1-or-later
// The command-line program for any set of registered models.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::app {

/// Body of main: parses the call, runs the command, and turns every failure into one line on stderr
/// and an exit status (0 done, 1 the solution or its output failed, 2 input or call wrong). Does
/// not return after a failure.
int run_program(int argc, char** argv, const contact::ModelRegistry& models);

}  // namespace rollfem::app
