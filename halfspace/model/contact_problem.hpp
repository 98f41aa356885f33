// The whole contact problem on one grid: normal contact, friction, and what couples them when the
// materials are unlike. One load after another is solved on operators that are made once.
#pragma once

#include "contact/solve/defect_correction.hpp"
#include "contact/solve/leading_edge.hpp"

#include <optional>

namespace rollfem::halfspace {

/// What stays the same from load to load.
struct ContactScene {
  contact::Field undeformed_distance;  ///< mm; not read with a given pressure
  contact::Field given_pressure;       ///< MPa, replaces the normal problem; empty: none
  double friction = 0.0;               ///< mu; 0: frictionless
  contact::UpwindOrder upwind_order = contact::UpwindOrder::second;
  /// Cosine of the angle between the elements' normals and z on a curved patch: the load and the
  /// approach are those along z. Empty: plane. Like materials only.
  contact::Field cosine{};
  /// Second-order differences fitted to the leading edge (contact/solve/leading_edge.hpp): forces
  /// converge with second order and tractions do not zigzag from row to row. false: the same
  /// difference everywhere.
  bool fit_leading_edge = true;
};

/// Exactly one of the two; not read with a given pressure.
struct NormalLoad {
  std::optional<double> force;     ///< N
  std::optional<double> approach;  ///< mm
};

struct ContactAccuracy {
  double tangential = 1e-6;  ///< residual of Newton's method, relative to the creepage load
  double coupled = 1e-6;     ///< change of the outer iteration of unlike materials
};

struct ContactState {
  contact::NormalSolution normal;
  contact::TangentialSolution tangential;
  contact::SurfaceField displacement;  ///< wheel minus rail, mm, by all tractions
  contact::Response defect;            ///< what coupling adds; empty for like materials
  int iterations = 0;                  ///< Newton steps, or outer iterations when coupled
  double residual = 0.0;

  contact::SurfaceField traction() const {
    return {tangential.traction.x, tangential.traction.y, normal.pressure};
  }
};

class ContactProblem {
 public:
  /// `whole` is the compliance with its normal-tangential coupling, `uncoupled` the one without,
  /// which preconditions it; the same object twice for like materials. Both must outlive this.
  ContactProblem(const contact::SolvableCompliance& whole,
                 const contact::SolvableCompliance& uncoupled, ContactScene scene);

  const contact::ContactGrid& grid() const { return whole_.grid(); }
  bool coupled() const { return &whole_ != &uncoupled_; }

  /// The normal problem without friction, kept for the last load. `start`: a pressure or empty.
  const contact::NormalSolution& press(const NormalLoad& load, const contact::Field& start);
  const contact::NormalSolution& press(const NormalLoad& load);

  /// Normal and tangential problem. `rigid_slip`: of steady rolling (no unit), or for
  /// Motion::shift what contact::History gives (mm). `start` (may be null): a state nearby. Throws
  /// SolveError when an iteration does not converge or nothing touches.
  ContactState solve(const NormalLoad& load, const contact::TangentialField& rigid_slip,
                     contact::Motion motion, const ContactState* start = nullptr,
                     const ContactAccuracy& accuracy = {});

 private:
  ContactState solve_uncoupled(const NormalLoad& load, const contact::TangentialField& rigid_slip,
                               contact::Motion motion, const ContactState* start,
                               const ContactAccuracy& accuracy);
  ContactState solve_coupled(const NormalLoad& load, const contact::TangentialField& rigid_slip,
                             contact::Motion motion, const ContactState* start,
                             const ContactAccuracy& accuracy);
  ContactState frictionless(const NormalLoad& load, const contact::TangentialField& rigid_slip,
                            contact::Motion motion);
  /// Rolling of second order is fitted to the leading edge of this pressure if the scene says so.
  const contact::TangentialOperator& tangential_operator(contact::Motion motion,
                                                         const contact::Field& pressure);

  const contact::SolvableCompliance& whole_;
  const contact::SolvableCompliance& uncoupled_;
  ContactScene scene_;
  NormalLoad pressed_load_;
  contact::NormalSolution pressed_;
  std::optional<contact::EdgeFittedRolling> fitted_;
};

}  // namespace rollfem::halfspace
