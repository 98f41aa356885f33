// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

struct Shift {
  const char* name;
  const char* unit;
  double largest;
  const char* sentence;
  double HistoryStep::*member;
};

}  // namespace

SectionWithKeys history_section() {
  Keys<Case> keys("history",
                  "Steps of the problems `shift` and `transient`, one list entry per step; a shift "
                  "is relative to the previous step",
                  whole_case());
  keys.section().alternatives = true;
  keys.integer("steps")
      .between(1, 1000)
      .per("load points")
      .otherwise("the length of the lists")
      .says("Number of steps, if no list determines it.")
      .by(
          [](const Case& c) {
            return c.history.empty() ? KeyValue() : static_cast<double>(c.history.size());
          },
          [](Case& c, const KeyValue& value) {
            c.history.resize(c.rolling.creepages.size());
            grow_load_points(c, static_cast<std::size_t>(std::get<double>(value)));
          });
  keys.choice("start")
      .otherwise("rest")
      .says(
          "State before a transient: `rest`, or `steady`: the first entry of the lists is steady "
          "rolling, which the others continue.")
      .among({"rest", "steady"})
      .by(
          [](const Case& c) {
            return c.starts_steady ? KeyValue(std::string("steady")) : KeyValue();
          },
          [](Case& c, const KeyValue& value) {
            c.starts_steady = std::get<std::string>(value) == "steady";
          });
  keys.reals("normal_force")
      .symbol("F_z")
      .unit("N")
      .between(1e-6, largest_force)
      .otherwise("load.normal_force in all steps")
      .says("Normal force of each step, instead of [load].")
      .into_each(&Case::history, &HistoryStep::normal_force);
  keys.reals("approach")
      .symbol("delta")
      .unit("mm")
      .between(1e-9, 1e6)
      .otherwise("load.approach in all steps")
      .says("Approach in each step, instead of [load].")
      .into_each(&Case::history, &HistoryStep::approach);
  for (const Shift& shift :
       {Shift{"longitudinal_shift", "mm", 1e3,
              "Rigid displacement of the wheel over the rail along x in each step (shift).",
              &HistoryStep::longitudinal_shift},
        Shift{"lateral_shift", "mm", 1e3, "The same along y.", &HistoryStep::lateral_shift},
        Shift{"spin_shift", "rad", 1.0, "Rotation about the normal in each step (shift).",
              &HistoryStep::spin_shift}})
    keys.reals(shift.name)
        .unit(shift.unit)
        .within(shift.largest)
        .otherwise("0")
        .says(shift.sentence)
        .into_each(&Case::history, shift.member);
  keys.reals("step_length")
      .unit("mm")
      .positive()
      .otherwise("required by `transient`")
      .says(
          "Distance that the wheel rolls in each step (transient); error bars count it. An element "
          "or a tenth of the patch is short enough.")
      .into_each(&Case::history, &HistoryStep::step_length);
  return keys;
}

}  // namespace rollfem::contact
