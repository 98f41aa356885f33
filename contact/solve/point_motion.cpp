// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/point_motion.hpp"

#include "base/errors.hpp"
#include "contact/iteration/interpolation.hpp"
#include "scene/step_past.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace rollfem::contact {

using Eigen::Vector2d;

Friction friction_on(const Scene& scene, const ChartedGeometry& geometry) {
  const Friction friction = scene.friction();
  if (!friction || !friction->varies() || !geometry.curved()) return friction;
  const auto on_arc =
      std::make_shared<VaryingFriction>(friction, [friction, &geometry](double grid_y) {
        return friction->of_row(geometry.lateral_place(grid_y));
      });
  on_arc->plasticity = friction->plasticity;
  on_arc->branch = friction->branch;
  return on_arc;
}

namespace {

/// Flows on the elements of a grid, linear between those along x that an earlier step has left.
Field flows_on(const ContactGrid& grid, const PastPatches& patches, Field PastPatch::*flows) {
  Field found = Field::Zero(grid.size());
  for (const PastPatch& patch : patches) {
    const ContactGrid& from = patch.grid;
    const auto rows = static_cast<int>(std::lround((grid.y_first - from.y_first) / grid.dy));
    const double columns = (grid.x_first - from.x_first) / grid.dx, whole = std::floor(columns);
    for (int j = std::max(0, -rows); j < std::min(grid.ny, from.ny - rows); ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const auto at = [&, column = i + static_cast<int>(whole)](int more) {
          const int c = column + more;
          return c < 0 || c >= from.nx ? 0.0 : (patch.*flows)[from.index(c, j + rows)];
        };
        found[grid.index(i, j)] += (1.0 - columns + whole) * at(0) + (columns - whole) * at(1);
      }
  }
  return found;
}

}  // namespace

PointMotion::PointMotion(const Scene& scene, const ChartedGeometry& geometry,
                         const ContactGrid& grid, const std::optional<History>& inherited)
    : scene_(scene),
      geometry_(geometry),
      grid_(grid),
      history_(inherited.value_or(History(grid, scene.upwind_order))) {
  if (scene.past) {
    const auto& [along, across, turn] = scene.past->shift;
    sum_ = {along, across, turn, scene.past->distance};
    steps_before_ = scene.past->steps;
  }
  const Friction& law = scene.friction();
  if (scene.heat) {
    if (scene.past)
      for (const PastHeat& step : scene.past->levels.front().heat)
        heat_.push_back({step.length, flows_on(grid, step.patches, &PastPatch::heat_wheel),
                         flows_on(grid, step.patches, &PastPatch::heat_rail)});
    left_temperature_ =
        left_temperature(grid, *scene.heat, scene.points.front().step_length, heat_);
  }
  if (!scene.is_history() || !law || !(law->memory() || law->plasticity || law->by_temperature()))
    return;
  friction_ = friction_on(scene, geometry);
  if (inherited) return;
  const Field none = Field::Zero(grid.size());
  history_.advance({none, none}, 0.0, friction_after(friction_, grid));
}

FrictionPast friction_after(const Friction& friction, const ContactGrid& grid,
                            const ContactState& state) {
  FrictionPast after{coefficients_of(friction, grid), 0.0, Field::Zero(grid.size())};
  const TangentialSolution& last = state.tangential;
  if (last.coefficient.size() != 0) after.coefficient = last.coefficient;
  if (last.plastic.size() != 0) after.plastic = last.plastic;
  return after;
}

Vector2d PointMotion::given_unknowns(std::size_t k) const {
  const LoadPoint& point = scene_.points[k];
  if (scene_.problem == Problem::shift) return {point.longitudinal_shift, point.lateral_shift};
  return {point.creepage.longitudinal, point.creepage.lateral};
}

TangentialField PointMotion::rigid_slip(const Creepage& creepage, double step) const {
  TangentialField slip = geometry_.rigid_slip(creepage, grid_);
  slip.y.array() += creepage.spin * upstream_of_spin(scene_.upwind_order, step);
  if (extra_.x.size() != 0) {
    slip.x += extra_.x;
    slip.y += extra_.y;
  }
  return slip;
}

