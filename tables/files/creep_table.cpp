// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/creep_table.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::tables {

namespace {

constexpr double ratio_let_pass = 1e-3;
constexpr double shift_let_pass = 1e-9;  // mm

bool increasing(const std::vector<double>& values) {
  return !values.empty() &&
         std::adjacent_find(values.begin(), values.end(),
                            [](double a, double b) { return !(a < b); }) == values.end();
}

void refuse_shape(const std::string& what) {
  throw contact::InputError("table: " + what + "; do: use a file written by rollfem table");
}

/// Weights along the creepage axes, for forces smooth at 0 and for forces bent at 0.
using CreepageWeights = std::array<std::array<AxisWeights, 2>, 3>;

/// Behaviour of F_x, F_y, M_z and the force along the normal at 0 of xi', eta' and phi': a force is
/// bent at 0 along the creepage that causes it.
constexpr AtZero at_zero[4][3] = {{AtZero::bent, AtZero::smooth, AtZero::smooth},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent}};
constexpr std::size_t along_normal = 3;

double value_of(const CreepTable& table, std::size_t point, std::size_t q) {
  return q == along_normal ? table.along_normal[point] : table.forces[point][q];
}

/// Weighted sum of force q over the nodes. Over ratios, node -1 of xi' is node 1 at -xi', where F_x
/// changes sign; node -1 of eta' is the mirror image of node 1, where phi', F_y and M_z change
/// sign. Only forces that keep their sign are smooth there.
double sum_of(const CreepTable& table, const AxisWeights& first, const CreepageWeights& creepage,
              std::size_t q) {
  const auto weights_of = [&](std::size_t axis) -> const AxisWeights& {
    return creepage[axis][static_cast<std::size_t>(at_zero[q][axis])];
  };
  const AxisWeights &x = weights_of(0), &y = weights_of(1), &z = weights_of(2);
  const auto spins = static_cast<int>(table.creepage[2].size());
  double sum = 0.0;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const double w = first.weight[r] * x.weight[i] * y.weight[j];
        if (w == 0.0) continue;
        const int m = x.first + static_cast<int>(i), n = y.first + static_cast<int>(j);
        for (std::size_t k = 0; k < 4; ++k) {
          if (z.weight[k] == 0.0) continue;
          const int spin = z.first + static_cast<int>(k);
          const std::size_t point = table.place(
              static_cast<std::size_t>(first.first + static_cast<int>(r)),
              static_cast<std::size_t>(std::abs(m)), static_cast<std::size_t>(std::abs(n)),
              static_cast<std::size_t>(n < 0 ? spins - 1 - spin : spin));
          sum += w * z.weight[k] * value_of(table, point, q);
        }
      }
  return sum;
}

/// The two nodes around the place: slots 1 and 2, if they exist.
std::array<std::size_t, 2> around(const AxisWeights& axis, std::size_t count) {
  if (count == 1) return {0, 0};
  const auto lower = static_cast<std::size_t>(axis.first + 1);
  return {lower, lower + 1};
}

std::array<double, 2> bars_of(const CreepTable& table, const std::array<std::size_t, 2>& first,
                              const CreepageWeights& creepage) {
  std::array<double, 2> largest{};
  for (const std::size_t r : first)
    for (const std::size_t i : around(creepage[0][0], table.creepage[0].size()))
      for (const std::size_t j : around(creepage[1][0], table.creepage[1].size()))
        for (const std::size_t k : around(creepage[2][0], table.creepage[2].size()))
          for (std::size_t q = 0; q < 2; ++q)
            largest[q] = std::max(largest[q], table.bars[table.place(r, i, j, k)][q]);
  return largest;
}

/// Widens the bars by the full difference across a jump.
void widen(TableForces& near, const TableForces& beyond) {
  near.force_bar += std::hypot(near.forces[0] - beyond.forces[0], near.forces[1] - beyond.forces[1],
                               near.along_normal - beyond.along_normal);
  near.moment_bar += std::abs(near.forces[2] - beyond.forces[2]);
}

