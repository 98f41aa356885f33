#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys geometry_section() {
  Keys<ContactShapeCase> keys("geometry", "Shape of the contact: of bodies or of endless rollers",
                              &Case::geometry);
  keys.section().alternatives = true;
  keys.choice("shape")
      .says(
          "`point`: a contact that ends across, of radii, profiles or points; `line`: rollers "
          "without ends across, in plane strain, which radii across are left out of. Line contact "
          "is for the models halfspace, hertz and carter, without spin.")
      .into(&ContactShapeCase::shape,
            {{"point", ContactShape::point}, {"line", ContactShape::line}});
  keys.real("width")
      .unit("mm")
      .positive()
      .says(
          "Line contact: the width across that all forces, moments, areas and works are of; 1 "
          "makes them those of one mm.")
      .into(&ContactShapeCase::width);
  keys.real("relative_radius")
      .symbol("R")
      .unit("mm")
      .between(smallest_radius, largest)
      .otherwise("wheel.rolling_radius, on a straight rail")
      .says(
          "Line contact: radius of the roller that has the same distance from a plane as both "
          "bodies have from each other, h = x^2 / (2 R); of two rollers 1/R = 1/R1 + 1/R2.")
      .into(&ContactShapeCase::relative_radius);
  keys.real("reference_distance")
      .unit("mm")
      .positive()
      .otherwise("the relative radius")
      .says(
          "Line contact: displacements are relative to those at this distance along the surface "
          "from a line load; approach, elastic energy, shifts and transients depend on it, steady "
          "rolling does not.")
      .into(&ContactShapeCase::reference_distance);
  return keys;
}

}  // namespace rollfem::contact