TangentialMotion PointMotion::at(std::size_t k, const Vector2d& unknowns) const {
  const LoadPoint& point = scene_.points[k];
  if (scene_.problem == Problem::shift) {
    TangentialMotion motion =
        history_.shift_step(uniform_slip({unknowns.x(), unknowns.y(), point.spin_shift}, grid_));
    if (friction_) motion.past = history_.past(0.0);
    return motion;
  }
  const bool steps = scene_.problem_of(k) == Problem::transient;
  const TangentialField slip = rigid_slip({unknowns.x(), unknowns.y(), point.creepage.spin},
                                          steps ? point.step_length : grid_.dx);
  if (!steps) return {slip};
  TangentialMotion motion = history_.rolling_step(slip, point.step_length);
  if (friction_) motion.past = history_.past(point.step_length);
  if (motion.past) motion.past->temperature = left_temperature_;
  return motion;
}

void PointMotion::describe(std::size_t k, const Vector2d& unknowns, PointResult& point) {
  const LoadPoint& given = scene_.points[k];
  point.creepage = given.creepage;
  if (scene_.problem == Problem::shift) {
    sum_.longitudinal += unknowns.x();
    sum_.lateral += unknowns.y();
    sum_.spin += given.spin_shift;
  } else {
    point.creepage.longitudinal = unknowns.x();
    point.creepage.lateral = unknowns.y();
  }
  if (!scene_.is_history()) return;
  point.step = steps_before_ + static_cast<int>(k) + 1;
  if (scene_.problem_of(k) == Problem::transient) sum_.distance += given.step_length;
  point.longitudinal_shift = sum_.longitudinal;
  point.lateral_shift = sum_.lateral;
  point.spin_shift = sum_.spin;
  point.distance = sum_.distance;
}

void PointMotion::warm(std::size_t k, PointResult& point) {
  if (!scene_.heat || scene_.problem != Problem::transient) return;
  const bool steady = scene_.problem_of(k) == Problem::steady;
  const double length = steady ? infinity : scene_.points[k].step_length;
  heat_.insert(heat_.begin(), set_temperatures(grid_, *scene_.heat, length, heat_, point));
  const double next = scene_.points[std::min(k + 1, scene_.points.size() - 1)].step_length;
  left_temperature_ = contact::left_temperature(grid_, *scene_.heat, next, heat_);
  keep_within(grid_.nx * grid_.dx, heat_);
}

void PointMotion::advance(std::size_t k, const ContactState& state) {
  if (!scene_.is_history()) return;
  // Steady rolling is as if the next step had been made before, with the same displacements.
  const bool steady = scene_.problem_of(k) == Problem::steady;
  const std::size_t like = steady ? std::min(k + 1, scene_.points.size() - 1) : k;
  const bool rolls = scene_.problem == Problem::transient;
  for (int times = steady ? 2 : 1; times > 0; --times)
    history_.advance({state.displacement.x, state.displacement.y},
                     rolls ? scene_.points[like].step_length : 0.0,
                     friction_ ? friction_after(friction_, grid_, state) : FrictionPast());
}

void PointMotion::restore(const PointResult& point) {
  sum_ = {point.longitudinal_shift, point.lateral_shift, point.spin_shift, point.distance};
}

namespace {

TangentialField zeros(const ContactGrid& grid) {
  return {Field::Zero(grid.size()), Field::Zero(grid.size())};
}

/// Curved streamlines strain the material while it rolls; the problem of the step is in mm.
TangentialMotion step(TangentialField rigid_slip, double slip_factor) {
  return {std::move(rigid_slip), Motion::shift, slip_factor, 1.0 / slip_factor};
}

}  // namespace

