// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/csv.hpp"
#include "postprocess/write/wheelset_rows.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

namespace {

std::string wheel_cells(const WheelAt& wheel, std::size_t k) {
  if (!wheel.main) return ",,,,,,,,,,";
  const contact::PointResult& point = wheel.main->points[k];
  return fmt::format(",{},{},{},{},{},{},{},{},{},{}", wheel.patches,
                     wheel.main->place->rolling_radius, wheel.main->place->contact_angle,
                     point.contact_length, point.contact_width, wheel.area, wheel.max_pressure,
                     wheel.vertical_force, wheel.longitudinal_force, wheel.lateral_force_track);
}

std::string head() {
  std::string text = "position [-],lateral_shift [mm],yaw [rad],model,point";
  for (const char* wheel : {"left", "right"})
    for (const char* what :
         {"patches [-]", "rolling_radius [mm]", "contact_angle [rad]", "contact_length [mm]",
          "contact_width [mm]", "contact_area [mm2]", "max_pressure [MPa]", "vertical_force [N]",
          "longitudinal_force [N]", "lateral_force_track [N]"})
      text += fmt::format(",{} {}", wheel, what);
  return text +
         ",radius_difference [mm],rigid_radius_difference [mm],conicity_harmonic [-],conicity_wave "
         "[-],wave_length [mm]\n";
}

std::string number_or_nothing(const std::optional<double>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

std::string conicity_cells(const RigidWheelset& rigid) {
  return number_or_nothing(rigid.conicity_harmonic) + number_or_nothing(rigid.conicity_wave) +
         number_or_nothing(rigid.wave_length);
}

}  // namespace

std::string wheelset_csv(const RunRecord& run) {
  if (run.wheelset.empty()) return {};
  std::string text = head();
  for (std::size_t p = 0; p < run.wheelset.size(); ++p)
    for (const std::string& model : model_names(run))
      for (std::size_t k = 0;; ++k) {
        const int position = static_cast<int>(p) + 1;
        const WheelAt left = wheel_at(run, model, true, position, k);
        const WheelAt right = wheel_at(run, model, false, position, k);
        if (!left.main && !right.main) break;
        const std::optional<RigidWheelset>& rigid = run.wheelset[p];
        text += fmt::format(
            "{},{},{},{},{}{}{}{}{}\n", position, run.input.wheelset.lateral_shift[p],
            run.input.wheelset.yaw[p], model, k + 1, wheel_cells(left, k), wheel_cells(right, k),
            number_or_nothing(loaded_radius_difference(left, right)),
            rigid ? fmt::format(",{}{}", rigid->radius_difference(), conicity_cells(*rigid))
                  : ",,,,");
      }
  return text;
}

std::string rigid_wheelset_csv(const std::vector<RigidWheelset>& rows) {
  std::string text =
      "lateral_shift [mm],roll [rad],radius_left [mm],radius_right [mm],radius_difference "
      "[mm],angle_left [rad],angle_right [rad],y_wheel_left [mm],y_wheel_right "
      "[mm],conicity_harmonic [-],conicity_wave [-],wave_length [mm]\n";
  for (const RigidWheelset& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{},{}{}\n", row.lateral_shift, row.roll,
                        row.radius_left, row.radius_right, row.radius_difference(), row.angle_left,
                        row.angle_right, row.y_wheel_left, row.y_wheel_right, conicity_cells(row));
  return text;
}

}  // namespace rollfem::postprocess
