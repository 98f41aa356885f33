#include "capi/patch_solution.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/patch_size.hpp"
#include "contact/result/validity.hpp"
#include "contact/scene/geometry.hpp"
#include "contact/solve/normal.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/model/level.hpp"
#include "halfspace/patch/correction_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rollfem::capi {

namespace {

using contact::ContactGrid;
using contact::PatchSize;
using contact::Scene;

/// Elements over the overlap in which the patch is looked for; it takes some three quarters of it.
constexpr int elements_of_search = 20;
/// Free elements around the patch on the grid: three that the driver wants, and one for what the
/// search is off.
constexpr int margin = 4;

/// Extents of the patch without friction, by few elements; nothing where the overlap does not hold
/// it, or holds several.
std::optional<PatchSize> find_patch(const Scene& scene, const track::WheelRailContact& contact) {
  const contact::NormalLoad load = contact::largest_load(scene);
  double half = std::sqrt(2.0 * contact.place.rolling_radius * contact.approach);
  std::array<double, 2> y = contact.reach;
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round) {
    const int n = elements_of_search;
    const double width = y[1] - y[0];
    if (!(half > 0.0 && width > 0.0)) return {};
    const ContactGrid grid =
        ContactGrid::centred(n, n, 2.0 * half / n, width / n, 0.0, 0.5 * (y[0] + y[1]));
    const halfspace::HalfspaceCompliance compliance(grid, scene.material.uncoupled());
    const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::plane);
    contact::NormalOptions options;
    options.tolerance = 1e-3;
    const contact::NormalSolution found = contact::solve_normal(
        compliance.normal(), {geometry.undeformed_distance(grid), load.force, load.approach},
        options);
    if (!contact::touches_border(grid, found.pressure)) {
      if (!is_one_region(grid, found.pressure)) return {};
      return contact::patch_size(grid, found.pressure);
    }
    half *= 1.3;
    y = {y[0] - 0.15 * width, y[1] + 0.15 * width};
  }
  return {};
}

/// Nothing where the patch reaches the border of the grid.
std::optional<contact::LevelResult> solve_on_patch(const Scene& scene, const PatchSize& patch,
                                                   int across) {
  const int n = across + 2 * margin;
  const double dx = patch.length / across, dy = patch.width / across;
  const ContactGrid grid = ContactGrid::centred(n, n, dx, dy, 0.5 * (patch.x_lower + patch.x_upper),
                                                0.5 * (patch.y_lower + patch.y_upper));
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  contact::RunOptions options;
  options.model = "halfspace";
  const contact::Progress silent;
  contact::ContactRun run(scene, geometry, options, silent, nullptr);
  if (!run.solve(grid, [&] { return halfspace::halfspace_elasticity(scene, geometry, grid); }))
    return {};
  return run.take_result();
}

/// As the model halfspace lays its grid.
contact::LevelResult solve_as_the_model(const Scene& scene, int across) {
  const halfspace::PatchSearch area(scene);
  const halfspace::PatchExtent extent = area.extent();
  return halfspace::solve_level(scene, area, extent.length / across, extent.width / across, nullptr,
                                "", {});
}

}  // namespace

bool is_one_region(const ContactGrid& grid, const contact::Field& pressure) {
  int changes = 0;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool loaded = pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0;
    if (loaded != inside) ++changes;
    inside = loaded;
  }
  return changes == 2;
}

contact::PointResult solve_patch(const Scene& scene, const track::WheelRailContact& contact,
                                 int across) {
  std::optional<contact::LevelResult> level;
  // Several regions, or one that conforms, are looked for with more care.
  if (const std::optional<PatchSize> patch = find_patch(scene, contact))
    level = solve_on_patch(scene, *patch, across);
  if (!level) level = solve_as_the_model(scene, across);
  contact::ModelResult result;
  result.name = "halfspace";
  result.grid = level->grid;
  result.points = std::move(level->points);
  contact::check_validity(scene, result);
  return std::move(result.points.front());
}

}  // namespace rollfem::capi
