// SPDX-License-Identifier: LGPL-2.1-or-later
#include "convert/wheel_rail.hpp"

#include "case/track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rollfem::convert {

namespace {

using contact::is_list_of_sections;

void fill_profile(const ProfileFile& profile, const std::string& body,
                  const std::string& profile_folder, Equivalent& made) {
  const auto refuse = [&](bool refused, const std::string& what) {
    made.refuse(refused, fmt::format("profile of the {} '{}': {}", body, profile.name, what));
  };
  const std::string &name = profile.name, details = body + "_profile";
  const bool absolute = !name.empty() && name.front() == '/';
  made.set(body, "profile",
           profile_folder.empty() || absolute ? name : profile_folder + "/" + name);
  if (profile.mirror_y >= 1) made.set(details, "mirror", true);
  if (profile.mirror_z >= 1) made.set(details, "flip", true);
  if (profile.scale == 1000.0 || profile.scale == 25.4)
    made.set(details, "unit", profile.scale == 25.4 ? "inch" : "m");
  else
    refuse(profile.scale != 1.0,
           fmt::format("SCALE = {:g}; allowed: 1 (mm), 25.4 (inch), 1000 (m)", profile.scale));
  made.note(profile.smooth != 0.0 || profile.has_options,
            fmt::format("the profile of the {} is not smoothed as CONTACT does (SMOOTH, PRFOPT), "
                        "whose measure is another one: see {}.smoothing",
                        body, details));
}

bool on_roller(const Digits& digits) {
  return digits.config >= 4;
}

/// Numbers of a displacement, left and right alike.
void fill_displacement(const std::string& section, const std::vector<double>& values,
                       const std::vector<const char*>& keys, Equivalent& made) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (values[k] != 0.0 && *keys[k]) made.set(section, keys[k], {values[k], values[k]});
}

void fill_track(const ContactCase& given, const std::string& profile_folder, Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  const auto& [height, sequence, gauge, last] = pair.track;
  const double cant = on_roller(given.digits) ? 0.0 : last;
  if (on_roller(given.digits)) made.set("rail", "rolling_radius", last, "mm");
  if (height > 0.0) {
    made.refuse(sequence > 1.0,
                fmt::format("GAUGSQ = {:g}: the gauge is always measured at the first gauge point",
                            sequence));
    made.set("track", "gauge", gauge, "mm");
    made.set("track", "gauge_height", height, "mm below the top of the rails");
  } else {
    made.set("track", "rail_position", {sequence, gauge}, "mm, RAILY0 and RAILZ0");
  }
  if (cant == 0.0)
    made.set("track", "inclination", "none");
  else
    made.set("track", "inclination", cant, "rad");
  fill_profile(pair.rail, "rail", profile_folder, made);
  // Files of rollers leave out their flat sides.
  if (on_roller(given.digits)) made.set("rail_profile", "longest_gap", 25.0, "mm");
}

/// Motion of the wheelset by the forward speed, on rollers that of their surface.
struct Forward {
  double speed = 0.0;  ///< mm/s, > 0
  /// A wheelset that rolls backwards is that of the mirror image x to -x, in which yaw, pitch and
  /// the velocity along x change their signs.
  double sign = 1.0;
};

Forward forward_of(const ContactCase& given, Equivalent& made) {
  const double speed = forward_speed(given);
  made.refuse(speed == 0.0 && given.digits.T != 0, "the wheelset does not roll");
  made.note(speed < 0.0, "the wheelset rolls backwards: this is the mirror image x to -x");
  return {speed == 0.0 ? 1.0 : std::abs(speed), speed < 0.0 ? -1.0 : 1.0};
}

/// Rotation of the wheelset by the forward speed, rad/mm.
double rotation_of(const ContactCase& given, const Forward& forward) {
  if (given.digits.F == 1 || given.digits.F == 2) return 1.0 / given.wheel_rail.wheelset[2];
  return -forward.sign * given.wheel_rail.velocity[5] / forward.speed;
}

