// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `table`: the creep force law of a case's contact over scaled creepages and axis
// ratios, or over lateral shifts of its wheelset, with error bars and interpolation errors.
#include "app/frame/commands.hpp"
#include "modelling/frame/parts.hpp"
#include "result/files/result_folder.hpp"
#include "tables/files/table_files.hpp"
#include "tables/filling/table_filling.hpp"
#include "tables/filling/table_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

using tables::CreepTable;

std::string range_of(const char* name, const std::vector<double>& axis) {
  return axis.size() == 1 ? fmt::format("{} = {:.4g}", name, axis.front())
                          : fmt::format("{:>2} values of {:<5} {:.4g} to {:.4g}", axis.size(), name,
                                        axis.front(), axis.back());
}

/// One line per shift, with marks where contact jumps.
std::string text_of_wheels(const CreepTable& table) {
  std::string text = "shift mm  angle mrad  radius mm  a mm   b mm   F_n N    p0 MPa  planes\n";
  for (std::size_t k = 0; k < table.wheels.size(); ++k) {
    const tables::TableWheel& wheel = table.wheels[k];
    if (table.load.size() > 1 && k % table.lateral_shift.size() == 0)
      text += fmt::format("load {:g} N\n", table.load[k / table.lateral_shift.size()]);
    text += fmt::format("{:8.6g} {:11.2f} {:10.4f} {:6.3f} {:6.3f} {:8.0f} {:8.1f} {:5.0f}\n",
                        table.lateral_shift[k % table.lateral_shift.size()],
                        1e3 * wheel.contact_angle, wheel.rolling_radius, wheel.semi_axis_x,
                        wheel.semi_axis_y, wheel.normal_force, wheel.max_pressure, wheel.contacts);
    if (wheel.jump_after != 0.0)
      text += "         contact jumps here: no interpolation up to the next shift\n";
  }
  return text;
}

/// Interpolation error of every axis and, where interpolation limits the table, which one to refine
/// and what that costs.
std::string advice_of(const CreepTable& table, double largest_bar, double seconds) {
  const tables::InterpolationError& error = table.interpolation;
  const bool shifts = table.over_shifts();
  const char* const names[] = {shifts ? "shift" : "a/b", "xi'", "eta'", "phi'", "load", "speed"};
  const char* const keys[] = {shifts ? "table.lateral_shift_step" : "table.axis_ratio",
                              "table.points or table.longitudinal_values",
                              "table.points or table.lateral_values",
                              "table.points or table.spin_values",
                              "table.load",
                              "table.speed"};
  const std::vector<double>* const axes[] = {&table.first_axis(), &table.creepage[0],
                                             &table.creepage[1],  &table.creepage[2],
                                             &table.load,         &table.speed};
  std::string text;
  for (std::size_t axis = 0; axis < error.by_axis.size(); ++axis)
    if (error.by_axis[axis] > 0.0)
      text += fmt::format("{}{} {:.2g} %", text.empty() ? "  by axis, in 95 of 100: " : ", ",
                          names[axis], 100.0 * error.by_axis[axis]);
  if (text.empty()) return text;
  text += '\n';
  if (std::max(error.force_95, error.moment_95) <= largest_bar) return text;
  const auto most = static_cast<std::size_t>(
      std::max_element(error.by_axis.begin(), error.by_axis.end()) - error.by_axis.begin());
  const std::size_t values = axes[most]->size();
  const double more = static_cast<double>(2 * values - 1) / static_cast<double>(values);
  return text + fmt::format(
                    "interpolation limits this table: refine {} first ({}); {} values "
                    "instead of {} would take about {:.2g} s\n",
                    names[most], keys[most], 2 * values - 1, values, seconds * more);
}

