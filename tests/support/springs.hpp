// SPDX-License-Identifier: LGPL-2.1-or-later
// A tangential operator whose elements do not act on each other: problems with known solutions.
#pragma once

#include "contact/iteration/tangential.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// T = c I. With Coulomb's law, the solution is p = -Proj(s / c).
class Springs : public contact::TangentialOperator {
 public:
  Springs(const contact::ContactGrid& grid, double c) : grid_(grid), c_(c) {}
  const contact::ContactGrid& grid() const override { return grid_; }
  contact::TangentialField apply(const contact::TangentialField& p) const override {
    return {c_ * p.x, c_ * p.y};
  }
  double diagonal() const override { return c_; }
  contact::TangentialField precondition(const contact::TangentialField& residual, double r,
                                        double shift) const override {
    const double inverse = 1.0 / (r * c_ + shift);
    return {inverse * residual.x, inverse * residual.y};
  }

 private:
  contact::ContactGrid grid_;
  double c_;
};

}  // namespace rollfem::testing
