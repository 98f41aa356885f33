// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys undeformed_distance_section() {
  Keys<DistanceOptions> keys("undeformed_distance",
                             "Undeformed distance, instead of the one from the radii",
                             &Case::undeformed_distance);
  keys.section().alternatives = true;
  keys.pair("quadratic")
      .symbol("A, B")
      .unit("1/mm")
      .between(1e-9, 1e6)
      .otherwise("from the radii of wheel and rail")
      .says("h = A x^2 + B y^2; the radii may then be omitted.")
      .into(&DistanceOptions::quadratic);
  keys.text("file")
      .otherwise("from the radii of wheel and rail")
      .says(
          "Lines `x, y, h` in mm on a regular lattice, which becomes the potential contact area; "
          "cubics interpolate.")
      .into(&DistanceOptions::values);
  return keys;
}

}  // namespace rollfem::contact
