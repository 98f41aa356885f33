// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/frame/computing.hpp"

#include "base/errors.hpp"
#include "case/checks/plausibility.hpp"
#include "models/frame/parts.hpp"
#include "profiles/profiles.hpp"

#include <fmt/format.h>

#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

void add_report_flags(CLI::App& command, ComputingRequest& request) {
  add_set_option(command, request.changes);
  command.add_flag("-q,--quiet", request.quiet, "print errors and warnings only");
  command.add_flag_callback(
      "--no-report", [&request] { request.report = false; },
      "write results only, no figures and no report");
}

void add_division(CLI::App& command, contact::OwnPart& own, int& merge, const std::string& items) {
  command.add_option_function<std::string>(
      "--part", [&own](const std::string& text) { own = modelling::parse_part(text); },
      "K/N: compute part K of N of the " + items +
          " and store it beside FOLDER; calls for other parts may run at the same time, on any "
          "machine that shares the folder");
  command
      .add_option("--merge", merge,
                  "N: write the result of the N parts computed with --part, or list the missing "
                  "ones; identical to the result of a single call")
      ->check(CLI::Range(2, 1000000));
}

void warn_of_doubts(const contact::Case& input) {
  warn(contact::implausible_values(input));
  warn(profiles::neglected_in_files(input));
}

bool report_drawn(const ComputingRequest& request, const fs::path& directory) {
  return request.report &&
         draw(request.call, directory, "the results were written, but the report was not drawn");
}

void tell_where(const fs::path& directory, const char* page, bool drawn) {
  std::cout << "\nresults: " << directory.string() << '\n';
  if (drawn) std::cout << "report:  " << (directory / page).string() << '\n';
}

}  // namespace rollfem::app
