// SPDX-License-Identifier: LGPL-2.1-or-later
// The error of a theory relative to the half-space it approximates.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

namespace rollfem::theories {

/// What a theory takes from closed forms, or leaves out.
struct TheoryKind {
  bool with_friction = true;  ///< it has forces, too
  bool hertzian = true;       ///< its patch and pressure without true profiles are Hertz's
};

/// Sets PointResult::model_error of a theory's values: 0 where it is exact for half-spaces,
/// otherwise from a half-space solution of the same scene with 32 elements across, the difference
/// and half of that solution's own bar. Where the half-space has no result, model_error_source
/// states the reason.
void estimate_model_error(const contact::Scene& scene, const TheoryKind& kind,
                          const contact::Progress& progress, contact::ModelResult& theory);

}  // namespace rollfem::theories
