// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/wheelset_rows.hpp"

#include "contact/result/quantities.hpp"
#include "postprocess/write/csv.hpp"
#include "postprocess/write/point_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::postprocess {

namespace {

using contact::ModelResult;
using contact::PointResult;

/// Number with `digits` decimals in a column; "-" if empty.
std::string column(const std::optional<double>& value, int width, int digits) {
  if (!value) return fmt::format("{:>{}}", "-", width);
  const double rounded = std::abs(*value) < 0.5 * std::pow(10.0, -digits) ? 0.0 : *value;
  return fmt::format("{:>{}.{}f}", rounded, width, digits);
}

template <class Value>
std::string column_of(const WheelAt& wheel, int width, int digits, const Value& value) {
  return column(wheel.main ? std::optional<double>(value(wheel)) : std::nullopt, width, digits);
}

std::string rigid_text(const std::optional<RigidWheelset>& rigid) {
  const auto of = [&](const std::optional<double> RigidWheelset::*member) {
    return rigid ? (*rigid).*member : std::nullopt;
  };
  std::optional<double> difference, length = of(&RigidWheelset::wave_length);
  if (rigid) difference = rigid->radius_difference();
  if (length) length = 1e-3 * *length;
  return column(difference, 10, 4) + column(of(&RigidWheelset::conicity_harmonic), 11, 4) +
         column(of(&RigidWheelset::conicity_wave), 9, 4) + column(length, 8, 1);
}

std::string wheel_cells(const WheelAt& wheel, std::size_t k) {
  if (!wheel.main) return ",,,,,,,,,,,";
  const contact::PointResult& point = wheel.main->points[k];
  return fmt::format(",{},{},{},{},{},{},{},{},{},{},{}", wheel.patches,
                     wheel.main->place->rolling_radius, wheel.main->place->contact_angle,
                     point.contact_length, point.contact_width, wheel.area, wheel.max_pressure,
                     wheel.vertical_force, wheel.longitudinal_force, wheel.lateral_force_track,
                     csv_cell(point.loaded_height));
}

std::string head(const std::vector<WayScalar>& ways) {
  std::string text = "position [-],lateral_shift [mm],yaw [rad]";
  for (const WayScalar& way : ways) text += fmt::format(",{} [{}]", way.name, way.unit);
  text += ",model,point";
  for (const char* wheel : {"left", "right"})
    for (const char* what :
         {"patches [-]", "rolling_radius [mm]", "contact_angle [rad]", "contact_length [mm]",
          "contact_width [mm]", "contact_area [mm2]", "max_pressure [MPa]", "vertical_force [N]",
          "longitudinal_force [N]", "lateral_force_track [N]", "loaded_height [mm]"})
      text += fmt::format(",{} {}", wheel, what);
  return text +
         ",radius_difference [mm],rigid_radius_difference [mm],conicity_harmonic [-],conicity_wave "
         "[-],wave_length [mm]\n";
}

std::string conicity_cells(const RigidWheelset& rigid) {
  return fmt::format(",{},{},{}", csv_cell(rigid.conicity_harmonic), csv_cell(rigid.conicity_wave),
                     csv_cell(rigid.wave_length));
}

}  // namespace

WheelAt wheel_at(const RunRecord& run, const std::string& model, bool left, int position,
                 std::size_t point) {
  WheelAt wheel;
  for (const ModelResult& patch : run.models) {
    if (!patch.place || patch.name != model || patch.place->left != left ||
        patch.place->position != position || point >= patch.points.size())
      continue;
    const PointResult& found = patch.points[point];
    ++wheel.patches;
    wheel.vertical_force += found.vertical_force.value_or(0.0);
    wheel.longitudinal_force += found.longitudinal_force;
    wheel.lateral_force_track += found.lateral_force_track.value_or(0.0);
    wheel.area += found.contact_area;
    wheel.max_pressure = std::max(wheel.max_pressure, found.max_pressure);
    if (!wheel.main || found.normal_force > wheel.main->points[point].normal_force)
      wheel.main = &patch;
  }
  return wheel;
}

std::optional<double> loaded_radius_difference(const WheelAt& left, const WheelAt& right) {
  if (!left.main || !right.main) return {};
  return right.main->place->rolling_radius - left.main->place->rolling_radius;
}

std::vector<std::string> model_names(const RunRecord& run) {
  std::vector<std::string> names;
  for (const ModelResult& model : run.models)
    if (std::find(names.begin(), names.end(), model.name) == names.end())
      names.push_back(model.name);
  return names;
}

