// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/equivalent_case.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::convert {

void remove_unused_values(std::vector<Point>& points) {
  for (const std::string name : {"longitudinal", "lateral"}) {
    const std::string force = "rolling." + name + "_force";
    const auto prescribed = std::count_if(points.begin(), points.end(), [&](const Point& point) {
      const auto found = point.find(force);
      return found != point.end() && !std::isnan(found->second);
    });
    for (Point& point : points) {
      if (prescribed == 0) point.erase(force);
      if (prescribed < static_cast<std::ptrdiff_t>(points.size())) continue;
      point.erase("rolling." + name + "_creepage");
      point.erase("history." + name + "_shift");
    }
  }
  const auto rolls = [](Point& point) {
    const auto way = point.find("history.wheel_way");
    return way == point.end() ||
           std::abs(way->second - point["history.step_length"]) <= 1e-6 * way->second;
  };
  if (std::all_of(points.begin(), points.end(), rolls))
    for (Point& point : points) point.erase("history.wheel_way");
}

namespace {

/// The elements' distances by rows, x and y ascending.
contact::Lattice lattice_of(const std::vector<std::array<double, 3>>& points, int nx) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(point[2]);
  const bool turned = points.front()[0] > points.back()[0];
  if (turned) std::reverse(values.begin(), values.end());
  const auto &first = turned ? points.back() : points.front(),
             &last = turned ? points.front() : points.back();
  const int ny = static_cast<int>(points.size()) / nx;
  return {"distances",
          nx,
          ny,
          first[0],
          first[1],
          (last[0] - first[0]) / std::max(nx - 1, 1),
          (last[1] - first[1]) / std::max(ny - 1, 1),
          {std::move(values)}};
}

}  // namespace

contact::NamedValues values_of(const Equivalent& made) {
  return values_of(made, {made.varied});
}

contact::NamedValues values_of(const Equivalent& made, std::vector<Point> points) {
  contact::NamedValues values;
  for (const auto& [section, settings] : made.fixed)
    for (const Setting& setting : settings)
      values.emplace_back(section.empty() ? setting.key : section + "." + setting.key,
                          setting.value);
  remove_unused_values(points);
  for (const auto& [path, value] : points.front()) {
    std::vector<double> of_points;
    for (const Point& point : points) of_points.push_back(point.at(path));
    values.emplace_back(path, points.size() > 1 ? contact::KeyValue(of_points) : value);
  }
  if (made.problem != "steady") values.emplace_back("rolling.problem", made.problem);
  if (made.from_sliding) values.emplace_back("friction.branch", "sliding");
  if (made.starts_steady) values.emplace_back("history.start", "steady");
  if (!made.distance.empty())
    values.emplace_back("undeformed_distance.quadratic", std::vector<double>{1e-3, 1e-3});
  return values;
}

contact::Case case_of(const Equivalent& made, const contact::NamedValues& values,
                      const std::string& name) {
  contact::Case input = contact::make_case(values, name);
  if (made.distance.empty()) return input;
  const auto row = std::find_if(made.distance.begin(), made.distance.end(), [&](const auto& point) {
    return point[1] != made.distance.front()[1];
  });
  input.undeformed_distance.quadratic.reset();
  input.undeformed_distance.values =
      lattice_of(made.distance, static_cast<int>(row - made.distance.begin()));
  return input;
}

}  // namespace rollfem::convert
