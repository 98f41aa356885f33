#include "halfspace/patch/load_sharing.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "halfspace/patch/force_law.hpp"
#include "halfspace/patch/ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::LoadBeside;
using contact::Scene;

namespace {

/// First guess of the sinking, mm; a wheel's patch approaches by 0.05 to 0.2.
constexpr double first_sinking = 0.05;
/// No wheel sinks deeper than this, mm.
constexpr double deepest_sinking = 20.0;
/// Forces that change by less than this part of their sum no longer feel each other.
constexpr double settled = 1e-8;
constexpr int most_turns = 60;

struct Patch {
  const Scene& scene;
  std::array<double, 2> up;  ///< y, z of the vertical
  double separation;
  double least_distance;  ///< mm, of the patch geometry: its own zero of the approach

  double approach_at(double sinking) const { return least_distance + sinking * up[1] - separation; }
  /// y of a patch frame points to the field on the left wheel, to the middle on the right.
  double outward() const { return scene.place->left ? 1.0 : -1.0; }
};

Patch patch_of(const Scene& scene) {
  if (!scene.has_profiles() || !scene.place)
    throw contact::InputError(
        "sharing of the load between patches: every scene needs the geometry and the place of its "
        "patch; do: make scenes of a case with profiles");
  const double angle = scene.place->contact_angle;
  const double sine = scene.place->left ? std::sin(angle) : -std::sin(angle);
  return {scene,
          {sine, std::cos(angle)},
          scene.place->separation,
          Ridge(*scene.geometry.surface.profiles).least_distance()};
}

std::vector<Patch> patches_of(const std::vector<Scene>& scenes) {
  std::vector<Patch> patches;
  for (const Scene& scene : scenes) patches.push_back(patch_of(scene));
  return patches;
}

/// The patches on grids that hold them up to a largest sinking.
class SinkingWheel {
 public:
  SinkingWheel(const std::vector<Patch>& patches, double largest_sinking) : patches_(patches) {
    for (const Patch& patch : patches)
      laws_.emplace_back(patch.scene, patch.up, patch.approach_at(largest_sinking));
  }

  /// Presses every patch under what the others displace, in turn until all agree.
  void sink(double sinking) {
    for (int round = 0; round < most_turns; ++round) {
      const std::vector<std::size_t> loaded_before = loaded();
      double change = 0.0, sum = 0.0;
      for (std::size_t i = 0; i < laws_.size(); ++i) {
        const double before = laws_[i].normal_force();
        std::vector<LoadBeside> all;
        for (std::size_t j = 0; j < laws_.size(); ++j)
          for (const LoadBeside& load : beside(i, j)) all.push_back(load);
        laws_[i].press(patches_[i].approach_at(sinking), all);
        change = std::max(change, std::abs(laws_[i].normal_force() - before));
        sum += laws_[i].normal_force();
      }
      const std::vector<std::size_t> loaded_now = loaded();
      const bool alone =
          loaded_now.size() <= 1 && (loaded_before.empty() || loaded_before == loaded_now);
      if (alone || change <= settled * sum) return;
    }
    throw contact::SolveError(
        fmt::format("sharing of the load between patches: their mutual displacement does not "
                    "converge in {} iterations",
                    most_turns));
  }

  double vertical_force() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < laws_.size(); ++i)
      sum += laws_[i].lateral_force() * patches_[i].up[0] +
             laws_[i].normal_force() * patches_[i].up[1];
    return sum;
  }

  std::vector<Share> shares() const {
    std::vector<Share> shares;
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      shares.push_back({laws_[i].normal_force(), laws_[i].lateral_force(), {}});
      for (std::size_t j = 0; j < laws_.size(); ++j) shares.back().beside.push_back(beside(i, j));
    }
    return shares;
  }

 private:
  /// Patches that carry something. One that carries all feels no other, it only keeps them off.
  std::vector<std::size_t> loaded() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < laws_.size(); ++i)
      if (laws_[i].normal_force() > 0.0) found.push_back(i);
    return found;
  }

  /// What patch j presses beside patch i, where it is on the surface of i rolled out.
  std::vector<LoadBeside> beside(std::size_t i, std::size_t j) const {
    if (i == j) return {};
    const contact::ContactPlace& here = *patches_[i].scene.place;
    const contact::ContactPlace& there = *patches_[j].scene.place;
    std::vector<LoadBeside> loads = laws_[j].point_loads();
    for (LoadBeside& load : loads) {
      load.x += there.x_track - here.x_track;
      load.y += patches_[i].outward() * (there.way_across - here.way_across);
    }
    return loads;
  }

  const std::vector<Patch>& patches_;
  std::vector<ForceLaw> laws_;
};

}  // namespace

SharedLoad share_load(const std::vector<Scene>& scenes, double vertical_force) {
  if (scenes.empty() || !(vertical_force > 0.0))
    throw contact::InputError(fmt::format(
        "sharing of the load between patches: {} patches and a vertical force of {} N; allowed: at "
        "least one patch and a force above 0",
        scenes.size(), vertical_force));
  const std::vector<Patch> patches = patches_of(scenes);
  double first_touch = deepest_sinking;
  for (const Patch& patch : patches)
    first_touch = std::min(first_touch, patch.separation / patch.up[1]);
  for (double way = first_sinking; first_touch + way < deepest_sinking; way *= 1.5) {
    SinkingWheel wheel(patches, first_touch + way);
    const auto excess = [&](double sinking) {
      wheel.sink(sinking);
      return wheel.vertical_force() - vertical_force;
    };
    if (excess(first_touch + way) < 0.0) continue;
    SharedLoad shared;
    shared.sinking = contact::bracketed_root(excess, first_touch, first_touch + way, 1e-12,
                                             "sharing of the load between patches");
    wheel.sink(shared.sinking);
    shared.shares = wheel.shares();
    return shared;
  }
  throw contact::SolveError(
      fmt::format("sharing of the load between patches: an approach of {:.3g} mm does not carry {} "
                  "N; do: check the profiles and the load",
                  deepest_sinking, vertical_force));
}

SharedLoad load_at(const std::vector<Scene>& scenes, double sinking) {
  const std::vector<Patch> patches = patches_of(scenes);
  SinkingWheel wheel(patches, sinking);
  wheel.sink(sinking);
  return {sinking, wheel.shares()};
}

}  // namespace rollfem::halfspace
