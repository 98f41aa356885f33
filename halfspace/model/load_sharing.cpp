#include "halfspace/model/load_sharing.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "halfspace/model/expected_patch.hpp"
#include "halfspace/model/patch_ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::Scene;

namespace {

/// First guess of the sinking, mm; a wheel's patch approaches by 0.05 to 0.2.
constexpr double first_sinking = 0.05;
/// No wheel sinks deeper than this, mm.
constexpr double deepest_sinking = 20.0;

struct Patch {
  const Scene& scene;
  double cosine;
  double separation;
  double least_distance;  ///< mm, of the patch geometry: its own zero of the approach

  double approach_at(double sinking) const {
    return least_distance + sinking * cosine - separation;
  }
};

Patch patch_of(const Scene& scene) {
  if (!scene.has_profiles() || !scene.place)
    throw contact::InputError(
        "sharing of the load between patches: every scene needs the geometry and the place of its "
        "patch; do: make scenes of a case with profiles");
  return {scene, std::cos(scene.place->contact_angle), scene.place->separation,
          Ridge(*scene.geometry.surface.profiles).least_distance()};
}

/// The patches on grids that hold them up to a largest sinking.
class SinkingWheel {
 public:
  SinkingWheel(const std::vector<Patch>& patches, double largest_sinking) : patches_(patches) {
    for (const Patch& patch : patches)
      laws_.emplace_back(patch.scene, patch.approach_at(largest_sinking));
  }

  std::vector<double> normal_forces(double sinking) {
    std::vector<double> forces;
    for (std::size_t i = 0; i < laws_.size(); ++i)
      forces.push_back(laws_[i].normal_force(patches_[i].approach_at(sinking)));
    return forces;
  }

  double vertical_force(double sinking) {
    const std::vector<double> forces = normal_forces(sinking);
    double sum = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) sum += forces[i] * patches_[i].cosine;
    return sum;
  }

 private:
  const std::vector<Patch>& patches_;
  std::vector<ForceLaw> laws_;
};

}  // namespace

SharedLoad share_load(const std::vector<Scene>& inputs, double vertical_force) {
  if (inputs.empty() || !(vertical_force > 0.0))
    throw contact::InputError(fmt::format(
        "sharing of the load between patches: {} patches and a vertical force of {} N; allowed: at "
        "least one patch and a force above 0",
        inputs.size(), vertical_force));
  std::vector<Patch> patches;
  for (const Scene& scene : inputs) patches.push_back(patch_of(scene));
  double first_touch = deepest_sinking;
  for (const Patch& patch : patches)
    first_touch = std::min(first_touch, patch.separation / patch.cosine);
  for (double way = first_sinking; first_touch + way < deepest_sinking; way *= 1.5) {
    SinkingWheel wheel(patches, first_touch + way);
    const auto excess = [&](double sinking) {
      return wheel.vertical_force(sinking) - vertical_force;
    };
    if (excess(first_touch + way) < 0.0) continue;
    SharedLoad shared;
    shared.sinking = contact::bracketed_root(excess, first_touch, first_touch + way, 1e-12,
                                             "sharing of the load between patches");
    shared.normal_forces = wheel.normal_forces(shared.sinking);
    return shared;
  }
  throw contact::SolveError(fmt::format(
      "sharing of the load between patches: a sinking of {:.3g} mm does not carry {} N; do: check "
      "the profiles and the load",
      deepest_sinking, vertical_force));
}

}  // namespace rollfem::halfspace
