// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/anderson.hpp"

#include <Eigen/QR>

#include <cmath>
#include <utility>

namespace rollfem::contact {

Anderson::Anderson(int depth, Product product) : depth_(depth), product_(std::move(product)) {
  if (!product_)
    product_ = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.dot(b); };
}

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& iterate, const Eigen::VectorXd& image) {
  const Eigen::VectorXd residual = image - iterate;
  if (last_residual_.size() == residual.size() && depth_ > 0)
    remember_step(residual - last_residual_, image - last_image_);
  last_residual_ = residual;
  last_image_ = image;
  const Eigen::Index n = products_.rows();
  if (n == 0) return image;
  Eigen::VectorXd right(n);
  for (Eigen::Index k = 0; k < n; ++k) right[k] = product_(residual, residual_steps_[k]);
  // Rank-revealing, and of steps of equal length: near convergence they become short and parallel.
  const Eigen::VectorXd scale = products_.diagonal().unaryExpr(
      [](double square) { return square > 0.0 ? 1.0 / std::sqrt(square) : 0.0; });
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(scale.asDiagonal() * products_ *
                                                      scale.asDiagonal());
  factors.setThreshold(1e-10);
  const Eigen::VectorXd weights =
      scale.cwiseProduct(factors.solve(scale.cwiseProduct(right)).eval());
  Eigen::VectorXd accelerated = image;
  for (Eigen::Index k = 0; k < n; ++k) accelerated -= weights[k] * image_steps_[k];
  return accelerated;
}

void Anderson::remember_step(Eigen::VectorXd residual_step, Eigen::VectorXd image_step) {
  residual_steps_.push_back(std::move(residual_step));
  image_steps_.push_back(std::move(image_step));
  Eigen::Index n = products_.rows();
  if (n == depth_) {
    residual_steps_.pop_front();
    image_steps_.pop_front();
    --n;
    products_ = products_.bottomRightCorner(n, n).eval();
  }
  products_.conservativeResize(n + 1, n + 1);
  for (Eigen::Index k = 0; k <= n; ++k)
    products_(n, k) = products_(k, n) = product_(residual_steps_[n], residual_steps_[k]);
}

void Anderson::restart() {
  *this = Anderson(depth_, std::move(product_));
}

}  // namespace rollfem::contact
