// Second-order upwind differences that know where the patch begins. Material enters with a traction
// like sqrt(d), d the distance from the leading edge, so that the displacement ahead of the edge is
// a straight line plus c d^(3/2): the usual difference over the edge errs by sqrt(dx) in the slip
// of the leading element and by O(dx) in the forces. Weights that are exact for d^(3/2) there
// restore second order (Carter's problem: error in F_x from 0.37 % to 0.05 % of mu F_z at 40
// elements).
#pragma once

#include "contact/compliance.hpp"

namespace rollfem::contact {

/// kappa per element: D u_i = (1 + kappa) d_i - kappa d_{i+1} with d_i = (u_i - u_{i+1}) / dx. It
/// is 1/2, the usual second order, but for the leading element of every run of contact elements
/// (bound > 0) of a row: there kappa = 1 / (r - 2), r = ((2 - e) / (1 - e))^(3/2), with the edge e
/// elements ahead of the element's centre, the root of a line through the bound's square behind.
Field upwind_weights(const ContactGrid& grid, const Field& traction_bound);

/// T = D A_tt with these weights.
class EdgeFittedRolling : public TangentialOperator {
 public:
  /// `first` and `second` are D A_tt of these orders: the one is applied, the other preconditions.
  /// Both must outlive this.
  EdgeFittedRolling(const TangentialOperator& first, const TangentialOperator& second,
                    Field weights);

  const ContactGrid& grid() const override { return first_.grid(); }
  TangentialField apply(const TangentialField& traction) const override;
  double diagonal() const override { return second_.diagonal(); }
  TangentialField precondition(const TangentialField& residual, double r,
                               double shift) const override;

 private:
  Field combined(const Field& differences) const;

  const TangentialOperator& first_;
  const TangentialOperator& second_;
  Field weights_;
};

}  // namespace rollfem::contact
