// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and displacement below the surface from stored results, without solving again. For the
// half-space and every theory with tractions on the contact grid by exact integrals over its
// elements, for finite elements by interpolation in the stored bodies.
#pragma once

#include "contact/solve/model.hpp"
#include "models/stress/stress_request.hpp"
#include "postprocess/stress/stress_report.hpp"

#include <string>
#include <vector>

namespace rollfem::modelling {

/// `warnings` receives notes for the user, and what was left out and why. Throws
/// contact::InputError if nothing is left.
postprocess::StressReport stored_stress(const StressRequest& request,
                                        const contact::ModelRegistry& models,
                                        std::vector<std::string>& warnings);

}  // namespace rollfem::modelling
