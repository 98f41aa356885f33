// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/load_sharing.hpp"

#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "contact/base/threads.hpp"
#include "contact/iteration/compliance.hpp"
#include "contact/result/result.hpp"
#include "contact/solve/standin.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/elasticity/neighbours.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "halfspace/patch/ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::NeighbourLoad;
using contact::Scene;

namespace {

/// First guess of the sinking, mm; a wheel's patch approaches by 0.05 to 0.2.
constexpr double first_sinking = 0.05;
/// Deepest sinking of a wheel, mm.
constexpr double deepest_sinking = 20.0;
/// Convergence: forces change by less than this fraction of their sum.
constexpr double settled = 1e-8;
constexpr int most_turns = 60;
/// Elements along x, and along y over the overlap.
constexpr int elements_of_law = 50;
/// Largest number of elements along y, as a multiple of that: gaps between patches are meshed like
/// patches.
constexpr double most_gaps = 24.0;
/// Number of point loads that represent a pressure.
constexpr int blocks_along = 5, blocks_across = 10;

struct Patch {
  const Scene& scene;
  std::array<double, 2> up;  ///< y, z of the vertical
  double separation;
  Ridge ridge;
  double touch;  ///< mm, least distance at first touch: the patch's zero of the approach
  FrictionRatio friction{};

  double approach_at(double sinking) const { return touch + sinking * up[1] - separation; }
};

Patch patch_of(const Scene& scene) {
  if (!scene.has_profiles() || !scene.place)
    throw contact::InputError(
        "sharing of the load between patches: every scene needs the geometry and the position of "
        "its patch; do: use scenes of a case with profiles");
  const double angle = scene.place->contact_angle;
  const double sine = scene.place->left ? std::sin(angle) : -std::sin(angle);
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  Ridge ridge(profiles);
  const bool at_touch = profiles.sinking().way[1] == 0.0;
  const double touch =
      at_touch ? ridge.least_distance()
               : Ridge(profiles.under_load(0.0, {0.0, 1.0}, {0.0, 1.0})).least_distance();
  return {scene, {sine, std::cos(angle)}, scene.place->separation, std::move(ridge), touch, {}};
}

std::vector<Patch> patches_of(const std::vector<Scene>& scenes,
                              const std::vector<FrictionRatio>& friction) {
  std::vector<Patch> patches;
  for (const Scene& scene : scenes) patches.push_back(patch_of(scene));
  for (std::size_t i = 0; i < friction.size(); ++i) patches[i].friction = friction[i];
  return patches;
}

ContactGrid grid_over(const Overlap& overlap, const contact::ChartedGeometry& geometry) {
  const Box& box = overlap.box;
  double steepest = 0.0;
  for (const RidgeRegion& region : overlap.regions)
    for (const double y : {region.y_lower, region.y_upper})
      steepest = std::max(steepest, std::abs(geometry.climb(y)));
  // On a curved surface y is the arc length, longer than its projection.
  const double stretch = contact::stretch_of(steepest);
  const auto on_surface = [&](double y, bool outward) {
    return outward == (y > 0.0) ? stretch * y : y;
  };
  const double y_lower = on_surface(box.y_lower, false);
  const double y_upper = on_surface(box.y_upper, true);
  const double times = std::clamp((y_upper - y_lower) / overlap.covered(), 1.0, most_gaps);
  const int ny =
      contact::count_of(std::ceil(elements_of_law * times - 1e-9), "elements of a force law");
  const double dx = (box.x_upper - box.x_lower) / elements_of_law, dy = (y_upper - y_lower) / ny;
  return {elements_of_law, ny, dx, dy, box.x_lower + 0.5 * dx, y_lower + 0.5 * dy};
}

/// Force of the pressure of a scene with profiles on one grid that holds every patch up to a
/// largest approach: one continuous function of the approach, accurate to about 0.5 % there and
/// less accurate for a small fraction of it.
class ForceLaw {
 public:
  ForceLaw() = default;
  /// `largest_approach`: mm along z.
  ForceLaw(const Patch& patch, double largest_approach)
      : material_(patch.scene.material.uncoupled()) {
    const Overlap overlap = patch.ridge.overlap(largest_approach);
    if (overlap.regions.empty()) return;
    const contact::ChartedGeometry geometry = halfspace_geometry(patch.scene);
    const ContactGrid grid = grid_over(overlap, geometry);
    compliance_ = std::make_unique<HalfspaceCompliance>(grid, material_);
    distance_ = geometry.undeformed_distance(grid);
    problem_.shape = geometry.shape(grid);
    problem_.frame = contact::vertical_frame(problem_.shape, patch.up);
    problem_.load.direction = patch.up;
  }

