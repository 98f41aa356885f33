// SPDX-License-Identifier: LGPL-2.1-or-later
// The track under wheels with profiles, and their wheelset.
#include "contact/case/case_text.hpp"
#include "contact/case/keys/key_builder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

namespace {

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
  keys.add("gauge", &Track::gauge, unit("mm"), between(1.0, 1e4), "Distance between the rails.");
  keys.add("gauge_height", &Track::gauge_height, unit("mm"), between(0.1, 100.0),
           "Depth below the top of the rails at which the gauge is measured.");
  keys.add("gauge_face", &Track::gauge_face, unit("mm"), within(1e3), otherwise("found"),
           "y of the gauge face at that depth, in the coordinates of the rail's profile; it also "
           "says which of several heads carries the wheel.");
  keys.add(KeyKind::lean, "inclination",
           Access<Track>{
               [](const Track& track) { return lean_of(track.inclination); },
               [](Track& track, const KeyValue& value) { track.inclination = tangent_of(value); }},
           among({"none"}), within(0.5), example(R"("1:40")"), otherwise("required with profiles"),
           "Inclination of the rails towards the middle of the track; `none` also if the rail's "
           "profile was measured in the track.");
  return keys;
}

using WheelsetKeys = Keys<Wheelset>;

/// Lists over the positions of the wheelset, extended to one length by complete_track.
void add_positions(WheelsetKeys& keys) {
  keys.add("lateral_shift", &Wheelset::lateral_shift, unit("mm"), within(1e3), per("positions"),
           "Lateral shift of the wheelset, positive to the right seen along x. A list gives "
           "several positions; lateral_shift, yaw and roll have one length or single numbers.");
  keys.add("yaw", &Wheelset::yaw, unit("rad"), within(0.2), per("positions"),
           "Yaw of the wheelset about the vertical, positive to the right.");
  keys.add("roll", &Wheelset::roll, unit("rad"), within(0.2), per("positions"),
           otherwise("both wheels touch their rails"),
           "Roll of the wheelset about x, positive when the right wheel is lower; each wheel is "
           "then lowered onto its rail separately.");
  keys.add("track_position", &Wheelset::track_position, unit("mm"), within(largest),
           per("positions"), otherwise("required with friction.track_position"),
           "Where along the track the wheelset is.");
}

void add_motion(WheelsetKeys& keys) {
  keys.add("lateral_velocity", &Wheelset::lateral_velocity, within(1.0),
           "Lateral over forward velocity, positive to the right.");
  keys.add("yaw_velocity", &Wheelset::yaw_velocity, unit("rad/mm"), within(1.0),
           "Change of yaw per rolled distance.");
  keys.add("rotation_change", of_each(&Wheelset::rotation_change), within(1.0),
           otherwise("0: the wheelset turns with V / rolling_radius"),
           "Relative change of the rotation from V / rolling_radius: positive drives, negative "
           "brakes. A list gives a creep curve; not with longitudinal_creepage.");
  keys.add(
      "free_rolling", &Wheelset::free_rolling,
      {{"none", FreeRolling::none}, {"force", FreeRolling::force}, {"torque", FreeRolling::torque}},
      "Condition instead of rotation_change: `force`: F_x = 0 on each wheel separately; `torque`: "
      "zero torque of both wheels about the axle.");
}

SectionWithKeys wheelset_section() {
  WheelsetKeys keys("wheelset", "Position and motion of the wheelset on the track, with profiles",
                    &Case::wheelset);
  keys.section().of_profiles = true;
  keys.add("side", &Wheelset::side,
           {{"left", WheelSide::left}, {"right", WheelSide::right}, {"both", WheelSide::both}},
           "Wheels to solve; both are always placed on the track.");
  keys.add("flange_back_distance", &Wheelset::flange_back_distance, unit("mm"), between(1.0, 1e4),
           "Distance between the backs of the two flanges (back to back).");
  keys.add("flange_back_position", &Wheelset::flange_back_position, unit("mm"), within(1e3),
           "y of the back of the flange in the coordinates of the wheel's profile.");
  add_positions(keys);
  add_motion(keys);
  return keys;
}

}  // namespace

Sections track_sections() {
  return {track_section(), wheelset_section()};
}

}  // namespace rollfem::contact
