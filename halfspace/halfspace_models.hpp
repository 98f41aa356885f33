// SPDX-License-Identifier: LGPL-2.1-or-later
// The model of this folder with its name, capabilities and options.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::halfspace {

struct HalfspaceOptions {
  bool model_error = false;  ///< is estimated
};

/// halfspace alone.
const contact::ModelRegistry& models();

}  // namespace rollfem::halfspace
