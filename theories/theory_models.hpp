// SPDX-License-Identifier: LGPL-2.1-or-later
// The models of this folder with their names, capabilities and options.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// Simplest first: hertz, linear, vermeulen-johnson, polach, carter, fastsim, fastrip, strip.
const contact::ModelRegistry& models();

}  // namespace rollfem::theories
