// SPDX-License-Identifier: LGPL-2.1-or-later
// Implements rollfem.h: structures and units of the caller, exceptions as status and text.
#include "base/errors.hpp"
#include "base/threads.hpp"
#include "bindings/capi/guarded.hpp"
#include "case/case.hpp"
#include "case/reading/case_reader.hpp"
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"
#include "track/pair/wheel_rail_pair.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"
#include <cstddef>
#include <string>
#include <utility>

using namespace rollfem::capi;
using rollfem::tables::CreepTableReader;
namespace contact = rollfem::contact;
namespace tables = rollfem::tables;
namespace track = rollfem::track;

namespace {

/// Size of a definition that ends with the elements, and of a state that ends with the vertical
/// force.
constexpr std::size_t first_definition = offsetof(rollfem_definition, kinetic_coefficient);
constexpr std::size_t first_state = offsetof(rollfem_state, given);

constexpr const char* opened = "what rollfem_table_open returned";

const char* name_of(rollfem_side side) {
  if (side == ROLLFEM_LEFT) return "left";
  if (side == ROLLFEM_RIGHT) return "right";
  throw contact::InputError(fmt::format(
      "side = {}: is not known; allowed: ROLLFEM_LEFT, ROLLFEM_RIGHT; do: fill the definition with "
      "rollfem_defaults",
      static_cast<int>(side)));
}

std::string profile_of(const char* what, const char* name) {
  if (name == nullptr || *name == '\0')
    throw contact::InputError(fmt::format("{} is not given; do: name a profile", what));
  return name;
}

const contact::FallShape& shape_of(rollfem_law law) {
  const std::vector<contact::FallShape>& laws = contact::fall_shapes();
  if (law >= 0 && static_cast<std::size_t>(law) < laws.size())
    return laws[static_cast<std::size_t>(law)];
  throw contact::InputError(
      fmt::format("friction_law = {}: is not known; allowed: ROLLFEM_CONSTANT, ROLLFEM_LINEAR, "
                  "ROLLFEM_RATIONAL, ROLLFEM_EXPONENTIAL, ROLLFEM_TEMPERATURE; do: fill the "
                  "definition with rollfem_defaults",
                  static_cast<int>(law)));
}

int threads_of(const rollfem_definition& given) {
  if (given.threads < 0 || given.threads > contact::most_threads)
    throw contact::InputError(
        fmt::format("threads = {}: is out of range; allowed: 0 to {}; do: write 0 for the caller's "
                    "thread alone",
                    given.threads, contact::most_threads));
  return given.threads;
}

/// On a track, or on the rail's profile by itself.
void place_wheels(const rollfem_definition& given, double length, contact::NamedValues& values) {
  if (given.gauge == 0.0) {
    if (given.side != ROLLFEM_RIGHT)
      throw contact::InputError(
          "side: gauge = 0 is a wheel by itself, in the coordinates of the rail's profile, where "
          "the field is at the right; allowed: ROLLFEM_RIGHT; do: write it, or give the gauge");
    values.emplace_back("placement.side", "right");
    return;
  }
  values.insert(values.end(),
                {{"track.gauge", given.gauge * length},
                 {"track.gauge_height", given.gauge_height * length},
                 {"track.inclination", given.inclination},
                 {"wheelset.side", name_of(given.side)},
                 {"wheelset.flange_back_distance", given.flange_back_distance * length},
                 {"wheelset.flange_back_position", given.flange_back_position * length}});
}

void set_heat(const rollfem_definition& given, contact::NamedValues& values) {
  if (given.has_heat == 0 && given.friction_law != ROLLFEM_TEMPERATURE) return;
  for (const auto& [body, heat] :
       {std::pair("wheel", &given.wheel_heat), {"rail", &given.rail_heat}}) {
    const std::string section = std::string(body) + "_heat.";
    values.emplace_back(section + "temperature", heat->temperature);
    if (heat->conductivity != 0.0)
      values.emplace_back(section + "conductivity", heat->conductivity);
    if (heat->heat_capacity != 0.0)
      values.emplace_back(section + "heat_capacity", heat->heat_capacity);
    constexpr double tonnes_per_mm3 = 1e-12;
    if (heat->density != 0.0)
      values.emplace_back(std::string(body) + ".density", heat->density * tonnes_per_mm3);
  }
}

/// The definition as a case, which passes the checks of case files.
contact::Case case_of(const rollfem_definition& given) {
  const Units units = units_of(given.units);
  const double length = units.length, stress = units.stress();
  contact::NamedValues values{
      {"load.vertical_force", 1.0},  // until a state gives its load
      {"friction.coefficient", given.friction_coefficient},
      {"friction.law", shape_of(given.friction_law).word},
      {"wheel.rolling_radius", given.rolling_radius * length},
      {"wheel.profile", profile_of("wheel_profile", given.wheel_profile)},
      {"wheel.young_modulus", given.wheel_young_modulus * stress},
      {"wheel.poisson_ratio", given.wheel_poisson_ratio},
      {"rail.profile", profile_of("rail_profile", given.rail_profile)},
      {"rail.young_modulus", given.rail_young_modulus * stress},
      {"rail.poisson_ratio", given.rail_poisson_ratio},
      {"contact_grid.elements_across", static_cast<double>(given.elements_across)}};
  place_wheels(given, length, values);
  const auto unless_zero = [&values](std::string key, double value) {
    if (value != 0.0) values.emplace_back(std::move(key), value);
  };
  unless_zero("rail.rolling_radius", given.rail_rolling_radius * length);
  unless_zero("friction.kinetic_coefficient", given.kinetic_coefficient);
  unless_zero("friction.half_velocity", given.half_velocity * length);
  unless_zero("friction.second_part", given.second_part);
  unless_zero("friction.second_half_velocity", given.second_half_velocity * length);
  unless_zero("friction.memory_distance", given.memory_distance * length);
  unless_zero("friction.memory_velocity", given.memory_velocity * length);
  const contact::FallShape& shape = shape_of(given.friction_law);
  for (std::size_t k = 0; k < shape.constants.size(); ++k) {
    const double value = given.law_constants[k];
    if (shape.constants[k].name != nullptr)
      unless_zero(fmt::format("friction.{}", shape.constants[k].name), value);
    else if (value != 0.0)
      throw contact::InputError(fmt::format(
          "law_constants[{}] = {:g}: the law {} has no such constant; allowed: 0; do: write 0", k,
          value, shape.word));
  }
  set_heat(given, values);
  const bool needs_speed = given.friction_law != ROLLFEM_CONSTANT || given.has_heat != 0;
  unless_zero("rolling.speed", needs_speed ? 1.0 : 0.0);
  unless_zero("layer.thickness", given.layer_thickness * length);
  unless_zero("layer.shear_modulus", given.layer_shear_modulus * stress);
  unless_zero("layer.yield_stress", given.layer_yield_stress * stress);
  unless_zero("layer.hardening", given.layer_hardening * stress / length);
  return contact::make_case(values, "pair");
}

track::WheelState state_of(const rollfem_state& state, const Units& units) {
  const double length = units.length;
  track::WheelState at{state.lateral_shift * length,
                       state.yaw,
                       state.roll,
                       state.forward_speed * length,
                       state.lateral_velocity * length,
                       state.yaw_rate,
                       state.rotation_speed};
  switch (state.given) {
    case ROLLFEM_VERTICAL_FORCE:
      at.given = track::GivenLoad::vertical_force;
      at.load = state.vertical_force * units.force;
      return at;
    case ROLLFEM_HEIGHT:
      at.given = track::GivenLoad::height;
      at.load = state.height * length;
      return at;
    case ROLLFEM_PENETRATION:
      at.given = track::GivenLoad::penetration;
      at.load = state.penetration * length;
      return at;
  }
  throw contact::InputError(
      fmt::format("given = {}: is not known; allowed: ROLLFEM_VERTICAL_FORCE, ROLLFEM_HEIGHT, "
                  "ROLLFEM_PENETRATION; do: write one of them",
                  static_cast<int>(state.given)));
}

rollfem_patch patch_of(const track::WheelPatch& of, const Units& units) {
  const double length = units.length, force = units.force;
  const contact::PointResult& point = of.point;
  rollfem_patch patch{};
  for (int d = 0; d < 3; ++d) {
    patch.position[d] = of.position[static_cast<std::size_t>(d)] / length;
    patch.force[d] = of.wrench[d] / force;
  }
  patch.contact_angle = of.place.contact_angle;
  patch.rolling_radius = of.place.rolling_radius / length;
  patch.longitudinal_creepage = point.creepage.longitudinal;
  patch.lateral_creepage = point.creepage.lateral;
  patch.spin = point.creepage.spin * length;
  patch.normal_force = point.normal_force / force;
  patch.longitudinal_force = point.longitudinal_force / force;
  patch.lateral_force = point.lateral_force / force;
  patch.spin_moment = point.spin_moment / (force * length);
  patch.lateral_pressure = point.lateral_pressure / force;
  patch.length = point.contact_length / length;
  patch.width = point.contact_width / length;
  patch.area = point.contact_area / (length * length);
  patch.adhesion_area = point.adhesion_area / (length * length);
  patch.max_pressure = point.max_pressure / units.stress();
  patch.max_pressure_bar = point.error_estimate.at("max_pressure") / units.stress();
  patch.creepage_work = point.creepage_work.value_or(0.0) / force;
  patch.max_temperature = point.max_temperature.value_or(0.0);
  patch.heat_wheel = point.heat_wheel.value_or(0.0) / force;
  patch.heat_rail = point.heat_rail.value_or(0.0) / force;
  return patch;
}

rollfem_result result_of(const track::WheelOnRail& wheel, const Units& units) {
  rollfem_result result{};
  for (const track::WheelPatch& of : wheel.patches) {
    const rollfem_patch patch = patch_of(of, units);
    result.creepage_work += patch.creepage_work;
    if (result.patch_count < ROLLFEM_MAX_PATCHES)
      result.patch[result.patch_count++] = patch;
    else
      ++result.patches_unlisted;
  }
  for (int d = 0; d < 3; ++d) {
    result.force[d] = wheel.wrench[d] / units.force;
    result.moment[d] = wheel.wrench[3 + d] / (units.force * units.length);
  }
  result.roll = wheel.roll;
  result.touching_height = wheel.touching_height / units.length;
  result.penetration = wheel.penetration / units.length;
  return result;
}

rollfem_derivatives derivatives_of(const track::WheelDerivatives& found, rollfem_given given,
                                   const Units& units) {
  static_assert(int{track::StateVariable::count} == int{ROLLFEM_STATE_VARIABLES});
  const double length = units.length, force = units.force;
  // What one unit of a variable is in mm, N, s, rad.
  const double unit[] = {length, 1.0, 1.0, length,
                         length, 1.0, 1.0, given == ROLLFEM_VERTICAL_FORCE ? force : length};
  rollfem_derivatives derivatives{};
  for (int k = 0; k < ROLLFEM_STATE_VARIABLES; ++k)
    for (int d = 0; d < 3; ++d) {
      derivatives.force[d][k] = found.by(d, k) * unit[k] / force;
      derivatives.moment[d][k] = found.by(3 + d, k) * unit[k] / (force * length);
    }
  derivatives.stiffness = found.stiffness * length / force;
  return derivatives;
}

}  // namespace

