#include "contact/case/checks/case_checks.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_text.hpp"

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

/// The keys that can say how hard the bodies are pressed together: exactly one of them does.
void check_load(const GivenCase& given) {
  const bool pressure = given.find("given_pressure", "semi_axis_x") != nullptr ||
                        given.find("given_pressure", "semi_axis_y") != nullptr ||
                        given.find("given_pressure", "max_pressure") != nullptr;
  std::vector<const char*> sources{"load.normal_force", "load.approach"};
  if (pressure)
    sources = {"load.normal_force", "given_pressure.max_pressure"};
  else if (given.find("history", "normal_force") != nullptr ||
           given.find("history", "approach") != nullptr)
    sources = {"history.normal_force", "history.approach"};
  const bool plain = sources[0] == std::string("load.normal_force") && !pressure;
  const bool profiles = plain && has_profiles(given);
  if (profiles) sources.push_back("load.vertical_force");
  const char* one_of = profiles ? "exactly one of normal_force, approach and vertical_force"
                                : "exactly one of normal_force and approach";
  const GivenValue* first = nullptr;
  std::string first_path;
  for (const char* path :
       {"load.normal_force", "load.approach", "load.vertical_force", "given_pressure.max_pressure",
        "history.normal_force", "history.approach"}) {
    const std::string text = path;
    const GivenValue* value =
        given.find(text.substr(0, text.find('.')), text.substr(text.find('.') + 1));
    if (value == nullptr) continue;
    const bool possible = std::find(sources.begin(), sources.end(), text) != sources.end();
    if (possible && first == nullptr) {
      first = value;
      first_path = text;
      continue;
    }
    CaseProblem problem = problem_at(text, *value);
    problem.wrong = first != nullptr ? fmt::format("contradicts {} = {} of line {}", first_path,
                                                   first->text, first->line)
                                     : fmt::format("does not go together with [{}]",
                                                   pressure ? "given_pressure" : "history");
    problem.allowed =
        plain ? one_of : fmt::format("exactly one of {} and {}", sources[0], sources[1]);
    problem.action = "remove one of the two";
    fail(given.file, problem);
  }
  if (first != nullptr) return;
  CaseProblem problem;
  problem.line = section_line(given, "load");
  problem.column = problem.line > 0 ? 1 : 0;
  problem.key = "load.normal_force";
  problem.wrong = pressure ? "is missing, and given_pressure.max_pressure too"
                           : "is missing, and load.approach too";
  problem.allowed =
      pressure ? "exactly one of load.normal_force and given_pressure.max_pressure" : one_of;
  problem.action = profiles ? "add `vertical_force = 50e3` under [load]"
                            : "add `normal_force = 50e3` under [load]";
  fail(given.file, problem);
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

}  // namespace

const GivenValue* GivenCase::find(const std::string& section, const std::string& name) const {
  const auto found = values.find(find_key(section, name));
  return found == values.end() ? nullptr : &found->second;
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

namespace {

/// A given mesh is held where its group `fixed` says, which need not enclose it.
void check_far_boundary(const GivenCase& given) {
  const GivenValue* far = given.find("fem", "far_boundary");
  if (far == nullptr || std::get<std::string>(far->value) != "point_load") return;
  for (const char* body : {"wheel", "rail"}) {
    if (given.find(body, "mesh") == nullptr) continue;
    CaseProblem problem = problem_at("fem.far_boundary", *far);
    problem.wrong = fmt::format(
        "applies to segments meshed by the program, but [{}] mesh names a mesh of your own", body);
    problem.allowed = "\"clamped\"";
    problem.action = "leave fem.far_boundary out, or the mesh";
    fail(given.file, problem);
  }
}

}  // namespace

void check_entries(const GivenCase& given) {
  for (const GivenEntry& entry : given.entries)
    for (const Key& key : case_keys())
      if (key.section == entry.section && key.required && entry.values.count(&key) == 0)
        fail_missing(given, key, entry.line, "[[" + entry.section + "]]");
}

void check_together(const GivenCase& given) {
  check_line(given);
  check_profiles(given);
  check_track(given);
  check_load(given);
  check_required(given);
  check_grid(given);
  check_entries(given);
  for (const char* group : {"load points", "positions"}) check_list_lengths(given, group);
  check_far_boundary(given);
}

void check_geometry(const GivenCase& given, const Case& input) {
  check_approach(given, input);
  check_grid_of_line(given, input);
  if (replaces_radii(given) || has_profiles(given) || is_line(given)) return;
  const double wheel = input.wheel.transverse_radius;
  const double rail = input.rail.transverse_radius;
  // Not only B > 0: radii that cancel to rounding would pass that and overflow later.
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
