// Declarations of the accuracy that is asked for, before the first section.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

std::vector<Key> accuracy_keys() {
  Key accuracy;
  accuracy.name = "accuracy";
  accuracy.bounds = {1e-5, 0.5};
  accuracy.when_absent = "the cells that the case gives, whatever their error";
  accuracy.sentence =
      "Largest estimated error, relative, of the quantities of `accuracy_of`: the models halfspace "
      "and fem halve their cells, beginning with those of the case, until it is reached; the run "
      "fails (status 1, results are written) when memory or the finest grid allowed ends that "
      "before.";
  accuracy.get = [](const Case& c) { return optional_number(c.accuracy); };
  accuracy.set = [](Case& c, const KeyValue& v) { c.accuracy = std::get<double>(v); };

  Key of;
  of.name = "accuracy_of";
  of.kind = KeyKind::words;
  of.words = {"max_pressure", "semi_axis_x",          "semi_axis_y",   "approach",
              "normal_force", "traction_coefficient", "max_traction_x"};
  of.sentence =
      "What `accuracy` is asked of: the largest error over all load points, relative to the value; "
      "of traction_coefficient and max_traction_x to the largest of the creep curve.";
  of.get = [](const Case& c) -> KeyValue { return c.accuracy_of; };
  of.set = [](Case& c, const KeyValue& v) { c.accuracy_of = std::get<Words>(v); };
  return {accuracy, of};
}

}  // namespace rollfem::contact
