// SPDX-License-Identifier: LGPL-2.1-or-later
// With it the cases of a test may give the keys of all models, as those of the program.
#pragma once

#include "modelling/registry.hpp"

namespace rollfem::testing {

inline const contact::ModelRegistry registered = modelling::built_in_models();

}  // namespace rollfem::testing
