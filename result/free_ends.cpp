// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/free_ends.hpp"

#include "result/bars.hpp"
#include "result/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

bool is_loaded(const ContactGrid& grid, const Field& pressure, int row) {
  return pressure.segment(grid.index(0, row), grid.nx).maxCoeff() > 0.0;
}

}  // namespace

LoadedEnds loaded_ends(const Scene& scene, const ContactGrid& grid, const PointResult& point) {
  LoadedEnds loaded;
  const Field& pressure = point.fields.traction.n;
  if (!scene.geometry.surface.profiles || pressure.size() != grid.size()) return loaded;
  const auto near = [&](const FreeEnd& end, int row, double way) {
    return std::abs(grid.y(row) - end.y) <= way;
  };
  for (const FreeEnd& end : scene.geometry.surface.profiles->free_ends())
    for (int j = 0; j < grid.ny; ++j)
      if (near(end, j, grid.dy) && is_loaded(grid, pressure, j)) {
        loaded.ends.push_back(end);
        break;
      }
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    if (std::any_of(loaded.ends.begin(), loaded.ends.end(),
                    [&](const FreeEnd& end) { return near(end, j, point.semi_axis_x); }))
      sum += pressure.segment(grid.index(0, j), grid.nx).sum();
  if (sum > 0.0) loaded.share = sum / pressure.sum();
  return loaded;
}

void explain_singular_values(const Scene& scene, const ContactGrid& grid, PointResult& point) {
  if (loaded_ends(scene, grid, point).ends.empty()) return;
  for (const char* name : {"max_pressure", "max_traction", "max_traction_x", "max_pass_work"}) {
    if (!quantity_named(name).value(point)) continue;
    point.error_estimate.erase(name);
    point.richardson.erase(name);
    point.no_bar[name] = NoBar::no_limit;
  }
}

void cut_at_ends(const Scene& scene, PatchSize& size, double beyond) {
  if (!scene.has_profiles() || scene.geometry.surface.profiles->free_ends().empty()) return;
  const double middle = 0.5 * (size.y_lower + size.y_upper);
  for (const FreeEnd& end : scene.geometry.surface.profiles->free_ends())
    if (end.y < middle && size.y_lower < end.y + beyond)
      size.y_lower = end.y;
    else if (end.y >= middle && size.y_upper > end.y - beyond)
      size.y_upper = end.y;
  size.width = size.y_upper - size.y_lower;
}

void place_patch(const Scene& scene, const ContactGrid& grid, PointResult& point) {
  if (!scene.has_profiles()) return;
  PatchSize size = patch_size(grid, point.fields.traction.n);
  const double width = size.width;
  cut_at_ends(scene, size, 0.5 * grid.dy);
  point.patch_x_middle = size.x_middle();
  point.patch_y_middle = size.y_middle();
  if (size.width == width) return;
  point.contact_width *= size.width / width;
  point.semi_axis_y = 0.5 * point.contact_width;
}

}  // namespace rollfem::contact
