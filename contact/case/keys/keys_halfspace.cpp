// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys halfspace_section() {
  Keys<HalfspaceOptions> keys("halfspace", "Model `halfspace`", &Case::halfspace);
  keys.choice("surface")
      .says(
          "`planar` solves the contact in the tangent plane of the contact point; `curved` follows "
          "the common surface of wheel and rail across rolling, with distance and forces along "
          "local normals and slip from the local rolling radius (steady or frictionless rolling of "
          "like materials). `auto` uses the plane unless the normals of a contact of true profiles "
          "spread by more than 0.03 rad; then the surface follows them, fully from 0.06 rad on "
          "(docs/track.md). Subsurface stresses need the plane.")
      .into(&HalfspaceOptions::surface, {{"auto", SurfaceForm::automatic},
                                         {"planar", SurfaceForm::planar},
                                         {"curved", SurfaceForm::curved}});
  keys.toggle("model_error")
      .says(
          "Estimate the model error of the half-space, per quantity and load point, from the true "
          "curvature of wheel and rail (some 0.1 s per load point). Needs radii or profiles.")
      .into(&HalfspaceOptions::model_error);
  return keys;
}

}  // namespace rollfem::contact
