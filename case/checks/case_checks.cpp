// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/checks/case_checks.hpp"

#include "base/errors.hpp"
#include "base/material.hpp"
#include "base/pi.hpp"
#include "base/profile_drop.hpp"
#include "case/checks/case_rules.hpp"
#include "case/checks/history_checks.hpp"
#include "case/checks/irregularity_checks.hpp"
#include "case/keys/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <utility>

namespace rollfem::contact {

namespace {

bool replaces_radii(const GivenCase& given) {
  for (const auto& [key, value] : given.values)
    if (key->section == "undeformed_distance" || key->section == "given_pressure") return true;
  return false;
}

std::string add_to(const std::string& section, const Key& key) {
  return fmt::format("add `{} = {}` under {}", key.name, key.example, section);
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
      fail_at(given, key.path(), "is missing", allowed_values(key),
              add_to("[" + section.name + "]", key));
    }
  }
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
      fail_at(given, key->path(),
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
      fail_at(given, key->path(),
              fmt::format("does not ascend: {:g} follows {:g}", fall[1], fall[0]),
              "numbers in ascending order, each once",
              "sort them, and the lists that belong to them alike");
  }
}

void check_approach(const GivenCase& given, const Case& input) {
  if (given.find("load", "approach") == nullptr || replaces_radii(given)) return;
  const double along = input.geometry.relative_radius.value_or(
      std::min(input.wheel.rolling_radius, std::abs(input.rail.rolling_radius)));
  const double smallest = when::line(given)
                              ? along
                              : std::min({along, std::abs(input.wheel.transverse_radius),
                                          std::abs(input.rail.transverse_radius)});
  if (*input.load.approach < 0.1 * smallest) return;
  fail_at(given, "load.approach",
          fmt::format("is not small against the smallest radius, {} mm", smallest),
          fmt::format("less than {} mm, a tenth of it", 0.1 * smallest),
          "give a smaller approach, or a force; linear elasticity does not cover more");
}

