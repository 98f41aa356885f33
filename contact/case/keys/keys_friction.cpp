// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys friction_section() {
  Keys<Case> keys("friction", "Friction between wheel and rail", whole_case());
  keys.real("coefficient")
      .symbol("mu")
      .between(0.0, 1000.0)
      .required("0.55")
      .says(
          "Coulomb's coefficient of friction, the same for adhesion and slip; 0 is frictionless, "
          "otherwise at least 1e-12.")
      .into(&Case::friction_coefficient);
  return keys;
}

}  // namespace rollfem::contact
