// SPDX-License-Identifier: LGPL-2.1-or-later
// Consistency checks of values whose keys are valid individually, and derived values.
#include "contact/base/material.hpp"
#include "contact/base/pi.hpp"
#include "contact/base/profile_drop.hpp"
#include "contact/case/checks/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace rollfem::contact {

namespace {

/// The normal force of a load point, if known before solving.
std::optional<double> known_normal_force(const Case& input, std::size_t k) {
  if (k < input.history.size() && input.history[k].normal_force)
    return input.history[k].normal_force;
  if (k < input.history.size() && input.history[k].approach) return {};
  return input.load.normal_force;
}

/// Below this part of the largest coefficient rows of elements have next to no bound.
constexpr double least_part_of_largest = 1e-3;

void check_friction(const GivenCase& given, const Case& input) {
  const double mu = input.friction_coefficient;
  for (const FrictionVariation::Point& point : input.friction_variation.points)
    if (point.coefficient < least_part_of_largest * mu)
      fail_at(given, "friction.coefficient", *given.find("friction", "coefficient"),
              fmt::format("has next to no friction at a point, {:g}", point.coefficient),
              fmt::format("at least {:g} times the largest, {:g}", least_part_of_largest, mu),
              "give it a small coefficient, 0.01 say");
}

/// Below this part of the friction at rest what slides has next to no bound.
constexpr double least_kinetic_part = 0.01;

void check_fall_of(const GivenCase& given, double mu, const FrictionFall& fall) {
  const double kinetic =
      fall.polach_a ? *fall.polach_a * mu : fall.kinetic_coefficient.value_or(mu);
  const double least = least_kinetic_part * mu * (1.0 - 1e-12);
  if (!fall.polach_a && (kinetic > mu || kinetic < least))
    fail_at(given, "friction.kinetic_coefficient", *given.find("friction", "kinetic_coefficient"),
            fmt::format("does not fit friction.coefficient = {:g}, from which friction falls", mu),
            fmt::format("{:g} to {:g}", least_kinetic_part * mu, mu),
            "give the coefficient at rest as friction.coefficient");
  if (fall.second_part > (mu - kinetic) * (1.0 + 1e-12))
    fail_at(given, "friction.second_part", *given.find("friction", "second_part"),
            fmt::format("is more than friction falls, {:g} from rest to sliding", mu - kinetic),
            fmt::format("0 to {:g}", mu - kinetic), "make it a part of that fall");
}

void check_fall(const GivenCase& given, const Case& input) {
  if (input.friction_fall.shape == FallShape::none || input.friction_coefficient == 0.0) return;
  if (input.friction_variation.points.empty())
    check_fall_of(given, input.friction_coefficient, input.friction_fall);
  for (const FrictionVariation::Point& point : input.friction_variation.points)
    check_fall_of(given, point.coefficient, point.fall);
  if (input.rolling.problem == Problem::shift || input.rolling.problem == Problem::frictionless ||
      input.rolling.speed > 0.0)
    return;
  fail_at(given, "rolling.speed", *given.find("rolling", "speed"),
          "leaves the friction at rest, although friction.law is given", "above 0 mm/s",
          "give the rolling speed, or write `law = \"constant\"` under [friction]");
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
    fail_at(given, std::string("rolling.") + name, *given.find("rolling", name),
            fmt::format("asks for {:.6g} N at load point {}, but friction transmits less than mu "
                        "F_z = {:.6g} N",
                        size, k + 1, limit),
            fmt::format("a tangential force below {:.6g} N in size", limit),
            "lower the force, or raise the friction coefficient or the normal force");
  }
}

void check_rigid(const GivenCase& given, const Case& input) {
  if (!input.wheel.material.rigid() || !input.rail.material.rigid()) return;
  fail_at(given, "rail.young_modulus", *given.find("rail", "young_modulus"),
          "makes both bodies rigid, so that they touch in a point",
          "inf for at most one of wheel and rail", "give one of them a finite modulus");
}

