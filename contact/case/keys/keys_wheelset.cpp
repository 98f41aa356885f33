// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

using WheelsetKeys = Keys<Wheelset>;

/// Lists over the positions of the wheelset, extended to one length by complete_track.
void add_positions(WheelsetKeys& keys) {
  keys.reals("lateral_shift")
      .unit("mm")
      .within(1e3)
      .per("positions")
      .says(
          "Lateral shift of the wheelset, positive to the right seen along x. A list gives several "
          "positions; lateral_shift, yaw and roll have one length or single numbers.")
      .into(&Wheelset::lateral_shift);
  keys.reals("yaw")
      .unit("rad")
      .within(0.2)
      .per("positions")
      .says("Yaw of the wheelset about the vertical, positive to the right.")
      .into(&Wheelset::yaw);
  keys.reals("roll")
      .unit("rad")
      .within(0.2)
      .per("positions")
      .otherwise("both wheels touch their rails")
      .says(
          "Roll of the wheelset about x, positive when the right wheel is lower; each wheel is "
          "then lowered onto its rail separately.")
      .into(&Wheelset::roll);
  keys.reals("track_position")
      .unit("mm")
      .within(largest)
      .per("positions")
      .otherwise("required with friction.track_position")
      .says("Where along the track the wheelset is.")
      .into(&Wheelset::track_position);
}

void add_motion(WheelsetKeys& keys) {
  keys.real("lateral_velocity")
      .within(1.0)
      .says("Lateral over forward velocity, positive to the right.")
      .into(&Wheelset::lateral_velocity);
  keys.real("yaw_velocity")
      .unit("rad/mm")
      .within(1.0)
      .says("Change of yaw per rolled distance.")
      .into(&Wheelset::yaw_velocity);
  keys.reals("rotation_change")
      .within(1.0)
      .otherwise("0: the wheelset turns with V / rolling_radius")
      .says(
          "Relative change of the rotation from V / rolling_radius: positive drives, negative "
          "brakes. A list gives a creep curve; not with longitudinal_creepage.")
      .into_each(&Wheelset::rotation_change);
  keys.choice("free_rolling")
      .says(
          "Condition instead of rotation_change: `force`: F_x = 0 on each wheel separately; "
          "`torque`: zero torque of both wheels about the axle.")
      .into(&Wheelset::free_rolling, {{"none", FreeRolling::none},
                                      {"force", FreeRolling::force},
                                      {"torque", FreeRolling::torque}});
}

}  // namespace

SectionWithKeys wheelset_section() {
  WheelsetKeys keys("wheelset", "Position and motion of the wheelset on the track, with profiles",
                    &Case::wheelset);
  keys.section().of_profiles = true;
  keys.choice("side")
      .says("Wheels to solve; both are always placed on the track.")
      .into(&Wheelset::side,
            {{"left", WheelSide::left}, {"right", WheelSide::right}, {"both", WheelSide::both}});
  keys.real("flange_back_distance")
      .unit("mm")
      .between(1.0, 1e4)
      .says("Distance between the backs of the two flanges (back to back).")
      .into(&Wheelset::flange_back_distance);
  keys.real("flange_back_position")
      .unit("mm")
      .within(1e3)
      .says("y of the back of the flange in the coordinates of the wheel's profile.")
      .into(&Wheelset::flange_back_position);
  add_positions(keys);
  add_motion(keys);
  return keys;
}

}  // namespace rollfem::contact
