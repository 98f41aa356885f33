// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of wheel and rail: their definition, and repairs of profile files.
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

using Profile = ProfileSource;
using ProfileKeys = Keys<Profile>;

void add_formulas(ProfileKeys& keys) {
  keys.reals("radii")
      .unit("mm")
      .sized(smallest_radius, largest)
      .or_inf()
      .otherwise("required by `arcs`")
      .says(
          "Profile `arcs`: radii of tangent arcs, positive convex, negative concave, inf straight.")
      .into(&Profile::radii);
  keys.reals("ends")
      .unit("mm")
      .within(1e3)
      .otherwise("required by `arcs`")
      .says(
          "y at which the arcs end: with symmetric = true one for each radius, from the middle "
          "outwards; otherwise one more than radii, increasing. The arcs pass through (0, 0).")
      .into(&Profile::ends);
  keys.toggle("symmetric")
      .says("The arcs are given for y > 0 and mirrored.")
      .into(&Profile::symmetric);
  keys.real("slope").within(1e6).says("dz/dy of unsymmetric arcs at (0, 0).").into(&Profile::slope);
  keys.reals("coefficients")
      .within(largest_force)
      .otherwise("required by `polynomial`")
      .says(
          "Profile `polynomial`: z in mm over y in mm, lowest order first; pieces one after the "
          "other, each with the same number of coefficients.")
      .into(&Profile::coefficients);
  keys.reals("limits")
      .unit("mm")
      .within(1e3)
      .otherwise("required by `polynomial`")
      .says(
          "y at which pieces begin and end, increasing, one more than pieces; they must meet in "
          "value and slope.")
      .into(&Profile::limits);
}

void add_places(ProfileKeys& keys) {
  keys.toggle("mirror").says("Swap the sides: y becomes -y.").into(&Profile::mirror);
  keys.real("rotation")
      .unit("rad")
      .within(1.6)
      .says(
          "Rotate about (0, 0), positive from y to z; the rail's inclination is track.inclination.")
      .into(&Profile::rotation);
  keys.pair("shift")
      .unit("mm")
      .within(1e6)
      .says("Shift along y and z, after the rotation.")
      .into(&Profile::shift);
}

void add_mending(ProfileKeys& keys) {
  keys.choice("unit")
      .says("Unit of the lengths in the file; SIMPACK files state their own.")
      .into(&Profile::unit,
            {{"mm", LengthUnit::mm}, {"m", LengthUnit::m}, {"inch", LengthUnit::inch}});
  keys.text("section")
      .otherwise("required by a MiniProf file with several profiles")
      .says("Section of the points in a MiniProf file: `Profile1Points`.")
      .into(&Profile::section);
  keys.toggle("flip").says("The file's z points upward: z becomes -z.").into(&Profile::flip);
  keys.toggle("reverse").says("Reverse the order of the points.").into(&Profile::reverse);
  keys.toggle("sort").says("Sort the points by y.").into(&Profile::sort);
  keys.toggle("drop_duplicates")
      .says("Drop points within 1e-6 mm of the previous one.")
      .into(&Profile::drop_duplicates);
  keys.toggle("drop_zigzag")
      .says("Drop points at which the curve turns back.")
      .into(&Profile::drop_zigzag);
  keys.real("thinning")
      .unit("mm")
      .zero_or(smallest, 10.0)
      .says("Merge points closer than this into their mean; 0: keep all.")
      .into(&Profile::thinning);
  keys.real("longest_gap")
      .unit("mm")
      .positive()
      .says("Largest gap that the curve bridges; a larger one is an error.")
      .into(&Profile::longest_gap);
  keys.real("largest_kink")
      .unit("degrees")
      .between(0.1, 180.0)
      .says(
          "Largest angle between two chords; a larger one, or a step that stands out, is an "
          "error.")
      .into(&Profile::largest_kink);
  keys.real("rounding")
      .unit("mm")
      .zero_or(smallest, 100.0)
      .says(
          "Drop points within this distance of a kink or step and bridge the gap smoothly; 0: "
          "kinks are errors.")
      .into(&Profile::rounding);
  keys.real("smoothing")
      .unit("mm")
      .zero_or(smallest, 1.0)
      .says(
          "Standard deviation of measured points across the profile; 0: the curve passes through "
          "the points.")
      .into(&Profile::smoothing);
}

template <class Body>
SectionWithKeys profile_section(const std::string& name, Body Case::*body) {
  ProfileKeys keys(name + "_profile",
                   "Details of the profile named in [wheel] or [rail]; rollfem repairs files only "
                   "as these keys say",
                   {[body](const Case& c) { return &(c.*body).profile; },
                    [body](Case& c) -> Profile& { return (c.*body).profile; }});
  keys.section().of_profiles = true;
  add_formulas(keys);
  add_places(keys);
  add_mending(keys);
  return keys;
}

}  // namespace

SectionWithKeys wheel_profile_section() {
  return profile_section("wheel", &Case::wheel);
}

SectionWithKeys rail_profile_section() {
  return profile_section("rail", &Case::rail);
}

}  // namespace rollfem::contact
