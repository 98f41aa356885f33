// SPDX-License-Identifier: LGPL-2.1-or-later
// Options and endings that the computing commands have in common.
#pragma once

#include "app/frame/commands.hpp"
#include "models/frame/command_frame.hpp"

#include <filesystem>
#include <string>

namespace rollfem::app {

using modelling::CommandFrame;

/// Common part of the requests of run and table.
struct ComputingRequest : CaseRequest, modelling::Computing {
  explicit ComputingRequest(Call& made_by)
      : CaseRequest(made_by), Computing{made_by.models, made_by.command, made_by.argc, made_by.argv,
                                        false,          false,           {},           0} {}
  bool report = true;  ///< draw figures and page, which takes some seconds
};

/// Adds the options that ComputingRequest holds, except those that divide the work.
void add_report_flags(CLI::App& command, ComputingRequest& request);

/// Adds the options that divide long work among calls (array jobs, machines).
void add_division(CLI::App& command, contact::OwnPart& own, int& merge, const std::string& items);

/// Warns of values in the case that look like unit mistakes, even with -q.
void warn_of_doubts(const contact::Case& input);

/// Draws figures and report of a written folder if they are wanted. Warns if that fails.
bool report_drawn(const ComputingRequest& request, const std::filesystem::path& directory);

/// Prints where the results are and, if it was drawn, the report.
void tell_where(const std::filesystem::path& directory, const char* page, bool drawn);

}  // namespace rollfem::app
