// SPDX-License-Identifier: LGPL-2.1-or-later
// Theories of an elliptic patch on true profiles: they use the ellipse with the area and ratio of
// extents of the half-space patch, centred at its centre of pressure.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"
#include "contact/solve/model.hpp"
#include "halfspace/patch/patch_search.hpp"

namespace rollfem::theories {

/// The ellipse, and the case with its Hertz pressure given in a frame at its centre.
struct EquivalentEllipse {
  halfspace::ExpectedPatch patch;               ///< of the half-space
  double semi_axis_x = 0.0, semi_axis_y = 0.0;  ///< mm
  contact::Scene scene;  ///< creepages at the centre of the ellipse: (xi - phi y, eta + phi x)
};
EquivalentEllipse equivalent_ellipse(const contact::Scene& scene);

/// Converts results in the frame of the ellipse into results of the case with profiles: grid, spin
/// moment, creepages and approach, with a note on the equivalent ellipse.
void return_to_patch_frame(const contact::Scene& scene, const EquivalentEllipse& ellipse,
                           contact::ModelResult& result);

/// Runs a theory of an elliptic patch on the equivalent ellipse of a case with `patch`. `no_spin`:
/// the theory has no spin; it is neglected with a note.
contact::ModelResult run_on_ellipse(const contact::Model& model, const contact::Scene& scene,
                                    const contact::Progress& progress, bool no_spin);

/// Hertz's theory with the relative curvatures at the contact point of the patch. Throws
/// contact::InputError where they define no ellipse; notes the half-space result.
contact::ModelResult run_hertz_of_patch(const contact::Scene& scene,
                                        const contact::Progress& progress);

/// Runs a model that supports one normal force separately for each load point where loads differ,
/// all on one grid, and iterates a load that is not along z together with friction.
contact::ModelResult run_each_load(const contact::Model& model, const contact::Scene& scene,
                                   const contact::Progress& progress);

}  // namespace rollfem::theories
