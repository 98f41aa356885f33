#include "contact/solve/tangential.hpp"

#include "contact/base/errors.hpp"
#include "contact/solve/adhesion_fronts.hpp"
#include "contact/solve/gmres.hpp"
#include "contact/solve/linearisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::contact {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The full-stick solution is only a start, but what its tractions lack from row to row puts the
/// borders of adhesion wrong in single rows: 1e-2 cost up to 50 Newton steps where this costs 7.
constexpr double full_stick_tolerance = 1e-3;

/// Drag (times r) at the first attempt, below which it is dropped, and from which it is given up.
constexpr double first_drag = 0.3;
constexpr double least_drag = 3e-3;
constexpr double largest_drag = 100.0;

/// A problem with drag only makes a better start, relative to the creepage load.
constexpr double drag_tolerance = 1e-3;
constexpr int patience_with_drag = 25;

/// Length of a GMRES cycle before it restarts; bounds the memory.
constexpr int krylov_restart = 80;

void check_problem(const TangentialOperator& compliance, const TangentialProblem& problem) {
  const int n = compliance.grid().size();
  if (problem.pressure.size() != n || problem.rigid_slip.x.size() != n ||
      problem.rigid_slip.y.size() != n)
    throw SolveError(
        "tangential problem: pressure and rigid slip must be given for every contact element");
  if (!problem.pressure.allFinite() || problem.pressure.minCoeff() < 0.0)
    throw SolveError("tangential problem: the pressure must be finite and not negative");
  if (!problem.rigid_slip.x.allFinite() || !problem.rigid_slip.y.allFinite())
    throw SolveError("tangential problem: the rigid slip is not finite everywhere");
}

/// F(p) = p - Proj_{|.|<=g}(p - r w(p)) and what its generalised Jacobian needs. Vectors hold the x
/// components of the contact elements (g > 0), then the y components.
struct Point {
  VectorXd traction;
  VectorXd slip;
  VectorXd value;     ///< F, MPa
  VectorXd trial;     ///< q = p - r w
  VectorXd bound;     ///< g; empty: that at rest
  double norm = 0.0;  ///< of F
};

class Newton {
 public:
  Newton(const TangentialOperator& compliance, const TangentialProblem& problem,
         const TangentialOptions& options)
      : compliance_(compliance),
        problem_(problem),
        options_(options),
        r_(1.0 / compliance.diagonal()),
        at_rest_(traction_bound(problem.friction, problem.pressure)),
        elements_(at_rest_),
        count_(elements_.count()),
        bound_(count_) {
    for (Index e = 0; e < count_; ++e) bound_[e] = at_rest_[elements_[e]];
    feels_slip_ = problem.friction && problem.friction->feels_slip();
    rigid_slip_ = elements_.gathered(problem.rigid_slip);
  }

  TangentialSolution run(const TangentialField& start) {
    const double creepage_load = r_ * rigid_slip_.norm();
    if (count_ == 0 || creepage_load == 0.0) return solution(at_rest(), 0.0);
    // Relative to the creepage load; to the bound where that is smaller, so that a low friction
    // coefficient does not make anything look converged.
    const double scale = std::min(creepage_load, bound_.norm());
    Point point = first_point(start);
    fronts_.emplace(compliance_.grid(), elements_.places());
    double previous = infinity;
    int with_this_drag = 0;
    for (int step = 0; step <= options_.max_newton_steps; ++step) {
      const double residual = point.norm / scale;
      newton_steps_ = step;
      if (drag_ == 0.0 && residual <= options_.tolerance) return solution(point, residual);
      if (step == options_.max_newton_steps || drag_ > largest_drag / r_) break;
      const bool settled = drag_ > 0.0 && residual <= drag_tolerance;
      const int patience = drag_ > 0.0 ? patience_with_drag : options_.patience;
      if (!settled && ++with_this_drag <= patience && advance(point, residual, previous)) {
        previous = residual;
        continue;
      }
      set_drag(settled ? 0.25 * drag_ : std::max(4.0 * drag_, first_drag / r_), point);
      previous = infinity;
      with_this_drag = 0;
    }
    throw SolveError(
        fmt::format("the tangential contact iteration did not converge: residual {:.3g} of the "
                    "creepage load after {} Newton steps and {} Krylov iterations, required {:.3g}",
                    point.norm / scale, newton_steps_, krylov_iterations_, options_.tolerance));
  }

 private:
  VectorXd compliance_times(const VectorXd& traction) const {
    return elements_.gathered(compliance_.apply(elements_.scattered(traction)));
  }

  void project(VectorXd& traction, const VectorXd& bound) const {
    for (Index e = 0; e < count_; ++e) {
      const double size = std::hypot(traction[e], traction[count_ + e]);
      if (size <= bound[e]) continue;
      traction[e] *= bound[e] / size;
      traction[count_ + e] *= bound[e] / size;
    }
  }