std::string summary_of(const CreepTable& table, double seconds) {
  const tables::InterpolationError& error = table.interpolation;
  std::string text = fmt::format(
      "{}\n\n{} points in {:.3g} s: forces over mu F_n, moment over mu F_n sqrt(a b)\n  {}\n",
      table.title, table.size(), seconds,
      table.over_shifts() ? range_of("lateral shift", table.lateral_shift) + " mm"
                          : range_of("a/b", table.axis_ratio));
  for (const auto& [name, values] :
       {std::pair{"load in N", &table.load}, {"speed in mm/s", &table.speed}})
    if (values->size() > 1) text += fmt::format("  {}\n", range_of(name, *values));
  if (!table.only_for.empty()) text += fmt::format("  only for {}\n", table.only_for);
  if (table.over_shifts()) text += text_of_wheels(table);
  const char* const names[] = {"xi'", "eta'", "phi'"};
  for (std::size_t q = 0; q < 3; ++q)
    text += fmt::format("  {}\n", range_of(names[q], table.creepage[q]));
  double force = 0.0, moment = 0.0;
  for (const auto& [f, m] : table.bars) {
    force = std::max(force, f);
    moment = std::max(moment, m);
  }
  text += fmt::format("bars at the points: forces up to {:.2g} %, moment up to {:.2g} %\n",
                      100.0 * force, 100.0 * moment);
  if (error.points > 0)
    text += fmt::format(
        "interpolation error at {} random points (seed {}):  forces up to {:.2g} % in 95 of 100, "
        "{:.2g} % at most; moment {:.2g} %, {:.2g} %\n",
        error.points, error.seed, 100.0 * error.force_95, 100.0 * error.force_max,
        100.0 * error.moment_95, 100.0 * error.moment_max);
  return text + advice_of(table, std::max(force, moment), seconds);
}

fs::path directory_of(const ComputingRequest& request) {
  return request.folder("_table");
}

void write_and_print(const ComputingRequest& request, const CreepTable& table, double seconds) {
  const fs::path directory = directory_of(request);
  std::map<std::string, std::string> files{{"table.h5", tables::table_hdf5(table)},
                                           {"table.csv", tables::table_csv(table)},
                                           {"interpolation.csv", tables::interpolation_csv(table)}};
  if (table.over_shifts()) files["shifts.csv"] = tables::shifts_csv(table);
  result::write_together(directory, files);
  const bool drawn = report_drawn(request, directory);
  if (request.quiet) return;
  std::cout << summary_of(table, seconds);
  print_where(directory, "table.html", drawn);
}

void table_at_once(const ComputingRequest& request) {
  const contact::Case input = request.read();
  CommandFrame frame(request, {});
  if (frame.idle()) return;
  modelling::refuse_other_result(directory_of(request), "table.h5");
  warn_of_doubts(input);
  if (const std::string ignored = tables::ignored_keys(input); !ignored.empty())
    frame.say("note: " + ignored);
  tables::CreepTable made = tables::empty_table(input);
  const result::Provenance provenance = frame.provenance();
  made.program = fmt::format("rollfem {} ({})", provenance.version, provenance.commit);
  made.command = provenance.command;
  made.started = provenance.started;
  result::check_directory(directory_of(request).string());
  frame.own(directory_of(request));
  const auto begin = std::chrono::steady_clock::now();
  frame.compute("table", "points", [&](const modelling::Solving& how) {
    tables::fill_table(made, input, how.progress, frame.keep_in(directory_of(request), input),
                       request.own);
    frame.clear_line();
    if (frame.ends_part()) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    write_and_print(request, made, seconds.count());
    frame.forget_kept();
  });
}

void table(ComputingRequest& request) {
  modelling::check_division(request, 2, "");  // a table has many points
  modelling::in_parts(request, true, directory_of(request), [&] { table_at_once(request); });
}

}  // namespace

void add_table(CLI::App& program, Call& call) {
  const auto request = std::make_shared<ComputingRequest>(call);
  CLI::App* table =
      program.add_subcommand("table",
                             "compute a table of creep forces over creepages, spin and "
                             "the ratio of the ellipse's axes or the "
                             "lateral shift of a wheelset");
  table
      ->add_option("case", request->case_file,
                   "case file (.toml); its section [table] defines the grid")
      ->required();
  table->add_option("-o,--output", request->directory,
                    "folder for the table (default: results/<name of the case file>_table)");
  table->add_flag("--resume", request->resume,
                  "resume an interrupted table from the points kept in FOLDER.unfinished");
  add_division(*table, request->own, request->merge, "points");
  add_report_flags(*table, *request);
  table->footer(
      "examples: rollfem table cases/thesis_a.toml --set table.points=[10,10,11]\n"
      "          rollfem table cases/s1002_uic60_left.toml --set table.lateral_shift=[-2,0,2]\n"
      "Contents of a table, and how Python and C read it: docs/tables.md");
  table->callback([request] { app::table(*request); });
}

}  // namespace rollfem::app
