#include "halfspace/patch/true_sections.hpp"

#include "halfspace/patch/patch_search.hpp"

#include <algorithm>

namespace rollfem::halfspace {

namespace {

/// A box on the surface reaches this many larger half sizes of the patch to each side at least.
constexpr double least_box_reach = 2.5;

}  // namespace

bool has_true_sections(const contact::Scene& scene) {
  if (!scene.has_profiles()) return false;
  if (scene.options.fem.mesh) return *scene.options.fem.mesh == contact::MeshFamily::gmsh;
  const PatchBox patch = PatchSearch(scene).box();
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  double reach = contact::infinity;
  const auto see = [&](const contact::SceneBody& body, const contact::HeightCurve& section) {
    if (body.material.rigid()) return;
    const auto [lower, upper] = section.gentle_part(steepest_of_box);
    reach = std::min({reach, patch.middle - lower, upper - patch.middle});
  };
  see(scene.wheel, profiles.wheel());
  see(scene.rail, profiles.rail());
  return reach < least_box_reach * patch.larger();
}

}  // namespace rollfem::halfspace