  /// What the law says of an element at a slip of the problem.
  FrictionLaw::Bound law_at(Index e, double slip) const {
    FrictionLaw::Bound bound =
        problem_.friction->bound(problem_.pressure[elements_[e]], problem_.slip_factor * slip);
    bound.by_slip *= problem_.slip_factor;
    return bound;
  }

  VectorXd bound_at(const VectorXd& slip) const {
    VectorXd bound(count_);
    for (Index e = 0; e < count_; ++e)
      bound[e] = law_at(e, std::hypot(slip[e], slip[count_ + e])).value;
    return bound;
  }

  const VectorXd& bound_of(const Point& point) const { return feels_slip_ ? point.bound : bound_; }

  /// Goes on from a point with this drag, with none where it is small.
  void set_drag(double drag, Point& point) {
    drag_ = r_ * drag < least_drag ? 0.0 : drag;
    dragged_from_ = point.traction;
    fronts_->forget();
    point = evaluated(std::move(point.traction), std::move(point.slip));
  }

  Point evaluated(VectorXd traction, VectorXd slip) const {
    Point point;
    point.trial = traction - r_ * slip;
    if (drag_ > 0.0) point.trial -= r_ * drag_ * (traction - dragged_from_);
    if (feels_slip_) point.bound = bound_at(slip);
    VectorXd projected = point.trial;
    project(projected, bound_of(point));
    point.value = traction - projected;
    point.norm = point.value.norm();
    point.traction = std::move(traction);
    point.slip = std::move(slip);
    return point;
  }

  Point evaluated(VectorXd traction) const {
    VectorXd slip = rigid_slip_ + compliance_times(traction);
    return evaluated(std::move(traction), std::move(slip));
  }

  Point at_rest() const { return evaluated(VectorXd::Zero(2 * count_), rigid_slip_); }

  /// The projected full-stick solution or what the caller has, whichever is nearer.
  Point first_point(const TangentialField& start) {
    if (start.x.size() == problem_.pressure.size() && start.y.size() == start.x.size()) {
      VectorXd traction = elements_.gathered(start);
      project(traction, bound_);
      Point given = evaluated(std::move(traction));
      if (given.norm < 0.1 * at_rest().norm) return given;
      Point stick = projected_full_stick();
      return given.norm < stick.norm ? given : stick;
    }
    return projected_full_stick();
  }

  Point projected_full_stick() {
    const auto matrix = [this](const VectorXd& p) { return VectorXd(r_ * compliance_times(p)); };
    const auto preconditioner = [this](const VectorXd& p) {
      return full_adhesion(compliance_, elements_, r_, p);
    };
    const GmresResult stick =
        gmres(matrix, preconditioner, -r_ * rigid_slip_,
              {full_stick_tolerance, options_.max_krylov_iterations, krylov_restart});
    krylov_iterations_ += stick.iterations;
    VectorXd traction = stick.solution;
    project(traction, bound_);
    return evaluated(std::move(traction));
  }

  Linearisation linearised(const Point& point) const {
    Linearisation at{std::vector<char>(static_cast<std::size_t>(count_)),
                     VectorXd(2 * count_),
                     VectorXd(2 * count_),
                     VectorXd(count_),
                     {}};
    const VectorXd& bound = bound_of(point);
    for (Index e = 0; e < count_; ++e) {
      const double size = std::hypot(point.trial[e], point.trial[count_ + e]);
      at.adheres[static_cast<std::size_t>(e)] = size <= bound[e];
      at.normal[e] = size > 0.0 ? point.trial[e] / size : 0.0;
      at.normal[count_ + e] = size > 0.0 ? point.trial[count_ + e] / size : 0.0;
      at.factor[e] = size > 0.0 ? bound[e] / size : 1.0;
      const double reached =
          std::max(bound[e], std::hypot(point.traction[e], point.traction[count_ + e]));
      at.left[e] = point.traction[e] / reached;
      at.left[count_ + e] = point.traction[count_ + e] / reached;
    }
    if (feels_slip_) at.by_slip = law_by_slip(point);
    return at;
  }

  VectorXd law_by_slip(const Point& point) const {
    VectorXd by_slip = VectorXd::Zero(2 * count_);
    for (Index e = 0; e < count_; ++e) {
      const double size = std::hypot(point.slip[e], point.slip[count_ + e]);
      if (size == 0.0) continue;
      const double derivative = law_at(e, size).by_slip / size;
      by_slip[e] = derivative * point.slip[e];
      by_slip[count_ + e] = derivative * point.slip[count_ + e];
    }
    return by_slip;
  }

  VectorXd jacobian_times(const Linearisation& at, const VectorXd& p) const {
    VectorXd result = r_ * compliance_times(p);
    const VectorXd by_slip = feels_slip_ ? slip_part(at, result) : VectorXd();
    if (drag_ > 0.0) result += r_ * drag_ * p;
    for (Index e = 0; e < count_; ++e) {
      if (at.adheres[static_cast<std::size_t>(e)]) continue;
      const Index f = count_ + e;
      const double dx = result[e] - p[e];
      const double dy = result[f] - p[f];
      const double along = at.normal[e] * dx + at.normal[f] * dy;
      result[e] = p[e] + at.factor[e] * (dx - along * at.left[e]);
      result[f] = p[f] + at.factor[e] * (dy - along * at.left[f]);
      if (!feels_slip_) continue;
      result[e] -= by_slip[e] * at.normal[e];
      result[f] -= by_slip[e] * at.normal[f];
    }
    return result;
  }

