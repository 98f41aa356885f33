// SPDX-License-Identifier: LGPL-2.1-or-later
// The load, and what stands before the first section.
#include "case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

SectionWithKeys general_section() {
  Keys<Case> keys("", "Before the first section", whole_case());
  keys.add("title", &Case::title, example(R"("a wheel on a crowned rail")"),
           otherwise("the name of the file"), "Heading of the report.");
  keys.add(KeyKind::words, "models",
           Access<Case>{
               [](const Case& c) -> KeyValue { return c.models.empty() ? KeyValue() : c.models; },
               [](Case& c, const KeyValue& v) { c.models = std::get<Words>(v); }},
           among_known(&KnownNames::models),
           "Models that `run` solves, in this order. `auto`, on its own, chooses the cheapest of "
           "halfspace, hybrid and fem that meets `accuracy` (docs/choice.md).");
  keys.add("accuracy", &Case::accuracy, between(1e-5, 0.5), otherwise("unset: no refinement"),
           "Largest estimated relative error of the quantities in `accuracy_of`. halfspace and fem "
           "halve their cells until they meet it, or end with status 1; auto includes the model "
           "error, with 0.01 as default.");
  keys.add("accuracy_of", &Case::accuracy_of, among_known(&KnownNames::quantities),
           "Quantities of `accuracy`, at the worst load point; errors refer to the value, of "
           "traction_coefficient to mu, of max_traction_x to mu p_0.");
  return keys;
}

SectionWithKeys load_section() {
  const char* one_of = "give exactly one";
  Keys<Load> keys("load", "Force, approach or largest pressure that presses the bodies together",
                  &Case::load);
  keys.section().alternatives = true;
  keys.add("normal_force", &Load::normal_force, symbol("F_z"), unit("N"),
           between(1e-6, largest_force), example("50e3"), otherwise(one_of),
           "Force that presses the wheel on the rail.");
  keys.add("approach", &Load::approach, symbol("delta"), unit("mm"), between(1e-9, 1e6),
           otherwise(one_of),
           "Approach (penetration) of distant points of the bodies; below a tenth of the smallest "
           "radius.");
  keys.add("vertical_force", &Load::vertical_force, symbol("Q"), unit("N"),
           between(1e-6, largest_force), otherwise(one_of),
           "With profiles: vertical force on each wheel, carried by pressure and friction of all "
           "its patches.");
  keys.add("max_pressure", &Load::max_pressure, symbol("p_0"), unit("MPa"), positive(),
           otherwise(one_of),
           "Hertz's largest pressure, which gives the force; not with profiles or a distance from "
           "a file.");
  return keys;
}

}  // namespace

Sections load_sections() {
  return {general_section(), load_section()};
}

}  // namespace rollfem::contact
