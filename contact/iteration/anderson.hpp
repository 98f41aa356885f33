// SPDX-License-Identifier: LGPL-2.1-or-later
// Anderson acceleration of a fixed-point iteration d <- F(d) (Anderson 1965; Walker & Ni 2011,
// algorithm AA): the next iterate minimises the linearised residual over the last few steps.
#pragma once

#include <Eigen/Core>

#include <deque>
#include <functional>

namespace rollfem::contact {

class Anderson {
 public:
  using Product = std::function<double(const Eigen::VectorXd&, const Eigen::VectorXd&)>;

  /// `depth` 0 is the plain iteration. `product` belongs to the norm of residuals, Euclid's if
  /// empty.
  explicit Anderson(int depth, Product product = {});

  /// Next iterate from the iterate d and its image F(d).
  Eigen::VectorXd next(const Eigen::VectorXd& iterate, const Eigen::VectorXd& image);

  /// The map has changed a little: old steps still hold, but none leads from the last iterate to
  /// the next one.
  void interrupt() { last_residual_.resize(0); }

  /// Forgets the history: after a change of the problem or when the residual has grown.
  void restart();

 private:
  void remember_step(Eigen::VectorXd residual_step, Eigen::VectorXd image_step);

  int depth_;
  Product product_;
  std::deque<Eigen::VectorXd> residual_steps_, image_steps_;
  Eigen::MatrixXd products_;  ///< of the steps of residuals
  Eigen::VectorXd last_residual_, last_image_;
};

}  // namespace rollfem::contact
