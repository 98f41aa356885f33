// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/write/wheelset_rows.hpp"

#include "result/write/columns.hpp"
#include "result/write/contents.hpp"
#include "result/write/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

namespace rollfem::result {

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

/// Radius differences and conicities of a position.
std::string radii_text(const std::optional<RigidWheelset>& rigid, std::optional<double> loaded) {
  const auto of = [&](const std::optional<double> RigidWheelset::*member) {
    return rigid ? (*rigid).*member : std::nullopt;
  };
  std::optional<double> difference, length = of(&RigidWheelset::wave_length);
  if (rigid) difference = rigid->radius_difference();
  if (length) length = 1e-3 * *length;
  return column(difference, 10, 4) + column(loaded, 10, 4) +
         column(of(&RigidWheelset::conicity_harmonic), 11, 4) +
         column(of(&RigidWheelset::conicity_wave), 9, 4) + column(length, 8, 1);
}

/// A row of wheelset.csv: a position of the wheelset at a load point of a model.
struct Row {
  const RunRecord* run;
  std::size_t position;  ///< from 0
  std::string model;
  std::size_t point;
  WheelAt left, right;
  std::optional<RigidWheelset> rigid;
};

/// The columns of one wheel.
void add_wheel(Columns<Row>& columns, const std::string& side, WheelAt Row::*wheel) {
  const auto add = [&](const char* name, const char* unit, auto value) {
    columns.add(side + ' ' + name, unit, [wheel, value](const Row& row) -> std::optional<double> {
      const WheelAt& at = row.*wheel;
      if (!at.main) return {};
      return std::invoke(value, at);
    });
  };
  const auto of_place = [](double contact::ContactPlace::*member) {
    return [member](const WheelAt& at) { return (*at.main->place).*member; };
  };
  using P = PointResult;
  const auto of_point = [](auto member) {
    return [member](const WheelAt& at) { return at.main->points[at.point].*member; };
  };
  add("patches", "-", &WheelAt::patches);
  add("rolling_radius", "mm", of_place(&contact::ContactPlace::rolling_radius));
  add("contact_angle", "rad", of_place(&contact::ContactPlace::contact_angle));
  add("contact_length", "mm", of_point(&P::contact_length));
  add("contact_width", "mm", of_point(&P::contact_width));
  add("contact_area", "mm2", &WheelAt::area);
  add("max_pressure", "MPa", &WheelAt::max_pressure);
  add("vertical_force", "N", &WheelAt::vertical_force);
  add("longitudinal_force", "N", &WheelAt::longitudinal_force);
  add("lateral_force_track", "N", &WheelAt::lateral_force_track);
  add("loaded_height", "mm", of_point(&P::loaded_height));
}

Columns<Row> wheelset_columns(const RunRecord& run) {
  Columns<Row> columns;
  const auto of_position = [](std::vector<double> contact::Wheelset::*list) {
    return [list](const Row& row) { return (row.run->input.wheelset.*list)[row.position]; };
  };
  columns.add("position", "-", [](const Row& row) { return row.position + 1; });
  columns.add("lateral_shift", "mm", of_position(&contact::Wheelset::lateral_shift));
  columns.add("yaw", "rad", of_position(&contact::Wheelset::yaw));
  for (const WayScalar& way : ways_of(run.input))
    columns.add(way.name, way.unit, of_position(way.list));
  columns.add("model", "", &Row::model);
  columns.add("point", "", [](const Row& row) { return row.point + 1; });
  if (run.input.is_wheel_history())
    columns.add("distance", "mm", [](const Row& row) {
      const WheelAt& wheel = row.left.main ? row.left : row.right;
      return wheel.main->points[row.point].distance;
    });
  add_wheel(columns, "left", &Row::left);
  add_wheel(columns, "right", &Row::right);
  columns.add("radius_difference", "mm",
              [](const Row& row) { return loaded_radius_difference(row.left, row.right); });
  const auto add_rigid = [&](const char* name, const char* unit, auto member) {
    columns.add(name, unit, [member](const Row& row) -> std::optional<double> {
      if (!row.rigid) return {};
      return std::invoke(member, *row.rigid);
    });
  };
  add_rigid("rigid_radius_difference", "mm", &RigidWheelset::radius_difference);
  add_rigid("conicity_harmonic", "-", &RigidWheelset::conicity_harmonic);
  add_rigid("conicity_wave", "-", &RigidWheelset::conicity_wave);
  add_rigid("wave_length", "mm", &RigidWheelset::wave_length);
  return columns;
}

}  // namespace

