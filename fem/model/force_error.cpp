#include "fem/model/force_error.hpp"

#include "contact/result/quantities.hpp"
#include "contact/result/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::ModelResult;
using contact::PointResult;

/// Of the largest traction and the area of adhesion, whose border no grid has exactly.
constexpr double traction_share = 3.0;

struct Force {
  const char* name;
  /// The largest traction stands where adhesion ends, within an element of it, and a moment weighs
  /// the edges most: both go with the first power of the element, and no two levels are even.
  bool uneven;
  double share;  ///< of grid_error(): what is believed at least
};

constexpr Force forces[] = {{"traction_coefficient", false, 1.0},
                            {"longitudinal_force", false, 1.0},
                            {"lateral_force", false, 1.0},
                            {"spin_moment", true, 1.0},
                            {"max_traction_x", true, traction_share},
                            {"max_traction", true, traction_share},
                            {"adhesion_area", true, traction_share}};

/// On fewer elements across than this errors fall with the square of their number, and two levels
/// agree the more easily by chance (docs/accuracy.md).
constexpr double fewest_even = 16.0;

/// What the contact grid alone leaves uncertain in a force, as part of it.
double grid_error(const PointResult& point, const contact::ContactGrid& grid) {
  const double across = 2.0 * std::min(point.semi_axis_x / grid.dx, point.semi_axis_y / grid.dy);
  if (point.adhesion_area == 0.0 || !(across > 0.0)) return 0.0;
  return contact::least_rolling_error / across * std::max(1.0, fewest_even / across);
}

}  // namespace

void estimate_force_errors(const contact::Scene& scene, std::vector<ModelResult>& levels,
                           std::size_t k, double assumed_order) {
  PointResult& fine = levels.back().points[k];
  const double least = grid_error(fine, levels.back().grid);
  for (const Force& force : forces) {
    std::vector<double> values;
    for (const ModelResult& level : levels)
      values.push_back(contact::quantity(level.points[k], force.name));
    const double scale = contact::estimate_scale(scene.friction_coefficient(), fine, force.name);
    if (!(scale > 0.0) || (values.back() == 0.0 && values[values.size() - 2] == 0.0)) continue;
    const bool uneven = force.uneven && fine.adhesion_area > 0.0;
    const double change = contact::estimated_error(values, uneven ? 1.0 : assumed_order);
    fine.error_estimate[force.name] =
        std::max((uneven ? contact::uneven_safety : 1.0) * change, force.share * least * scale);
  }
}

}  // namespace rollfem::fem
