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
          "The models that `run` solves, in this order; `--model` on the command line overrides "
          "it. `auto`, on its own, chooses the cheapest of halfspace, hybrid and fem that meets "
          "`accuracy` (docs/choice.md).")
      .by([](const Case& c) -> KeyValue { return c.models.empty() ? KeyValue() : c.models; },
          [](Case& c, const KeyValue& v) { c.models = std::get<Words>(v); });
  keys.real("accuracy")
      .between(1e-5, 0.5)
      .otherwise("unset: no refinement")
      .says(
          "Requested accuracy: largest relative estimated error of the quantities in "
          "`accuracy_of`. The models halfspace and fem start from the cells of the case and halve "
          "them until it is reached; if memory or the finest grid sets a limit first, the results "
          "are written and the run ends with status 1. The model auto chooses model and grid to "
          "reach it, model error included; its default is 0.01, and missing the default is only a "
          "warning.")
      .into(&Case::accuracy);
  keys.choices("accuracy_of")
      .among(accuracy_words())
      .says(
          "Quantities that `accuracy` applies to. Their error is the largest over all load points, "
          "relative to the value, for traction_coefficient to mu, for max_traction_x to mu p_0.")
      .into(&Case::accuracy_of);
  return keys;
}

}  // namespace rollfem::contact
