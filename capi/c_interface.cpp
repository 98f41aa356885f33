// SPDX-License-Identifier: LGPL-2.1-or-later
// Implements rollfem.h: unit conversion, and exceptions as status and text.
#include "capi/guarded.hpp"
#include "capi/units.hpp"
#include "capi/wheel_rail_pair.hpp"
#include "contact/base/errors.hpp"
#include "contact/case/case.hpp"
#include "contact/case/case_reader.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"
#include <cstddef>
#include <string>

using rollfem::capi::Given;
using rollfem::capi::guarded;
using rollfem::capi::PatchForces;
using rollfem::capi::SolvedPatch;
using rollfem::capi::SolvedWheel;
using rollfem::capi::taken;
using rollfem::capi::Units;
using rollfem::capi::units_of;
using rollfem::capi::wanted;
using rollfem::capi::WheelDerivatives;
using rollfem::capi::WheelRailPair;
using rollfem::capi::WheelState;
namespace contact = rollfem::contact;

namespace {

/// Size of a definition that ends with the elements, and of a state that ends with the vertical
/// force.
constexpr std::size_t first_definition = offsetof(rollfem_definition, kinetic_coefficient);
constexpr std::size_t first_state = offsetof(rollfem_state, given);

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

const char* name_of(rollfem_law law) {
  switch (law) {
    case ROLLFEM_CONSTANT:
      return word_of(contact::FallShape::none);
    case ROLLFEM_LINEAR:
      return word_of(contact::FallShape::linear);
    case ROLLFEM_RATIONAL:
      return word_of(contact::FallShape::rational);
    case ROLLFEM_EXPONENTIAL:
      return word_of(contact::FallShape::exponential);
  }
  throw contact::InputError(fmt::format(
      "friction_law = {}: is not known; allowed: ROLLFEM_CONSTANT, ROLLFEM_LINEAR, "
      "ROLLFEM_RATIONAL, ROLLFEM_EXPONENTIAL; do: fill the definition with rollfem_defaults",
      static_cast<int>(law)));
}

/// The sections of friction and of the layer; members that are 0 are not given.
std::string friction_text(const rollfem_definition& definition, const Units& units) {
  std::string text = fmt::format("[friction]\ncoefficient = {}\nlaw = \"{}\"\n",
                                 definition.friction_coefficient, name_of(definition.friction_law));
  const auto add = [&text](const char* key, double value) {
    if (value != 0.0) text += fmt::format("{} = {}\n", key, value);
  };
  add("kinetic_coefficient", definition.kinetic_coefficient);
  add("half_velocity", definition.half_velocity * units.length);
  add("second_part", definition.second_part);
  add("second_half_velocity", definition.second_half_velocity * units.length);
  add("memory_distance", definition.memory_distance * units.length);
  add("memory_velocity", definition.memory_velocity * units.length);
  if (definition.friction_law != ROLLFEM_CONSTANT) text += "[rolling]\nspeed = 1.0\n";
  if (definition.layer_thickness != 0.0 || definition.layer_shear_modulus != 0.0 ||
      definition.layer_yield_stress != 0.0 || definition.layer_hardening != 0.0)
    text += "[layer]\n";
  add("thickness", definition.layer_thickness * units.length);
  add("shear_modulus", definition.layer_shear_modulus * units.stress());
  add("yield_stress", definition.layer_yield_stress * units.stress());
  add("hardening", definition.layer_hardening * units.stress() / units.length);
  return text;
}

/// The definition as a case, which passes the checks of case files.
contact::Case case_of(const rollfem_definition& definition) {
  const Units units = units_of(definition.units);
  const double length = units.length, stress = units.stress();
  const std::string text = fmt::format(
      "models = [\"halfspace\"]\n[load]\nvertical_force = 1.0\n{}"
      "[wheel]\nrolling_radius = {}\nprofile = {}\nyoung_modulus = {}\npoisson_ratio = {}\n"
      "[rail]\nprofile = {}\nyoung_modulus = {}\npoisson_ratio = {}\n"
      "[track]\ngauge = {}\ngauge_height = {}\ninclination = {}\n"
      "[wheelset]\nside = \"{}\"\nflange_back_distance = {}\nflange_back_position = {}\n"
      "[contact_grid]\nelements_across = {}\n",
      friction_text(definition, units), definition.rolling_radius * length,
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
  switch (state.given) {
    case ROLLFEM_VERTICAL_FORCE:
      found.given = WheelState::Given::vertical_force;
      found.load = state.vertical_force * units.force;
      return found;
    case ROLLFEM_HEIGHT:
      found.given = WheelState::Given::height;
      found.load = state.height * units.length;
      return found;
    case ROLLFEM_PENETRATION:
      found.given = WheelState::Given::penetration;
      found.load = state.penetration * units.length;
      return found;
  }
  throw contact::InputError(
      fmt::format("given = {}: is not known; allowed: ROLLFEM_VERTICAL_FORCE, ROLLFEM_HEIGHT, "
                  "ROLLFEM_PENETRATION; do: write one of them",
                  static_cast<int>(state.given)));
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
  found.creepage_work = of.creepage_work / force;
  return found;
}

rollfem_result result_of(const SolvedWheel& wheel, const Units& units) {
  static_assert(SolvedWheel::most_patches == ROLLFEM_MAX_PATCHES);
  rollfem_result result{};
  result.patch_count = static_cast<int>(wheel.count);
  result.patches_unlisted = static_cast<int>(wheel.unlisted);
  for (std::size_t k = 0; k < wheel.count; ++k) result.patch[k] = patch_of(wheel.patches[k], units);
  for (int d = 0; d < 3; ++d) {
    result.force[d] = wheel.sum.force[d] / units.force;
    result.moment[d] = wheel.sum.moment[d] / (units.force * units.length);
  }
  result.creepage_work = wheel.creepage_work / units.force;
  result.roll = wheel.roll;
  result.touching_height = wheel.height / units.length;
  result.penetration = wheel.penetration / units.length;
  return result;
}

rollfem_derivatives derivatives_of(const WheelDerivatives& found, const WheelState& state,
                                   const Units& units) {
  static_assert(rollfem::capi::state_variables.size() == ROLLFEM_STATE_VARIABLES);
  const bool by_force = state.given == WheelState::Given::vertical_force;
  const double length = units.length, force = units.force;
  // What one unit of a variable is in mm, N, s, rad.
  const double unit[] = {length, 1.0, 1.0, length, length, 1.0, 1.0, by_force ? force : length};
  rollfem_derivatives derivatives{};
  for (std::size_t k = 0; k < found.by.size(); ++k)
    for (int d = 0; d < 3; ++d) {
      derivatives.force[d][k] = found.by[k].force[d] * unit[k] / force;
      derivatives.moment[d][k] = found.by[k].moment[d] * unit[k] / (force * length);
    }
  derivatives.stiffness = found.stiffness * length / force;
  return derivatives;
}

}  // namespace

struct rollfem_pair {
  Units units;
  WheelRailPair pair;
};

extern "C" {

void rollfem_defaults(rollfem_definition* definition, rollfem_units units) {
  const double mm = units == ROLLFEM_M_N ? 1e-3 : 1.0;
  const double mpa = units == ROLLFEM_M_N ? 1e6 : units == ROLLFEM_MM_KN ? 1e-3 : 1.0;
  Given<rollfem_definition> place(definition);
  if (place.fits())
    place.give({0, units, ROLLFEM_LEFT, "S1002", "60E1", 460.0 * mm, 1435.0 * mm, 14.0 * mm,
                1.0 / 40.0, 1360.0 * mm, -70.0 * mm, 210e3 * mpa, 0.3, 210e3 * mpa, 0.3, 0.3, 12,
                // friction is constant, and there is no layer
                0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, ROLLFEM_CONSTANT, 0.0, 0.0});
}

rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size) {
  rollfem_pair* made = nullptr;
  guarded(
      [&] {
        const rollfem_definition given = taken(
            definition, "definition", "one that rollfem_defaults has filled", first_definition);
        made = new rollfem_pair{units_of(given.units), WheelRailPair(case_of(given))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state,
                             rollfem_result* result, char* message, size_t size) {
  Given<rollfem_result> place(result);
  return guarded(
      [&] {
        const rollfem_pair& of = wanted(pair, "pair", "what rollfem_create returned");
        place.check("result", "a place for the result");
        const WheelState at =
            state_of(taken(state, "state", "a state of the wheelset", first_state), of.units);
        place.give(result_of(of.pair.solve(at), of.units));
      },
      message, size);
}

rollfem_status rollfem_linearise(const rollfem_pair* pair, const rollfem_state* state,
                                 rollfem_result* result, rollfem_derivatives* derivatives,
                                 char* message, size_t size) {
  Given<rollfem_result> place(result);
  Given<rollfem_derivatives> place_of_derivatives(derivatives);
  return guarded(
      [&] {
        const rollfem_pair& of = wanted(pair, "pair", "what rollfem_create returned");
        place.check("result", "a place for the result");
        place_of_derivatives.check("derivatives", "a place for the derivatives");
        const WheelState at =
            state_of(taken(state, "state", "a state of the wheelset", first_state), of.units);
        WheelDerivatives found;
        place.give(result_of(of.pair.linearise(at, found), of.units));
        place_of_derivatives.give(derivatives_of(found, at, of.units));
      },
      message, size);
}

void rollfem_destroy(rollfem_pair* pair) {
  delete pair;
}

const char* rollfem_version(void) {
  return ROLLFEM_VERSION;
}

int rollfem_version_number(void) {
  return ROLLFEM_VERSION_NUMBER;
}

}  // extern "C"
