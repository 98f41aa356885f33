// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/checks/case_rules.hpp"

namespace rollfem::contact {

namespace {

// Conditions of the rules.

bool has(const GivenCase& given, const char* section, const char* name) {
  return given.find(section, name) != nullptr;
}

std::string problem_of(const GivenCase& given) {
  return word_of(given, "rolling", "problem", "steady");
}
bool shift(const GivenCase& given) {
  return problem_of(given) == "shift";
}
bool transient(const GivenCase& given) {
  return problem_of(given) == "transient";
}
bool frictionless(const GivenCase& given) {
  return problem_of(given) == "frictionless";
}
bool has_steps(const GivenCase& given) {
  return shift(given) || transient(given);
}
bool no_steps(const GivenCase& given) {
  return !has_steps(given);
}
bool nothing_slides_on(const GivenCase& given) {
  return shift(given) || frictionless(given);
}
bool is_point(const GivenCase& given) {
  return !is_line(given);
}
bool no_profiles(const GivenCase& given) {
  return !has_profiles(given);
}
bool only_wheel(const GivenCase& given) {
  return !has(given, "rail", "profile");
}
bool only_rail(const GivenCase& given) {
  return !has(given, "wheel", "profile");
}
bool given_pressure(const GivenCase& given) {
  return has(given, "given_pressure", "semi_axis_x") ||
         has(given, "given_pressure", "semi_axis_y") ||
         has(given, "given_pressure", "max_pressure");
}
bool profiles_pressed(const GivenCase& given) {
  return has_profiles(given) && !given_pressure(given);
}
bool radii_pressed(const GivenCase& given) {
  return no_profiles(given) && !given_pressure(given);
}
bool slip_from_file(const GivenCase& given) {
  return word_of(given, "rolling", "extra_slip", "auto") == "file";
}
bool no_slip_from_file(const GivenCase& given) {
  return !slip_from_file(given);
}
bool slip_file_missing(const GivenCase& given) {
  return slip_from_file(given) && !has(given, "rolling", "extra_slip_file");
}
bool slip_file_useless(const GivenCase& given) {
  return slip_from_file(given) && nothing_slides_on(given);
}
bool own_mesh(const GivenCase& given) {
  return has(given, "wheel", "mesh") || has(given, "rail", "mesh");
}
bool torque_of_one(const GivenCase& given) {
  return word_of(given, "wheelset", "free_rolling", "none") == "torque" &&
         word_of(given, "wheelset", "side", "") != "both";
}

constexpr const char* no_extent = "applies to contacts of finite width, but geometry.shape is line";
constexpr const char* rollers =
    "line contact of rollers under a prescribed force, rolling straight ahead";

}  // namespace

const std::vector<Exclusion>& exclusions_of_shapes() {
  static const std::vector<Exclusion> all{
      {is_point,
       {"geometry.width", "geometry.relative_radius", "geometry.reference_distance"},
       "applies to line contact, but geometry.shape is point",
       "with shape = \"line\"",
       "write `shape = \"line\"` under [geometry], or remove it"},
      {is_line,
       {"*.transverse_radius", "*.profile", "undeformed_distance.*"},
       no_extent,
       rollers,
       "remove it; the radius of a line contact is geometry.relative_radius"},
      {is_line,
       {"*.approach"},
       "does not determine the force, because half-planes have no finite approach",
       rollers,
       "give normal_force, the force in N on geometry.width"},
      {is_line,
       {"rolling.spin", "history.spin_shift"},
       "is a rotation about the normal, which endless rollers do not allow",
       rollers,
       "remove it, or geometry.shape"},
      {is_line,
       {"given_pressure.*", "rolling.extra_slip_file", "halfspace.surface"},
       no_extent,
       rollers,
       "remove it, or geometry.shape"},
      {is_line,
       {"halfspace.model_error"},
       "needs bodies of finite width, but geometry.shape is line",
       rollers,
       "remove it, or geometry.shape"},
      {no_profiles,
       {"load.vertical_force"},
       "is for wheels and rails with profiles, but this case has none",
       "profiles of both bodies, or radii without it",
       "write `normal_force` instead, or give wheel.profile and rail.profile"},
      {no_profiles,
       {"track.*", "wheelset.*"},
       "places profiles on a track, but this case has none",
       "profiles of both bodies, or radii without it",
       "give wheel.profile and rail.profile, or remove it",
       true},
      {only_wheel,
       {"wheel.profile"},
       "is given alone: rail.profile is missing",
       "profiles of both bodies, or of none",
       "add `profile = \"60E1\"` under [rail]; \"arcs\" builds one from radii"},
      {only_rail,
       {"rail.profile"},
       "is given alone: wheel.profile is missing",
       "profiles of both bodies, or of none",
       "add `profile = \"S1002\"` under [wheel]; \"arcs\" builds one from radii"},
      {torque_of_one,
       {"wheelset.free_rolling"},
       "needs both wheels, because their forces balance each other",
       "\"torque\" with side = \"both\", or \"force\" for each wheel separately",
       "write `side = \"both\"` under [wheelset]"},
      {has_steps,
       {"wheelset.free_rolling"},
       "is for steady rolling, and rolling.problem is {problem}",
       "free rolling with the problem steady",
       "remove it"}};
  return all;
}

const std::vector<Exclusion>& exclusions_of_problems() {
  static const std::vector<Exclusion> all{
      {given_pressure,
       {"load.approach", "load.vertical_force", "history.normal_force", "history.approach"},
       "does not go together with [given_pressure]",
       "exactly one of load.normal_force and given_pressure.max_pressure",
       "remove one of the two"},
      {frictionless,
       {"rolling.*_force"},
       "is not possible without friction",
       "a force with the problems steady, shift, transient",
       "remove it, or choose another rolling.problem"},
      {shift,
       {"rolling.*_creepage", "rolling.spin"},
       "has no meaning without rolling (problem shift)",
       "shifts or forces with the problem shift",
       "give longitudinal_shift, lateral_shift or spin_shift under [history]"},
      {frictionless,
       {"rolling.*_creepage", "rolling.spin"},
       "has no effect without friction (problem frictionless)",
       "creepages with the problems steady and transient",
       "remove it, or choose `problem = \"steady\"`"},
      {no_steps,
       {"history.*"},
       "is a step of a history, but rolling.problem is {problem}",
       "[history] with the problems shift and transient",
       "write `problem = \"shift\"` or `problem = \"transient\"` under [rolling], or remove "
       "[history]"},
      {transient,
       {"history.*_shift"},
       "belongs to the problem shift, but here the bodies roll",
       "creepages and step_length with the problem transient",
       "give the creepage under [rolling], or choose `problem = \"shift\"`"},
      {shift,
       {"history.step_length", "history.start"},
       "belongs to the problem transient, but here nothing rolls",
       "shifts with the problem shift",
       "remove it, or choose `problem = \"transient\"`"},
      {no_slip_from_file,
       {"rolling.extra_slip_file"},
       "is not used, because extra_slip is {slip}",
       "a file with extra_slip = \"file\"",
       "write `extra_slip = \"file\"`, or remove the file"},
      {slip_file_useless,
       {"rolling.extra_slip"},
       "has no meaning with the problem {problem}",
       "\"none\", or the problems steady and transient",
       "remove it"},
      {slip_file_missing,
       {"rolling.extra_slip"},
       "names no file",
       "`file` with extra_slip_file",
       "add `extra_slip_file = \"slip.csv\"` under [rolling]"},
      // A given mesh is clamped at its group `fixed`, which need not enclose it.
      {own_mesh,
       {"fem.far_boundary"},
       "applies to segments meshed by rollfem, but this case provides a mesh",
       "\"clamped\"",
       "remove fem.far_boundary, or the mesh"}};
  return all;
}

const std::vector<Rivals>& rivals() {
  static const char* const shape = "either a profile or what replaces the shapes, not both";
  static const char* const along_x = ", which also determines the creepage along x";
  static const char* const one_along_x =
      "at most one of free_rolling, rotation_change, longitudinal_creepage and longitudinal_force";
  static const std::vector<Rivals> all{
      {{"wheel.transverse_radius", "wheel.profile"},
       "",
       "exactly one of profile and transverse_radius"},
      {{"rail.transverse_radius", "rail.profile"},
       "",
       "exactly one of profile and transverse_radius"},
      {{"wheel.round_to", "wheel.profile"}, "", "exactly one of profile and round_to"},
      {{"rail.round_to", "rail.profile"}, "", "exactly one of profile and round_to"},
      {{"undeformed_distance.quadratic", "undeformed_distance.file"},
       "",
       "at most one of quadratic and file"},
      {{"undeformed_distance.*", "wheel.profile"}, "", shape},
      {{"given_pressure.*", "wheel.profile"}, "", shape},
      {{"given_pressure.*", "undeformed_distance.*"}, "", "at most one of the two sections"},
      {{"wheelset.free_rolling", "wheelset.rotation_change", "rolling.longitudinal_creepage"},
       along_x,
       one_along_x},
      {{"wheelset.free_rolling", "wheelset.rotation_change", "rolling.longitudinal_force"},
       along_x,
       one_along_x},
      {{"rolling.longitudinal_creepage", "rolling.longitudinal_force"}, along_x, one_along_x, true},
      {{"rolling.lateral_creepage", "rolling.lateral_force"},
       ", which follows from the force",
       "at most one of lateral_force and lateral_creepage",
       true},
      {{"history.longitudinal_shift", "rolling.longitudinal_force"},
       ", which follows from the force",
       "at most one of longitudinal_force and longitudinal_shift",
       true},
      {{"history.lateral_shift", "rolling.lateral_force"},
       ", which follows from the force",
       "at most one of lateral_force and lateral_shift",
       true},
      {{"load.normal_force", "load.approach", "load.vertical_force", "given_pressure.max_pressure",
        "history.normal_force", "history.approach"},
       "",
       "exactly one of normal_force, approach and vertical_force; where the pressure is given, of "
       "normal_force and max_pressure"},
      {{"friction.kinetic_coefficient", "friction.polach_a"},
       "",
       "at most one of kinetic_coefficient and polach_a"},
      {{"friction.half_velocity", "friction.polach_b"},
       "",
       "at most one of half_velocity and polach_b"},
      {{"friction.inclination", "friction.track_position", "friction.lateral_position"},
       "",
       "at most one of inclination, track_position and lateral_position"},
      {{"contact_grid.elements_across", "contact_grid.cell_size"},
       "",
       "at most one of elements_across and cell_size"}};
  return all;
}

const std::vector<Need>& needs() {
  static const std::vector<Need> all{
      {is_line,
       {"geometry.relative_radius", "wheel.rolling_radius"},
       "is missing, and wheel.rolling_radius too",
       "one of them: a line contact needs a radius along rolling",
       "add `relative_radius = 405.0` under [geometry]"},
      {has_profiles,
       {"track.inclination"},
       "is missing",
       "\"none\", \"1:20\", \"1:40\", any other ratio, or an angle in rad; there is no default, "
       "because it moves the contact",
       "add `inclination = \"1:40\"` under [track]"},
      {given_pressure,
       {"load.normal_force", "given_pressure.max_pressure"},
       "is missing, and given_pressure.max_pressure too",
       "exactly one of load.normal_force and given_pressure.max_pressure",
       "add `normal_force = 50e3` under [load]"},
      {profiles_pressed,
       {"load.normal_force", "load.approach", "load.vertical_force", "history.normal_force",
        "history.approach"},
       "is missing, and load.approach too",
       "exactly one of normal_force, approach and vertical_force",
       "add `vertical_force = 50e3` under [load]"},
      {radii_pressed,
       {"load.normal_force", "load.approach", "history.normal_force", "history.approach"},
       "is missing, and load.approach too",
       "exactly one of normal_force and approach",
       "add `normal_force = 50e3` under [load]"},
      {transient,
       {"history.step_length"},
       "is missing",
       "with the problem transient, the distance rolled in each step, in mm",
       "add `step_length = 0.1` under [history]"},
      {given_pressure,
       {"given_pressure.semi_axis_x"},
       "is missing",
       "both semi-axes of the ellipse in mm",
       "add `semi_axis_x = 5.0` under [given_pressure]"},
      {given_pressure,
       {"given_pressure.semi_axis_y"},
       "is missing",
       "both semi-axes of the ellipse in mm",
       "add `semi_axis_y = 5.0` under [given_pressure]"}};
  return all;
}

}  // namespace rollfem::contact
