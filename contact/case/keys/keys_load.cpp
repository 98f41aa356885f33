// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys load_section() {
  const char* one_of = "give exactly one";
  Keys<Load> keys("load", "Force or approach that presses the bodies together", &Case::load);
  keys.section().alternatives = true;
  keys.real("normal_force")
      .symbol("F_z")
      .unit("N")
      .between(1e-6, largest_force)
      .example("50e3")
      .otherwise(one_of)
      .says("Force that presses the wheel on the rail.")
      .into(&Load::normal_force);
  keys.real("approach")
      .symbol("delta")
      .unit("mm")
      .between(1e-9, 1e6)
      .otherwise(one_of)
      .says(
          "Approach (penetration) of distant points of the two bodies, instead of the force; less "
          "than a tenth of the smallest radius.")
      .into(&Load::approach);
  keys.real("vertical_force")
      .symbol("Q")
      .unit("N")
      .between(1e-6, largest_force)
      .otherwise(one_of)
      .says(
          "With profiles: vertical force on each wheel, carried by the normal forces and friction "
          "of all its patches together.")
      .into(&Load::vertical_force);
  return keys;
}

}  // namespace rollfem::contact
