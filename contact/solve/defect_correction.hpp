// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact on any compliance A by defect correction on the half-space A_half: solve with A_half, add
// (A - A_half) p as an extra gap and displacement, repeat with Anderson acceleration. The fixed
// point is the solution with A; A_half only preconditions. One outer iteration is one A.apply(),
// also with a prescribed force: the half-space is solved for that force with the defect held fixed.
#pragma once

#include "contact/solve/halfspace_contact.hpp"
#include "contact/solve/prescribed_force.hpp"

#include <Eigen/Core>

#include <functional>

namespace rollfem::contact {

struct OuterOptions {
  double tolerance = 1e-4;  ///< on the defect's change, relative to approach and creepage load
  int max_iterations = 40;
  int anderson_depth = 3;  ///< 0: plain steps, for bodies that come into balance meanwhile
  /// Relative to the slip equivalent of the friction bound if that is less than the creepage load:
  /// needed by the search for a prescribed force, which is small at low friction.
  bool to_the_bound = false;
};

/// A prescribed tangential force instead of creepages (shifts).
struct ForcedMotion {
  /// The motion at creepages (shifts), which affect only the rigid slip.
  std::function<TangentialMotion(const Eigen::Vector2d& unknowns)> at;
  PrescribedForce wanted;
  ForceSearch search;
};

/// F_x, F_y and mu F_z of a state.
TransmittedForce transmitted_by(const ContactGrid& grid, const ContactConditions& conditions,
                                const ContactState& state);

using OuterCallback = std::function<void(const ContactState&)>;

/// Throws SolveError when the outer iteration does not converge, UnfitGrid when it does not because
/// the patch reaches the border of the grid. `start_traction` (may be empty): initial pressure and
/// tangential tractions of the first solution on the half-space. `forced` (may be null) replaces
/// the motion of the problem; every iteration then satisfies the force.
ContactState solve_coupled(const Compliance& compliance, const Preconditioner& preconditioner,
                           const PointProblem& problem, const OuterOptions& options = {},
                           const Response& start_defect = {},
                           const OuterCallback& each_iteration = {},
                           const SurfaceField& start_traction = {},
                           const ForcedMotion* forced = nullptr);

}  // namespace rollfem::contact
