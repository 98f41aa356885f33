// SPDX-License-Identifier: LGPL-2.1-or-later
// The linearised friction problem at a Newton iterate, and an approximate inverse of its
// Jacobian that remains effective as the grid is refined.
#pragma once

#include "contact/base/grid.hpp"
#include "contact/iteration/compliance.hpp"

#include <vector>

namespace rollfem::contact {

/// The elements of a grid in contact, in order. Vectors on them hold the x components, then the y
/// components.
class ContactElements {
 public:
  /// Elements with positive `bound`.
  explicit ContactElements(const Field& bound);

  Eigen::Index count() const { return static_cast<Eigen::Index>(places_.size()); }
  /// Grid indices.
  const std::vector<Eigen::Index>& grid_indices() const { return places_; }
  Eigen::Index operator[](Eigen::Index e) const { return places_[static_cast<std::size_t>(e)]; }

  Eigen::VectorXd gathered(const TangentialField& field) const;
  /// Zero on all other elements.
  TangentialField scattered(const Eigen::VectorXd& values) const;

 private:
  Eigen::Index grid_size_;
  std::vector<Eigen::Index> places_;
};

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

/// Approximate inverse of J, block by block: r T + drag where elements adhere, then r T + drag +
/// (|q| / g - 1) across the slip where they slip, with the tractions of the first inserted, the
/// identity along the slip. Both blocks are inverted as if they covered the whole grid.
class JacobianInverse {
 public:
  /// `drag`: r c. All arguments must outlive this object.
  JacobianInverse(const TangentialOperator& compliance, const ContactElements& elements, double r,
                  double drag, const Linearisation& at);

  Eigen::VectorXd times(const Eigen::VectorXd& p) const;
  /// The same with the identity in all directions where elements slip.
  Eigen::VectorXd times_adhesion(const Eigen::VectorXd& p) const;

 private:
  Eigen::VectorXd adhering(const Eigen::VectorXd& p) const;
  void add_across(const Eigen::VectorXd& p, Eigen::VectorXd& result) const;

  const TangentialOperator& compliance_;
  const ContactElements& elements_;
  const Linearisation& at_;
  double r_;
  double drag_;
  Eigen::Index slipping_;
  double damping_ = 0.0;   ///< geometric mean of |q| / g - 1 over the slipping elements
  Eigen::VectorXd scale_;  ///< symmetric scaling to the common damping of slipping elements
};

/// Approximate inverse of r T on all contact elements.
Eigen::VectorXd full_adhesion(const TangentialOperator& compliance, const ContactElements& elements,
                              double r, const Eigen::VectorXd& p);

// A tangential operator T restricted to the elements in contact, as applied by Newton's method for
// the friction problem, into the caller's memory. Vectors hold the x components, then the y
// components.

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
  virtual void precondition_surely(const Given& p, Vector result) { precondition(p, result); }
};

}  // namespace rollfem::contact
