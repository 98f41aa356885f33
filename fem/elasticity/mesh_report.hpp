// SPDX-License-Identifier: LGPL-2.1-or-later
// The meshes of a case with their quality, without solving. Free of deal.II, like model.hpp.
#pragma once

#include "result/result.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace rollfem::fem {

/// Mesh of wheel or rail. Figures refer to the refined cells with straight edges between their
/// corners.
struct MeshedBody {
  std::string name;            ///< "wheel", "rail"
  std::string msh;             ///< coarse mesh as a gmsh file, accepted as [wheel] mesh
  contact::BodyField refined;  ///< refined cells, without displacement
  long coarse_cells = 0;
  long cells = 0;
  long unknowns = 0;
  int levels = 0;                         ///< refinement levels of the coarse cells at the patch
  double shortest_edge = 0.0;             ///< mm
  double longest_edge = 0.0;              ///< mm
  double size_in_patch = 0.0;             ///< mm, longest side of a contact face under the patch
  double smallest_scaled_jacobian = 1.0;  ///< 1: box, 0: flat at a corner
  double largest_aspect_ratio = 1.0;
};

/// Wheel and rail as meshed by `run`; a rigid one is omitted. Collective; complete on process 0.
/// Throws contact::InputError.
std::vector<MeshedBody> mesh_case(const contact::Scene& scene);

}  // namespace rollfem::fem
