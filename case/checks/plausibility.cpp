// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/checks/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

// Limits and their reasons: docs/troubleshooting.md.
constexpr double smallest_rolling_radius = 5.0;     // mm
constexpr double smallest_transverse_radius = 1.0;  // mm
constexpr double smallest_wheel = 100.0;            // mm
constexpr double least_of_metal = 1e4;              // MPa
constexpr double stiffest = 2e6;                    // MPa
constexpr double least_load_of_wheel = 5e-3;        // N/mm^2, force over the rolling radius squared
constexpr double largest_friction = 1.0;
constexpr double full_adhesion = 100.0;  // from here on it means no limit
constexpr double largest_creepage = 0.3;
constexpr double largest_spin = 0.1;         // rad/mm
constexpr double narrowest_gauge = 100.0;    // mm, of models
constexpr double largest_inclination = 0.1;  // tangent; rails lean by up to 1:20

struct Doubts {
  const std::string& file;
  std::vector<std::string> texts;
  void add(bool doubtful, const char* key, double value, const char* unit, const std::string& why) {
    if (doubtful) texts.push_back(fmt::format("{}: {} = {:g}{}: {}", file, key, value, unit, why));
  }
};

void doubt_radii(const Case& input, Doubts& doubts) {
  const double rolling = input.wheel.rolling_radius;
  doubts.add(rolling > 0.0 && rolling < smallest_rolling_radius, "wheel.rolling_radius", rolling,
             " mm", "wheels are larger; do: give it in mm if this is in m");
  const auto across = [&](const char* key, double radius) {
    doubts.add(radius != 0.0 && std::abs(radius) < smallest_transverse_radius, key, radius, " mm",
               "profiles have larger radii; do: give it in mm if this is in m");
  };
  if (input.wheel.profile.name.empty())
    across("wheel.transverse_radius", input.wheel.transverse_radius);
  if (input.rail.profile.name.empty())
    across("rail.transverse_radius", input.rail.transverse_radius);
}

void doubt_moduli(const Case& input, Doubts& doubts) {
  // Profiles are those of metal wheels on rails, as are loads that a soft wheel would not carry.
  const double radius = input.wheel.rolling_radius;
  const double force = input.load.vertical_force.value_or(input.load.normal_force.value_or(0.0));
  const bool loaded = input.geometry.shape == ContactShape::point && std::isfinite(radius) &&
                      radius >= smallest_wheel && force >= least_load_of_wheel * radius * radius;
  const bool metal = loaded || input.has_profiles();
  for (const auto& [key, modulus] :
       {std::pair{"wheel.young_modulus", input.wheel.material.young_modulus},
        std::pair{"rail.young_modulus", input.rail.material.young_modulus}}) {
    doubts.add(
        std::isfinite(modulus) && modulus > stiffest, key, modulus, " MPa",
        "no material is that stiff; do: give it in MPa if this is in kPa, or inf for a rigid body");
    doubts.add(metal && modulus < least_of_metal, key, modulus, " MPa",
               "metals have 7e4 to 2.1e5; do: give it in MPa if this is in GPa");
  }
}

void doubt_track(const Case& input, Doubts& doubts) {
  if (!input.has_profiles()) return;
  for (const auto& [key, length] :
       {std::pair{"track.gauge", input.track.gauge},
        std::pair{"wheelset.flange_back_distance", input.wheelset.flange_back_distance}})
    doubts.add(length < narrowest_gauge, key, length, " mm",
               "no track is that narrow; do: give it in mm if this is in m");
  doubts.add(std::abs(input.track.inclination) > largest_inclination, "track.inclination",
             std::atan(input.track.inclination), " rad",
             "rails lean by 0.025 to 0.05 rad (1:40 to 1:20); do: give it in rad if this is in "
             "degrees, or as a ratio such as \"1:40\"");
}

void doubt_load(const Case& input, Doubts& doubts) {
  const double radius = input.wheel.rolling_radius;
  const bool metal = std::min(input.wheel.material.young_modulus,
                              input.rail.material.young_modulus) > least_of_metal;
  const bool line = input.geometry.shape == ContactShape::line;  // any force is plausible
  if (line || !metal || !(radius >= smallest_wheel) || !std::isfinite(radius)) return;
  const double least = least_load_of_wheel * radius * radius;
  for (const auto& [key, force] : {std::pair{"load.normal_force", input.load.normal_force},
                                   std::pair{"load.vertical_force", input.load.vertical_force}})
    doubts.add(
        force && *force < least, key, force.value_or(0.0), " N",
        fmt::format(
            "a wheel of {:g} mm carries more than {:.0f} N; do: give it in N if this is in kN",
            radius, least));
}

double largest_size(const Case& input, double Creepage::*member) {
  double largest = 0.0;
  for (const Creepage& creepage : input.rolling.creepages)
    if (std::abs(creepage.*member) > std::abs(largest)) largest = creepage.*member;
  return largest;
}

void doubt_friction(const Case& input, Doubts& doubts) {
  const double mu = input.friction_coefficient;
  doubts.add(mu > largest_friction && mu < full_adhesion, "friction.coefficient", mu, "",
             "dry steel has 0.3 to 0.6; do: give it as a ratio if this is in percent");
}

void doubt_creepages(const Case& input, Doubts& doubts) {
  for (const auto& [key, member] :
       {std::pair{"rolling.longitudinal_creepage", &Creepage::longitudinal},
        std::pair{"rolling.lateral_creepage", &Creepage::lateral}}) {
    const double value = largest_size(input, member);
    doubts.add(std::abs(value) > largest_creepage, key, value, "",
               "the contact slides fully far below that; do: give it as a ratio if this is in "
               "percent: 0.001 is 0.1 %");
  }
  const double spin = largest_size(input, &Creepage::spin);
  doubts.add(std::abs(spin) > largest_spin, "rolling.spin", spin, " rad/mm",
             "contact angles cause sin(angle)/radius, some 1e-4 to 1e-2; do: give it in rad/mm if "
             "this is in rad/m");
}

}  // namespace

std::vector<std::string> implausible_values(const Case& input) {
  Doubts doubts{input.file, {}};
  doubt_radii(input, doubts);
  doubt_moduli(input, doubts);
  doubt_track(input, doubts);
  doubt_load(input, doubts);
  doubt_friction(input, doubts);
  doubt_creepages(input, doubts);
  return std::move(doubts.texts);
}

}  // namespace rollfem::contact
