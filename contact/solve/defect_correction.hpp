// Contact on any compliance A by defect correction on the half-space A_half: solve with A_half, put
// (A - A_half) p in as an extra gap and displacement, repeat with Anderson acceleration. The fixed
// point is the solution with A; A_half only preconditions. One outer iteration is one A.apply().
#pragma once

#include "contact/base/progress.hpp"
#include "contact/solve/normal.hpp"
#include "contact/solve/tangential.hpp"

namespace rollfem::contact {

/// What the tangential operator gives: slip of steady rolling or relative displacement.
enum class Motion {
  rolling,  ///< slip w = s + D u, without a unit
  shift,    ///< slip w = s + u in mm: a step of a shift or of transient rolling
};

/// The solvable stand-in for A: the half-space on the same grid.
struct Preconditioner {
  const Compliance& whole;            ///< A_half
  const NormalOperator& normal;       ///< its normal block
  const TangentialOperator& rolling;  ///< D A_half,tt; A_half,tt for Motion::shift
  UpwindOrder upwind_order;
  Motion motion = Motion::rolling;
  /// D A_half,tt of first order: with it a `rolling` of second order is fitted to the leading edge
  /// of every pressure (contact/solve/leading_edge.hpp). Null: `rolling` is used as it is.
  const TangentialOperator* first_order = nullptr;
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
  Field given_pressure;        ///< MPa, replaces the normal problem; empty: none
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

/// Throws SolveError when the outer iteration does not converge. `start_traction` (may be empty):
/// pressure and tangential tractions to begin the first solution with the stand-in.
CoupledSolution solve_coupled(const Compliance& compliance, const Preconditioner& halfspace,
                              const CoupledProblem& problem, const OuterOptions& options = {},
                              const Response& start_defect = {},
                              const OuterCallback& each_iteration = {},
                              const SurfaceField& start_traction = {});

}  // namespace rollfem::contact
