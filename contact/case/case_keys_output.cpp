// [output]: what a run writes beside its numbers.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

std::vector<Key> output_keys() {
  return {
      {"output",
       "paths",
       KeyKind::words,
       "",
       "",
       {},
       {"x", "y"},
       false,
       "",
       "",
       "Middle lines of the patch along which stresses are written and drawn.",
       [](const Case& c) -> KeyValue { return c.output.paths; },
       [](Case& c, const KeyValue& v) { c.output.paths = std::get<Words>(v); }},
      {"output",
       "fields",
       KeyKind::boolean,
       "",
       "",
       {},
       {},
       false,
       "",
       "",
       "Write the contact surfaces as ParaView files, and wheel and rail of the model fem as "
       "`body_fields` says.",
       [](const Case& c) -> KeyValue { return c.output.fields; },
       [](Case& c, const KeyValue& v) { c.output.fields = std::get<bool>(v); }},
      word_key<BodyFields>(
          "output", "body_fields", {"all", "last", "none"},
          "Load points at which displacement (mm) and stress (MPa) of wheel and rail (model "
          "fem) are kept, as ParaView files and in results.h5, from which rollfem stress reads "
          "them.",
          [](Case& c) -> BodyFields& { return c.output.body_fields; }),
      {"output",
       "stress_maxima",
       KeyKind::boolean,
       "",
       "",
       {},
       {},
       false,
       "true for the model fem, false for halfspace, where it costs some 0.3 s a load point",
       "true",
       "Largest von Mises, Tresca, orthogonal shear and principal stress of wheel and rail at "
       "every "
       "load point, with their places (models fem and halfspace).",
       [](const Case& c) -> KeyValue {
         return c.output.stress_maxima ? KeyValue(*c.output.stress_maxima) : KeyValue();
       },
       [](Case& c, const KeyValue& v) { c.output.stress_maxima = std::get<bool>(v); }},
  };
}

}  // namespace rollfem::contact
