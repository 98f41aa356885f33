// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys geometry_section() {
  Keys<ContactShapeCase> keys("geometry",
                              "Shape of the contact: bodies of finite width or endless rollers",
                              &Case::geometry);
  keys.section().alternatives = true;
  keys.choice("shape")
      .says(
          "`point`: finite width, given by radii, profiles or points; `line`: endless rollers in "
          "plane strain, without transverse radii and spin (models halfspace, hertz, carter).")
      .into(&ContactShapeCase::shape,
            {{"point", ContactShape::point}, {"line", ContactShape::line}});
  keys.real("width")
      .unit("mm")
      .positive()
      .says("Line contact: width to which forces, moments, areas and work refer; 1: per mm.")
      .into(&ContactShapeCase::width);
  keys.real("relative_radius")
      .symbol("R")
      .unit("mm")
      .between(smallest_radius, largest)
      .otherwise("wheel.rolling_radius, on a straight rail")
      .says(
          "Line contact: R of the undeformed distance h = x^2 / (2 R); for two rollers 1/R = 1/R1 "
          "+ 1/R2.")
      .into(&ContactShapeCase::relative_radius);
  keys.real("reference_distance")
      .unit("mm")
      .positive()
      .or_inf()
      .otherwise("the relative radius")
      .says(
          "Line contact: displacements are relative to the surface at this distance from a line "
          "load, with inf to distant points, in the middle of a load as long as `width`; approach, "
          "elastic energy, shifts and transients depend on it.")
      .into(&ContactShapeCase::reference_distance);
  return keys;
}

}  // namespace rollfem::contact
