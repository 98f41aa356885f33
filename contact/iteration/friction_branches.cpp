// SPDX-License-Identifier: LGPL-2.1-or-later
// Which solution Newton's method has to find where friction falls steeply with the slip and there
// may be several, and whether small changes leave it.
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

}  // namespace

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
/// not leave them.
bool FrictionNewton::follow_bounds(double scale) {
  constexpr int most_rounds = 240;
  constexpr double near_round_trips = 3e-2;
  constexpr double round_tolerance = 1e-5, least_near = 1e-6;  // below, rounds go on alone
  double near = 1e-2;  // of the bound at rest of every element
  int turns = 0;
  const bool from_sliding =
      (problem_->law.branch == FrictionBranch::sliding) != options_->other_branch;
  if (from_sliding) {
    slip_change_.setConstant(fast / problem_->slip_factor);
    state_.set_bound(slip_change_, point_->bound);
  } else {
    point_->bound = bound_;
  }
  trial_->bound = point_->bound;
  for (int round = 0; round < most_rounds; ++round) {
    frozen_ = true;
    drag_ = 0.0;
    fronts_.forget();
    evaluate(*point_);
    const bool solved = iterate(scale, near > 1e-3 ? round_tolerance : 0.1 * options_->tolerance);
    frozen_ = false;
    if (!solved) steep_ = false;  // nothing that friction does
    if (!solved) return false;
    const Eigen::VectorXd held = point_->bound;
    evaluate(*point_);
    if (point_->norm <= options_->tolerance * scale && stays()) return true;
    const double change =
        ((point_->bound - held).array() / bound_.array()).abs().maxCoeff(&restless_);
    if (change < near && near > least_near) {
      if (finish(scale, near)) return true;
      near *= 0.1;
    } else if (round % 20 == 19 && finish(scale, near_round_trips)) {
      return true;
    }
    // In shifts all bounds move the same way; along a row friction that is lost upstream can be
    // gained downstream, and both go round.
    const Eigen::ArrayXd moved = (point_->bound - held).array() / bound_.array();
    const double against = from_sliding ? -moved.minCoeff() : moved.maxCoeff();
    if (against > 0.01 * change) ++turns;
    const double share = turns < 20 ? 1.0 : turns < 60 ? 0.5 : turns < 140 ? 0.25 : 0.1;
    point_->bound = held + share * (point_->bound - held);
    trial_->bound = point_->bound;
  }
  return false;
}

/// Newton's method from the bounds of a round to a solution beside them that stays; otherwise
/// nothing is changed.
bool FrictionNewton::finish(double scale, double near) {
  fronts_.forget();
  const Eigen::VectorXd traction = point_->traction, bound = point_->bound;
  const TangentialOptions* given = options_;
  TangentialOptions brief = *given;
  brief.max_newton_steps = std::min(given->max_newton_steps, given->patience);  // no drag
  options_ = &brief;
  const bool solved = iterate(scale, given->tolerance);
  options_ = given;
  if (solved && ((point_->bound - bound).array() / bound_.array()).abs().maxCoeff() < 10.0 * near &&
      stays())
    return true;
  point_->traction = traction;
  drag_ = 0.0;
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
  frozen_ = true;
  effort_.krylov_iterations +=
      gmres_
          .solve([this](const Gmres::Given& p, Gmres::Vector result) { apply_jacobian(p, result); },
                 [this](const Gmres::Given& p, Gmres::Vector result) {
                   if (stood_still_)
                     compliance_->precondition_surely(p, result);
                   else
                     compliance_->precondition(p, result);
                 },
                 right_, {tolerance, options_->max_krylov_iterations, krylov_restart}, direction_)
          .iterations;
  frozen_ = false;
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
    const Eigen::MatrixXd hessenberg = projected.topLeftCorner(k + 1, k + 1);
    const Eigen::EigenSolver<Eigen::MatrixXd> eigenvalues(hessenberg, false);
    const double rightmost = eigenvalues.eigenvalues().real().maxCoeff();
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
  const Index k = (*places_)[static_cast<std::size_t>(restless_)];
  const std::string feedback =
      effort_.feedback ? fmt::format("; {:.2g} of a small change of friction came back in the last",
                                     *effort_.feedback)
                       : std::string();
  const auto [cause, cure] =
      state_.softens()
          ? std::pair("the layer softens so fast", "give a layer.hardening nearer to 0")
          : std::pair("friction falls so steeply with the slip velocity",
                      "give friction.memory_distance, or a larger one, or a larger half_velocity");
  throw NoSteadyFriction(fmt::format(
      "{} (steepness {:.2g}) that no state stays: none was found that small changes do not leave, "
      "and bounds went up and down most at x = {:.4g} mm, y = {:.4g} mm; without a lag such "
      "surfaces chatter; do: {} ({}{})",
      cause, effort_.steepness, grid.x(static_cast<int>(k % grid.nx)),
      grid.y(static_cast<int>(k / grid.nx)), cure, how, feedback));
}

}  // namespace rollfem::contact
