// SPDX-License-Identifier: LGPL-2.1-or-later
// Which solution Newton's method has to find where friction falls steeply with the slip and there
// may be several, and whether it is stable.
#include "contact/iteration/friction_newton.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::contact {

namespace {

/// From this steepness of the law on (contact::steepness) there may be several solutions.
constexpr double steep = 0.5;

/// A slip at which all laws are down to their kinetic friction.
constexpr double fast = 1e9;

/// Feedback above which small changes grow: 1, and what the estimate may err.
constexpr double largest_feedback = 1.02;

/// Of the eigenvalues of a Hessenberg matrix.
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

/// The memory distance, mm, with which the law is no longer steep.
double sufficient_memory(const FrictionLaw& law, double steepness, double way) {
  const double wanted = steep * steepest_fall(law, way, law.memory()) / steepness;
  const double least_slip = law.memory() ? law.memory()->least_slip : 0.0;
  double lower = 1e-9, upper = 1e3;
  while (upper > 1.01 * lower) {
    const double middle = std::sqrt(lower * upper);
    const bool enough = steepest_fall(law, way, FrictionMemory{middle, least_slip}) < wanted;
    (enough ? upper : lower) = middle;
  }
  return upper;
}

}  // namespace

SteepCause steep_cause(const FrictionLaw& law, double steepness, double way) {
  SteepCause words{"friction falls so steeply with the slip velocity",
                   "give friction.memory_distance, or a larger one, or a larger half_velocity"};
  if (law.feels_slip() && way > 0.0 && steepness > steep)
    words.cure = fmt::format(
        "give friction.memory_distance (one state from about {:.2g} mm), or a larger half_velocity",
        sufficient_memory(law, steepness, way));
  if (!law.plasticity || law.plasticity->hardening >= 0.0) return words;
  const std::string cure = "give a layer.hardening nearer to 0";
  if (!law.feels_slip()) return {"the layer softens so fast", cure};
  return {"friction falls with the slip velocity and the layer softens so fast",
          cure + ", or " + words.cure};
}

/// Of a single element, or of all together: with tractions in proportion to the pressure, the
/// largest slip per traction bounds the feedback of operators with positive entries, such as those
/// of shifts, where the elements help one another.
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

/// Bounds begin at rest and follow the slip of the solution with bounds held fixed, which has one.
/// Rounds let more slip and lower bounds further, down to the first that stay: those of the
/// solution with the largest bounds, which grows out of small creepage. From the bounds of fast
/// sliding they rise to the solution with the smallest. Then Newton's method takes over, and must
/// not leave them. In shifts all bounds move the same way; along a row friction that is lost
/// upstream can be gained downstream, and both go round: then bounds follow with a lag, in implicit
/// steps of time (stays()).
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
      (problem_->law.branch == FrictionBranch::sliding) != options_->other_branch;
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
    // Longer steps would end in the state found last, which is unstable.
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

/// Newton's method from the bounds of a round to a solution beside them that stays; otherwise
/// nothing is changed.
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

/// The same from the first point, wherever it leads: along a force search or from one correction
/// to the next the state then stays the same where there are several.
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
    // Of no symmetry that an eigenvector might lack.
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
  const ContactGrid& grid = problem_->grid;
  const Index k = (*places_)[static_cast<std::size_t>(most_changed_element_)];
  const std::string found =
      effort_.feedback
          ? fmt::format("in the one found a small change returns {:.3g} times as large",
                        *effort_.feedback)
          : std::string("Newton's method found none");
  const SteepCause steep =
      steep_cause(problem_->law, effort_.steepness,
                  problem_->motion.past ? problem_->motion.past->length : grid.dx);
  throw NoSteadyFriction(
      fmt::format("{} (steepness {:.2g}) that no stable steady state was found: {}, and bounds "
                  "went up and down most at x = "
                  "{:.4g} mm, y = {:.4g} mm; such surfaces stick and slip in turn, which steps of "
                  "rolling.problem = \"transient\" follow; do: {} ({})",
                  steep.cause, effort_.steepness, found, grid.x(static_cast<int>(k % grid.nx)),
                  grid.y(static_cast<int>(k / grid.nx)), steep.cure, how));
}

}  // namespace rollfem::contact