Field upstream(const ContactGrid& grid, const Field& values, double distance) {
  // Beyond the grid the border values continue, regardless of the size of a step.
  const double elements = std::min(distance / grid.dx, grid.nx + 2.0);
  // Keeps an integer number of elements exact.
  const double nearest = std::round(elements);
  const bool whole = std::abs(elements - nearest) < 1e-9 * std::max(1.0, nearest);
  const int ahead = static_cast<int>(whole ? nearest : std::floor(elements));
  const auto weights =
      lagrange_weights(std::array<double, 4>{-1.0, 0.0, 1.0, 2.0}, whole ? 0.0 : elements - ahead);
  Field result(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k)
        sum += weights[static_cast<std::size_t>(k)] *
               values[grid.index(std::clamp(i + ahead + k - 1, 0, grid.nx - 1), j)];
      result[grid.index(i, j)] = sum;
    }
  return result;
}

History::History(const ContactGrid& grid, UpwindOrder order)
    : grid_(grid), order_(order), last_(zeros(grid)), before_last_(zeros(grid)) {}

TangentialMotion History::shift_step(const TangentialField& rigid_shift) const {
  return {{rigid_shift.x - last_.x, rigid_shift.y - last_.y}, Motion::shift, 1.0, 0.0};
}

TangentialMotion History::rolling_step(const TangentialField& rigid_slip,
                                       double step_length) const {
  if (!(step_length > 0.0))
    throw InputError(
        fmt::format("transient rolling: a step of {} mm; allowed: above 0", step_length));
  const double way = arrived_ ? 0.0 : step_length;
  const TangentialField one{upstream(grid_, last_.x, way), upstream(grid_, last_.y, way)};
  const auto equals = [&](double other) {
    return std::abs(step_length - other) <= 1e-9 * step_length;
  };
  const bool equal_steps = equals(last_step_) && equals(before_last_step_);
  if (order_ == UpwindOrder::first || !equal_steps)
    return step({step_length * rigid_slip.x - one.x, step_length * rigid_slip.y - one.y},
                1.0 / step_length);
  // (3 u - 4 u' + u'')/2 + step s = 3/2 (u + (2 step s - 4 u' + u'')/3)
  const TangentialField two{upstream(grid_, before_last_.x, 2.0 * way),
                            upstream(grid_, before_last_.y, 2.0 * way)};
  return step({(2.0 * step_length * rigid_slip.x - 4.0 * one.x + two.x) / 3.0,
               (2.0 * step_length * rigid_slip.y - 4.0 * one.y + two.y) / 3.0},
              1.5 / step_length);
}

void History::advance(const TangentialField& displacement, double step_length, FrictionPast after) {
  arrived_ = false;
  before_last_ = last_;
  last_ = displacement;
  before_last_step_ = last_step_;
  last_step_ = step_length;
  after_ = std::move(after);
}

void History::inherit(TangentialField last, TangentialField before_last,
                      std::array<double, 2> lengths, FrictionPast after) {
  last_ = std::move(last);
  before_last_ = std::move(before_last);
  last_step_ = lengths[0];
  before_last_step_ = lengths[1];
  after_ = std::move(after);
  arrived_ = true;
}

/// Linear between elements: a cubic could leave the values between which mu lies.
FrictionPast History::past(double step_length) const {
  if (step_length == 0.0) return {after_.coefficient, 1.0, after_.plastic};
  if (arrived_) return {after_.coefficient, step_length, after_.plastic};
  const double elements = std::min(step_length / grid_.dx, grid_.nx + 2.0);
  const int ahead = static_cast<int>(elements);
  const double part = elements - ahead;
  FrictionPast past{Field(grid_.size()), step_length, Field(grid_.size())};
  for (int j = 0; j < grid_.ny; ++j)
    for (int i = 0; i < grid_.nx; ++i) {
      const auto at = [&](const Field& values) {
        const int column = std::min(i + ahead, grid_.nx - 1);
        const int next = std::min(i + ahead + 1, grid_.nx - 1);
        return (1.0 - part) * values[grid_.index(column, j)] + part * values[grid_.index(next, j)];
      };
      past.coefficient[grid_.index(i, j)] = at(after_.coefficient);
      past.plastic[grid_.index(i, j)] = at(after_.plastic);
    }
  return past;
}

}  // namespace rollfem::contact
