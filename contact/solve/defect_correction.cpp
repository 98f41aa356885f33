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

Response zero_response(Eigen::Index n) {
  return {{Field::Zero(n), Field::Zero(n), Field::Zero(n)}, {Field::Zero(n), Field::Zero(n)}};
}

/// A distance along the local normal to the vertical way that closes it, which makes the normal
/// problem of a curved patch that of a plane one: gap = h + u_n - approach / stretch becomes
/// stretch (h + u_n) - approach, the pressure's vertical force is its sum times dx dy, and with
/// respect to that sum stretch A_nn is symmetric.
Field vertical(const PatchShape& shape, const Field& distance) {
  return shape.stretch.size() == 0 ? distance : Field(distance.cwiseProduct(shape.stretch));
}

/// What the preconditioner misses.
Response defect_of(const Response& response, const SurfaceField& halfspace,
                   const PatchShape& shape) {
  const SurfaceField& u = response.displacement;
  Response defect{{u.x - halfspace.x, u.y - halfspace.y, vertical(shape, u.n) - halfspace.n},
                  response.curvature_slip};
  if (defect.curvature_slip.x.size() == 0)
    defect.curvature_slip = {Field::Zero(u.n.size()), Field::Zero(u.n.size())};
  return defect;
}

/// Vertical force of the tractions along the local lateral tangent, N.
double friction_lift(const Preconditioner& halfspace, const CoupledProblem& problem,
                     const CoupledSolution& solution) {
  const Field& py = solution.tangential.traction.y;
  if (py.size() == 0 || problem.shape.climb.size() == 0) return 0.0;
  return halfspace.whole.grid().element_area() * py.dot(problem.shape.climb);
}

/// Slip (displacement in a shift) that a defect of the compliance adds to the rigid slip.
TangentialField defect_slip(const Preconditioner& halfspace, const Response& defect) {
  if (halfspace.motion == Motion::shift) return {defect.displacement.x, defect.displacement.y};
  TangentialField slip =
      upwind_difference(halfspace.whole.grid(), {defect.displacement.x, defect.displacement.y},
                        halfspace.upwind_order);
  slip.x += defect.curvature_slip.x;
  slip.y += defect.curvature_slip.y;
  return slip;
}

double rms_over(const Field& mask, const Field& values) {
  const double count = mask.sum();
  return count > 0.0 ? std::sqrt((values.array().square() * mask.array()).sum() / count) : 0.0;
}

double rms_over(const Field& mask, const TangentialField& values) {
  return std::hypot(rms_over(mask, values.x), rms_over(mask, values.y));
}

bool frictionless(const CoupledProblem& problem) {
  return problem.rigid_slip.x.size() == 0 || problem.friction_coefficient == 0.0;
}

/// A given pressure as the solution of a normal problem nobody asks about: no gap, no approach.
NormalSolution given_normal(const ContactGrid& grid, const Field& pressure) {
  NormalSolution given;
  given.pressure = pressure;
  given.gap = Field::Zero(pressure.size());
  given.normal_force = pressure.sum() * grid.element_area();
  given.contact_elements = static_cast<int>((pressure.array() > 0.0).count());
  return given;
}

/// Normal contact with A_half alone, the defect put in as an extra gap; pressure carries what the
/// tractions leave of the vertical force.
void solve_pressure(const Preconditioner& halfspace, const CoupledProblem& problem,
                    const Response& defect, double lift, double tolerance,
                    CoupledSolution& solution) {
  if (problem.given_pressure.size() != 0) {
    solution.normal = given_normal(halfspace.whole.grid(), problem.given_pressure);
    return;
  }
  NormalProblem normal{vertical(problem.shape, problem.undeformed_distance) + defect.displacement.n,
                       problem.normal_force, problem.approach};
  if (normal.normal_force) *normal.normal_force -= lift;
  NormalOptions options;
  options.tolerance = std::min(options.tolerance, 0.1 * tolerance);
  solution.normal = solve_normal(halfspace.normal, normal, options, solution.normal.pressure);
}

