// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys contact_grid_section() {
  Keys<GridOptions> keys("contact_grid", "Elements of the contact area of the half-space model",
                         &Case::contact_grid);
  keys.section().alternatives = true;
  keys.integer("elements_across")
      .between(4, 2000)
      .says("Contact elements along the smaller extent of the patch; not with cell_size.")
      .by(
          [](const GridOptions& grid) {
            return grid.cell_size ? KeyValue() : value_of(grid.elements_across);
          },
          [](GridOptions& grid, const KeyValue& value) { assign(grid.elements_across, value); });
  keys.pair("cell_size")
      .symbol("dx, dy")
      .unit("mm")
      .positive()
      .otherwise("from elements_across")
      .says("Size of a contact element, [along x, along y].")
      .into(&GridOptions::cell_size);
  keys.pair("extent")
      .unit("mm")
      .positive()
      .otherwise("from the size of the patch")
      .says(
          "Extent of the potential contact area, [along x, along y], also of fem, if the expected "
          "patches do not cover it.")
      .into(&GridOptions::extent);
  keys.pair("middle")
      .unit("mm")
      .within(1e6)
      .says(
          "Its middle, [x, y]; with profiles relative to the contact point, without an extent to "
          "the middle of the patch.")
      .into(&GridOptions::middle);
  return keys;
}

}  // namespace rollfem::contact
