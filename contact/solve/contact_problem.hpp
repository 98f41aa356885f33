// SPDX-License-Identifier: LGPL-2.1-or-later
// The complete contact problem on one grid: normal contact, friction, the sharing of the load
// between pressure and friction where surface or load are tilted, and defect correction where the
// elasticity differs from its half-space (unlike materials, finite elements). Successive loads
// reuse the same operators.
#pragma once

#include "contact/iteration/leading_edge.hpp"
#include "contact/solve/defect_correction.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace rollfem::contact {

struct ContactAccuracy {
  double tangential = 1e-6;  ///< residual of Newton's method, relative to the creepage load
  OuterOptions outer{1e-6, 600, 5};
};

class ContactProblem {
 public:
  /// `halfspace`: without coupling, on the same grid; `whole` itself for half-spaces of like
  /// materials. Both must outlive this object.
  ContactProblem(const Compliance& whole, const SolvableCompliance& halfspace,
                 ContactConditions conditions);

  const ContactGrid& grid() const { return halfspace_.grid(); }

  /// The normal problem without friction on the half-space, cached for the last load. `start`: a
  /// pressure or empty.
  const NormalSolution& press(const NormalLoad& load, const Field& start = {});

  /// Normal and tangential problem. `start` (may be null): a similar state. Throws SolveError when
  /// an iteration does not converge or without contact.
  ContactState solve(const NormalLoad& load, const TangentialMotion& motion,
                     const ContactState* start = nullptr, const ContactAccuracy& accuracy = {},
                     const OuterCallback& each_iteration = {});

  /// The same with a prescribed force: finds ContactState::unknowns. With an expensive elasticity
  /// the search runs within every outer iteration, otherwise around the solutions.
  ContactState solve_for_force(const NormalLoad& load, const ForcedMotion& forced,
                               const ContactState& start, const ContactAccuracy& accuracy,
                               const OuterCallback& each_iteration);

  /// 2 where a state of the other branch (FrictionBranch) was found beside the solved `state` of
  /// this motion, otherwise 1. Searched for only where the law falls steeply, under the pressure of
  /// the state and with its correction of the elasticity.
  int count_states(const ContactState& state, const TangentialMotion& motion);

  /// The elasticity's response to pressure only: start of the first load point.
  ContactState solve_frictionless(const NormalLoad& load, const ContactAccuracy& accuracy);

 private:
  ContactState solve_problem(const PointProblem& problem, const ContactState* start,
                             const ContactAccuracy& accuracy, const OuterCallback& each_iteration,
                             const ForcedMotion* forced = nullptr);
  ContactState solve_uncoupled(const PointProblem& problem, const ContactState* start,
                               const ContactAccuracy& accuracy);
  ContactState solve_coupled(const PointProblem& problem, const ContactState* start,
                             const ContactAccuracy& accuracy, const OuterCallback& each_iteration,
                             const ForcedMotion* forced = nullptr);
  ContactState frictionless(const PointProblem& problem);
  /// The gap along the normal recomputed with the whole elasticity, independent of the solver: from
  /// the undeformed distance, the displacement under all tractions and the approach.
  static void set_gap(const PointProblem& problem, ContactState& state);
  /// Fits second-order rolling to the leading edge of this pressure if the conditions request it.
  const TangentialOperator& tangential_operator(Motion motion, const Field& pressure);
  bool fitted(Motion motion) const;
  /// Half-spaces of like materials: pressure and friction are solved one after the other.
  bool is_uncoupled() const { return &whole_ == static_cast<const Compliance*>(&halfspace_); }
  /// Half-spaces, like or unlike: the pressure without friction is that of the uncoupled one.
  bool is_halfspace() const { return is_uncoupled() || &whole_ == conditions_.coupled_halfspace; }
  Preconditioner preconditioner(Motion motion, const Field& pressure);

  const Compliance& whole_;
  const SolvableCompliance& halfspace_;
  ContactConditions conditions_;
  NormalLoad pressed_load_;
  NormalSolution pressed_;
  std::optional<EdgeFittedRolling> fitted_;
};

}  // namespace rollfem::contact
