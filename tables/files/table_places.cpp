// SPDX-License-Identifier: LGPL-2.1-or-later
// Places of CreepTableReader: their coordinates on the axes, jumps of contact, and the place at
// which the bodies of a table have the friction of another ellipse.
#include "contact/base/errors.hpp"
#include "tables/files/creep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::tables {

namespace {

constexpr double let_pass = 1e-3;        // of ratio, load and speed, relative
constexpr double shift_let_pass = 1e-9;  // mm

}  // namespace

double CreepTableReader::first_coordinate(double place) const {
  const double low = table_.first_axis().front(), high = table_.first_axis().back();
  if (table_.over_shifts()) {
    if (!(place >= low - shift_let_pass && place <= high + shift_let_pass))
      throw contact::InputError(
          fmt::format("table: lateral shift {:g} mm: allowed: {:g} to {:g}; do: make a table with "
                      "[table] lateral_shift that covers it",
                      place, low, high));
    return std::clamp(place, low, high);
  }
  if (!(place >= low * (1.0 - let_pass) && place <= high * (1.0 + let_pass)))
    throw contact::InputError(
        fmt::format("table: a/b = {:g}: allowed: {:g} to {:g}; do: make a table with [table] "
                    "axis_ratio that covers it",
                    place, low, high));
  return std::log(std::clamp(place, low, high));
}

/// The coordinate on the axis of loads or speeds.
double CreepTableReader::condition(const char* name, const char* unit,
                                   const std::vector<double>& axis, double given) const {
  if (axis.empty()) {
    if (given == 0.0) return 0.0;
    throw contact::InputError(
        fmt::format("table: {} {:g} {}: its forces are of no {}; allowed: "
                    "tables with [table] {}; do: leave it out",
                    name, given, unit, name, name));
  }
  if (given == 0.0 && axis.size() == 1) given = axis.front();
  const double low = axis.front(), high = axis.back();
  if (!(given >= low * (1.0 - let_pass) && given <= high * (1.0 + let_pass)))
    throw contact::InputError(fmt::format(
        "table: {} {:g} {}{}: allowed: {:g} to {:g}; do: {}make a table with [table] {} that "
        "covers it",
        name, given, unit,
        table_.over_shifts() ? "" : " on the bodies of the table, at equal friction", low, high,
        given == 0.0 ? "give it, or " : "", name));
  return std::log(std::clamp(given, low, high));
}

CreepTableReader::OnAxis CreepTableReader::on_axis(const Stretches& stretches, double x) {
  const auto at_end = [](std::size_t node) {
    Nodes end;
    end.weights.first = static_cast<int>(node);
    end.weights.weight[0] = 1.0;
    end.around = {node, node};
    return end;
  };
  std::size_t s = 0;
  while (s + 1 < stretches.size() && x > stretches[s].nodes.back()) ++s;
  const Stretch& stretch = stretches[s];
  if (x < stretch.nodes.front() && s > 0) {  // in the gap before this stretch
    const Nodes before = at_end(stretch.first - 1), after = at_end(stretch.first);
    const double middle = 0.5 * (stretches[s - 1].nodes.back() + stretch.nodes.front());
    return x < middle ? OnAxis{before, after} : OnAxis{after, before};
  }
  Nodes nodes{axis_weights(stretch.nodes, x, false), {}};
  nodes.around = around(nodes.weights, stretch.nodes.size());
  nodes.weights.first += static_cast<int>(stretch.first);
  for (std::size_t& node : nodes.around) node += stretch.first;
  return {nodes, {}};
}

CreepTableReader::Place CreepTableReader::locate(const TablePlace& place) const {
  const double x = first_coordinate(place.first);
  std::size_t nearest = 0;  // shift
  if (table_.over_shifts())
    for (std::size_t k = 1; k < table_.lateral_shift.size(); ++k)
      if (std::abs(table_.lateral_shift[k] - x) < std::abs(table_.lateral_shift[nearest] - x))
        nearest = k;
  const OnAxis load = on_axis(load_[nearest], condition("load", "N", table_.load, place.load));
  Side near, beyond;
  near.load = load.near.weights;
  near.speed = on_axis(speed_, condition("speed", "mm/s", table_.speed, place.speed)).near.weights;
  beyond = near;
  bool jumps = load.beyond.has_value();
  if (jumps) beyond.load = load.beyond->weights;
  const auto first_at = [&](std::size_t at_load) {
    return on_axis(first_[table_.over_shifts() ? at_load : 0], x);
  };
  each_node(near.load, [&](std::size_t node, double, std::size_t slot) {
    const OnAxis found = first_at(node);
    near.first[slot] = found.near;
    if (!load.beyond) beyond.first[slot] = found.beyond.value_or(found.near);
    jumps = jumps || found.beyond;
  });
  if (load.beyond)
    each_node(beyond.load, [&](std::size_t node, double, std::size_t slot) {
      beyond.first[slot] = first_at(node).near;
    });
  if (jumps) return {near, beyond};
  return {near, {}};
}

/// A place at which the wheel and the scales are those of the given one.
TablePlace CreepTableReader::at_any_speed(TablePlace place) const {
  if (!table_.speed.empty()) place.speed = table_.speed.front();
  if (!table_.over_shifts() && !table_.load.empty()) place.load = table_.load.front();
  return place;
}

double CreepTableReader::mean_axis_at(const TablePlace& place) const {
  double logarithm = 0.0;
  each_node(on_axis(first_.front(), first_coordinate(place.first)).near.weights,
            [&](std::size_t first, double weight, std::size_t) {
              logarithm += weight * std::log(table_.mean_axis[first]);
            });
  const double load = place.load == 0.0 ? table_.load.front() : place.load;
  return std::exp(logarithm) * std::cbrt(load / table_.load.front());
}

/// The bodies of the table at another load and speed have the friction of this ellipse.
TablePlace CreepTableReader::place_of(double ratio, double c, double shear_modulus,
                                      double friction_bound, double speed) const {
  if (table_.only_for.empty()) return {ratio, 0.0, speed};
  if (std::abs(shear_modulus / table_.shear_modulus - 1.0) > let_pass)
    throw contact::InputError(fmt::format(
        "table: shear modulus {:g}: the table holds for {}; allowed: {:g} MPa, with mm and N; do: "
        "give it, or make another table",
        shear_modulus, table_.only_for, table_.shear_modulus));
  const double first = table_.load.front();
  const double force = friction_bound / table_.friction_coefficient / first,
               size = c / mean_axis_at({ratio, first}), pressure = force / (size * size);
  // Size and pressure of the table are in proportion to the cube root of its load.
  const double sets[] = {1.0, size, pressure, std::sqrt(size * pressure), std::cbrt(force)};
  const double root = sets[static_cast<std::size_t>(table_.load_sets)];
  if (table_.load_sets == LoadSets::all && std::abs(size / root - 1.0) > let_pass)
    throw contact::InputError(fmt::format(
        "table: sqrt(a b) = {:g} mm: the table holds for {}; allowed: {:g} mm at this a/b and mu "
        "F_n; do: make a table with bodies of this curvature",
        c, table_.only_for, c * root / size));
  if (speed == 0.0 && table_.speed.size() == 1) speed = table_.speed.front();
  return {ratio, first * root * root * root, speed * pressure / root};
}

}  // namespace rollfem::tables
