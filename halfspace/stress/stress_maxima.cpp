// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/stress_maxima.hpp"

#include "contact/base/root.hpp"
#include "halfspace/stress/subsurface.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::StressMaximum;
using contact::ValueAt;

constexpr int layers = 18;
constexpr double deepest = 1.5;  ///< in smaller semi-axes

std::vector<double> depths_of(const contact::ContactGrid& grid, const contact::PointResult& point) {
  const double step = deepest / layers * std::min(point.semi_axis_x, point.semi_axis_y);
  std::vector<double> depths{0.0};
  for (int k = 1; k <= layers; ++k)
    if (k * step >= std::max(grid.dx, grid.dy)) depths.push_back(k * step);
  return depths;
}

/// The largest on the lattice; z = +depth in the wheel, -depth in the rail.
std::vector<ValueAt> largest_on_lattice(const LoadedBody& body, const std::vector<double>& depths,
                                        const StateBeyond& beyond) {
  const auto& measures = contact::reported_measures();
  std::vector<ValueAt> best(measures.size(), {-contact::infinity, {}});
  const double sign = body.body == Body::wheel ? 1.0 : -1.0;
  for (const SubsurfaceLayer& layer : subsurface_box(body, body.grid, depths))
    for (int k = 0; k < body.grid.size(); ++k) {
      SubsurfaceState state = layer.at(k);
      if (beyond)
        beyond(body.body,
               {body.grid.x(k % body.grid.nx), body.grid.y(k / body.grid.nx), layer.depth}, state);
      const contact::Stress& stress = state.stress;
      for (std::size_t m = 0; m < measures.size(); ++m) {
        const double value = measures[m].value(stress);
        if (value > best[m].value)
          best[m] = {value,
                     {body.grid.x(k % body.grid.nx), body.grid.y(k / body.grid.nx),
                      sign * layer.depth + 0.0}};
      }
    }
  return best;
}

ValueAt refined(const LoadedBody& body, const contact::StressMeasure& measure, const ValueAt& start,
                double step, const StateBeyond& beyond) {
  const double least = std::max(body.grid.dx, body.grid.dy);
  if (start.place[2] == 0.0) return start;
  const auto values = [&](const std::vector<std::array<double, 3>>& places) {
    std::vector<SubsurfacePoint> points;
    for (const auto& p : places) points.push_back({p[0], p[1], std::max(std::abs(p[2]), least)});
    std::vector<ValueAt> result;
    auto states = subsurface_at(body, points);
    if (beyond)
      for (std::size_t k = 0; k < places.size(); ++k) beyond(body.body, points[k], states[k]);
    for (std::size_t k = 0; k < places.size(); ++k)
      result.push_back(
          {std::abs(places[k][2]) < least ? -contact::infinity : measure.value(states[k].stress),
           places[k]});
    return result;
  };
  return contact::local_maximum(values, start, step);
}

}  // namespace

std::vector<StressMaximum> stress_maxima(const contact::Scene& scene,
                                         const contact::ContactGrid& grid,
                                         const contact::PointResult& point,
                                         const StateBeyond& beyond) {
  const auto depths = depths_of(grid, point);
  const auto& measures = contact::reported_measures();
  std::vector<StressMaximum> maxima;
  for (const bool wheel : {true, false}) {
    const LoadedBody body{wheel ? Body::wheel : Body::rail,
                          wheel ? scene.wheel.material : scene.rail.material, grid,
                          point.fields.traction};
    const auto best = largest_on_lattice(body, depths, beyond);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      const ValueAt at =
          refined(body, measures[m], best[m], 0.5 * std::max(grid.dx, grid.dy), beyond);
      maxima.push_back({wheel ? "wheel" : "rail", measures[m].name, at.value, at.place});
    }
  }
  return maxima;
}

}  // namespace rollfem::halfspace
