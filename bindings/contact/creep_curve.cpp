// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/creep_curve.hpp"

#include "base/errors.hpp"
#include "contact/solve/point_motion.hpp"
#include "halfspace/elasticity/influence_tables.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <utility>

namespace rollfem::addon {

using contact::Scene;

namespace {

constexpr int most_elements = 20 * 20;

bool is_simple(const Scene& scene) {
  const contact::Friction law = scene.friction();
  const contact::LoadPoint& point = scene.points.front();
  return scene.problem == contact::Problem::steady && law && !law->feels_slip() && !law->varies() &&
         !law->memory() && !law->plasticity && !point.force.any() && !scene.material.couples() &&
         !scene.heat && !scene.geometry.line && scene.upwind_order == contact::UpwindOrder::first;
}

}  // namespace

std::shared_ptr<CreepCurve> CreepCurve::of(const Scene& scene, const contact::ContactGrid& grid,
                                           const halfspace::Halfspaces& halfspaces,
                                           const contact::PointResult& solved) {
  const auto loaded = (solved.fields.traction.n.array() > 0.0).count();
  if (!is_simple(scene) || grid.nx > halfspace::most_columns || loaded > most_elements) return {};
  return std::shared_ptr<CreepCurve>(new CreepCurve(grid, halfspaces, solved));
}

CreepCurve::CreepCurve(const contact::ContactGrid& grid, halfspace::Halfspaces halfspaces,
                       contact::PointResult solved)
    : grid_(grid),
      halfspaces_(std::move(halfspaces)),
      point_(std::move(solved)),
      rolling_(grid.nx, grid.ny, most_elements) {}

contact::PointResult CreepCurve::at(const Scene& scene) {
  contact::ContactFields& fields = point_.fields;
  const contact::CombinedMaterial& material = halfspaces_.material;
  if (!std::exchange(ready_, true) &&
      !rolling_.set(halfspace::influence_table(grid_.nx, grid_.ny, grid_.dy / grid_.dx, material),
                    fields.traction.n, contact::Field::Zero(grid_.size()),
                    material.layer / grid_.dx))
    throw contact::SolveError("the elements do not fit");
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  const contact::Creepage& creepage = scene.points.front().creepage;
  contact::TangentialProblem problem{
      fields.traction.n,
      contact::PointMotion(scene, geometry, grid_).at(0, {creepage.longitudinal, creepage.lateral}),
      scene.friction()};
  newton_.solve(rolling_, grid_, problem, rolling_.grid_indices(), {},
                {fields.traction.x, fields.traction.y});
  Eigen::VectorXd strain(newton_.traction().size());
  rolling_.apply(newton_.traction(), Eigen::Map<Eigen::VectorXd>(strain.data(), strain.size()));
  point_.creepage = creepage;
  const auto count = static_cast<Eigen::Index>(rolling_.grid_indices().size());
  for (Eigen::Index e = 0; e < count; ++e) {
    const Eigen::Index k = rolling_.grid_indices()[static_cast<std::size_t>(e)];
    fields.traction.x[k] = newton_.traction()[e];
    fields.traction.y[k] = newton_.traction()[count + e];
    fields.slip.x[k] = problem.motion.rigid_slip.x[k] + strain[e];
    fields.slip.y[k] = problem.motion.rigid_slip.y[k] + strain[count + e];
    fields.state[static_cast<std::size_t>(k)] = newton_.adheres()[static_cast<std::size_t>(e)]
                                                    ? contact::ElementState::adhesion
                                                    : contact::ElementState::slip;
  }
  contact::integrate_tractions(grid_, point_);
  fields.displacement = halfspaces_.like->apply(fields.traction);
  return point_;
}

}  // namespace rollfem::addon
