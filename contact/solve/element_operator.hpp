// A tangential operator T restricted to the elements in contact, as Newton's method on the friction
// problem applies it, into memory of the caller. Vectors hold the x components, then the y
// components.
#pragma once

#include "contact/solve/linearisation.hpp"

namespace rollfem::contact {

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
  /// Slower, but sure where `precondition` brings the iteration to a standstill.
  virtual void precondition_surely(const Given& p, Vector result) { precondition(p, result); }
};

}  // namespace rollfem::contact
