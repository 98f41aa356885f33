// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/friction_newton.hpp"

#include "base/pieces.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

namespace rollfem::contact {

namespace {

/// A slip at which all laws are down to their kinetic friction.
constexpr double fast = 1e9;

/// Feedback above which small changes grow: 1 plus the uncertainty of the estimate.
constexpr double largest_feedback = 1.02;

/// The largest real part of the eigenvalues of a Hessenberg matrix.
double largest_real_part(const Eigen::MatrixXd& hessenberg) {
  Eigen::RealSchur<Eigen::MatrixXd> schur(hessenberg.rows());
  schur.computeFromHessenberg(hessenberg, hessenberg, false);
  const Eigen::MatrixXd& block = schur.matrixT();
  double largest = -infinity;
  for (Eigen::Index k = 0; k < block.rows(); ++k) {
    const bool of_pair = k + 1 < block.rows() && block(k + 1, k) != 0.0;
    largest = std::max(largest, of_pair ? 0.5 * (block(k, k) + block(k + 1, k + 1)) : block(k, k));
    k += of_pair ? 1 : 0;
  }
  return largest;
}

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

/// Compares the steepness of a single element and of all elements together: with tractions in
/// proportion to the pressure, the largest slip per traction bounds the feedback of operators with
/// positive entries, such as those of shifts, where the elements help one another.
bool FrictionNewton::falls_steeply() {
  if (!feels_slip_) return steep_ = false;
  const Index size = count_;
  const double unit = std::sqrt(0.5) / bound_.maxCoeff();
  trial_->traction.head(size) = unit * bound_;
  trial_->traction.tail(size) = unit * bound_;
  compliance_->apply(trial_->traction, trial_->slip);
  const double together =
      (trial_->slip.head(size).array().square() + trial_->slip.tail(size).array().square())
          .maxCoeff();
  return steep_ = effort_.steepness >= steep || state_.steepness(std::sqrt(together)) >= steep;
}

/// Each round solves with fixed bounds, which has one solution, and then lowers the bounds by its
/// slip. Starting from the bounds at rest, the first bounds that stay are those of the solution
/// with the largest bounds, which grows out of small creepage. Starting from the bounds of fast
/// sliding, they rise to the solution with the smallest bounds. Then Newton's method takes over,
/// and must stay at that solution. In shifts all bounds move the same way; along a row friction
/// that is lost upstream can be gained downstream, and both go round: then bounds follow with a
/// lag, in implicit steps of time (stays()).
bool FrictionNewton::follow_bounds(double scale) {
  constexpr int most_rounds = 240, most_turns = 20;
  constexpr double near_round_trips = 3e-2;
  constexpr double round_tolerance = 1e-5, coarse = 1e-3;
  constexpr double least_near = 1e-6;  // below, rounds go on alone
  constexpr double longest_step = 10.0, short_step = 0.1, shortest_step = 0.01;
  double near = 1e-2;  // of the bound at rest of every element
  double step = 1.0;   // of time
  int turns = 0;
  const bool from_sliding =
      (problem_->friction->branch == FrictionBranch::sliding) != options_->other_branch;
  if (from_sliding) {
    slip_change_.setConstant(fast / problem_->motion.slip_factor);
    state_.set_bound(slip_change_, slip_change_, point_->bound);
  } else {
    point_->bound = bound_;
  }
  effort_.feedback.reset();
  for (int round = 0; round < most_rounds && step > shortest_step; ++round) {
    const bool lags = turns >= most_turns;
    const double tolerance = lags          ? std::max(1e-2 * near, options_->tolerance)
                             : near > 1e-3 ? round_tolerance
                                           : 0.1 * options_->tolerance;
    lagged_bound_ = point_->bound;
    trial_->bound = lagged_bound_;
    bound_relaxation_ = lags ? step / (1.0 + step) : 0.0;
    drag_ = 0.0;
    fronts_.forget();
    const Eigen::VectorXd traction = point_->traction;
    evaluate(*point_);
    const double part = lags ? bound_relaxation_ : 1.0;
    const bool solved = lags ? iterate_briefly(scale, tolerance) : iterate(scale, tolerance);
    bound_relaxation_ = 1.0;
    if (!solved && !lags) {
      steep_ = false;  // nothing that friction does
      return false;
    }
    if (!solved && (point_->norm > coarse * scale || step < short_step)) {
      point_->traction = traction;
      point_->bound = lagged_bound_;
      step *= 0.5;
      bound_relaxation_ = 0.0;
      drag_ = 0.0;
      evaluate_from_traction(*point_);
      continue;
    }
    evaluate(*point_);
    if (point_->norm <= options_->tolerance * scale && stays()) return true;
    const Eigen::ArrayXd moved = (point_->bound - lagged_bound_).array() / bound_.array();
    const double change = moved.abs().maxCoeff(&most_changed_element_);
    const Eigen::VectorXd next = lagged_bound_ + part * (point_->bound - lagged_bound_);
    if (lags) step = solved ? std::min(longest_step, 1.5 * step) : 0.5 * step;
    // Longer steps would end in the solution found last, which is unstable.
    if (lags && effort_.feedback > 1.0) step = std::min(step, 0.5 / (*effort_.feedback - 1.0));
    if (change < near && near > least_near) {
      if (finish(scale, near)) return true;
      near *= 0.1;
    } else if (round % 20 == 19 && finish(scale, near_round_trips)) {
      return true;
    }
    const double against = from_sliding ? -moved.minCoeff() : moved.maxCoeff();
    if (against > 0.01 * change && ++turns == most_turns && finish_from_first(scale)) return true;
    point_->bound = next;
  }
  return false;
}

/// Newton's method without long detours.
bool FrictionNewton::iterate_briefly(double scale, double tolerance) {
  const TangentialOptions* given = options_;
  TangentialOptions brief = *given;
  brief.max_newton_steps = std::min(given->max_newton_steps, given->patience);  // no drag
  options_ = &brief;
  const bool solved = iterate(scale, tolerance);
  options_ = given;
  return solved;
}

/// Newton's method from the bounds of a round to a nearby stable solution; changes nothing if there
/// is none.
bool FrictionNewton::finish(double scale, double near) {
  fronts_.forget();
  const Eigen::VectorXd traction = point_->traction, bound = point_->bound;
  const bool solved = iterate_briefly(scale, options_->tolerance);
  if (solved && ((point_->bound - bound).array() / bound_.array()).abs().maxCoeff() < 10.0 * near &&
      stays())
    return true;
  point_->traction = traction;
  drag_ = 0.0;
  evaluate_from_traction(*point_);
  return false;
}

/// The same from the first iterate, whatever the solution: along a force search, or from one
/// correction to the next, the solution then stays on the same branch.
bool FrictionNewton::finish_from_first(double scale) {
  const Eigen::VectorXd traction = point_->traction;
  point_->traction = first_;
  evaluate_from_traction(*point_);
  if (finish(scale, infinity)) return true;
  point_->traction = traction;
  evaluate_from_traction(*point_);
  return false;
}

/// A change of the bounds of the slipping elements changes the slip, which changes the bounds in
/// turn: by bound_change_.
void FrictionNewton::feed_back(const Eigen::VectorXd& change) {
  constexpr double tolerance = 1e-3;
  for (Index e = 0; e < count_; ++e) {
    right_[e] = change[e] * at_.normal[e];
    right_[count_ + e] = change[e] * at_.normal[count_ + e];
  }
  bound_relaxation_ = 0.0;
  invert_jacobian(tolerance, options_->max_krylov_iterations, direction_);
  bound_relaxation_ = 1.0;
  compliance_->apply(direction_, slip_change_);
  trial_change_ = direction_ - r_ * slip_change_;
  state_.change(slip_change_, trial_change_, bound_change_);
  for (Index e = 0; e < count_; ++e)
    if (at_.adheres[static_cast<std::size_t>(e)]) bound_change_[e] = 0.0;
}

/// If friction follows the slip with a lag, however short, bounds g move like dg/dt = G(g) - g, G
/// those at the slip of the solution with bounds g held fixed. Small changes die out where the
/// eigenvalues of G' have real parts below 1; the rightmost ones are what Arnoldi's method finds
/// first. Changes that rolling only carries downstream have none. Where T is symmetric, as in
/// shifts, this is the same as a minimum of the energy of the step.
bool FrictionNewton::stays() {
  constexpr int most_products = 24;
  constexpr double settled = 5e-3;
  linearise(*point_);
  drag_ = 0.0;
  compliance_->linearise(at_, r_, 0.0);
  Eigen::MatrixXd basis(count_, most_products + 1);
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(most_products + 1, most_products);
  for (Index e = 0; e < count_; ++e) {
    const bool slips = at_.adheres[static_cast<std::size_t>(e)] == 0;
    // Without symmetry, so that it has a part along every eigenvector.
    basis(e, 0) = slips ? bound_[e] * (1.0 + 0.5 * std::cos(7.3 * static_cast<double>(e))) : 0.0;
  }
  effort_.feedback = 0.0;
  const double norm = basis.col(0).norm();
  if (norm == 0.0) return true;
  basis.col(0) /= norm;
  int steady = 0;
  for (Index k = 0; k < most_products && steady < 3; ++k) {
    feed_back(basis.col(k));
    Eigen::VectorXd image = bound_change_;
    const auto known = basis.leftCols(k + 1);
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd part = known.transpose() * image;
      projected.col(k).head(k + 1) += part;
      image -= known * part;
    }
    const double rightmost = largest_real_part(projected.topLeftCorner(k + 1, k + 1));
    steady = std::abs(rightmost - *effort_.feedback) < settled ? steady + 1 : 0;
    effort_.feedback = rightmost;
    const double length = image.norm();
    projected(k + 1, k) = length;
    if (length < 1e-6) break;
    basis.col(k + 1) = image / length;
  }
  return *effort_.feedback <= largest_feedback;
}

void FrictionNewton::fail(double scale) const {
  const std::string how = fmt::format(
      "residual {:.3g} of the creepage load after {} Newton steps and {} Krylov iterations, "
      "required {:.3g}",
      point_->norm / scale, effort_.newton_steps, effort_.krylov_iterations, options_->tolerance);
  if (!steep_) throw SolveError("the tangential contact iteration did not converge: " + how);
  const Index k = (*places_)[static_cast<std::size_t>(most_changed_element_)];
  const std::string found =
      effort_.feedback
          ? fmt::format("in the one found a small change returns {:.3g} times as large",
                        *effort_.feedback)
          : std::string("Newton's method found none");
  const SteepCause reason =
      steep_cause(*problem_->friction, effort_.steepness,
                  problem_->motion.past ? problem_->motion.past->length : grid_->dx);
  throw NoSteadyFriction(
      fmt::format("{} (steepness {:.2g}) that no stable steady state was found: {}, and bounds "
                  "went up and down most at x = "
                  "{:.4g} mm, y = {:.4g} mm; such surfaces stick and slip in turn, which steps of "
                  "rolling.problem = \"transient\" follow; do: {} ({})",
                  reason.cause, effort_.steepness, found, grid_->x(static_cast<int>(k % grid_->nx)),
                  grid_->y(static_cast<int>(k / grid_->nx)), reason.cure, how));
}

FrictionEffort FrictionNewton::solve(ElementOperator& compliance, const ContactGrid& grid,
                                     const TangentialProblem& problem,
                                     const std::vector<Index>& places,
                                     const TangentialOptions& options,
                                     const TangentialField& start) {
  compliance_ = &compliance;
  grid_ = &grid;
  problem_ = &problem;
  places_ = &places;
  options_ = &options;
  r_ = 1.0 / compliance.diagonal();
  state_.begin(grid, problem, places, r_);
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
    fronts_.begin(grid, places);
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

/// Computes value and norm of a point from its traction and slip.
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
                       compliance_->precondition_robustly(p, image);
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
