// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/files/table_reader.hpp"

#include "base/errors.hpp"

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

constexpr double let_pass = 1e-3;        // of ratio, load and speed, relative
constexpr double shift_let_pass = 1e-9;  // mm

/// Weights along the creepage axes, for forces smooth at 0 and for forces bent at 0.
using CreepageWeights = std::array<std::array<AxisWeights, 2>, 3>;

/// Behaviour of F_x, F_y, M_z and the force along the normal at 0 of xi', eta' and phi': a force is
/// bent at 0 along the creepage that causes it.
constexpr AtZero at_zero[5][3] = {{AtZero::bent, AtZero::smooth, AtZero::smooth},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::bent, AtZero::bent, AtZero::bent}};
constexpr std::size_t along_normal = 3, rise = 4;

/// The scale of rises to interpolate, which in full sliding are in proportion to the creepages.
double with_size(const Scaled& creepage) {
  return 1.0 + std::hypot(creepage[0], creepage[1], creepage[2]);
}

double value_of(const CreepTable& table, std::size_t point, std::size_t q) {
  if (q == rise) {
    const auto& [xi, eta, phi] = table.creepage;
    const std::size_t row = point / phi.size();
    return table.rise[point] / with_size({xi[row / eta.size() % xi.size()], eta[row % eta.size()],
                                          phi[point % phi.size()]});
  }
  return q == along_normal ? table.along_normal[point] : table.forces[point][q];
}

/// Weighted sum of force q over the nodes; `layer`: the first one of a load and speed. Over ratios,
/// node -1 of xi' is node 1 at -xi', where F_x changes sign; node -1 of eta' is the mirror image of
/// node 1, where phi', F_y and M_z change sign. Only forces that keep their sign are smooth there.
double sum_of(const CreepTable& table, std::size_t layer, const AxisWeights& first,
              const CreepageWeights& creepage, std::size_t q) {
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
              layer + static_cast<std::size_t>(first.first + static_cast<int>(r)),
              static_cast<std::size_t>(std::abs(m)), static_cast<std::size_t>(std::abs(n)),
              static_cast<std::size_t>(n < 0 ? spins - 1 - spin : spin));
          sum += w * z.weight[k] * value_of(table, point, q);
        }
      }
  return sum;
}

/// Raises bars to those at the nodes around a place.
void raise_bars(std::array<double, 2>& largest, const CreepTable& table, std::size_t layer,
                const std::array<std::size_t, 2>& first, const CreepageWeights& creepage) {
  for (const std::size_t r : first)
    for (const std::size_t i : around(creepage[0][0], table.creepage[0].size()))
      for (const std::size_t j : around(creepage[1][0], table.creepage[1].size()))
        for (const std::size_t k : around(creepage[2][0], table.creepage[2].size()))
          for (std::size_t q = 0; q < 2; ++q)
            largest[q] = std::max(largest[q], table.bars[table.place(layer + r, i, j, k)][q]);
}

/// Widens the bars by the full difference across a jump.
void widen(TableForces& near, const TableForces& beyond) {
  near.force_bar += std::hypot(near.forces[0] - beyond.forces[0], near.forces[1] - beyond.forces[1],
                               near.along_normal - beyond.along_normal);
  near.moment_bar += std::abs(near.forces[2] - beyond.forces[2]);
}

}  // namespace

