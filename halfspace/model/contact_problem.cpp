#include "halfspace/model/contact_problem.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::halfspace {

using contact::ElementState;
using contact::Field;
using contact::Motion;
using contact::SurfaceField;
using contact::TangentialField;
using contact::UpwindOrder;

namespace {

/// Coupling converges by a factor of about beta^2 in adhesion and mu beta in slip an iteration.
constexpr int most_outer_iterations = 100;
constexpr int anderson_depth = 5;

/// The normal problem of a curved patch in terms of q = p cos, whose sum is the force along z:
/// (h + A p) / cos is the gap along z, which the approach closes by the same way everywhere.
class TiltedNormal : public contact::NormalOperator {
 public:
  TiltedNormal(const contact::NormalOperator& plane, const Field& cosine)
      : plane_(plane), cosine_(cosine) {}
  const contact::ContactGrid& grid() const override { return plane_.grid(); }
  Field apply(const Field& q) const override {
    return plane_.apply(q.cwiseQuotient(cosine_)).cwiseQuotient(cosine_);
  }
  Field precondition(const Field& residual) const override {
    return plane_.precondition(residual.cwiseProduct(cosine_)).cwiseProduct(cosine_);
  }

 private:
  const contact::NormalOperator& plane_;
  const Field& cosine_;
};

contact::NormalSolution solve_tilted(const contact::NormalOperator& plane,
                                     const ContactScene& scene, const NormalLoad& load,
                                     const Field& start) {
  const TiltedNormal tilted(plane, scene.cosine);
  const bool given = start.size() == scene.cosine.size();
  contact::NormalSolution solution = contact::solve_normal(
      tilted, {scene.undeformed_distance.cwiseQuotient(scene.cosine), load.force, load.approach},
      {}, given ? Field(start.cwiseProduct(scene.cosine)) : Field());
  solution.pressure = solution.pressure.cwiseQuotient(scene.cosine).eval();
  solution.gap = solution.gap.cwiseProduct(scene.cosine).eval();
  return solution;
}

}  // namespace

ContactProblem::ContactProblem(const contact::SolvableCompliance& whole,
                               const contact::SolvableCompliance& uncoupled, ContactScene scene)
    : whole_(whole), uncoupled_(uncoupled), scene_(std::move(scene)) {}

const contact::TangentialOperator& ContactProblem::tangential_operator(Motion motion,
                                                                       const Field& pressure) {
  if (motion == Motion::shift) return uncoupled_.shift();
  if (scene_.upwind_order == UpwindOrder::first || !scene_.fit_leading_edge)
    return uncoupled_.rolling(scene_.upwind_order);
  return fitted_.emplace(uncoupled_.rolling(UpwindOrder::first),
                         uncoupled_.rolling(UpwindOrder::second),
                         contact::upwind_weights(grid(), pressure));
}

const contact::NormalSolution& ContactProblem::press(const NormalLoad& load, const Field& start) {
  const bool known = pressed_.pressure.size() != 0 && load.force == pressed_load_.force &&
                     load.approach == pressed_load_.approach;
  if (known) return pressed_;
  if (scene_.given_pressure.size() != 0) {
    pressed_ = {};
    pressed_.pressure = scene_.given_pressure;
    pressed_.gap = Field::Zero(grid().size());
    pressed_.normal_force = pressed_.pressure.sum() * grid().element_area();
    pressed_.contact_elements = static_cast<int>((pressed_.pressure.array() > 0.0).count());
  } else if (scene_.cosine.size() != 0) {
    pressed_ = solve_tilted(uncoupled_.normal(), scene_, load, start);
  } else {
    pressed_ = contact::solve_normal(
        uncoupled_.normal(), {scene_.undeformed_distance, load.force, load.approach}, {}, start);
  }
  pressed_load_ = load;
  return pressed_;
}

const contact::NormalSolution& ContactProblem::press(const NormalLoad& load) {
  const Field none;
  return press(load, none);
}

ContactState ContactProblem::solve(const NormalLoad& load, const TangentialField& rigid_slip,
                                   Motion motion, const ContactState* start,
                                   const ContactAccuracy& accuracy) {
  if (scene_.friction == 0.0) return frictionless(load, rigid_slip, motion);
  return coupled() ? solve_coupled(load, rigid_slip, motion, start, accuracy)
                   : solve_uncoupled(load, rigid_slip, motion, start, accuracy);
}

ContactState ContactProblem::solve_uncoupled(const NormalLoad& load,
                                             const TangentialField& rigid_slip, Motion motion,
                                             const ContactState* start,
                                             const ContactAccuracy& accuracy) {
  ContactState state;
  state.normal = press(load, start ? start->normal.pressure : Field());
  contact::TangentialOptions options;
  options.tolerance = accuracy.tangential;
  state.tangential =
      contact::solve_tangential(tangential_operator(motion, press(load).pressure),
                                {scene_.friction * state.normal.pressure, rigid_slip}, options,
                                start ? start->tangential.traction : TangentialField());
  state.displacement = whole_.apply(state.traction());
  state.iterations = state.tangential.newton_steps;
  state.residual = std::max(state.normal.residual, state.tangential.residual);
  return state;
}

ContactState ContactProblem::solve_coupled(const NormalLoad& load,
                                           const TangentialField& rigid_slip, Motion motion,
                                           const ContactState* start,
                                           const ContactAccuracy& accuracy) {
  contact::CoupledProblem problem;
  problem.undeformed_distance = scene_.undeformed_distance;
  problem.normal_force = load.force;
  problem.approach = load.approach;
  problem.friction_coefficient = scene_.friction;
  problem.rigid_slip = rigid_slip;
  problem.given_pressure = scene_.given_pressure;
  const contact::Preconditioner uncoupled{uncoupled_, uncoupled_.normal(),
                                          tangential_operator(motion, press(load).pressure),
                                          scene_.upwind_order, motion};
  contact::OuterOptions options;
  options.tolerance = accuracy.coupled;
  options.max_iterations = most_outer_iterations;
  options.anderson_depth = anderson_depth;
  contact::CoupledSolution solution = contact::solve_coupled(
      whole_, uncoupled, problem, options, start ? start->defect : contact::Response(), {},
      start ? start->traction() : SurfaceField());
  ContactState state;
  state.normal = std::move(solution.normal);
  state.tangential = std::move(solution.tangential);
  state.displacement = std::move(solution.displacement);
  state.defect = std::move(solution.defect);
  state.iterations = solution.outer_iterations;
  state.residual = solution.residual;
  return state;
}

/// Without friction nothing adheres and tractions vanish; normal pressure on unlike materials still
/// moves the surfaces sideways.
ContactState ContactProblem::frictionless(const NormalLoad& load, const TangentialField& rigid_slip,
                                          Motion motion) {
  ContactState state;
  state.normal = press(load);
  const Field zero = Field::Zero(grid().size());
  state.tangential.traction = {zero, zero};
  state.displacement = whole_.apply(state.traction());
  state.tangential.slip = rigid_slip;
  if (coupled()) {
    const TangentialField u{state.displacement.x, state.displacement.y};
    const TangentialField moved =
        motion == Motion::shift ? u : contact::upwind_difference(grid(), u, scene_.upwind_order);
    state.tangential.slip.x += moved.x;
    state.tangential.slip.y += moved.y;
  }
  for (const double p : state.normal.pressure)
    state.tangential.state.push_back(p > 0.0 ? ElementState::slip : ElementState::exterior);
  state.residual = state.normal.residual;
  return state;
}

}  // namespace rollfem::halfspace
