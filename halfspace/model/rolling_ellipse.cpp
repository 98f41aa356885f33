// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/rolling_ellipse.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "contact/solve/side_by_side.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <tuple>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::LevelResult;
using contact::Scene;

namespace {

/// Free elements around the patch; the second-order difference uses two columns upstream.
constexpr int free_around = 2;

constexpr int coarsest = 10;  ///< elements across

/// Effect of the starting tractions on the forces.
constexpr double tolerance = 1e-11;

/// The ellipse with G = 1, mu = 1, a b = 1 and F_n = 1, so that creepages, forces and moments of
/// its load points are scaled as in the table.
Scene scaled_scene(const EllipseShape& shape, const std::vector<ScaledCreepage>& creepages) {
  contact::Case input;
  const double a = std::sqrt(shape.axis_ratio);
  input.given_pressure = contact::GivenPressure{a, 1.0 / a, 1.5 / contact::pi};
  input.load.normal_force = 1.0;
  input.friction_coefficient = 1.0;
  input.friction_fall = shape.friction.fall;
  input.rolling.speed = shape.friction.speed;
  input.layer = shape.friction.layer;
  input.wheel.material = {2.0 * (1.0 + shape.poisson_ratio), shape.poisson_ratio};
  input.rail.material = input.wheel.material;
  input.rolling.creepages = creepages;
  if (!shape.heat) return Scene(input);
  if (!(input.rolling.speed > 0.0)) input.rolling.speed = 1.0;
  // With beta = sqrt(V) / unit of both bodies together.
  constexpr double per_tonne = 1e6;
  const double effusivity = 0.5 * std::sqrt(input.rolling.speed) / shape.heat->unit;
  for (contact::Body* body : std::initializer_list<contact::Body*>{&input.wheel, &input.rail}) {
    contact::BodyHeat& heat = body->heat.emplace();
    heat.temperature = shape.heat->temperature;
    heat.capacity =
        effusivity * effusivity / (heat.conductivity * per_tonne * body->material.density);
  }
  return Scene(input);
}

ContactGrid grid_of(const EllipseShape& shape, int across) {
  const double a = std::sqrt(shape.axis_ratio);
  return ContactGrid::centred(across + 2 * free_around, across + 2 * free_around, 2.0 * a / across,
                              2.0 / (a * across));
}

LevelResult solve_level(const Scene& scene, const ContactGrid& grid, const LevelResult* coarser) {
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  contact::RunOptions options;
  options.accuracy.tangential = tolerance;
  options.coarser = coarser;
  options.independent = true;
  const auto make = [&] { return halfspace_elasticity(scene, geometry, grid); };
  return contact::solve_points(scene, geometry, options, {}, nullptr, grid, make).value();
}

ScaledForces forces_of(const contact::PointResult& point) {
  return {point.longitudinal_force, point.lateral_force, point.spin_moment};
}

/// Ratio of the change from `coarse` to `fine` to the change from `fine` to the limit: order 3/2.
EllipseForces limit_of(const ScaledForces& fine, const ScaledForces& coarse, int across) {
  const double weight = 1.0 / (std::pow(2.0, 1.5) - 1.0);
  const ScaledForces rest{weight * (fine.longitudinal - coarse.longitudinal),
                          weight * (fine.lateral - coarse.lateral),
                          weight * (fine.spin_moment - coarse.spin_moment)};
  return {{fine.longitudinal + rest.longitudinal, fine.lateral + rest.lateral,
           fine.spin_moment + rest.spin_moment},
          rest,
          across};
}

bool small(const ScaledForces& correction, double largest) {
  return std::hypot(correction.longitudinal, correction.lateral) <= largest &&
         std::abs(correction.spin_moment) <= 4.0 * largest;
}

void check(const EllipseShape& shape, const std::vector<ScaledCreepage>& creepages,
           const EllipseAccuracy& accuracy) {
  const auto refuse = [](const std::string& what, const char* allowed) {
    throw contact::InputError(fmt::format("table: {}: allowed: {}", what, allowed));
  };
  if (!(shape.axis_ratio >= 1e-3 && shape.axis_ratio <= 1e3))
    refuse(fmt::format("axis ratio {:g}", shape.axis_ratio), "0.001 to 1000");
  if (!(shape.poisson_ratio >= 0.0 && shape.poisson_ratio <= 0.5))
    refuse(fmt::format("Poisson's ratio {:g}", shape.poisson_ratio), "0 to 0.5");
  for (std::size_t k = 0; k < creepages.size(); ++k)
    if (!std::isfinite(creepages[k].longitudinal + creepages[k].lateral + creepages[k].spin))
      refuse(fmt::format("creepages of point {}", k), "finite numbers");
  if (accuracy.most_across < 2 * coarsest)
    refuse(fmt::format("most_across = {}", accuracy.most_across), "20 and more");
}

/// The load points at these indices, with the start of the finer level.
std::pair<Scene, LevelResult> part_of(const Scene& scene, const LevelResult& level,
                                      const std::vector<std::size_t>& places) {
  std::pair<Scene, LevelResult> part{scene, {}};
  part.first.points.clear();
  part.second.grid = level.grid;
  part.second.pressure = level.pressure;
  for (const std::size_t k : places) {
    part.first.points.push_back(scene.points[k]);
    part.second.points.push_back(level.points[k]);
    part.second.relative_traction.push_back(level.relative_traction[k]);
  }
  return part;
}

std::vector<EllipseForces> all_levels(const EllipseShape& shape, Scene scene,
                                      const EllipseAccuracy& accuracy) {
  std::vector<EllipseForces> results(scene.points.size());
  std::vector<std::size_t> open;  // indices in the results
  for (std::size_t k = 0; k < results.size(); ++k) open.push_back(k);
  LevelResult coarse = solve_level(scene, grid_of(shape, coarsest), nullptr);
  for (int across = 2 * coarsest; !open.empty(); across *= 2) {
    LevelResult fine = solve_level(scene, grid_of(shape, across), &coarse);
    std::vector<std::size_t> left, still_open;
    for (std::size_t k = 0; k < open.size(); ++k) {
      EllipseForces& result = results[open[k]];
      result = limit_of(forces_of(fine.points[k]), forces_of(coarse.points[k]), across);
      if (shape.heat)
        result.rise = (fine.points[k].max_temperature.value_or(shape.heat->temperature) -
                       shape.heat->temperature) /
                      shape.heat->unit;
      if (small(result.correction, accuracy.largest_correction) ||
          2 * across > accuracy.most_across)
        continue;
      left.push_back(k);
      still_open.push_back(open[k]);
    }
    std::tie(scene, coarse) = part_of(scene, fine, left);
    open = std::move(still_open);
  }
  return results;
}

}  // namespace

std::vector<EllipseForces> roll_ellipse(const EllipseShape& shape,
                                        const std::vector<ScaledCreepage>& creepages,
                                        const EllipseAccuracy& accuracy) {
  check(shape, creepages, accuracy);
  if (creepages.empty()) return {};
  return contact::at_place({fmt::format("table, axis ratio {:g}", shape.axis_ratio)}, [&] {
    return all_levels(shape, scaled_scene(shape, creepages), accuracy);
  });
}

}  // namespace rollfem::halfspace
