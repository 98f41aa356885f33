// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `wheelset`: rolling radii, contact angles and equivalent conicity of the rigid
// wheelset of a case over its lateral shift; no contact problem is solved.
#include "app/input/wheelset.hpp"

#include "app/frame/commands.hpp"
#include "app/frame/screen.hpp"
#include "base/errors.hpp"
#include "base/threads.hpp"
#include "result/files/files_together.hpp"
#include "result/write/csv.hpp"
#include "result/write/output.hpp"
#include "track/motion/placed_scenes.hpp"
#include "track/motion/rigid_touch.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

namespace {

struct WheelsetRequest : CaseRequest {
  using CaseRequest::CaseRequest;
  bool json = false;    ///< print JSON; files are then written only into `directory`
  double reach = 10.0;  ///< largest shift, mm, to the right; the other side is the mirror image
};

constexpr double shift_step = 0.1;  // mm; EN 15302 requires at most 0.2
constexpr int rows_per_millimetre = 10;

std::string value_or(const std::optional<double>& value, const char* format, const char* none) {
  return value ? fmt::format(fmt::runtime(format), *value) : none;
}

using result::RigidWheelset;

std::string table_of(const std::vector<RigidWheelset>& rows) {
  std::string text =
      "shift mm  r right - left mm  angle left mrad  right mrad  conicity: harmonic    wave  wave "
      "length m\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k % rows_per_millimetre != 0 && k + 1 != rows.size()) continue;
    const RigidWheelset& row = rows[k];
    text += fmt::format("{:8.1f} {:18.4f} {:16.2f} {:11.2f} {:>19} {:>7} {:>14}\n",
                        row.lateral_shift, row.radius_difference(), 1e3 * row.angle_left,
                        1e3 * row.angle_right, value_or(row.conicity_harmonic, "{:.4f}", "-"),
                        value_or(row.conicity_wave, "{:.4f}", "-"),
                        row.wave_length ? fmt::format("{:.2f}", 1e-3 * *row.wave_length) : "-");
  }
  return text;
}

}  // namespace

void add_rigid_wheelset(const track::SearchScene& search, result::RunRecord& record) {
  const contact::Case& input = record.input;
  const std::vector<double>& shifts = input.wheelset.lateral_shift;
  if (input.wheelset.positions() < 2 || input.wheelset.on_rail) return;
  const auto [least, most] = std::minmax_element(shifts.begin(), shifts.end());
  if (*least == *most) return;  // a sweep over yaw angles only
  const auto nearer = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double reach = std::abs(*std::max_element(shifts.begin(), shifts.end(), nearer));
  if (reach < 2.0 * shift_step) return;
  auto rows = contact::attempt([&] {
    return track::wheelset_rows(input, search, std::ceil(reach / shift_step) * shift_step,
                                shift_step);
  });
  if (!rows) return;  // profiles for which only one wheel stands on its rail
  record.wheelset.resize(shifts.size());
  contact::for_each_index(shifts.size(), [&](std::size_t k) {
    record.wheelset[k] = track::wheelset_row(input, search, *rows, shifts[k]);
  });
  record.rigid_row = std::move(*rows);
}

namespace {

void check(const WheelsetRequest& request, const contact::Case& input) {
  if (!input.has_profiles())
    throw contact::InputError(fmt::format(
        "{}: wheel and rail are given by radii, without a track; allowed: a case with profiles; "
        "do: give wheel.profile, rail.profile and [wheelset], as in cases/manchester_A22.toml",
        input.file));
  if (input.wheelset.on_rail)
    throw contact::InputError(
        fmt::format("{}: [placement] is a wheel by itself, without a track; allowed: a wheelset on "
                    "a track; do: "
                    "give [track] and [wheelset] instead",
                    input.file));
  if (!(request.reach >= 2.0 * shift_step && request.reach <= 30.0))
    throw contact::InputError(fmt::format(
        "--reach {:g}: allowed: 0.2 to 30 mm; do: give a shift in this range", request.reach));
}

void print(const contact::Case& input, const std::vector<RigidWheelset>& rows) {
  nlohmann::ordered_json json = result_head("wheelset");
  json["case_file"] = input.file;
  json["title"] = input.title;
  json["contact_distance"] = track::contact_distance(input.track);
  json["rolling_radius"] = input.wheel.rolling_radius;
  json.update(columns_json(result::rigid_wheelset_columns(), rows));
  print_result(json.dump(1));
}

void print_table(const WheelsetRequest& request, const contact::Case& input,
                 const std::vector<RigidWheelset>& rows) {
  const double last = rows.back().lateral_shift;
  std::cout << fmt::format(
      "{}\nrigid wheelset, contacts {:g} mm apart, rolling radius {:g} mm; the other side is the "
      "mirror image{}\n\n{}",
      input.title, track::contact_distance(input.track), input.wheel.rolling_radius,
      std::isfinite(input.rail.rolling_radius) ? "; conicity with the radii of the rollers" : "",
      table_of(rows));
  if (last + 0.5 * shift_step < request.reach)
    std::cout << fmt::format("beyond {:.1f} mm a wheel leaves its rail or its profile ends\n",
                             last);
}

void wheelset(const WheelsetRequest& request) {
  const contact::Case input = request.read();
  warn_of_doubts(input);
  check(request, input);
  const std::vector<RigidWheelset> rows =
      track::wheelset_rows(input, track::search_scene_of(input), request.reach, shift_step);
  if (request.json) print(input, rows);
  if (request.json && request.directory.empty()) return;
  const fs::path folder = request.folder("_wheelset");
  result::replace_file(folder / "wheelset.csv", result::rigid_wheelset_columns().table(rows));
  print_table(request, input, rows);
  std::cout << '\n';
  draw_and_print(request.call, folder / "wheelset.csv");
}

}  // namespace

void add_wheelset(CLI::App& program, Call& call) {
  const auto request = std::make_shared<WheelsetRequest>(call);
  CLI::App* wheelset = program.add_subcommand(
      "wheelset",
      "rolling radii, contact angles and equivalent conicity of a wheelset over its lateral shift");
  wheelset->add_option("case", request->case_file, "case file (.toml) with profiles")->required();
  wheelset->add_option("--reach", request->reach, "largest shift in mm (default: 10)");
  wheelset->add_option("-o,--output", request->directory,
                       "folder for the table (.csv) and the figure (.svg) (default: results/<name "
                       "of the case file>_wheelset)");
  add_json_flag(*wheelset, request->json);
  add_set_option(*wheelset, request->changes);
  wheelset->footer("example: rollfem wheelset cases/manchester_A22.toml");
  wheelset->callback([request] { app::wheelset(*request); });
}

}  // namespace rollfem::app
