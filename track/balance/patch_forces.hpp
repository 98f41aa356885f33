// Tangential forces of a scene by the half-space on a coarse
// grid, used to balance loads and rotation.
#pragma once

#include "contact/scene/scene.hpp"
#include "track/motion/wheelset_motion.hpp"

#include <vector>

namespace rollfem::track {

/// Of the balance. Forces to about half a percent of mu F_z (docs/accuracy.md); what of it enters
/// the balance is smaller by the sine of the contact angle, and the rotation feels it in both
/// wheels alike.
inline constexpr int elements_of_balance = 24;

/// One for each load point of the scene. Throws contact::SolveError.
std::vector<PatchForce> patch_forces(const contact::Scene& scene,
                                     int elements_across = elements_of_balance);

}  // namespace rollfem::track
