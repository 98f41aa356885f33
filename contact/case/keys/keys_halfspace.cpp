// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys halfspace_section() {
  Keys<HalfspaceOptions> keys("halfspace", "Model `halfspace`", &Case::halfspace);
  keys.choice("surface")
      .says(
          "`planar`: the tangent plane of the contact point; `curved` follows the common surface "
          "of wheel and rail across rolling, with local normals and rolling radii (steady or "
          "frictionless rolling of like materials, no subsurface stress). `auto`: planar unless "
          "the normals of true profiles spread by more than 0.03 rad, fully curved from 0.06 rad "
          "on (docs/track.md).")
      .into(&HalfspaceOptions::surface, {{"auto", SurfaceForm::automatic},
                                         {"planar", SurfaceForm::planar},
                                         {"curved", SurfaceForm::curved}});
  keys.toggle("model_error")
      .says(
          "Estimate the half-space's model error, per quantity and load point, from the true "
          "curvature of wheel and rail (some 0.1 s per load point); needs radii or profiles.")
      .into(&HalfspaceOptions::model_error);
  return keys;
}

}  // namespace rollfem::contact
