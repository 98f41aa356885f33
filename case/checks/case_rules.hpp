// SPDX-License-Identifier: LGPL-2.1-or-later
// Dependencies between the keys of a case, declared in tables: keys without meaning in some cases,
// mutually exclusive alternatives, and groups with one required key.
#pragma once

#include "case/checks/case_checks.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Condition under which a rule applies to a case.
class Condition {
 public:
  using Holds = std::function<bool(const GivenCase&)>;
  explicit Condition(Holds holds) : holds_(std::move(holds)) {}
  bool operator()(const GivenCase& given) const { return holds_(given); }

  Condition operator!() const {
    return Condition([a = *this](const GivenCase& given) { return !a(given); });
  }
  Condition operator&&(const Condition& b) const {
    return Condition([a = *this, b](const GivenCase& given) { return a(given) && b(given); });
  }
  Condition operator||(const Condition& b) const {
    return Condition([a = *this, b](const GivenCase& given) { return a(given) || b(given); });
  }

 private:
  Holds holds_;
};

namespace when {

/// The key is given.
inline Condition has(const char* section, const char* name) {
  return Condition([=](const GivenCase& given) { return given.find(section, name) != nullptr; });
}

/// The key, or its default, is this word.
inline Condition is(const char* section, const char* name, const char* word) {
  return Condition([=](const GivenCase& given) { return word_of(given, section, name) == word; });
}

inline const Condition line = is("geometry", "shape", "line");
inline const Condition wheel_profile = has("wheel", "profile");
inline const Condition rail_profile = has("rail", "profile");
inline const Condition profiles = wheel_profile || rail_profile;
inline Condition section(const char* name) {
  return Condition([=](const GivenCase& given) { return given.section_lines.count(name) > 0; });
}
/// A key of the section is given: in a template all may stand in comments.
inline Condition any_of(const char* name) {
  return Condition([=](const GivenCase& given) {
    for (const auto& [key, value] : given.values)
      if (key->section == name) return true;
    return false;
  });
}
inline const Condition placement = section("placement");
/// A list, of a key over such entries, has more than one number.
inline Condition lists_over(const char* per) {
  return Condition([=](const GivenCase& given) {
    for (const auto& [key, value] : given.values)
      if (key->per == per && std::get<std::vector<double>>(value.value).size() > 1) return true;
    return false;
  });
}
inline Condition off(const char* section, const char* name) {
  return Condition([=](const GivenCase& given) {
    const GivenValue* value = given.find(section, name);
    return value != nullptr && !std::get<bool>(value->value);
  });
}
inline Condition rigid(const char* body) {
  return Condition([=](const GivenCase& given) {
    const GivenValue* modulus = given.find(body, "young_modulus");
    return modulus != nullptr && std::get<double>(modulus->value) == infinity;
  });
}
inline const Condition own_mesh = has("wheel", "mesh") || has("rail", "mesh");
inline const Condition given_pressure = has("given_pressure", "semi_axis_x") ||
                                        has("given_pressure", "semi_axis_y") ||
                                        has("given_pressure", "max_pressure");
inline const Condition shift = is("rolling", "problem", "shift");
inline const Condition transient = is("rolling", "problem", "transient");
inline const Condition frictionless = is("rolling", "problem", "frictionless");
inline const Condition steps = shift || transient;
inline const Condition slip_from_file = is("rolling", "extra_slip", "file");
inline const Condition torque_of_one =
    is("wheelset", "free_rolling", "torque") && !is("wheelset", "side", "both");
/// mu follows the temperature instead of the slip.
inline const Condition by_temperature = Condition([](const GivenCase& given) {
  return fall_shape(word_of(given, "friction", "law")).by_temperature;
});
inline const Condition friction_falls =
    !is("friction", "law", FallShape::none.word) && !by_temperature;
/// The law has no other spelling of its numbers.
inline const Condition no_polach = Condition(
    [](const GivenCase& given) { return !fall_shape(word_of(given, "friction", "law")).polach; });
inline const Condition second_part = has("friction", "second_part");
inline const Condition memory = has("friction", "memory_distance");
inline const Condition varies_along_track = has("friction", "track_position");
/// The profile is a list of sections along the way.
inline Condition sections(const char* body) {
  return Condition([=](const GivenCase& given) {
    const GivenValue* name = given.find(body, "profile");
    return name != nullptr && is_list_of_sections(std::get<std::string>(name->value));
  });
}
inline const Condition rail_sections = sections("rail");
inline const Condition wheel_sections = sections("wheel");
/// The body changes along its way.
inline const Condition rail_varies =
    rail_sections || any_of("rail_corrugation") || any_of("rail_dip");
inline const Condition wheel_varies =
    wheel_sections || any_of("wheel_flat") || any_of("wheel_polygon");
inline const Condition rounded_flat =
    has("wheel_flat", "shape") && is("wheel_flat", "shape", "rounded");
inline const Condition yields = any_of("wheel_plasticity") || any_of("rail_plasticity");
inline const Condition heat = any_of("wheel_heat") || any_of("rail_heat");
inline const Condition layer = has("layer", "thickness") || has("layer", "shear_modulus");

}  // namespace when

/// Keys that are not allowed if the condition holds: "section.name", with at most one *. In the
/// texts, {problem} stands for the problem, {slip} for extra_slip, {law} for the friction law and
/// {laws} for those that fall.
struct Exclusion {
  Condition where;
  std::vector<const char*> keys;
  const char* wrong;
  const char* allowed;
  const char* action;
  bool defaults_too = false;  ///< also rejected with a value that has no effect
};

/// Throws InputError.
void check_exclusion(const GivenCase& given, const Exclusion& rule);

/// Applies the rules to the given keys. Throws InputError.
void check_rules(const GivenCase& given);

}  // namespace rollfem::contact
