// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/creep_table.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::tables {

namespace {

bool increasing(const std::vector<double>& values) {
  return !values.empty() &&
         std::adjacent_find(values.begin(), values.end(),
                            [](double a, double b) { return !(a < b); }) == values.end();
}

void refuse_shape(const std::string& what) {
  throw contact::InputError("table: " + what + "; do: use a file written by rollfem table");
}

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

CreepTableReader::CreepTableReader(CreepTable table) : table_(std::move(table)) {
  if (!increasing(table_.first_axis())) refuse_shape("its first axis does not increase");
  check_creepages();
  for (std::size_t q = 0; q < 3; ++q)
    for (const double x : table_.creepage[q]) coordinate_[q].push_back(table_coordinate(x));
  const bool shifts = table_.over_shifts();
  if (!shifts && table_.axis_ratio.front() <= 0.0) refuse_shape("its ratios are not positive");
  check_conditions();
  if (table_.forces.size() != table_.size() || table_.bars.size() != table_.size() ||
      table_.scale.size() != (shifts ? table_.loads() : 1) * table_.first_axis().size())
    refuse_shape("its forces do not fit its axes");
  if (shifts) check_wheels();
  find_stretches();
}

void CreepTableReader::check_conditions() const {
  for (const std::vector<double>* axis : {&table_.load, &table_.speed})
    if (!axis->empty() && (!increasing(*axis) || !is_positive(axis->front())))
      refuse_shape("its loads or speeds are not positive or do not increase");
  const bool shifts = table_.over_shifts();
  if (!shifts && table_.only_for.empty()) return;
  if (!shifts && (table_.load.empty() || table_.mean_axis.size() != table_.axis_ratio.size()))
    refuse_shape("its ellipses have no load or no size");
  if (!is_positive(table_.shear_modulus) || !is_positive(table_.friction_coefficient))
    refuse_shape("it has no stiffness or no friction");
}

void CreepTableReader::find_stretches() {
  const bool shifts = table_.over_shifts();
  const auto jumps = [&](std::size_t a, std::size_t b) {
    return shifts && contact_jumps(table_.wheels[a], table_.wheels[b]);
  };
  const auto add = [](Stretches& stretches, std::size_t node, bool anew, double x) {
    if (node == 0 || anew) stretches.push_back({node, {}});
    stretches.back().nodes.push_back(x);
  };
  const std::size_t firsts = table_.first_axis().size();
  first_.resize(shifts ? table_.loads() : 1);
  for (std::size_t l = 0; l < first_.size(); ++l)
    for (std::size_t k = 0; k < firsts; ++k)
      add(first_[l], k,
          shifts && k > 0 && table_.wheels[table_.pressed(l, k - 1)].jump_after != 0.0,
          shifts ? table_.lateral_shift[k] : std::log(table_.axis_ratio[k]));
  load_.resize(shifts ? firsts : 1);
  for (std::size_t k = 0; k < load_.size(); ++k)
    for (std::size_t l = 0; l < table_.loads(); ++l)
      add(load_[k], l, l > 0 && jumps(table_.pressed(l - 1, k), table_.pressed(l, k)),
          table_.load.empty() ? 0.0 : std::log(table_.load[l]));
  for (std::size_t n = 0; n < table_.speeds(); ++n)
    add(speed_, n, false, table_.speed.empty() ? 0.0 : std::log(table_.speed[n]));
}

void CreepTableReader::check_creepages() const {
  for (const std::vector<double>& axis : table_.creepage)
    if (axis.size() < 2 || !increasing(axis)) refuse_shape("its creepages do not increase");
  for (std::size_t q = table_.over_shifts() ? 0 : 2; q < 3; ++q) {
    const std::vector<double>& both = table_.creepage[q];
    for (std::size_t k = 0; k < both.size(); ++k)
      if (both[k] != -both[both.size() - 1 - k])
        refuse_shape("its creepages are not of both signs");
  }
  if (!table_.over_shifts() &&
      (table_.creepage[0].front() != 0.0 || table_.creepage[1].front() != 0.0))
    refuse_shape("its creepages do not begin with 0");
}

void CreepTableReader::check_wheels() const {
  if (table_.wheels.size() != table_.scale.size() || table_.along_normal.size() != table_.size())
    refuse_shape("its wheels do not fit its lateral shifts");
  for (const TableWheel& wheel : table_.wheels)
    if (!is_positive(wheel.semi_axis_x) || !is_positive(wheel.semi_axis_y) ||
        !is_positive(wheel.normal_force))
      refuse_shape("a wheel has no contact");
}

}  // namespace rollfem::tables