std::vector<WayScalar> ways_of(const contact::Case& input) {
  using W = contact::Wheelset;
  std::vector<WayScalar> ways;
  for (const WayScalar& way :
       {WayScalar{"track_position", "mm", "where along the track the wheel is", &W::track_position},
        WayScalar{"wheel_angle", "rad",
                  "of the section of the wheel that points down; grows as it rolls forward",
                  &W::wheel_angle}})
    if (!(input.wheelset.*way.list).empty()) ways.push_back(way);
  return ways;
}

WheelAt wheel_at(const RunRecord& run, const std::string& model, bool left, int position,
                 std::size_t point) {
  WheelAt wheel;
  wheel.point = point;
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

std::vector<WheelDip> wheel_dips(const RunRecord& run) {
  const std::vector<double>& along = run.input.wheelset.track_position;
  std::vector<WheelDip> dips;
  for (const std::string& model : model_names(run))
    for (const bool left : {true, false}) {
      std::map<double, double> way;  // position along the track -> height under load
      for (std::size_t p = 0; p < along.size(); ++p) {
        const WheelAt wheel = wheel_at(run, model, left, static_cast<int>(p) + 1, 0);
        if (!wheel.main) continue;
        if (const auto& height = wheel.main->points[headline(*wheel.main)].loaded_height)
          way[along[p]] = *height;
      }
      const auto lowest = std::max_element(
          way.begin(), way.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      if (way.size() < 3 || lowest == way.begin() || lowest == std::prev(way.end())) continue;
      double fall = 0.0, rise = 0.0;
      for (auto to = std::next(way.begin()), from = way.begin(); to != way.end(); from = to++) {
        const double slope = (to->second - from->second) / (to->first - from->first);
        if (to->first <= lowest->first)
          fall = std::max(fall, slope);
        else
          rise = std::max(rise, -slope);
      }
      dips.push_back({model, contact::side_word(left), lowest->first, lowest->second, fall + rise});
    }
  return dips;
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
    text += fmt::format("{:>4}{:>10.6g}", position, run.input.wheelset.lateral_shift[p]) +
            radii_text(run.wheelset[p], loaded_radius_difference(left, right));
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
  if (run.wheelset.empty() && !moves_along && !run.input.is_wheel_history()) return {};
  std::vector<Row> rows;
  for (std::size_t p = 0; p < run.input.wheelset.positions(); ++p)
    for (const std::string& model : model_names(run))
      for (std::size_t k = 0;; ++k) {
        const int position = static_cast<int>(p) + 1;
        Row row{&run,
                p,
                model,
                k,
                wheel_at(run, model, true, position, k),
                wheel_at(run, model, false, position, k),
                {}};
        if (!row.left.main && !row.right.main) break;
        if (!run.wheelset.empty()) row.rigid = run.wheelset[p];
        rows.push_back(std::move(row));
      }
  return wheelset_columns(run).table(rows);
}

const Columns<RigidWheelset>& rigid_wheelset_columns() {
  static const Columns<RigidWheelset> columns = [] {
    Columns<RigidWheelset> all;
    all.add_members<RigidWheelset>([](const auto& row) -> const auto& { return row; });
    return all;
  }();
  return columns;
}

}  // namespace rollfem::result
