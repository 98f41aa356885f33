#include "app/table_grid.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/material.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/theories/linear_theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::app {

namespace {

constexpr std::size_t most_points = 20'000'000;

[[noreturn]] void refuse(const contact::Case& input, const std::string& key,
                         const std::string& wrong, const std::string& advice) {
  throw contact::InputError(fmt::format("{}: table.{}: {}; {}", input.file, key, wrong, advice));
}

void check_increasing(const contact::Case& input, const std::string& key,
                      const std::vector<double>& values) {
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(values[k] > values[k - 1]))
      refuse(input, key, fmt::format("{:g} follows {:g}", values[k], values[k - 1]),
             "allowed: values that increase; do: sort them");
}

std::vector<double> ratios_of(const contact::Case& input) {
  if (!input.table.axis_ratio.empty()) return input.table.axis_ratio;
  if (input.geometry.shape == contact::ContactShape::line || input.has_profiles())
    refuse(input, "axis_ratio", "is missing, and true profiles and lines have no ellipse",
           "allowed: ratios a/b from 0.02 to 50; do: add `axis_ratio = [0.2, 0.5, 1.0, 2.0, 5.0]` "
           "under [table]");
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(contact::Scene(input));
  const double ratio = hertz.semi_axis_x / hertz.semi_axis_y;
  if (!(ratio >= 0.02 && ratio <= 50.0))
    refuse(input, "axis_ratio", fmt::format("the ellipse of the case has a/b = {:g}", ratio),
           "allowed: 0.02 to 50; do: name the ratios under [table]");
  return {ratio};
}

/// 0 and what is listed, or the even steps of points and largest.
std::vector<double> axis_of(const contact::Case& input, std::size_t axis) {
  const contact::TableOptions& asked = input.table;
  const char* const names[] = {"longitudinal_values", "lateral_values", "spin_values"};
  const std::vector<double>* const lists[] = {&asked.longitudinal, &asked.lateral, &asked.spin};
  const std::vector<double>& list = *lists[axis];
  if (list.empty())
    return axis == 2 ? postprocess::spins_to(asked.largest[2], asked.points[2])
                     : postprocess::creepages_to(asked.largest[axis], asked.points[axis]);
  check_increasing(input, names[axis], list);
  if (list.back() <= 0.0 || (axis < 2 && (list.front() != 0.0 || list.size() < 2)))
    refuse(input, names[axis], "holds too little",
           "allowed: 0 and larger values; do: begin with 0.0");
  if (axis < 2) return list;
  std::vector<double> both;
  for (auto value = list.rbegin(); value != list.rend(); ++value)
    if (*value > 0.0) both.push_back(-*value);
  both.insert(both.end(), list.begin(), list.end());
  return both;
}

}  // namespace

postprocess::CreepTable empty_table(const contact::Case& input) {
  const contact::CombinedMaterial material =
      contact::combine(input.wheel.material, input.rail.material);
  if (material.couples())
    throw contact::InputError(fmt::format(
        "{}: wheel and rail are of unlike materials: their pressure depends on creepage, and no "
        "table holds that; allowed: like materials; do: give both one Young's modulus and "
        "Poisson's ratio, or take rollfem run",
        input.file));
  postprocess::CreepTable table;
  table.title = input.title;
  table.case_file = input.file;
  table.case_text = input.text;
  table.poisson_ratio = material.poisson_ratio;
  check_increasing(input, "axis_ratio", input.table.axis_ratio);
  table.axis_ratio = ratios_of(input);
  for (std::size_t axis = 0; axis < 3; ++axis) table.creepage[axis] = axis_of(input, axis);
  if (table.size() > most_points)
    refuse(input, "points", fmt::format("makes {} points", table.size()),
           fmt::format("allowed: {}; do: take fewer", most_points));
  for (const double ratio : table.axis_ratio) {
    const auto c = halfspace::kalker_coefficients(std::sqrt(ratio), 1.0 / std::sqrt(ratio),
                                                  table.poisson_ratio);
    table.scale.push_back({c.c11 / 3.0, c.c22 / 3.0, std::hypot(c.c23, c.c33)});
  }
  return table;
}

}  // namespace rollfem::app