  /// Solves at an approach; `beside`: loads on the surface beside the contact.
  void press(double approach, const std::vector<NeighbourLoad>& beside) {
    force_ = {};
    if (!compliance_) return;
    const ContactGrid& grid = compliance_->grid();
    problem_.undeformed_distance = distance_;
    add_displacement(beside, material_, grid, problem_.undeformed_distance);
    problem_.load.approach = approach;
    const double along_z = problem_.load.direction[1];
    const Field& distance = problem_.undeformed_distance;
    const double opening =
        problem_.frame.plane()
            ? distance.minCoeff()
            : along_z * distance.cwiseProduct(problem_.frame.to_vertical).minCoeff();
    if (!(approach > opening)) return;
    pressure_ = contact::press_standin(compliance_->normal(), problem_, pressure_).pressure;
    const Field none = Field::Zero(grid.size());
    const auto force = contact::transmitted_force(grid, {none, none, pressure_}, problem_.shape);
    force_ = {force[1], force[2]};
  }

  double normal_force() const { return force_[1]; }   ///< N, along z; 0 without contact
  double lateral_force() const { return force_[0]; }  ///< N, along y: nonzero on a curved surface

  /// The pressure as point loads, each that of a block of elements.
  std::vector<NeighbourLoad> point_loads() const {
    std::vector<NeighbourLoad> loads;
    if (!(force_[1] > 0.0)) return loads;
    const ContactGrid& grid = compliance_->grid();
    const auto step = [](int count, int blocks) { return (count + blocks - 1) / blocks; };
    lump(grid, pressure_, {}, step(grid.nx, blocks_along), step(grid.ny, blocks_across), loads);
    return loads;
  }

 private:
  contact::CombinedMaterial material_;
  std::unique_ptr<const contact::SolvableCompliance> compliance_;
  contact::CoupledProblem problem_;
  Field distance_;
  Field pressure_;  ///< of the last approach
  std::array<double, 2> force_{};
};

/// The patches on grids that hold them up to a largest sinking.
class SinkingWheel {
 public:
  SinkingWheel(const std::vector<Patch>& patches, double largest_sinking)
      : patches_(patches), laws_(patches.size()) {
    contact::for_each_index(patches.size(), [&](std::size_t i) {
      laws_[i] = ForceLaw(patches[i], patches[i].approach_at(largest_sinking));
    });
  }

  /// Solves every patch under the displacement due to the others, in turn until all agree.
  void sink(double sinking) {
    for (int round = 0; round < most_turns; ++round) {
      const std::vector<std::size_t> loaded_before = loaded();
      double change = 0.0, sum = 0.0;
      for (std::size_t i = 0; i < laws_.size(); ++i) {
        const double before = laws_[i].normal_force();
        std::vector<NeighbourLoad> all;
        for (std::size_t j = 0; j < laws_.size(); ++j)
          for (const NeighbourLoad& load : neighbour_loads(i, j)) all.push_back(load);
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

  std::vector<PatchLoad> shares() const {
    std::vector<PatchLoad> shares;
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      shares.push_back({laws_[i].normal_force(), laws_[i].lateral_force(), {}});
      for (std::size_t j = 0; j < laws_.size(); ++j)
        shares.back().neighbour_loads.push_back(neighbour_loads(i, j));
    }
    return shares;
  }

 private:
  /// Loaded patches. A patch that carries the whole load is not affected by others, it only keeps
  /// them open.
  std::vector<std::size_t> loaded() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < laws_.size(); ++i)
      if (laws_[i].normal_force() > 0.0) found.push_back(i);
    return found;
  }

  /// Load of patch j beside patch i, at its position on the rolled-out surface of i.
  std::vector<NeighbourLoad> neighbour_loads(std::size_t i, std::size_t j) const {
    if (i == j) return {};
    const contact::ContactPlace& here = *patches_[i].scene.place;
    const contact::ContactPlace& there = *patches_[j].scene.place;
    std::vector<NeighbourLoad> loads = laws_[j].point_loads();
    for (NeighbourLoad& load : loads) {
      place_beside(here, there, load);
      load.longitudinal = patches_[j].friction[0] * load.normal;
      load.lateral = patches_[j].friction[1] * load.normal;
    }
    return loads;
  }

  const std::vector<Patch>& patches_;
  std::vector<ForceLaw> laws_;
};

}  // namespace

SharedLoad share_load(const std::vector<Scene>& scenes, double vertical_force,
                      const std::vector<FrictionRatio>& friction) {
  if (scenes.empty() || !(vertical_force > 0.0))
    throw contact::InputError(fmt::format(
        "sharing of the load between patches: {} patches and a vertical force of {} N; allowed: at "
        "least one patch and a force above 0",
        scenes.size(), vertical_force));
  const std::vector<Patch> patches = patches_of(scenes, friction);
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
  const std::vector<Patch> patches = patches_of(scenes, {});
  SinkingWheel wheel(patches, sinking);
  wheel.sink(sinking);
  return {sinking, wheel.shares()};
}

}  // namespace rollfem::halfspace
