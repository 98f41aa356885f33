// How far the forces of a finite-element result may be off: what its levels show, and what the
// contact grid alone leaves uncertain.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <vector>

namespace rollfem::fem {

/// Adds the error estimates of the forces (longitudinal_force, lateral_force, spin_moment,
/// traction_coefficient) and of the largest |p_x| to load point k of the finest level. `levels`:
/// at least two, the finest last, each of half the cells of the one before.
void estimate_force_errors(const contact::Scene& scene, std::vector<contact::ModelResult>& levels,
                           std::size_t k, double assumed_order);

}  // namespace rollfem::fem
