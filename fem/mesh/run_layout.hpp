// SPDX-License-Identifier: LGPL-2.1-or-later
// The layout of one level of the model fem before anything is meshed: expected patch, contact grid,
// options of the bodies.
#pragma once

#include "base/grid.hpp"
#include "fem/mesh/body_options.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "halfspace/patch/profile_reach.hpp"
#include "scene/scene.hpp"

namespace rollfem::fem {

using halfspace::PatchBox;
using halfspace::PatchSearch;

/// FE cell size of the case: [fem] cell_size, or an eighth of the smaller semi-axis.
double default_cell_size(const contact::Scene& scene);

struct RunLayout {
  PatchBox patch;
  contact::ContactGrid grid;  ///< square elements on the lattice of the FE faces: one face each,
                              ///< of degree 1 two by two
  BodyOptions bodies;
};
/// Throws contact::InputError when the profiles cannot be meshed over this extent.
RunLayout run_layout(const contact::Scene& scene, double cell);

/// Of one body, from RunLayout::bodies: where steel may yield, cells are as fine as in the contact,
/// as deep as the stress below the middle of the patch exceeds the yield stress.
BodyOptions options_of(const contact::Scene& scene, bool is_wheel, const BodyOptions& both);

/// Whether a body is heated, and its first row (BodyOptions of its own) at most a third of the
/// heated layer.
bool resolves_heat(const contact::Scene& scene, bool is_wheel, const BodyOptions& own);

}  // namespace rollfem::fem
