// How several separate patches of one wheel share its load: the wheel sinks vertically by one way,
// of which every patch feels the part along its own normal.
#pragma once

#include "contact/scene/scene.hpp"

#include <vector>

namespace rollfem::halfspace {

struct SharedLoad {
  double sinking = 0.0;               ///< mm, vertical, from first contact of the wheel
  std::vector<double> normal_forces;  ///< N, one for each scene, 0 where it does not touch
};

/// Normal forces N_i with sum N_i cos(delta_i) = vertical_force (N), at the approaches
/// w cos(delta_i) - separation_i of one sinking w. `scenes`: patches with a `place`, of
/// which contact angle and separation (along the normal) are taken; their loads are not read.
/// Friction and the elastic influence of one scene on another are left out. Forces at an approach
/// are those of ForceLaw. Throws contact::SolveError when no sinking carries the load,
/// contact::InputError for a scene without profiles or place or a force that is not positive.
SharedLoad share_load(const std::vector<contact::Scene>& scenes, double vertical_force);

}  // namespace rollfem::halfspace
