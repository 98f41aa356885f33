// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/checks/case_checks.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_text.hpp"
#include "contact/case/checks/case_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rollfem::contact {

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

[[noreturn]] void fail_missing(const GivenCase& given, const Key& key, unsigned line,
                               const std::string& section) {
  fail_missing(given, key.path(), line, "is missing", allowed_values(key),
               fmt::format("add `{} = {}` under {}", key.name, key.example, section));
}

void check_required(const GivenCase& given) {
  const bool radii_replaced = replaces_radii(given) || when::line(given);
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

std::size_t length_of(const KeyValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value);
  return list != nullptr ? list->size() : static_cast<std::size_t>(std::get<double>(value));
}

/// Lists with the same `per` are as long as the one that counts them, otherwise as the first; a
/// single number is that of all.
void check_list_lengths(const GivenCase& given) {
  std::map<std::string, std::pair<const Key*, const GivenValue*>> first;
  for (const bool counting : {true, false})
    for (const auto& [key, value] : given.values) {
      if (key->per.empty() || key->counts != counting) continue;
      const std::size_t length = length_of(value.value);
      if (!counting && length == 1) continue;
      const auto& [model, expected] = first.try_emplace(key->per, key, &value).first->second;
      if (length == length_of(expected->value)) continue;
      fail_at(given, key->path(), value,
              fmt::format("has {} entries, but {} of line {} has {}", length, model->path(),
                          expected->line, length_of(expected->value)),
              "lists of one common length, or a single number for all " + key->per,
              "make the lists equally long");
    }
}

void check_order(const GivenCase& given) {
  for (const auto& [key, value] : given.values) {
    if (!key->ascending) continue;
    const auto& list = std::get<std::vector<double>>(value.value);
    const auto fall = std::adjacent_find(list.begin(), list.end(), std::greater_equal<>());
    if (fall != list.end())
      fail_at(given, key->path(), value,
              fmt::format("does not ascend: {:g} follows {:g}", fall[1], fall[0]),
              "numbers in ascending order, each once",
              "sort them, and the lists that belong to them alike");
  }
}

void check_approach(const GivenCase& given, const Case& input) {
  const GivenValue* approach = given.find("load", "approach");
  if (approach == nullptr) return;
  if (replaces_radii(given)) return;
  const double along = input.geometry.relative_radius.value_or(
      std::min(input.wheel.rolling_radius, std::abs(input.rail.rolling_radius)));
  const double smallest = when::line(given)
                              ? along
                              : std::min({along, std::abs(input.wheel.transverse_radius),
                                          std::abs(input.rail.transverse_radius)});
  if (*input.load.approach < 0.1 * smallest) return;
  fail_at(given, "load.approach", *approach,
          fmt::format("is not small against the smallest radius, {} mm", smallest),
          fmt::format("less than {} mm, a tenth of it", 0.1 * smallest),
          "give a smaller approach, or a force; linear elasticity does not cover more");
}

/// A ring holds its wheel.
void check_ring(const GivenCase& given, const Case& input) {
  const GivenValue* ring = given.find("rail", "rolling_radius");
  const double radius = -input.rail.rolling_radius;
  if (ring == nullptr || radius < 0.0 || radius > input.wheel.rolling_radius) return;
  fail_at(given, "rail.rolling_radius", *ring,
          fmt::format("is a ring that is not larger than the wheel in it, {} mm",
                      input.wheel.rolling_radius),
          "a larger magnitude below 0, or a positive radius (a roller below the wheel)",
          "check the sign");
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

/// Keys used by only one kind of profile.
bool is_read(const std::string& key, const std::string& profile, std::string& by) {
  const auto among = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  const bool arcs = profile == "arcs";
  const bool polynomial = profile == "polynomial";
  if (among({"radii", "ends", "symmetric", "slope"})) {
    by = "profile = \"arcs\"";
    return arcs;
  }
  if (among({"coefficients", "limits"})) {
    by = "profile = \"polynomial\"";
    return polynomial;
  }
  if (among({"mirror", "rotation", "shift", "free_ends"})) return true;
  by = "profiles from files";
  // Names of built-in profiles have no extension; a file without extension is given as "./name".
  return !arcs && !polynomial && profile.find_first_of("./") != std::string::npos;
}

/// One shape for each body, and only keys used by its kind of profile.
void check_profile(const GivenCase& given, const std::string& body) {
  const GivenValue* profile = given.find(body, "profile");
  const std::string section = body + "_profile";
  for (const auto& [key, value] : given.values) {
    if (key->section != section) continue;
    if (profile == nullptr)
      fail_at(given, key->path(), value,
              fmt::format("is not used, because {}.profile is missing", body),
              fmt::format("[{}] together with [{}] profile", section, body),
              fmt::format("add `profile = \"FILE\"` under [{}], or remove [{}]", body, section));
    std::string by;
    if (!is_read(key->name, std::get<std::string>(profile->value), by))
      fail_at(given, key->path(), value,
              fmt::format("is not used with {}.profile = {}", body, profile->text), by,
              "remove it, or name another profile");
  }
  if (profile != nullptr && std::get<std::string>(profile->value).empty())
    fail_at(given, body + ".profile", *profile, "is empty",
            "a built-in profile, arcs, polynomial or a file", "name one");
}

}  // namespace