void fill_motion(const ContactCase& given, const Forward& forward, Equivalent& made) {
  const Digits& digits = given.digits;
  const auto& [vs, vy, vz, vroll, vyaw, vpitch] = given.wheel_rail.velocity;
  const double radius = given.wheel_rail.wheelset[2], speed = forward.speed;
  if (vy != 0.0) made.set("wheelset", "lateral_velocity", vy / speed, "VY / VS");
  if (vyaw != 0.0)
    made.set("wheelset", "yaw_velocity", forward.sign * vyaw / speed, "rad/mm, VYAW / VS");
  if (vroll != 0.0) made.set("wheelset", "roll_velocity", vroll / speed, "rad/mm, VROLL / VS");
  // CONTACT's planes do not climb: where the bodies do, the wheel follows them along x.
  if (vz != 0.0 || !(is_list_of_sections(given.wheel_rail.rail.name) ||
                     is_list_of_sections(given.wheel_rail.wheel.name)))
    made.set("wheelset", "vertical_velocity", vz / speed, "VZ / VS");
  const double change = rotation_of(given, forward) * radius - 1.0;
  const bool by_force = digits.F == 1 || digits.F == 2;
  if (!by_force && made.history())
    made.varied["wheelset.rotation_change"] = change;
  else if (!by_force)
    made.set("wheelset", "rotation_change", change, "-VPITCH NOMRAD / VS - 1");
  if (!by_force) return;
  made.set("wheelset", "free_rolling", digits.F == 1 ? "force" : "torque");
  // Both are on the rail: MY turns the wheel forward.
  if (digits.F == 2)
    made.varied["wheelset.axle_torque"] = forward.sign * vpitch;
  else if (vpitch != 0.0 || made.history())
    made.varied["wheelset.longitudinal_force"] = -forward.sign * vpitch;
}

/// Rails on springs.
void fill_springs(const ContactCase& given, Equivalent& made) {
  if (given.digits.F != 3) return;
  const std::vector<double>& values = given.wheel_rail.springs;
  if (values.empty()) return made.refuse(true, "digit F = 3 without KYRAIL to FZRAIL (digit Z)");
  // With N = 1 the height of the rail has no effect.
  constexpr double rigid = 1e9;
  const bool by_height = given.digits.N == 0;
  made.set("track", "rail_stiffness", {values[0], by_height ? values[2] : rigid},
           "N/mm, KYRAIL and KZRAIL");
  made.set("track", "rail_force", {values[1], by_height ? values[3] : 0.0}, "N, FYRAIL and FZRAIL");
}

/// CONTACT turns a displaced wheel and roller about the axles that they have without displacement,
/// and pitch of a wheel by itself about the origin of its profile; here they turn about their own
/// axles. The difference becomes a velocity of the wheel about the origin of its profile.
void turn_about_own_axles(const ContactCase& given, const Forward& forward,
                          const std::vector<double>& rail, std::vector<double>& wheel) {
  const double turning = rotation_of(given, forward), radius = given.wheel_rail.wheelset[2];
  const double roller = on_roller(given.digits) ? 1.0 / given.wheel_rail.track[3] : 0.0;
  const double sine = std::sin(wheel[4]), cosine = std::cos(wheel[4]);
  const double tilt = roller * (1.0 - std::cos(rail[2]));  // seen from the origin of the rail
  const double pitch = turning + wheel[11] + tilt;
  const double rotation = pitch * cosine / std::cos(wheel[3]);  // about its own axle
  // The velocities of CONTACT are along the axes of the yawed wheelset.
  const double yaw = forward.sign * given.wheel_rail.position[4];
  const double ahead = wheel[6] + radius * (rotation * cosine - turning) - turning * wheel[2];
  const double across = wheel[7] + radius * rotation * sine;
  wheel[6] = std::cos(yaw) * ahead - std::sin(yaw) * across - roller * rail[1];
  if (given.digits.N == 0) wheel[6] -= tilt * given.wheel_rail.position[2];
  wheel[7] = std::sin(yaw) * ahead + std::cos(yaw) * across;
  // With the slip of every place (digit D) CONTACT leaves DX out.
  if (given.wheel_rail.search < 3 || given.wheel_rail.search > 4) wheel[8] += turning * wheel[0];
  wheel[9] -= pitch * sine;
  wheel[10] += rotation * std::sin(wheel[3]) + roller * std::sin(rail[2]);
  wheel[11] = rotation - turning;
}

