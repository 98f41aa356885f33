// Declarations of the options of the model halfspace.
#include "contact/case/case_key_parts.hpp"

namespace rollfem::contact {

std::vector<Key> halfspace_keys() {
  return {word_key<SurfaceForm>(
      "halfspace", "surface", {"planar", "curved"},
      "`planar` takes the contact in the tangent plane of the contact point; `curved` follows the "
      "common surface of wheel and rail across: distance and forces along local normals, slip of "
      "the local rolling radius. For steady or frictionless rolling of like materials.",
      [](Case& c) -> SurfaceForm& { return c.halfspace.surface; })};
}

}  // namespace rollfem::contact
