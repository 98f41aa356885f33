// SPDX-License-Identifier: LGPL-2.1-or-later
// Theories of an elliptic patch on true profiles: they use the ellipse with the area and ratio of
// extents of the half-space patch, centred at its centre of pressure.
#pragma once

#include "contact/solve/model.hpp"

namespace rollfem::theories {

/// Runs a theory of an elliptic patch on the equivalent ellipse of a case with `patch`.
contact::ModelResult run_on_ellipse(const contact::Model& model, const contact::Scene& scene,
                                    const contact::Progress& progress);

/// Hertz's theory with the relative curvatures at the contact point of the patch. Throws
/// contact::InputError where they define no ellipse; notes the half-space result.
contact::ModelResult run_hertz_of_patch(const contact::Scene& scene,
                                        const contact::Progress& progress);

/// Runs a model that supports one normal force separately for each load point where loads differ,
/// all on one grid, and iterates a load that is not along z together with friction.
contact::ModelResult run_each_load(const contact::Model& model, const contact::Scene& scene,
                                   const contact::Progress& progress);

}  // namespace rollfem::theories
