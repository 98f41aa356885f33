// Where finite elements need the true sections of wheel and rail: a question of the patch and the
// profiles, which others than finite elements ask before these are chosen.
#pragma once

#include "contact/scene/scene.hpp"

namespace rollfem::halfspace {

/// dz/dy at which a box laid on the surface of a profile ends.
constexpr double steepest_of_box = 1.5;

/// The scene has a patch of true profiles and its bodies are the true sections of wheel and rail,
/// not boxes laid on the surface: as [fem] mesh says, else where a box would not reach far enough.
bool has_true_sections(const contact::Scene& scene);

}  // namespace rollfem::halfspace
