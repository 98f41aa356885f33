// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/solve/contact_problem.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::contact {

namespace {

/// The stand-in, whose second-order difference is fitted anew to the leading edge of every
/// pressure.
Preconditioner refitted(const SolvableCompliance& standin, UpwindOrder order,
                        const Compliance* coupled = nullptr) {
  return {standin, standin.normal(), standin.rolling(order),
          order,   Motion::rolling,  &standin.rolling(UpwindOrder::first),
          coupled};
}

/// The approach for a given force makes the mean gap under pressure vanish. The residual of an
/// outer iteration does not contain this mean, which on a few elements may be the whole error.
void take_up_mean(const NormalLoad& load, const VerticalFrame& frame, NormalSolution& normal) {
  const Field pressed = (normal.pressure.array() > 0.0).cast<double>();
  const Field to_vertical = frame.plane() ? Field(Field::Ones(pressed.size())) : frame.to_vertical;
  const double mean =
      normal.gap.cwiseProduct(to_vertical).dot(pressed) / std::max(1.0, pressed.sum());
  normal.gap -= mean * to_vertical.cwiseInverse();
  normal.approach += frame.plane() ? mean : mean * load.direction[1];
}

}  // namespace

ContactProblem::ContactProblem(const Compliance& whole, const SolvableCompliance& standin,
                               ContactConditions conditions)
    : whole_(whole), standin_(standin), conditions_(std::move(conditions)) {}

bool ContactProblem::fitted(Motion motion) const {
  return motion == Motion::rolling && conditions_.upwind_order == UpwindOrder::second &&
         conditions_.fit_leading_edge;
}

const TangentialOperator& ContactProblem::tangential_operator(Motion motion,
                                                              const Field& pressure) {
  if (motion == Motion::shift) return standin_.shift();
  if (!fitted(motion)) return standin_.rolling(conditions_.upwind_order);
  return fitted_.emplace(standin_.rolling(UpwindOrder::first),
                         standin_.rolling(UpwindOrder::second), upwind_weights(grid(), pressure));
}

void ContactProblem::set_gap(const NormalLoad& load, const Field& displacement,
                             NormalSolution& normal) const {
  if (conditions_.given_pressure.size() != 0) return;
  const VerticalFrame frame = vertical_frame(conditions_.shape, load.direction);
  Field& gap = normal.gap;
  gap = conditions_.undeformed_distance + displacement;
  if (frame.plane())
    gap.array() -= normal.approach;
  else
    gap -= normal.approach / load.direction[1] * frame.to_vertical.cwiseInverse();
  if (load.force) take_up_mean(load, frame, normal);
}

const NormalSolution& ContactProblem::press(const NormalLoad& load, const Field& start) {
  if (pressed_.pressure.size() != 0 && load == pressed_load_) return pressed_;
  pressed_ = press_standin(standin_.normal(), coupled_problem(load, {}, false), start);
  pressed_load_ = load;
  return pressed_;
}

CoupledProblem ContactProblem::coupled_problem(const NormalLoad& load,
                                               const TangentialMotion& motion,
                                               bool friction) const {
  CoupledProblem problem;
  problem.undeformed_distance = conditions_.undeformed_distance;
  problem.load = load;
  problem.given_pressure = conditions_.given_pressure;
  problem.shape = conditions_.shape;
  problem.frame = vertical_frame(conditions_.shape, load.direction);
  if (!friction) return problem;
  problem.friction = conditions_.friction;
  problem.slip_factor = motion.slip_factor;
  problem.rigid_slip = motion.rigid_slip;
  problem.curvature_weight = motion.curvature_weight;
  problem.past = motion.past;
  return problem;
}

ContactState ContactProblem::solve(const NormalLoad& load, const TangentialMotion& motion,
                                   const ContactState* start, const ContactAccuracy& accuracy,
                                   const OuterCallback& each_iteration) {
  const bool friction = conditions_.friction != nullptr;
  ContactState state;
  if (!friction && conditions_.same_normal_block)
    state = frictionless(load, motion);
  else if (coupled())
    state = solve_coupled(load, motion, start, accuracy, each_iteration, friction);
  else
    state = solve_uncoupled(load, motion, start, accuracy);
  state.tangential.slip.x *= motion.slip_factor;
  state.tangential.slip.y *= motion.slip_factor;
  set_gap(load, state.displacement.n, state.normal);
  return state;
}

ContactState ContactProblem::solve_for_force(const NormalLoad& load, const MotionAt& motion,
                                             const PrescribedForce& wanted,
                                             const ForceSearch& search, const ContactState& start,
                                             const ContactAccuracy& accuracy,
                                             const OuterCallback& each_iteration) {
  if (coupled() && !conditions_.same_normal_block) {
    const TangentialMotion first = motion(search.start);
    const ForcedSlip forced{wanted, search,
                            [&](const Eigen::Vector2d& at) { return motion(at).rigid_slip; }};
    ContactState state =
        solve_coupled(load, first, &start, accuracy, each_iteration, true, &forced);
    state.tangential.slip.x *= first.slip_factor;
    state.tangential.slip.y *= first.slip_factor;
    set_gap(load, state.displacement.n, state.normal);
    return state;
  }
  ContactState state = start;
  int iterations = 0;
  const ForceLaw law = [&](const Eigen::Vector2d& at) {
    state = solve(load, motion(at), &state, accuracy, each_iteration);
    iterations += state.iterations;
    const auto force = transmitted_force(grid(), state.traction(), conditions_.shape);
    return TransmittedForce{
        {force[0], force[1]},
        mean_coefficient(conditions_.friction, grid(), state.normal.pressure) * force[2]};
  };
  state.unknowns = find_creepage(law, wanted, search).creepage;
  state.iterations = iterations;
  return state;
}

