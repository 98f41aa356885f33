// SPDX-License-Identifier: LGPL-2.1-or-later
// What replaces the shapes of wheel and rail, and the contact grid.
#include "case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

SectionWithKeys undeformed_distance_section() {
  Keys<DistanceOptions> keys("undeformed_distance", "Instead of radii", &Case::undeformed_distance);
  keys.section().alternatives = true;
  keys.add("quadratic", &DistanceOptions::quadratic, symbol("A, B"), unit("1/mm"),
           between(1e-9, 1e6), otherwise("from the radii"), "h = A x^2 + B y^2.");
  keys.add("file", &DistanceOptions::values, names_file, otherwise("from the radii"),
           "Lines `x, y, h` in mm on a regular lattice, the potential contact area; cubics "
           "interpolate.");
  return keys;
}

SectionWithKeys given_pressure_section() {
  Keys<GivenPressure> keys("given_pressure",
                           "Hertz's pressure on a given ellipse instead of the normal problem",
                           &Case::given_pressure);
  keys.section().alternatives = true;
  keys.add("semi_axis_x", &GivenPressure::semi_axis_x, symbol("a"), unit("mm"), positive(),
           otherwise("not given"), "Semi-axis of the ellipse along rolling.");
  keys.add("semi_axis_y", &GivenPressure::semi_axis_y, symbol("b"), unit("mm"), positive(),
           otherwise("not given"), "Semi-axis of the ellipse across rolling.");
  keys.add("max_pressure", &GivenPressure::max_pressure, symbol("p_0"), unit("MPa"), positive(),
           otherwise("from load.normal_force"), "Pressure in its middle.");
  return keys;
}

SectionWithKeys contact_grid_section() {
  Keys<GridOptions> keys("contact_grid", "Elements of the contact area of the half-space model",
                         &Case::contact_grid);
  keys.section().alternatives = true;
  keys.add(
      KeyKind::integer, "elements_across",
      Access<GridOptions>{
          [](const GridOptions& grid) {
            return grid.cell_size ? KeyValue() : value_of(grid.elements_across);
          },
          [](GridOptions& grid, const KeyValue& value) { assign(grid.elements_across, value); }},
      between(4, 2000), "Contact elements along the smaller extent of the patch.");
  keys.add("cell_size", &GridOptions::cell_size, symbol("dx, dy"), unit("mm"), positive(),
           otherwise("from elements_across"), "Size of a contact element along x and y.");
  keys.add("extent", &GridOptions::extent, unit("mm"), positive(),
           otherwise("from the size of the patch"),
           "Extent of the potential contact area, also of fem, if the expected patches do not "
           "cover it.");
  keys.add("middle", &GridOptions::middle, unit("mm"), within(1e6),
           "Its middle; with profiles relative to the contact point, without an extent to the "
           "middle of the patch.");
  return keys;
}

}  // namespace

Sections contact_sections() {
  return {undeformed_distance_section(), given_pressure_section(), contact_grid_section()};
}

}  // namespace rollfem::contact
