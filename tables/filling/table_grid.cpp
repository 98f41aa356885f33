// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tables/filling/table_grid.hpp"

#include "base/errors.hpp"
#include "base/material.hpp"
#include "base/pi.hpp"
#include "case/keys/case_keys.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/kalker.hpp"
#include "scene/surface_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rollfem::tables {

namespace {

constexpr std::size_t most_table_points = 20'000'000;

[[noreturn]] void refuse(const contact::Case& input, const std::string& key,
                         const std::string& wrong, const std::string& advice) {
  throw contact::InputError(fmt::format("{}: table.{}: {}; {}", input.file, key, wrong, advice));
}

std::vector<double> ratios_of(const contact::Case& input) {
  if (!input.table.axis_ratio.empty()) return input.table.axis_ratio;
  const char* const ratios =
      "add `axis_ratio = [0.2, 0.5, 1.0, 2.0, 5.0]` under [table], for ellipses of any kind";
  if (input.has_profiles())
    refuse(input, "axis_ratio", "is missing, and true profiles have no ellipse",
           std::string("allowed: this or table.lateral_shift; do: add `lateral_shift = [-4.0, "
                       "-2.0, 0.0, 2.0, 4.0]` under [table] for this wheel on its rail, or ") +
               ratios);
  if (input.geometry.shape == contact::ContactShape::line)
    refuse(input, "axis_ratio", "is missing, and lines have no ellipse",
           std::string("allowed: ratios a/b from 0.02 to 50; do: ") + ratios);
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(contact::Scene(input));
  const double ratio = hertz.semi_axis_x / hertz.semi_axis_y;
  if (!(ratio >= 0.02 && ratio <= 50.0))
    refuse(input, "axis_ratio", fmt::format("the ellipse of the case has a/b = {:g}", ratio),
           "allowed: 0.02 to 50; do: name the ratios under [table]");
  return {ratio};
}

constexpr std::array<int, 3> points_over_ratios{16, 16, 31}, points_over_shifts{8, 8, 15};

/// Extends a list of values >= 0 by their negatives in front.
std::vector<double> both_signs(const std::vector<double>& list) {
  std::vector<double> both;
  for (auto value = list.rbegin(); value != list.rend(); ++value)
    if (*value > 0.0) both.push_back(-*value);
  both.insert(both.end(), list.begin(), list.end());
  return both;
}

/// An axis of creepage: 0 and the listed values, or even steps from points and largest. Spin has
/// both signs; over shifts all axes have.
std::vector<double> axis_of(const contact::Case& input, std::size_t axis) {
  const contact::TableOptions& asked = input.table;
  const bool shifts = !asked.lateral_shift.empty();
  const auto points = asked.points.value_or(shifts ? points_over_shifts : points_over_ratios);
  const char* const names[] = {"longitudinal_values", "lateral_values", "spin_values"};
  const std::vector<double>* const lists[] = {&asked.longitudinal, &asked.lateral, &asked.spin};
  const std::vector<double>& list = *lists[axis];
  if (list.empty())
    return axis == 2 ? spins_to(asked.largest[2], points[2])
           : shifts  ? spins_to(asked.largest[axis], 2 * points[axis] - 1)
                     : creepages_to(asked.largest[axis], points[axis]);
  if (list.back() <= 0.0 || (axis < 2 && (list.front() != 0.0 || list.size() < 2)))
    refuse(input, names[axis], "has no positive value, or does not begin with 0",
           "allowed: 0 and larger values; do: begin with 0.0");
  return axis < 2 && !shifts ? list : both_signs(list);
}

constexpr std::size_t most_shifts = 10'000;

std::vector<double> shifts_of(const contact::Case& input) {
  const std::vector<double>& asked = input.table.lateral_shift;
  if (!input.table.lateral_shift_step) return asked;
  const double step = *input.table.lateral_shift_step;
  if (asked.size() != 2)
    refuse(input, "lateral_shift_step", fmt::format("lateral_shift has {} values", asked.size()),
           "allowed: two values with lateral_shift_step; do: give the first and the last shift, or "
           "no step");
  const double steps = (asked[1] - asked[0]) / step;
  const double whole = std::round(steps);
  if (std::abs(steps - whole) > 1e-6 || whole < 1.0 || whole > most_shifts)
    refuse(
        input, "lateral_shift_step",
        fmt::format("{:g} mm from {:g} to {:g} gives {:g} steps", step, asked[0], asked[1], steps),
        fmt::format("allowed: a whole number up to {}; do: change one of them", most_shifts));
  std::vector<double> shifts;
  for (double k = 0.0; k <= whole; k += 1.0)
    shifts.push_back(asked[0] + k * (asked[1] - asked[0]) / whole);
  return shifts;
}

/// Throws for cases without a table over lateral shifts.
void check_wheel(const contact::Case& input) {
  const auto refuse_key = [&](const std::string& what) {
    throw contact::InputError(fmt::format("{}: {}", input.file, what));
  };
  if (!input.table.axis_ratio.empty())
    refuse(input, "axis_ratio", "a table is either over axis ratios or over lateral shifts",
           "allowed: one of axis_ratio and lateral_shift; do: remove the other");
  if (!input.has_profiles())
    refuse(
        input, "lateral_shift", "wheel and rail are given by radii, without a track",
        "allowed: cases with profiles; do: give wheel.profile, rail.profile and [wheelset], as in "
        "cases/manchester_A22.toml");
  if (input.wheelset.side == contact::WheelSide::both)
    refuse_key(
        "wheelset.side = \"both\": a table holds one wheel; allowed: \"left\" or "
        "\"right\"; do: make a table for each");
  if (input.wheelset.positions() > 1 || input.wheelset.yaw.size() > 1 ||
      input.wheelset.roll.size() > 1)
    refuse_key(
        "wheelset.lateral_shift, wheelset.yaw or wheelset.roll: is a list; allowed: one value "
        "with table.lateral_shift; do: give shifts under [table] alone, make a table for each yaw "
        "and roll");
  if (input.rolling.problem != contact::Problem::steady)
    refuse_key("rolling.problem: a table holds steady rolling; allowed: \"steady\"; do: remove it");
}

bool falls(const contact::Case& input) {
  return input.friction_fall.shape != contact::FallShape::none;
}

/// CreepTable::only_for.
std::string only_for(const contact::Case& input, const std::vector<double>& speeds) {
  if (!falls(input) && !input.layer) return {};
  std::string text = fmt::format("a coefficient of friction of {:g}", input.friction_coefficient);
  const char* const law =
      input.friction_fall.shape.by_temperature ? "friction by temperature" : "falling friction";
  if (falls(input))
    text = speeds.size() == 1 ? fmt::format("{} at a speed of {:g} mm/s", law, speeds.front())
                              : fmt::format("{} at speeds of {:g} to {:g} mm/s", law,
                                            speeds.front(), speeds.back());
  if (!input.layer) return text;
  text += " and a layer";
  if (input.layer->thickness)
    text += fmt::format(" of {:g} mm and {:g} MPa", *input.layer->thickness,
                        input.layer->shear_modulus.value_or(0.0));
  if (input.layer->yield_stress)
    text += fmt::format(" that yields at {:g} MPa", *input.layer->yield_stress);
  return text;
}

LoadSets load_sets(const contact::Case& input) {
  const contact::Layer layer = input.layer.value_or(contact::Layer{});
  std::vector<LoadSets> found;
  if (layer.thickness || layer.hardening.value_or(0.0) != 0.0) found.push_back(LoadSets::size);
  if (layer.yield_stress) found.push_back(LoadSets::pressure);
  if (falls(input) && input.friction_fall.memory_distance > 0.0)
    found.push_back(input.friction_fall.shape.by_temperature ? LoadSets::all
                                                             : LoadSets::sliding_distance);
  if (found.empty()) return LoadSets::nothing;
  return found.size() == 1 ? found.front() : LoadSets::all;
}

/// Loads and speeds: those listed, and one of each where friction depends on it.
void set_conditions(const contact::Case& input, CreepTable& table) {
  const bool ellipses = !table.over_shifts();
  table.load_sets = ellipses ? load_sets(input) : LoadSets::nothing;
  if (!input.table.load.empty() && ellipses && table.load_sets == LoadSets::nothing)
    refuse(input, "load", "forces of ellipses over mu F_n do not depend on the load",
           falls(input) ? "but on the speed and the pressure; do: list table.speed instead"
                        : "under this friction; do: remove it");
  if (!input.table.load.empty() && input.load.approach)
    refuse(input, "load", "the case gives an approach",
           "allowed: with normal_force or vertical_force; do: give one of them under [load]");
  if (!input.table.speed.empty() && !falls(input))
    refuse(input, "speed", "forces do not depend on the speed",
           "allowed: with a friction.law that falls; do: remove it");
  table.load = input.table.load;
  table.speed = input.table.speed;
  if (table.speed.empty() && falls(input)) table.speed = {input.rolling.speed};
  table.only_for = only_for(input, table.speed);
  if (table.only_for.empty()) return;
  const auto& given =
      input.load.vertical_force ? input.load.vertical_force : input.load.normal_force;
  if (!ellipses && table.load.empty() && given) table.load = {*given};
}

/// Load and size of ellipses whose friction depends on them: of any a/b between bodies that have
/// the curvature of the case along rolling.
void set_sizes(const contact::Case& input, const contact::CombinedMaterial& material,
               CreepTable& table) {
  if (input.has_profiles() || input.geometry.shape == contact::ContactShape::line)
    throw contact::InputError(fmt::format(
        "{}: friction of ellipses then depends on the size of the patch; allowed: bodies that "
        "touch in an ellipse, or table.lateral_shift; do: give radii, or make a table of the wheel",
        input.file));
  const contact::Scene scene(input);
  const halfspace::HertzContact own = halfspace::hertz_of_scene(scene);
  const double along = halfspace::curvatures_of_scene(scene).A;
  if (table.load.empty()) table.load = {own.normal_force};
  for (const double ratio : table.axis_ratio) {
    // The curvature of an ellipse grows as the force over the third power of its size.
    halfspace::HertzContact trial = own;
    trial.semi_axis_x = std::sqrt(ratio);
    trial.semi_axis_y = 1.0 / trial.semi_axis_x;
    trial.max_pressure = 1.5 * table.load.front() / contact::pi;
    table.mean_axis.push_back(
        std::cbrt(halfspace::hertz_curvatures(trial, material.contact_modulus).A / along));
  }
}

}  // namespace