int ContactProblem::count_states(const ContactState& state, const TangentialMotion& motion) {
  constexpr double apart = 1e-3;  // of the largest bound
  const TangentialSolution& known = state.tangential;
  if (!known.feedback) return 1;
  const Field& pressure = state.normal.pressure;
  TangentialField slip = motion.rigid_slip;
  if (coupled()) {
    CoupledProblem problem;
    problem.curvature_weight = motion.curvature_weight;
    const TangentialField more =
        defect_slip(preconditioner(motion.motion, pressure), problem, state.defect, pressure);
    slip.x += more.x;
    slip.y += more.y;
  }
  TangentialOptions options;
  options.other_branch = true;
  try {
    const TangentialSolution other = solve_tangential(
        tangential_operator(motion.motion, pressure),
        {pressure, slip, conditions_.friction, motion.slip_factor, motion.past}, options);
    const double difference = (other.bound - known.bound).cwiseAbs().maxCoeff();
    return difference > apart * known.bound.maxCoeff() ? 2 : 1;
  } catch (const SolveError&) {  // none that stays
    return 1;
  }
}

ContactState ContactProblem::solve_frictionless(const NormalLoad& load,
                                                const ContactAccuracy& accuracy) {
  return solve_coupled(load, {}, nullptr, accuracy, {}, false);
}

ContactState ContactProblem::solve_uncoupled(const NormalLoad& load, const TangentialMotion& motion,
                                             const ContactState* start,
                                             const ContactAccuracy& accuracy) {
  const CoupledProblem problem = coupled_problem(load, motion, true);
  CoupledSolution solution;
  solution.normal = press(load, start ? start->normal.pressure : Field());
  if (start) solution.tangential.traction = start->tangential.traction;
  // All load points share one pressure unless friction carries a part of the load; then the leading
  // edge is located anew with every pressure.
  const UpwindOrder order = conditions_.upwind_order;
  const Preconditioner standin =
      problem.shares_load() && fitted(motion.motion)
          ? refitted(standin_, order)
          : Preconditioner{standin_, standin_.normal(),
                           tangential_operator(motion.motion, solution.normal.pressure), order,
                           motion.motion};
  solve_standin(standin, problem, accuracy.tangential, solution);
  ContactState state;
  state.normal = std::move(solution.normal);
  state.tangential = std::move(solution.tangential);
  state.displacement = whole_.apply(state.traction());
  state.iterations = state.tangential.newton_steps;
  state.residual = std::max(state.normal.residual, state.tangential.residual);
  return state;
}

Preconditioner ContactProblem::preconditioner(Motion motion, const Field& pressure) {
  const UpwindOrder order = conditions_.upwind_order;
  if (!conditions_.same_normal_block && fitted(motion))
    return refitted(standin_, order, conditions_.coupled_standin);
  return {standin_, standin_.normal(), tangential_operator(motion, pressure), order, motion};
}

ContactState ContactProblem::solve_coupled(const NormalLoad& load, const TangentialMotion& motion,
                                           const ContactState* start,
                                           const ContactAccuracy& accuracy,
                                           const OuterCallback& each_iteration, bool friction,
                                           const ForcedSlip* forced) {
  const bool same_normal = conditions_.same_normal_block;
  const CoupledProblem problem = coupled_problem(load, motion, friction);
  const Preconditioner standin =
      preconditioner(motion.motion, same_normal ? press(load).pressure : Field());
  CoupledSolution solution = contact::solve_coupled(
      whole_, standin, problem, accuracy.outer, start ? start->defect : Response(), each_iteration,
      start && same_normal ? start->traction() : SurfaceField(), forced);
  ContactState state;
  state.normal = std::move(solution.normal);
  state.tangential = std::move(solution.tangential);
  state.displacement = std::move(solution.displacement);
  state.defect = std::move(solution.defect);
  state.unknowns = solution.unknowns;
  state.iterations = solution.outer_iterations;
  state.residual = solution.residual;
  if (!friction) set_frictionless(grid(), state.tangential, state.normal.pressure, {});
  return state;
}

/// Without friction nothing adheres and tractions vanish; normal pressure on unlike materials still
/// moves the surfaces sideways.
ContactState ContactProblem::frictionless(const NormalLoad& load, const TangentialMotion& motion) {
  ContactState state;
  state.normal = press(load);
  set_frictionless(grid(), state.tangential, state.normal.pressure, motion.rigid_slip);
  state.displacement = whole_.apply(state.traction());
  if (coupled()) {
    const TangentialField u{state.displacement.x, state.displacement.y};
    const TangentialField moved =
        motion.motion == Motion::shift ? u : upwind_difference(grid(), u, conditions_.upwind_order);
    state.tangential.slip.x += moved.x;
    state.tangential.slip.y += moved.y;
  }
  state.residual = state.normal.residual;
  return state;
}

}  // namespace rollfem::contact
