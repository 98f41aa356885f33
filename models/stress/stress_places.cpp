// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/stress/stress_places.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/case_reader.hpp"
#include "contact/result/stress_extremes.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "hybrid/stresses.hpp"
#include "models/fem/fem_models.hpp"
#include "models/solving/case_scenes.hpp"
#include "postprocess/read/body_sampler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rollfem::modelling {
namespace {

using contact::InputError;
using contact::ModelResult;
using contact::SubsurfaceField;
using contact::SubsurfaceRequest;
using postprocess::BodySampler;
using postprocess::StressSet;

constexpr int profile_points = 121;
constexpr double profile_depth = 3.0;  ///< in units of the smaller semi-axis

struct Spot {
  double x = 0.0;
  double y = 0.0;
};

/// Middle of the loaded elements, and of the most loaded one.
std::pair<Spot, Spot> spots(const contact::ContactGrid& grid, const contact::Field& pressure) {
  Spot centre;
  int count = 0;
  Eigen::Index most = 0;
  pressure.maxCoeff(&most);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      if (pressure[grid.index(i, j)] > 0.0) {
        centre.x += grid.x(i);
        centre.y += grid.y(j);
        ++count;
      }
  const auto clean = [](double sum, int n, double size) {
    const double mean = n > 0 ? sum / n : 0.0;
    return std::abs(mean) < 1e-9 * size ? 0.0 : mean;
  };
  centre = {clean(centre.x, count, grid.dx), clean(centre.y, count, grid.dy)};
  const int k = static_cast<int>(most);
  return {centre, {grid.x(k % grid.nx), grid.y(k / grid.nx)}};
}

/// A half-space has no material beyond z = 0.
void refuse_beyond_surface(const NamedRequest& named, const std::string& model) {
  for (const auto& place : halfspace::subsurface_points(named.request))
    if ((named.request.wheel ? place[2] : -place[2]) < 0.0)
      throw InputError(fmt::format(
          "{}: ({:g}, {:g}, {:g}) mm is not in the {} of model {}, a half-space with z {} 0; do: "
          "name points inside it, or the other body",
          named.call, place[0], place[1], place[2], named.request.wheel ? "wheel" : "rail", model,
          named.request.wheel ? ">=" : "<="));
}

/// On the surface the jumps of traction between elements make the in-plane stress infinite at
/// element edges. Places there get the stress interpolated between the middles of the four elements
/// around them, where it is accurate.
void smooth_surface(const halfspace::LoadedBody& body, SubsurfaceField& field) {
  std::vector<std::size_t> places;
  std::vector<halfspace::SubsurfacePoint> middles;
  std::vector<std::array<double, 2>> shares;
  for (std::size_t k = 0; k < field.points.size(); ++k) {
    if (field.points[k][2] != 0.0) continue;
    const double i = (field.points[k][0] - body.grid.x_first) / body.grid.dx;
    const double j = (field.points[k][1] - body.grid.y_first) / body.grid.dy;
    places.push_back(k);
    shares.push_back({i - std::floor(i), j - std::floor(j)});
    for (const int b : {0, 1})
      for (const int a : {0, 1})
        middles.push_back({body.grid.x_first + (std::floor(i) + a) * body.grid.dx,
                           body.grid.y_first + (std::floor(j) + b) * body.grid.dy, 0.0});
  }
  if (places.empty()) return;
  const auto states = halfspace::subsurface_at(body, middles);
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::array<double, 6>& stress = field.stress[places[k]];
    stress.fill(0.0);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto [s, t] = shares[k];
      const double weight = (corner % 2 == 1 ? s : 1.0 - s) * (corner / 2 == 1 ? t : 1.0 - t);
      const auto values = states[4 * k + corner].stress.as_array();
      for (std::size_t c = 0; c < 6; ++c) stress[c] += weight * values[c];
    }
  }
}

