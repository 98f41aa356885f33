// SPDX-License-Identifier: LGPL-2.1-or-later
// Registration of the model "hybrid". Its finite-element part is
// in a library that is opened when it runs.
#pragma once

#include "contact/solve/model.hpp"
#include "hybrid/model.hpp"

namespace rollfem::modelling {

/// Finds what the bodies of a scene add to half-spaces: in the cache (correction_cache.hpp), else
/// by the library, which is then opened; throws contact::InputError as open_fem_library does.
/// Collective where several processes run.
hybrid::FindParts smooth_parts_finder();

/// That of the scene is in the cache.
bool correction_is_kept(const contact::Scene& scene);

contact::ModelInfo hybrid_model();

}  // namespace rollfem::modelling
