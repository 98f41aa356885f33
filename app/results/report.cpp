// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `report`: figures and page of a stored result.
#include "result/write/report.hpp"

#include "app/frame/commands.hpp"
#include "base/errors.hpp"
#include "modelling/program/provenance.hpp"

#include <fmt/format.h>

namespace rollfem::app {

namespace {

void draw_report(const std::string& directory, const std::vector<std::string>& overlays) {
  const auto holds = [&](const char* file) {
    return std::filesystem::exists(std::filesystem::path(directory) / file);
  };
  if (!holds("results.h5") && !holds("compare.json") && !holds("study.json") && !holds("table.h5"))
    throw contact::InputError(
        fmt::format("report: {} holds no result; do: name a folder that rollfem run, compare, "
                    "study or table wrote",
                    directory));
  const std::string problem =
      result::make_report(directory, modelling::script_directory().string(), overlays);
  if (!problem.empty()) throw contact::InputError("report: " + problem);
}

}  // namespace

void add_report(CLI::App& program, Call& /*call*/) {
  const auto directory = std::make_shared<std::string>();
  CLI::App* report =
      program.add_subcommand("report", "draw or redraw figures and report of a stored result");
  report->add_option("result", *directory, "folder of a run, a comparison, a study or a table")
      ->required();
  const auto overlays = std::make_shared<std::vector<std::string>>();
  report->add_option("--overlay", *overlays,
                     "measured creep curves to draw over those of a run: tables (CSV) of creepage, "
                     "traction coefficient and, if known, its bar");
  report->footer("example: rollfem report results/thesis_a --overlay measured.csv");
  report->callback([directory, overlays] { draw_report(*directory, *overlays); });
}

}  // namespace rollfem::app