bool positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

}  // namespace

std::size_t CreepTable::size() const {
  return first_axis().size() * creepage[0].size() * creepage[1].size() * creepage[2].size();
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
      {"semi_axis_x", &W::semi_axis_x, "mm", "a of the ellipse that scales creepages"},
      {"semi_axis_y", &W::semi_axis_y, "mm", "b of the ellipse that scales creepages"},
      {"normal_force", &W::normal_force, "N", "of all contacts, each along its own normal"},
      {"contact_angle", &W::contact_angle, "rad", "of the main contact"},
      {"rolling_radius", &W::rolling_radius, "mm", "of the main contact"},
      {"y_rail", &W::y_rail, "mm", "reference point of the main contact, rail profile"},
      {"y_wheel", &W::y_wheel, "mm", "reference point of the main contact, wheel profile"},
      {"lateral_pressure", &W::lateral_pressure, "N",
       "force of the main contact's pressure along its y"},
      {"max_pressure", &W::max_pressure, "MPa", "largest of all contacts"},
      {"contact_area", &W::contact_area, "mm2", "of all contacts"},
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
  if (table_.forces.size() != table_.size() || table_.bars.size() != table_.size() ||
      table_.scale.size() != table_.first_axis().size())
    refuse_shape("its forces do not fit its axes");
  if (shifts) check_wheels();
  for (std::size_t k = 0; k < table_.first_axis().size(); ++k) {
    if (k == 0 || (shifts && table_.wheels[k - 1].jump_after != 0.0)) stretches_.push_back({k, {}});
    const double place = table_.first_axis()[k];
    stretches_.back().nodes.push_back(shifts ? place : std::log(place));
  }
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
  if (table_.wheels.size() != table_.lateral_shift.size() ||
      table_.along_normal.size() != table_.size())
    refuse_shape("its wheels do not fit its lateral shifts");
  for (const TableWheel& wheel : table_.wheels)
    if (!positive(wheel.semi_axis_x) || !positive(wheel.semi_axis_y) ||
        !positive(wheel.normal_force))
      refuse_shape("a wheel has no contact");
  if (!positive(table_.shear_modulus) || !positive(table_.friction_coefficient))
    refuse_shape("it has no stiffness or no friction");
}

void CreepTableReader::refuse_other_kind(bool wanted_shifts) const {
  if (table_.over_shifts() == wanted_shifts) return;
  throw contact::InputError(
      wanted_shifts ? "table: a lateral shift was given, but this table is over axis ratios; "
                      "do: give the semi-axes, or make a table with [table] lateral_shift"
                    : "table: an ellipse was given, but this table is over lateral shifts; do: "
                      "give lateral_shift, or make a table with [table] axis_ratio");
}

double CreepTableReader::coordinate_of(double place) const {
  const double low = table_.first_axis().front(), high = table_.first_axis().back();
  if (table_.over_shifts()) {
    if (!(place >= low - shift_let_pass && place <= high + shift_let_pass))
      throw contact::InputError(
          fmt::format("table: lateral shift {:g} mm: allowed: {:g} to {:g}; do: make a table with "
                      "[table] lateral_shift that covers it",
                      place, low, high));
    return std::clamp(place, low, high);
  }
  if (!(place >= low * (1.0 - ratio_let_pass) && place <= high * (1.0 + ratio_let_pass)))
    throw contact::InputError(
        fmt::format("table: a/b = {:g}: allowed: {:g} to {:g}; do: make a table with [table] "
                    "axis_ratio that covers it",
                    place, low, high));
  return std::log(std::clamp(place, low, high));
}

