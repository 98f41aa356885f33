// Keys before the first section.
#include "contact/base/accuracy.hpp"
#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys general_section() {
  Keys<Case> keys("", "Before the first section", whole_case());
  keys.text("title")
      .example(R"("a wheel on a crowned rail")")
      .otherwise("the name of the file")
      .says("What the report is headed with.")
      .into(&Case::title);
  keys.choices("models")
      .says(
          "The models that `run` computes, in this order; `--model` on the command line overrides "
          "it. `auto`, alone, takes the cheapest of halfspace, hybrid and fem that meets "
          "`accuracy` "
          "(docs/choice.md).")
      .by([](const Case& c) -> KeyValue { return c.models.empty() ? KeyValue() : c.models; },
          [](Case& c, const KeyValue& v) { c.models = std::get<Words>(v); });
  keys.real("accuracy")
      .between(1e-5, 0.5)
      .otherwise("the cells that the case gives, whatever their error")
      .says(
          "Largest estimated error, relative, of the quantities of `accuracy_of`: the models "
          "halfspace and fem halve their cells, beginning with those of the case, until it is "
          "reached; the run fails (status 1, results are written) when memory or the finest grid "
          "allowed ends that before. The model auto chooses model and grid for it, with what the "
          "model leaves out added to its error, and looks for 0.01 where it is not given: then it "
          "is a warning, no failure, where that is not reached.")
      .into(&Case::accuracy);
  keys.choices("accuracy_of")
      .among(accuracy_words())
      .says(
          "What `accuracy` is asked of: the largest error over all load points, as part of the "
          "value; of traction_coefficient as part of mu, of max_traction_x of mu p_0.")
      .into(&Case::accuracy_of);
  return keys;
}

}  // namespace rollfem::contact
