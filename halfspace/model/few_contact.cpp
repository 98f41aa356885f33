// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/few_contact.hpp"

#include "base/errors.hpp"
#include "contact/solve/point_motion.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/validity.hpp"

#include <algorithm>
#include <vector>

namespace rollfem::halfspace {

using contact::Scene;

namespace {

constexpr int most_elements = 20 * 20;  ///< of a grid

bool is_simple(const Scene& scene) {
  const contact::Friction law = scene.friction();
  const contact::LoadPoint& point = scene.points.front();
  return scene.problem == contact::Problem::steady && law && !law->feels_slip() && !law->varies() &&
         !law->memory() && !law->plasticity && !point.force.any() && !point.load.is_tilted() &&
         !scene.material.couples() && !scene.heat && !scene.geometry.line &&
         !scene.given_pressure && scene.upwind_order == contact::UpwindOrder::first;
}

bool same(const contact::CombinedMaterial& a, const contact::CombinedMaterial& b) {
  return a.shear_modulus == b.shear_modulus && a.poisson_ratio == b.poisson_ratio &&
         a.contact_modulus == b.contact_modulus && a.layer == b.layer;
}

}  // namespace

std::optional<contact::PointResult> FewContact::solve(const Scene& scene,
                                                      const contact::ContactGrid& grid) {
  if (!is_simple(scene) || grid.size() > most_elements || grid.nx > most_columns) return {};
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  if (geometry.curved()) return {};
  const contact::Field distance = geometry.undeformed_distance(grid);
  const bool known = distance_.size() == distance.size() && distance_ == distance &&
                     grid_.nx == grid.nx && grid_.dx == grid.dx && grid_.dy == grid.dy &&
                     same(material_, scene.material) && load_ == scene.points.front().load;
  try {
    if (!known && !press(scene, grid, distance)) return {};
    roll(scene, geometry);
  } catch (const contact::SolveError&) {
    distance_ = {};
    return {};
  }
  return point_;
}

bool FewContact::press(const Scene& scene, const contact::ContactGrid& grid,
                       const contact::Field& distance) {
  distance_ = {};
  const double ratio = grid.dy / grid.dx;
  if (table_.nx != grid.nx || table_.ny != grid.ny || table_.ratio != ratio ||
      !same(material_, scene.material))
    table_ = influence_table(grid.nx, grid.ny, ratio, scene.material);
  if (!rolling_ || grid_.nx != grid.nx || grid_.ny != grid.ny)
    rolling_.emplace(grid.nx, grid.ny, grid.size());
  grid_ = grid;
  material_ = scene.material;
  load_ = scene.points.front().load;
  FewElementsNormal compliance(material_);
  const std::vector<double> carried(static_cast<std::size_t>(grid.ny), 1.0);
  compliance.set({{&table_, grid, carried.data()}});
  contact::NormalOptions options;
  options.tolerance = 1e-6;
  // The forces of the last shape are a start where the elements are as many.
  const contact::Field start = normal_.pressure();
  if (load_.force)
    normal_.solve_sum(compliance, distance, *load_.force, options, start);
  else
    normal_.solve_approach(compliance, distance, *load_.approach, options, start);
  contact::ContactFields& fields = point_.fields;
  fields.traction.n = normal_.pressure() / grid.element_area();
  fields.gap = normal_.gap();
  fields.displacement.n = normal_.displacement();
  point_.approach = normal_.approach();
  if (!contact::holds_patch(scene, grid, fields.traction.n) ||
      !rolling_->set(table_, fields.traction.n, contact::Field::Zero(grid.size()),
                     material_.layer / grid.dx))
    return false;
  distance_ = distance;
  return true;
}

void FewContact::roll(const Scene& scene, const contact::ChartedGeometry& geometry) {
  contact::ContactFields& fields = point_.fields;
  const contact::Creepage& creepage = scene.points.front().creepage;
  const contact::TangentialProblem problem{
      fields.traction.n,
      contact::PointMotion(scene, geometry, grid_).at(0, {creepage.longitudinal, creepage.lateral}),
      scene.friction()};
  contact::TangentialOptions options;
  options.tolerance = 1e-5;  // as CONTACT's clients ask for
  newton_.solve(*rolling_, grid_, problem, rolling_->grid_indices(), options,
                {fields.traction.x, fields.traction.y});
  point_.creepage = creepage;
  const std::vector<Eigen::Index>& places = rolling_->grid_indices();
  const auto count = static_cast<Eigen::Index>(places.size());
  const auto on_grid = [&](const Eigen::VectorXd& both) {
    const contact::Field none = contact::Field::Zero(grid_.size());
    contact::TangentialField field{none, none};
    for (Eigen::Index e = 0; e < count; ++e) {
      field.x[places[static_cast<std::size_t>(e)]] = both[e];
      field.y[places[static_cast<std::size_t>(e)]] = both[count + e];
    }
    return field;
  };
  contact::TangentialSolution solution;
  solution.traction = on_grid(newton_.traction());
  fields.slip = on_grid(newton_.slip());
  contact::set_states(newton_, places, problem.friction, grid_, solution);
  fields.traction.x = std::move(solution.traction.x);
  fields.traction.y = std::move(solution.traction.y);
  fields.traction_bound = std::move(solution.bound);
  fields.state = std::move(solution.state);
  contact::integrate_tractions(grid_, point_);
}

}  // namespace rollfem::halfspace