/// A ring holds its wheel.
void check_ring(const GivenCase& given, const Case& input) {
  const double radius = -input.rail.rolling_radius;
  if (radius < 0.0 || radius > input.wheel.rolling_radius) return;
  fail_at(given, "rail.rolling_radius",
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
    if (std::abs(across - expected) <= 1e-9 * width) return;
    fail_at(
        given, std::string("contact_grid.") + name,
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
      fail_at(given, key->path(), fmt::format("is not used, because {}.profile is missing", body),
              fmt::format("[{}] together with [{}] profile", section, body),
              fmt::format("add `profile = \"FILE\"` under [{}], or remove [{}]", body, section));
    std::string by;
    if (!is_read(key->name, std::get<std::string>(profile->value), by))
      fail_at(given, key->path(),
              fmt::format("is not used with {}.profile = {}", body, profile->text), by,
              "remove it, or name another profile");
  }
  if (profile != nullptr && std::get<std::string>(profile->value).empty())
    fail_at(given, body + ".profile", "is empty", "a built-in profile, arcs, polynomial or a file",
            "name one");
}

/// The normal force of a load point, if known before solving.
std::optional<double> known_normal_force(const Case& input, std::size_t k) {
  if (k < input.history.size() && input.history[k].normal_force)
    return input.history[k].normal_force;
  if (k < input.history.size() && input.history[k].approach) return {};
  return input.load.normal_force;
}

/// Rows with a coefficient below this fraction of the largest one have practically no traction
/// bound.
constexpr double least_part_of_largest = 1e-3;

void check_friction(const GivenCase& given, const Case& input) {
  const double mu = input.friction_coefficient;
  for (const FrictionVariation::Point& point : input.friction_variation.points)
    if (point.coefficient < least_part_of_largest * mu)
      fail_at(given, "friction.coefficient",
              fmt::format("has next to no friction at a point, {:g}", point.coefficient),
              fmt::format("at least {:g} times the largest, {:g}", least_part_of_largest, mu),
              "give it a small coefficient, 0.01 say");
}

/// Below this fraction of the friction at rest, sliding elements have practically no traction
/// bound.
constexpr double least_kinetic_part = 0.01;

void check_fall_of(const GivenCase& given, double mu, const FrictionFall& fall) {
  const double kinetic =
      fall.polach_a ? *fall.polach_a * mu : fall.kinetic_coefficient.value_or(mu);
  const double least = least_kinetic_part * mu * (1.0 - 1e-12);
  if (!fall.polach_a && (kinetic > mu || kinetic < least))
    fail_at(given, "friction.kinetic_coefficient",
            fmt::format("does not fit friction.coefficient = {:g}, from which friction falls", mu),
            fmt::format("{:g} to {:g}", least_kinetic_part * mu, mu),
            "give the coefficient at rest as friction.coefficient");
  if (fall.second_part > (mu - kinetic) * (1.0 + 1e-12))
    fail_at(given, "friction.second_part",
            fmt::format("is more than friction falls, {:g} from rest to sliding", mu - kinetic),
            fmt::format("0 to {:g}", mu - kinetic), "make it a part of that fall");
}

void check_temperatures_of(const GivenCase& given, const FallShape& law, const FrictionFall& fall) {
  const double cold = fall.constants[0].value_or(law.constants[0].otherwise);
  if (!(*fall.constants[1] > cold))
    fail_at(given, "friction.hot_temperature", "is not above friction.cold_temperature",
            fmt::format("above {:g} degC", cold), "give the higher temperature here");
}

void check_fall(const GivenCase& given, const Case& input) {
  if (input.friction_fall.shape == FallShape::none || input.friction_coefficient == 0.0) return;
  const FallShape& law = input.friction_fall.shape;
  const auto check = [&](double mu, const FrictionFall& fall) {
    return law.by_temperature ? check_temperatures_of(given, law, fall)
                              : check_fall_of(given, mu, fall);
  };
  if (input.friction_variation.points.empty())
    check(input.friction_coefficient, input.friction_fall);
  for (const FrictionVariation::Point& point : input.friction_variation.points)
    check(point.coefficient, point.fall);
  if (input.rolling.problem == Problem::shift || input.rolling.problem == Problem::frictionless ||
      input.rolling.speed > 0.0)
    return;
  fail_at(given, "rolling.speed", "leaves the friction at rest, although friction.law is given",
          "above 0 mm/s", "give the rolling speed, or write `law = \"constant\"` under [friction]");
}

void check_heat(const GivenCase& given, const Case& input) {
  if ((input.wheel.heat || input.rail.heat) && !(input.rolling.speed > 0.0))
    fail_at(given, "rolling.speed",
            "gives the surfaces no temperature, which [wheel_heat] and "
            "[rail_heat] ask for",
            "above 0 mm/s", "give the rolling speed, or remove these sections");
}

void check_friction_limit(const GivenCase& given, const Case& input) {
  const auto& forces = input.rolling.forces;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const std::optional<double> normal = known_normal_force(input, k);
    if (!normal) continue;
    const double size =
        std::hypot(forces[k].longitudinal.value_or(0.0), forces[k].lateral.value_or(0.0));
    const double limit = input.friction_coefficient * *normal;
    if (size < limit * (1.0 - 1e-12)) continue;
    const char* name = forces[k].longitudinal ? "longitudinal_force" : "lateral_force";
    fail_at(given, std::string("rolling.") + name,
            fmt::format("asks for {:.6g} N at load point {}, but friction transmits less than mu "
                        "F_z = {:.6g} N",
                        size, k + 1, limit),
            fmt::format("a tangential force below {:.6g} N in size", limit),
            "lower the force, or raise the friction coefficient or the normal force");
  }
}

void check_rigid(const GivenCase& given, const Case& input) {
  if (!input.wheel.material.rigid() || !input.rail.material.rigid()) return;
  fail_at(given, "rail.young_modulus", "makes both bodies rigid, so that they touch in a point",
          "inf for at most one of wheel and rail", "give one of them a finite modulus");
}

/// Points up to this height (mm) above a concave surface may still be moved onto it; the finite
/// elements, whose size is not known yet, decide.
constexpr double most_above_surface = 1.0;

