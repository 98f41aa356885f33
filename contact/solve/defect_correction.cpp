#include "contact/solve/defect_correction.hpp"

#include "contact/base/errors.hpp"
#include "contact/solve/anderson.hpp"
#include "contact/solve/leading_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace rollfem::contact {

namespace {

/// One vector for Anderson's least squares. The slip of curved streamlines is a strain and weighs
/// little beside the displacements; it follows them.
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

/// Adds what the plain difference of the coupling is beyond the fitted one, which the slip of a
/// defect takes.
void leave_coupling_unfitted(const Preconditioner& halfspace, const SurfaceField& traction,
                             const SurfaceField& uncoupled, TangentialField& slip) {
  const Field weights = halfspace.fitted_weights(traction.n);
  if (halfspace.coupled == nullptr || weights.size() == 0) return;
  const ContactGrid& grid = halfspace.whole.grid();
  const SurfaceField coupled = halfspace.coupled->apply(traction);
  const TangentialField u{coupled.x - uncoupled.x, coupled.y - uncoupled.y};
  const TangentialField plain = upwind_difference(grid, u, halfspace.upwind_order);
  const TangentialField fitted = fitted_difference(grid, u, weights);
  slip.x += plain.x - fitted.x;
  slip.y += plain.y - fitted.y;
}

/// What the preconditioner misses; its normal part as a gap along z.
Response defect_of(const Response& response, const Preconditioner& standin,
                   const SurfaceField& traction, const VerticalFrame& frame) {
  const SurfaceField& u = response.displacement;
  const SurfaceField halfspace = standin.whole.apply(traction);
  Field normal = u.n;
  if (frame.to_vertical.size() != 0) normal = normal.cwiseProduct(frame.to_vertical).eval();
  normal -=
      frame.carried.size() == 0 ? halfspace.n : Field(halfspace.n.cwiseQuotient(frame.carried));
  Response defect{{u.x - halfspace.x, u.y - halfspace.y, std::move(normal)},
                  response.curvature_slip};
  if (defect.curvature_slip.x.size() == 0)
    defect.curvature_slip = {Field::Zero(u.n.size()), Field::Zero(u.n.size())};
  leave_coupling_unfitted(standin, traction, halfspace, defect.curvature_slip);
  return defect;
}

double rms_over(const Field& mask, const Field& values) {
  const double count = mask.sum();
  return count > 0.0 ? std::sqrt((values.array().square() * mask.array()).sum() / count) : 0.0;
}

double rms_over(const Field& mask, const TangentialField& values) {
  return std::hypot(rms_over(mask, values.x), rms_over(mask, values.y));
}

SurfaceField tractions(const CoupledSolution& solution) {
  const Eigen::Index n = solution.normal.pressure.size();
  if (solution.tangential.traction.x.size() == 0)
    return {Field::Zero(n), Field::Zero(n), solution.normal.pressure};
  return {solution.tangential.traction.x, solution.tangential.traction.y, solution.normal.pressure};
}

/// How far the defect is from its own image, over the contact area: the normal part relative to the
/// elastic displacement (less its mean, which the approach takes up at given force), the tangential
/// part as slip relative to the creepage load.
double defect_residual(const Preconditioner& halfspace, const CoupledProblem& problem,
                       const CoupledSolution& solution, const Response& defect) {
  const Field mask = (solution.normal.pressure.array() > 0.0).cast<double>();
  const Response& image = solution.defect;
  Field normal_change = image.displacement.n - defect.displacement.n;
  if (problem.load.force) {
    const double mean = normal_change.dot(mask) / std::max(1.0, mask.sum());
    normal_change.array() -= mean;
  }
  double residual = problem.given_pressure.size() != 0
                        ? 0.0
                        : rms_over(mask, normal_change) / rms_over(mask, solution.displacement.n);
  if (problem.shares_load())
    residual = std::max(
        residual,
        std::abs(force_along_load(halfspace.whole.grid(), problem, solution) / *problem.load.force -
                 1.0));
  if (problem.frictionless()) return residual;
  const Field& pressure = solution.normal.pressure;
  const TangentialField slip = defect_slip(halfspace, problem, image, pressure);
  const TangentialField before = defect_slip(halfspace, problem, defect, pressure);
  const double change = rms_over(mask, TangentialField{slip.x - before.x, slip.y - before.y});
  const double load = std::max(rms_over(mask, problem.rigid_slip), rms_over(mask, slip));
  // What is only rounding of the displacements has no relative error.
  const double unit = halfspace.motion == Motion::shift ? 1.0 : halfspace.whole.grid().dx;
  const double rounding = 1e-12 * rms_over(mask, solution.displacement.n) / unit;
  if (load > rounding) residual = std::max(residual, change / load);
  return residual;
}

/// Solves the stand-in with the defect held fixed, for the force if one is prescribed: creepage
/// after creepage, which costs little beside the compliance. The next search begins where this one
/// ends.
void solve_standin_with(const Preconditioner& halfspace, const Response& defect, double tolerance,
                        std::optional<ForcedSlip>& forced, CoupledProblem& problem,
                        CoupledSolution& solution) {
  if (!forced) return solve_standin(halfspace, problem, defect, tolerance, solution);
  ForceSearch& search = forced->search;
  const ForceLaw law = [&](const Eigen::Vector2d& unknowns) {
    problem.rigid_slip = forced->rigid_slip(unknowns);
    solve_standin(halfspace, problem, defect, std::min(tolerance, search.tolerance), solution);
    const auto force =
        transmitted_force(halfspace.whole.grid(), tractions(solution), problem.shape);
    return TransmittedForce{{force[0], force[1]}, coefficient_of(problem.friction) * force[2]};
  };
  solution.unknowns = search.start = find_creepage(law, forced->wanted, search).creepage;
}

/// Shorter steps once the iteration only goes round: pressure, bound and traction at a slipping
/// edge chase each other when mu times the coupling is large.
class Damping {
 public:
  double factor() const { return factor_; }

