// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction on a known pressure: find tractions with |p_t| <= g and slip w = s + T p such that p_t =
// -g w/|w| where it slips, g(p_n, |w|) the bound of the friction law, by a semi-smooth Newton
// method on p - Proj_{|.|<=g}(p - r w) = 0 with matrix-free Krylov inner solves; if it fails, the
// same with drag, w + c (p - p') with the previous traction p', which resembles time steps of
// rolling towards the steady state.
#pragma once

#include "base/errors.hpp"
#include "contact/iteration/compliance.hpp"
#include "contact/iteration/friction_state.hpp"
#include "result/result.hpp"

#include <optional>

namespace rollfem::contact {

/// Friction falls so steeply that no stable steady state was found. The text says where, and what
/// helps.
class NoSteadyFriction : public SolveError {
 public:
  using SolveError::SolveError;
};

struct TangentialOptions {
  double tolerance = 1e-6;        ///< relative to the creepage load, never to mu F
  int max_newton_steps = 200;     ///< in total
  int patience = 25;              ///< Newton steps without drag before drag is tried
  double krylov_tolerance = 0.1;  ///< loosest; tightened as Newton's method converges
  int max_krylov_iterations = 400;
  bool other_branch = false;  ///< than FrictionLaw::branch
};

struct FrictionEffort {
  int newton_steps = 0;
  int krylov_iterations = 0;
  double residual = 0.0;
  double steepness = 0.0;  ///< of the law (friction_state.hpp); 0 where it does not feel slip
  /// How much of a small change of all bounds comes back through the slip, below 1; empty where the
  /// law does not fall steeply enough for several solutions.
  std::optional<double> feedback;
};

struct TangentialSolution : FrictionEffort {
  TangentialField traction;         ///< MPa, on the wheel; |p_t| <= g
  TangentialField slip;             ///< w
  Field bound;                      ///< g, MPa
  std::vector<ElementState> state;  ///< exterior where g = 0 at rest
  Field coefficient;                ///< mu that particles carry on; at rest outside; empty: mu(w)
  Field plastic;                    ///< u* likewise, mm; empty where no yield stress changes
  int states = 1;  ///< that were looked for and found (ContactProblem::count_states)
};

/// Throws SolveError when Newton's method does not converge. `start`: initial tractions, empty for
/// the projected full-stick solution.
TangentialSolution solve_tangential(const TangentialOperator& compliance,
                                    const TangentialProblem& problem,
                                    const TangentialOptions& options = {},
                                    const TangentialField& start = {});

}  // namespace rollfem::contact
