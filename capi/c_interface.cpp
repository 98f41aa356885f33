// SPDX-License-Identifier: LGPL-2.1-or-later
// Implements rollfem.h: unit conversion, and exceptions as status and text.
#include "capi/guarded.hpp"
#include "capi/wheel_rail_pair.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"
#include <algorithm>
#include <cmath>
#include <string>

using rollfem::capi::guarded;
using rollfem::capi::PatchForces;
using rollfem::capi::SolvedPatch;
using rollfem::capi::SolvedWheel;
using rollfem::capi::wanted;
using rollfem::capi::WheelRailPair;
using rollfem::capi::WheelState;
namespace contact = rollfem::contact;

namespace {

/// The caller's units in mm and N.
struct Units {
  double length = 1.0;
  double force = 1.0;
  double stress() const { return force / (length * length); }
};

Units units_of(rollfem_units units) {
  switch (units) {
    case ROLLFEM_MM_N:
      return {1.0, 1.0};
    case ROLLFEM_M_N:
      return {1e3, 1.0};
    case ROLLFEM_MM_KN:
      return {1.0, 1e3};
  }
  throw contact::InputError(fmt::format(
      "units = {}: is not known; allowed: ROLLFEM_MM_N, ROLLFEM_M_N, ROLLFEM_MM_KN; do: "
      "fill the definition with rollfem_defaults",
      static_cast<int>(units)));
}

const char* name_of(rollfem_side side) {
  if (side == ROLLFEM_LEFT) return "left";
  if (side == ROLLFEM_RIGHT) return "right";
  throw contact::InputError(fmt::format(
      "side = {}: is not known; allowed: ROLLFEM_LEFT, ROLLFEM_RIGHT; do: fill the definition with "
      "rollfem_defaults",
      static_cast<int>(side)));
}

/// Any text as a TOML string.
std::string quoted(const char* what, const char* text) {
  if (text == nullptr || *text == '\0')
    throw contact::InputError(fmt::format("{} is not given; do: name a profile", what));
  std::string found = "\"";
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c == '"' || *c == '\\') found += '\\';
    found += *c;
  }
  return found + '"';
}

/// The definition as a case, which passes the checks of case files.
contact::Case case_of(const rollfem_definition& definition) {
  const Units units = units_of(definition.units);
  const double length = units.length, stress = units.stress();
  const std::string text = fmt::format(
      "models = [\"halfspace\"]\n[load]\nvertical_force = 1.0\n[friction]\ncoefficient = {}\n"
      "[wheel]\nrolling_radius = {}\nprofile = {}\nyoung_modulus = {}\npoisson_ratio = {}\n"
      "[rail]\nprofile = {}\nyoung_modulus = {}\npoisson_ratio = {}\n"
      "[track]\ngauge = {}\ngauge_height = {}\ninclination = {}\n"
      "[wheelset]\nside = \"{}\"\nflange_back_distance = {}\nflange_back_position = {}\n"
      "[contact_grid]\nelements_across = {}\n",
      definition.friction_coefficient, definition.rolling_radius * length,
      quoted("wheel_profile", definition.wheel_profile), definition.wheel_young_modulus * stress,
      definition.wheel_poisson_ratio, quoted("rail_profile", definition.rail_profile),
      definition.rail_young_modulus * stress, definition.rail_poisson_ratio,
      definition.gauge * length, definition.gauge_height * length, definition.inclination,
      name_of(definition.side), definition.flange_back_distance * length,
      definition.flange_back_position * length, definition.elements_across);
  return contact::parse_case(text, "pair");
}

WheelState state_of(const rollfem_state& state, const Units& units) {
  WheelState found;
  found.lateral_shift = state.lateral_shift * units.length;
  found.yaw = state.yaw;
  found.roll = state.roll;
  found.forward_speed = state.forward_speed * units.length;
  found.lateral_velocity = state.lateral_velocity * units.length;
  found.yaw_rate = state.yaw_rate;
  found.rotation_speed = state.rotation_speed;
  found.vertical_force = state.vertical_force * units.force;
  return found;
}

rollfem_patch patch_of(const SolvedPatch& patch, const Units& units) {
  const double length = units.length, force = units.force, area = length * length;
  const PatchForces& of = patch.forces;
  rollfem_patch found{};
  for (int d = 0; d < 3; ++d) {
    found.position[d] = patch.origin[d] / length;
    found.force[d] = patch.force[d] / force;
  }
  found.contact_angle = patch.contact_angle;
  found.rolling_radius = patch.rolling_radius / length;
  found.longitudinal_creepage = of.creepage.longitudinal;
  found.lateral_creepage = of.creepage.lateral;
  found.spin = of.creepage.spin * length;
  found.normal_force = of.normal_force / force;
  found.longitudinal_force = of.longitudinal_force / force;
  found.lateral_force = of.lateral_force / force;
  found.lateral_pressure = of.lateral_pressure / force;
  found.spin_moment = of.spin_moment / (force * length);
  found.length = of.length / length;
  found.width = of.width / length;
  found.area = of.area / area;
  found.max_pressure = of.max_pressure / units.stress();
  found.max_pressure_bar = of.max_pressure_bar / units.stress();
  found.adhesion_area = of.adhesion_area / area;
  return found;
}

void fill(const SolvedWheel& wheel, const Units& units, rollfem_result& result) {
  static_assert(SolvedWheel::most_patches == ROLLFEM_MOST_PATCHES);
  result.patches = static_cast<int>(wheel.count);
  for (int k = 0; k < result.patches; ++k) result.patch[k] = patch_of(wheel.patches[k], units);
  for (int d = 0; d < 3; ++d) {
    result.force[d] = wheel.force[d] / units.force;
    result.moment[d] = wheel.moment[d] / (units.force * units.length);
  }
  result.height = wheel.height / units.length;
}

}  // namespace

struct rollfem_pair {
  Units units;
  WheelRailPair pair;
};

extern "C" {

void rollfem_defaults(rollfem_definition* definition, rollfem_units units) {
  if (definition == nullptr) return;
  const double mm = units == ROLLFEM_M_N ? 1e-3 : 1.0;
  const double mpa = units == ROLLFEM_M_N ? 1e6 : units == ROLLFEM_MM_KN ? 1e-3 : 1.0;
  *definition = {units,       ROLLFEM_LEFT, "S1002",     "60E1",     460.0 * mm,  1435.0 * mm,
                 14.0 * mm,   1.0 / 40.0,   1360.0 * mm, -70.0 * mm, 210e3 * mpa, 0.3,
                 210e3 * mpa, 0.3,          0.3,         12};
}

rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size) {
  rollfem_pair* made = nullptr;
  guarded(
      [&] {
        const rollfem_definition& given =
            wanted(definition, "definition", "one that rollfem_defaults has filled");
        made = new rollfem_pair{units_of(given.units), WheelRailPair(case_of(given))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state,
                             rollfem_result* result, char* message, size_t size) {
  if (result != nullptr) *result = rollfem_result{};
  return guarded(
      [&] {
        const rollfem_pair& of = wanted(pair, "pair", "what rollfem_create returned");
        rollfem_result& found = wanted(result, "result", "a place for the result");
        fill(of.pair.solve(state_of(wanted(state, "state", "a state of the wheelset"), of.units)),
             of.units, found);
      },
      message, size);
}

void rollfem_destroy(rollfem_pair* pair) {
  delete pair;
}

const char* rollfem_version(void) {
  return ROLLFEM_VERSION;
}

}  // extern "C"