CreepTableReader::Place CreepTableReader::locate(double place) const {
  const double x = coordinate_of(place);
  const auto at_end = [](std::size_t node) {
    Nodes end;
    end.weights.first = static_cast<int>(node);
    end.weights.weight[0] = 1.0;
    end.around = {node, node};
    return end;
  };
  std::size_t s = 0;
  while (s + 1 < stretches_.size() && x > stretches_[s].nodes.back()) ++s;
  const Stretch& stretch = stretches_[s];
  if (x < stretch.nodes.front()) {  // in the gap before this stretch
    Nodes before = at_end(stretch.first - 1), after = at_end(stretch.first);
    const double middle = 0.5 * (stretches_[s - 1].nodes.back() + stretch.nodes.front());
    return x < middle ? Place{before, after} : Place{after, before};
  }
  Nodes nodes{axis_weights(stretch.nodes, x, false), {}};
  nodes.around = around(nodes.weights, stretch.nodes.size());
  nodes.weights.first += static_cast<int>(stretch.first);
  for (std::size_t& node : nodes.around) node += stretch.first;
  return {nodes, {}};
}

Scaled CreepTableReader::scale_of(const Nodes& nodes) const {
  Scaled logarithm{};
  for (int r = 0; r < 4; ++r) {
    const double weight = nodes.weights.weight[static_cast<std::size_t>(r)];
    if (weight == 0.0) continue;
    const Scaled& factor = table_.scale[static_cast<std::size_t>(nodes.weights.first + r)];
    for (std::size_t q = 0; q < 3; ++q) logarithm[q] += weight * std::log(factor[q]);
  }
  return {std::exp(logarithm[0]), std::exp(logarithm[1]), std::exp(logarithm[2])};
}

Scaled CreepTableReader::scale_at(double place) const {
  return scale_of(locate(place).near);
}

TableForces CreepTableReader::forces_of(const Nodes& nodes, const Scaled& creepage) const {
  double shrunk = 1.0;
  for (std::size_t q = 0; q < 3; ++q) {
    if (!std::isfinite(creepage[q]))
      throw contact::InputError(
          "table: a creepage is not finite; allowed: finite numbers; do: check where it comes "
          "from");
    const double end = table_.creepage[q].back();
    if (std::abs(creepage[q]) * shrunk > end) shrunk = end / std::abs(creepage[q]);
  }
  constexpr double rounding = 1e-9;
  if (shrunk < 1.0 - rounding && !table_.only_for.empty())
    throw contact::InputError(
        fmt::format("table: the creepages are {:.4g} times those at the end of the table, which "
                    "holds for {}; allowed: creepages of the table; do: make one with larger "
                    "[table] largest",
                    1.0 / shrunk, table_.only_for));
  // For an ellipse, reversing all creepages reverses all forces; mirroring reverses eta, phi, F_y
  // and M_z. Both together reverse xi and F_x.
  const bool mirrored = !table_.over_shifts();
  const double along = mirrored && creepage[0] < 0.0 ? -1.0 : 1.0,
               across = mirrored && creepage[1] < 0.0 ? -1.0 : 1.0;
  const Scaled turned{along * creepage[0], across * creepage[1], across * creepage[2]};
  CreepageWeights weights;
  for (std::size_t q = 0; q < 3; ++q) {
    const double end = coordinate_[q].back();
    const double place = std::clamp(table_coordinate(shrunk * turned[q]), -end, end);
    for (const AtZero zero : {AtZero::smooth, AtZero::bent})
      weights[q][static_cast<std::size_t>(zero)] =
          axis_weights(coordinate_[q], place, mirrored && q < 2, zero);
  }
  const auto sum = [&](std::size_t q) { return sum_of(table_, nodes.weights, weights, q); };
  TableForces found;
  found.forces = {along * sum(0), across * sum(1), across * sum(2)};
  if (!mirrored) found.along_normal = sum(along_normal);
  const double size = std::hypot(found.forces[0], found.forces[1]);
  if (mirrored && size > 1.0)
    for (std::size_t q = 0; q < 2; ++q) found.forces[q] /= size;
  const auto bars = bars_of(table_, nodes.around, weights);
  found.force_bar = bars[0] + table_.interpolation.force_95;
  found.moment_bar = bars[1] + table_.interpolation.moment_95;
  return found;
}

