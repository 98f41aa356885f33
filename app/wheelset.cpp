#include "app/wheelset.hpp"

#include "app/files_together.hpp"
#include "app/models.hpp"
#include "app/places.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "meshes/track/rigid_touch.hpp"
#include "meshes/track/scenes.hpp"
#include "postprocess/write/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace rollfem::app {

namespace fs = std::filesystem;

using meshes::WheelsetRow;

namespace {

constexpr double shift_step = 0.1;  // mm; EN 15302 asks for 0.2 at most
constexpr int rows_per_millimetre = 10;
/// Of what a run says beside its patches, mm: as EN 15302.
constexpr double step_of_rows = 0.2;

std::string value_or(const std::optional<double>& value, const char* format, const char* none) {
  return value ? fmt::format(fmt::runtime(format), *value) : none;
}

std::string table_of(const std::vector<WheelsetRow>& rows) {
  std::string text =
      "shift mm  r right - left mm  angle left mrad  right mrad  conicity: harmonic    wave  wave "
      "length m\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k % rows_per_millimetre != 0 && k + 1 != rows.size()) continue;
    const WheelsetRow& row = rows[k];
    text += fmt::format("{:8.1f} {:18.4f} {:16.2f} {:11.2f} {:>19} {:>7} {:>14}\n",
                        row.touch.lateral_shift, row.touch.radius_difference(),
                        1e3 * row.touch.left.contact_angle, 1e3 * row.touch.right.contact_angle,
                        value_or(row.harmonic, "{:.4f}", "-"), value_or(row.wave, "{:.4f}", "-"),
                        row.wave_length ? fmt::format("{:.2f}", 1e-3 * *row.wave_length) : "-");
  }
  return text;
}

std::string csv_of(const std::vector<WheelsetRow>& rows) {
  std::string text =
      "lateral_shift [mm],roll [rad],radius_left [mm],radius_right [mm],radius_difference "
      "[mm],angle_left [rad],angle_right [rad],y_wheel_left [mm],y_wheel_right "
      "[mm],conicity_harmonic [-],conicity_wave [-],wave_length [mm]\n";
  for (const WheelsetRow& row : rows) {
    const meshes::WheelsetTouch& touch = row.touch;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", touch.lateral_shift, touch.roll,
                    touch.left.rolling_radius, touch.right.rolling_radius,
                    touch.radius_difference(), touch.left.contact_angle, touch.right.contact_angle,
                    touch.left.y_wheel, touch.right.y_wheel, value_or(row.harmonic, "{}", ""),
                    value_or(row.wave, "{}", ""), value_or(row.wave_length, "{}", ""));
  }
  return text;
}

void check(const WheelsetRequest& request, const contact::Case& input) {
  if (!input.has_profiles())
    throw contact::InputError(fmt::format(
        "{}: wheel and rail have radii, and no track; allowed: a case with profiles; do: give "
        "wheel.profile, rail.profile and [wheelset], as in cases/manchester_A22.toml",
        input.file));
  if (!(request.reach >= 2.0 * shift_step && request.reach <= 30.0))
    throw contact::InputError(fmt::format(
        "--reach {:g}: allowed: 0.2 to 30 mm; do: give a shift of that size", request.reach));
}

}  // namespace

std::vector<postprocess::WheelsetGeometry> wheelset_geometry(const contact::Case& input) {
  const std::vector<double>& shifts = input.wheelset.lateral_shift;
  const auto farther = [](double a, double b) { return std::abs(a) < std::abs(b); };
  if (!input.has_profiles() || input.wheelset.side != contact::WheelSide::both ||
      input.wheelset.positions() < 2)
    return {};
  const double reach = std::abs(*std::max_element(shifts.begin(), shifts.end(), farther));
  if (reach < step_of_rows) return {};
  const auto rows =
      meshes::wheelset_rows(input, meshes::search_scene_of(input), reach, step_of_rows);
  std::vector<postprocess::WheelsetGeometry> geometry;
  for (const double shift : shifts) {
    // The nearest of the rows: the other side is the mirror image.
    const auto k = static_cast<std::size_t>(std::lround(std::abs(shift) / step_of_rows));
    const WheelsetRow& row = rows[std::min(k, rows.size() - 1)];
    geometry.push_back(
        {std::copysign(1.0, shift) * row.touch.radius_difference(), row.harmonic, row.wave});
  }
  return geometry;
}

std::string wheelset_lines(const contact::Case& input,
                           const std::vector<postprocess::WheelsetGeometry>& geometry) {
  if (geometry.empty()) return "";
  std::string text =
      "\nrigid wheelset: position, shift mm, r right - left mm, equivalent conicity at that "
      "amplitude\n";
  for (std::size_t k = 0; k < geometry.size(); ++k)
    text += fmt::format("{:>8}{:>10.4g}{:>20.4f}{:>12}\n", k + 1, input.wheelset.lateral_shift[k],
                        geometry[k].radius_difference,
                        value_or(geometry[k].conicity_harmonic, "{:.4f}", "-"));
  return text;
}

void wheelset(const WheelsetRequest& request, const contact::ModelRegistry& models) {
  const contact::Case input =
      contact::read_case(request.case_file, model_words(models), request.changes);
  check(request, input);
  const std::vector<WheelsetRow> rows =
      meshes::wheelset_rows(input, meshes::search_scene_of(input), request.reach, shift_step);
  const fs::path folder =
      request.directory.empty()
          ? fs::path("results") / (fs::path(request.case_file).stem().string() + "_wheelset")
          : fs::path(request.directory);
  FilesTogether files("wheelset", folder);
  files.write("wheelset.csv", csv_of(rows));
  files.commit();
  const double last = rows.back().touch.lateral_shift;
  std::cout << fmt::format(
      "{}\nrigid wheelset, contacts {:g} mm apart, rolling radius {:g} mm; the other side is the "
      "mirror image\n\n{}",
      input.title, meshes::contact_distance(input.track), input.wheel.rolling_radius,
      table_of(rows));
  if (last + 0.5 * shift_step < request.reach)
    std::cout << fmt::format("beyond {:.1f} mm a wheel leaves its rail, or its profile ends\n",
                             last);
  const fs::path table = folder / "wheelset.csv";
  const std::string problem =
      postprocess::draw_wheelset(table.string(), script_directory().string());
  if (!problem.empty()) std::cerr << "warning: the figure was not drawn: " << problem << '\n';
  std::cout << "\ntable:  " << table.string() << '\n';
  if (problem.empty()) std::cout << "figure: " << (folder / "wheelset.svg").string() << '\n';
}

}  // namespace rollfem::app
