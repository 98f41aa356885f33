// SPDX-License-Identifier: LGPL-2.1-or-later
// Cross-sections in quadrilaterals by gmsh: a block of equal cells under the patch that follows the
// profile exactly, and free quadrilaterals in the polygon around it.
#pragma once

#include "meshes/segment_mesh.hpp"
#include "meshes/true_section.hpp"

#include <functional>

namespace rollfem::meshes {

/// One session at a time in a process, because gmsh has global state.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
};

/// Parameters of a cross-section. Coordinates are y and v, where v is the distance from z = 0 into
/// the body.
struct SectionOptions {
  std::function<double(double)> drop;  ///< v of the surface at y, mm; 0 at y = 0
  double half_width = 60;              ///< mm, reaches to |y| = half_width
  double depth = 60;                   ///< mm, v at the far side, more where the profile drops far
  double fine_half_width = 5;  ///< mm, smallest extent of cells of cell_size along the profile
  double fine_depth = 2;       ///< mm, their smallest depth
  double cell_size = 1;        ///< mm, of the coarse cells in that fine block
  /// mm, of a row that equal rows have at the given depth.
  std::function<double(double)> row_depth = [](double even) { return even; };
  bool half = false;  ///< only y >= 0
};

/// A block of equal cells under the patch, quadrilaterals that grow from there to the outside.
/// Surface nodes lie exactly on the profile. Throws contact::InputError when the block does not fit
/// into the section or gmsh fails.
Section mesh_section(const SectionOptions& options);

/// Quadrilaterals of a block under the patch (first, row by row) and around it, coarser with the
/// distance.
struct BlockedSection {
  Section section;
  std::size_t block_quads = 0;
};

/// The block of equal cells under the patch: columns on a lattice of y, rows at z below the
/// surface.
struct SectionBlock {
  std::function<double(double)> height;  ///< z of the surface over y
  double middle = 0.0;                   ///< mm, y of its middle
  double cell_size = 1.0;                ///< mm
  int half_columns = 2;                  ///< to each side of the middle
  int rows = 2;                          ///< even
  std::function<double(double)> row_depth = [](double even) { return even; };  ///< as above
};

/// The whole section; its points are y and z. Edges: `contact` on top of the block, `fixed` on the
/// clamped line; all others are free. Throws contact::InputError when gmsh fails or the block does
/// not fit.
BlockedSection mesh_true_section(const TrueSection& outline, const SectionBlock& block);

}  // namespace rollfem::meshes
