// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables of dependencies between keys, and the check of a case against them.
#include "case/checks/case_rules.hpp"

#include "case/checks/case_needs.hpp"
#include "case/keys/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Alternative keys: at most one of them is allowed.
struct Rivals {
  std::vector<const char*> keys;
  const char* why;  ///< added to "contradicts ..."; may be empty
  const char* allowed;
  bool by_point = false;  ///< a list with nan leaves these load points to the other key
};

constexpr const char* no_extent = "applies to contacts of finite width, but geometry.shape is line";
constexpr const char* is_rigid = "belongs to a rigid body, which is not meshed";
constexpr const char* elastic = "a body with a finite young_modulus";
constexpr const char* make_elastic = "remove it, or give a finite young_modulus";
constexpr const char* rollers = "line contact of rollers, rolling straight ahead";

constexpr const char* of_falling =
    "is of friction that falls with the slip velocity, but friction.law is {law}";
constexpr const char* make_falling = "write `law = \"exponential\"` under [friction], or remove it";

constexpr const char* shape = "either a profile or what replaces the shapes, not both";
constexpr const char* along_x = ", which also determines the creepage along x";
constexpr const char* one_along_x =
    "at most one of free_rolling, rotation_change, longitudinal_creepage and longitudinal_force";

const std::vector<Exclusion> exclusions{
    {!when::line,
     {"geometry.width", "geometry.relative_radius", "geometry.reference_distance"},
     "applies to line contact, but geometry.shape is point",
     "with shape = \"line\"",
     "write `shape = \"line\"` under [geometry], or remove it"},
    {when::line,
     {"*.transverse_radius", "*.profile", "undeformed_distance.*"},
     no_extent,
     rollers,
     "remove it; the radius of a line contact is geometry.relative_radius"},
    {when::line,
     {"rolling.spin", "history.spin_shift"},
     "is a rotation about the normal, which endless rollers do not allow",
     rollers,
     "remove it, or geometry.shape"},
    {when::line,
     {"given_pressure.*", "rolling.extra_slip_file"},
     no_extent,
     rollers,
     "remove it, or geometry.shape"},
    {when::rigid("wheel"), {"wheel.mesh", "wheel_plasticity.*"}, is_rigid, elastic, make_elastic},
    {when::rigid("rail"), {"rail.mesh", "rail_plasticity.*"}, is_rigid, elastic, make_elastic},
    {when::off("output", "fields"),
     {"output.body_fields"},
     "has no effect, because output.fields is false",
     "with fields = true",
     "remove one of the two"},
    {when::transient || when::given_pressure || when::line || when::own_mesh,
     {"wheel_plasticity.*", "rail_plasticity.*"},
     "is for steady rolling, or pressing in steps, of bodies of finite width, meshed by rollfem, "
     "under a contact that is found",
     "rolling.problem steady, frictionless or shift, with radii or profiles",
     "remove the section, or what it does not go with"},
    {!when::heat && !when::by_temperature,
     {"wheel_plasticity.hot_temperature", "rail_plasticity.hot_temperature"},
     "has no effect, because the surfaces have no temperature",
     "with [wheel_heat] or [rail_heat], or friction.law \"temperature\"",
     "add `temperature = 20.0` under [rail_heat], or remove it"},
    {when::shift || when::frictionless,
     {"wheel_heat.*", "rail_heat.*"},
     "is of the temperature while rolling, but the problem is {problem}",
     "with the problems steady and transient",
     "remove the section, or choose one of these problems"},
    {!when::profiles,
     {"load.vertical_force", "history.vertical_force"},
     "is for wheels and rails with profiles, but this case has none",
     "profiles of both bodies, or radii without it",
     "write `normal_force` instead, or give wheel.profile and rail.profile"},
    {when::profiles || when::has("undeformed_distance", "file"),
     {"load.max_pressure"},
     "is that of Hertz's ellipse or line, but the shapes of this case are not circles",
     "with radii, undeformed_distance.quadratic or geometry.shape = \"line\"",
     "give a force or an approach instead"},
    {!when::profiles,
     {"track.*", "wheelset.*", "placement.*", "wheel_displacement.*", "rail_displacement.*"},
     "places profiles, but this case has none",
     "profiles of both bodies, or radii without it",
     "give wheel.profile and rail.profile, or remove it",
     true},
    {!when::profiles,
     {"wheel_flat.*", "wheel_polygon.*", "rail_corrugation.*", "rail_dip.*"},
     "changes a profile along the way, but this case has none",
     "profiles of both bodies; \"arcs\" builds them from radii",
     "give wheel.profile and rail.profile, or remove it",
     true},
    {when::rounded_flat,
     {"wheel_flat.edge_radius"},
     "is of the ends of a chord, but this flat is rounded",
     "with shape = \"chord\"",
     "remove it, or choose `shape = \"chord\"`"},
    {when::placement,
     {"track.*", "wheelset.*", "wheel_displacement.*", "rail_displacement.*"},
     "is of a wheelset on a track, but [placement] gives the pose of a wheel on the rail",
     "[placement] alone, or [track] and [wheelset]",
     "remove it, or [placement]",
     true},
    {!when::has("wheelset", "vertical_velocity"),
     {"wheel_displacement.vertical_velocity", "rail_displacement.vertical_velocity"},
     "has no effect, because the wheel follows its rail at any vertical velocity",
     "together with wheelset.vertical_velocity, with which it does not",
     "give the vertical_velocity of the wheelset too, or remove it"},
    {when::profiles && !when::placement && !when::has("track", "rail_position") &&
         !when::has("track", "gauge_face"),
     {"rail_profile.free_ends"},
     "leaves no gauge face to be found, because the profile ends where the side face begins",
     "with [placement], track.rail_position or track.gauge_face",
     "say where the rail is by one of these"},
    {!when::rail_profile,
     {"wheel.profile"},
     "is given alone: rail.profile is missing",
     "profiles of both bodies, or of none",
     "add `profile = \"60E1\"` under [rail]; \"arcs\" builds one from radii"},
    {!when::wheel_profile,
     {"rail.profile"},
     "is given alone: wheel.profile is missing",
     "profiles of both bodies, or of none",
     "add `profile = \"S1002\"` under [wheel]; \"arcs\" builds one from radii"},
    {when::torque_of_one && !when::has("wheelset", "axle_torque"),
     {"wheelset.free_rolling"},
     "needs both wheels, because their forces balance each other",
     "\"torque\" with side = \"both\", or \"force\" for each wheel separately",
     "write `side = \"both\"` under [wheelset]"},
    {when::shift,
     {"*.free_rolling"},
     "is for rolling, and rolling.problem is {problem}",
     "free rolling with the problems steady and transient",
     "remove it"},
    {when::transient && when::has("track", "rail_stiffness"),
     {"*.free_rolling"},
     "is not possible in a history of a rail on springs",
     "either of both, or the problem steady",
     "give rotation_change instead"},
    {when::given_pressure,
     {"load.approach", "load.vertical_force", "load.max_pressure", "history.normal_force",
      "history.approach"},
     "does not go together with [given_pressure]",
     "exactly one of load.normal_force and given_pressure.max_pressure",
     "remove one of the two"},
    {when::has("history", "time") && !when::has("rolling", "speed"),
     {"history.time"},
     "says how far the wheel rolls only at a speed",
     "together with rolling.speed, or step_length instead",
     "add `speed = 10e3` under [rolling]"},
    {when::is("wheelset", "side", "both"),
     {"track.rail_stiffness"},
     "is of one wheel on its rail, but wheelset.side is both",
     "with side = \"left\" or \"right\"",
     "give one side"},
    {!when::has("track", "rail_stiffness"),
     {"track.rail_force"},
     "is on rails that give way, but track.rail_stiffness is not given",
     "together with rail_stiffness",
     "add `rail_stiffness = [1e4, 1e4]` under [track], or remove it"},
    {!when::is("wheelset", "free_rolling", "force") &&
         !when::is("placement", "free_rolling", "force"),
     {"wheelset.longitudinal_force", "placement.longitudinal_force"},
     "is the force for which a rotation is sought, but free_rolling is not `force`",
     "with free_rolling = \"force\"",
     "add `free_rolling = \"force\"`, or remove it"},
    {!when::is("wheelset", "free_rolling", "torque"),
     {"wheelset.axle_torque"},
     "is the torque for which a rotation is sought, but free_rolling is not `torque`",
     "with free_rolling = \"torque\"",
     "add `free_rolling = \"torque\"`, or remove it"},
    {when::has("history", "motion") && when::is("history", "motion", "positions"),
     {"*.lateral_velocity", "wheelset.yaw_velocity", "placement.yaw_velocity",
      "wheelset.roll_velocity", "placement.roll_velocity"},
     "is the difference of the positions, because history.motion is positions",
     "with motion = \"velocities\"",
     "remove one of the two"},
    {when::frictionless,
     {"rolling.*_force"},
     "is not possible without friction",
     "a force with the problems steady, shift, transient",
     "remove it, or choose another rolling.problem"},
    {when::frictionless,
     {"*.free_rolling"},
     "has no effect without friction (problem frictionless)",
     "free rolling with the problem steady",
     "remove it, or choose `problem = \"steady\"`"},
    {when::shift,
     {"rolling.*_creepage", "rolling.spin"},
     "has no meaning without rolling (problem shift)",
     "shifts or forces with the problem shift",
     "give longitudinal_shift, lateral_shift or spin_shift under [history]"},
    {when::frictionless,
     {"rolling.*_creepage", "rolling.spin"},
     "has no effect without friction (problem frictionless)",
     "creepages with the problems steady and transient",
     "remove it, or choose `problem = \"steady\"`"},
    {!(when::steps || when::frictionless),
     {"history.*"},
     "is a step of a history, but rolling.problem is {problem}",
     "[history] with the problems shift, transient and frictionless",
     "write `problem = \"shift\"` or `problem = \"transient\"` under [rolling], or remove "
     "[history]"},
    {when::frictionless,
     {"history.*_shift"},
     "has no effect without friction (problem frictionless)",
     "shifts with the problem shift",
     "remove it, or choose `problem = \"shift\"`"},
    {when::transient,
     {"history.*_shift"},
     "belongs to the problem shift, but here the bodies roll",
     "creepages and step_length with the problem transient",
     "give the creepage under [rolling], or choose `problem = \"shift\"`"},
    {when::shift || when::frictionless,
     {"history.step_length", "history.start", "history.time", "history.wheel_way"},
     "belongs to the problem transient, but here nothing rolls",
     "shifts with the problem shift",
     "remove it, or choose `problem = \"transient\"`"},
    {!when::slip_from_file,
     {"rolling.extra_slip_file"},
     "is not used, because extra_slip is {slip}",
     "a file with extra_slip = \"file\"",
     "write `extra_slip = \"file\"`, or remove the file"},
    {when::slip_from_file && (when::shift || when::frictionless),
     {"rolling.extra_slip"},
     "has no meaning with the problem {problem}",
     "\"none\", or the problems steady and transient",
     "remove it"},
    {when::slip_from_file && !when::has("rolling", "extra_slip_file"),
     {"rolling.extra_slip"},
     "names no file",
     "`file` with extra_slip_file",
     "add `extra_slip_file = \"slip.csv\"` under [rolling]"},
    {!when::friction_falls,
     {"friction.kinetic_coefficient", "friction.half_velocity", "friction.second_*",
      "friction.polach_*"},
     of_falling,
     "with the laws {laws}",
     make_falling},
    {!when::friction_falls && !when::by_temperature,
     {"friction.memory_*", "friction.branch"},
     of_falling,
     "with the laws {laws}",
     make_falling},
    {when::by_temperature,
     {"layer.yield_stress"},
     "is not combined with friction that follows the temperature",
     "with the laws {laws}",
     "remove it, or choose another law under [friction]"},
    {when::by_temperature && (when::shift || when::frictionless),
     {"friction.law"},
     "follows the temperature while rolling, but the problem is {problem}",
     "`constant` or, with the laws {laws}, friction that falls with the slip velocity",
     "choose another law, or the problem steady or transient"},
    {when::friction_falls && when::no_polach,
     {"friction.polach_*"},
     "is of the exponential law, but friction.law is {law}",
     "with law = \"exponential\"",
     "give kinetic_coefficient and half_velocity instead, or choose the exponential law"},
    {!when::second_part,
     {"friction.second_half_velocity"},
     "is not used, because second_part is not given",
     "together with second_part",
     "add second_part under [friction], or remove it"},
    {!when::memory,
     {"friction.memory_velocity"},
     "is not used, because memory_distance is not given",
     "together with memory_distance",
     "add memory_distance under [friction], or remove it"},
    {!when::profiles,
     {"friction.inclination", "friction.track_position"},
     "is of friction that varies over the rail, but this case has no profiles",
     "with profiles of both bodies, or one number as friction.coefficient",
     "give wheel.profile and rail.profile (\"arcs\" builds them from radii), or remove it",
     true},
    {when::profiles,
     {"friction.lateral_position"},
     "is of contacts without profiles",
     "friction over the rail as friction.inclination",
     "give inclination instead",
     true},
    {!(when::varies_along_track || when::rail_varies || when::transient),
     {"wheelset.track_position", "placement.track_position"},
     "is not used, because neither the rail nor friction.track_position changes along the track",
     "together with friction.track_position, sections as rail.profile, [rail_corrugation] or "
     "[rail_dip]",
     "add one of these, or remove it",
     true},
    {!(when::wheel_varies ||
       (when::has("history", "motion") && when::is("history", "motion", "positions"))),
     {"wheelset.wheel_angle", "placement.wheel_angle"},
     "is not used, because the wheel is round",
     "together with sections as wheel.profile, [wheel_flat] or [wheel_polygon], or where "
     "[history] moves by positions",
     "add one of these, or remove it",
     true}};

