// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/creep_table.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::tables {

namespace {

/// Smallest overlap of the patches of neighbouring shifts without a jump. For S1002 on UIC60, 80
/// kN, steps of 0.5 mm: at an overlap of a fifth the interpolation error is three times that
/// elsewhere; at a half it is not larger.
constexpr double least_overlap = 0.25;

}  // namespace

bool is_positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

TablePlace CreepTable::node(std::size_t number) const {
  const std::size_t firsts = first_axis().size(), layer = number / firsts;
  return {first_axis()[number % firsts], load.empty() ? 0.0 : load[layer / speeds()],
          speed.empty() ? 0.0 : speed[layer % speeds()]};
}

std::vector<std::size_t> CreepTable::shape() const {
  std::vector<std::size_t> found;
  for (const std::vector<double>* axis : {&load, &speed})
    if (axis->size() > 1) found.push_back(axis->size());
  found.push_back(first_axis().size());
  for (const std::vector<double>& axis : creepage) found.push_back(axis.size());
  return found;
}

bool contact_jumps(const TableWheel& a, const TableWheel& b) {
  const double way = std::max(std::abs(a.y_wheel - b.y_wheel), std::abs(a.y_rail - b.y_rail));
  return a.contacts != b.contacts || way > (1.0 - least_overlap) * (a.semi_axis_y + b.semi_axis_y);
}

std::size_t CreepTable::size() const {
  return nodes() * creepage[0].size() * creepage[1].size() * creepage[2].size();
}

std::size_t CreepTable::place(std::size_t first, std::size_t i, std::size_t j,
                              std::size_t k) const {
  return ((first * creepage[0].size() + i) * creepage[1].size() + j) * creepage[2].size() + k;
}

double table_coordinate(double scaled_creepage) {
  const double size = std::abs(scaled_creepage);
  return std::copysign(size <= 1.0 ? size : 1.0 + std::log(size), scaled_creepage);
}

double creepage_at(double coordinate) {
  const double size = std::abs(coordinate);
  return std::copysign(size <= 1.0 ? size : std::exp(size - 1.0), coordinate);
}

std::vector<double> creepages_to(double largest, int count) {
  const double end = table_coordinate(largest);
  std::vector<double> found;
  for (int k = 0; k < count; ++k) found.push_back(creepage_at(end * k / (count - 1)));
  found.back() = largest;
  return found;
}

std::vector<double> spins_to(double largest, int count) {
  const double end = table_coordinate(largest);
  std::vector<double> found;
  for (int k = 0; k < count; ++k)
    found.push_back(creepage_at(end * (2 * k - (count - 1)) / (count - 1)));
  found.front() = -largest;
  found.back() = largest;
  return found;
}

const std::vector<WheelColumn>& wheel_columns() {
  using W = TableWheel;
  static const std::vector<WheelColumn> columns{
      {"semi_axis_x", &W::semi_axis_x, "mm", "a of the ellipse that scales creepages", true},
      {"semi_axis_y", &W::semi_axis_y, "mm", "b of the ellipse that scales creepages", true},
      {"normal_force", &W::normal_force, "N", "of all contacts, each along its own normal", true},
      {"contact_angle", &W::contact_angle, "rad", "of the main contact"},
      {"rolling_radius", &W::rolling_radius, "mm", "of the main contact"},
      {"y_rail", &W::y_rail, "mm", "reference point of the main contact, rail profile"},
      {"y_wheel", &W::y_wheel, "mm", "reference point of the main contact, wheel profile"},
      {"lateral_pressure", &W::lateral_pressure, "N",
       "force of the main contact's pressure along its y"},
      {"max_pressure", &W::max_pressure, "MPa", "largest of all contacts", true},
      {"contact_area", &W::contact_area, "mm2", "of all contacts", true},
      {"contacts", &W::contacts, "1", "contacts in different planes"},
      {"jump_after", &W::jump_after, "1", "1: contact jumps between this shift and the next"}};
  return columns;
}

}  // namespace rollfem::tables
