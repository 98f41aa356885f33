// SPDX-License-Identifier: LGPL-2.1-or-later
// How wheel and rail take the heat of friction, as a case gives it.
#pragma once

namespace rollfem::contact {

/// Together with Material::density; steel by default.
struct BodyHeat {
  double conductivity = 50.0;  ///< lambda, W/(m K), which is N/(s K)
  double capacity = 450.0;     ///< c, J/(kg K)
  double expansion = 1.2e-5;   ///< alpha, 1/K
  double temperature = 20.0;   ///< degC, before contact
  double limit = 700.0;        ///< degC, above which results warn
};

}  // namespace rollfem::contact