const std::vector<Rivals> rivals{
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
    {{"history.step_length", "history.time"}, "", "at most one of step_length and time"},
    {{"track.rail_position", "track.gauge"}, "", "at most one of gauge and rail_position"},
    {{"track.rail_position", "track.gauge_height"},
     ", which is of the gauge",
     "rail_position alone"},
    {{"*.free_rolling", "*.rotation_change", "rolling.longitudinal_*"}, along_x, one_along_x},
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
    {{"load.normal_force", "load.approach", "load.vertical_force", "load.max_pressure",
      "given_pressure.max_pressure", "history.normal_force", "history.approach",
      "history.vertical_force", "wheelset.height", "placement.height"},
     "",
     "exactly one of normal_force, approach, vertical_force, max_pressure and, with profiles, "
     "height; with [given_pressure], of normal_force and its max_pressure"},
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

/// Whether a path matches "section.name" with at most one *.
bool matches(const std::string& pattern, const std::string& path) {
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos) return pattern == path;
  const std::size_t after = pattern.size() - star - 1;
  return path.size() >= star + after && path.compare(0, star, pattern, 0, star) == 0 &&
         path.compare(path.size() - after, after, pattern, star + 1, after) == 0;
}

/// A value without effect: the default, no curvature, no motion.
bool has_no_effect(const Key& key, const GivenValue& given) {
  static const Case defaults;
  if (key.get(defaults) == given.value) return true;
  if (const auto* number = std::get_if<double>(&given.value)) return std::isinf(*number);
  if (const auto* text = std::get_if<std::string>(&given.value)) return *text == "planar";
  const auto* numbers = std::get_if<std::vector<double>>(&given.value);
  return numbers != nullptr && key.unit != "N" &&
         std::all_of(numbers->begin(), numbers->end(), [](double number) { return number == 0.0; });
}

