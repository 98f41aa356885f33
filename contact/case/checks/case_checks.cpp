// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/checks/case_checks.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/checks/case_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::contact {

CaseProblem problem_at(const std::string& path, const GivenValue& given) {
  CaseProblem problem;
  problem.line = given.line;
  problem.column = given.column;
  problem.key = path;
  problem.value = given.text;
  return problem;
}

unsigned section_line(const GivenCase& given, const std::string& section) {
  const auto found = given.section_lines.find(section);
  return found == given.section_lines.end() ? 0 : found->second;
}

namespace {

bool replaces_radii(const GivenCase& given) {
  for (const auto& [key, value] : given.values)
    if (key->section == "undeformed_distance" || key->section == "given_pressure") return true;
  return false;
}

[[noreturn]] void fail_missing(const GivenCase& given, const Key& key, unsigned section_line,
                               const std::string& section) {
  CaseProblem problem;
  problem.line = section_line;
  problem.column = section_line > 0 ? 1 : 0;
  problem.key = key.path();
  problem.wrong = "is missing";
  problem.allowed = allowed_values(key);
  problem.action = fmt::format("add `{} = {}` under {}", key.name, key.example, section);
  fail(given.file, problem);
}

void check_required(const GivenCase& given) {
  const bool radii_replaced = replaces_radii(given) || is_line(given);
  for (const Section& section : case_sections()) {
    if (section.repeated) continue;
    const bool is_body = section.name == "wheel" || section.name == "rail";
    if (radii_replaced && is_body) continue;
    for (const Key& key : section) {
      if (!key.required || given.values.count(&key) > 0) continue;
      if (key.name == "transverse_radius" && given.find(section.name, "profile") != nullptr)
        continue;
      fail_missing(given, key, section_line(given, section.name), "[" + section.name + "]");
    }
  }
}

void check_list_lengths(const GivenCase& given, const std::string& group) {
  std::string first_path;
  const GivenValue* first = nullptr;
  std::size_t expected = 0;
  for (const Key& key : case_keys()) {
    const auto found = given.values.find(&key);
    if (found == given.values.end()) continue;
    const GivenValue& value = found->second;
    const bool steps = key.path() == "history.steps";
    if (key.per != group) continue;
    const std::size_t length = steps ? static_cast<std::size_t>(std::get<double>(value.value))
                                     : std::get<std::vector<double>>(value.value).size();
    if (length == 1 && !steps) continue;
    if (first == nullptr) {
      first = &value;
      first_path = key.path();
      expected = length;
      continue;
    }
    if (length == expected) continue;
    CaseProblem problem = problem_at(key.path(), value);
    problem.wrong = fmt::format("has {} entries, but {} of line {} has {}", length, first_path,
                                first->line, expected);
    problem.allowed = "lists of one common length, or a single number for all " + group;
    problem.action = "make the lists equally long";
    fail(given.file, problem);
  }
}

void check_approach(const GivenCase& given, const Case& input) {
  const GivenValue* approach = given.find("load", "approach");
  if (approach == nullptr) return;
  if (replaces_radii(given)) return;
  const double smallest =
      std::min({input.wheel.rolling_radius, std::abs(input.wheel.transverse_radius),
                std::abs(input.rail.transverse_radius)});
  if (*input.load.approach < 0.1 * smallest) return;
  CaseProblem problem = problem_at("load.approach", *approach);
  problem.wrong = fmt::format("is not small against the smallest radius, {} mm", smallest);
  problem.allowed = fmt::format("less than {} mm, a tenth of it", 0.1 * smallest);
  problem.action = "give a smaller approach, or a force; linear elasticity does not cover more";
  fail(given.file, problem);
}

/// The contact grid of a line is one row of elements across its width.
void check_grid_of_line(const GivenCase& given, const Case& input) {
  if (input.geometry.shape != ContactShape::line) return;
  const double width = input.geometry.width;
  const auto check = [&](const char* name, double across, double expected) {
    const GivenValue* value = given.find("contact_grid", name);
    if (value == nullptr || std::abs(across - expected) <= 1e-9 * width) return;
    fail_at(
        given, std::string("contact_grid.") + name, *value,
        fmt::format("is not a single row of elements as wide as geometry.width, {:g} mm", width),
        fmt::format("{:g} mm across", expected),
        fmt::format("write {:g} as its second number", expected));
  };
  const GridOptions& grid = input.contact_grid;
  if (grid.cell_size) check("cell_size", (*grid.cell_size)[1], width);
  if (grid.extent) check("extent", (*grid.extent)[1], width);
  check("middle", grid.middle[1], 0.0);
}

}  // namespace

