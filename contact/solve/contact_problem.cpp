// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/contact_problem.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::contact {

namespace {

/// The half-space, whose second-order difference is fitted anew to the leading edge of every
/// pressure.
Preconditioner refitted(const SolvableCompliance& halfspace, UpwindOrder order,
                        const Compliance* coupled = nullptr) {
  return {halfspace, halfspace.normal(), halfspace.rolling(order),
          order,     Motion::rolling,    &halfspace.rolling(UpwindOrder::first),
          coupled};
}

/// The approach for a given force makes the mean gap under pressure vanish, without load the
/// smallest one. The residual of an outer iteration does not contain this mean, which on a few
/// elements may be the whole error.
void close_mean_gap(const PointProblem& problem, NormalSolution& normal) {
  const VerticalFrame& frame = problem.frame;
  const Field pressed = (normal.pressure.array() > 0.0).cast<double>();
  const Field to_vertical = frame.plane() ? Field(Field::Ones(pressed.size())) : frame.to_vertical;
  const Field vertical = normal.gap.cwiseProduct(to_vertical);
  const double mean = *problem.load.force > 0.0
                          ? vertical.dot(pressed) / std::max(1.0, pressed.sum())
                          : vertical.minCoeff();
  normal.gap -= mean * to_vertical.cwiseInverse();
  normal.approach += frame.plane() ? mean : mean * problem.load.direction[1];
}

}  // namespace

ContactProblem::ContactProblem(const Compliance& whole, const SolvableCompliance& halfspace,
                               ContactConditions conditions)
    : whole_(whole), halfspace_(halfspace), conditions_(std::move(conditions)) {}

bool ContactProblem::fitted(Motion motion) const {
  return motion == Motion::rolling && conditions_.upwind_order == UpwindOrder::second &&
         conditions_.fit_leading_edge;
}

const TangentialOperator& ContactProblem::tangential_operator(Motion motion,
                                                              const Field& pressure) {
  if (motion == Motion::shift) return halfspace_.shift();
  if (!fitted(motion)) return halfspace_.rolling(conditions_.upwind_order);
  return fitted_.emplace(halfspace_.rolling(UpwindOrder::first),
                         halfspace_.rolling(UpwindOrder::second), upwind_weights(grid(), pressure));
}

void ContactProblem::set_gap(const PointProblem& problem, ContactState& state) {
  if (!problem.presses()) return;
  const VerticalFrame& frame = problem.frame;
  NormalSolution& normal = state.normal;
  normal.gap = problem.conditions.undeformed_distance + state.displacement.n;
  if (frame.plane())
    normal.gap.array() -= normal.approach;
  else
    normal.gap -= normal.approach / problem.load.direction[1] * frame.to_vertical.cwiseInverse();
  if (problem.load.force) close_mean_gap(problem, normal);
}

const NormalSolution& ContactProblem::press(const NormalLoad& load, const Field& start) {
  if (pressed_.pressure.size() != 0 && load == pressed_load_) return pressed_;
  pressed_ = press_on_halfspace(halfspace_.normal(), {conditions_, load}, start);
  pressed_load_ = load;
  return pressed_;
}

ContactState ContactProblem::solve_problem(const PointProblem& problem, const ContactState* start,
                                           const ContactAccuracy& accuracy,
                                           const OuterCallback& each_iteration,
                                           const ForcedMotion* forced) {
  ContactState state;
  if (!conditions_.friction && is_halfspace()) {
    state = frictionless(problem);
  } else if (is_uncoupled()) {
    state = solve_uncoupled(problem, start, accuracy);
    if (each_iteration) each_iteration(state);
  } else {
    state = solve_coupled(problem, start, accuracy, each_iteration, forced);
  }
  state.tangential.slip.x *= problem.motion.slip_factor;
  state.tangential.slip.y *= problem.motion.slip_factor;
  set_gap(problem, state);
  return state;
}

ContactState ContactProblem::solve(const NormalLoad& load, const TangentialMotion& motion,
                                   const ContactState* start, const ContactAccuracy& accuracy,
                                   const OuterCallback& each_iteration) {
  return solve_problem({conditions_, load, motion}, start, accuracy, each_iteration);
}

