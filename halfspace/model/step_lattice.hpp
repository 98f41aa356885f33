// SPDX-License-Identifier: LGPL-2.1-or-later
// A step of a wheel whose contact has been elsewhere (contact::StepPast): its grids on the lattice
// of the material, and the displacements by the tractions that earlier steps have left there.
#pragma once

#include "contact/solve/contact_run.hpp"
#include "scene/scene.hpp"
#include "scene/step_past.hpp"

#include <cstddef>

namespace rollfem::halfspace {

/// The scene on the lattice of one level of its past, with that level alone.
contact::Scene on_lattice(const contact::Scene& scene, const contact::PastLevel& level);

/// The past of such a scene on a grid of its lattice, which need not hold all elements that were in
/// contact: u' = A p', by the half-space on a grid that holds them too.
contact::History inherited_on(const contact::Scene& scene, const contact::ChartedGeometry& geometry,
                              const contact::ContactGrid& grid);

/// What the last load point of a level leaves: the elements between the outermost ones with
/// traction or plastic displacement.
contact::PastPatch left_by(const contact::LevelResult& solved);

}  // namespace rollfem::halfspace