/// Inertia needs a speed below the Rayleigh wave speed, at which moving loads have no steady
/// solution and the stiffness with inertia becomes indefinite.
void check_inertia(const GivenCase& given, const Case& input) {
  if (!input.fem.inertia) return;
  if (!feels_inertia(input))
    fail_at(given, "fem.inertia", *given.find("fem", "inertia"),
            "needs a rolling speed, and rolling.speed is 0", "true with rolling.speed > 0",
            "give `speed` in mm/s under [rolling], or remove it");
  const GivenValue& speed = *given.find("rolling", "speed");
  for (const bool wheel : {true, false}) {
    const Material& material = wheel ? input.wheel.material : input.rail.material;
    const double limit = largest_rayleigh_fraction * rayleigh_speed(material);
    if (input.rolling.speed < limit) continue;
    fail_at(
        given, "rolling.speed", speed,
        fmt::format("is at or above {} of the Rayleigh wave speed of the {}, {:.4g} mm/s",
                    largest_rayleigh_fraction, wheel ? "wheel" : "rail", rayleigh_speed(material)),
        fmt::format("below {:.4g} mm/s", limit),
        "lower the speed (mm/s), check young_modulus (MPa) and density (t/mm^3), or remove "
        "fem.inertia");
  }
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

/// One load point for each pass, by default one pass for each load point.
void repeat_load_points(const GivenCase& given, Case& input) {
  const int points = input.fem.cycle = static_cast<int>(input.rolling.creepages.size());
  const GivenValue* passes = given.find("fem", "passes");
  if (passes == nullptr) input.fem.passes = points;
  if (input.fem.passes < points)
    fail_at(given, "fem.passes", *passes,
            fmt::format("leaves out some of the {} load points, each of which is a pass", points),
            fmt::format("at least {}, one cycle of them", points),
            "raise it, or shorten the lists of creepages or forces");
  const auto repeat = [&](auto& entries) {
    if (entries.empty()) return;
    const auto once = entries;
    entries.clear();
    for (int pass = 0; pass < input.fem.passes; ++pass) entries.push_back(once[pass % once.size()]);
  };
  repeat(input.rolling.creepages);
  repeat(input.rolling.forces);
  repeat(input.wheelset.rotation_change);
}

/// What the keys of a steel need of each other.
void check_plasticity(const GivenCase& given, const char* body, const BodyPlasticity& steel) {
  const std::string section = std::string(body) + "_plasticity";
  const auto length = [&](const char* key) {
    const GivenValue* value = given.find(section, key);
    return value == nullptr ? 0 : std::get<std::vector<double>>(value->value).size();
  };
  const auto need = [&](const char* key, const char* allowed, const char* action) {
    if (given.find(section, key) == nullptr)
      fail_missing(given, section + "." + key, section_line(given, section), "is missing", allowed,
                   fmt::format("add `{} under [{}]", action, section));
  };
  need("yield_stress", "the stress in tension at which the steel yields", "yield_stress = 520.0`");
  if (length("recovery") > 0)
    need("hardening", "the moduli of the back stresses that recover", "hardening = 100e3`");
  const bool lists = length("residual_along") + length("residual_across") > 0;
  if (!steel.residual.file.empty() && (lists || length("residual_depth") > 0))
    fail_at(given, section + ".residual_file", *given.find(section, "residual_file"),
            "stands beside lists of the residual stress", "the file or the lists",
            "remove one of the two");
  if (lists) need("residual_depth", "depths of the lists", "residual_depth = [0.0, 5.0]`");
  constexpr std::size_t most = BodyPlasticity::most_back_stresses;
  if (length("hardening") > most)
    fail_at(given, section + ".hardening", *given.find(section, "hardening"),
            fmt::format("has {} back stresses", length("hardening")),
            fmt::format("one to {} moduli", most), "join those that saturate at similar strains");
  if (steel.rise < 0.0 && -steel.rise >= steel.yield_stress)
    fail_at(given, section + ".isotropic_rise", *given.find(section, "isotropic_rise"),
            "softens the steel to nothing",
            fmt::format("above {:g} MPa (minus the yield stress)", -steel.yield_stress),
            "give a smaller softening");
  if ((steel.rise != 0.0) != (steel.rate != 0.0)) {
    const std::string key = steel.rise != 0.0 ? "isotropic_rise" : "isotropic_rate";
    fail_at(given, section + "." + key, *given.find(section, key), "has no effect by itself",
            "isotropic_rise together with isotropic_rate", "give both of them, or neither");
  }
}

}  // namespace

void check_places(const GivenCase& given, const Case& input, bool bodies) {
  long points = 0;
  for (std::size_t k = 0; k < input.subsurface.size(); ++k) {
    const SubsurfaceRequest& request = input.subsurface[k];
    const GivenEntry& entry = given.entries.at(k);
    const auto fail_here = [&](const std::string& key, const std::string& wrong,
                               const std::string& allowed, const std::string& action) {
      const Key* declared = find_key(entry.section, key);
      const auto found = entry.values.find(declared);
      if (found != entry.values.end())
        fail_at(given, declared->path(), found->second, wrong, allowed, action);
      fail(given.file, {entry.line, 0, "", "", wrong, allowed, action});
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
  const Problem problem = input.rolling.problem;
  if (problem == Problem::shift || problem == Problem::transient)
    input.history.resize(input.rolling.creepages.size(),
                         input.history.empty() ? HistoryStep{} : input.history.front());
  for (const HistoryStep& step : input.history) {
    const auto raise = [](std::optional<double>& highest, const std::optional<double>& value) {
      if (value) highest = std::max(highest.value_or(0.0), *value);
    };
    raise(input.load.normal_force, step.normal_force);
    raise(input.load.approach, step.approach);
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
  for (Body* body : {static_cast<Body*>(&input.wheel), static_cast<Body*>(&input.rail)})
    if (body->plasticity) {
      auto& residual = body->plasticity->residual;
      extend({&residual.depth, &residual.along, &residual.across});
    }
  if (input.yields()) repeat_load_points(given, input);
}

void check_values(const GivenCase& given, const Case& input) {
  for (const bool wheel : {true, false}) {
    const Body& body = wheel ? static_cast<const Body&>(input.wheel) : input.rail;
    if (body.plasticity) check_plasticity(given, wheel ? "wheel" : "rail", *body.plasticity);
  }
  check_rigid(given, input);
  check_friction(given, input);
  check_fall(given, input);
  check_friction_limit(given, input);
  check_inertia(given, input);
  check_places(given, input);
}

}  // namespace rollfem::contact
