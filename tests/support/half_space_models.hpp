// SPDX-License-Identifier: LGPL-2.1-or-later
// The models that need no finite elements.
#pragma once

#include "halfspace/halfspace_models.hpp"
#include "theories/theory_models.hpp"

namespace rollfem::testing {

/// The theories and halfspace.
inline const contact::ModelRegistry& half_space_models() {
  static const contact::ModelRegistry all =
      contact::ModelRegistry(theories::models()).add(halfspace::models().at("halfspace"));
  return all;
}

}  // namespace rollfem::testing
