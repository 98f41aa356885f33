#include "capi/quick_patch.hpp"

#include "capi/patch_solution.hpp"
#include "contact/base/fixed_point.hpp"
#include "contact/solve/leading_edge.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::capi {

using contact::ChartedGeometry;
using contact::ContactGrid;
using contact::Field;
using contact::PatchSize;

namespace {

/// Of the approach, for the extents of the patch and for its pressure.
constexpr double search_tolerance = 1e-3;
constexpr double pressure_tolerance = 1e-5;
/// Of the creepage load: a hundredth of what so few elements are off.
constexpr double traction_tolerance = 1e-5;
/// Of the load: pressure and friction carry it together to this, then both are scaled to it.
constexpr double shared_to = 1e-6;
constexpr int most_turns = 12;
/// From this turn on the weights at the leading edge stay, which jump where an element comes into
/// contact: a share between the two sides is met by neither.
constexpr int turns_until_kept = 5;
/// A surface along the load carries next to nothing of it.
constexpr double least_carried = 0.05;

}  // namespace

QuickPatch::QuickPatch(const InfluenceTables& tables, int across)
    : tables_(tables),
      across_(across),
      pressure_(tables.n()),
      tractions_(tables.n(), (across + 3) * (across + 3)) {
  for (auto* list : {&place_, &climb_, &cosine_, &carried_, &of_lateral_})
    list->resize(static_cast<std::size_t>(tables.n()));
}

/// Extents of the patch without friction, by few elements over the overlap of the bodies.
std::optional<PatchSize> QuickPatch::find_patch(const QuickProblem& problem) {
  const int n = tables_.n();
  const ChartedGeometry geometry(problem.geometry, contact::Chart::plane);
  double half = std::sqrt(2.0 * problem.contact.place.rolling_radius * problem.contact.approach);
  std::array<double, 2> y = problem.contact.reach;
  std::fill(carried_.begin(), carried_.end(), 1.0);
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round) {
    const double width = y[1] - y[0];
    if (!(half > 0.0 && width > 0.0)) return {};
    table_ = tables_.nearest(0.5 * width / half);
    if (table_ == nullptr) return {};
    const double dx = std::max(2.0 * half, width / table_->ratio) / n;
    grid_ = ContactGrid::centred(n, n, dx, table_->ratio * dx, 0.0, 0.5 * (y[0] + y[1]));
    const Field distance = geometry.undeformed_distance(grid_);
    if (!pressure_.solve({*table_, grid_, distance, carried_, problem.force / problem.direction[1],
                          search_tolerance},
                         true))
      return {};
    if (!contact::touches_border(grid_, pressure_.pressure())) {
      if (!is_one_region(grid_, pressure_.pressure())) return {};
      return contact::patch_size(grid_, pressure_.pressure());
    }
    half *= 1.3;
    y = {y[0] - 0.15 * width, y[1] + 0.15 * width};
  }
  return {};
}

/// What the lateral tractions carry of the load.
double QuickPatch::load_of_friction() const {
  double sum = 0.0;
  for (int j = 0; j < grid_.ny; ++j)
    sum += of_lateral_[static_cast<std::size_t>(j)] *
           tractions_.traction().y.segment(grid_.index(0, j), grid_.nx).sum();
  return sum * grid_.element_area();
}

/// Pressure and friction in turn until they carry the load together.
bool QuickPatch::share_load(const QuickProblem& problem, const Field& distance,
                            const contact::TangentialField& slip) {
  double share = problem.force;
  contact::PositiveFixedPoint sharing;
  Field weights;
  for (int turn = 0; turn < most_turns; ++turn) {
    if (!pressure_.solve({*table_, grid_, distance, carried_, share, pressure_tolerance},
                         turn == 0))
      return false;
    if (turn < turns_until_kept) weights = contact::upwind_weights(grid_, pressure_.pressure());
    if (!tractions_.solve({*table_, grid_, pressure_.pressure(), weights, slip, problem.friction,
                           traction_tolerance},
                          turn == 0))
      return false;
    const double image = problem.force - load_of_friction();
    if (std::abs(image - share) <= shared_to * problem.force) {
      const double carried = share + problem.force - image;
      pressure_.scale(problem.force / carried);
      tractions_.scale(problem.force / carried);
      return true;
    }
    share = sharing.next(share, image);
  }
  return false;
}

