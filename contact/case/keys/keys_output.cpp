// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys output_section() {
  Keys<OutputOptions> keys("output", "Output beside summary.json and results.h5", &Case::output);
  keys.choices("paths")
      .among({"x", "y"})
      .or_empty()
      .says("Centre lines of the patch along which tractions are written and drawn.")
      .into(&OutputOptions::paths);
  keys.toggle("fields")
      .says(
          "Write ParaView files: the contact surface at `grid_fields`, wheel and rail (model fem) "
          "at `body_fields`.")
      .into(&OutputOptions::fields);
  keys.choice("grid_fields")
      .says(
          "Load points that keep fields on the contact grid (results.h5, path_x.csv, path_y.csv, "
          "ParaView): `some` is 25 from the first to the last; `auto` is all of up to 100 per "
          "model and patch, otherwise `some`. Figures, and rollfem stress for half-spaces, need "
          "these fields.")
      .into(&OutputOptions::grid_fields, {{"auto", GridFields::automatic},
                                          {"all", GridFields::all},
                                          {"some", GridFields::some},
                                          {"none", GridFields::none}});
  keys.choice("body_fields")
      .says(
          "Load points that keep displacement and stress of wheel and rail (model fem; ParaView, "
          "results.h5, rollfem stress); each takes some 12 MB and about as long as solving it.")
      .into(&OutputOptions::body_fields,
            {{"all", BodyFields::all}, {"last", BodyFields::last}, {"none", BodyFields::none}});
  keys.toggle("stress_maxima")
      .says(
          "Largest von Mises, Tresca, orthogonal shear and principal stress of wheel and rail, "
          "with positions (models halfspace, hybrid, fem).")
      .into(&OutputOptions::stress_maxima);
  return keys;
}

}  // namespace rollfem::contact