/// Whether a point is certainly outside its body: beyond z = 0, and not in a concave body.
bool outside(const Case& input, bool wheel, const std::array<double, 3>& place) {
  const double depth = wheel ? place[2] : -place[2];
  const Body& body = wheel ? static_cast<const Body&>(input.wheel) : input.rail;
  double drop = profile_drop(body.transverse_radius, place[1], body.round_to).value;
  const double circle = input.wheel.rolling_radius - drop;
  if (wheel) drop += std::abs(place[0]) < circle ? circle_drop(circle, place[0]) : infinity;
  return depth < (drop < 0.0 ? drop - most_above_surface : 0.0);
}

/// Without load only bodies that have yielded tell anything.
void check_unloaded_steps(const GivenCase& given, const Case& input) {
  const auto unloaded = [](const HistoryStep& step) { return step.normal_force == 0.0; };
  const auto& steps = input.history;
  if (std::none_of(steps.begin(), steps.end(), unloaded)) return;
  if (!input.yields() || input.rolling.problem != Problem::shift)
    fail_at(given, "history.normal_force", "takes the load away from bodies that do not yield",
            "above 0 N, or 0 with the problem shift and [rail_plasticity] or [wheel_plasticity]",
            "give a small force instead");
  if (std::all_of(steps.begin(), steps.end(), unloaded))
    fail_at(given, "history.normal_force", "is 0 in all steps", "a force above 0 N in one of them",
            "give the force that presses the bodies");
}

void check_hardening_law(const GivenCase& given, const std::string& section,
                         const HardeningLaw& law, const BodyPlasticity& steel) {
  constexpr double beyond_all_strain = 1e12;
  const auto acts = [&](const HardeningLaw::Constant& one) { return steel.*one.member != 0.0; };
  const auto& constants = law.constants;
  const auto given_one = std::find_if(constants.begin(), constants.end(), acts);
  if (given_one == constants.end()) return;
  const auto refuse = [&](const char* wrong, const std::string& allowed, const char* action) {
    fail_at(given, section + "." + given_one->key, wrong, allowed, action);
  };
  if (steel.yield_stress + law.rise(steel, beyond_all_strain) <= 0.0)
    refuse("softens the steel to nothing",
           fmt::format("above {:g} MPa (minus the yield stress)", -steel.yield_stress),
           "give a smaller softening");
  std::string together;
  for (const auto& one : constants)
    together += (together.empty() ? "" : " together with ") + std::string(one.key);
  if (!std::all_of(constants.begin(), constants.end(), acts))
    refuse("has no effect by itself", together, "give all of them, or none");
}

/// What the keys of a steel need of each other.
void check_plasticity(const GivenCase& given, const char* name, const Body& body) {
  const BodyPlasticity& steel = *body.plasticity;
  const std::string section = std::string(name) + "_plasticity";
  const auto length = [&](const char* key) {
    const GivenValue* value = given.find(section, key);
    return value == nullptr ? 0 : std::get<std::vector<double>>(value->value).size();
  };
  const auto need = [&](const char* key, const char* allowed, const char* action) {
    if (given.find(section, key) == nullptr)
      fail_at(given, section + "." + key, "is missing", allowed,
              fmt::format("add `{} under [{}]", action, section));
  };
  need("yield_stress", "the stress in tension at which the steel yields", "yield_stress = 520.0`");
  if (length("recovery") > 0)
    need("hardening", "the moduli of the back stresses that recover", "hardening = 100e3`");
  const bool lists = length("residual_along") + length("residual_across") > 0;
  if (!steel.residual.file.empty() && (lists || length("residual_depth") > 0))
    fail_at(given, section + ".residual_file", "stands beside lists of the residual stress",
            "the file or the lists", "remove one of the two");
  if (lists) need("residual_depth", "depths of the lists", "residual_depth = [0.0, 5.0]`");
  constexpr std::size_t most = BodyPlasticity::most_back_stresses;
  if (length("hardening") > most)
    fail_at(given, section + ".hardening", fmt::format("has {} back stresses", length("hardening")),
            fmt::format("one to {} moduli", most), "join those that saturate at similar strains");
  if (steel.hot_temperature || steel.hot_yield_stress) {
    need("hot_temperature", "the temperature in degC of the hot steel", "hot_temperature = 700.0`");
    need("hot_yield_stress", "the yield stress of the hot steel", "hot_yield_stress = 200.0`");
    const double cold = body.heat.value_or(BodyHeat{}).temperature;
    if (!(*steel.hot_temperature > cold))
      fail_at(given, section + ".hot_temperature", "is not above that before contact",
              fmt::format("above {:g} degC, at which the steel has its yield_stress", cold),
              "give a higher one");
  }
  for (const HardeningLaw& law : hardening_laws()) check_hardening_law(given, section, law, steel);
}

}  // namespace

