// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `stress`: stress and displacement below the surface from stored results, without
// solving again. For the half-space and every theory with tractions on the contact grid by
// exact integrals over its elements, for finite elements by interpolation in the stored
// bodies.
#pragma once

#include "app/results/stress_request.hpp"
#include "contact/solve/model.hpp"

namespace rollfem::app {

/// Writes stress.csv, stress.json and figures, prints a table. Throws contact::InputError; nothing
/// is written then.
void stress(const StressRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
