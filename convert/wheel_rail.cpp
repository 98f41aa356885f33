// SPDX-License-Identifier: LGPL-2.1-or-later
// Module 1: wheel and rail with profiles.
#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>

namespace rollfem::convert {

namespace {

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

void fill_profile(const ProfileFile& profile, const std::string& body,
                  const std::string& profile_folder, Equivalent& made) {
  const auto refuse = [&](bool refused, const std::string& what) {
    made.refuse(refused, fmt::format("profile of the {} '{}': {}", body, profile.name, what));
  };
  const std::string &name = profile.name, details = body + "_profile";
  const bool absolute = !name.empty() && name.front() == '/';
  made.set_word(body, "profile",
                profile_folder.empty() || absolute ? name : profile_folder + "/" + name);
  if (profile.mirror_y >= 1) made.fixed[details].push_back("mirror = true");
  if (profile.mirror_z >= 1) made.fixed[details].push_back("flip = true");
  if (profile.scale == 1000.0 || profile.scale == 25.4)
    made.set_word(details, "unit", profile.scale == 25.4 ? "inch" : "m");
  else
    refuse(profile.scale != 1.0,
           fmt::format("SCALE = {:g}; allowed: 1 (mm), 25.4 (inch), 1000 (m)", profile.scale));
  refuse(profile.smooth != 0.0 || profile.has_options,
         "smoothing by CONTACT's spline (SMOOTH, PRFOPT); set it to 0 and use "
         "wheel_profile.smoothing or rail_profile.smoothing");
  refuse(name.size() > 5 && name.substr(name.size() - 5) == ".slcs",
         "profiles that vary along the track");
}

void fill_track(const WheelRail& pair, const std::string& profile_folder, Equivalent& made) {
  const auto& [height, sequence, gauge, cant] = pair.track;
  made.refuse(height <= 0.0, "GAUGHT <= 0: a rail placed by RAILY0, RAILZ0 instead of the gauge");
  made.refuse(height > 0.0 && sequence > 1.0,
              fmt::format("GAUGSQ = {:g}: the gauge is always measured at the first gauge point",
                          sequence));
  made.refuse(any(pair.rail_deviations), "DY to VROLL: a displaced or moving rail");
  made.set("track", "gauge", gauge, "mm");
  made.set("track", "gauge_height", height, "mm below the top of the rails");
  if (cant == 0.0)
    made.set_word("track", "inclination", "none");
  else
    made.set("track", "inclination", cant, "rad");
  fill_profile(pair.rail, "rail", profile_folder, made);
}

/// Position and motion. CONTACT's track axes are ours: x forward, y to the right, z down.
void fill_wheelset(const ContactCase& given, Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  const Digits& digits = given.digits;
  const auto& [back_distance, back_position, radius] = pair.wheelset;
  const auto& [s, y, vertical, roll, yaw, pitch] = pair.position;
  const auto& [vs, vy, vz, vroll, vyaw, vpitch] = pair.velocity;
  made.refuse(digits.N == 0,
              "digit N = 0: a prescribed height of the wheelset instead of its load");
  made.refuse(any(pair.wheel_deviations), "digit E >= 4: a flexible wheelset");
  made.set_word("wheelset", "side", digits.config == 0 ? "left" : "right");
  made.set("wheelset", "flange_back_distance", back_distance, "mm");
  made.set("wheelset", "flange_back_position", back_position, "mm");
  made.set("load", "vertical_force", vertical, "N, on this wheel");
  made.varied["wheelset.lateral_shift"] = y;
  made.varied["wheelset.yaw"] = yaw;
  made.varied["wheelset.roll"] = roll;
  if (digits.T == 0) return;
  made.refuse(vs <= 0.0, "VS is not positive: the wheelset must roll forward");
  if (vs <= 0.0) return;
  made.refuse(vz != 0.0 || vroll != 0.0, "VZ, VROLL: a wheelset with a vertical or roll velocity");
  if (vy != 0.0) made.set("wheelset", "lateral_velocity", vy / vs, "VY / VS");
  if (vyaw != 0.0) made.set("wheelset", "yaw_velocity", vyaw / vs, "rad/mm, VYAW / VS");
  if (digits.F == 0)
    made.set("wheelset", "rotation_change", -vpitch * radius / vs - 1.0, "-VPITCH NOMRAD / VS - 1");
  else if (digits.F == 1 && vpitch == 0.0)
    made.set_word("wheelset", "free_rolling", "force");
  else
    made.refuse(true, fmt::format("digit F = {}: a prescribed force or moment on the wheel other "
                                  "than zero force",
                                  digits.F));
}

}  // namespace

void fill_wheel_rail(const ContactCase& given, const std::string& profile_folder,
                     Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  made.refuse(given.digits.config > 1,
              fmt::format("digit C1 = {}: a roller rig", given.digits.config));
  made.set("wheel", "rolling_radius", pair.wheelset[2], "mm");
  // Body 1 is the rail in this module, but the wheel (upper body) in rollfem and in module 3.
  fill_bodies(given.bodies, {"rail", "wheel"}, made);
  fill_profile(pair.wheel, "wheel", profile_folder, made);
  fill_track(pair, profile_folder, made);
  fill_wheelset(given, made);
  made.set_list("contact_grid", "cell_size", {pair.cell[0], pair.cell[1]}, "mm, DX and DS");
  const int D = pair.search;
  made.set_word("halfspace", "surface", D == 4 ? "curved" : "planar");
  if (given.digits.T != 0) {
    // D = 3 and 4 take the slip of every place.
    if (D != 3 && D != 4) made.set_word("rolling", "extra_slip", "none");
    made.set_word("rolling", "upwind_order", "first");
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