const GivenValue* GivenCase::find(const std::string& section, const std::string& name) const {
  const auto found = values.find(find_key(section, name));
  return found == values.end() ? nullptr : &found->second;
}

std::string word_of(const GivenCase& given, const char* section, const char* name) {
  const GivenValue* value = given.find(section, name);
  return std::get<std::string>(value == nullptr ? find_key(section, name)->get(default_case())
                                                : value->value);
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
  fail(given.file, {value.line, value.column, path, value.text, wrong, allowed, action});
}

void fail_missing(const GivenCase& given, const std::string& path, unsigned line,
                  const std::string& wrong, const std::string& allowed, const std::string& action) {
  fail(given.file, {line, line > 0 ? 1U : 0U, path, "", wrong, allowed, action});
}

void check_entries(const GivenCase& given) {
  for (const GivenEntry& entry : given.entries)
    for (const Key& key : case_keys())
      if (key.section == entry.section && key.required && entry.values.count(&key) == 0)
        fail_missing(given, key, entry.line, "[[" + entry.section + "]]");
}

void check_together(const GivenCase& given) {
  for (const char* body : {"wheel", "rail"}) check_profile(given, body);
  check_rules(given);
  check_required(given);
  check_entries(given);
  check_list_lengths(given);
  check_order(given);
}

void check_geometry(const GivenCase& given, const Case& input) {
  check_approach(given, input);
  check_ring(given, input);
  check_grid_of_line(given, input);
  if (replaces_radii(given) || when::profiles(given) || when::line(given)) return;
  const double wheel = input.wheel.transverse_radius;
  const double rail = input.rail.transverse_radius;
  // B > 0 is not sufficient: radii that cancel to rounding would pass and overflow later.
  const double scale = 1.0 / std::abs(wheel) + 1.0 / std::abs(rail);
  if (1.0 / wheel + 1.0 / rail > 1e-9 * scale) return;
  const auto fail_here = [&](const std::string& wrong, const std::string& allowed,
                             const std::string& action) {
    fail_at(given, "wheel.transverse_radius", *given.find("wheel", "transverse_radius"), wrong,
            allowed, action);
  };
  if (std::isinf(wheel) && std::isinf(rail))
    fail_here("flat on a flat rail is an endless line contact",
              "a finite radius of the wheel or of the rail",
              "give one of the two profiles a radius, which may be very large, or write shape = "
              "\"line\" under [geometry]");
  if (wheel < 0.0 && rail > 0.0 && !std::isinf(rail))
    fail_here(fmt::format("concave and not wider than the rail's {} mm: the bodies would not touch "
                          "in the middle",
                          rail),
              fmt::format("a concave radius below {} mm (larger in magnitude)", -rail),
              "flatten the wheel's profile or sharpen the rail's");
  if (rail < 0.0 && wheel > 0.0 && !std::isinf(wheel))
    fail_here(fmt::format("convex and not sharper than the concave rail's {} mm: the bodies would "
                          "not touch in the middle",
                          rail),
              fmt::format("a convex radius from 0 to below {} mm", -rail),
              "sharpen the wheel's profile or flatten the rail's");
  fail_here(fmt::format("with rail.transverse_radius = {} leaves no convex body: the bodies would "
                        "touch at their edges",
                        rail),
            "at least one convex (positive) radius",
            "check the signs: positive is convex, for wheel and rail");
}

}  // namespace rollfem::contact
