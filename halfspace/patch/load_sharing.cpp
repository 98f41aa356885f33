// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/load_sharing.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/threads.hpp"
#include "contact/iteration/bound_constrained_cg.hpp"
#include "contact/iteration/compliance.hpp"
#include "contact/solve/halfspace_contact.hpp"
#include "contact/solve/pressure_share.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/neighbours.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "halfspace/patch/ridge.hpp"
#include "result/result.hpp"

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
constexpr double settled_to = 1e-8;
constexpr int most_turns = 60;
/// Elements along x, and along y over the overlap.
constexpr int elements_of_law = 50;
/// Largest number of elements along y, as a multiple of that: gaps between patches are meshed like
/// patches.
constexpr double most_gaps = 24.0;
/// Number of point loads that represent a pressure.
constexpr int blocks_along = 5, blocks_across = 10;

struct Patch {
  const Scene* scene;
  double level;              ///< part of the vertical that is across the track
  std::array<double, 2> up;  ///< y, z of this part, in which the wheel sinks
  Ridge ridge;
  double touch;  ///< mm, approach at first touch of the wheel: negative by the separation
  ForceRatio ratio;

  // On a grid that holds it up to a largest sinking; without one where that does not reach it.
  std::unique_ptr<const HalfspaceCompliance> compliance{};
  contact::PatchShape shape{};
  Field carried{}, distance{}, pressure{};
  Eigen::Index first = 0;  ///< of its elements in the fields of the wheel
  double normal_force = 0.0, vertical_force = 0.0;

  Field pressure_of(const Field& forces) const {
    return forces.segment(first, carried.size()).cwiseQuotient(carried) /
           compliance->grid().element_area();
  }
};

