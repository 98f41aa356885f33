// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/defect_correction.hpp"

#include "base/errors.hpp"
#include "contact/iteration/anderson.hpp"
#include "contact/iteration/friction_state.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "result/patch_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace rollfem::contact {

namespace {

/// One vector for Anderson's least squares. The slip of curved streamlines is a strain, small
/// compared with the displacements, and follows them.
Eigen::VectorXd stacked(const Response& defect) {
  const SurfaceField& u = defect.displacement;
  Eigen::VectorXd all(5 * u.n.size());
  all << u.x, u.y, u.n, defect.curvature_slip.x, defect.curvature_slip.y;
  return all;
}

Response unstacked(const Eigen::VectorXd& all) {
  const Eigen::Index n = all.size() / 5;
  return {{all.segment(0, n), all.segment(n, n), all.segment(2 * n, n)},
          {all.segment(3 * n, n), all.segment(4 * n, n)}};
}

/// Adds the plain minus the fitted difference of the coupling, because the slip of a defect uses
/// the fitted one.
void leave_coupling_unfitted(const Preconditioner& preconditioner, const SurfaceField& traction,
                             const SurfaceField& uncoupled, TangentialField& slip) {
  const Field weights = preconditioner.fitted_weights(traction.n);
  if (preconditioner.coupled == nullptr || weights.size() == 0) return;
  const ContactGrid& grid = preconditioner.whole.grid();
  const SurfaceField coupled = preconditioner.coupled->apply(traction);
  const TangentialField u{coupled.x - uncoupled.x, coupled.y - uncoupled.y};
  const TangentialField plain = upwind_difference(grid, u, preconditioner.upwind_order);
  const TangentialField fitted = fitted_difference(grid, u, weights);
  slip.x += plain.x - fitted.x;
  slip.y += plain.y - fitted.y;
}

/// Difference between elasticity and preconditioner; its normal part as a gap along z.
Response defect_of(const Response& response, const Preconditioner& preconditioner,
                   const SurfaceField& traction, const VerticalFrame& frame) {
  const SurfaceField& u = response.displacement;
  const SurfaceField halfspace = preconditioner.whole.apply(traction);
  Field normal = u.n;
  if (frame.to_vertical.size() != 0) normal = normal.cwiseProduct(frame.to_vertical).eval();
  normal -=
      frame.carried.size() == 0 ? halfspace.n : Field(halfspace.n.cwiseQuotient(frame.carried));
  Response defect{{u.x - halfspace.x, u.y - halfspace.y, std::move(normal)},
                  response.curvature_slip};
  if (defect.curvature_slip.x.size() == 0)
    defect.curvature_slip = {Field::Zero(u.n.size()), Field::Zero(u.n.size())};
  leave_coupling_unfitted(preconditioner, traction, halfspace, defect.curvature_slip);
  return defect;
}

double rms_over(const Field& mask, const Field& values) {
  const double count = mask.sum();
  return count > 0.0 ? std::sqrt((values.array().square() * mask.array()).sum() / count) : 0.0;
}

double rms_over(const Field& mask, const TangentialField& values) {
  return std::hypot(rms_over(mask, values.x), rms_over(mask, values.y));
}

SurfaceField tractions(const ContactState& solution) {
  const Eigen::Index n = solution.normal.pressure.size();
  if (solution.tangential.traction.x.size() == 0)
    return {Field::Zero(n), Field::Zero(n), solution.normal.pressure};
  return {solution.tangential.traction.x, solution.tangential.traction.y, solution.normal.pressure};
}

/// Distance of the defect from its image over the contact area, without load over the grid: the
/// normal part relative to the elastic displacement (less its mean, which the approach absorbs at
/// given force), the tangential part as slip relative to the creepage load.
double defect_residual(const Preconditioner& preconditioner, const PointProblem& problem,
                       const ContactState& solution, const Response& defect, bool to_the_bound) {
  Field mask = (solution.normal.pressure.array() > 0.0).cast<double>();
  if (problem.load.force == 0.0) mask.setOnes();
  const Response& image = solution.defect;
  Field normal_change = image.displacement.n - defect.displacement.n;
  if (problem.load.force) {
    const double mean = normal_change.dot(mask) / std::max(1.0, mask.sum());
    normal_change.array() -= mean;
  }
  const double size = rms_over(mask, solution.displacement.n);
  double residual = problem.presses() && size > 0.0 ? rms_over(mask, normal_change) / size : 0.0;
  if (problem.shares_load())
    residual = std::max(residual,
                        std::abs(force_along_load(preconditioner.whole.grid(), problem, solution) /
                                     *problem.load.force -
                                 1.0));
  if (problem.frictionless()) return residual;
  const Field& pressure = solution.normal.pressure;
  const TangentialField slip =
      defect_slip(preconditioner, problem.motion.curvature_weight, image, pressure);
  const TangentialField before =
      defect_slip(preconditioner, problem.motion.curvature_weight, defect, pressure);
  const double change = rms_over(mask, TangentialField{slip.x - before.x, slip.y - before.y});
  double load = std::max(rms_over(mask, problem.motion.rigid_slip), rms_over(mask, slip));
  if (to_the_bound)
    load =
        std::min(load, preconditioner.rolling.diagonal() *
                           rms_over(mask, traction_bound(problem.conditions.friction,
                                                         preconditioner.whole.grid(), pressure)));
  // Differences within the rounding of the displacements count as zero.
  const double unit = preconditioner.motion == Motion::shift ? 1.0 : preconditioner.whole.grid().dx;
  const double rounding = 1e-12 * size / unit;
  if (load > rounding) residual = std::max(residual, change / load);
  return residual;
}

/// Solves on the half-space with a fixed defect, for the force if one is prescribed: one creepage
/// after another, which is cheap compared with the compliance. The next search starts where this
/// one ends.
void solve_with_defect(const Preconditioner& preconditioner, const Response& defect,
                       double tolerance, std::optional<ForcedMotion>& forced, PointProblem& problem,
                       ContactState& solution) {
  if (!forced) return solve_on_halfspace(preconditioner, problem, defect, tolerance, solution);
  ForceSearch& search = forced->search;
  const ForceLaw law = [&](const Eigen::Vector2d& unknowns) {
    problem.motion = forced->at(unknowns);
    solve_on_halfspace(preconditioner, problem, defect, std::min(tolerance, search.tolerance),
                       solution);
    return transmitted_by(preconditioner.whole.grid(), problem.conditions, solution);
  };
  solution.unknowns = search.start = find_creepage(law, forced->wanted, search).creepage;
}

/// Next defect from a defect and its image: Anderson's method while it makes progress. Where mu
/// times the coupling is large, it cycles: at a slipping edge pressure, bound and traction feed
/// back on each other with a gain of i mu K/(1 - nu), and the edge moves with every step. Then
/// short plain steps, which contract as long as omega < 2/(1 + gain^2), and every few of them an
/// extrapolation (alternating Anderson-Richardson: Pratapa, Suryanarayana & Pask, J. Comput. Phys.
/// 306 (2016)).
class OuterSteps {
 public:
  explicit OuterSteps(int depth) : anderson_(depth), rare_(depth_of_rare) {}

