// SPDX-License-Identifier: LGPL-2.1-or-later
// Coarse meshes of bodies: generated with gmsh or read from a user's file, checked,
// and turned into a triangulation. Internal to fem/.
#pragma once

#include "fem/mesh/body_options.hpp"
#include "fem/mesh/surface_shape.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/true_section.hpp"

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace rollfem::fem {

/// Cross-section by gmsh, revolved (wheel) or extruded (rail). Cells under the patch have the size
/// options.cell_size * 2^level. Created on process 0 and sent to the others.
meshes::HexMesh gmsh_mesh(const SurfaceShape& shape, const BodyOptions& options, int level,
                          MPI_Comm communicator);

/// The true section of a profile body, extruded or revolved about its axle. The block of cells
/// under the patch follows the surface, its faces lie on the lattice of the contact grid. Created
/// on process 0 and sent to the others. Throws contact::InputError.
CoarseBody true_section_mesh(const meshes::TrueSection& outline, const SurfaceShape& shape,
                             const BodyOptions& options, MPI_Comm communicator);

/// The same on this process only. Tries blocks of coarse cells from the largest that fit down to
/// the finest cells and returns the first good mesh, otherwise the best.
CoarseBody make_true_section_mesh(const meshes::TrueSection& outline, const SurfaceShape& shape,
                                  const BodyOptions& options);

/// A user's mesh, checked for the body; nodes of its contact faces are moved onto the surface.
/// `options` give the position of the patch. Read on process 0 and sent to the others, where errors
/// are thrown, too. Throws contact::InputError beginning with `name`.
meshes::HexMesh user_mesh(const std::string& path, const std::string& name,
                          const SurfaceShape& shape, const BodyOptions& options,
                          MPI_Comm communicator);

/// Creates cells, boundary ids, and the chart as manifold where it is one to one (not across the
/// axle of a whole wheel) and, unless `follows_surface` is empty, only in the cells marked there.
void create_triangulation(const meshes::HexMesh& mesh, const SurfaceShape& shape,
                          dealii::Triangulation<3>& triangulation,
                          const std::vector<bool>& follows_surface = {});

/// The reverse, from the coarsest level.
meshes::HexMesh hex_mesh(const dealii::Triangulation<3>& triangulation);

}  // namespace rollfem::fem