/// Stress by interpolation in a body.
StressSet set_in(const BodySampler& body, const NamedRequest& named, double semi_axis) {
  StressSet set;
  set.name = named.name;
  set.field.request = named.request;
  auto places = halfspace::subsurface_points(named.request);
  // The surface lies at z = 0 only in the middle of the patch.
  const double inner = named.request.wheel ? 0.5 * semi_axis : -0.5 * semi_axis;
  const bool follows = named.request.kind == SubsurfaceRequest::Kind::surface;
  double height = 0.0;
  for (auto& place : places) {
    if (follows || (named.depth_profile && &place == &places.front()))
      height = body.surface(place[0], place[1], inner, -inner);
    place[2] += height;
  }
  for (const auto& place : places) {
    const auto sample = contact::at_place(named.call + ": ", [&] { return body.at(place); });
    set.field.points.push_back(sample.place);
    set.field.displacement.push_back(sample.displacement);
    set.field.stress.push_back(sample.stress);
    set.moved = std::max(set.moved, sample.moved);
  }
  return set;
}

/// Finite-element results store only elastic bodies.
bool is_rigid(const ModelResult& model, const std::string& body) {
  return !model.bodies.empty() &&
         std::none_of(model.bodies.begin(), model.bodies.end(),
                      [&](const contact::BodyField& stored) { return stored.name == body; });
}

/// The scene of the result's patch.
contact::Scene scene_of(const contact::Case& input, const ModelResult& model) {
  if (!model.place) return input;
  for (const contact::Case& how : {input, on_common_surface(input)}) {
    const auto scenes = contact::attempt([&] { return scenes_of(how, placed_wheels(how)).list; });
    if (!scenes) continue;
    for (const contact::Scene& scene : *scenes)
      if (scene.place && scene.place->same_patch(*model.place) &&
          scene.place->patches == model.place->patches)
        return scene;
  }
  throw InputError(fmt::format(
      "{}: patch {} of the result is no longer found in its case; do: run the case again",
      input.file, model.place->label()));
}

/// Whether a line and both sides of a plane have a length; otherwise they cannot be drawn.
bool has_length(const contact::SubsurfaceRequest& places) {
  using Kind = contact::SubsurfaceRequest::Kind;
  if (places.kind == Kind::point) return true;
  return places.to != places.from && (places.kind != Kind::plane || places.across != places.from);
}

}  // namespace

std::vector<NamedRequest> named_requests(const StressRequest& request) {
  std::vector<NamedRequest> all;
  if (request.places.empty()) return all;
  std::map<std::string, int> counts;
  for (const contact::SubsurfaceRequest& places : contact::read_places(request.places)) {
    const std::string kind = word_of(places.kind);
    const std::string name = fmt::format("{}_{}", kind, ++counts[kind]);
    if (!has_length(places))
      throw InputError(fmt::format("{}: {}: two of its points coincide; do: move one of them",
                                   request.places, name));
    all.push_back({name, fmt::format("{}: {}", request.places, name), places});
  }
  return all;
}

std::vector<NamedRequest> depth_profiles(const ModelResult& model, std::size_t number,
                                         const StressRequest& request) {
  const contact::PointResult& point = model.points.at(number);
  const double semi_axis = contact::smaller_semi_axis(model.grid, point);
  const double depth = request.depth.value_or(profile_depth * semi_axis);
  if (!(depth > 0.0) || !std::isfinite(depth))
    throw InputError(
        request.depth
            ? fmt::format("--depth {:g}: allowed: a depth > 0 in mm; do: give one", *request.depth)
            : fmt::format("model {} does not give the size of the patch; do: give a --depth",
                          model.key()));
  const auto [centre, most] = spots(model.grid, point.fields.traction.n);
  const bool apart = std::abs(most.x - centre.x) > 0.51 * model.grid.dx ||
                     std::abs(most.y - centre.y) > 0.51 * model.grid.dy;
  std::vector<NamedRequest> profiles;
  const auto add = [&](const char* name, const Spot& spot) {
    for (const bool wheel : {true, false}) {
      const char* body = wheel ? "wheel" : "rail";
      if (is_rigid(model, body)) continue;
      SubsurfaceRequest line;
      line.kind = SubsurfaceRequest::Kind::line;
      line.wheel = wheel;
      line.from = {spot.x, spot.y, 0.0};
      line.to = {spot.x, spot.y, wheel ? depth : -depth};
      line.points = {profile_points, 1};
      profiles.push_back({name, "depth profile", line, true});
    }
  };
  add("depth_centre", centre);
  if (apart) add("depth_most_loaded", most);
  return profiles;
}

