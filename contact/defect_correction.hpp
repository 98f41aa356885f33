// Contact on any compliance A by defect correction on the half-space A_half: solve with A_half, put
// (A - A_half) p in as an extra gap and displacement, repeat with Anderson acceleration. The fixed
// point is the solution with A; A_half only preconditions. One outer iteration is one A.apply().
#pragma once

#include "contact/normal.hpp"
#include "contact/progress.hpp"
#include "contact/tangential.hpp"

namespace rollfem::contact {

/// The solvable stand-in for A: the half-space on the same grid.
struct Preconditioner {
  const Compliance& whole;            ///< A_half
  const NormalOperator& normal;       ///< its normal block
  const TangentialOperator& rolling;  ///< D A_half,tt
  UpwindOrder upwind_order;
};

struct OuterOptions {
  double tolerance = 1e-4;  ///< on the defect's change, relative to approach and creepage load
  int max_iterations = 40;
  int anderson_depth = 3;
};

/// On a curved patch (`shape`) the approach and the force are vertical, while distance, tractions
/// and displacement are along the local normal and tangents.
struct CoupledProblem {
  Field undeformed_distance;
  std::optional<double> normal_force;
  std::optional<double> approach;
  double friction_coefficient = 0.0;
  TangentialField rigid_slip;  ///< empty: frictionless
  PatchShape shape;            ///< empty: plane
};

struct CoupledSolution {
  NormalSolution normal;
  TangentialSolution tangential;  ///< fields of size 0 when frictionless
  SurfaceField displacement;      ///< A p at the solution
  Response defect;                ///< (A - A_half) p: a start for the next load point
  int outer_iterations = 0;
  double residual = 0.0;
};

using OuterCallback = std::function<void(const CoupledSolution&)>;

/// Throws SolveError when the outer iteration does not converge.
CoupledSolution solve_coupled(const Compliance& compliance, const Preconditioner& halfspace,
                              const CoupledProblem& problem, const OuterOptions& options = {},
                              const Response& start_defect = {},
                              const OuterCallback& each_iteration = {});

}  // namespace rollfem::contact