ContactState ContactProblem::solve_for_force(const NormalLoad& load, const ForcedMotion& forced,
                                             const ContactState& start,
                                             const ContactAccuracy& accuracy,
                                             const OuterCallback& each_iteration) {
  if (!is_halfspace())
    return solve_problem({conditions_, load, forced.at(forced.search.start)}, &start, accuracy,
                         each_iteration, &forced);
  ContactState state = start;
  int iterations = 0;
  const ForceLaw law = [&](const Eigen::Vector2d& at) {
    state = solve(load, forced.at(at), &state, accuracy, each_iteration);
    iterations += state.iterations;
    return transmitted_by(grid(), conditions_, state);
  };
  state.unknowns = find_creepage(law, forced.wanted, forced.search).creepage;
  state.iterations = iterations;
  return state;
}

int ContactProblem::count_states(const ContactState& state, const TangentialMotion& motion) {
  constexpr double apart = 1e-3;  // of the largest bound
  const TangentialSolution& known = state.tangential;
  if (!known.feedback) return 1;
  const Field& pressure = state.normal.pressure;
  TangentialOptions options;
  options.other_branch = true;
  try {
    const TangentialProblem problem =
        tangential_problem(preconditioner(motion.motion, pressure), motion, conditions_.friction,
                           pressure, is_uncoupled() ? nullptr : &state.defect);
    const TangentialSolution other =
        solve_tangential(tangential_operator(motion.motion, pressure), problem, options);
    const double difference = (other.bound - known.bound).cwiseAbs().maxCoeff();
    return difference > apart * known.bound.maxCoeff() ? 2 : 1;
  } catch (const SolveError&) {  // none that stays
    return 1;
  }
}

ContactState ContactProblem::solve_frictionless(const NormalLoad& load,
                                                const ContactAccuracy& accuracy) {
  return solve_coupled({conditions_, load}, nullptr, accuracy, {});
}

ContactState ContactProblem::solve_uncoupled(const PointProblem& problem, const ContactState* start,
                                             const ContactAccuracy& accuracy) {
  const Motion motion = problem.motion.motion;
  ContactState state;
  state.normal = press(problem.load, start ? start->normal.pressure : Field());
  if (start) state.tangential.traction = start->tangential.traction;
  // All load points share one pressure unless friction carries a part of the load; then the leading
  // edge is located anew with every pressure.
  const UpwindOrder order = conditions_.upwind_order;
  const Preconditioner preconditioner =
      problem.shares_load() && fitted(motion)
          ? refitted(halfspace_, order)
          : Preconditioner{halfspace_, halfspace_.normal(),
                           tangential_operator(motion, state.normal.pressure), order, motion};
  solve_on_halfspace(preconditioner, problem, accuracy.tangential, state);
  state.displacement = whole_.apply(state.traction());
  state.iterations = state.tangential.newton_steps;
  state.residual = std::max(state.normal.residual, state.tangential.residual);
  return state;
}

Preconditioner ContactProblem::preconditioner(Motion motion, const Field& pressure) {
  const UpwindOrder order = conditions_.upwind_order;
  if (!is_halfspace() && fitted(motion))
    return refitted(halfspace_, order, conditions_.coupled_halfspace);
  return {halfspace_, halfspace_.normal(), tangential_operator(motion, pressure), order, motion};
}

ContactState ContactProblem::solve_coupled(const PointProblem& problem, const ContactState* start,
                                           const ContactAccuracy& accuracy,
                                           const OuterCallback& each_iteration,
                                           const ForcedMotion* forced) {
  const bool is_half = is_halfspace();
  ContactState state = contact::solve_coupled(
      whole_,
      preconditioner(problem.motion.motion, is_half ? press(problem.load).pressure : Field()),
      problem, accuracy.outer, start ? start->defect : Response(), each_iteration,
      start && is_half ? start->traction() : SurfaceField(), forced);
  if (problem.frictionless()) set_frictionless(grid(), state.tangential, state.normal.pressure, {});
  return state;
}

/// Without friction nothing adheres and tractions vanish; normal pressure on unlike materials still
/// moves the surfaces sideways.
ContactState ContactProblem::frictionless(const PointProblem& problem) {
  ContactState state;
  state.normal = press(problem.load);
  set_frictionless(grid(), state.tangential, state.normal.pressure, problem.motion.rigid_slip);
  state.displacement = whole_.apply(state.traction());
  if (!is_uncoupled()) {
    const TangentialField u{state.displacement.x, state.displacement.y};
    const TangentialField moved = problem.motion.motion == Motion::shift
                                      ? u
                                      : upwind_difference(grid(), u, conditions_.upwind_order);
    state.tangential.slip.x += moved.x;
    state.tangential.slip.y += moved.y;
  }
  state.residual = state.normal.residual;
  return state;
}

}  // namespace rollfem::contact
