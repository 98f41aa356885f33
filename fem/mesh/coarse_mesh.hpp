// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of bodies: generated with gmsh or read from a user's file, checked,
// and turned into a triangulation. Internal to fem/.
#pragma once

#include "fem/mesh/body_options.hpp"
#include "fem/mesh/surface_shape.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/true_section.hpp"

#include <deal.II/grid/tria.h>

#include <functional>
#include <string>

namespace rollfem::fem {

/// Runs `make` on process 0 and returns its result, or throws its error, on every process.
CoarseBody on_all_processes(MPI_Comm communicator, const std::function<CoarseBody()>& make);

/// Cross-section by gmsh, revolved (wheel) or extruded (rail). Cells under the patch have the size
/// options.cell_size * 2^level.
CoarseBody gmsh_mesh(const SurfaceShape& shape, const BodyOptions& options, int level);

/// The true section of a profile body, extruded or revolved about its axle. The block of cells
/// under the patch follows the surface, its faces lie on the lattice of the contact grid. Tries
/// blocks of coarse cells from the largest that fit down to the finest cells and returns the first
/// good mesh, otherwise the best. Throws contact::InputError.
CoarseBody true_section_mesh(const meshes::TrueSection& outline, const SurfaceShape& shape,
                             const BodyOptions& options);

/// A user's mesh, checked for the body; nodes of its contact faces are moved onto the surface.
/// `options` give the position of the patch. Throws contact::InputError beginning with `name`.
CoarseBody user_mesh(const std::string& path, const std::string& name, const SurfaceShape& shape,
                     const BodyOptions& options);

/// Creates cells, boundary ids, and the chart with these rows as manifold where it is one to one
/// (not across the axle of a whole wheel) and, if only some cells follow the surface, in these.
void create_triangulation(const CoarseBody& coarse, const SurfaceShape& shape,
                          const GradedDepth& rows, dealii::Triangulation<3>& triangulation);

/// The reverse, from the coarsest level.
meshes::HexMesh hex_mesh(const dealii::Triangulation<3>& triangulation);

}  // namespace rollfem::fem
