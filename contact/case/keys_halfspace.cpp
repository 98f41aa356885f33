#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys halfspace_section() {
  Keys<HalfspaceCase> keys("halfspace", "Model `halfspace`", &Case::halfspace);
  keys.choice("surface")
      .says(
          "`planar` takes the contact in the tangent plane of the contact point; `curved` follows "
          "the common surface of wheel and rail across: distance and forces along local normals, "
          "slip of the local rolling radius. For steady or frictionless rolling of like "
          "materials. `auto` is the plane, but where the normals of a contact of true profiles "
          "spread by more than 0.03 rad the surface follows them, all the way from 0.06 rad on "
          "(docs/track.md); without stresses below the surface.")
      .into(&HalfspaceCase::surface, {{"auto", SurfaceForm::automatic},
                                      {"planar", SurfaceForm::planar},
                                      {"curved", SurfaceForm::curved}});
  keys.toggle("model_error")
      .says(
          "Estimate what the half-space leaves out, per quantity and load point, from wheel and "
          "rail as curved as they are: some 0.1 s a load point. They need radii or profiles.")
      .into(&HalfspaceCase::model_error);
  return keys;
}

}  // namespace rollfem::contact