bool QuickPatch::solve_on(const QuickProblem& problem, const ChartedGeometry& geometry) {
  const auto [across, upwards] = problem.direction;
  for (int j = 0; j < grid_.ny; ++j) {
    const auto k = static_cast<std::size_t>(j);
    place_[k] = geometry.lateral_place(grid_.y(j));
    climb_[k] = geometry.climb(grid_.y(j));
    cosine_[k] = 1.0 / std::sqrt(1.0 + climb_[k] * climb_[k]);
    carried_[k] = std::max(upwards - across * climb_[k], least_carried) * cosine_[k];
    of_lateral_[k] = (across + upwards * climb_[k]) * cosine_[k];
  }
  return share_load(problem, geometry.undeformed_distance(grid_),
                    geometry.rigid_slip(problem.creepage, grid_)) &&
         is_held(problem);
}

/// By the grid, the profiles, and the limits of the contact.
bool QuickPatch::is_held(const QuickProblem& problem) const {
  const Field& pressure = pressure_.pressure();
  if (!pressure.allFinite() || contact::touches_border(grid_, pressure)) return false;
  const contact::PatchGeometry& profiles = *problem.geometry.surface.profiles;
  for (int j = 0; j < grid_.ny; ++j) {
    if (!(pressure.segment(grid_.index(0, j), grid_.nx).maxCoeff() > 0.0)) continue;
    for (const double side : {-1.0, 1.0}) {
      const double y = place_[static_cast<std::size_t>(j)] + side * grid_.dy;
      if (!profiles.within_limits(y) || !profiles.known(y)) return false;
    }
  }
  return true;
}

PatchForces QuickPatch::forces(const QuickProblem& problem) const {
  PatchForces found;
  found.creepage = problem.creepage;
  const Field& pressure = pressure_.pressure();
  const contact::TangentialField& traction = tractions_.traction();
  for (int j = 0; j < grid_.ny; ++j) {
    const auto row = static_cast<std::size_t>(j);
    for (int i = 0; i < grid_.nx; ++i) {
      const int k = grid_.index(i, j);
      const double across = (traction.y[k] - climb_[row] * pressure[k]) * cosine_[row];
      found.longitudinal_force += traction.x[k];
      found.lateral_force += across;
      found.normal_force += (pressure[k] + climb_[row] * traction.y[k]) * cosine_[row];
      found.spin_moment += grid_.x(i) * across - place_[row] * traction.x[k];
    }
  }
  for (double* sum :
       {&found.longitudinal_force, &found.lateral_force, &found.normal_force, &found.spin_moment})
    *sum *= grid_.element_area();
  const PatchSize size = contact::patch_size(grid_, pressure);
  found.length = size.length;
  found.width = size.width;
  found.area = size.area;
  found.adhesion_area = size.area * tractions_.adhering() / tractions_.elements();
  found.max_pressure = pressure.maxCoeff();
  return found;
}

std::optional<PatchForces> QuickPatch::solve(const QuickProblem& problem) {
  const std::optional<PatchSize> patch = find_patch(problem);
  if (!patch || !(patch->length > 0.0 && patch->width > 0.0)) return {};
  table_ = tables_.nearest(patch->width / patch->length);
  if (table_ == nullptr) return {};
  // The ratio of the ladder shares its difference between both directions.
  const double dx =
      std::sqrt(patch->length * patch->width / table_->ratio) / static_cast<double>(across_);
  grid_ = ContactGrid::centred(tables_.n(), tables_.n(), dx, table_->ratio * dx,
                               0.5 * (patch->x_lower + patch->x_upper),
                               0.5 * (patch->y_lower + patch->y_upper));
  const auto chart = problem.follows > 0.0 ? contact::Chart::arc : contact::Chart::plane;
  if (!solve_on(problem, ChartedGeometry(problem.geometry, chart))) return {};
  return forces(problem);
}

}  // namespace rollfem::capi