  /// Change of every element's bound with its slip; `change`: r times that of the slip.
  VectorXd slip_part(const Linearisation& at, const VectorXd& change) const {
    const auto product = (at.by_slip.array() * change.array()).eval();
    return (product.head(count_) + product.tail(count_)) / r_;
  }

  /// How exactly the linear system is solved: loosely at first, more exactly as Newton's method
  /// converges fast (Eisenstat & Walker 1996, choice 2), never better than the tolerance needs.
  double forcing(double residual, double previous) const {
    const double ratio = previous < infinity ? residual / previous : 1.0;
    const double wanted = std::min(options_.krylov_tolerance, 0.5 * ratio * ratio);
    return std::max({wanted, 0.1 * options_.tolerance / residual, 1e-10});
  }

  /// J dp = -F. Where the bodies all but slide, the part across the slip may bring the
  /// preconditioned iteration to a standstill, which the identity in its place does not: slower,
  /// but it arrives.
  GmresResult newton_direction(const Point& point, const Linearisation& at, double tolerance) {
    const JacobianInverse inverse(compliance_, elements_, r_, r_ * drag_, at);
    const auto solved = [&](const LinearMap& preconditioner) {
      GmresResult result =
          gmres([&](const VectorXd& p) { return jacobian_times(at, p); }, preconditioner,
                -point.value, {tolerance, options_.max_krylov_iterations, krylov_restart});
      krylov_iterations_ += result.iterations;
      return result;
    };
    constexpr double standstill = 0.5;
    if (!stood_still_) {
      GmresResult result = solved([&](const VectorXd& p) { return inverse.times(p); });
      if (result.residual <= standstill) return result;
      stood_still_ = true;
    }
    return solved([&](const VectorXd& p) { return inverse.times_adhesion(p); });
  }

  /// One damped Newton step. False when no step along the Newton direction reduces |F|.
  bool advance(Point& point, double residual, double previous) {
    Linearisation at = linearised(point);
    const bool extended = fronts_->extend(at.adheres);
    if (step_along(point, at, residual, previous)) return true;
    return extended && step_along(point, linearised(point), residual, previous);
  }

  bool step_along(Point& point, const Linearisation& at, double residual, double previous) {
    const GmresResult newton = newton_direction(point, at, forcing(residual, previous));
    const VectorXd slip_change = compliance_times(newton.solution);
    double length = 1.0;
    constexpr int most_halvings = 20;
    for (int halving = 0; halving < most_halvings; ++halving, length *= 0.5) {
      Point trial =
          evaluated(point.traction + length * newton.solution, point.slip + length * slip_change);
      if (trial.norm <= (1.0 - 1e-4 * length) * point.norm) {
        point = std::move(trial);
        return true;
      }
    }
    return false;
  }

  TangentialSolution solution(const Point& point, double residual) const {
    TangentialSolution result;
    // As it is, within the bound to the tolerance: projected it would hide what is left.
    result.traction = elements_.scattered(point.traction);
    const TangentialField displacement = compliance_.apply(result.traction);
    result.slip = {problem_.rigid_slip.x + displacement.x, problem_.rigid_slip.y + displacement.y};
    const Linearisation at = linearised(point);
    result.state.assign(static_cast<std::size_t>(problem_.pressure.size()), ElementState::exterior);
    for (Index e = 0; e < count_; ++e)
      result.state[static_cast<std::size_t>(elements_[e])] =
          at.adheres[static_cast<std::size_t>(e)] ? ElementState::adhesion : ElementState::slip;
    result.newton_steps = newton_steps_;
    result.krylov_iterations = krylov_iterations_;
    result.residual = residual;
    return result;
  }

  const TangentialOperator& compliance_;
  const TangentialProblem& problem_;
  TangentialOptions options_;
  double r_;
  Field at_rest_;  ///< g at rest, of the grid
  ContactElements elements_;
  Index count_;
  VectorXd bound_;  ///< g at rest, of the contact elements
  bool feels_slip_ = false;
  std::optional<AdhesionFronts> fronts_;
  double drag_ = 0.0;      ///< c in w + c (p - p'), of the unit of T
  VectorXd dragged_from_;  ///< p'
  VectorXd rigid_slip_;
  int newton_steps_ = 0;
  int krylov_iterations_ = 0;
  bool stood_still_ = false;  ///< the full preconditioner has once
};

}  // namespace

TangentialSolution solve_tangential(const TangentialOperator& compliance,
                                    const TangentialProblem& problem,
                                    const TangentialOptions& options,
                                    const TangentialField& start) {
  check_problem(compliance, problem);
  return Newton(compliance, problem, options).run(start);
}

}  // namespace rollfem::contact
