// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/subsurface.hpp"

#include "contact/base/errors.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/stress/subsurface_sum.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::halfspace {

namespace {

contact::Field sized(const contact::Field& field, const contact::ContactGrid& grid,
                     const char* name) {
  if (field.size() == 0) return contact::Field::Zero(grid.size());
  if (field.size() != grid.size())
    throw contact::InputError(
        fmt::format("traction.{} has {} values for a contact grid of {} by {}; allowed: one per "
                    "element, or none",
                    name, field.size(), grid.nx, grid.ny));
  if (!field.allFinite())
    throw contact::InputError(fmt::format("traction.{} is not finite everywhere", name));
  return field;
}

void check_spacing(const contact::ContactGrid& grid, const char* name) {
  if (grid.nx < 1 || grid.ny < 1 || !(grid.dx > 0.0 && grid.dy > 0.0))
    throw contact::InputError(
        fmt::format("{} of {} by {} points {} by {} mm apart; allowed: at least 1 by 1, spacing "
                    "positive",
                    name, grid.nx, grid.ny, grid.dx, grid.dy));
}

/// The rail is the mirror image of the wheel in z = 0: with the opposite tractions the pressure
/// stays a pressure and the tangential tractions change sign.
LocalProblem local_problem(const LoadedBody& body) {
  check_spacing(body.grid, "contact grid");
  const double sign = body.body == Body::wheel ? 1.0 : -1.0;
  LocalProblem problem;
  problem.grid = body.grid;
  problem.load_x = sign * sized(body.traction.x, body.grid, "x");
  problem.load_y = sign * sized(body.traction.y, body.grid, "y");
  problem.load_z = sized(body.traction.n, body.grid, "n");
  problem.shear_modulus = contact::shear_modulus(body.material);
  problem.poisson_ratio = body.material.poisson_ratio;
  check_half_space(0.0, problem.shear_modulus, problem.poisson_ratio);
  return problem;
}

/// Sign of the components that are odd in z: u_z, xz, yz.
double mirror(const LoadedBody& body) {
  return body.body == Body::wheel ? 1.0 : -1.0;
}

SubsurfaceState global_state(const LocalState& local, double odd) {
  SubsurfaceState state;
  state.displacement = {local[u_x], local[u_y], odd * local[u_z]};
  state.stress = {local[s_xx], local[s_yy],       local[s_zz],
                  local[s_xy], odd * local[s_yz], odd * local[s_xz]};
  return state;
}

bool same_spacing(const contact::ContactGrid& grid, const contact::ContactGrid& points) {
  const auto same = [](double a, double b, int count) {
    return count == 1 || std::abs(a - b) * count < 1e-9 * a;
  };
  return same(grid.dx, points.dx, points.nx) && same(grid.dy, points.dy, points.ny);
}

/// Costs in corner functions: the direct sum needs one per point and element, a layer of the
/// convolution one per offset, and its transforms cost about four times as much in addition
/// (measured).
bool fft_is_cheaper(const LocalProblem& problem, const contact::ContactGrid& points,
                    long loaded_elements) {
  const double offsets = static_cast<double>(problem.grid.nx + points.nx) *
                         static_cast<double>(problem.grid.ny + points.ny);
  return 5.0 * offsets < static_cast<double>(points.size()) * static_cast<double>(loaded_elements);
}

SubsurfaceLayer empty_layer(const contact::ContactGrid& points, double depth) {
  SubsurfaceLayer layer;
  layer.depth = depth;
  for (contact::Field* field : {&layer.displacement.x, &layer.displacement.y, &layer.displacement.n,
                                &layer.xx, &layer.yy, &layer.zz, &layer.xy, &layer.yz, &layer.xz})
    field->resize(points.size());
  return layer;
}

SubsurfaceLayer direct_layer(const DirectSum& sum, const contact::ContactGrid& points, double depth,
                             double odd) {
  SubsurfaceLayer layer = empty_layer(points, depth);
  for (int j = 0; j < points.ny; ++j)
    for (int i = 0; i < points.nx; ++i) {
      const SubsurfaceState state = global_state(sum.at(points.x(i), points.y(j), depth), odd);
      const int k = points.index(i, j);
      layer.displacement.x[k] = state.displacement[0];
      layer.displacement.y[k] = state.displacement[1];
      layer.displacement.n[k] = state.displacement[2];
      layer.xx[k] = state.stress.xx;
      layer.yy[k] = state.stress.yy;
      layer.zz[k] = state.stress.zz;
      layer.xy[k] = state.stress.xy;
      layer.yz[k] = state.stress.yz;
      layer.xz[k] = state.stress.xz;
    }
  return layer;
}

SubsurfaceLayer fft_layer(const LayerConvolution& convolution, double depth, double odd) {
  std::array<contact::Field, component_count> fields = convolution.at(depth);
  SubsurfaceLayer layer;
  layer.depth = depth;
  layer.displacement = {std::move(fields[u_x]), std::move(fields[u_y]), odd * fields[u_z]};
  layer.xx = std::move(fields[s_xx]);
  layer.yy = std::move(fields[s_yy]);
  layer.zz = std::move(fields[s_zz]);
  layer.xy = std::move(fields[s_xy]);
  layer.yz = odd * fields[s_yz];
  layer.xz = odd * fields[s_xz];
  return layer;
}

}  // namespace

