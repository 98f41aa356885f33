// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/checks/case_needs.hpp"

#include "case/checks/case_rules.hpp"
#include "case/keys/case_text.hpp"

#include <vector>

namespace rollfem::contact {

namespace {

/// One of these keys is required where the condition holds.
struct Need {
  Condition where;
  std::vector<const char*> one_of;
  const char* wrong;
  const char* allowed;
  const char* action;
};

const std::vector<Need> needs{
    {when::line,
     {"geometry.relative_radius", "wheel.rolling_radius"},
     "is missing, and wheel.rolling_radius too",
     "one of them: a line contact needs a radius along rolling",
     "add `relative_radius = 405.0` under [geometry]"},
    {when::profiles && !when::placement,
     {"track.inclination"},
     "is missing",
     "\"none\", \"1:20\", \"1:40\", any other ratio, or an angle in rad; there is no default, "
     "because it moves the contact",
     "add `inclination = \"1:40\"` under [track]"},
    {when::given_pressure,
     {"load.normal_force", "given_pressure.max_pressure"},
     "is missing, and given_pressure.max_pressure too",
     "exactly one of load.normal_force and given_pressure.max_pressure",
     "add `normal_force = 50e3` under [load]"},
    {when::profiles && !when::given_pressure,
     {"load.normal_force", "load.approach", "load.vertical_force", "history.normal_force",
      "history.approach", "history.vertical_force", "wheelset.height", "placement.height"},
     "is missing, and load.approach too",
     "exactly one of normal_force, approach, vertical_force and wheelset.height or "
     "placement.height",
     "add `vertical_force = 50e3` under [load]"},
    {!when::profiles && !when::given_pressure,
     {"load.normal_force", "load.approach", "load.max_pressure", "history.normal_force",
      "history.approach"},
     "is missing, and load.approach too",
     "exactly one of normal_force, approach and max_pressure",
     "add `normal_force = 50e3` under [load]"},
    {when::transient,
     {"history.step_length", "history.time", "wheelset.track_position", "placement.track_position"},
     "is missing",
     "with the problem transient, the distance rolled in each step, in mm, the time or the "
     "track_position at its end",
     "add `step_length = 0.1` under [history]"},
    {when::given_pressure,
     {"given_pressure.semi_axis_x"},
     "is missing",
     "both semi-axes of the ellipse in mm",
     "add `semi_axis_x = 5.0` under [given_pressure]"},
    {when::given_pressure,
     {"given_pressure.semi_axis_y"},
     "is missing",
     "both semi-axes of the ellipse in mm",
     "add `semi_axis_y = 5.0` under [given_pressure]"},
    {when::friction_falls,
     {"friction.kinetic_coefficient", "friction.polach_a"},
     "is missing",
     "the coefficient to which friction falls with the slip velocity",
     "add `kinetic_coefficient = 0.1` under [friction], or write `law = \"constant\"`"},
    {when::friction_falls,
     {"friction.half_velocity", "friction.polach_b"},
     "is missing",
     "the slip velocity in mm/s at which half of the fall is done",
     "add `half_velocity = 1000.0` under [friction], or write `law = \"constant\"`"},
    {when::friction_falls && when::second_part,
     {"friction.second_half_velocity"},
     "is missing",
     "the slip velocity in mm/s at which half of second_part is left",
     "add `second_half_velocity = 1e4` under [friction], or remove second_part"},
    {when::friction_falls && !when::shift && !when::frictionless,
     {"rolling.speed"},
     "is missing, and the friction depends on the slip velocity (friction.law)",
     "the rolling speed in mm/s",
     "add `speed = 10e3` under [rolling], or write `law = \"constant\"` under [friction]"},
    {when::by_temperature,
     {"friction.hot_coefficient"},
     "is missing",
     "the coefficient of friction of hot surfaces",
     "add `hot_coefficient = 0.1` under [friction], or choose another law"},
    {when::by_temperature,
     {"friction.hot_temperature"},
     "is missing",
     "the temperature in degC from which friction is the hot_coefficient",
     "add `hot_temperature = 400.0` under [friction], or choose another law"},
    {when::heat || when::by_temperature,
     {"rolling.speed"},
     "is missing, and temperatures depend on it",
     "the rolling speed in mm/s",
     "add `speed = 30e3` under [rolling], or remove the sections of heat and the law "
     "`temperature`"},
    {when::lists_over("friction points"),
     {"friction.inclination", "friction.track_position", "friction.lateral_position"},
     "is missing: nothing says where on the rail the several numbers of [friction] apply",
     "as many places as numbers: inclination, track_position or lateral_position; or one number",
     "give the inclination of the rail at each, say `inclination = [-1.2, -0.4, 0.0]` under "
     "[friction], or one number"},
    {when::varies_along_track || when::rail_varies,
     {"wheelset.track_position", "placement.track_position"},
     "is missing, and rail or friction depend on it (rail.profile, [rail_corrugation], [rail_dip], "
     "friction.track_position)",
     "one position along the track, mm, for each position of the wheelset",
     "add `track_position = 0.0` under [wheelset], or under [placement]"},
    {when::wheel_varies,
     {"wheelset.wheel_angle", "placement.wheel_angle"},
     "is missing, and the wheel depends on it (wheel.profile, [wheel_flat], [wheel_polygon])",
     "an angle about the axle, rad, for each position of the wheelset",
     "add `wheel_angle = 0.0` under [wheelset], or under [placement]"},
    {when::rail_sections && !when::placement,
     {"track.rail_position"},
     "is missing, and no gauge places a rail that changes along the track",
     "where the origin of the rail's profiles is",
     "add `rail_position = [750.0, 0.0]` under [track], from the middle of the track outwards and "
     "down"},
    {when::layer,
     {"layer.thickness"},
     "is missing",
     "thickness and shear_modulus of the layer",
     "add `thickness = 0.02` under [layer]"},
    {when::layer,
     {"layer.shear_modulus"},
     "is missing",
     "thickness and shear_modulus of the layer",
     "add `shear_modulus = 800.0` under [layer]"},
    {when::has("layer", "hardening"),
     {"layer.yield_stress"},
     "is missing",
     "the shear stress at which the layer yields, before it hardens or softens",
     "add `yield_stress = 200.0` under [layer], or remove hardening"},
    {when::rounded_flat,
     {"wheel_flat.depth"},
     "is missing",
     "a rounded flat has a depth and a length",
     "add `depth = 0.5` under [wheel_flat]"},
    {when::rounded_flat,
     {"wheel_flat.length"},
     "is missing",
     "a rounded flat has a depth and a length",
     "add `length = 60.0` under [wheel_flat]"},
    {when::any_of("wheel_polygon"),
     {"wheel_polygon.order"},
     "is missing",
     "how many waves there are around the wheel",
     "add `order = 20` under [wheel_polygon]"},
    {when::any_of("wheel_polygon"),
     {"wheel_polygon.amplitude"},
     "is missing",
     "an amplitude of each wave, mm",
     "add `amplitude = 0.02` under [wheel_polygon]"},
    {when::any_of("rail_corrugation"),
     {"rail_corrugation.wavelength"},
     "is missing",
     "the length of each wave, mm",
     "add `wavelength = 40.0` under [rail_corrugation]"},
    {when::any_of("rail_corrugation"),
     {"rail_corrugation.amplitude"},
     "is missing",
     "an amplitude of each wave, mm",
     "add `amplitude = 0.02` under [rail_corrugation]"},
    {when::any_of("rail_dip"),
     {"rail_dip.depth"},
     "is missing",
     "the depth in the middle, mm",
     "add `depth = 0.5` under [rail_dip]"},
    {when::any_of("rail_dip"),
     {"rail_dip.length"},
     "is missing",
     "the length from end to end, mm",
     "add `length = 1000.0` under [rail_dip]"}};

void check_need(const GivenCase& given, const Need& rule) {
  if (!rule.where(given)) return;
  for (const char* key : rule.one_of)
    if (given.values.count(find_key(key)) > 0) return;
  fail_at(given, rule.one_of.front(), rule.wrong, rule.allowed, rule.action);
}

}  // namespace

void check_needs(const GivenCase& given) {
  for (const Need& rule : needs) check_need(given, rule);
}

}  // namespace rollfem::contact
