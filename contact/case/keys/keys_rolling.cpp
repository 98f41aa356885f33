// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

using RollingKeys = Keys<Rolling>;

void add_motion(RollingKeys& keys) {
  keys.reals("longitudinal_creepage")
      .symbol("xi")
      .within(1.0)
      .example("[0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]")
      .says(
          "Rigid slip of the wheel along x over the rolling speed; positive when braking: the rail "
          "pulls the wheel towards -x. A list gives a creep curve.")
      .into_each(&Rolling::creepages, &Creepage::longitudinal);
  keys.reals("lateral_creepage")
      .symbol("eta")
      .within(1.0)
      .says("The same along y.")
      .into_each(&Rolling::creepages, &Creepage::lateral);
  keys.reals("spin")
      .symbol("phi")
      .unit("rad/mm")
      .within(1.0)
      .says("Rigid rotation about the normal over the rolling speed.")
      .into_each(&Rolling::creepages, &Creepage::spin);
  keys.real("speed")
      .symbol("V")
      .unit("mm/s")
      .zero_or(smallest, 1e8)
      .says(
          "Rolling speed, for a friction.law of the slip velocity and for fem.inertia; all else is "
          "quasi-static.")
      .into(&Rolling::speed);
}

void add_difference(RollingKeys& keys) {
  keys.choice("upwind_order")
      .says(
          "Order of the difference along the streamline; `first` reproduces CONTACT's numbers on "
          "the same elements and needs some ten times finer ones.")
      .into(&Rolling::upwind_order,
            {{"first", UpwindOrder::first}, {"second", UpwindOrder::second}});
  keys.choice("leading_edge")
      .says(
          "`fitted` adapts the second-order difference of steady rolling to the leading edge "
          "within its element; `plain` is the textbook difference, whose tractions zigzag.")
      .into(&Rolling::leading_edge,
            {{"fitted", LeadingEdge::fitted}, {"plain", LeadingEdge::plain}});
}

void add_extra_slip(RollingKeys& keys) {
  keys.choice("extra_slip")
      .says(
          "Rigid slip from the shape of the surface: `auto` from the wheel's rolling radii and, "
          "on a curved surface, its tangents; `none`: creepages and spin alone; `file` adds "
          "extra_slip_file.")
      .into(&Rolling::extra_slip,
            {{"auto", ExtraSlip::automatic}, {"none", ExtraSlip::none}, {"file", ExtraSlip::file}});
  keys.text("extra_slip_file")
      .otherwise("required if extra_slip is `file`")
      .says("Lines `x, y, s_x, s_y` (mm, slip over the rolling speed) on a regular lattice.")
      .into(&Rolling::extra_slip_values);
}

void add_problem(RollingKeys& keys) {
  keys.choice("problem")
      .says(
          "`steady`: steady rolling, each load point separately; `shift`: pressing and shifting "
          "without rolling (Cattaneo), `transient`: rolling, both in steps, each from the previous "
          "state; `frictionless`: the normal problem alone.")
      .into(&Rolling::problem,
            words_of({Problem::steady, Problem::shift, Problem::transient, Problem::frictionless}));
  keys.reals("longitudinal_force")
      .symbol("F_x")
      .unit("N")
      .within(largest_force)
      .or_nan()
      .otherwise("creepage or shift applies")
      .says(
          "Force on the wheel along x, instead of longitudinal_creepage or longitudinal_shift; "
          "negative when braking, of magnitude below mu F_z; nan: at this load point the creepage "
          "or shift applies.")
      .into_each(&Rolling::forces, &PrescribedForce::longitudinal);
  keys.reals("lateral_force")
      .symbol("F_y")
      .unit("N")
      .within(largest_force)
      .or_nan()
      .otherwise("creepage or shift applies")
      .says("The same along y.")
      .into_each(&Rolling::forces, &PrescribedForce::lateral);
}

}  // namespace

SectionWithKeys rolling_section() {
  RollingKeys keys(
      "rolling",
      "Rolling along x; lists have the length of the load points, single numbers apply to all",
      &Case::rolling);
  keys.section().alternatives = true;
  add_motion(keys);
  add_difference(keys);
  add_extra_slip(keys);
  add_problem(keys);
  return keys;
}

}  // namespace rollfem::contact