/// Two defaults also contradict each other.
bool is_none(const Key&, const GivenValue& given) {
  return given.value == KeyValue(std::string("none"));
}

using Given = std::map<const Key*, GivenValue>::value_type;

/// The first key of the file that matches a pattern and has an effect; null if none.
const Given* find_match(const GivenCase& given, const char* pattern,
                        bool (*nothing)(const Key&, const GivenValue&)) {
  for (const Given& one : given.values)
    if (matches(pattern, one.first->path()) && !nothing(*one.first, one.second)) return &one;
  return nullptr;
}

std::string falling_laws() {
  std::vector<std::string> words;
  for (const FallShape& law : fall_shapes())
    if (law != FallShape::none && !law.by_temperature) words.emplace_back(law.word);
  return joined(words);
}

bool leaves_points(const GivenValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value.value);
  return list != nullptr &&
         std::any_of(list->begin(), list->end(), [](double one) { return std::isnan(one); });
}

void check_rivals(const GivenCase& given, const Rivals& rule) {
  const Given* first = nullptr;
  for (const char* pattern : rule.keys) {
    const Given* found = find_match(given, pattern, is_none);
    if (found == nullptr || (rule.by_point && leaves_points(found->second))) continue;
    if (first != nullptr)
      fail_at(given, found->first->path(),
              fmt::format("contradicts {} = {} of line {}{}", first->first->path(),
                          first->second.text, first->second.line, rule.why),
              rule.allowed, "remove one of the two");
    first = found;
  }
}

