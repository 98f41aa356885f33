// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/scene/friction_law.hpp"

#include <cmath>

namespace rollfem::contact {

Friction coulomb(double coefficient) {
  return coefficient == 0.0 ? nullptr : std::make_shared<CoulombFriction>(coefficient);
}

double coefficient_of(const Friction& friction) {
  return friction ? friction->coefficient() : 0.0;
}

Field traction_bound(const Friction& friction, const Field& pressure, const TangentialField& slip) {
  Field bound = Field::Zero(pressure.size());
  if (!friction) return bound;
  const bool slips = slip.x.size() == pressure.size();
  for (Eigen::Index k = 0; k < pressure.size(); ++k)
    bound[k] = friction->bound(pressure[k], slips ? std::hypot(slip.x[k], slip.y[k]) : 0.0).value;
  return bound;
}

}  // namespace rollfem::contact
