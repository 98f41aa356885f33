// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/coverage.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "halfspace/elasticity/neighbours.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace rollfem::halfspace {

using contact::ContactGrid;

namespace {

/// Overlaps below this fraction of the approach are due to the point loads, not to the bodies.
constexpr double least_overlap = 1e-3;

/// Throws contact::ConformalContact where pressure reaches a limit of the contact
/// (PatchGeometry::limits).
void check_limits(const contact::Scene& scene, const contact::ChartedGeometry& geometry,
                  const ContactGrid& grid, const contact::Field& pressure) {
  if (!scene.has_profiles()) return;
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  for (int j = 0; j < grid.ny; ++j) {
    const double y = geometry.lateral_place(grid.y(j));
    if (profiles.within_limits(y - grid.dy) && profiles.within_limits(y + grid.dy)) continue;
    if (!(pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0)) continue;
    throw contact::ConformalContact(
        scene.where(),
        "the patch reaches y = {:.2f} mm, where another contact of the same wheel "
        "begins: both are one conformal contact, which a plane cannot represent; do: "
        "run with halfspace.surface = \"curved\"",
        y);
  }
}

}  // namespace

std::optional<std::array<double, 2>> touched_beyond(
    const contact::Scene& scene, const contact::ChartedGeometry& geometry, const PatchSearch& area,
    const ContactGrid& grid, const contact::PointResult& point, const contact::NormalLoad& load) {
  if (!scene.has_profiles() || !scene.geometry.has_surfaces() || scene.given_pressure) return {};
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  const Overlap overlap = area.ridge().overlap(point.approach);
  std::optional<std::array<double, 2>> touched;
  const auto look_at = [&](double y) {
    const double x = ridge_point(profiles, geometry.lateral_place(y)).x;
    const ContactGrid place{1, 1, grid.dx, grid.dy, x, y};
    const double climb = geometry.climb(y);
    contact::Field distance = geometry.undeformed_distance(place);
    add_displacement(scene.neighbour_loads, scene.material, place, distance);
    const double opening = distance[0] + displacement_beside(x, y, grid, point.fields.traction.n,
                                                             scene.material.contact_modulus);
    // The bodies approach along the load; the plane uses its component along z.
    const double along_normal =
        geometry.curved()
            ? (1.0 - climb * load.direction[0] / load.direction[1]) / std::sqrt(1.0 + climb * climb)
            : 1.0;
    const double gap = opening - point.approach * along_normal;
    if (gap > -least_overlap * point.approach) return;
    if (!touched) touched = {y, y};
    (*touched)[0] = std::min((*touched)[0], y);
    (*touched)[1] = std::max((*touched)[1], y);
  };
  for (const RidgeRegion& region : overlap.regions) {
    for (int j = -1; geometry.lateral_place(grid.y(j)) > region.y_lower; --j)
      if (geometry.lateral_place(grid.y(j)) < region.y_upper) look_at(grid.y(j));
    for (int j = grid.ny; geometry.lateral_place(grid.y(j)) < region.y_upper; ++j)
      if (geometry.lateral_place(grid.y(j)) > region.y_lower) look_at(grid.y(j));
  }
  return touched;
}

ContactGrid grid_of_all_patches(const contact::Scene& scene,
                                const contact::ChartedGeometry& geometry, const PatchSearch& area,
                                const ContactGrid& grid,
                                const std::vector<contact::PointResult>& points) {
  int below = 0, above = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!contact::is_solved(points[k])) continue;
    check_limits(scene, geometry, grid, points[k].fields.traction.n);
    const auto beyond =
        touched_beyond(scene, geometry, area, grid, points[k], scene.points[k].load);
    if (!beyond) continue;
    const auto rows = [&](double way) {
      return contact::count_of(std::ceil(way / grid.dy),
                               "rows up to the next patch (contact_grid)") +
             free_elements;
    };
    if ((*beyond)[0] < grid.y_first) below = std::max(below, rows(grid.y_first - (*beyond)[0]));
    const double last = grid.y(grid.ny - 1);
    if ((*beyond)[1] > last) above = std::max(above, rows((*beyond)[1] - last));
  }
  ContactGrid larger = grid;
  larger.ny += below + above;
  larger.y_first -= below * grid.dy;
  return larger;
}

}  // namespace rollfem::halfspace
