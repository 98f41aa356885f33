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
          "Write the contact surfaces of the load points of `grid_fields` as ParaView files, and "
          "of wheel and rail (model fem) at those of `body_fields`.")
      .into(&OutputOptions::fields);
  keys.choice("grid_fields")
      .says(
          "Load points at which pressure, tractions, slip, gap and displacement on the contact "
          "grid are stored in results.h5, path_x.csv, path_y.csv and as ParaView files: `some` "
          "keeps 25 from the first to the last; `auto` keeps all of up to 100 load points per "
          "model and patch, otherwise `some`. Scalars are always stored. Figures, and rollfem "
          "stress "
          "for half-spaces, need these fields.")
      .into(&OutputOptions::grid_fields, {{"auto", GridFields::automatic},
                                          {"all", GridFields::all},
                                          {"some", GridFields::some},
                                          {"none", GridFields::none}});
  keys.choice("body_fields")
      .says(
          "Load points at which displacement (mm) and stress (MPa) of wheel and rail (model fem) "
          "are stored as ParaView files and in results.h5, where rollfem stress reads them. This "
          "takes some 12 MB per load point and about as long as solving the load point.")
      .into(&OutputOptions::body_fields,
            {{"all", BodyFields::all}, {"last", BodyFields::last}, {"none", BodyFields::none}});
  keys.toggle("stress_maxima")
      .says(
          "Largest von Mises, Tresca, orthogonal shear and principal stress of wheel and rail at "
          "every load point, with their positions (models halfspace, hybrid and fem).")
      .into(&OutputOptions::stress_maxima);
  return keys;
}

}  // namespace rollfem::contact
