// SPDX-License-Identifier: LGPL-2.1-or-later
// Shares the load of a wheel among its separate contacts: the wheel sinks vertically, each contact
// approaches by the component along its own normal less the displacement due to the others.
#pragma once

#include "contact/scene/scene.hpp"

#include <array>
#include <vector>

namespace rollfem::halfspace {

/// Load of one contact, without friction.
struct PatchLoad {
  double normal_force = 0.0;   ///< N, along z of the patch; 0 without contact
  double lateral_force = 0.0;  ///< N, of the pressure along y: nonzero on a curved surface
  /// The loads of all other contacts on each scene, as in Scene::neighbour_loads; indexed by scene.
  std::vector<std::vector<contact::NeighbourLoad>> neighbour_loads;
};

/// Friction of one contact, x and y of its frame, over its normal force.
using FrictionRatio = std::array<double, 2>;

struct SharedLoad {
  double sinking = 0.0;           ///< mm, vertical, from first contact of the wheel
  std::vector<PatchLoad> shares;  ///< one for each scene
};

/// Shares whose forces have the sum `vertical_force` (N) along the vertical, at the approaches w
/// cos(delta_i) - separation_i of one sinking w. `scenes`: patches with a `place`, which supplies
/// contact angle, separation (along the normal) and position on the surface; their loads and loads
/// beside are ignored. Contacts displace each other (neighbours.hpp), also by their friction: a
/// ratio for each scene, none if empty, which carries no load here. Forces at an approach are
/// accurate to about 0.5 %. Throws contact::SolveError when no sinking carries the load,
/// contact::InputError for a scene without profiles or place or a force that is not positive.
SharedLoad share_load(const std::vector<contact::Scene>& scenes, double vertical_force,
                      const std::vector<FrictionRatio>& friction = {});

/// The same at a given sinking, mm, without friction.
SharedLoad load_at(const std::vector<contact::Scene>& scenes, double sinking);

}  // namespace rollfem::halfspace