std::size_t length_of(const KeyValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value);
  return list != nullptr ? list->size() : static_cast<std::size_t>(std::get<double>(value));
}

const GivenValue* GivenCase::find(const std::string& section, const std::string& name) const {
  const auto found = values.find(find_key(section, name));
  return found == values.end() ? nullptr : &found->second;
}

std::string word_of(const GivenCase& given, const char* section, const char* name) {
  const GivenValue* value = given.find(section, name);
  return std::get<std::string>(value == nullptr ? find_key(section, name)->get(Case())
                                                : value->value);
}

void fail(const std::string& file, const CaseProblem& problem) {
  std::string place = file, text;
  if (problem.line > 0) place += fmt::format(":{}:{}", problem.line, problem.column);
  text += problem.key;
  if (!problem.value.empty()) text += " = " + problem.value;
  if (!problem.key.empty()) text += ": ";
  text += problem.wrong;
  if (!problem.allowed.empty()) text += "; allowed: " + problem.allowed;
  if (!problem.action.empty()) text += "; do: " + problem.action;
  throw CaseError({place}, text);
}

void fail_at(const GivenCase& given, const std::string& path, const std::string& wrong,
             const std::string& allowed, const std::string& action) {
  const Key* key = find_key(path);
  const auto found = given.values.find(key);
  if (found != given.values.end())
    fail(given.file, {found->second.line, found->second.column, path, found->second.text, wrong,
                      allowed, action});
  // Missing: the message shows where its section begins, if there is one.
  const auto section = given.section_lines.find(key->section);
  const unsigned line = section == given.section_lines.end() ? 0 : section->second;
  fail(given.file, {line, line > 0 ? 1U : 0U, path, "", wrong, allowed, action});
}

