// SPDX-License-Identifier: LGPL-2.1-or-later
// The track under wheels with profiles, and their wheelset.
#include "case/keys/case_text.hpp"
#include "case/keys/key_builder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

namespace {

constexpr double largest_turn = 0.5;  // rad

/// A tangent as written in a file: "none", "1:40" where it is such a ratio, otherwise the angle.
KeyValue lean_of(double tangent) {
  if (tangent == 0.0) return std::string("none");
  const std::string ratio = fmt::format("1:{:g}", 1.0 / tangent);
  const std::optional<double> number = ratio_of(ratio);
  if (number && std::abs(*number * tangent - 1.0) < 1e-12) return ratio;
  return std::atan(tangent);
}

double tangent_of(const KeyValue& value) {
  if (const auto* angle = std::get_if<double>(&value)) return std::tan(*angle);
  const std::optional<double> ratio = ratio_of(std::get<std::string>(value));
  return ratio ? 1.0 / *ratio : 0.0;
}

SectionWithKeys track_section() {
  Keys<Track> keys("track", "The track under wheels with profiles", &Case::track);
  keys.section().of_profiles = true;
  keys.section().on_rail = false;
  keys.add("gauge", &Track::gauge, unit("mm"), between(1.0, 1e4), "Distance between the rails.");
  keys.add("gauge_height", &Track::gauge_height, unit("mm"), between(0.1, 100.0),
           "Depth below the top of the rails where the gauge is measured.");
  keys.add(
      "gauge_face", &Track::gauge_face, unit("mm"), within(1e3), otherwise("found"),
      "y of the gauge face there, on the rail's profile; it also chooses among several heads.");
  keys.add("rail_position", &Track::rail_position, unit("mm"), within(1e4),
           otherwise("from the gauge"),
           "Origin of the rail's profile, from the middle of the track outwards and down.");
  keys.add("rail_stiffness", &Track::rail_stiffness, unit("N/mm"), between(1.0, largest),
           otherwise("the rails stay in place"),
           "Springs without mass under each rail, across and vertical.");
  keys.add("rail_force", &Track::rail_force, unit("N"), within(largest_force), silent_default,
           otherwise("0"),
           "Further force on each rail, to the right and down, with rail_stiffness.");
  keys.add(KeyKind::lean, "inclination",
           Access<Track>{
               [](const Track& track) { return lean_of(track.inclination); },
               [](Track& track, const KeyValue& value) { track.inclination = tangent_of(value); }},
           among({"none"}), within(0.5), example(R"("1:40")"), otherwise("required with profiles"),
           "Inclination towards the middle of the track; `none` if the profile was measured in the "
           "track.");
  return keys;
}

using WheelsetKeys = Keys<Wheelset>;

/// Of a wheelset on a track or, `on_rail`, of a wheel by itself.
WheelsetKeys keys_of(const std::string& name, const std::string& sentence, bool on_rail) {
  WheelsetKeys keys(name, sentence, &Case::wheelset);
  keys.section().of_profiles = true;
  keys.section().on_rail = on_rail;
  return keys;
}

/// The last two lists over the positions, extended to one length by `complete`.
void add_height(WheelsetKeys& keys) {
  keys.add("height", &Wheelset::height, unit("mm"), within(1e3), per("positions"),
           otherwise("the load determines it"),
           "z of the middle of the axle plus wheel.rolling_radius, instead of a load (a result "
           "then): 0 is level with the top of the rails or the profile's z = 0, positive below.");
}

/// Where along the track, and which part of the wheel is below.
void add_way(WheelsetKeys& keys) {
  keys.add("track_position", &Wheelset::track_position, unit("mm"), within(largest),
           per("positions"), otherwise("required if rail or friction change along the track"),
           "Position along the track.");
  keys.add("wheel_angle", &Wheelset::wheel_angle, unit("rad"), within(1e3), per("positions"),
           otherwise("required if the profile changes about the axle"),
           "Angle of the wheel's section that points down; grows in rolling.");
}

/// Lists over the positions of the wheelset.
void add_positions(WheelsetKeys& keys) {
  keys.add(
      "lateral_shift", &Wheelset::lateral_shift, unit("mm"), within(1e3), per("positions"),
      "Lateral shift, positive to the right. Lists (also of yaw and roll) give several positions.");
  keys.add("yaw", &Wheelset::yaw, unit("rad"), within(largest_turn), per("positions"),
           "Yaw, positive from x to y.");
  keys.add("roll", &Wheelset::roll, unit("rad"), within(largest_turn), per("positions"),
           otherwise("both wheels touch their rails"),
           "Roll, positive when the right wheel is lower; each wheel is then lowered onto its rail "
           "separately.");
  add_height(keys);
  add_way(keys);
}

void add_motion(WheelsetKeys& keys, const Choices<FreeRolling>& free,
                const std::string& conditions) {
  keys.add("lateral_velocity", &Wheelset::lateral_velocity, within(1.0),
           "Lateral over forward velocity, positive along y.");
  keys.add("yaw_velocity", &Wheelset::yaw_velocity, unit("rad/mm"), within(1.0),
           "Change of yaw per rolled distance.");
  keys.add("roll_velocity", &Wheelset::roll_velocity, unit("rad/mm"), within(1.0),
           "Change of roll per rolled distance.");
  keys.add("vertical_velocity", &Wheelset::vertical_velocity, within(1.0),
           otherwise("the wheel follows the rail"),
           "Vertical over forward velocity, positive downwards.");
  keys.add("rotation_change", of_each(&Wheelset::rotation_change), within(1.0), otherwise("0"),
           "Relative change of the rotation from V / rolling_radius: positive drives, negative "
           "brakes. A list gives a creep curve.");
  keys.add("free_rolling", &Wheelset::free_rolling, free,
           "Instead of rotation_change: " + conditions);
  keys.add("longitudinal_force", of_each(&Wheelset::longitudinal_force), symbol("F_x"), unit("N"),
           within(largest_force), otherwise("0"),
           "With `force`: force of the rail on each wheel along the way, negative when braking.");
}

const std::string no_force = "`force`: F_x on each wheel is longitudinal_force";

SectionWithKeys wheelset_section() {
  WheelsetKeys keys =
      keys_of("wheelset", "Position and motion of the wheelset on the track, with profiles", false);
  keys.add("side", &Wheelset::side,
           {{"left", WheelSide::left}, {"right", WheelSide::right}, {"both", WheelSide::both}},
           "Wheels to solve; both are always placed on the track.");
  keys.add("flange_back_distance", &Wheelset::flange_back_distance, unit("mm"), within(1e4),
           "Distance between the flange backs (back to back).");
  keys.add("flange_back_position", &Wheelset::flange_back_position, unit("mm"), within(1e3),
           "y of the flange back on the wheel's profile.");
  add_positions(keys);
  add_motion(
      keys,
      {{"none", FreeRolling::none}, {"force", FreeRolling::force}, {"torque", FreeRolling::torque}},
      no_force + "; `torque`: the torque on both is axle_torque.");
  keys.add("axle_torque", of_each(&Wheelset::axle_torque), unit("N mm"), within(largest_force),
           otherwise("0"),
           "With `torque`: torque of the contact forces on both wheels about the axle, positive "
           "when braking.");
  return keys;
}

SectionWithKeys placement_section() {
  WheelsetKeys keys = keys_of("placement",
                              "One wheel in the coordinates of the rail's profile (y to the field, "
                              "z down), instead of [track] and [wheelset]",
                              true);
  keys.add("side", &Wheelset::side, {{"left", WheelSide::left}, {"right", WheelSide::right}},
           "Where the field is, seen along x.");
  keys.add("lateral_position", &Wheelset::lateral_shift, unit("mm"), within(1e4), per("positions"),
           "y of the origin of the wheel's profile. Lists give several poses.");
  add_height(keys);
  keys.add("yaw", &Wheelset::yaw, unit("rad"), within(largest_turn), per("positions"),
           "Yaw, positive from x to y.");
  keys.add("roll", &Wheelset::roll, unit("rad"), within(largest_turn), per("positions"),
           otherwise("0"), "Roll, positive from y to z.");
  add_way(keys);
  add_motion(keys, {{"none", FreeRolling::none}, {"force", FreeRolling::force}}, no_force + ".");
  return keys;
}

SectionWithKeys displacement_section(const std::string& body, Displacement Case::*part,
                                     bool is_wheel) {
  Keys<Displacement> keys(
      body + "_displacement",
      "Displacement of each " + body +
          " from its place, [left, right], in the axes of the track, and its change",
      part);
  keys.section().of_profiles = true;
  keys.section().on_rail = false;
  using Member = Displacement::Sides Displacement::*;
  const auto add = [&](const char* name, Member member, const char* in, double most,
                       const std::string& sentence) {
    keys.add(name, member, unit(in), within(most), silent_default, sentence);
  };
  if (is_wheel) add("longitudinal", &Displacement::longitudinal, "mm", 1e3, "Along x.");
  add("lateral", &Displacement::lateral, "mm", 1e3, "To the right.");
  add("vertical", &Displacement::vertical, "mm", 1e3, "Down.");
  add("roll", &Displacement::roll, "rad", largest_turn, "From y to z, about the profile's origin.");
  if (is_wheel) add("yaw", &Displacement::yaw, "rad", largest_turn, "From x to y.");
  if (is_wheel)
    add("longitudinal_velocity", &Displacement::longitudinal_velocity, "", 1.0,
        "Along x, over the forward velocity.");
  add("lateral_velocity", &Displacement::lateral_velocity, "", 1.0, "The same to the right.");
  add("vertical_velocity", &Displacement::vertical_velocity, "", 1.0,
      "The same down, with wheelset.vertical_velocity.");
  add("roll_velocity", &Displacement::roll_velocity, "rad/mm", 1.0, "Change per rolled distance.");
  if (is_wheel) {
    add("yaw_velocity", &Displacement::yaw_velocity, "rad/mm", 1.0, "Change per rolled distance.");
    add("rotation", &Displacement::rotation, "rad/mm", 1.0,
        "Added to rotation over forward velocity, positive forward.");
  }
  return keys;
}

}  // namespace

Sections track_sections() {
  return {track_section(), wheelset_section(), placement_section(),
          displacement_section("wheel", &Case::wheel_displacement, true),
          displacement_section("rail", &Case::rail_displacement, false)};
}

}  // namespace rollfem::contact
