// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys given_pressure_section() {
  Keys<GivenPressure> keys("given_pressure",
                           "Hertz's pressure on a given ellipse instead of the normal problem",
                           &Case::given_pressure);
  keys.section().alternatives = true;
  keys.real("semi_axis_x")
      .symbol("a")
      .unit("mm")
      .positive()
      .otherwise("the normal problem is solved")
      .says("Semi-axis of the ellipse along rolling; the radii may then be omitted.")
      .into(&GivenPressure::semi_axis_x);
  keys.real("semi_axis_y")
      .symbol("b")
      .unit("mm")
      .positive()
      .otherwise("the normal problem is solved")
      .says("Semi-axis of the ellipse across rolling.")
      .into(&GivenPressure::semi_axis_y);
  keys.real("max_pressure")
      .symbol("p_0")
      .unit("MPa")
      .positive()
      .otherwise("from load.normal_force")
      .says("Pressure in the middle of the ellipse, instead of load.normal_force.")
      .into(&GivenPressure::max_pressure);
  return keys;
}

}  // namespace rollfem::contact
