// SPDX-License-Identifier: LGPL-2.1-or-later
// Rolling, and the steps of a history.
#include "case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

using RollingKeys = Keys<Rolling>;

void add_motion(RollingKeys& keys) {
  keys.add("longitudinal_creepage", of_each(&Rolling::creepages, &Creepage::longitudinal),
           symbol("xi"), within(1.0), example("[0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006]"),
           "Rigid slip of the wheel along x over the rolling speed; positive when braking. A list "
           "gives a creep curve.");
  keys.add("lateral_creepage", of_each(&Rolling::creepages, &Creepage::lateral), symbol("eta"),
           within(1.0), "The same along y.");
  keys.add("spin", of_each(&Rolling::creepages, &Creepage::spin), symbol("phi"), unit("rad/mm"),
           within(1.0), "Rigid rotation about the normal over the rolling speed.");
  keys.add("speed", &Rolling::speed, symbol("V"), unit("mm/s"), zero_or(smallest, 1e8),
           "Rolling speed, for falling friction, heat and fem.inertia.");
}

void add_difference(RollingKeys& keys) {
  keys.add("upwind_order", &Rolling::upwind_order,
           {{"first", UpwindOrder::first}, {"second", UpwindOrder::second}},
           "Order of the difference along the streamline; `first` reproduces CONTACT and needs "
           "some ten times finer elements.");
  keys.add("leading_edge", &Rolling::leading_edge,
           {{"fitted", LeadingEdge::fitted}, {"plain", LeadingEdge::plain}},
           "`fitted` adapts the second-order difference to the leading edge within its element; "
           "`plain` does not, and its tractions zigzag.");
}

void add_extra_slip(RollingKeys& keys) {
  keys.add("extra_slip", &Rolling::extra_slip,
           {{"auto", ExtraSlip::automatic}, {"none", ExtraSlip::none}, {"file", ExtraSlip::file}},
           "`auto`: rigid slip from the wheel's rolling radii and, on a curved surface, its "
           "tangents; `none`: creepages and spin alone; `file` adds extra_slip_file.");
  keys.add("extra_slip_file", &Rolling::extra_slip_values, names_file,
           otherwise("required if extra_slip is `file`"),
           "Lines `x, y, s_x, s_y` (mm, slip over the rolling speed) on a regular lattice.");
}

void add_problem(RollingKeys& keys) {
  keys.add("problem", &Rolling::problem,
           words_of({Problem::steady, Problem::shift, Problem::transient, Problem::frictionless}),
           "`steady`; `shift`: pressed and shifted without rolling (Cattaneo), `transient`: "
           "rolling, both in steps from the previous state; `frictionless`: the normal problem "
           "alone, with loads in [history] in steps.");
  keys.add("longitudinal_force", of_each(&Rolling::forces, &PrescribedForce::longitudinal),
           symbol("F_x"), unit("N"), or_nan(within(largest_force)),
           otherwise("creepage or shift applies"),
           "Force on the wheel along x, negative when braking, below mu F_z in magnitude; nan: "
           "here the creepage or shift applies.");
  keys.add("lateral_force", of_each(&Rolling::forces, &PrescribedForce::lateral), symbol("F_y"),
           unit("N"), or_nan(within(largest_force)), otherwise("creepage or shift applies"),
           "The same along y.");
}

SectionWithKeys rolling_section() {
  RollingKeys keys("rolling", "Rolling along x; lists have one entry per load point",
                   &Case::rolling);
  keys.section().alternatives = true;
  add_motion(keys);
  add_difference(keys);
  add_extra_slip(keys);
  add_problem(keys);
  return keys;
}

struct Shift {
  const char* name;
  const char* unit;
  double largest;
  const char* sentence;
  double HistoryStep::*member;
};

SectionWithKeys history_section() {
  Keys<Case> keys("history",
                  "Steps of `shift`, `transient` and `frictionless` (loads alone), one list entry "
                  "per step; a shift is relative to the previous step",
                  whole_case());
  keys.section().alternatives = true;
  keys.add(KeyKind::integer, "steps",
           Access<Case>{[](const Case& c) {
                          return c.history.empty() ? KeyValue()
                                                   : static_cast<double>(c.history.size());
                        },
                        [](Case& c, const KeyValue& value) {
                          c.history.resize(c.rolling.creepages.size());
                          grow_load_points(c, static_cast<std::size_t>(std::get<double>(value)));
                        }},
           between(1, 1000), per("load points"), counts, otherwise("the length of the lists"),
           "Number of steps, if no list determines it.");
  keys.add("start", &Case::starts_steady, {{"rest", false}, {"steady", true}}, silent_default,
           otherwise("rest"),
           "State before a transient; `steady`: the first entry is steady rolling, which the "
           "others continue.");
  keys.add("normal_force", of_each(&Case::history, &HistoryStep::normal_force), symbol("F_z"),
           unit("N"), zero_or(1e-6, largest_force), otherwise("that of [load]"),
           "Normal force; 0 leaves bodies that yield without load.");
  keys.add("approach", of_each(&Case::history, &HistoryStep::approach), symbol("delta"), unit("mm"),
           between(1e-9, 1e6), otherwise("that of [load]"), "Approach.");
  keys.add("vertical_force", of_each(&Case::history, &HistoryStep::vertical_force), symbol("Q"),
           unit("N"), between(1e-6, largest_force), otherwise("that of [load]"),
           "With profiles: vertical force on each wheel.");
  for (const Shift& shift :
       {Shift{"longitudinal_shift", "mm", 1e3,
              "Rigid displacement of the wheel over the rail along x (shift).",
              &HistoryStep::longitudinal_shift},
        Shift{"lateral_shift", "mm", 1e3, "The same along y.", &HistoryStep::lateral_shift},
        Shift{"spin_shift", "rad", 1.0, "Rotation about the normal (shift).",
              &HistoryStep::spin_shift}})
    keys.add(shift.name, of_each(&Case::history, shift.member), unit(shift.unit),
             within(shift.largest), otherwise("0"), shift.sentence);
  keys.add("step_length", of_each(&Case::history, &HistoryStep::step_length), unit("mm"),
           positive(), otherwise("from track_position or time"),
           "Distance rolled (transient); an element or a tenth of the patch is short enough.");
  keys.add(
      "time", of_each(&Case::history, &HistoryStep::time), unit("s"), within(1e6), ascending,
      otherwise("step_length"),
      "Time at the end of each step, with rolling.speed; the first step is as long as the second.");
  keys.add("wheel_way", of_each(&Case::history, &HistoryStep::wheel_way), unit("mm"), within(1e3),
           otherwise("step_length"),
           "Way of the wheel between positions, if it is not that of its contact.");
  keys.add("motion", &Case::moves_by_positions, {{"velocities", false}, {"positions", true}},
           silent_default, otherwise("velocities"),
           "Lateral, yaw and roll velocity of a wheel whose positions follow each other: those "
           "given, or differences of the positions (also of a shift).");
  return keys;
}

}  // namespace

Sections rolling_sections() {
  return {rolling_section(), history_section()};
}

}  // namespace rollfem::contact