std::vector<StressSet> halfspace_sets(contact::Scene scene, const ModelResult& model,
                                      std::size_t point,
                                      const std::vector<NamedRequest>& requests) {
  const contact::SurfaceField& traction = model.points.at(point).fields.traction;
  for (const NamedRequest& named : requests) {
    refuse_beyond_surface(named, model.key());
    scene.subsurface.push_back(named.request);
  }
  std::vector<StressSet> sets;
  for (SubsurfaceField& field : halfspace::subsurface_fields(scene, model.grid, traction)) {
    const bool wheel = field.request.wheel;
    smooth_surface({wheel ? halfspace::Body::wheel : halfspace::Body::rail,
                    wheel ? scene.wheel.material : scene.rail.material, model.grid, traction},
                   field);
    sets.push_back({requests[sets.size()].name, std::move(field), 0.0});
  }
  return sets;
}

std::vector<StressSet> body_sets(const ModelResult& model, std::size_t point,
                                 const std::vector<NamedRequest>& requests) {
  for (const NamedRequest& named : requests)
    if (const char* body = named.request.wheel ? "wheel" : "rail"; is_rigid(model, body))
      throw InputError(
          fmt::format("{}: the {} is rigid and has no stored stress; do: name the other body",
                      named.call, body));
  const contact::PointResult& at = model.points.at(point);
  std::vector<StressSet> sets(requests.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const contact::BodyField field = model.body_at(point, b);
    const BodySampler sampler(field);
    for (std::size_t k = 0; k < requests.size(); ++k)
      if (requests[k].request.wheel == (field.name == "wheel"))
        sets[k] = set_in(sampler, requests[k], std::min(at.semi_axis_x, at.semi_axis_y));
  }
  return sets;
}

std::vector<StressSet> hybrid_sets(const contact::Case& input, const ModelResult& model,
                                   std::size_t point, const std::vector<NamedRequest>& requests,
                                   std::vector<contact::StressMaximum>& maxima) {
  // The case text alone does not determine the layout of the bodies.
  contact::Scene scene = scene_of(contact::parse_case(input.text, input.file), model);
  scene.subsurface.clear();
  scene.output.stress_maxima = true;
  scene.follows_surface = 1.0;
  const halfspace::SmoothParts parts = find_smooth_parts(scene, {});
  const hybrid::Stresses stresses(scene, parts);
  for (const NamedRequest& named : requests) {
    SubsurfaceRequest request = named.request;
    if (named.depth_profile) {
      const auto& spot = named.request.from;
      request.from = stresses.place(request.wheel, spot[0], spot[1], 0.0);
      request.to = stresses.place(request.wheel, spot[0], spot[1], std::abs(named.request.to[2]));
    }
    scene.subsurface.push_back(request);
  }
  contact::PointResult solved = model.points.at(point);
  stresses.add(model.grid, solved);
  stresses.finish(model.grid, 0.0, 0.0, solved);
  std::vector<StressSet> sets;
  for (std::size_t k = 0; k < requests.size(); ++k)
    sets.push_back({requests[k].name, std::move(solved.subsurface[k]), 0.0});
  maxima = std::move(solved.stress_maxima);
  return sets;
}

}  // namespace rollfem::modelling
