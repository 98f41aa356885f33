// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/quick_patch.hpp"

#include "contact/iteration/leading_edge.hpp"
#include "contact/solve/pressure_share.hpp"
#include "halfspace/elasticity/neighbours.hpp"
#include "halfspace/patch/load_sharing.hpp"
#include "result/derived.hpp"
#include "result/heat/temperature.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PatchSize;

namespace {

/// A field as a matrix: column j is the row of elements at y_j.
Eigen::Map<const Eigen::ArrayXXd> rows(const ContactGrid& grid, const double* values) {
  return {values, grid.nx, grid.ny};
}
Eigen::Map<Eigen::ArrayXXd> rows(const ContactGrid& grid, Field& field) {
  return {field.data(), grid.nx, grid.ny};
}

/// Relative to the creepage load: a hundredth of the error of so few elements.
constexpr double traction_tolerance = 1e-5;
/// Tolerance of Newton's linear systems; a looser one costs more steps than it saves.
constexpr double krylov_tolerance = 0.05;
/// Number of point loads along and across that represent the tractions of a patch acting on its
/// neighbours.
constexpr int loads_across = 5;

}  // namespace

QuickPatch::QuickPatch(const InfluenceTables& tables, const contact::CombinedMaterial& material)
    : tables_(tables),
      layer_(material.layer),
      peak_(material.contact_modulus),
      rolling_(tables.nx(), tables.ny(),
               (tables.nx() - 2 * margin + 3) * (tables.ny() - 2 * margin + 3)) {
  for (auto* list : {&place_, &climb_, &cosine_, &carried_, &of_lateral_})
    list->resize(tables.ny());
  for (Field* field : {&problem_.pressure, &traction_.x, &traction_.y, &change_.x, &change_.y})
    field->setZero(tables.nx() * tables.ny());
  loads_.reserve(loads_across * loads_across);
}

void QuickPatch::begin(const QuickContact& contact) {
  given_ = &contact;
  direction_ = upwards(contact.place);
  const bool follows = contact.geometry.surface.follows > 0.0;
  geometry_.emplace(contact.geometry, follows ? contact::Chart::arc : contact::Chart::plane);
  box = {2.0 * std::sqrt(2.0 * contact.place.rolling_radius * contact.approach),
         {grid_place(contact.reach[0]), grid_place(contact.reach[1])},
         0.0};
}

double QuickPatch::first_sinking() const {
  return given_->place.separation / direction_[1];
}

/// Coordinate of the grid at y of the patch frame.
double QuickPatch::grid_place(double y) const {
  double at = y;
  constexpr int steps = 6;
  for (int step = 0; geometry_->curved() && step < steps; ++step)
    at += (y - geometry_->lateral_place(at)) * contact::stretch_of(geometry_->climb(at));
  return at;
}

void QuickPatch::reach_to(double sinking) {
  const contact::PatchGeometry& profiles = *given_->geometry.surface.profiles;
  const double approach = (sinking - first_sinking()) * direction_[1];
  constexpr double step = 0.1, farthest = 15.0;  // mm
  const auto end = [&](double direction) {
    double y = 0.0;
    do y += direction * step;
    while (std::abs(y) < farthest && profiles.known(y) && profiles.distance(0.0, y) < approach);
    return grid_place(y);
  };
  box = {
      2.0 * std::sqrt(2.0 * given_->place.rolling_radius * approach), {end(-1.0), end(1.0)}, 0.0};
}

bool QuickPatch::lay_over_box() {
  const double width = box.y[1] - box.y[0], nx = tables_.nx(), ny = tables_.ny();
  if (!(box.length > 0.0 && width > 0.0)) return false;
  return place_grid(box.length / nx, width / ny, box.middle_along_x, 0.5 * (box.y[0] + box.y[1]));
}

bool QuickPatch::lay_on_patch() {
  const PatchSize patch = size_;
  const double dx = patch.length / (tables_.nx() - 2 * margin);
  const double dy = patch.width / (tables_.ny() - 2 * margin);
  if (!(dx > 0.0 && dy > 0.0)) return false;
  if (!place_grid(dx, dy, patch.x_middle(), patch.y_middle())) return false;
  geometry_->rigid_slip(given_->creepage, grid_, own_slip_);
  problem_.motion.rigid_slip = own_slip_;
  return true;
}

