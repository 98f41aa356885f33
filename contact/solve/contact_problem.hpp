// SPDX-License-Identifier: LGPL-2.1-or-later
// The complete contact problem on one grid: normal contact, friction, the sharing of the load
// between pressure and friction where surface or load are tilted, and defect correction where the
// elasticity differs from its solvable stand-in (unlike materials, finite elements). Successive
// loads reuse the same operators.
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

/// The motion at creepages (shifts), which affect only the rigid slip.
using MotionAt = std::function<TangentialMotion(const Eigen::Vector2d& unknowns)>;

class ContactProblem {
 public:
  /// `standin` is `whole`, or a half-space without coupling on the same grid as preconditioner.
  /// Both must outlive this object.
  ContactProblem(const Compliance& whole, const SolvableCompliance& standin,
                 ContactConditions conditions);

  const ContactGrid& grid() const { return standin_.grid(); }
  bool coupled() const { return &whole_ != static_cast<const Compliance*>(&standin_); }
  const PatchShape& shape() const { return conditions_.shape; }

  /// The normal problem without friction on the stand-in, cached for the last load. `start`: a
  /// pressure or empty.
  const NormalSolution& press(const NormalLoad& load, const Field& start = {});

  /// Normal and tangential problem. `start` (may be null): a similar state. Throws SolveError when
  /// an iteration does not converge or without contact.
  ContactState solve(const NormalLoad& load, const TangentialMotion& motion,
                     const ContactState* start = nullptr, const ContactAccuracy& accuracy = {},
                     const OuterCallback& each_iteration = {});

  /// The same with a prescribed force: finds ContactState::unknowns. With an expensive elasticity
  /// the search runs within every outer iteration, otherwise around the solutions.
  ContactState solve_for_force(const NormalLoad& load, const MotionAt& motion,
                               const PrescribedForce& wanted, const ForceSearch& search,
                               const ContactState& start, const ContactAccuracy& accuracy,
                               const OuterCallback& each_iteration);

  /// 2 where a state of the other branch (FrictionBranch) was found beside the solved `state` of
  /// this motion, otherwise 1. Searched for only where the law falls steeply, under the pressure of
  /// the state and with its correction of the elasticity.
  int count_states(const ContactState& state, const TangentialMotion& motion);

  /// The elasticity's response to pressure only: start of the first load point.
  ContactState solve_frictionless(const NormalLoad& load, const ContactAccuracy& accuracy);

 private:
  ContactState solve_problem(const CoupledProblem& problem, const ContactState* start,
                             const ContactAccuracy& accuracy, const OuterCallback& each_iteration,
                             const ForcedSlip* forced = nullptr);
  ContactState solve_uncoupled(const CoupledProblem& problem, const ContactState* start,
                               const ContactAccuracy& accuracy);
  ContactState solve_coupled(const CoupledProblem& problem, const ContactState* start,
                             const ContactAccuracy& accuracy, const OuterCallback& each_iteration,
                             const ForcedSlip* forced = nullptr);
  ContactState frictionless(const CoupledProblem& problem);
  /// The gap along the normal recomputed with the whole elasticity, independent of the solver: from
  /// the undeformed distance, the displacement under all tractions and the approach.
  static void set_gap(const CoupledProblem& problem, ContactState& state);
  CoupledProblem problem_of(const NormalLoad& load, const TangentialMotion& motion = {}) const {
    return {conditions_, load, motion, vertical_frame(conditions_.shape, load.direction)};
  }
  /// Fits second-order rolling to the leading edge of this pressure if the conditions request it.
  const TangentialOperator& tangential_operator(Motion motion, const Field& pressure);
  bool fitted(Motion motion) const;
  /// The stand-in has the normal block of the whole elasticity, as for unlike half-spaces.
  bool same_normal_block() const { return !coupled() || &whole_ == conditions_.coupled_standin; }
  Preconditioner preconditioner(Motion motion, const Field& pressure);

  const Compliance& whole_;
  const SolvableCompliance& standin_;
  ContactConditions conditions_;
  NormalLoad pressed_load_;
  NormalSolution pressed_;
  std::optional<EdgeFittedRolling> fitted_;
};

}  // namespace rollfem::contact
