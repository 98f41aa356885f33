// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of the far boundary of a case, and the error of the approach due to it.
#pragma once

#include "contact/scene/scene.hpp"

#include <string>

namespace rollfem::fem {

/// As the case says; if it does not, that of a half-space under a point load where the program
/// meshes both bodies as boxes on the surface or around it, and clamped otherwise (true sections
/// have free sides, which a half-space has not).
contact::FarBoundary far_boundary_of(const contact::Scene& scene);

/// Upper estimate, mm, of what the approach at this force (N) would change by in segments that
/// reach beyond `extent` (mm). Clamped: the half-spaces' displacement there. Point load: what its
/// displacement there is off, by the spread of the pressure and the curvature of the bodies.
/// Derivation: docs/theory.md, "Far boundary".
double approach_left_out(const contact::Scene& scene, double normal_force, double extent);

/// What the results say about it.
std::string far_boundary_note(const contact::Scene& scene, double extent);

}  // namespace rollfem::fem
