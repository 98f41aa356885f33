#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys halfspace_section() {
  Keys<HalfspaceCase> keys("halfspace", "Model `halfspace`", &Case::halfspace);
  keys.choice("surface")
      .says(
          "`planar` takes the contact in the tangent plane of the contact point; `curved` follows "
          "the common surface of wheel and rail across: distance and forces along local normals, "
          "slip of the local rolling radius. For steady or frictionless rolling of like "
          "materials.")
      .into(&HalfspaceCase::surface,
            {{"planar", SurfaceForm::planar}, {"curved", SurfaceForm::curved}});
  return keys;
}

}  // namespace rollfem::contact
