// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys output_section() {
  Keys<OutputOptions> keys("output", "Output in addition to summary.json and results.h5",
                           &Case::output);
  keys.choices("paths")
      .among({"x", "y"})
      .or_empty()
      .says("Middle lines of the patch along which tractions are written and drawn.")
      .into(&OutputOptions::paths);
  keys.toggle("fields")
      .says(
          "Write the contact surfaces of the load points of `grid_fields` as ParaView files, and "
          "wheel and rail of the model fem according to `body_fields`.")
      .into(&OutputOptions::fields);
  keys.choice("grid_fields")
      .says(
          "Load points at which pressure, tractions, slip, gap and displacement on the contact "
          "grid are stored in results.h5, path_x.csv, path_y.csv and as ParaView files: `some` "
          "stores 25 from the first to the last, `auto` all of up to 100 and otherwise some, "
          "counted for each model and patch. Scalars are always stored. Figures, and rollfem "
          "stress for half-spaces, need these fields.")
      .into(&OutputOptions::grid_fields, {{"auto", GridFields::automatic},
                                          {"all", GridFields::all},
                                          {"some", GridFields::some},
                                          {"none", GridFields::none}});
  keys.choice("body_fields")
      .says(
          "Load points at which displacement (mm) and stress (MPa) of wheel and rail (model fem) "
          "are stored as ParaView files and in results.h5, from which rollfem stress reads them: "
          "about 12 MB per load point, and recovering them takes about as long as solving the load "
          "point.")
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
