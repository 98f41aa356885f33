// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/stress_maxima.hpp"

#include "base/root.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/stress_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rollfem::halfspace {

namespace {

using contact::StressMaximum;
using contact::ValueAt;

constexpr int layers = 18;
constexpr double deepest = 1.5;  ///< in smaller semi-axes

std::vector<double> depths_of(const contact::ContactGrid& grid, const contact::PointResult& point) {
  const double step = deepest / layers * contact::smaller_semi_axis(grid, point);
  std::vector<double> depths{0.0};
  for (int k = 1; k <= layers; ++k)
    if (k * step >= grid.longer_side()) depths.push_back(k * step);
  if (depths.size() < 2) depths.push_back(grid.longer_side());  // long elements
  return depths;
}

/// The largest of each measure on the surface and below it, and xz below it.
struct Lattice {
  std::vector<ValueAt> on_surface, below;
  contact::RollingLines lines;
  std::vector<double> xz;
};

/// z = +depth in the wheel, -depth in the rail.
Lattice largest_on_lattice(const LoadedBody& body, const std::vector<double>& depths,
                           const StateBeyond& beyond) {
  const auto& measures = contact::reported_measures();
  const std::vector<ValueAt> none(measures.size(), {-contact::infinity, {}});
  Lattice found{none, none, {body.grid.nx, body.grid.ny, {}}, {}};
  const double sign = body.body == Body::wheel ? 1.0 : -1.0;
  for (const SubsurfaceLayer& layer : subsurface_box(body, body.grid, depths))
    for (int k = 0; k < body.grid.size(); ++k) {
      SubsurfaceState state = layer.states[static_cast<std::size_t>(k)];
      const double x = body.grid.x(k % body.grid.nx), y = body.grid.y(k / body.grid.nx);
      if (beyond) beyond(body.body, {x, y, layer.depth}, state);
      const std::array<double, 3> place{x, y, sign * layer.depth + 0.0};
      auto& best = layer.depth == 0.0 ? found.on_surface : found.below;
      for (std::size_t m = 0; m < measures.size(); ++m)
        if (const double value = measures[m].value(state.stress); value > best[m].value)
          best[m] = {value, place};
      if (layer.depth == 0.0) continue;
      found.lines.places.push_back(place);
      found.xz.push_back(state.stress[contact::component::xz]);
    }
  return found;
}

ValueAt refined(const LoadedBody& body, const contact::StressMeasure& measure, const ValueAt& start,
                double step, const StateBeyond& beyond) {
  const double least = body.grid.longer_side();
  const auto values = [&](const std::vector<std::array<double, 3>>& places) {
    std::vector<SubsurfacePoint> points;
    for (const auto& p : places) points.push_back({p[0], p[1], std::max(std::abs(p[2]), least)});
    std::vector<ValueAt> result;
    auto states = subsurface_at(body, points);
    if (beyond)
      for (std::size_t k = 0; k < places.size(); ++k) beyond(body.body, points[k], states[k]);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool beside = body.grid.is_line() && places[k][1] != start.place[1];
      const bool out = beside || std::abs(places[k][2]) < least;
      result.push_back({out ? -contact::infinity : measure.value(states[k].stress), places[k]});
    }
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
    const std::string name = wheel ? "wheel" : "rail";
    const Lattice best = largest_on_lattice(body, depths, beyond);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      ValueAt at = refined(body, measures[m], best.below[m], 0.5 * grid.longer_side(), beyond);
      if (!contact::only_below(measures[m]) && best.on_surface[m].value > at.value)
        at = best.on_surface[m];
      maxima.push_back({name, measures[m].name, at.value, at.place});
    }
    maxima.push_back(contact::largest_surface_shear(name, grid, point));
    maxima.push_back(contact::largest_xz_range(name, best.lines, best.xz));
  }
  return maxima;
}

}  // namespace rollfem::halfspace
