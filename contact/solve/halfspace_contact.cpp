// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/halfspace_contact.hpp"

#include "contact/iteration/leading_edge.hpp"
#include "contact/solve/pressure_share.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::contact {

namespace {

/// The normal problem in terms of q = carried p.
class CarriedNormal : public NormalOperator {
 public:
  CarriedNormal(const NormalOperator& plane, const Field& carried)
      : plane_(plane), carried_(carried) {}
  const ContactGrid& grid() const override { return plane_.grid(); }
  void apply(const Field& q, Field& displacement) const override {
    plane_.apply(q.cwiseQuotient(carried_), displacement);
    displacement.array() /= carried_.array();
  }
  void precondition(const Field& residual, Field& result) const override {
    plane_.precondition(residual.cwiseProduct(carried_), result);
    result.array() *= carried_.array();
  }

 private:
  const NormalOperator& plane_;
  const Field& carried_;
};

/// A given pressure as the solution of a normal problem, without gap and approach.
NormalSolution given_normal(const ContactGrid& grid, const Field& pressure) {
  NormalSolution given;
  given.pressure = pressure;
  given.normal_force = pressure.sum() * grid.element_area();
  given.contact_elements = static_cast<int>((pressure.array() > 0.0).count());
  return given;
}

/// Normal contact on the half-space. `defect`: an extra gap along the load (along z in the plane),
/// may be empty; `force`: force that the pressure carries in this direction.
NormalSolution solve_pressure(const NormalOperator& plane, const PointProblem& problem,
                              const Field& defect, const std::optional<double>& force,
                              const NormalOptions& options, const Field& start) {
  const ContactConditions& conditions = problem.conditions;
  if (!problem.presses()) return given_normal(plane.grid(), conditions.given_pressure);
  const VerticalFrame& frame = problem.frame;
  NormalProblem normal{conditions.undeformed_distance, force, problem.load.approach};
  const double along_z = problem.load.direction[1];
  if (!frame.plane()) {
    normal.undeformed_distance = normal.undeformed_distance.cwiseProduct(frame.to_vertical).eval();
    if (normal.approach) *normal.approach /= along_z;
  }
  if (defect.size() != 0) normal.undeformed_distance += defect;
  NormalSolution solution;
  if (frame.carried.size() == 0) {
    solution = solve_normal(plane, normal, options, start);
  } else {
    const bool given = start.size() == frame.carried.size();
    solution = solve_normal(CarriedNormal(plane, frame.carried), normal, options,
                            given ? Field(start.cwiseProduct(frame.carried)) : Field());
    solution.pressure = solution.pressure.cwiseQuotient(frame.carried).eval();
  }
  if (!frame.plane()) {
    solution.gap = solution.gap.cwiseQuotient(frame.to_vertical).eval();
    solution.approach *= along_z;
  }
  return solution;
}

/// Force carried by the pressure without friction, along the load (along z in the plane).
double frictionless_share(const PointProblem& problem) {
  return *problem.load.force / (problem.frame.plane() ? problem.load.direction[1] : 1.0);
}

/// The same force that the pressure has to carry if friction stays unchanged.
double pressure_share(const ContactGrid& grid, const PointProblem& problem,
                      const ContactState& solution) {
  const double wanted = *problem.load.force;
  if (solution.normal.pressure.size() != grid.size()) return frictionless_share(problem);
  const Field none = Field::Zero(grid.size());
  const auto [across, upwards] = problem.load.direction;
  const auto pressure =
      transmitted_force(grid, {none, none, solution.normal.pressure}, problem.conditions.shape);
  const double missing = wanted - force_along_load(grid, problem, solution);
  return problem.frame.plane() ? pressure[2] + missing / upwards
                               : across * pressure[1] + upwards * pressure[2] + missing;
}

/// Tractions under the pressure of `solution`; `defect` (may be null) is an extra slip. `weights`:
/// Preconditioner::fitted_weights.
void solve_tractions(const Preconditioner& preconditioner, const PointProblem& problem,
                     const Response* defect, double tolerance, const Field& weights,
                     ContactState& solution) {
  TangentialOptions options;
  options.tolerance = tolerance;
  std::optional<EdgeFittedRolling> fitted;
  if (weights.size() != 0)
    fitted.emplace(*preconditioner.first_order, preconditioner.rolling, weights);
  solution.tangential = solve_tangential(
      fitted ? *fitted : preconditioner.rolling,
      tangential_problem(preconditioner, problem.motion, problem.conditions.friction,
                         solution.normal.pressure, defect),
      options, solution.tangential.traction);
}

}  // namespace

VerticalFrame vertical_frame(const PatchShape& shape, const std::array<double, 2>& direction) {
  if (shape.climb.size() == 0) return {};
  Field carried =
      shape.climb.unaryExpr([&](double climb) { return carried_part(direction, climb); });
  if (shape.y.size() == 0) {
    const Field to_load = shape.stretch.cwiseQuotient(carried);
    return {to_load, direction == std::array{0.0, 1.0} ? Field() : carried};
  }
  carried = carried.array() * (1.0 + shape.climb.array().square()).rsqrt();
  return {carried.cwiseInverse(), carried};
}