  /// Records the residual of a defect. True when it has not decreased for long.
  bool goes_round(double residual) {
    const bool in_vain = went_in_vain(residual);
    // A changed active set can make the history misleading: restart it.
    if (in_vain || residual > 2.0 * best_) anderson_.restart();
    best_ = std::min(best_, residual);
    given_up_ = in_vain && factor_ <= least;
    if (in_vain) factor_ = std::max(least, factor_ * (factor_ > longest_plain ? 0.25 : 0.5));
    if (in_vain) rare_.restart();
    return in_vain;
  }

  /// The shortest steps failed, too.
  bool given_up() const { return given_up_; }

  Eigen::VectorXd next(const Eigen::VectorXd& defect, const Eigen::VectorXd& image) {
    if (factor_ > longest_plain) return anderson_.next(defect, image);
    const Eigen::VectorXd plain = defect + factor_ * (image - defect);
    const Eigen::VectorXd extrapolated = rare_.next(defect, plain);
    return ++plain_steps_ % period == 0 ? extrapolated : plain;
  }

 private:
  static constexpr int patience = 8;
  static constexpr int patience_when_plain = 40;
  static constexpr double longest_plain = 0.25;
  static constexpr double least = 0.03125;
  static constexpr int period = 5;
  static constexpr int depth_of_rare = 10;

  /// True when the residual has not decreased to 0.7 of its last mark for long.
  bool went_in_vain(double residual) {
    if (residual < 0.7 * mark_) {
      mark_ = residual;
      vain_ = 0;
      return false;
    }
    if (++vain_ < (factor_ > longest_plain ? patience : patience_when_plain)) return false;
    vain_ = 0;
    return true;
  }