struct rollfem_pair {
  Units units;
  int threads;
  track::WheelRailPair pair;
};

struct rollfem_table {
  CreepTableReader reader;
};

namespace {

/// `derivatives`: null without.
rollfem_status solved(const rollfem_pair* pair, const rollfem_state* state, rollfem_result* result,
                      Given<rollfem_derivatives>* derivatives, char* message, size_t size) {
  Given<rollfem_result> place(result);
  return guarded(
      [&] {
        const rollfem_pair& of = wanted(pair, "pair", "what rollfem_create returned");
        const contact::Threads threads(of.threads);
        place.check("result", "a place for the result");
        if (derivatives != nullptr)
          derivatives->check("derivatives", "a place for the derivatives");
        const rollfem_state given = taken(state, "state", "a state of the wheelset", first_state);
        const track::WheelState at = state_of(given, of.units);
        track::WheelDerivatives found;
        place.give(
            result_of(derivatives ? of.pair.linearise(at, found) : of.pair.solve(at), of.units));
        if (derivatives != nullptr) derivatives->give(derivatives_of(found, given.given, of.units));
      },
      message, size);
}

}  // namespace

extern "C" {

void rollfem_defaults(rollfem_definition* definition, rollfem_units units) {
  const double mm = units == ROLLFEM_M_N ? 1e-3 : 1.0;
  const double mpa = units == ROLLFEM_M_N ? 1e6 : units == ROLLFEM_MM_KN ? 1e-3 : 1.0;
  Given<rollfem_definition> place(definition);
  if (!place.fits()) return;
  rollfem_definition given{};  // friction is constant, and there is no layer
  given.units = units;
  given.side = ROLLFEM_LEFT;
  given.wheel_profile = "S1002";
  given.rail_profile = "60E1";
  given.rolling_radius = 460.0 * mm;
  given.gauge = 1435.0 * mm;
  given.gauge_height = 14.0 * mm;
  given.inclination = 1.0 / 40.0;
  given.flange_back_distance = 1360.0 * mm;
  given.flange_back_position = -70.0 * mm;
  given.wheel_young_modulus = given.rail_young_modulus = 210e3 * mpa;
  given.wheel_poisson_ratio = given.rail_poisson_ratio = 0.3;
  given.friction_coefficient = 0.3;
  given.elements_across = 12;
  given.wheel_heat.temperature = given.rail_heat.temperature = contact::BodyHeat{}.temperature;
  given.threads = 1;
  place.give(given);
}

rollfem_pair* rollfem_create(const rollfem_definition* definition, char* message, size_t size) {
  rollfem_pair* made = nullptr;
  guarded(
      [&] {
        const rollfem_definition given = taken(
            definition, "definition", "one that rollfem_defaults has filled", first_definition);
        const int threads = threads_of(given);
        const contact::Threads used(threads);
        made =
            new rollfem_pair{units_of(given.units), threads, track::WheelRailPair(case_of(given))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_solve(const rollfem_pair* pair, const rollfem_state* state,
                             rollfem_result* result, char* message, size_t size) {
  return solved(pair, state, result, nullptr, message, size);
}

rollfem_status rollfem_linearise(const rollfem_pair* pair, const rollfem_state* state,
                                 rollfem_result* result, rollfem_derivatives* derivatives,
                                 char* message, size_t size) {
  Given<rollfem_derivatives> place(derivatives);
  return solved(pair, state, result, &place, message, size);
}

void rollfem_destroy(rollfem_pair* pair) {
  delete pair;
}

rollfem_table* rollfem_table_open(const char* path, char* message, size_t size) {
  rollfem_table* made = nullptr;
  guarded(
      [&] {
        if (path == nullptr || *path == '\0')
          throw contact::InputError("no table given; do: name its file");
        made = new rollfem_table{CreepTableReader(tables::read_table(path))};
      },
      message, size);
  return made;
}

rollfem_status rollfem_table_forces(const rollfem_table* table, const rollfem_ellipse* ellipse,
                                    rollfem_creep_forces* forces, char* message, size_t size) {
  Given<rollfem_creep_forces> result(forces);
  return guarded(
      [&] {
        const rollfem_ellipse of =
            taken(ellipse, "ellipse", "an ellipse", offsetof(rollfem_ellipse, speed));
        const auto found =
            wanted(table, "table", opened)
                .reader.physical(
                    of.semi_axis_x, of.semi_axis_y, of.shear_modulus, of.friction_bound,
                    {of.longitudinal_creepage, of.lateral_creepage, of.spin}, of.speed);
        result.check("forces", "a place for the forces");
        result.give({0, found.forces[0], found.forces[1], found.forces[2], found.force_bar,
                     found.moment_bar, found.rise});
      },
      message, size);
}

rollfem_status rollfem_table_wheel_forces(const rollfem_table* table,
                                          const rollfem_shifted_wheel* wheel,
                                          rollfem_wheel_forces* forces, char* message,
                                          size_t size) {
  Given<rollfem_wheel_forces> result(forces);
  return guarded(
      [&] {
        const rollfem_shifted_wheel of = taken(wheel, "wheel", "a wheel at a lateral shift",
                                               offsetof(rollfem_shifted_wheel, load));
        const auto& reader = wanted(table, "table", opened).reader;
        const auto [length, newtons] = units_of(of.units);
        const tables::TablePlace asked{length * of.lateral_shift, newtons * of.load,
                                       length * of.speed};
        const auto place = reader.wheel_at({asked.first, asked.load});
        const double own = reader.table().friction_coefficient * place.normal_force;
        const double bound = of.friction_bound == 0.0 ? own : newtons * of.friction_bound;
        const auto found = reader.of_wheel(
            asked, bound, {of.longitudinal_creepage, of.lateral_creepage, of.spin / length});
        const double moment = newtons * length;
        result.check("forces", "a place for the forces");
        result.give({0, found.forces[0] / newtons, found.forces[1] / newtons,
                     found.along_normal / newtons, found.forces[2] / moment,
                     found.force_bar / newtons, found.moment_bar / moment, bound / newtons,
                     place.normal_force / newtons, place.contact_angle,
                     place.rolling_radius / length, place.jump_after != 0.0, found.rise});
      },
      message, size);
}

void rollfem_table_close(rollfem_table* table) {
  delete table;
}

const char* rollfem_version(void) {
  return ROLLFEM_VERSION;
}

int rollfem_version_number(void) {
  return ROLLFEM_VERSION_NUMBER;
}

}  // extern "C"