/// Displacements of wheel and rail by themselves.
void fill_displacements(const ContactCase& given, const Forward& forward, Equivalent& made) {
  std::vector<double> wheel = given.wheel_rail.wheel_deviations,
                      rail = given.wheel_rail.rail_deviations;
  wheel.resize(12);
  rail.resize(6);
  // DX, DYAW, DPITCH, VX, VYAW and VPITCH of the mirror image.
  for (const std::size_t k : {0, 4, 5, 6, 10, 11}) wheel[k] *= forward.sign;
  wheel[11] = -wheel[11];
  const bool moves = given.digits.T != 0;
  for (std::size_t k = 6; k < 12; ++k) wheel[k] *= moves ? 1.0 / forward.speed : 0.0;
  for (std::size_t k = 3; k < 6; ++k) rail[k] *= moves ? 1.0 / forward.speed : 0.0;
  if (moves) turn_about_own_axles(given, forward, rail, wheel);
  fill_displacement(
      "wheel_displacement", wheel,
      {"longitudinal", "lateral", "vertical", "roll", "yaw", "", "longitudinal_velocity",
       "lateral_velocity", "vertical_velocity", "roll_velocity", "yaw_velocity", "rotation"},
      made);
  fill_displacement(
      "rail_displacement", rail,
      {"lateral", "vertical", "roll", "lateral_velocity", "vertical_velocity", "roll_velocity"},
      made);
}

/// Position and motion. CONTACT's track axes are ours: x forward, y to the right, z down.
void fill_wheelset(const ContactCase& given, Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  const auto& [back_distance, back_position, radius] = pair.wheelset;
  const auto& [s, y, vertical, roll, yaw, pitch] = pair.position;
  made.set("wheelset", "side", given.digits.config % 4 == 0 ? "left" : "right");
  made.set("wheelset", "flange_back_distance", back_distance, "mm");
  made.set("wheelset", "flange_back_position", back_position, "mm");
  const Forward forward = forward_of(given, made);
  if (given.digits.N == 0)
    made.varied["wheelset.height"] = vertical;
  else if (made.history())
    made.varied["history.vertical_force"] = vertical;
  else
    made.set("load", "vertical_force", vertical, "N, on this wheel");
  made.varied["wheelset.lateral_shift"] = y;
  if (is_list_of_sections(pair.rail.name)) made.varied["wheelset.track_position"] = s;
  if (is_list_of_sections(pair.wheel.name))
    made.varied["wheelset.wheel_angle"] = -forward.sign * pitch;
  made.varied["wheelset.yaw"] = forward.sign * yaw;
  made.varied["wheelset.roll"] = roll;
  fill_displacements(given, forward, made);
  if (given.digits.T != 0) fill_motion(given, forward, made);
  fill_springs(given, made);
  made.place = forward.sign * s;
  if (!made.history()) return;
  // T = 1 in axes of the track: the wheel moves by VS, its patch by the change of S.
  const bool shifted = given.digits.T == 1;
  made.varied["history.step_length"] = shifted ? forward.speed : pair.step * pair.cell[0];
  if (shifted) made.varied["history.wheel_way"] = forward.speed;
  made.note(shifted, "steps of T = 1: the contact moves by the change of S, the wheel by VS");
  made.problem = "transient";
}

}  // namespace

double forward_speed(const ContactCase& given) {
  const double given_speed = given.wheel_rail.velocity[0];
  return on_roller(given.digits) ? given_speed * given.wheel_rail.track[3] : given_speed;
}

void fill_wheel_rail(const ContactCase& given, const std::string& profile_folder,
                     Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  made.set("wheel", "rolling_radius", pair.wheelset[2], "mm");
  // Body 1 is the rail in this module, but the wheel (upper body) in rollfem and in module 3.
  fill_bodies(given, {"rail", "wheel"}, made);
  fill_profile(pair.wheel, "wheel", profile_folder, made);
  fill_track(given, profile_folder, made);
  fill_wheelset(given, made);
  made.set("contact_grid", "cell_size", {pair.cell[0], pair.cell[1]}, "mm");
  const int D = pair.search;
  made.set("halfspace", "surface", D == 4 ? "curved" : "planar");
  if (given.digits.T != 0) {
    // D = 3 and 4 take the slip of every place.
    if (D != 3 && D != 4) made.set("rolling", "extra_slip", "none");
    made.set("rolling", "upwind_order", "first");
  }
  made.note(D > 4, fmt::format("digit D = {}: contacts are searched for as with D = 2", D));
  made.note(true,
            "DQREL, A_SEP, D_SEP and D_COMB are ignored: contacts share a grid depending on their "
            "angles (docs/track.md)");
  made.note(made.varied["wheelset.yaw"] != 0.0 || made.varied["wheelset.lateral_shift"] != 0.0,
            "creepages are relative to the forward speed; CONTACT divides by the mean of forward "
            "and circumferential speed");
}

}  // namespace rollfem::convert
