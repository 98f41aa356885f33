// SPDX-License-Identifier: LGPL-2.1-or-later
// Registration of the models "fem" and "hybrid", whose finite-element library is opened when they
// run.
#pragma once

#include "contact/solve/model.hpp"
#include "hybrid/hybrid_model.hpp"

namespace rollfem::modelling {

/// Finds the correction of half-spaces for the bodies of a scene: in the cache
/// (correction_cache.hpp), otherwise by the finite-element library, which it opens. Throws
/// contact::InputError as open_fem_library does. Collective if several processes run.
hybrid::SmoothParts find_smooth_parts(const contact::Scene& scene,
                                      const contact::Progress& progress);

/// Whether the correction of the scene is in the cache.
bool correction_is_kept(const contact::Scene& scene);

contact::ModelInfo hybrid_model();
contact::ModelInfo fem_model();

}  // namespace rollfem::modelling
