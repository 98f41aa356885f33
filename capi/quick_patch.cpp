#include "capi/quick_patch.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "contact/result/validity.hpp"

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
/// Of Newton's linear systems, looser than which costs more steps than it saves.
constexpr double krylov_tolerance = 0.05;
/// Of the load: pressure and friction carry it together to this, then both are scaled to it.
constexpr double shared_to = 1e-6;
constexpr int most_turns = 12;
/// From this turn on the weights at the leading edge stay, which jump where an element comes into
/// contact: a share between the two sides is met by neither.
constexpr int turns_until_kept = 5;
/// A surface along the load carries next to nothing of it.
constexpr double least_carried = 0.05;

/// No row without pressure lies between others.
bool is_one_region(const ContactGrid& grid, const Field& pressure) {
  int changes = 0;
  bool inside = false;
  for (int j = 0; j < grid.ny; ++j) {
    const bool loaded = pressure.segment(grid.index(0, j), grid.nx).maxCoeff() > 0.0;
    if (loaded != inside) ++changes;
    inside = loaded;
  }
  return changes == 2;
}

}  // namespace

QuickPatch::QuickPatch(const halfspace::InfluenceTables& tables, int across)
    : tables_(tables), across_(across), rolling_(tables.n(), (across + 3) * (across + 3)) {
  const int n = tables.n();
  for (auto* list : {&place_, &climb_, &cosine_, &of_lateral_})
    list->resize(static_cast<std::size_t>(n));
  for (Field* field : {&carried_, &pressure_, &traction_.x, &traction_.y}) field->setZero(n * n);
}

/// Sets the pressure that carries `force` along the load, from what it is or, with `anew`, from
/// none. `distance`: over the part of the pressure along the load.
void QuickPatch::press(const Field& distance, double force, double tolerance, bool anew) {
  static const Field none;
  contact::NormalOptions options;
  options.tolerance = tolerance;
  normal_.solve_sum(halfspace::FewElementsNormal{*table_, grid_.dx, carried_}, distance,
                    force / grid_.element_area(), options, anew ? none : normal_.pressure());
  pressure_ = normal_.pressure().cwiseQuotient(carried_);
}

/// Sets the tractions under the pressure, from what they are or, with `anew`, from adhesion all
/// over. False when there are too many elements.
bool QuickPatch::rub(const QuickProblem& problem, const Field& weights,
                     const contact::TangentialField& slip, bool anew) {
  static const contact::TangentialField none;
  if (!rolling_.set(*table_, pressure_, weights)) return false;
  if (!problem.friction) return true;
  contact::TangentialOptions options;
  options.tolerance = traction_tolerance;
  options.krylov_tolerance = krylov_tolerance;
  newton_.solve(rolling_, {grid_, pressure_, slip, *problem.friction, 1.0}, rolling_.grid_indices(),
                options, anew ? none : traction_);
  traction_.x.setZero();
  traction_.y.setZero();
  const auto count = static_cast<Eigen::Index>(rolling_.grid_indices().size());
  for (Eigen::Index e = 0; e < count; ++e) {
    const Eigen::Index k = rolling_.grid_indices()[static_cast<std::size_t>(e)];
    traction_.x[k] = newton_.traction()[e];
    traction_.y[k] = newton_.traction()[count + e];
  }
  return true;
}