/// The same for the tractions under that pressure, the defect put in as an extra slip.
void solve_tractions(const Preconditioner& halfspace, const CoupledProblem& problem,
                     const Response& defect, double tolerance, CoupledSolution& solution) {
  const TangentialField from_defect = defect_slip(halfspace, defect);
  TangentialProblem tangential{
      problem.friction_coefficient * solution.normal.pressure,
      {problem.rigid_slip.x + from_defect.x, problem.rigid_slip.y + from_defect.y}};
  TangentialOptions options;
  options.tolerance = std::min(options.tolerance, 0.1 * tolerance);
  std::optional<EdgeFittedRolling> fitted;
  if (halfspace.first_order && halfspace.upwind_order == UpwindOrder::second)
    fitted.emplace(*halfspace.first_order, halfspace.rolling,
                   upwind_weights(halfspace.whole.grid(), solution.normal.pressure));
  solution.tangential = solve_tangential(fitted ? *fitted : halfspace.rolling, tangential, options,
                                         solution.tangential.traction);
}

/// Contact with A_half alone. On a curved patch at given force pressure and tractions share the
/// vertical force: they are solved in turn until they do, which takes few turns as the lift of the
/// tractions is a small part of the force.
void solve_preconditioner(const Preconditioner& halfspace, const CoupledProblem& problem,
                          const Response& defect, double tolerance, CoupledSolution& solution) {
  constexpr int most_turns = 10;
  constexpr double shared_to = 1e-10;
  for (int turn = 0; turn < most_turns; ++turn) {
    const double lift = friction_lift(halfspace, problem, solution);
    solve_pressure(halfspace, problem, defect, lift, tolerance, solution);
    if (frictionless(problem)) return;
    solve_tractions(halfspace, problem, defect, tolerance, solution);
    const double change = friction_lift(halfspace, problem, solution) - lift;
    if (!problem.normal_force || std::abs(change) <= shared_to * *problem.normal_force) return;
  }
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
  if (problem.normal_force) {
    const double mean = normal_change.dot(mask) / std::max(1.0, mask.sum());
    normal_change.array() -= mean;
  }
  double residual = problem.given_pressure.size() != 0
                        ? 0.0
                        : rms_over(mask, normal_change) / rms_over(mask, solution.displacement.n);
  if (problem.normal_force && problem.given_pressure.size() == 0)
    residual = std::max(
        residual, std::abs(solution.normal.normal_force +
                           friction_lift(halfspace, problem, solution) - *problem.normal_force) /
                      *problem.normal_force);
  if (!frictionless(problem)) {
    const TangentialField slip = defect_slip(halfspace, image);
    const TangentialField before = defect_slip(halfspace, defect);
    const double change = rms_over(mask, TangentialField{slip.x - before.x, slip.y - before.y});
    const double load = std::max(rms_over(mask, problem.rigid_slip), rms_over(mask, slip));
    // What is only rounding of the displacements has no relative error.
    const double unit = halfspace.motion == Motion::shift ? 1.0 : halfspace.whole.grid().dx;
    const double rounding = 1e-12 * rms_over(mask, solution.displacement.n) / unit;
    if (load > rounding) residual = std::max(residual, change / load);
  }
  return residual;
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
                              const CoupledProblem& problem, const OuterOptions& options,
                              const Response& start_defect, const OuterCallback& each_iteration,
                              const SurfaceField& start_traction) {
  const Eigen::Index n = halfspace.whole.grid().size();
  Response defect = start_defect;
  if (defect.displacement.n.size() != n) defect = zero_response(n);

  Anderson anderson(options.anderson_depth);
  Damping damping;
  CoupledSolution solution;
  solution.normal.pressure = start_traction.n;
  solution.tangential.traction = {start_traction.x, start_traction.y};
  double best = std::numeric_limits<double>::infinity();
  for (int iteration = 1; iteration <= options.max_iterations; ++iteration) {
    solve_preconditioner(halfspace, problem, defect, options.tolerance, solution);
    const SurfaceField traction = tractions(solution);
    const Response response = compliance.respond(traction);
    solution.displacement = response.displacement;
    solution.defect = defect_of(response, halfspace.whole.apply(traction), problem.shape);
    solution.outer_iterations = iteration;
    solution.residual = defect_residual(halfspace, problem, solution, defect);
    if (each_iteration) each_iteration(solution);
    if (solution.residual <= options.tolerance) {
      if (problem.shape.stretch.size() > 0)
        solution.normal.gap = solution.normal.gap.cwiseQuotient(problem.shape.stretch);
      return solution;
    }

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