void check_entries(const GivenCase& given) {
  for (const GivenEntry& entry : given.entries)
    for (const Key& key : case_keys())
      if (key.section == entry.section && key.required && entry.values.count(&key) == 0)
        fail(given.file, {entry.line, 1, key.path(), "", "is missing", allowed_values(key),
                          add_to("[[" + entry.section + "]]", key)});
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
    fail_at(given, "wheel.transverse_radius", wrong, allowed, action);
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

void check_places(const GivenCase& given, const Case& input, bool bodies) {
  long points = 0;
  for (std::size_t k = 0; k < input.subsurface.size(); ++k) {
    const SubsurfaceRequest& request = input.subsurface[k];
    const GivenEntry& entry = given.entries.at(k);
    const auto fail_here = [&](const std::string& key, const std::string& wrong,
                               const std::string& allowed, const std::string& action) {
      const Key* declared = find_key(entry.section, key);
      const auto found = entry.values.find(declared);
      if (found == entry.values.end())
        fail(given.file, {entry.line, 0, "", "", wrong, allowed, action});
      const GivenValue& value = found->second;
      fail(given.file,
           {value.line, value.column, declared->path(), value.text, wrong, allowed, action});
    };
    using Kind = SubsurfaceRequest::Kind;
    // Corners of a line on the surface have z = 0.
    std::vector<std::pair<std::string, std::array<double, 3>>> corners{
        {request.kind == Kind::point ? "at" : "from", request.from}};
    if (request.kind != Kind::point) corners.emplace_back("to", request.to);
    if (request.kind == Kind::plane) corners.emplace_back("across", request.across);
    for (const auto& [name, corner] : corners)
      if (bodies && outside(input, request.wheel, corner))
        fail_here(
            name,
            fmt::format("z = {} is not in the {}", corner[2], request.wheel ? "wheel" : "rail"),
            "z >= 0 in the wheel, z <= 0 in the rail; beyond that only in a concave body, down to "
            "its "
            "surface",
            "change the sign of z, or name the other body");
    if (request.kind == Kind::plane) {
      for (const double count :
           std::get<std::vector<double>>(entry.values.at(find_key(entry.section, "points")).value))
        if (count != std::floor(count))
          fail_here("points", fmt::format("{} is not a whole number", count), "two whole numbers",
                    "write for instance `points = [41, 21]`");
      // The fourth corner may leave the body although the three others do not.
      std::array<double, 3> fourth{};
      for (int c = 0; c < 3; ++c) fourth[c] = request.to[c] + request.across[c] - request.from[c];
      if (bodies && outside(input, request.wheel, fourth))
        fail_here("across",
                  fmt::format("the fourth corner, z = {}, is outside the body", fourth[2]),
                  "a parallelogram within the body", "move a corner deeper");
    }
    points += static_cast<long>(request.points[0]) * request.points[1];
    constexpr long most_points = 1000000;
    if (points > most_points)
      fail_here("points", fmt::format("gives {} points in total", points),
                fmt::format("at most {} points below the surface", most_points),
                "use fewer points");
  }
}

void complete(const GivenCase& given, Case& input) {
  Problem& problem = input.rolling.problem;
  if (problem == Problem::frictionless && !input.history.empty()) {
    problem = Problem::shift;  // pressed in steps
    input.friction_coefficient = 0.0;
    input.friction_variation = {};
  }
  if (problem == Problem::shift || problem == Problem::transient)
    input.history.resize(input.rolling.creepages.size(),
                         input.history.empty() ? HistoryStep{} : input.history.front());
  for (const HistoryStep& step : input.history) {
    const auto raise = [](std::optional<double>& highest, const std::optional<double>& value) {
      if (value) highest = std::max(highest.value_or(0.0), *value);
    };
    raise(input.load.normal_force, step.normal_force);
    raise(input.load.approach, step.approach);
    raise(input.load.vertical_force, step.vertical_force);
  }
  if (input.given_pressure) {
    GivenPressure& pressure = *input.given_pressure;
    const double volume = 2.0 / 3.0 * pi * pressure.semi_axis_x *
                          pressure.semi_axis_y;  // of the semi-ellipsoid with p0 = 1
    if (input.load.normal_force)
      pressure.max_pressure = *input.load.normal_force / volume;
    else
      input.load.normal_force = pressure.max_pressure * volume;
  }
  if (given.find("wheel", "rolling_radius") == nullptr) input.wheel.rolling_radius = infinity;
  input.rolling.given = {given.find("rolling", "longitudinal_creepage") != nullptr,
                         given.find("rolling", "lateral_creepage") != nullptr,
                         given.find("rolling", "spin") != nullptr};
  Wheelset& wheelset = input.wheelset;
  wheelset.on_rail = given.section_lines.count("placement") > 0;
  for (ProfileSource* profile : {&input.wheel.profile, &input.rail.profile})
    profile->for_track = !wheelset.on_rail && !input.track.rail_position;
  const auto extend = [](std::initializer_list<std::vector<double>*> lists) {
    std::size_t count = 0;
    for (const auto* list : lists) count = std::max(count, list->size());
    for (auto* list : lists)
      if (!list->empty()) list->resize(count, list->front());
  };
  extend({&wheelset.lateral_shift, &wheelset.yaw, &wheelset.roll, &wheelset.height,
          &wheelset.track_position, &wheelset.wheel_angle});
  complete_history(given, input);
  for (Body* body : {static_cast<Body*>(&input.wheel), static_cast<Body*>(&input.rail)})
    if (body->plasticity) {
      auto& residual = body->plasticity->residual;
      extend({&residual.depth, &residual.along, &residual.across});
    }
  if (auto& waves = input.wheel.polygon) extend({&waves->order, &waves->amplitude, &waves->phase});
  if (auto& waves = input.rail.corrugation)
    extend({&waves->wavelength, &waves->amplitude, &waves->phase});
  for (const Section& section : case_sections())
    if (section.complete != nullptr) section.complete(given, input);
}

void check_values(const GivenCase& given, const Case& input) {
  check_irregularities(given, input);
  if (input.wheel.plasticity) check_plasticity(given, "wheel", input.wheel);
  if (input.rail.plasticity) check_plasticity(given, "rail", input.rail);
  check_unloaded_steps(given, input);
  check_rigid(given, input);
  check_friction(given, input);
  check_fall(given, input);
  check_heat(given, input);
  check_friction_limit(given, input);
  check_places(given, input);
}

}  // namespace rollfem::contact
