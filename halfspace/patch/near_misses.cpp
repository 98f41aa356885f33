// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/near_misses.hpp"

#include "contact/base/pi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

/// The gap must fall by this fraction of the approach: less is the roughness of a profile.
constexpr double least_fall = 1e-3;

}  // namespace

double displacement_beside(double x, double y, const ContactGrid& grid, const Field& pressure,
                           double modulus) {
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (const double p = pressure[grid.index(i, j)]; p > 0.0)
        sum += p / std::hypot(x - grid.x(i), y - grid.y(j));
  return sum * grid.element_area() / (contact::pi * modulus);
}

Box with_near_misses(const Box& patch, const Ridge& ridge, double approach, const ContactGrid& grid,
                     const Field& pressure, double modulus) {
  Box box = patch;
  double widest = std::numeric_limits<double>::lowest();  // gap passed on the way from the patch
  const auto look_at = [&](double y, const RidgePoint& point) {
    const double overlap = approach - point.distance;
    const double gap = overlap > 0.0
                           ? displacement_beside(point.x, y, grid, pressure, modulus) - overlap
                           : -overlap;
    widest = std::max(widest, gap);
    if (!(overlap > 0.0) || gap > widest - least_fall * approach) return;
    // As long as Hertz's patch of this approach.
    const double half = std::sqrt(0.5 * overlap / std::max(point.curvature, 1e-12));
    box = {std::min(box.x_lower, point.x - half), std::max(box.x_upper, point.x + half),
           std::min(box.y_lower, y), std::max(box.y_upper, y)};
  };
  const auto& places = ridge.places();
  const auto& points = ridge.points();
  for (std::size_t k = places.size(); k-- > 0;)
    if (places[k] < patch.y_lower) look_at(places[k], points[k]);
  widest = std::numeric_limits<double>::lowest();
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places[k] > patch.y_upper) look_at(places[k], points[k]);
  return box;
}

}  // namespace rollfem::halfspace
