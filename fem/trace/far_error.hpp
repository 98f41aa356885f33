// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of the far boundary of a case, and the error of the approach due to it.
#pragma once

#include "contact/scene/scene.hpp"

#include <string>

namespace rollfem::fem {

/// As given in the case; by default that of a half-space under a point load if rollfem meshes both
/// bodies as boxes on the surface or around it, and clamped otherwise (true sections have free
/// sides, unlike a half-space).
contact::FarBoundary far_boundary_of(const contact::Scene& scene);

/// Upper estimate, mm, of the change of the approach at this force (N) in segments larger than
/// `extent` (mm). Clamped: the half-spaces' displacement there. Point load: error of its
/// displacement there, from the spread of the pressure and the curvature of the bodies. Derivation:
/// docs/theory.md, "Far boundary".
double approach_left_out(const contact::Scene& scene, double normal_force, double extent);

/// Note for the results.
std::string far_boundary_note(const contact::Scene& scene, double extent);

}  // namespace rollfem::fem
