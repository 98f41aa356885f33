#include "contact/solve/gmres.hpp"

#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::contact {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One Arnoldi cycle: an orthonormal basis of the Krylov space of A M, the Hessenberg matrix made
/// triangular by Givens rotations as it grows, and the residual that goes with it.
class Cycle {
 public:
  Cycle(const VectorXd& residual, int capacity)
      : basis_(residual.size(), capacity + 1),
        triangle_(MatrixXd::Zero(capacity + 1, capacity)),
        projected_(VectorXd::Zero(capacity + 1)) {
    const double norm = residual.norm();
    basis_.col(0) = residual / norm;
    projected_[0] = norm;
  }

  int size() const { return size_; }
  double residual_norm() const { return std::abs(projected_[size_]); }
  auto last() const { return basis_.col(size_); }

  /// Takes in A M times the last basis vector. False when the space is exhausted.
  bool extend(VectorXd image) {
    const int k = size_;
    auto known = basis_.leftCols(k + 1);
    const double before = image.norm();
    VectorXd h = known.transpose() * image;
    image.noalias() -= known * h;
    // Classical Gram-Schmidt keeps orthogonality when repeated after heavy cancellation.
    if (image.norm() < 0.1 * before) {
      const VectorXd correction = known.transpose() * image;
      image.noalias() -= known * correction;
      h += correction;
    }
    const double norm = image.norm();
    triangle_.col(k).head(k + 1) = h;
    triangle_(k + 1, k) = norm;
    rotate(k);
    ++size_;
    if (!(norm > 1e-14 * before)) return false;
    basis_.col(k + 1) = image / norm;
    return true;
  }

  VectorXd combination() const {
    const auto triangle = triangle_.topLeftCorner(size_, size_).triangularView<Eigen::Upper>();
    const VectorXd y = triangle.solve(projected_.head(size_));
    return basis_.leftCols(size_) * y;
  }

 private:
  void rotate(int k) {
    for (int i = 0; i < k; ++i)
      triangle_.col(k).applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(triangle_(k, k), triangle_(k + 1, k));
    triangle_.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    projected_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations_.push_back(rotation);
  }

  MatrixXd basis_;
  MatrixXd triangle_;
  VectorXd projected_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  int size_ = 0;
};

}  // namespace

GmresResult gmres(const LinearMap& matrix, const LinearMap& preconditioner,
                  const VectorXd& right_hand_side, const GmresOptions& options) {
  GmresResult result;
  result.solution = VectorXd::Zero(right_hand_side.size());
  const double scale = right_hand_side.norm();
  VectorXd residual = right_hand_side;
  if (scale == 0.0) {
    result.converged = true;
    return result;
  }
  while (result.iterations < options.max_iterations) {
    Cycle cycle(residual, std::min(options.restart, options.max_iterations - result.iterations));
    const int capacity = std::min(options.restart, options.max_iterations - result.iterations);
    bool growing = true;
    while (growing && cycle.size() < capacity &&
           cycle.residual_norm() > options.tolerance * scale) {
      growing = cycle.extend(matrix(preconditioner(cycle.last())));
      ++result.iterations;
    }
    result.solution += preconditioner(cycle.combination());
    result.residual = cycle.residual_norm() / scale;
    result.converged = result.residual <= options.tolerance;
    if (result.converged || !growing) return result;
    residual = right_hand_side - matrix(result.solution);
  }
  return result;
}

}  // namespace rollfem::contact