Patch patch_of(const Scene& scene, const ForceRatio& ratio) {
  if (!scene.has_profiles() || !scene.place)
    throw contact::InputError(
        "sharing of the load between patches: every scene needs the geometry and the position of "
        "its patch; do: use scenes of a case with profiles");
  const auto [across, along_normal] = upwards(*scene.place);
  const double level = std::hypot(across, along_normal);
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  Ridge ridge(profiles);
  const bool at_touch = profiles.sinking().way[1] == 0.0;
  const double least =
      at_touch ? ridge.least_distance()
               : Ridge(profiles.under_load(0.0, {0.0, 1.0}, {0.0, 1.0})).least_distance();
  return {&scene,
          level,
          {across / level, along_normal / level},
          std::move(ridge),
          least - scene.place->separation,
          ratio};
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

/// The patches of a wheel as one normal problem in the forces of the elements along `up`; fields
/// hold one patch after the other. Forces are continuous functions of the sinking, accurate to
/// about 0.5 % at the largest sinking and less accurate for a small fraction of it.
class SinkingWheel : public contact::NormalMap {
 public:
  SinkingWheel(const std::vector<Scene>& scenes, const std::vector<ForceRatio>& ratios) {
    for (std::size_t i = 0; i < scenes.size(); ++i)
      patches_.push_back(patch_of(scenes[i], ratios.empty() ? ForceRatio() : ratios[i]));
  }

  double first_touch() const {
    double first = deepest_sinking;
    for (const Patch& patch : patches_)
      first = std::min(first, patch.scene->place->separation / patch.up[1]);
    return first;
  }

  void lay_grids(double largest_sinking) {
    contact::for_each_index(patches_.size(),
                            [&](std::size_t i) { lay_grid(largest_sinking, patches_[i]); });
    size_ = 0;
    for (Patch& patch : patches_) {
      patch.first = size_;
      size_ += patch.carried.size();
    }
  }

  void apply(const Field& forces, Field& displacement) const override {
    displacement.resize(size_);
    Field part;
    for (const Patch& patch : patches_) {
      if (!patch.compliance) continue;
      patch.compliance->normal().apply(patch.pressure_of(forces), part);
      displacement.segment(patch.first, part.size()) = part.cwiseQuotient(patch.carried);
    }
  }

  void precondition(const Field& residual, Field& result) const override {
    result.resize(size_);
    Field part;
    for (const Patch& patch : patches_) {
      if (!patch.compliance) continue;
      const Field own = residual.segment(patch.first, patch.carried.size());
      patch.compliance->normal().precondition(own.cwiseProduct(patch.carried), part);
      result.segment(patch.first, part.size()) =
          patch.compliance->grid().element_area() * part.cwiseProduct(patch.carried);
    }
  }

  /// At a sinking (mm), or under a vertical force (N). Pressures and the displacements by the other
  /// patches alternate until all agree.
  SharedLoad press(const std::optional<double>& sinking, double vertical_force) {
    contact::BoundConstrainedCg solver;
    contact::PressureShare sharing;
    sharing.load = vertical_force;
    sharing.tolerance = settled_to;
    sharing.most_turns = most_turns;
    sharing.sliding = true;
    const auto solve = [&](double share, int) {
      const Field joint = distance();
      if (sinking)
        solver.solve_approach(*this, joint, *sinking, {}, solver.pressure());
      else
        solver.solve_sum(*this, joint, share, {}, solver.pressure());
      sharing.settled = set_forces(solver.pressure());
      return sinking ? share : share + vertical_force - lift();
    };
    if (size_ > 0) sharing.solve(vertical_force, solve);
    SharedLoad shared{solver.approach(), {}};
    for (const Patch& patch : patches_)
      shared.shares.push_back({patch.normal_force, patch.vertical_force, loads_beside(patch)});
    return shared;
  }

 private:
  static void lay_grid(double largest_sinking, Patch& patch) {
    const Overlap overlap = patch.ridge.overlap(patch.touch + largest_sinking * patch.up[1]);
    if (overlap.regions.empty()) return;
    const contact::ChartedGeometry geometry = halfspace_geometry(*patch.scene);
    const ContactGrid grid = grid_over(overlap, geometry);
    patch.compliance =
        std::make_unique<HalfspaceCompliance>(grid, patch.scene->material.uncoupled());
    patch.shape = geometry.shape(grid);
    patch.carried = contact::vertical_frame(patch.shape, patch.up).carried;
    if (patch.carried.size() == 0) patch.carried = Field::Constant(grid.size(), patch.up[1]);
    patch.distance = geometry.undeformed_distance(grid);
    patch.pressure = Field::Zero(grid.size());
  }

  /// Along `up` before the wheel sinks.
  Field distance() const {
    Field joint(size_);
    for (const Patch& patch : patches_) {
      if (!patch.compliance) continue;
      Field own = patch.distance;
      add_displacement(loads_beside(patch), patch.scene->material.uncoupled(),
                       patch.compliance->grid(), own);
      joint.segment(patch.first, own.size()) =
          (own.array() / patch.carried.array() - patch.touch / patch.up[1]).matrix();
    }
    return joint;
  }

  /// Whether the patches carry as much as before.
  bool set_forces(const Field& forces) {
    double change = 0.0, sum = 0.0;
    for (Patch& patch : patches_) {
      if (!patch.compliance) continue;
      patch.pressure = patch.pressure_of(forces);
      const Field none = Field::Zero(patch.pressure.size());
      const auto [x, y, z] = contact::transmitted_force(patch.compliance->grid(),
                                                        {none, none, patch.pressure}, patch.shape);
      change = std::max(change, std::abs(z - patch.normal_force));
      sum += z;
      const double across = patch.ratio ? (*patch.ratio)[1] * z : y;
      patch.normal_force = z;
      patch.vertical_force = patch.level * (across * patch.up[0] + z * patch.up[1]);
    }
    return change <= settled_to * sum || patches_.size() == 1;
  }

  double lift() const {
    double sum = 0.0;
    for (const Patch& patch : patches_) sum += patch.vertical_force;
    if (sum > 0.0) return sum;
    throw contact::SolveError(fmt::format(
        "the {} wheel: friction on the flange lifts it at any load (beyond Nadal's limit), so "
        "there is no equilibrium; do: use less friction, lateral_shift or yaw",
        patches_.front().scene->place->side()));
  }

  /// The other patches as point loads, each that of a block of elements.
  std::vector<NeighbourLoad> loads_beside(const Patch& here) const {
    const auto step = [](int count, int blocks) { return (count + blocks - 1) / blocks; };
    std::vector<NeighbourLoad> all, loads;
    for (const Patch& there : patches_) {
      if (&there == &here || !(there.normal_force > 0.0)) continue;
      const ContactGrid& grid = there.compliance->grid();
      lump(grid, there.pressure, {}, step(grid.nx, blocks_along), step(grid.ny, blocks_across),
           loads);
      for (NeighbourLoad& load : loads) {
        place_beside(*here.scene->place, *there.scene->place, load);
        const auto [x, y] = there.ratio.value_or(std::array{0.0, 0.0});
        load.longitudinal = x * load.normal;
        load.lateral = y * load.normal;
        all.push_back(load);
      }
    }
    return all;
  }

  std::vector<Patch> patches_;
  Eigen::Index size_ = 0;
};

}  // namespace

std::array<double, 2> upwards(const contact::ContactPlace& place) {
  const double level = std::cos(place.climb);
  return {place.outward() * std::sin(place.contact_angle) * level,
          std::cos(place.contact_angle) * level};
}

SharedLoad share_load(const std::vector<Scene>& scenes, double vertical_force,
                      const std::vector<ForceRatio>& ratios) {
  if (scenes.empty() || !(vertical_force > 0.0))
    throw contact::InputError(fmt::format(
        "sharing of the load between patches: {} patches and a vertical force of {} N; allowed: at "
        "least one patch and a force above 0",
        scenes.size(), vertical_force));
  SinkingWheel wheel(scenes, ratios);
  const double first_touch = wheel.first_touch();
  for (double way = first_sinking; first_touch + way < deepest_sinking; way *= 1.5) {
    wheel.lay_grids(first_touch + way);
    SharedLoad shared = wheel.press({}, vertical_force);
    if (shared.sinking <= first_touch + way) return shared;
  }
  throw contact::SolveError(
      fmt::format("sharing of the load between patches: an approach of {:.3g} mm does not carry {} "
                  "N; do: check the profiles and the load",
                  deepest_sinking, vertical_force));
}

SharedLoad load_at(const std::vector<Scene>& scenes, double sinking) {
  SinkingWheel wheel(scenes, {});
  wheel.lay_grids(sinking);
  return wheel.press(sinking, 1.0);
}

}  // namespace rollfem::halfspace