bool QuickPatch::place_grid(double dx, double dy, double x_middle, double y_middle) {
  if (!tables_.interpolate(dy / dx, table_)) return false;
  grid_ = ContactGrid::centred(tables_.nx(), tables_.ny(), dx, dy, x_middle, y_middle);
  geometry_->undeformed_distance(grid_, distance_);
  const auto [across, upwards] = direction_;
  for (int j = 0; j < grid_.ny; ++j) {
    place_[j] = geometry_->lateral_place(grid_.y(j));
    climb_[j] = geometry_->climb(grid_.y(j));
    cosine_[j] = 1.0 / contact::stretch_of(climb_[j]);
    carried_[j] = contact::carried_part(direction_, climb_[j]) * cosine_[j];
    of_lateral_[j] = (across + upwards * climb_[j]) * cosine_[j];
  }
  rows(grid_, distance_).rowwise() /= carried_.transpose();
  distance_.array() += first_sinking();
  own_distance_ = distance_;
  return true;
}

NormalBlock QuickPatch::block() const {
  return {&table_, grid_, carried_.data(), &given_->place};
}

void QuickPatch::set_forces(const double* forces) {
  rows(grid_, problem_.pressure) =
      (rows(grid_, forces).rowwise() / carried_.transpose()) / grid_.element_area();
}

/// True if no unloaded row lies between loaded ones.
bool QuickPatch::is_one_region() const {
  int changes = 0;
  bool inside = false;
  for (int j = 0; j < grid_.ny; ++j) {
    const bool loaded = rows(grid_, problem_.pressure.data()).col(j).maxCoeff() > 0.0;
    if (loaded != inside) ++changes;
    inside = loaded;
  }
  return changes == 2;
}

bool QuickPatch::solve_friction(const contact::Friction& friction, bool anew, bool keeps_weights) {
  static const contact::TangentialField none;
  if (!keeps_weights) contact::set_upwind_weights(grid_, problem_.pressure, runs_, weights_);
  if (!rolling_.set(table_, problem_.pressure, weights_, layer_ / grid_.dx)) return false;
  if (!friction) return true;
  contact::TangentialOptions options;
  options.tolerance = traction_tolerance;
  options.krylov_tolerance = krylov_tolerance;
  problem_.friction = friction;
  newton_.solve(rolling_, grid_, problem_, rolling_.grid_indices(), options,
                anew ? none : traction_);
  spread(newton_.traction(), traction_);
  return true;
}

/// Sets a field on the elements in contact, and zero elsewhere.
void QuickPatch::spread(const Eigen::Ref<const Eigen::VectorXd>& of_elements,
                        contact::TangentialField& field) const {
  field.x.setZero();
  field.y.setZero();
  const auto count = static_cast<Eigen::Index>(rolling_.grid_indices().size());
  for (Eigen::Index e = 0; e < count; ++e) {
    const Eigen::Index k = rolling_.grid_indices()[static_cast<std::size_t>(e)];
    field.x[k] = of_elements[e];
    field.y[k] = of_elements[count + e];
  }
}

bool QuickPatch::respond(SumsByCreepage& by_creepage) {
  const auto count = static_cast<Eigen::Index>(rolling_.grid_indices().size());
  slip_change_.resize(2 * count);
  traction_change_.resize(2 * count);
  for (Eigen::Index c = 0; c < 3; ++c) {
    contact::Creepage changed = given_->creepage;
    (c == 0 ? changed.longitudinal : c == 1 ? changed.lateral : changed.spin) += 1.0;
    // Slip is linear in the creepages.
    const contact::TangentialField slip = geometry_->rigid_slip(changed, grid_);
    for (Eigen::Index e = 0; e < count; ++e) {
      const Eigen::Index k = rolling_.grid_indices()[static_cast<std::size_t>(e)];
      slip_change_[e] = slip.x[k] - own_slip_.x[k];
      slip_change_[count + e] = slip.y[k] - own_slip_.y[k];
    }
    if (!newton_.respond(slip_change_, traction_change_)) return false;
    spread(traction_change_, change_);
    by_creepage.col(c) = sum(nullptr, change_);
  }
  return true;
}

void QuickPatch::forget_neighbours() {
  distance_ = own_distance_;
  problem_.motion.rigid_slip.x = own_slip_.x;
  problem_.motion.rigid_slip.y = own_slip_.y;
}

/// Lumps the neighbour's tractions into one point load per block of elements. Its pressure
/// displaces this patch in the joint problem, its friction here.
void QuickPatch::add_neighbour(const QuickPatch& neighbour,
                               const contact::CombinedMaterial& material) {
  const ContactGrid& there = neighbour.grid_;
  constexpr double blocks = loads_across;
  lump(there, neighbour.problem_.pressure, neighbour.traction_, there.nx / blocks,
       there.ny / blocks, loads_);
  for (contact::NeighbourLoad& load : loads_)
    place_beside(given_->place, neighbour.given_->place, load);
  add_slip(loads_, material, grid_, problem_.motion.rigid_slip);
  for (contact::NeighbourLoad& load : loads_) load.normal = 0.0;
  moved_.setZero(grid_.size());
  add_displacement(loads_, material, grid_, moved_);
  rows(grid_, distance_) += rows(grid_, moved_).rowwise() / carried_.transpose();
}

