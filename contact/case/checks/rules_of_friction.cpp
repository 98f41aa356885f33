// SPDX-License-Identifier: LGPL-2.1-or-later
// Keys that falling friction and a layer require and exclude.
#include "contact/case/checks/case_rules.hpp"

namespace rollfem::contact {

namespace {

bool has_friction_key(const GivenCase& given, const char* name) {
  return given.find("friction", name) != nullptr;
}
std::string law_of(const GivenCase& given) {
  return word_of(given, "friction", "law", "constant");
}
bool constant_friction(const GivenCase& given) {
  return law_of(given) == "constant";
}
bool falling_friction(const GivenCase& given) {
  return !constant_friction(given);
}
bool falls_otherwise(const GivenCase& given) {
  return falling_friction(given) && law_of(given) != "exponential";
}
bool falls_in_rolling(const GivenCase& given) {
  const std::string problem = word_of(given, "rolling", "problem", "steady");
  return falling_friction(given) && problem != "shift" && problem != "frictionless";
}
bool falls_in_two_parts(const GivenCase& given) {
  return falling_friction(given) && has_friction_key(given, "second_part");
}
bool falls_in_one_part(const GivenCase& given) {
  return !has_friction_key(given, "second_part");
}
bool no_memory(const GivenCase& given) {
  return !has_friction_key(given, "memory_distance");
}
bool no_profiles(const GivenCase& given) {
  return !has_profiles(given);
}
bool varies_along_the_track(const GivenCase& given) {
  return has_friction_key(given, "track_position");
}
bool same_along_the_track(const GivenCase& given) {
  return !varies_along_the_track(given);
}
bool has_layer(const GivenCase& given) {
  return given.find("layer", "thickness") != nullptr ||
         given.find("layer", "shear_modulus") != nullptr;
}
bool has_hardening(const GivenCase& given) {
  return given.find("layer", "hardening") != nullptr;
}

}  // namespace

const std::vector<Exclusion>& exclusions_of_friction() {
  static const std::vector<Exclusion> all{
      {constant_friction,
       {"friction.kinetic_coefficient", "friction.half_velocity", "friction.second_*",
        "friction.polach_*", "friction.memory_*", "friction.branch"},
       "is of friction that falls with the slip velocity, but friction.law is constant",
       "with the laws linear, rational, exponential",
       "write `law = \"exponential\"` under [friction], or remove it"},
      {falls_otherwise,
       {"friction.polach_*"},
       "is of the exponential law, but friction.law is {law}",
       "with law = \"exponential\"",
       "give kinetic_coefficient and half_velocity instead, or choose the exponential law"},
      {falls_in_one_part,
       {"friction.second_half_velocity"},
       "is not used, because second_part is not given",
       "together with second_part",
       "add second_part under [friction], or remove it"},
      {no_memory,
       {"friction.memory_velocity"},
       "is not used, because memory_distance is not given",
       "together with memory_distance",
       "add memory_distance under [friction], or remove it"},
      {no_profiles,
       {"friction.inclination", "friction.track_position"},
       "is of friction that varies over the rail, but this case has no profiles",
       "with profiles of both bodies, or one number as friction.coefficient",
       "give wheel.profile and rail.profile (\"arcs\" builds them from radii), or remove it",
       true},
      {has_profiles,
       {"friction.lateral_position"},
       "is of contacts without profiles",
       "friction over the rail as friction.inclination",
       "give inclination instead",
       true},
      {same_along_the_track,
       {"wheelset.track_position"},
       "is not used, because friction.track_position is not given",
       "together with friction.track_position",
       "add track_position under [friction], or remove it",
       true}};
  return all;
}

const std::vector<Need>& needs_of_friction() {
  static const std::vector<Need> all{
      {falling_friction,
       {"friction.kinetic_coefficient", "friction.polach_a"},
       "is missing",
       "the coefficient to which friction falls with the slip velocity",
       "add `kinetic_coefficient = 0.1` under [friction], or write `law = \"constant\"`"},
      {falling_friction,
       {"friction.half_velocity", "friction.polach_b"},
       "is missing",
       "the slip velocity in mm/s at which half of the fall is done",
       "add `half_velocity = 1000.0` under [friction], or write `law = \"constant\"`"},
      {falls_in_two_parts,
       {"friction.second_half_velocity"},
       "is missing",
       "the slip velocity in mm/s at which half of second_part is left",
       "add `second_half_velocity = 1e4` under [friction], or remove second_part"},
      {falls_in_rolling,
       {"rolling.speed"},
       "is missing, and the friction depends on the slip velocity (friction.law)",
       "the rolling speed in mm/s",
       "add `speed = 10e3` under [rolling], or write `law = \"constant\"` under [friction]"},
      {varies_along_the_track,
       {"wheelset.track_position"},
       "is missing, and the friction depends on it (friction.track_position)",
       "one position along the track, mm, for each position of the wheelset",
       "add `track_position = 0.0` under [wheelset]"},
      {has_layer,
       {"layer.thickness"},
       "is missing",
       "thickness and shear_modulus of the layer",
       "add `thickness = 0.02` under [layer]"},
      {has_layer,
       {"layer.shear_modulus"},
       "is missing",
       "thickness and shear_modulus of the layer",
       "add `shear_modulus = 800.0` under [layer]"},
      {has_hardening,
       {"layer.yield_stress"},
       "is missing",
       "the shear stress at which the layer yields, before it hardens or softens",
       "add `yield_stress = 200.0` under [layer], or remove hardening"}};
  return all;
}

}  // namespace rollfem::contact
