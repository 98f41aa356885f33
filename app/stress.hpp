// The command `stress`: stress and displacement below the surface from stored results, without
// solving again. Of the half-space and every theory with tractions on the contact grid by the exact
// integrals over its elements, at any load point; of finite elements by interpolation in the stored
// bodies, at the last one.
#pragma once

#include "app/stress_request.hpp"

namespace rollfem::app {

/// Writes stress.csv, stress.json and figures, prints a table. Throws contact::InputError; nothing
/// is written then.
void stress(const StressRequest& request);

}  // namespace rollfem::app
