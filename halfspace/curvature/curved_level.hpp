// The contact problem on gently curved bodies: the common driver on
// CurvedCompliance, by defect correction on the half-space.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/solve/contact_run.hpp"

#include <optional>
#include <string>

namespace rollfem::halfspace {

/// All load points on the grid; none where a patch reaches its border. Throws contact::SolveError,
/// contact::InputError.
std::optional<contact::LevelResult> solve_curved_level(const contact::Scene& scene,
                                                       const contact::ContactGrid& grid,
                                                       const std::string& stage_prefix,
                                                       const contact::Progress& progress);

}  // namespace rollfem::halfspace
