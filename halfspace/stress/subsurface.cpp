// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/subsurface.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/threads.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/stress/subsurface_sum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

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
/// stays a pressure and the tangential tractions change sign, as do u_z, xz, yz in the result.
double mirror(const LoadedBody& body) {
  return body.body == Body::wheel ? 1.0 : -1.0;
}

LocalProblem local_problem(const LoadedBody& body) {
  check_spacing(body.grid, "contact grid");
  LocalProblem problem{body.grid,
                       {mirror(body) * sized(body.traction.x, body.grid, "x"),
                        mirror(body) * sized(body.traction.y, body.grid, "y"),
                        sized(body.traction.n, body.grid, "n")},
                       contact::shear_modulus(body.material),
                       body.material.poisson_ratio};
  check_half_space(0.0, problem.shear_modulus, problem.poisson_ratio);
  return problem;
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

/// On several threads where the sums are long.
void for_each_point(const DirectSum& sum, std::size_t count,
                    const std::function<void(std::size_t)>& work) {
  constexpr long corners_of_a_piece = 10000;  // 1 ms
  const std::ptrdiff_t piece = 1 + corners_of_a_piece / std::max(1L, sum.elements());
  contact::for_each_piece(static_cast<std::ptrdiff_t>(count), piece, [&](auto first, auto end) {
    for (auto k = first; k < end; ++k) work(static_cast<std::size_t>(k));
  });
}

}  // namespace

std::vector<SubsurfaceState> subsurface_at(const LoadedBody& body,
                                           const std::vector<SubsurfacePoint>& points) {
  const LocalProblem problem = local_problem(body);
  const DirectSum sum(problem);
  for (const SubsurfacePoint& point : points)
    check_half_space(point.depth, problem.shear_modulus, problem.poisson_ratio);
  std::vector<SubsurfaceState> states(points.size());
  for_each_point(sum, points.size(), [&](std::size_t k) {
    states[k] = global_state(sum.at(points[k].x, points[k].y, points[k].depth), mirror(body));
  });
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
  const bool possible = !body.grid.is_line() && same_spacing(body.grid, points);
  if (summation == Summation::fft && !possible)
    throw contact::InputError(fmt::format(
        "lattice spacing {} by {} mm; allowed for summation by FFT: that of the contact grid, {} "
        "by {} mm; use another spacing or direct summation",
        points.dx, points.dy, body.grid.dx, body.grid.dy));
  const DirectSum sum(problem);
  const bool by_fft =
      summation == Summation::fft || (summation == Summation::automatic && possible &&
                                      fft_is_cheaper(problem, points, sum.elements()));
  std::optional<LayerConvolution> convolution;
  if (by_fft) convolution.emplace(problem, points);
  std::vector<SubsurfaceLayer> layers;
  for (const double depth : depths) {
    std::vector<SubsurfaceState> states(static_cast<std::size_t>(points.size()));
    std::vector<LocalState> local;
    if (convolution) local = convolution->at(depth);
    for_each_point(sum, states.size(), [&](std::size_t n) {
      const int k = static_cast<int>(n);
      states[n] = global_state(
          convolution ? local[n] : sum.at(points.x(k % points.nx), points.y(k / points.nx), depth),
          mirror(body));
    });
    layers.push_back({depth, std::move(states)});
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
