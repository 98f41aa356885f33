// SPDX-License-Identifier: LGPL-2.1-or-later
// How wheel and rail with true profiles are meshed, and how far their profiles are gentle beside
// the patch: questions that others than finite elements ask before these are chosen.
#pragma once

#include "contact/scene/scene.hpp"

namespace rollfem::halfspace {

/// The scene has a patch of true profiles and its bodies are the true sections of wheel and rail,
/// as [fem] mesh says, not boxes laid on the surface.
bool has_true_sections(const contact::Scene& scene);

/// A box on the surface reaches this many larger half sizes of the patch to each side at least,
/// however steep the profile is there.
constexpr double least_box_reach = 2.5;

/// How far the profiles of the bodies that are not rigid go to both sides of y = `middle` before
/// they end or are steeper than 56 degrees, mm; infinite without profiles.
double gentle_reach(const contact::Scene& scene, double middle);

/// Beside the patch a profile becomes steep nearer than the least reach of a box.
bool is_steep(const contact::Scene& scene);

}  // namespace rollfem::halfspace
