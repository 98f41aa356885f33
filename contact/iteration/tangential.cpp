// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/tangential.hpp"

#include "contact/iteration/friction_newton.hpp"

#include <optional>

namespace rollfem::contact {

namespace {

using Eigen::Index;

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

/// A tangential operator of the whole grid, with an approximate inverse whose quality does not
/// depend on the grid.
class GridElements : public ElementOperator {
 public:
  GridElements(const TangentialOperator& compliance, const ContactElements& elements)
      : compliance_(compliance), elements_(elements) {}

  double diagonal() const override { return compliance_.diagonal(); }
  void apply(const Given& p, Vector result) override {
    result = elements_.gathered(compliance_.apply(elements_.scattered(p)));
  }
  void linearise(const Linearisation& at, double r, double drag) override {
    inverse_.emplace(compliance_, elements_, r, drag, at);
  }
  void precondition(const Given& p, Vector result) override { result = inverse_->times(p); }
  void precondition_surely(const Given& p, Vector result) override {
    result = inverse_->times_adhesion(p);
  }

 private:
  const TangentialOperator& compliance_;
  const ContactElements& elements_;
  std::optional<JacobianInverse> inverse_;
};

/// Bounds and states of the elements, and what their particles carry on.
void set_states(const FrictionNewton& newton, const ContactElements& elements, const Friction& law,
                const ContactGrid& grid, TangentialSolution& result) {
  const Index size = result.traction.x.size();
  const FrictionState& friction = newton.state();
  result.bound = Field::Zero(size);
  result.state.assign(static_cast<std::size_t>(size), ElementState::exterior);
  if (friction.has_memory()) result.coefficient = coefficients_of(law, grid);
  if (friction.hardens()) result.plastic = Field::Zero(size);
  for (Index e = 0; e < elements.count(); ++e) {
    const Index k = elements[e];
    const bool adheres = newton.adheres()[static_cast<std::size_t>(e)];
    result.bound[k] = newton.bound()[e];
    result.state[static_cast<std::size_t>(k)] = adheres              ? ElementState::adhesion
                                                : friction.yields(e) ? ElementState::plastic
                                                                     : ElementState::slip;
    if (friction.has_memory()) result.coefficient[k] = friction.coefficient(e);
    if (friction.hardens()) result.plastic[k] = friction.plastic(e);
  }
}

}  // namespace

TangentialSolution solve_tangential(const TangentialOperator& compliance,
                                    const TangentialProblem& problem,
                                    const TangentialOptions& options,
                                    const TangentialField& start) {
  check_problem(compliance, problem);
  const ContactElements elements(
      traction_bound(problem.friction, compliance.grid(), problem.pressure));
  GridElements on_elements(compliance, elements);
  const CoulombFriction none(0.0);
  const FrictionLaw& law = problem.friction ? *problem.friction : none;
  const FrictionProblem on_pressure{compliance.grid(),   problem.pressure,
                                    problem.rigid_slip,  law,
                                    problem.slip_factor, problem.past ? &*problem.past : nullptr};
  FrictionNewton newton;
  const FrictionNewton::Effort effort =
      newton.solve(on_elements, on_pressure, elements.grid_indices(), options, start);
  TangentialSolution result;
  result.traction = elements.scattered(newton.traction());
  const TangentialField displacement = compliance.apply(result.traction);
  result.slip = {problem.rigid_slip.x + displacement.x, problem.rigid_slip.y + displacement.y};
  set_states(newton, elements, problem.friction, compliance.grid(), result);
  result.newton_steps = effort.newton_steps;
  result.krylov_iterations = effort.krylov_iterations;
  result.residual = effort.residual;
  result.steepness = effort.steepness;
  result.feedback = effort.feedback;
  return result;
}

}  // namespace rollfem::contact