SubsurfaceState SubsurfaceLayer::at(int index) const {
  SubsurfaceState state;
  state.displacement = {displacement.x[index], displacement.y[index], displacement.n[index]};
  state.stress = {xx[index], yy[index], zz[index], xy[index], yz[index], xz[index]};
  return state;
}

std::vector<SubsurfaceState> subsurface_at(const LoadedBody& body,
                                           const std::vector<SubsurfacePoint>& points) {
  const LocalProblem problem = local_problem(body);
  const DirectSum sum(problem);
  std::vector<SubsurfaceState> states;
  states.reserve(points.size());
  for (const SubsurfacePoint& point : points) {
    check_half_space(point.depth, problem.shear_modulus, problem.poisson_ratio);
    states.push_back(global_state(sum.at(point.x, point.y, point.depth), mirror(body)));
  }
  return states;
}

std::vector<SubsurfaceLayer> subsurface_box(const LoadedBody& body,
                                            const contact::ContactGrid& points,
                                            const std::vector<double>& depths,
                                            Summation summation) {
  const LocalProblem problem = local_problem(body);
  check_spacing(points, "lattice");
  for (const double depth : depths)
    check_half_space(depth, problem.shear_modulus, problem.poisson_ratio);
  const bool possible = same_spacing(body.grid, points);
  if (summation == Summation::fft && !possible)
    throw contact::InputError(fmt::format(
        "lattice spacing {} by {} mm; allowed for summation by FFT: that of the contact grid, {} "
        "by {} mm; use another spacing or direct summation",
        points.dx, points.dy, body.grid.dx, body.grid.dy));
  const DirectSum sum(problem);
  const bool by_fft =
      summation == Summation::fft || (summation == Summation::automatic && possible &&
                                      fft_is_cheaper(problem, points, sum.elements()));
  std::vector<SubsurfaceLayer> layers;
  layers.reserve(depths.size());
  if (by_fft) {
    const LayerConvolution convolution(problem, points);
    for (const double depth : depths) layers.push_back(fft_layer(convolution, depth, mirror(body)));
  } else {
    for (const double depth : depths)
      layers.push_back(direct_layer(sum, points, depth, mirror(body)));
  }
  return layers;
}

std::vector<std::array<double, 3>> subsurface_points(const contact::SubsurfaceRequest& request) {
  std::vector<std::array<double, 3>> points;
  const auto share = [](int k, int count) {
    return count > 1 ? static_cast<double>(k) / (count - 1) : 0.0;
  };
  for (int j = 0; j < request.points[1]; ++j)
    for (int i = 0; i < request.points[0]; ++i) {
      std::array<double, 3> point = request.from;
      for (int c = 0; c < 3; ++c) {
        point[c] += share(i, request.points[0]) * (request.to[c] - request.from[c]);
        if (request.points[1] > 1)
          point[c] += share(j, request.points[1]) * (request.across[c] - request.from[c]);
      }
      if (request.kind == contact::SubsurfaceRequest::Kind::surface)
        point[2] = request.wheel ? request.depth : 0.0 - request.depth;
      points.push_back(point);
    }
  return points;
}

std::vector<contact::SubsurfaceField> subsurface_fields(const contact::Scene& scene,
                                                        const contact::ContactGrid& grid,
                                                        const contact::SurfaceField& traction) {
  std::vector<contact::SubsurfaceField> fields;
  for (const contact::SubsurfaceRequest& request : scene.subsurface) {
    contact::SubsurfaceField field;
    field.request = request;
    field.points = subsurface_points(request);
    std::vector<SubsurfacePoint> points;
    for (const auto& point : field.points)
      points.push_back({point[0], point[1], request.wheel ? point[2] : 0.0 - point[2]});
    const LoadedBody body{request.wheel ? Body::wheel : Body::rail,
                          request.wheel ? scene.wheel.material : scene.rail.material, grid,
                          traction};
    for (const SubsurfaceState& state : subsurface_at(body, points)) {
      field.displacement.push_back(state.displacement);
      field.stress.push_back(state.stress.as_array());
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace rollfem::halfspace
