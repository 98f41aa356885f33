// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/stresses.hpp"

#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/stress_extremes.hpp"
#include "result/stress_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rollfem::hybrid {

using contact::BelowSurface;
using contact::SubsurfaceField;
using contact::SubsurfaceRequest;
using halfspace::Body;
using halfspace::SubsurfacePoint;
using halfspace::SubsurfaceState;

namespace {

/// Fraction of the smaller semi-axis within which a point is moved onto the surface, as in the
/// finite-element model.
constexpr double reach_above = 0.125;

/// Turns a state from the axes of the surface to x, y, z.
void turn(const contact::Axes& axes, SubsurfaceState& state) {
  state.stress = contact::out_of_axes(axes, state.stress);
  state.displacement = contact::out_of_axes(axes, state.displacement);
}

std::optional<SmoothStressOnGrid> beyond_of(const SmoothDepthMap& map,
                                            const contact::ContactGrid& grid,
                                            const contact::SurfaceField& traction) {
  if (map.empty()) return {};
  return SmoothStressOnGrid(map, grid, traction);
}

contact::Geometry following(const contact::Scene& scene) {
  contact::Geometry geometry = scene.geometry;
  geometry.surface.follows = 1.0;
  return geometry;
}

}  // namespace

struct Stresses::CorrectedBody {
  halfspace::LoadedBody half;
  std::optional<SmoothStressOnGrid> beyond;  ///< none: a half-space

  void add_beyond(const SubsurfacePoint& at, SubsurfaceState& state) const {
    if (beyond) beyond->add(at, state);
  }
};

struct Stresses::Bodies {
  CorrectedBody wheel, rail;
  const CorrectedBody& of(bool is_wheel) const { return is_wheel ? wheel : rail; }
};

struct Stresses::Lists {
  std::vector<contact::Vector3> places;
  std::vector<SubsurfacePoint> points;
  std::vector<contact::Axes> axes;
};

Stresses::Stresses(const contact::Scene& scene, const SmoothParts& parts)
    : scene_(scene),
      parts_(parts),
      geometry_(following(scene), contact::Chart::arc),
      wheel_(geometry_, true),
      rail_(geometry_, false) {
  const halfspace::PatchExtent extent = halfspace::PatchSearch(scene).extent();
  reach_ = reach_above * 0.5 * std::min(extent.length, extent.width);
}

Stresses::Lists Stresses::lists(const SubsurfaceRequest& request, std::size_t number) const {
  const BelowSurface& body = request.wheel ? wheel_ : rail_;
  const char* const name = request.wheel ? "wheel" : "rail";
  Lists lists;
  for (auto place : halfspace::subsurface_points(request)) {
    if (request.kind == SubsurfaceRequest::Kind::surface)
      place = body.below(place[0], place[1], request.depth);
    const auto at = body.coordinates(place);
    const auto refuse = [&](const std::string& why) {
      throw contact::InputError(scene_.where(),
                                "request {} for stresses: ({:.6g}, {:.6g}, {:.6g}) mm is {}",
                                number + 1, place[0], place[1], place[2], why);
    };
    if (!(at.spread > BelowSurface::least_spread))
      refuse(
          fmt::format("so deep in the {} that the normals of its surface, which the hybrid model "
                      "follows, intersect there; allowed: depths of up to 0.7 of the radius of the "
                      "surface; do: request shallower points, or run with --model fem",
                      name));
    if (!(at.depth >= -reach_))
      refuse(
          fmt::format("not in the {}, but {:.4g} mm above its surface; allowed: up to {:.3g} mm "
                      "above (moved onto the surface); do: move the points into the body, or "
                      "follow its surface with [[subsurface.surface]]",
                      name, -at.depth, reach_));
    lists.places.push_back(at.depth < 0.0 ? body.place(at.x, at.y, 0.0) : place);
    lists.points.push_back({at.x, at.y, std::max(0.0, at.depth)});
    lists.axes.push_back(at.axes);
  }
  return lists;
}