std::string wheelset_table(const RunRecord& run, const std::string& model) {
  if (run.wheelset.empty()) return {};
  std::string text = fmt::format(
      "\nthe wheelset, by {} at the first load point; rigid: unloaded; Y: lateral force on "
      "the wheel in the track frame, to the right\n"
      "{:>4}{:>10}{:>20}{:>29}{:>17}{:>18}{:>18}\n"
      "{:>4}{:>10}{:>10}{:>10}{:>11}{:>9}{:>9}{:>9}{:>8}{:>10}{:>8}{:>10}{:>8}\n",
      model, "", "", "r right - left mm", "conicity at the amplitude", "angle mrad", "p0 MPa",
      "Y kN", "pos", "shift mm", "rigid", "loaded", "harmonic", "wave", "wave m", "left", "right",
      "left", "right", "left", "right");
  for (std::size_t p = 0; p < run.wheelset.size(); ++p) {
    const int position = static_cast<int>(p) + 1;
    const WheelAt left = wheel_at(run, model, true, position, 0);
    const WheelAt right = wheel_at(run, model, false, position, 0);
    const std::string rigid = rigid_text(run.wheelset[p]);
    text += fmt::format("{:>4}{:>10.6g}{}{}{}", position, run.input.wheelset.lateral_shift[p],
                        rigid.substr(0, 10), column(loaded_radius_difference(left, right), 10, 4),
                        rigid.substr(10));
    const auto both = [&](int first, int second, int digits, const auto& value) {
      text += column_of(left, first, digits, value) + column_of(right, second, digits, value);
    };
    both(10, 8, 2, [](const WheelAt& w) { return 1e3 * w.main->place->contact_angle; });
    both(10, 8, 1, [](const WheelAt& w) { return w.max_pressure; });
    both(10, 8, 2, [](const WheelAt& w) { return 1e-3 * w.lateral_force_track; });
    text += '\n';
  }
  return text;
}

std::string wheelset_csv(const RunRecord& run) {
  const std::vector<WayScalar> ways = ways_of(run.input);
  const bool moves_along = std::any_of(ways.begin(), ways.end(), [&](const WayScalar& way) {
    const auto& at = run.input.wheelset.*way.list;
    return std::any_of(at.begin(), at.end(), [&](double value) { return value != at.front(); });
  });
  if (run.wheelset.empty() && !moves_along) return {};
  std::string text = head(ways);
  for (std::size_t p = 0; p < run.input.wheelset.positions(); ++p) {
    std::string way_cells;
    for (const WayScalar& way : ways)
      way_cells += fmt::format(",{}", way.at(run.input, static_cast<int>(p) + 1));
    for (const std::string& model : model_names(run))
      for (std::size_t k = 0;; ++k) {
        const int position = static_cast<int>(p) + 1;
        const WheelAt left = wheel_at(run, model, true, position, k);
        const WheelAt right = wheel_at(run, model, false, position, k);
        if (!left.main && !right.main) break;
        const std::optional<RigidWheelset> rigid =
            run.wheelset.empty() ? std::nullopt : run.wheelset[p];
        text += fmt::format(
            "{},{},{}{},{},{}{}{},{}{}\n", position, run.input.wheelset.lateral_shift[p],
            run.input.wheelset.yaw[p], way_cells, model, k + 1, wheel_cells(left, k),
            wheel_cells(right, k), csv_cell(loaded_radius_difference(left, right)),
            rigid ? fmt::format(",{}{}", rigid->radius_difference(), conicity_cells(*rigid))
                  : ",,,,");
      }
  }
  return text;
}

namespace {

template <auto Member>
std::optional<double> member_of(const RigidWheelset& wheelset) {
  return wheelset.*Member;
}

}  // namespace

const std::vector<RigidColumn>& rigid_columns() {
  using W = RigidWheelset;
  static const std::vector<RigidColumn> columns{
      {"lateral_shift", "mm", member_of<&W::lateral_shift>},
      {"roll", "rad", member_of<&W::roll>},
      {"radius_left", "mm", member_of<&W::radius_left>},
      {"radius_right", "mm", member_of<&W::radius_right>},
      {"radius_difference", "mm",
       [](const W& wheelset) { return std::optional(wheelset.radius_difference()); }},
      {"angle_left", "rad", member_of<&W::angle_left>},
      {"angle_right", "rad", member_of<&W::angle_right>},
      {"y_wheel_left", "mm", member_of<&W::y_wheel_left>},
      {"y_wheel_right", "mm", member_of<&W::y_wheel_right>},
      {"conicity_harmonic", "-", member_of<&W::conicity_harmonic>},
      {"conicity_wave", "-", member_of<&W::conicity_wave>},
      {"wave_length", "mm", member_of<&W::wave_length>}};
  return columns;
}

std::string rigid_wheelset_csv(const std::vector<RigidWheelset>& rows) {
  std::string text;
  const auto line = [&](const auto& cell) {
    for (const RigidColumn& column : rigid_columns())
      text += (&column == &rigid_columns().front() ? "" : ",") + cell(column);
    text += '\n';
  };
  line([](const RigidColumn& column) { return fmt::format("{} [{}]", column.name, column.unit); });
  for (const RigidWheelset& row : rows)
    line([&](const RigidColumn& column) { return csv_cell(column.value(row)); });
  return text;
}

}  // namespace rollfem::postprocess