CreepTableReader::CreepTableReader(CreepTable table) : table_(std::move(table)) {
  if (!increasing(table_.first_axis())) refuse_shape("its first axis does not increase");
  check_creepages();
  for (std::size_t q = 0; q < 3; ++q)
    for (const double x : table_.creepage[q]) coordinate_[q].push_back(table_coordinate(x));
  const bool shifts = table_.over_shifts();
  if (!shifts && table_.axis_ratio.front() <= 0.0) refuse_shape("its ratios are not positive");
  check_conditions();
  if (table_.forces.size() != table_.size() || table_.bars.size() != table_.size() ||
      !(table_.rise.empty() ? !table_.heat : table_.rise.size() == table_.size()) ||
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
  const double speed = table_.heat && table_.speed.empty() ? 0.0 : place.speed;
  near.speed = on_axis(speed_, condition("speed", "mm/s", table_.speed, speed)).near.weights;
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
  const double heating = table_.heat && table_.heat->sets_friction != 0.0
                             ? std::pow(pressure, 4) * size / std::pow(root, 5)
                             : pressure / root;
  return {ratio, first * root * root * root, speed * heating};
}

void CreepTableReader::refuse_other_kind(bool wanted_shifts) const {
  if (table_.over_shifts() == wanted_shifts) return;
  throw contact::InputError(
      wanted_shifts ? "table: a lateral shift was given, but this table is over axis ratios; "
                      "do: give the semi-axes, or make a table with [table] lateral_shift"
                    : "table: an ellipse was given, but this table is over lateral shifts; do: "
                      "give lateral_shift, or make a table with [table] axis_ratio");
}

Scaled CreepTableReader::scale_of(const Side& side) const {
  Scaled logarithm{};
  each_node(side.load, [&](std::size_t load, double of_load, std::size_t slot) {
    each_node(side.first[slot].weights, [&](std::size_t first, double weight, std::size_t) {
      const Scaled& factor = table_.scale[table_.pressed(load, first)];
      for (std::size_t q = 0; q < 3; ++q) logarithm[q] += of_load * weight * std::log(factor[q]);
    });
  });
  return {std::exp(logarithm[0]), std::exp(logarithm[1]), std::exp(logarithm[2])};
}

Scaled CreepTableReader::scale_at(const TablePlace& place) const {
  return scale_of(locate(at_any_speed(place)).near);
}

TableForces CreepTableReader::forces_of(const Side& side, const Scaled& creepage) const {
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
  TableForces found;
  std::array<double, 2> bars{};
  double risen = 0.0;
  each_node(side.load, [&](std::size_t load, double of_load, std::size_t slot) {
    const Nodes& first = side.first[slot];
    each_node(side.speed, [&](std::size_t speed, double of_speed, std::size_t) {
      const std::size_t layer = (load * table_.speeds() + speed) * table_.first_axis().size();
      const auto sum = [&](std::size_t q) {
        return of_load * of_speed * sum_of(table_, layer, first.weights, weights, q);
      };
      found.forces[0] += along * sum(0);
      found.forces[1] += across * sum(1);
      found.forces[2] += across * sum(2);
      if (!mirrored) found.along_normal += sum(along_normal);
      if (table_.heat) risen += sum(rise);
      raise_bars(bars, table_, layer, first.around, weights);
    });
  });
  const double size = std::hypot(found.forces[0], found.forces[1]);
  if (table_.heat) {
    const Scaled within{shrunk * creepage[0], shrunk * creepage[1], shrunk * creepage[2]};
    found.rise = std::max(0.0, risen * with_size(within) / shrunk);
  }
  const bool may_rise = table_.heat && table_.heat->sets_friction != 0.0;
  if (mirrored && !may_rise && size > 1.0)
    for (std::size_t q = 0; q < 2; ++q) found.forces[q] /= size;
  found.force_bar = bars[0] + table_.interpolation.force_95;
  found.moment_bar = bars[1] + table_.interpolation.moment_95;
  return found;
}

TableForces CreepTableReader::at(const TablePlace& place, const Scaled& creepage) const {
  const Place here = locate(place);
  TableForces found = forces_of(here.near, creepage);
  if (here.beyond) widen(found, forces_of(*here.beyond, creepage));
  return found;
}

TableForces CreepTableReader::physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                       double friction_bound, const Scaled& creepage,
                                       double speed) const {
  refuse_other_kind(false);
  if (!is_positive(semi_axis_x) || !is_positive(semi_axis_y) || !is_positive(shear_modulus) ||
      !is_positive(friction_bound))
    throw contact::InputError(
        "table: semi-axes, shear modulus and mu F_n: allowed: positive numbers; do: check where "
        "they come from");
  const double c = std::sqrt(semi_axis_x * semi_axis_y);
  const TablePlace place =
      place_of(semi_axis_x / semi_axis_y, c, shear_modulus, friction_bound, speed);
  return unscaled(locate(place).near, shear_modulus, c, friction_bound, creepage, speed);
}

TableForces CreepTableReader::unscaled(const Side& side, double shear_modulus, double c,
                                       double friction_bound, const Scaled& creepage,
                                       double speed) const {
  const double stiffness = shear_modulus * c * c;
  const Scaled scale = scale_of(side);
  const double s = stiffness / friction_bound;
  TableForces found = forces_of(side, {scale[0] * s * creepage[0], scale[1] * s * creepage[1],
                                       scale[2] * s * c * creepage[2]});
  found.forces = {friction_bound * found.forces[0], friction_bound * found.forces[1],
                  friction_bound * c * found.forces[2]};
  found.along_normal *= friction_bound;
  found.force_bar *= friction_bound;
  found.moment_bar *= friction_bound * c;
  if (!table_.heat) return found;
  const TableHeat& heat = *table_.heat;
  const double asked = speed > 0.0 ? speed : heat.speed;
  const bool same = std::abs(shear_modulus / heat.shear_modulus - 1.0) <= let_pass;
  found.rise *= same ? friction_bound * friction_bound * std::sqrt(asked) /
                           (stiffness * heat.effusivity * std::pow(c, 1.5))
                     : std::numeric_limits<double>::quiet_NaN();
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

TableForces CreepTableReader::of_wheel(const TablePlace& place, double friction_bound,
                                       const Scaled& creepage) const {
  refuse_other_kind(true);
  if (!is_positive(friction_bound))
    throw contact::InputError(
        "table: mu F_n: allowed: a positive number; do: check where it comes from");
  const Place here = locate(place);
  const auto on = [&](const Side& side) {
    const TableWheel wheel = wheel_of(side);
    const double own = table_.friction_coefficient * wheel.normal_force;
    if (&side == &here.near) refuse_other_bound(friction_bound, own);
    // A table for one bound only has another one beyond a jump.
    const double bound = table_.only_for.empty() ? friction_bound : own;
    return unscaled(side, table_.shear_modulus, std::sqrt(wheel.semi_axis_x * wheel.semi_axis_y),
                    bound, creepage, place.speed);
  };
  TableForces found = on(here.near);
  if (here.beyond) widen(found, on(*here.beyond));
  return found;
}

TableWheel CreepTableReader::wheel_of(const Side& side) const {
  TableWheel found;
  for (const WheelColumn& column : wheel_columns()) {
    const bool logarithm = column.power && table_.load.size() > 1;
    double sum = 0.0;
    each_node(side.load, [&](std::size_t load, double of_load, std::size_t slot) {
      double at_load = 0.0;
      each_node(side.first[slot].weights, [&](std::size_t first, double weight, std::size_t) {
        at_load += weight * table_.wheels[table_.pressed(load, first)].*column.member;
      });
      sum += of_load * (logarithm ? std::log(at_load) : at_load);
    });
    found.*column.member = logarithm ? std::exp(sum) : sum;
  }
  return found;
}

TableWheel CreepTableReader::wheel_at(const TablePlace& place) const {
  refuse_other_kind(true);
  const Place here = locate(at_any_speed(place));
  TableWheel found = wheel_of(here.near);
  found.jump_after = here.beyond ? 1.0 : 0.0;
  return found;
}

}  // namespace rollfem::tables
