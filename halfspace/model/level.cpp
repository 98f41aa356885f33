// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/level.hpp"

#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/result/free_ends.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/side_by_side.hpp"
#include "contact/solve/state_record.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "halfspace/patch/coverage.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::PatchSize;
using contact::Scene;

namespace {

/// Transient rolling uses values up to two steps upstream.
int columns_for_steps(const Scene& scene, const PatchSearch& area, double dx) {
  if (scene.problem != contact::Problem::transient || scene.contact_grid.extent ||
      scene.geometry.distance_values)
    return 0;
  double longest = 0.0;
  for (const contact::LoadPoint& point : scene.points)
    longest = std::max(longest, point.step_length);
  const double extent = area.extent().length;
  return contact::count_of(std::ceil(std::min(2.0 * longest, extent) / dx),
                           "columns covering two steps (history.step_length, contact_grid)");
}

class HalfspaceElasticity : public PreconditionedElasticity {
 public:
  HalfspaceElasticity(const Scene& scene, const contact::ChartedGeometry& geometry,
                      const ContactGrid& grid)
      : PreconditionedElasticity(scene, grid), scene_(scene), geometry_(geometry) {}

  void check_patch(const PatchSize& found) const override {
    PatchSize patch = found;
    contact::cut_at_ends(scene_, patch);
    check_profiles_reach(scene_, geometry_.lateral_place(patch.y_lower),
                         geometry_.lateral_place(patch.y_upper));
  }

 private:
  const Scene& scene_;
  const contact::ChartedGeometry& geometry_;
};

std::string why_no_grid_holds(const Scene& scene, const contact::ChartedGeometry& geometry,
                              const ContactGrid& grid) {
  const double border = geometry.lateral_place(grid.y(grid.ny - 1));
  if (geometry.curved()) {
    const std::string why = contact::why_flanks_touch(geometry.geometry(), border);
    if (!why.empty()) return why;
  }
  const bool pulled = scene.friction() != nullptr && scene.material.couples();
  return fmt::format(
      "the contact patch reaches the border of the potential contact area ({} by {} elements), or "
      "the bodies touch beyond it: {}; do: give a larger contact_grid.extent",
      grid.nx, grid.ny,
      pulled ? "friction of unlike bodies moves and widens the patch, or the surfaces conform over "
               "a wider area than their curvatures suggest"
             : "the surfaces conform over a wider area than their curvatures suggest");
}

}  // namespace

std::unique_ptr<contact::Elasticity> halfspace_elasticity(const Scene& scene,
                                                          const contact::ChartedGeometry& geometry,
                                                          const ContactGrid& grid) {
  return std::make_unique<HalfspaceElasticity>(scene, geometry, grid);
}

contact::LevelResult solve_level(const Scene& scene, const PatchSearch& area, double dx, double dy,
                                 const contact::LevelResult* coarser,
                                 const std::string& stage_prefix, const contact::Progress& progress,
                                 contact::Checkpoint* checkpoint,
                                 const GridElasticity& elasticity) {
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = elasticity.model;
  options.stage_prefix = stage_prefix;
  options.force_accuracy = accuracy_of_force_search;
  options.coarser = coarser;
  // The balance of a wheel needs all load points.
  options.independent = elasticity.independent_points;
  options.leaves_unsolved = elasticity.independent_points && !scene.place;
  ContactGrid grid =
      area.grid(dx, dy, free_elements).widened(columns_for_steps(scene, area, dx), 0);
  constexpr int most_enlargements = 4;
  for (int attempt = 0;; ++attempt) {
    std::optional<contact::PointStore> store;
    if (checkpoint)
      store.emplace(*checkpoint, fmt::format("{}-{}x{}", elasticity.model, grid.nx, grid.ny));
    std::optional<contact::LevelResult> result =
        contact::solve_points(scene, geometry, options, progress, store ? &*store : nullptr, grid,
                              [&] { return elasticity.make(scene, geometry, grid); });
    if (result) {
      const ContactGrid larger = grid_of_all_patches(scene, geometry, area, grid, result->points);
      if (larger.ny == grid.ny) return *std::move(result);
      grid = larger;
      if (attempt < most_enlargements && !scene.contact_grid.extent) continue;
    }
    if (attempt == most_enlargements || scene.contact_grid.extent)
      throw contact::UnfitGrid(why_no_grid_holds(scene, geometry, grid));
    grid = grid.widened(grid.nx / 4 + free_elements, grid.ny / 4 + free_elements);
  }
}

}  // namespace rollfem::halfspace
