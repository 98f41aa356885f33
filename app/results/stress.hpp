// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `stress`: stress and displacement below the surface from stored results, without
// solving again. The half-space and theories with tractions on the contact grid use exact integrals
// over the elements; finite elements use interpolation in the stored bodies.
#pragma once

#include "app/results/stress_request.hpp"
#include "contact/solve/model.hpp"

namespace rollfem::app {

/// Writes stress.csv, stress.json and figures, prints a table. Throws contact::InputError and then
/// writes nothing.
void stress(const StressRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
