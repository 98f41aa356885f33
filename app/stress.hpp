// The command `stress`: stress and displacement below the surface from stored results, without
// solving again. Of the half-space and every theory with tractions on the contact grid by the exact
// integrals over its elements, of finite elements by interpolation in the bodies, at the load
// points that keep them.
#pragma once

#include "app/stress_request.hpp"
#include "contact/solve/models.hpp"

namespace rollfem::app {

/// Writes stress.csv, stress.json and figures, prints a table. Throws contact::InputError; nothing
/// is written then.
void stress(const StressRequest& request, const contact::ModelRegistry& models);

}  // namespace rollfem::app
