// Tangential forces of a scene from the half-space on a coarse grid: what loads and rotation are
// balanced with.
#pragma once

#include "contact/case.hpp"

#include <vector>

namespace rollfem::wheelset {

/// Forces on the wheel in the patch frame, N.
struct PatchForce {
  double longitudinal = 0.0;
  double lateral = 0.0;
  double normal = 0.0;
};

/// One for each load point of the scene. Throws contact::SolveError.
std::vector<PatchForce> patch_forces(const contact::Case& scene);

}  // namespace rollfem::wheelset