TableForces CreepTableReader::at(double place, const Scaled& creepage) const {
  const Place here = locate(place);
  TableForces found = forces_of(here.near, creepage);
  if (here.beyond) widen(found, forces_of(*here.beyond, creepage));
  return found;
}

TableForces CreepTableReader::physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                       double friction_bound, const Scaled& creepage) const {
  refuse_other_kind(false);
  if (!positive(semi_axis_x) || !positive(semi_axis_y) || !positive(shear_modulus) ||
      !positive(friction_bound))
    throw contact::InputError(
        "table: semi-axes, shear modulus and mu F_n: allowed: positive numbers; do: check where "
        "they come from");
  const Nodes nodes = locate(semi_axis_x / semi_axis_y).near;
  const double c2 = semi_axis_x * semi_axis_y, c = std::sqrt(c2);
  return unscaled(nodes, shear_modulus * c2, c, friction_bound, creepage);
}

/// `stiffness`: G c^2.
TableForces CreepTableReader::unscaled(const Nodes& nodes, double stiffness, double c,
                                       double friction_bound, const Scaled& creepage) const {
  const Scaled scale = scale_of(nodes);
  const double s = stiffness / friction_bound;
  TableForces found = forces_of(nodes, {scale[0] * s * creepage[0], scale[1] * s * creepage[1],
                                        scale[2] * s * c * creepage[2]});
  found.forces = {friction_bound * found.forces[0], friction_bound * found.forces[1],
                  friction_bound * c * found.forces[2]};
  found.along_normal *= friction_bound;
  found.force_bar *= friction_bound;
  found.moment_bar *= friction_bound * c;
  return found;
}

void CreepTableReader::refuse_other_bound(double given, double own) const {
  constexpr double rounding = 1e-6;
  if (table_.only_for.empty() || std::abs(given - own) <= rounding * own) return;
  throw contact::InputError(
      fmt::format("table: mu F_n = {:g} N: the table holds for {}; allowed: its own {:g} N; do: "
                  "leave friction_bound out, or make another table",
                  given, table_.only_for, own));
}

TableForces CreepTableReader::of_wheel(double lateral_shift, double friction_bound,
                                       const Scaled& creepage) const {
  refuse_other_kind(true);
  if (!positive(friction_bound))
    throw contact::InputError(
        "table: mu F_n: allowed: a positive number; do: check where it comes from");
  const Place here = locate(lateral_shift);
  const auto side = [&](const Nodes& nodes) {
    const TableWheel wheel = wheel_of(nodes);
    refuse_other_bound(friction_bound, table_.friction_coefficient * wheel.normal_force);
    const double c2 = wheel.semi_axis_x * wheel.semi_axis_y;
    return unscaled(nodes, table_.shear_modulus * c2, std::sqrt(c2), friction_bound, creepage);
  };
  TableForces found = side(here.near);
  if (here.beyond) widen(found, side(*here.beyond));
  return found;
}

TableWheel CreepTableReader::wheel_of(const Nodes& nodes) const {
  TableWheel found;
  for (const WheelColumn& column : wheel_columns()) {
    double sum = 0.0;
    for (int r = 0; r < 4; ++r) {
      const double weight = nodes.weights.weight[static_cast<std::size_t>(r)];
      if (weight != 0.0)
        sum += weight *
               table_.wheels[static_cast<std::size_t>(nodes.weights.first + r)].*column.member;
    }
    found.*column.member = sum;
  }
  return found;
}

TableWheel CreepTableReader::wheel_at(double lateral_shift) const {
  refuse_other_kind(true);
  const Place here = locate(lateral_shift);
  TableWheel found = wheel_of(here.near);
  found.jump_after = here.beyond ? 1.0 : 0.0;
  return found;
}

}  // namespace rollfem::tables
