// SPDX-License-Identifier: LGPL-2.1-or-later
// Refinement levels of the half-space in a study.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::halfspace {

/// Contact elements: the grid of the case is the third of five levels.
contact::Refinement contact_grid();

}  // namespace rollfem::halfspace
