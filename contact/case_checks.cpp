#include "contact/case_checks.hpp"

#include "contact/case_text.hpp"
#include "contact/errors.hpp"
#include "contact/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Problem at a given value; the caller adds what is wrong.
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

void check_required(const GivenCase& given) {
  for (const Key& key : case_keys()) {
    if (!key.required || given.values.count(&key) > 0) continue;
    CaseProblem problem;
    problem.line = section_line(given, key.section);
    problem.column = problem.line > 0 ? 1 : 0;
    problem.key = key.path();
    problem.wrong = "is missing";
    problem.allowed = allowed_values(key);
    problem.action = fmt::format("add `{} = {}` under [{}]", key.name, key.example, key.section);
    fail(given.file, problem);
  }
}

void check_load(const GivenCase& given) {
  const GivenValue* force = given.find("load", "normal_force");
  const GivenValue* approach = given.find("load", "approach");
  if (force != nullptr && approach != nullptr) {
    CaseProblem problem = problem_at("load.approach", *approach);
    problem.wrong =
        fmt::format("contradicts load.normal_force = {} of line {}", force->text, force->line);
    problem.allowed = "exactly one of normal_force and approach";
    problem.action = "remove one of the two";
    fail(given.file, problem);
  }
  if (force == nullptr && approach == nullptr) {
    CaseProblem problem;
    problem.line = section_line(given, "load");
    problem.column = problem.line > 0 ? 1 : 0;
    problem.key = "load.normal_force";
    problem.wrong = "is missing, and load.approach too";
    problem.allowed = "exactly one of normal_force and approach";
    problem.action = "add `normal_force = 50e3` under [load]";
    fail(given.file, problem);
  }
}

void check_grid(const GivenCase& given) {
  const GivenValue* across = given.find("contact_grid", "elements_across");
  const GivenValue* size = given.find("contact_grid", "cell_size");
  if (across == nullptr || size == nullptr) return;
  CaseProblem problem = problem_at("contact_grid.cell_size", *size);
  problem.wrong = fmt::format("contradicts contact_grid.elements_across = {} of line {}",
                              across->text, across->line);
  problem.allowed = "at most one of elements_across and cell_size";
  problem.action = "remove one of the two";
  fail(given.file, problem);
}

void check_creepage_lengths(const GivenCase& given) {
  std::string first_name;
  const GivenValue* first = nullptr;
  for (const char* name : {"longitudinal_creepage", "lateral_creepage", "spin"}) {
    const GivenValue* value = given.find("rolling", name);
    if (value == nullptr) continue;
    const std::size_t length = std::get<std::vector<double>>(value->value).size();
    if (length == 1) continue;
    if (first == nullptr) {
      first = value;
      first_name = name;
      continue;
    }
    const std::size_t expected = std::get<std::vector<double>>(first->value).size();
    if (length == expected) continue;
    CaseProblem problem = problem_at(std::string("rolling.") + name, *value);
    problem.wrong = fmt::format("has {} entries, but rolling.{} of line {} has {}", length,
                                first_name, first->line, expected);
    problem.allowed = "lists of one common length, or a single number for all load points";
    problem.action = "make the lists equally long";
    fail(given.file, problem);
  }
}

void check_approach(const GivenCase& given, const Case& input) {
  const GivenValue* approach = given.find("load", "approach");
  if (approach == nullptr) return;
  const double smallest =
      std::min({input.wheel.rolling_radius, std::abs(input.wheel.transverse_radius),
                std::abs(input.rail.transverse_radius)});
  if (*input.load.approach < 0.1 * smallest) return;
  CaseProblem problem = problem_at("load.approach", *approach);
  problem.wrong = fmt::format("is not small against the smallest radius, {} mm", smallest);
  problem.allowed = fmt::format("less than {} mm, a tenth of it", 0.1 * smallest);
  problem.action = "give a smaller approach, or a force; linear elasticity covers no more";
  fail(given.file, problem);
}

}  // namespace

const GivenValue* GivenCase::find(const std::string& section, const std::string& name) const {
  const auto found = values.find(find_key(section, name));
  return found == values.end() ? nullptr : &found->second;
}

void fail(const std::string& file, const CaseProblem& problem) {
  std::string text = file;
  if (problem.line > 0) text += fmt::format(":{}:{}", problem.line, problem.column);
  text += ": ";
  if (!problem.key.empty()) text += problem.key;
  if (!problem.value.empty()) text += " = " + problem.value;
  if (!problem.key.empty()) text += ": ";
  text += problem.wrong;
  if (!problem.allowed.empty()) text += "; allowed: " + problem.allowed;
  if (!problem.action.empty()) text += "; do: " + problem.action;
  throw InputError(text);
}

void check_together(const GivenCase& given) {
  check_load(given);
  check_required(given);
  check_grid(given);
  check_creepage_lengths(given);
}

void check_geometry(const GivenCase& given, const Case& input) {
  check_approach(given, input);
  const double wheel = input.wheel.transverse_radius;
  const double rail = input.rail.transverse_radius;
  // Not only B > 0: radii that cancel to rounding would pass that and overflow later.
  const double scale = 1.0 / std::abs(wheel) + 1.0 / std::abs(rail);
  if (1.0 / wheel + 1.0 / rail > 1e-9 * scale) return;
  CaseProblem problem =
      problem_at("wheel.transverse_radius", *given.find("wheel", "transverse_radius"));
  if (std::isinf(wheel) && std::isinf(rail)) {
    problem.wrong = "flat on a flat rail has line contact, which has no end along y";
    problem.allowed = "a finite radius of the wheel or of the rail";
    problem.action = "give one of the two profiles a radius, also a very large one";
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
        "with rail.transverse_radius = {} leaves no convex body: they would touch at the edges",
        rail);
    problem.allowed = "at least one convex (positive) radius";
    problem.action = "check the signs: positive is convex for wheel and rail alike";
  }
  fail(given.file, problem);
}

}  // namespace rollfem::contact