Response zero_response(Eigen::Index n) {
  return {{Field::Zero(n), Field::Zero(n), Field::Zero(n)}, {Field::Zero(n), Field::Zero(n)}};
}

Field Preconditioner::fitted_weights(const Field& pressure) const {
  if (first_order == nullptr || upwind_order != UpwindOrder::second) return {};
  return upwind_weights(whole.grid(), pressure);
}

TangentialField defect_slip(const Preconditioner& preconditioner, double curvature_weight,
                            const Response& defect, const Field& pressure) {
  const ContactGrid& grid = preconditioner.whole.grid();
  const TangentialField u{defect.displacement.x, defect.displacement.y};
  const Field weights = preconditioner.fitted_weights(pressure);
  TangentialField slip = preconditioner.motion == Motion::shift ? u
                         : weights.size() != 0
                             ? fitted_difference(grid, u, weights)
                             : upwind_difference(grid, u, preconditioner.upwind_order);
  if (curvature_weight != 0.0) {
    slip.x += curvature_weight * defect.curvature_slip.x;
    slip.y += curvature_weight * defect.curvature_slip.y;
  }
  return slip;
}

TangentialProblem tangential_problem(const Preconditioner& preconditioner,
                                     const TangentialMotion& motion, const Friction& friction,
                                     const Field& pressure, const Response* defect) {
  TangentialProblem problem{pressure, motion, friction};
  if (defect == nullptr) return problem;
  const TangentialField slip =
      defect_slip(preconditioner, motion.curvature_weight, *defect, pressure);
  problem.motion.rigid_slip.x += slip.x;
  problem.motion.rigid_slip.y += slip.y;
  return problem;
}

double force_along_load(const ContactGrid& grid, const PointProblem& problem,
                        const ContactState& solution) {
  const auto force = transmitted_force(grid, solution.traction(), problem.conditions.shape);
  return problem.load.direction[0] * force[1] + problem.load.direction[1] * force[2];
}

NormalSolution press_on_halfspace(const NormalOperator& normal, const PointProblem& problem,
                                  const Field& start) {
  std::optional<double> force;
  if (problem.load.force) force = frictionless_share(problem);
  return solve_pressure(normal, problem, {}, force, {}, start);
}

namespace {

constexpr double shared_to = 1e-10;
/// Weights at the leading edge jump when an element comes into contact, and forces jump by 0.1 % of
/// the load: the force may jump across the required share, so that no iterate meets it. From this
/// iteration on the weights are fixed.
constexpr int turns_until_kept = 12;
/// Divergence limit: pressure that carries more than this many times the load along z.
constexpr double largest_share = 30.0;

/// The share of the pressure is a fixed point. `pressed`: `solution` already holds the frictionless
/// pressure of the load.
void solve_in_turn(const Preconditioner& preconditioner, const PointProblem& problem,
                   const Response* defect, const NormalOptions& normal, double tangential,
                   bool pressed, ContactState& solution) {
  const ContactGrid& grid = preconditioner.whole.grid();
  const Field gap = defect ? defect->displacement.n : Field();
  Field weights;
  const auto solve_for = [&](const std::optional<double>& share, int turn) {
    if (!pressed || problem.shares_load())
      solution.normal = solve_pressure(preconditioner.normal, problem, gap, share, normal,
                                       solution.normal.pressure);
    if (turn < turns_until_kept) weights = preconditioner.fitted_weights(solution.normal.pressure);
    if (!problem.frictionless())
      solve_tractions(preconditioner, problem, defect, tangential, weights, solution);
  };
  if (!problem.shares_load()) return solve_for(problem.load.force, 0);
  double share = pressure_share(grid, problem, solution);
  // A start from another load may be far away.
  if (!(share > 0.0)) share = frictionless_share(problem);
  PressureShare sharing;
  sharing.load = *problem.load.force;
  sharing.tolerance = shared_to;
  sharing.largest_share = largest_share;
  sharing.solve(share, [&](double pressing, int turn) {
    solve_for(pressing, turn);
    return pressure_share(grid, problem, solution);
  });
}

}  // namespace

void solve_on_halfspace(const Preconditioner& preconditioner, const PointProblem& problem,
                        double tolerance, ContactState& solution) {
  solve_in_turn(preconditioner, problem, nullptr, {}, tolerance, true, solution);
}

void solve_on_halfspace(const Preconditioner& preconditioner, const PointProblem& problem,
                        const Response& defect, double tolerance, ContactState& solution) {
  NormalOptions normal;
  normal.tolerance = std::min(normal.tolerance, 0.1 * tolerance);
  const double tangential = std::min(TangentialOptions().tolerance, 0.1 * tolerance);
  solve_in_turn(preconditioner, problem, &defect, normal, tangential, false, solution);
}

void set_frictionless(const ContactGrid& grid, TangentialSolution& tangential,
                      const Field& pressure, const TangentialField& slip) {
  const Field zero = Field::Zero(grid.size());
  tangential.traction = {zero, zero};
  tangential.bound = zero;
  tangential.slip = slip.x.size() == 0 ? TangentialField{zero, zero} : slip;
  tangential.state.clear();
  for (const double p : pressure)
    tangential.state.push_back(p > 0.0 ? ElementState::slip : ElementState::exterior);
}

}  // namespace rollfem::contact