/// Extents of the patch without friction, by few elements over the overlap of the bodies.
std::optional<PatchSize> QuickPatch::find_patch(const QuickProblem& problem) {
  const int n = tables_.n();
  const ChartedGeometry geometry(problem.geometry, contact::Chart::plane);
  double half = std::sqrt(2.0 * problem.contact.place.rolling_radius * problem.contact.approach);
  std::array<double, 2> y = problem.contact.reach;
  carried_.setOnes();
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round) {
    const double width = y[1] - y[0];
    if (!(half > 0.0 && width > 0.0)) return {};
    table_ = tables_.nearest(0.5 * width / half);
    if (table_ == nullptr) return {};
    const double dx = std::max(2.0 * half, width / table_->ratio) / n;
    grid_ = ContactGrid::centred(n, n, dx, table_->ratio * dx, 0.0, 0.5 * (y[0] + y[1]));
    const Field distance = geometry.undeformed_distance(grid_);
    press(distance, problem.force / problem.direction[1], search_tolerance, true);
    if (!contact::touches_border(grid_, pressure_)) {
      if (across_ < most_across && !is_one_region(grid_, pressure_)) return {};
      return contact::patch_size(grid_, pressure_);
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
           traction_.y.segment(grid_.index(0, j), grid_.nx).sum();
  return sum * grid_.element_area();
}

/// Pressure and friction in turn until they carry the load together.
bool QuickPatch::share_load(const QuickProblem& problem, const Field& distance,
                            const contact::TangentialField& slip) {
  double share = problem.force;
  contact::PositiveFixedPoint sharing;
  Field weights;
  for (int turn = 0; turn < most_turns; ++turn) {
    press(distance, share, pressure_tolerance, turn == 0);
    if (turn < turns_until_kept) weights = contact::upwind_weights(grid_, pressure_);
    if (!rub(problem, weights, slip, turn == 0)) return false;
    const double image = problem.force - load_of_friction();
    if (std::abs(image - share) <= shared_to * problem.force) {
      const double carried = share + problem.force - image;
      for (Field* field : {&pressure_, &traction_.x, &traction_.y})
        *field *= problem.force / carried;
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
    carried_.segment(grid_.index(0, j), grid_.nx)
        .setConstant(std::max(upwards - across * climb_[k], least_carried) * cosine_[k]);
    of_lateral_[k] = (across + upwards * climb_[k]) * cosine_[k];
  }
  Field distance = geometry.undeformed_distance(grid_);
  distance = distance.cwiseQuotient(carried_);
  return share_load(problem, distance, geometry.rigid_slip(problem.creepage, grid_)) &&
         is_held(problem);
}

/// By the profiles and the limits of the contact.
bool QuickPatch::is_held(const QuickProblem& problem) const {
  const contact::PatchGeometry& profiles = *problem.geometry.surface.profiles;
  for (int j = 0; j < grid_.ny; ++j) {
    if (!(pressure_.segment(grid_.index(0, j), grid_.nx).maxCoeff() > 0.0)) continue;
    for (const double side : {-1.0, 1.0}) {
      const double y = place_[static_cast<std::size_t>(j)] + side * grid_.dy;
      if (!profiles.within_limits(y) || !profiles.known(y)) return false;
    }
  }
  return true;
}

/// What check_point looks at and what the sums are of.
void QuickPatch::fill_fields(const QuickProblem& problem) {
  contact::ContactFields& fields = point_.fields;
  fields.traction.n = pressure_;
  fields.traction.x = traction_.x;
  fields.traction.y = traction_.y;
  fields.gap = normal_.gap().cwiseProduct(carried_);
  fields.displacement.n = normal_.displacement().cwiseProduct(carried_);
  fields.traction_bound.setZero(pressure_.size());
  if (!problem.friction) return;
  for (const Eigen::Index k : rolling_.grid_indices())
    fields.traction_bound[k] = problem.friction->bound(pressure_[k], 0.0).value;
}

void QuickPatch::fill_sums(const QuickProblem& problem) {
  double longitudinal = 0.0, lateral = 0.0, normal = 0.0, spin_moment = 0.0, pressed = 0.0;
  for (int j = 0; j < grid_.ny; ++j) {
    const auto row = static_cast<std::size_t>(j);
    for (int i = 0; i < grid_.nx; ++i) {
      const int k = grid_.index(i, j);
      const double of_pressure = -climb_[row] * pressure_[k] * cosine_[row];
      const double across = traction_.y[k] * cosine_[row] + of_pressure;
      pressed += of_pressure;
      longitudinal += traction_.x[k];
      lateral += across;
      normal += (pressure_[k] + climb_[row] * traction_.y[k]) * cosine_[row];
      spin_moment += grid_.x(i) * across - place_[row] * traction_.x[k];
    }
  }
  const double area = grid_.element_area();
  point_.creepage = problem.creepage;
  point_.longitudinal_force = area * longitudinal;
  point_.lateral_force = area * lateral;
  point_.lateral_pressure = area * pressed;
  point_.normal_force = area * normal;
  point_.spin_moment = area * spin_moment;
  point_.max_pressure = pressure_.maxCoeff();
  point_.approach = normal_.approach();
  const PatchSize size = contact::patch_size(grid_, pressure_);
  point_.contact_length = size.length;
  point_.contact_width = size.width;
  point_.contact_area = size.area;
  const std::vector<char>& adheres = newton_.adheres();
  point_.adhesion_area =
      !problem.friction
          ? 0.0
          : size.area * static_cast<double>(std::count(adheres.begin(), adheres.end(), 1)) /
                static_cast<double>(adheres.size());
  point_.converged = true;
}

const contact::PointResult* QuickPatch::solve(const QuickProblem& problem) {
  try {
    if (!solve_or_throw(problem)) return nullptr;
    contact::NormalLoad load;
    load.force = problem.force;
    load.direction = problem.direction;
    contact::check_point({grid_, point_, load});
    return &point_;
  } catch (const contact::SolveError&) {
    return nullptr;
  }
}

bool QuickPatch::solve_or_throw(const QuickProblem& problem) {
  const std::optional<PatchSize> patch = find_patch(problem);
  if (!patch || !(patch->length > 0.0 && patch->width > 0.0)) return false;
  table_ = tables_.nearest(patch->width / patch->length);
  if (table_ == nullptr) return false;
  // The ratio of the ladder shares its difference between both directions.
  const double dx =
      std::sqrt(patch->length * patch->width / table_->ratio) / static_cast<double>(across_);
  grid_ = ContactGrid::centred(tables_.n(), tables_.n(), dx, table_->ratio * dx,
                               0.5 * (patch->x_lower + patch->x_upper),
                               0.5 * (patch->y_lower + patch->y_upper));
  const auto chart = problem.follows > 0.0 ? contact::Chart::arc : contact::Chart::plane;
  if (!solve_on(problem, ChartedGeometry(problem.geometry, chart))) return false;
  fill_fields(problem);
  fill_sums(problem);
  return true;
}

}  // namespace rollfem::capi
