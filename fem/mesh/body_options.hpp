// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of a body's mesh, and its boundary numbers.
#pragma once

#include "fem/fem_options.hpp"
#include "fem/mesh/graded_depth.hpp"
#include "meshes/hex_mesh.hpp"
#include "scene/scene.hpp"

#include <deal.II/base/types.h>

#include <optional>
#include <utility>
#include <vector>

namespace rollfem::fem {

/// Boundary ids of every body.
enum BoundaryId : dealii::types::boundary_id {
  free_surface = 0,  ///< deal.II's default: sides of a given mesh outside its groups
  contact_surface = 1,
  symmetry_plane = 2,
  far_boundary = 3
};

/// Parameters of the mesh.
struct BodyOptions {
  double cell_size = 0.5;       ///< mm, cells in the fine region (s and t), exactly
  double fine_half_length = 5;  ///< mm, smallest extent of the fine region in s
  double fine_half_width = 5;   ///< mm, and in t to both sides of `middle`
  double middle = 0;            ///< mm, t of the middle of the patch; an integer number of cells
  double extent = 60;           ///< mm, half length, half width and depth of the segment
  bool half = false;            ///< only t >= 0, symmetry plane t = 0
  int degree = 2;
  double fine_depth = 2;  ///< depth of the fine region below the surface, in rows of cells
  double growth = 1;      ///< cells may be cell_size + growth * distance from the fine region
  double speed = 0;       ///< mm/s, rolling speed: inertia in the stiffness (rolling_inertia.hpp)
  bool yields = false;    ///< plastic flow: its volume must not change, see projects_dilatation()
  double plastic_half_width = 0;  ///< mm, of the streamlines that may yield
  double plastic_depth = 0;       ///< in rows of cells
  GradedDepth rows;               ///< where they are; cells are as long and wide as without
  MeshFamily family = MeshFamily::structured;
  std::optional<double> half_length = std::nullopt;  ///< mm, instead of extent along s
  std::optional<double> half_width = std::nullopt;   ///< mm, instead of extent along t
  std::optional<double> depth = std::nullopt;        ///< mm, instead of extent inwards
  double reach_s() const { return half_length.value_or(extent); }
  double reach_t() const { return half_width.value_or(extent); }
  double reach_depth() const { return depth.value_or(extent); }
};

/// For a given coarse mesh: cells that are bent to the surface. In the others new nodes lie on
/// straight lines, in a wheel on circles about its axle.
struct CoarseBody {
  CoarseBody() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a mesh that follows the surface everywhere
  CoarseBody(meshes::HexMesh given) : mesh(std::move(given)) {}

  meshes::HexMesh mesh;
  std::vector<bool> follows_surface;  ///< for each cell; empty: all of them
};

}  // namespace rollfem::fem
