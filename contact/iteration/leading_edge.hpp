// SPDX-License-Identifier: LGPL-2.1-or-later
// Second-order upwind differences that account for the position of the leading edge. Material
// enters with a traction like sqrt(d), d the distance behind the leading edge, and ahead of the
// edge u is a straight line plus c d^(3/2). The usual difference across the edge therefore acts as
// if the patch began at the border of its first element less 0.18 elements, wherever the edge lies
// in the element: a shift of O(dx) that differs from row to row. In adhesion it is carried along
// the whole row, so that tractions zigzag from row to row by O(sqrt(dx)) (docs/theory.md). One
// weight for each leading element, calibrated once on that local problem, puts the edge at its true
// position.
#pragma once

#include "contact/iteration/compliance.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::contact {

/// kappa per element: D u_i = (1 + kappa) d_i - kappa d_{i+1} with d_i = (u_i - u_{i+1}) / dx. It
/// is 1/2, the usual second order, except in the leading element of every run of contact elements
/// (pressure > 0, on any scale) of a row whose pressure falls to an edge like sqrt(d).
Field upwind_weights(const ContactGrid& grid, const Field& pressure);

/// The runs of contact elements in the rows of a grid. Memory is used again by the next grid.
class GridRuns {
 public:
  struct Run {
    int first;             ///< trailing element
    int last;              ///< leading element
    double beyond_border;  ///< edge ahead of the leading element's border, elements
    bool has_edge;         ///< the bound falls to zero as sqrt(d)
  };
  struct Row {
    const Run* first = nullptr;
    const Run* last = nullptr;
    const Run* begin() const { return first; }
    const Run* end() const { return last; }
  };

  void find(const ContactGrid& grid, const Field& bound);
  /// Empty beyond the grid.
  Row of_row(int j) const;

 private:
  std::vector<Run> runs_;
  std::vector<std::size_t> ends_;
};

/// The weights in memory of the caller.
void set_upwind_weights(const ContactGrid& grid, const Field& pressure, GridRuns& runs,
                        Field& weights);

/// The weight of a leading element whose edge lies `beyond_border` elements ahead of the element's
/// leading border, -0.75 to 0.75 (clamped): with it the discrete solution of a half-plane's
/// adhesion area has its edge there. From 1.1 at -0.75 to -0.3 at 0.75.
double leading_weight(double beyond_border);

/// Distance of the edge ahead of the leading border of each such leading element, in elements; 0
/// for all other elements and if unknown.
Field leading_edges(const ContactGrid& grid, const Field& pressure);

/// Weight of the difference of a layer between the bodies at a leading element: tractions held by a
/// layer alone grow as d, not as sqrt(d).
double layer_weight(double weight);

/// D u with these weights.
TangentialField fitted_difference(const ContactGrid& grid, const TangentialField& displacement,
                                  const Field& weights);

/// T = D A_tt with these weights.
class EdgeFittedRolling : public TangentialOperator {
 public:
  /// `first` and `second` are D A_tt of these orders: one is applied, the other preconditions. Both
  /// must outlive this object.
  EdgeFittedRolling(const TangentialOperator& first, const TangentialOperator& second,
                    Field weights);

  const ContactGrid& grid() const override { return first_.grid(); }
  TangentialField apply(const TangentialField& traction) const override;
  double diagonal() const override { return second_.diagonal(); }
  TangentialField precondition(const TangentialField& residual, double r,
                               double shift) const override;

 private:
  const TangentialOperator& first_;
  const TangentialOperator& second_;
  Field weights_;
  Field of_layer_;  ///< its compliance times the difference of its weights; empty: no layer
};

}  // namespace rollfem::contact
