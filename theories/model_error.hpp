// The error of a theory relative to the half-space it approximates.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

namespace rollfem::theories {

/// Sets PointResult::model_error of a theory's values from a half-space solution of the same scene
/// with 32 elements across: the difference, and half of that solution's own bar. `with_friction`:
/// the theory has forces, too. Where the half-space has no result model_error_source says why.
void estimate_model_error(const contact::Scene& scene, bool with_friction,
                          contact::ModelResult& theory);

}  // namespace rollfem::theories