/// The constants of a law have no meaning for another one.
void check_constants(const GivenCase& given) {
  const std::string law = word_of(given, "friction", "law");
  for (const FallShape& one : fall_shapes())
    for (const FallShape::Constant& own : one.constants) {
      if (own.name == nullptr || law == one.word) continue;
      if (given.find("friction", own.name) != nullptr)
        fail_at(given, std::string("friction.") + own.name,
                fmt::format("is of the law {}, but friction.law is {}", one.word, law),
                fmt::format("with law = \"{}\"", one.word), "remove it, or choose that law");
    }
}

}  // namespace

void check_exclusion(const GivenCase& given, const Exclusion& rule) {
  if (!rule.where(given)) return;
  for (const char* pattern : rule.keys) {
    const Given* found = find_match(given, pattern, rule.defaults_too ? is_none : has_no_effect);
    if (found == nullptr) continue;
    const auto filled = [&](const char* text) {
      return fmt::format(
          fmt::runtime(text), fmt::arg("problem", word_of(given, "rolling", "problem")),
          fmt::arg("slip", word_of(given, "rolling", "extra_slip")),
          fmt::arg("law", word_of(given, "friction", "law")), fmt::arg("laws", falling_laws()));
    };
    fail_at(given, found->first->path(), filled(rule.wrong), filled(rule.allowed), rule.action);
  }
}

void check_rules(const GivenCase& given) {
  for (const Exclusion& rule : exclusions) check_exclusion(given, rule);
  for (const Rivals& rule : rivals) check_rivals(given, rule);
  check_needs(given);
  check_constants(given);
}

}  // namespace rollfem::contact
