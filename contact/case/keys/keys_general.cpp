// SPDX-License-Identifier: LGPL-2.1-or-later
// Keys before the first section.
#include "contact/base/accuracy.hpp"
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys general_section() {
  Keys<Case> keys("", "Before the first section", whole_case());
  keys.text("title")
      .example(R"("a wheel on a crowned rail")")
      .otherwise("the name of the file")
      .says("Heading of the report.")
      .into(&Case::title);
  keys.choices("models")
      .says(
          "Models that `run` solves, in this order; `--model` overrides it. `auto`, on its own, "
          "chooses the cheapest of halfspace, hybrid and fem that meets `accuracy` "
          "(docs/choice.md).")
      .by([](const Case& c) -> KeyValue { return c.models.empty() ? KeyValue() : c.models; },
          [](Case& c, const KeyValue& v) { c.models = std::get<Words>(v); });
  keys.real("accuracy")
      .between(1e-5, 0.5)
      .otherwise("unset: no refinement")
      .says(
          "Largest estimated relative error of the quantities in `accuracy_of`. halfspace and fem "
          "halve their cells until it is reached; if memory or the finest grid ends this first, "
          "the status is 1. auto chooses model and grid, model error included; its default is "
          "0.01, and missing that only a warning.")
      .into(&Case::accuracy);
  keys.choices("accuracy_of")
      .among(accuracy_words())
      .says(
          "Quantities that `accuracy` applies to, at the worst load point; errors are relative to "
          "the value, of traction_coefficient to mu, of max_traction_x to mu p_0.")
      .into(&Case::accuracy_of);
  return keys;
}

}  // namespace rollfem::contact
