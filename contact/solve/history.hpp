// What a step of a shift or of transient rolling inherits from earlier steps: the displacement
// difference of the material points now in the patch. Each step is then a tangential problem of its
// own, T = A_tt, with slip measured in mm (Kalker 1990, section 4.1).
#pragma once

#include "contact/solve/compliance.hpp"

namespace rollfem::contact {

/// A step as the tangential solver sees it: |w'| = 0 in adhesion, w' = rigid_slip + A_tt p in mm.
struct StepProblem {
  TangentialField rigid_slip;  ///< mm
  /// Slip as results give it is this times w': 1 for a shift (mm slipped in the step), 1/mm for
  /// rolling (slip relative to the rolling speed).
  double slip_factor = 1.0;
};

/// Displacements of the last two steps, in the frame of the contact.
class History {
 public:
  /// `order`: of the difference in time of transient rolling. First: (u - u') over the step.
  /// Second: (3 u - 4 u' + u'')/2, which tends to the steady solution of second-order upwind
  /// differences; from the third of equal steps on, since the displacement may jump in the first (a
  /// force that is there at once) and u'' before the jump would throw the second step beyond.
  /// Shifts always compare with the step before.
  History(const ContactGrid& grid, UpwindOrder order);

  /// A shift by `rigid_shift` (mm): w = W + u - u'.
  StepProblem shift_step(const TangentialField& rigid_shift) const;

  /// Rolling over `step_length` mm with the rigid slip s: w = step s + u(x) - u'(x + step). Throws
  /// InputError unless the step is positive.
  StepProblem rolling_step(const TangentialField& rigid_slip, double step_length) const;

  /// The step is solved: u = A p with all that caused it. `step_length` 0 for a shift.
  void advance(const TangentialField& displacement, double step_length);

 private:
  ContactGrid grid_;
  UpwindOrder order_;
  TangentialField last_;
  TangentialField before_last_;
  double last_step_ = 0.0;         ///< mm rolled in the last step
  double before_last_step_ = 0.0;  ///< and in the one before
};

/// Values at `distance` >= 0 upstream (+x) of every element, by cubics between the four nearest
/// elements of the row; beyond the grid the outermost value goes on.
Field upstream(const ContactGrid& grid, const Field& values, double distance);

}  // namespace rollfem::contact
