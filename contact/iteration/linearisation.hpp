// SPDX-License-Identifier: LGPL-2.1-or-later
// The linearised friction problem at a Newton iterate, and what Newton's method needs of an
// elasticity.
#pragma once

#include "base/grid.hpp"

#include <vector>

namespace rollfem::contact {

/// Treatment of an element in the Jacobian J = (I - B) + B r T: B = I in adhesion, in slip B = (g /
/// |q|) (I - m n^T) with n = q / |q| and m = p / max(g, |p|) in place of n, which is the same at
/// the solution and much better on the way (Hueeber, Stadler & Wohlmuth 2008). A law that feels
/// slip adds -n times the change of g (friction_state.hpp).
struct Linearisation {
  std::vector<char> adheres;
  Eigen::VectorXd normal;  ///< n of the slipping elements
  Eigen::VectorXd left;    ///< m of the slipping elements
  Eigen::VectorXd factor;  ///< g / |q| of the slipping elements
};

/// A tangential operator T restricted to the elements in contact, as applied by Newton's method for
/// the friction problem, into the caller's memory. Vectors hold the x components, then the y
/// components.
class ElementOperator {
 public:
  using Vector = Eigen::Ref<Eigen::VectorXd>;
  using Given = Eigen::Ref<const Eigen::VectorXd>;

  virtual ~ElementOperator() = default;
  /// Mean diagonal entry of T, the scale of the projection parameter r = 1 / diagonal.
  virtual double diagonal() const = 0;
  /// result = T p.
  virtual void apply(const Given& p, Vector result) = 0;
  /// Prepares the approximate inverse of the Jacobian. `drag`: r c. `at` must outlive its use.
  virtual void linearise(const Linearisation& at, double r, double drag) = 0;
  /// result = J^-1 p, nearly.
  virtual void precondition(const Given& p, Vector result) = 0;
  /// Slower, but safe where `precondition` stalls the iteration.
  virtual void precondition_robustly(const Given& p, Vector result) {  // NOLINT(*-value-param)
    precondition(p, result);
  }
};

}  // namespace rollfem::contact
