// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/profile_reach.hpp"

#include "halfspace/patch/patch_search.hpp"

#include <algorithm>

namespace rollfem::halfspace {

namespace {

constexpr double steepest_of_box = 1.5;  // dz/dy

}  // namespace

double gentle_reach(const contact::Scene& scene, double middle) {
  double reach = contact::infinity;
  if (!scene.has_profiles()) return reach;
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  const auto see = [&](const contact::SceneBody& body, const contact::HeightCurve& section) {
    if (body.material.rigid()) return;
    const auto [lower, upper] = section.gentle_part(steepest_of_box);
    reach = std::min({reach, middle - lower, upper - middle});
  };
  see(scene.wheel, profiles.wheel());
  see(scene.rail, profiles.rail());
  return reach;
}

bool is_steep(const contact::Scene& scene) {
  if (!scene.has_profiles()) return false;
  const PatchBox patch = PatchSearch(scene).box();
  return gentle_reach(scene, patch.middle) < least_box_reach * patch.larger();
}

}  // namespace rollfem::halfspace
