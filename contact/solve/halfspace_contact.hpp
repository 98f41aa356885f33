// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves one contact problem on the half-space: pressure, then tractions, alternating where both
// carry the load. The difference between the elasticity and its half-space enters as a defect
// (defect_correction.hpp).
#pragma once

#include "contact/iteration/normal.hpp"
#include "contact/iteration/tangential.hpp"
#include "scene/scene.hpp"

#include <Eigen/Core>

#include <array>
#include <utility>

namespace rollfem::contact {

/// The half-space on the grid of an elasticity A, with the operators that the contact solvers use.
struct Preconditioner {
  const Compliance& whole;            ///< A_half
  const NormalOperator& normal;       ///< its normal block
  const TangentialOperator& rolling;  ///< D A_half,tt; A_half,tt for Motion::shift
  UpwindOrder upwind_order;
  Motion motion = Motion::rolling;
  /// D A_half,tt of first order: with it a `rolling` of second order is fitted to the leading edge
  /// of every pressure (contact/iteration/leading_edge.hpp). Null: `rolling` is used unchanged.
  const TangentialOperator* first_order = nullptr;
  /// A_half with the coupling of unlike materials. The coupling has no kink at the leading edge and
  /// is not fitted to it. Null: like materials.
  const Compliance* coupled = nullptr;

  /// The weights of that fit; empty where `rolling` is used unchanged.
  Field fitted_weights(const Field& pressure) const;
};

/// Local normals relative to the direction of the load on a curved patch. The bodies approach each
/// other along the load, distance and displacement are along the normal: a gap along the load is
/// `to_vertical` times the gap along the normal, and in terms of q = carried p, whose sum is the
/// force along the load, the normal problem stays symmetric and independent of the choice of origin
/// on the surface. Both empty in the plane; `carried` empty where the grid is the projection of the
/// surface along the load, whose elements carry their full pressure.
struct VerticalFrame {
  Field to_vertical;
  Field carried;

  bool plane() const { return to_vertical.size() == 0; }
};
VerticalFrame vertical_frame(const PatchShape& shape, const std::array<double, 2>& direction);

/// Conditions common to all load points.
struct ContactConditions {
  Field undeformed_distance;    ///< mm; ignored with a given pressure
  Field given_pressure;         ///< MPa, replaces the normal problem; may be empty
  Friction friction = nullptr;  ///< null: frictionless
  UpwindOrder upwind_order = UpwindOrder::second;
  PatchShape shape{};  ///< empty: plane
  /// Second-order differences fitted to the leading edge (leading_edge.hpp): forces converge with
  /// second order and tractions do not zigzag from row to row. false: the same difference
  /// everywhere.
  bool fit_leading_edge = true;
  /// The half-space with the coupling of unlike materials; null: like materials.
  const Compliance* coupled_halfspace = nullptr;
};

/// The problem of one load point for any compliance. On a curved patch (PatchShape) approach and
/// load refer to the patch frame, while distance, tractions and displacement are along the local
/// normal and tangents.
struct PointProblem {
  PointProblem(const ContactConditions& of_all, NormalLoad of_point, TangentialMotion moves = {})
      : conditions(of_all),
        load(of_point),
        motion(std::move(moves)),
        frame(vertical_frame(of_all.shape, load.direction)) {}

  const ContactConditions& conditions;
  NormalLoad load;
  TangentialMotion motion;  ///< empty rigid slip: frictionless
  VerticalFrame frame;      ///< of the shape and the direction of the load

  bool presses() const { return conditions.given_pressure.size() == 0; }
  bool frictionless() const { return motion.rigid_slip.x.size() == 0 || !conditions.friction; }
  /// Whether friction carries a part of the prescribed force.
  bool shares_load() const {
    return load.force && presses() && (conditions.shape.climb.size() != 0 || load.is_tilted());
  }
};

/// The state of a contact: the solution of one problem, and the start of the next one.
struct ContactState {
  NormalSolution normal;
  TangentialSolution tangential;     ///< fields of size 0 while frictionless
  SurfaceField displacement;         ///< wheel minus rail, mm, by all tractions
  TangentialField curvature_slip{};  ///< Response::curvature_slip; empty for straight streamlines
  Response defect;     ///< difference between the elasticity and its half-space; may be empty
  int iterations = 0;  ///< Newton steps, or outer iterations
  double residual = 0.0;
  Eigen::Vector2d unknowns = Eigen::Vector2d::Zero();  ///< creepages (shifts) found for a force

  SurfaceField traction() const {
    return {tangential.traction.x, tangential.traction.y, normal.pressure};
  }
};

/// Zero of a response.
Response zero_response(Eigen::Index size);

/// Slip (displacement in a shift) that a defect of the compliance adds to the rigid slip under this
/// pressure, by the same difference as the half-space's, so that the sum is the slip of the whole
/// compliance.
TangentialField defect_slip(const Preconditioner& preconditioner, double curvature_weight,
                            const Response& defect, const Field& pressure);

/// Friction under this pressure, with the slip of a defect, which may be null.
TangentialProblem tangential_problem(const Preconditioner& preconditioner,
                                     const TangentialMotion& motion, const Friction& friction,
                                     const Field& pressure, const Response* defect);

/// Force on the wheel along the direction of the load, N.
double force_along_load(const ContactGrid& grid, const PointProblem& problem,
                        const ContactState& solution);

/// Pressure without friction.
NormalSolution press_on_halfspace(const NormalOperator& normal, const PointProblem& problem,
                                  const Field& start);

/// Tractions under the pressure of `solution`; where friction carries a part of the load, both
/// alternately until the load is met to 1e-10. On entry `solution` holds the pressure of
/// press_on_halfspace and a guess of the tractions.
void solve_on_halfspace(const Preconditioner& preconditioner, const PointProblem& problem,
                        double tolerance, ContactState& solution);

/// The same with a defect, starting from the contents of `solution`; `tolerance` is that of the
/// outer iteration.
void solve_on_halfspace(const Preconditioner& preconditioner, const PointProblem& problem,
                        const Response& defect, double tolerance, ContactState& solution);

/// Zero tractions, slipping wherever there is pressure. `slip` may be empty: 0.
void set_frictionless(const ContactGrid& grid, TangentialSolution& tangential,
                      const Field& pressure, const TangentialField& slip);

}  // namespace rollfem::contact
