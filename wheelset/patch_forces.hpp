// Tangential forces of a scene from the half-space on a coarse grid: what loads and rotation are
// balanced with.
#pragma once

#include "contact/scene/scene.hpp"
#include "meshes/track/wheelset_motion.hpp"

#include <vector>

namespace rollfem::wheelset {

/// One for each load point of the scene. Throws contact::SolveError.
std::vector<meshes::PatchForce> patch_forces(const contact::Scene& scene);

}  // namespace rollfem::wheelset