double QuickPatch::load_of_friction() const {
  const auto lateral = rows(grid_, traction_.y.data());
  return grid_.element_area() * (lateral.rowwise() * of_lateral_.transpose()).sum();
}

void QuickPatch::scale(double factor) {
  for (Field* field : {&problem_.pressure, &traction_.x, &traction_.y}) *field *= factor;
}

bool QuickPatch::reaches_only(bool (contact::PatchGeometry::*good)(double) const,
                              double elements) const {
  const contact::PatchGeometry& profiles = *given_->geometry.surface.profiles;
  const auto loaded = rows(grid_, problem_.pressure.data());
  for (int j = 0; j < grid_.ny; ++j)
    for (const double side : {-elements, elements})
      if (loaded.col(j).maxCoeff() > 0.0 && !(profiles.*good)(place_[j] + side * grid_.dy))
        return false;
  return true;
}

void QuickPatch::finish(const contact::Friction& friction, const double* gap,
                        const double* displacement, double sinking) {
  contact::ContactFields& fields = point_.fields;
  fields.traction.n = problem_.pressure;
  fields.traction.x = traction_.x;
  fields.traction.y = traction_.y;
  for (Field* field : {&fields.gap, &fields.displacement.n, &fields.traction_bound})
    field->setZero(problem_.pressure.size());
  rows(grid_, fields.gap) = rows(grid_, gap).rowwise() * carried_.transpose();
  rows(grid_, fields.displacement.n) = rows(grid_, displacement).rowwise() * carried_.transpose();
  if (friction)
    for (const Eigen::Index k : rolling_.grid_indices())
      fields.traction_bound[k] = friction->largest() * problem_.pressure[k];
  const PatchSums sums = this->sums();
  point_.creepage = given_->creepage;
  point_.longitudinal_force = sums[PatchSum::longitudinal];
  point_.lateral_force = sums[PatchSum::lateral];
  point_.lateral_pressure = sums[PatchSum::lateral_pressure];
  point_.normal_force = sums[PatchSum::normal];
  point_.spin_moment = sums[PatchSum::spin_moment];
  point_.creepage_work =  // per mm rolled, N
      -grid_.element_area() * (traction_.x.dot(own_slip_.x) + traction_.y.dot(own_slip_.y));
  point_.approach = sinking - first_sinking();
  const PeakPressure::Peak peak = peak_.of(*geometry_, grid_, problem_.pressure);
  point_.max_pressure = peak.pressure;
  point_.error_estimate["max_pressure"] = peak.bar;
  const PatchSize patch = measure();
  point_.contact_length = patch.length;
  point_.contact_width = patch.width;
  point_.contact_area = patch.area;
  const std::vector<char>& adheres = newton_.adheres();
  point_.adhesion_area =
      !friction ? 0.0
                : point_.contact_area *
                      static_cast<double>(std::count(adheres.begin(), adheres.end(), 1)) /
                      static_cast<double>(adheres.size());
  point_.converged = true;
}

void QuickPatch::warm(const contact::SurfaceHeat& heat) {
  contact::TangentialField& slip = point_.fields.slip;
  slip = change_ = own_slip_;
  slip_change_.resize(newton_.traction().size());
  spread(newton_.slip(), slip);
  rolling_.central_slip(table_, newton_.traction(), slip_change_);
  spread(slip_change_, change_);
  change_.x += problem_.motion.rigid_slip.x;
  change_.y += problem_.motion.rigid_slip.y;
  contact::set_works(grid_, change_, point_);
  contact::set_temperatures(grid_, heat, point_);
}

/// Resultants of pressure and tractions; without a pressure, of the tractions alone.
PatchSums QuickPatch::sum(const Field* pressure, const contact::TangentialField& traction) const {
  PatchSums sums = PatchSums::Zero();
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i) {
      const int k = grid_.index(i, j);
      const double pressed = pressure == nullptr ? 0.0 : (*pressure)[k];
      const double of_pressure = -climb_[j] * pressed * cosine_[j];
      const double across = traction.y[k] * cosine_[j] + of_pressure;
      sums[PatchSum::lateral_pressure] += of_pressure;
      sums[PatchSum::longitudinal] += traction.x[k];
      sums[PatchSum::lateral] += across;
      sums[PatchSum::normal] += (pressed + climb_[j] * traction.y[k]) * cosine_[j];
      sums[PatchSum::spin_moment] += grid_.x(i) * across - place_[j] * traction.x[k];
    }
  return grid_.element_area() * sums;
}

}  // namespace rollfem::halfspace
