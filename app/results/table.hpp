// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `table`: the creep force law of a case's contact over scaled creepages and axis
// ratios, or over lateral shifts of its wheelset, with error bars and interpolation errors.
#pragma once

#include "app/frame/command_frame.hpp"

#include <string>

namespace rollfem::app {

/// Empty `directory`: results/<case>_table. `resume` continues from finished points.
struct TableRequest : ComputingRequest {
  std::string case_file;
};

/// Writes DIR/table.h5, table.csv, interpolation.csv, over lateral shifts shifts.csv, and
/// table.html. Throws contact::InputError before the computation, contact::SolveError if a point
/// has no solution or a wheel does not touch.
void table(TableRequest request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