bool is_line(const GivenCase& given) {
  const GivenValue* shape = given.find("geometry", "shape");
  return shape != nullptr && std::get<std::string>(shape->value) == "line";
}

bool has_profiles(const GivenCase& given) {
  return given.find("wheel", "profile") != nullptr || given.find("rail", "profile") != nullptr;
}

const GivenValue* GivenCase::find(const std::string& section, const std::string& name) const {
  const auto found = values.find(find_key(section, name));
  return found == values.end() ? nullptr : &found->second;
}

std::string word_of(const GivenCase& given, const char* section, const char* name,
                    const char* otherwise) {
  const GivenValue* value = given.find(section, name);
  return value == nullptr ? otherwise : std::get<std::string>(value->value);
}

bool is_option(const std::string& file) {
  return file.rfind("--set ", 0) == 0;
}

void fail(const std::string& file, const CaseProblem& problem) {
  std::string text = file;
  if (is_option(file)) {
    text += ": ";
  } else {
    if (problem.line > 0) text += fmt::format(":{}:{}", problem.line, problem.column);
    text += ": ";
    if (!problem.key.empty()) text += problem.key;
    if (!problem.value.empty()) text += " = " + problem.value;
    if (!problem.key.empty()) text += ": ";
  }
  text += problem.wrong;
  if (!problem.allowed.empty()) text += "; allowed: " + problem.allowed;
  if (!problem.action.empty()) text += "; do: " + problem.action;
  throw InputError(text);
}

void fail_at(const GivenCase& given, const std::string& path, const GivenValue& value,
             const std::string& wrong, const std::string& allowed, const std::string& action) {
  CaseProblem problem = problem_at(path, value);
  problem.wrong = wrong;
  problem.allowed = allowed;
  problem.action = action;
  fail(given.file, problem);
}

void check_entries(const GivenCase& given) {
  for (const GivenEntry& entry : given.entries)
    for (const Key& key : case_keys())
      if (key.section == entry.section && key.required && entry.values.count(&key) == 0)
        fail_missing(given, key, entry.line, "[[" + entry.section + "]]");
}

void check_together(const GivenCase& given) {
  check_profiles(given);
  check_rules(given);
  check_required(given);
  check_entries(given);
  for (const char* group : {"load points", "positions", "friction points"})
    check_list_lengths(given, group);
}

void check_geometry(const GivenCase& given, const Case& input) {
  check_approach(given, input);
  check_grid_of_line(given, input);
  if (replaces_radii(given) || has_profiles(given) || is_line(given)) return;
  const double wheel = input.wheel.transverse_radius;
  const double rail = input.rail.transverse_radius;
  // B > 0 is not sufficient: radii that cancel to rounding would pass and overflow later.
  const double scale = 1.0 / std::abs(wheel) + 1.0 / std::abs(rail);
  if (1.0 / wheel + 1.0 / rail > 1e-9 * scale) return;
  CaseProblem problem =
      problem_at("wheel.transverse_radius", *given.find("wheel", "transverse_radius"));
  if (std::isinf(wheel) && std::isinf(rail)) {
    problem.wrong = "flat on a flat rail is an endless line contact";
    problem.allowed = "a finite radius of the wheel or of the rail";
    problem.action =
        "give one of the two profiles a radius, which may be very large, or write shape = \"line\" "
        "under [geometry]";
  } else if (wheel < 0.0 && rail > 0.0 && !std::isinf(rail)) {
    problem.wrong = fmt::format(
        "concave and not wider than the rail's {} mm: the bodies would not touch in the middle",
        rail);
    problem.allowed = fmt::format("a concave radius below {} mm (larger in magnitude)", -rail);
    problem.action = "flatten the wheel's profile or sharpen the rail's";
  } else if (rail < 0.0 && wheel > 0.0 && !std::isinf(wheel)) {
    problem.wrong = fmt::format(
        "convex and not sharper than the concave rail's {} mm: the bodies would not touch in the "
        "middle",
        rail);
    problem.allowed = fmt::format("a convex radius from 0 to below {} mm", -rail);
    problem.action = "sharpen the wheel's profile or flatten the rail's";
  } else {
    problem.wrong = fmt::format(
        "with rail.transverse_radius = {} leaves no convex body: the bodies would touch at their "
        "edges",
        rail);
    problem.allowed = "at least one convex (positive) radius";
    problem.action = "check the signs: positive is convex, for wheel and rail";
  }
  fail(given.file, problem);
}

}  // namespace rollfem::contact
