// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of a body: a coarse mesh (a graded box in chart coordinates, or a given mesh) and octree
// refinement towards the patch.
#pragma once

#include "fem/mesh/body_options.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping.h>

namespace rollfem::fem {

using Triangulation = dealii::parallel::distributed::Triangulation<3>;

/// The mesh of a segment by rollfem. Throws contact::InputError.
void make_mesh(const SurfaceShape& shape, const BodyOptions& options, Triangulation& mesh);

/// On a given coarse mesh, whose cells must keep their orientation under `mapping`. Throws
/// contact::InputError.
void refine_coarse_mesh(const SurfaceShape& shape, const BodyOptions& options,
                        const CoarseBody& coarse, const dealii::Mapping<3>& mapping,
                        Triangulation& mesh);

/// Level of the finest cells above the coarse ones of a segment.
int coarse_level(const BodyOptions& options);

/// Estimated number of unknowns of a body with these options, by counting cells without creating a
/// mesh (within 15 % in the family `structured`). Counting stops at `enough`.
double predicted_unknowns(const BodyOptions& options, double enough);

}  // namespace rollfem::fem