  Anderson anderson_;
  Anderson rare_;
  double factor_ = 1.0;
  bool given_up_ = false;
  int plain_steps_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
  double mark_ = std::numeric_limits<double>::infinity();
  int vain_ = 0;
};

/// After the last iteration.
[[noreturn]] void refuse(const Preconditioner& preconditioner, const PointProblem& problem,
                         const ContactState& solution, double tolerance, double imbalance) {
  const std::string how = "the outer contact iteration did not converge: relative residual " +
                          std::to_string(solution.residual) + " after " +
                          std::to_string(solution.iterations) + " iterations, required " +
                          std::to_string(tolerance);
  if (imbalance > tolerance)
    throw SolveError(how +
                     "; the steel that yields is not in balance; do: give more load steps, a "
                     "smaller load or friction, hardening, or a smaller [fem] cell_size");
  if (solution.tangential.feedback) {
    const SteepCause why = steep_cause(
        *problem.conditions.friction, solution.tangential.steepness,
        problem.motion.past ? problem.motion.past->length : preconditioner.whole.grid().dx);
    throw NoSteadyFriction(
        why.cause +
        " that no stable steady state was found: it jumps to another one whenever pressure and "
        "slip are corrected for each other; do: " +
        why.cure + " (" + how + ")");
  }
  throw SolveError(how);
}

}  // namespace

TransmittedForce transmitted_by(const ContactGrid& grid, const ContactConditions& conditions,
                                const ContactState& state) {
  const auto force = transmitted_force(grid, state.traction(), conditions.shape);
  return {{force[0], force[1]},
          mean_coefficient(conditions.friction, grid, state.normal.pressure) * force[2]};
}

ContactState solve_coupled(const Compliance& compliance, const Preconditioner& preconditioner,
                           const PointProblem& given, const OuterOptions& options,
                           const Response& start_defect, const OuterCallback& each_iteration,
                           const SurfaceField& start_traction, const ForcedMotion* forced) {
  const Eigen::Index n = preconditioner.whole.grid().size();
  Response defect = start_defect;
  if (defect.displacement.n.size() != n)
    defect = start_traction.x.size() == n ? defect_of(compliance.respond(start_traction),
                                                      preconditioner, start_traction, given.frame)
                                          : zero_response(n);

  PointProblem problem = given;
  std::optional<ForcedMotion> search;
  if (forced != nullptr) search = *forced;
  OuterSteps steps(options.anderson_depth);
  bool may_restart = start_traction.x.size() == n && start_defect.displacement.n.size() != n;
  ContactState solution;
  solution.normal.pressure = start_traction.n;
  solution.tangential.traction = {start_traction.x, start_traction.y};
  for (int iteration = 1; iteration <= options.max_iterations; ++iteration) {
    solve_with_defect(preconditioner, defect, options.tolerance, search, problem, solution);
    const SurfaceField traction = tractions(solution);
    const Response response = compliance.respond(traction);
    solution.displacement = response.displacement;
    solution.curvature_slip = response.curvature_slip;
    solution.defect = defect_of(response, preconditioner, traction, problem.frame);
    solution.iterations = iteration;
    solution.residual =
        std::max(compliance.imbalance(),
                 defect_residual(preconditioner, problem, solution, defect, options.to_the_bound));
    if (each_iteration) each_iteration(solution);
    if (solution.residual <= options.tolerance) return solution;
    if (options.anderson_depth == 0) {
      defect = solution.defect;
      continue;
    }

    // Friction can move the patch of unlike bodies out of the grid sized for the frictionless
    // pressure: cut off at the border it has the pressure of a punch, and there may be no solution.
    if (steps.goes_round(solution.residual) &&
        touches_border(preconditioner.whole.grid(), traction.n))
      throw UnfitGrid("the contact patch reaches the border of the grid");
    if (steps.given_up() && !may_restart) break;
    if (steps.given_up()) {
      may_restart = false;
      // There may be several solutions, and none near the cycle: retry from a cold start.
      defect = zero_response(n);
      solution.tangential.traction = {};
      steps = OuterSteps(options.anderson_depth);
      continue;
    }
    defect = unstacked(steps.next(stacked(defect), stacked(solution.defect)));
  }
  refuse(preconditioner, problem, solution, options.tolerance, compliance.imbalance());
}

}  // namespace rollfem::contact