std::string ignored_keys(const contact::Case& input) {
  std::string ignored;
  for (const auto& [section, name] : {std::pair("wheelset", "lateral_shift"),
                                      {"wheelset", "free_rolling"},
                                      {"wheelset", "rotation_change"},
                                      {"wheelset", "lateral_velocity"},
                                      {"wheelset", "yaw_velocity"},
                                      {"rolling", "longitudinal_creepage"},
                                      {"rolling", "lateral_creepage"},
                                      {"rolling", "spin"},
                                      {"rolling", "longitudinal_force"},
                                      {"rolling", "lateral_force"}}) {
    const contact::Key& key = *contact::find_key(section, name);
    if (key.get(input) != key.get(contact::Case()))
      ignored += (ignored.empty() ? "" : ", ") + key.path();
  }
  if (ignored.empty()) return "";
  return fmt::format("{}: a table has positions and creepages of its own and does not use {}",
                     input.file, ignored);
}

CreepTable empty_table(const contact::Case& input) {
  if (input.yields())
    throw contact::InputError(fmt::format(
        "{}: [wheel_plasticity] and [rail_plasticity]: a table holds contacts of elastic bodies; "
        "allowed: without them; do: remove the section, or use rollfem run",
        input.file));
  const contact::CombinedMaterial material =
      contact::combine(input.wheel.material, input.rail.material);
  if (material.couples())
    throw contact::InputError(
        fmt::format("{}: wheel and rail are of unlike materials: their pressure depends on "
                    "creepage, which a table cannot hold; allowed: like materials; do: give both "
                    "the same Young's modulus and Poisson's ratio, or use rollfem run",
                    input.file));
  if (!input.friction_variation.points.empty())
    throw contact::InputError(fmt::format(
        "{}: friction.coefficient: has several values, which a table does not hold; allowed: one "
        "number; do: give one, without the places of several, or use rollfem run",
        input.file));
  if (!(input.friction_coefficient > 0.0))
    throw contact::InputError(
        fmt::format("{}: friction.coefficient = 0: without friction there is no creep force; "
                    "allowed: above 0; do: give one",
                    input.file));
  CreepTable table;
  table.title = input.title;
  table.case_file = input.file;
  table.case_text = input.text;
  table.poisson_ratio = material.poisson_ratio;
  if (!input.table.lateral_shift.empty()) {
    check_wheel(input);
    table.lateral_shift = shifts_of(input);
  } else {
    if (input.table.lateral_shift_step)
      refuse(input, "lateral_shift_step", "lateral_shift is missing",
             "allowed: together with lateral_shift; do: give lateral_shift = [first, last]");
    table.axis_ratio = ratios_of(input);
  }
  if (const auto heat = contact::surface_heat(input))
    table.heat = {heat->effusivity(), heat->contact_temperature(), heat->speed,
                  material.shear_modulus, input.friction_fall.shape.by_temperature ? 1.0 : 0.0};
  set_conditions(input, table);
  if (table.over_shifts() || !table.only_for.empty()) {
    table.shear_modulus = material.shear_modulus;
    table.friction_coefficient = input.friction_coefficient;
  }
  if (!table.over_shifts() && !table.only_for.empty()) set_sizes(input, material, table);
  for (std::size_t axis = 0; axis < 3; ++axis) table.creepage[axis] = axis_of(input, axis);
  if (table.size() > most_table_points)
    refuse(input, "points", fmt::format("makes {} points", table.size()),
           fmt::format("allowed: {}; do: take fewer", most_table_points));
  for (const double ratio : table.axis_ratio)
    table.scale.push_back(scale_of_ratio(ratio, table.poisson_ratio));
  return table;
}

Scaled scale_of_ratio(double axis_ratio, double poisson_ratio) {
  const auto c = halfspace::kalker_coefficients(std::sqrt(axis_ratio), 1.0 / std::sqrt(axis_ratio),
                                                poisson_ratio);
  return {c.c11 / 3.0, c.c22 / 3.0, std::hypot(c.c23, c.c33)};
}

}  // namespace rollfem::tables
