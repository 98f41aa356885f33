// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/friction_newton.hpp"

#include "contact/base/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

namespace rollfem::contact {

namespace {

/// The full-stick solution is only a start, but errors of its tractions from row to row misplace
/// the border of adhesion in individual rows: a tolerance of 1e-2 took up to 50 Newton steps, this
/// one takes 7.
constexpr double full_stick_tolerance = 1e-3;

/// Drag (times r): value at the first attempt, value below which it is dropped, and value at which
/// the solver gives up.
constexpr double first_drag = 0.3;
constexpr double least_drag = 3e-3;
constexpr double largest_drag = 100.0;

/// Tolerance of problems with drag, which only provide a better start; relative to the creepage
/// load.
constexpr double drag_tolerance = 1e-3;
constexpr int patience_with_drag = 25;

void enlarge(Eigen::VectorXd& values, Eigen::Index n) {
  if (values.size() < n) values.resize(n);
}

}  // namespace

FrictionEffort FrictionNewton::solve(ElementOperator& compliance, const FrictionProblem& problem,
                                     const std::vector<Index>& places,
                                     const TangentialOptions& options,
                                     const TangentialField& start) {
  compliance_ = &compliance;
  problem_ = &problem;
  places_ = &places;
  options_ = &options;
  r_ = 1.0 / compliance.diagonal();
  state_.begin(problem, places, r_);
  feels_slip_ = state_.feels_slip();
  drag_ = 0.0;
  bound_relaxation_ = 1.0;
  effort_ = {};
  preconditioner_failed_ = false;
  lay_out(static_cast<Index>(places.size()));
  state_.set_rest(bound_);
  gather(problem.motion.rigid_slip, rigid_slip_);
  const double creepage_load = r_ * rigid_slip_.norm();
  if (count_ == 0 || creepage_load == 0.0) {
    evaluate_at_rest(*point_);
  } else {
    find_first_point(start);
    if (feels_slip_) first_ = point_->traction;
    fronts_.begin(problem.grid, places);
    // Relative to the creepage load, or to the bound if that is smaller, so that a low friction
    // coefficient does not simulate convergence.
    const double scale = std::min(creepage_load, bound_.norm());
    if (feels_slip_) effort_.steepness = state_.steepness(compliance.diagonal());
    const bool direct = !falls_steeply() && iterate(scale, options.tolerance);
    if (!direct && !(feels_slip_ && follow_bounds(scale))) fail(scale);
    // The tolerance applies to all elements together: a single one may exceed its bound by more.
    project(point_->traction, point_->bound);
    evaluate_from_traction(*point_);
  }
  linearise(*point_);
  return effort_;
}

void FrictionNewton::lay_out(Index count) {
  count_ = count;
  Point &one = points_[0], &other = points_[1];
  const std::array<Vector*, 14> pairs{&rigid_slip_, &dragged_from_, &direction_,     &slip_change_,
                                      &right_,      &trial_change_, &one.traction,   &one.slip,
                                      &one.value,   &one.trial,     &other.traction, &other.slip,
                                      &other.value, &other.trial};
  const std::array<Vector*, 4> bounds{&bound_, &bound_change_, &one.bound, &other.bound};
  enlarge(memory_, static_cast<Index>(2 * pairs.size() + bounds.size()) * count);
  double* next = memory_.data();
  const auto place = [&](Vector* vector, Index size) {
    new (vector) Vector(next, size);
    next += size;
  };
  for (Vector* vector : pairs) place(vector, 2 * count);
  for (Vector* vector : bounds) place(vector, count);
  if (!feels_slip_)
    for (Point& point : points_) new (&point.bound) Vector(bound_.data(), count);
  for (Eigen::VectorXd* vector : {&at_.normal, &at_.left}) enlarge(*vector, 2 * count);
  enlarge(at_.factor, count);
}

void FrictionNewton::gather(const TangentialField& field, Vector& values) const {
  for (Index e = 0; e < count_; ++e) {
    const Index k = (*places_)[static_cast<std::size_t>(e)];
    values[e] = field.x[k];
    values[count_ + e] = field.y[k];
  }
}

/// True when the residual is down to the tolerance.
bool FrictionNewton::iterate(double scale, double tolerance) {
  double previous = infinity;
  int with_this_drag = 0;
  const int taken = effort_.newton_steps;
  for (int step = 0; step <= options_->max_newton_steps; ++step) {
    const double residual = point_->norm / scale;
    effort_.newton_steps = taken + step;
    effort_.residual = residual;
    if (drag_ == 0.0 && residual <= tolerance) return true;
    if (step == options_->max_newton_steps || drag_ > largest_drag / r_) break;
    const bool settled = drag_ > 0.0 && residual <= drag_tolerance;
    const int patience = drag_ > 0.0 ? patience_with_drag : options_->patience;
    if (!settled && ++with_this_drag <= patience && advance(residual, previous)) {
      previous = residual;
      continue;
    }
    set_drag(settled ? 0.25 * drag_ : std::max(4.0 * drag_, first_drag / r_));
    previous = infinity;
    with_this_drag = 0;
  }
  return false;
}

void FrictionNewton::project(Vector& traction, const Vector& bound) const {
  for (Index e = 0; e < count_; ++e) {
    const double size = std::hypot(traction[e], traction[count_ + e]);
    if (size <= bound[e]) continue;
    traction[e] *= bound[e] / size;
    traction[count_ + e] *= bound[e] / size;
  }
}

/// Continues from the point with this drag, or without drag if it is small.
void FrictionNewton::set_drag(double drag) {
  drag_ = r_ * drag < least_drag ? 0.0 : drag;
  dragged_from_ = point_->traction;
  fronts_.forget();
  evaluate(*point_);
}

/// From the traction and slip of a point.
void FrictionNewton::evaluate(Point& point) {
  point.trial = point.traction - r_ * point.slip;
  if (drag_ > 0.0) point.trial -= r_ * drag_ * (point.traction - dragged_from_);
  if (feels_slip()) state_.set_bound(point.slip, point.trial, point.bound);
  if (feels_slip() && bound_relaxation_ < 1.0)
    point.bound = lagged_bound_ + bound_relaxation_ * (point.bound - lagged_bound_);
  point.value = point.trial;
  project(point.value, point.bound);
  point.value = point.traction - point.value;
  point.norm = point.value.norm();
}

void FrictionNewton::evaluate_from_traction(Point& point) {
  compliance_->apply(point.traction, point.slip);
  point.slip += rigid_slip_;
  evaluate(point);
}

void FrictionNewton::evaluate_at_rest(Point& point) {
  point.traction.setZero();
  point.slip = rigid_slip_;
  evaluate(point);
}

/// The projected full-stick solution or the caller's start, whichever has the smaller residual.
void FrictionNewton::find_first_point(const TangentialField& start) {
  const Index size = problem_->pressure.size();
  if (start.x.size() != size || start.y.size() != size) {
    stick_fully(*point_);
    return;
  }
  gather(start, point_->traction);
  project(point_->traction, bound_);
  evaluate_from_traction(*point_);
  evaluate_at_rest(*trial_);
  if (point_->norm < 0.1 * trial_->norm) return;
  stick_fully(*trial_);
  if (!(point_->norm < trial_->norm)) std::swap(point_, trial_);
}

void FrictionNewton::stick_fully(Point& point) {
  at_.adheres.assign(static_cast<std::size_t>(count_), 1);
  compliance_->linearise(at_, r_, 0.0);
  right_ = -r_ * rigid_slip_;
  const auto matrix = [this](const Gmres::Given& p, Gmres::Vector result) {
    compliance_->apply(p, result);
    result *= r_;
  };
  const auto preconditioner = [this](const Gmres::Given& p, Gmres::Vector result) {
    compliance_->precondition(p, result);
  };
  effort_.krylov_iterations +=
      gmres_
          .solve(matrix, preconditioner, right_,
                 {full_stick_tolerance, options_->max_krylov_iterations, krylov_restart},
                 point.traction)
          .iterations;
  project(point.traction, bound_);
  evaluate_from_traction(point);
}

void FrictionNewton::linearise(const Point& point) {
  at_.adheres.assign(static_cast<std::size_t>(count_), 0);
  for (Index e = 0; e < count_; ++e) {
    const Index f = count_ + e;
    const double bound = point.bound[e];
    const double size = std::hypot(point.trial[e], point.trial[f]);
    at_.adheres[static_cast<std::size_t>(e)] = size <= bound;
    at_.normal[e] = size > 0.0 ? point.trial[e] / size : 0.0;
    at_.normal[f] = size > 0.0 ? point.trial[f] / size : 0.0;
    at_.factor[e] = size > 0.0 ? bound / size : 1.0;
    const double reached = std::max(bound, std::hypot(point.traction[e], point.traction[f]));
    at_.left[e] = point.traction[e] / reached;
    at_.left[f] = point.traction[f] / reached;
  }
  if (feels_slip()) state_.linearise(point.slip, point.trial);
}

void FrictionNewton::apply_jacobian(const Gmres::Given& p, Gmres::Vector result) {
  compliance_->apply(p, result);
  result *= r_;
  change_value(p, result);
}

/// Turns r times a change of slip into the change of F, for tractions that change by `p`.
void FrictionNewton::change_value(const Gmres::Given& p, Gmres::Vector change) {
  const bool falls = feels_slip();
  if (falls) {
    trial_change_ = r_ * ((1.0 - r_ * drag_) * p - change);
    state_.change(change, trial_change_, bound_change_);
    bound_change_ *= bound_relaxation_;
  }
  for_each_element(count_, [&](Index e) {
    const Index f = count_ + e;
    change[e] += r_ * drag_ * p[e];
    change[f] += r_ * drag_ * p[f];
    if (at_.adheres[static_cast<std::size_t>(e)]) return;
    const double dx = change[e] - p[e];
    const double dy = change[f] - p[f];
    const double along = at_.normal[e] * dx + at_.normal[f] * dy;
    change[e] = p[e] + at_.factor[e] * (dx - along * at_.left[e]);
    change[f] = p[f] + at_.factor[e] * (dy - along * at_.left[f]);
    if (!falls) return;
    change[e] -= bound_change_[e] / r_ * at_.normal[e];
    change[f] -= bound_change_[e] / r_ * at_.normal[f];
  });
}

bool FrictionNewton::respond(const Eigen::Ref<const Eigen::VectorXd>& slip_change,
                             Eigen::Ref<Eigen::VectorXd> change) {
  constexpr double tolerance = 1e-6;
  constexpr int most_iterations = 400;
  compliance_->linearise(preconditioned(), r_, 0.0);
  right_ = r_ * slip_change;
  slip_change_.setZero();  // tractions that stay
  change_value(slip_change_, right_);
  right_ = -right_;
  return invert_jacobian(tolerance, most_iterations, change).converged;
}

GmresResult FrictionNewton::invert_jacobian(double tolerance, int most_iterations,
                                            Gmres::Vector solution) {
  const GmresResult result =
      gmres_.solve([this](const Gmres::Given& p, Gmres::Vector image) { apply_jacobian(p, image); },
                   [this](const Gmres::Given& p, Gmres::Vector image) {
                     if (preconditioner_failed_)
                       compliance_->precondition_surely(p, image);
                     else
                       compliance_->precondition(p, image);
                   },
                   right_, {tolerance, most_iterations, krylov_restart}, solution);
  effort_.krylov_iterations += result.iterations;
  return result;
}

/// Tolerance of the linear system: loose at first, tighter as Newton's method converges (Eisenstat
/// & Walker 1996, choice 2), never tighter than required.
double FrictionNewton::forcing(double residual, double previous) const {
  const double ratio = previous < infinity ? residual / previous : 1.0;
  const double wanted = std::min(options_->krylov_tolerance, 0.5 * ratio * ratio);
  return std::max({wanted, 0.1 * options_->tolerance / residual, 1e-10});
}

/// J dp = -F. Where the bodies nearly slide, the preconditioner's block across the slip may stall
/// the iteration; replaced by the identity it converges more slowly, but it converges.
void FrictionNewton::find_direction(double tolerance) {
  compliance_->linearise(preconditioned(), r_, r_ * drag_);
  right_ = -point_->value;
  constexpr double standstill = 0.5;
  const auto solve = [&] {
    return invert_jacobian(tolerance, options_->max_krylov_iterations, direction_).residual;
  };
  if (solve() <= standstill || preconditioner_failed_) return;
  preconditioner_failed_ = true;
  solve();
}

/// One damped Newton step. False when no step along the Newton direction reduces |F|.
bool FrictionNewton::advance(double residual, double previous) {
  linearise(*point_);
  const bool extended = fronts_.extend(at_.adheres);
  if (step_along(residual, previous)) return true;
  if (!extended) return false;
  linearise(*point_);
  return step_along(residual, previous);
}

bool FrictionNewton::step_along(double residual, double previous) {
  find_direction(forcing(residual, previous));
  compliance_->apply(direction_, slip_change_);
  double length = 1.0;
  constexpr int most_halvings = 20;
  for (int halving = 0; halving < most_halvings; ++halving, length *= 0.5) {
    trial_->traction = point_->traction + length * direction_;
    trial_->slip = point_->slip + length * slip_change_;
    evaluate(*trial_);
    if (trial_->norm <= (1.0 - 1e-4 * length) * point_->norm) {
      std::swap(point_, trial_);
      return true;
    }
  }
  return false;
}

}  // namespace rollfem::contact
