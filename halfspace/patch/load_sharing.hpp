// SPDX-License-Identifier: LGPL-2.1-or-later
// Shares the load of a wheel among its separate contacts: the wheel sinks vertically, each contact
// approaches by the component along its own normal less the displacement due to the others. All
// contacts are one normal problem in the forces of the elements along the vertical.
#pragma once

#include "scene/scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::halfspace {

/// The vertical in the frame of the patch, along y and the normal, upwards on the wheel: y points
/// to the field on the left and to the middle on the right. NormalLoad::direction of a vertical
/// force.
std::array<double, 2> upwards(const contact::ContactPlace& place);

/// Load of one contact.
struct PatchLoad {
  double normal_force = 0.0;    ///< N, along z of the patch, by the pressure; 0 without contact
  double vertical_force = 0.0;  ///< N, upwards, with the friction of its ratio
  /// The loads of all other contacts on this scene, as in Scene::neighbour_loads.
  std::vector<contact::NeighbourLoad> neighbour_loads;
};

/// Force on one contact along x and y of its frame, by pressure and friction, over its normal
/// force; empty: by pressure alone.
using ForceRatio = std::optional<std::array<double, 2>>;

struct SharedLoad {
  double sinking = 0.0;           ///< mm, vertical, from first contact of the wheel
  std::vector<PatchLoad> shares;  ///< one for each scene
};

/// Shares whose vertical forces have the sum `vertical_force` (N), at the approaches w cos(delta_i)
/// - separation_i of one sinking w. `scenes`: patches with a `place`, which supplies contact angle,
/// separation (along the normal) and position on the surface; their loads and loads beside are
/// ignored. `ratios`: one for each scene, or none. Contacts displace each other (neighbours.hpp),
/// also by their friction. Forces at an approach are accurate to about 0.5 %. Throws
/// contact::SolveError when no sinking carries the load or friction lifts the wheel,
/// contact::InputError for a scene without profiles or place or a force that is not positive.
SharedLoad share_load(const std::vector<contact::Scene>& scenes, double vertical_force,
                      const std::vector<ForceRatio>& ratios = {});

/// The same at a given sinking, mm, without friction.
SharedLoad load_at(const std::vector<contact::Scene>& scenes, double sinking);

}  // namespace rollfem::halfspace
