// Module 1: a wheel with its profile on a rail with its own.
#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::convert {

namespace {

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

void fill_profile(const ProfileFile& profile, const std::string& body,
                  const std::string& profile_folder, Equivalent& made) {
  const auto refuse = [&](const std::string& what) {
    made.impossible.push_back(fmt::format("profile of the {} '{}': {}", body, profile.name, what));
  };
  const bool absolute = !profile.name.empty() && profile.name.front() == '/';
  made.set_word(
      body, "profile",
      profile_folder.empty() || absolute ? profile.name : profile_folder + "/" + profile.name);
  const std::string details = body + "_profile";
  if (profile.mirror_y >= 1) made.fixed[details].push_back("mirror = true");
  if (profile.mirror_z >= 1) made.fixed[details].push_back("flip = true");
  if (profile.scale == 1000.0)
    made.set_word(details, "unit", "m");
  else if (profile.scale == 25.4)
    made.set_word(details, "unit", "inch");
  else if (profile.scale != 1.0)
    refuse(fmt::format("SCALE = {:g}; allowed: 1 (mm), 25.4 (inch), 1000 (m)", profile.scale));
  if (profile.smooth != 0.0 || profile.has_options)
    refuse(
        "smoothing by CONTACT's spline (SMOOTH, PRFOPT); set it to 0 and use "
        "wheel_profile.smoothing or rail_profile.smoothing");
  if (profile.name.size() > 5 && profile.name.substr(profile.name.size() - 5) == ".slcs")
    refuse("profiles that vary along the track");
}

void fill_track(const WheelRail& pair, const std::string& profile_folder, Equivalent& made) {
  if (pair.gauge_height <= 0.0)
    made.impossible.push_back("GAUGHT <= 0: a rail placed by RAILY0, RAILZ0 instead of the gauge");
  if (pair.gauge_sequence > 1.0)
    made.impossible.push_back(
        fmt::format("GAUGSQ = {:g}: the gauge is always measured at the first gauge point",
                    pair.gauge_sequence));
  if (any(pair.rail_deviations))
    made.impossible.push_back("DY to VROLL: a displaced or moving rail");
  made.set("track", "gauge", pair.gauge, "mm");
  made.set("track", "gauge_height", pair.gauge_height, "mm below the top of the rails");
  if (pair.cant == 0.0)
    made.set_word("track", "inclination", "none");
  else
    made.set("track", "inclination", pair.cant, "rad");
  fill_profile(pair.rail, "rail", profile_folder, made);
}

/// Position and motion. CONTACT's track axes are ours: x forward, y to the right, z down.
void fill_wheelset(const ContactCase& given, Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  const auto& [s, y, vertical, roll, yaw, pitch] = pair.position;
  const auto& [vs, vy, vz, vroll, vyaw, vpitch] = pair.velocity;
  const auto refuse = [&](const std::string& what) { made.impossible.push_back(what); };
  if (given.digits.N == 0)
    refuse("digit N = 0: a prescribed height of the wheelset instead of its load");
  if (any(pair.wheel_deviations)) refuse("digit E >= 4: a flexible wheelset");
  made.set_word("wheelset", "side", given.digits.config == 0 ? "left" : "right");
  made.set("wheelset", "flange_back_distance", pair.flange_back_distance, "mm");
  made.set("wheelset", "flange_back_position", pair.flange_back_position, "mm");
  made.set("load", "vertical_force", vertical, "N, on this wheel");
  made.varied["wheelset.lateral_shift"] = y;
  made.varied["wheelset.yaw"] = yaw;
  made.varied["wheelset.roll"] = roll;
  if (given.digits.T == 0) return;
  if (vs <= 0.0) return refuse("VS is not positive: the wheelset must roll forward");
  if (vz != 0.0 || vroll != 0.0) refuse("VZ, VROLL: a wheelset with a vertical or roll velocity");
  if (vy != 0.0) made.set("wheelset", "lateral_velocity", vy / vs, "VY / VS");
  if (vyaw != 0.0) made.set("wheelset", "yaw_velocity", vyaw / vs, "rad/mm, VYAW / VS");
  if (given.digits.F == 0)
    made.set("wheelset", "rotation_change", -vpitch * pair.nominal_radius / vs - 1.0,
             "-VPITCH NOMRAD / VS - 1");
  else if (given.digits.F == 1 && vpitch == 0.0)
    made.set_word("wheelset", "free_rolling", "force");
  else
    refuse(
        fmt::format("digit F = {}: a prescribed force or moment on the wheel other than zero force",
                    given.digits.F));
}

}  // namespace

void fill_wheel_rail(const ContactCase& given, const std::string& profile_folder,
                     Equivalent& made) {
  const WheelRail& pair = given.wheel_rail;
  if (given.digits.config > 1)
    made.impossible.push_back(fmt::format("digit C1 = {}: a roller rig", given.digits.config));
  // Body 1 of this module is the rail, of ours (and of module 3) the upper one, the wheel.
  const std::array<const char*, 2> sections{"rail", "wheel"};
  made.set("wheel", "rolling_radius", pair.nominal_radius, "mm");
  for (std::size_t body = 0; body < 2; ++body) {
    const double nu = given.bodies.poisson[body], G = given.bodies.shear_modulus[body];
    made.set(sections[body], "young_modulus", 2.0 * G * (1.0 + nu),
             fmt::format("MPa, G = {:g}", G));
    made.set(sections[body], "poisson_ratio", nu);
  }
  fill_profile(pair.wheel, "wheel", profile_folder, made);
  fill_track(pair, profile_folder, made);
  fill_wheelset(given, made);
  made.set_pair("contact_grid", "cell_size", pair.dx, pair.ds, "mm, DX and DS");
  made.set_word("halfspace", "surface", "planar");
  if (given.digits.T != 0) {
    made.set_word("rolling", "extra_slip", "none");
    made.set_word("rolling", "upwind_order", "first");
  }
  made.notes.push_back(
      "DQREL, A_SEP, D_SEP and D_COMB are ignored: contacts share a grid depending on their angles "
      "(docs/track.md)");
  if (made.varied["wheelset.yaw"] != 0.0 || made.varied["wheelset.lateral_shift"] != 0.0)
    made.notes.push_back(
        "creepages are relative to the forward speed; CONTACT divides by the mean of forward and "
        "circumferential speed");
}

}  // namespace rollfem::convert