  /// True when the step has just been shortened.
  bool after(double residual) {
    if (residual < 0.7 * best_) {
      best_ = residual;
      in_vain_ = 0;
      return false;
    }
    if (++in_vain_ < patience || factor_ <= least) return false;
    in_vain_ = 0;
    factor_ *= 0.5;
    return true;
  }

 private:
  static constexpr int patience = 8;
  static constexpr double least = 0.1;
  double best_ = std::numeric_limits<double>::infinity();
  double factor_ = 1.0;
  int in_vain_ = 0;
};

}  // namespace

CoupledSolution solve_coupled(const Compliance& compliance, const Preconditioner& halfspace,
                              const CoupledProblem& given, const OuterOptions& options,
                              const Response& start_defect, const OuterCallback& each_iteration,
                              const SurfaceField& start_traction, const ForcedSlip* forced) {
  const Eigen::Index n = halfspace.whole.grid().size();
  Response defect = start_defect;
  if (defect.displacement.n.size() != n) defect = zero_response(n);

  CoupledProblem problem = given;
  std::optional<ForcedSlip> search;
  if (forced != nullptr) search = *forced;
  Anderson anderson(options.anderson_depth);
  Damping damping;
  CoupledSolution solution;
  solution.normal.pressure = start_traction.n;
  solution.tangential.traction = {start_traction.x, start_traction.y};
  double best = std::numeric_limits<double>::infinity();
  for (int iteration = 1; iteration <= options.max_iterations; ++iteration) {
    solve_standin_with(halfspace, defect, options.tolerance, search, problem, solution);
    const SurfaceField traction = tractions(solution);
    const Response response = compliance.respond(traction);
    solution.displacement = response.displacement;
    solution.defect = defect_of(response, halfspace, traction, problem.frame);
    solution.outer_iterations = iteration;
    solution.residual = defect_residual(halfspace, problem, solution, defect);
    if (each_iteration) each_iteration(solution);
    if (solution.residual <= options.tolerance) return solution;

    // A changed active set can make the history misleading: begin it anew rather than follow it.
    if (solution.residual > 2.0 * best) anderson.restart();
    if (damping.after(solution.residual)) anderson.restart();
    best = std::min(best, solution.residual);
    const Eigen::VectorXd iterate = stacked(defect);
    const Eigen::VectorXd step = stacked(solution.defect) - iterate;
    defect = unstacked(anderson.next(iterate, iterate + damping.factor() * step));
  }
  throw SolveError("the outer contact iteration did not converge: relative residual " +
                   std::to_string(solution.residual) + " after " +
                   std::to_string(options.max_iterations) + " iterations, asked for " +
                   std::to_string(options.tolerance));
}

}  // namespace rollfem::contact
