#include "contact/solve/anderson.hpp"

#include <Eigen/QR>

namespace rollfem::contact {

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& iterate, const Eigen::VectorXd& image) {
  const Eigen::VectorXd residual = image - iterate;
  if (last_residual_.size() == residual.size() && depth_ > 0) {
    residual_steps_.push_back(residual - last_residual_);
    image_steps_.push_back(image - last_image_);
    if (static_cast<int>(residual_steps_.size()) > depth_) {
      residual_steps_.pop_front();
      image_steps_.pop_front();
    }
  }
  last_residual_ = residual;
  last_image_ = image;
  if (residual_steps_.empty()) return image;

  const auto columns = static_cast<Eigen::Index>(residual_steps_.size());
  Eigen::MatrixXd steps(residual.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) steps.col(k) = residual_steps_[k];
  // Rank-revealing: near convergence the steps become parallel.
  const Eigen::VectorXd weights = steps.colPivHouseholderQr().solve(residual);
  Eigen::VectorXd accelerated = image;
  for (Eigen::Index k = 0; k < columns; ++k) accelerated -= weights[k] * image_steps_[k];
  return accelerated;
}

void Anderson::restart() {
  residual_steps_.clear();
  image_steps_.clear();
  last_residual_.resize(0);
  last_image_.resize(0);
}

}  // namespace rollfem::contact