Stresses::Bodies Stresses::bodies(const contact::ContactGrid& grid,
                                  const contact::SurfaceField& traction) const {
  const auto body = [&](Body which, const contact::Material& material,
                        const SmoothDepthMap& map) -> CorrectedBody {
    return {{which, material, grid, traction}, beyond_of(map, grid, traction)};
  };
  return {body(Body::wheel, scene_.wheel.material, parts_.wheel_below),
          body(Body::rail, scene_.rail.material, parts_.rail_below)};
}

SubsurfaceField Stresses::field(const SubsurfaceRequest& request, std::size_t number,
                                const CorrectedBody& body) const {
  Lists asked = lists(request, number);
  SubsurfaceField field;
  field.request = request;
  field.points = asked.places;
  auto states = halfspace::smooth_subsurface_at(body.half, asked.points);
  for (std::size_t k = 0; k < states.size(); ++k) {
    body.add_beyond(asked.points[k], states[k]);
    turn(asked.axes[k], states[k]);
    field.displacement.push_back(states[k].displacement);
    field.stress.push_back(states[k].stress);
  }
  return field;
}

void Stresses::add(const contact::ContactGrid& grid, contact::PointResult& point) const {
  point.subsurface.clear();
  if (!scene_.asks_for_stress()) return;
  const Bodies loaded = bodies(grid, point.fields.traction);
  for (std::size_t k = 0; k < scene_.subsurface.size(); ++k)
    point.subsurface.push_back(
        field(scene_.subsurface[k], k, loaded.of(scene_.subsurface[k].wheel)));
  if (!scene_.output.stress_maxima) return;
  point.stress_maxima = halfspace::stress_maxima(
      scene_, grid, point, [&](Body body, const SubsurfacePoint& at, SubsurfaceState& state) {
        loaded.of(body == Body::wheel).add_beyond(at, state);
      });
}

void Stresses::finish(const contact::ContactGrid& grid, double part, double relative,
                      contact::PointResult& point) const {
  const auto widen = [&](const std::string& name, double change) {
    const auto bar = point.error_estimate.find(name);
    if (bar != point.error_estimate.end()) bar->second = std::hypot(bar->second, part * change);
  };
  if (point.subsurface.empty() && point.stress_maxima.empty()) return;
  const Bodies loaded = bodies(grid, point.fields.traction);
  double most = 0.0;
  for (std::size_t k = 0; k < point.subsurface.size(); ++k) {
    const SubsurfaceField& field = point.subsurface[k];
    const Lists asked = lists(field.request, k);
    for (std::size_t p = 0; p < asked.points.size(); ++p) {
      SubsurfaceState state;
      loaded.of(field.request.wheel).add_beyond(asked.points[p], state);
      for (std::size_t c = 0; c < state.stress.size(); ++c)
        most = std::max({most, std::abs(state.stress[c]), std::abs(relative * field.stress[p][c])});
    }
  }
  widen("subsurface_stress", most);
  std::vector<contact::StressMaximum> plain;
  if (!point.stress_maxima.empty()) plain = halfspace::stress_maxima(scene_, grid, point);
  for (std::size_t k = 0; k < point.stress_maxima.size(); ++k) {
    contact::StressMaximum& maximum = point.stress_maxima[k];
    const auto widen_by = [&](double half_space) {
      widen(fmt::format("max_{}_{}", maximum.measure, maximum.body),
            std::hypot(maximum.value - half_space, relative * maximum.value));
    };
    if (maximum.measure == contact::xz_range) widen_by(plain[k].value);
    const bool wheel = maximum.body == "wheel";
    const SubsurfacePoint at{maximum.place[0], maximum.place[1], std::abs(maximum.place[2])};
    const auto half = halfspace::smooth_subsurface_at(loaded.of(wheel).half, {at});
    for (const contact::StressMeasure& measure : contact::reported_measures())
      if (measure.name == maximum.measure) widen_by(measure.value(half.front().stress));
    maximum.place = place(wheel, at.x, at.y, at.depth);
  }
}

}  // namespace rollfem::hybrid
