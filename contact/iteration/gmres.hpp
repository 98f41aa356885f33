// SPDX-License-Identifier: LGPL-2.1-or-later
// Restarted GMRES with right preconditioning for matrix-free linear systems (Saad & Schultz 1986),
// in memory reused from one system to the next.
#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::contact {

struct GmresOptions {
  double tolerance = 1e-2;  ///< on the true residual, relative to the right-hand side
  int max_iterations = 400;
  int restart = 80;
};

struct GmresResult {
  int iterations = 0;
  double residual = 0.0;  ///< relative
  bool converged = false;
};

class Gmres {
 public:
  using Vector = Eigen::Ref<Eigen::VectorXd>;
  using Given = Eigen::Ref<const Eigen::VectorXd>;

  /// Solves A x = b from x = 0, minimising the residual over x = M y. `matrix(x, y)` and
  /// `preconditioner(x, y)` set y.
  template <class Matrix, class Preconditioner>
  GmresResult solve(const Matrix& matrix, const Preconditioner& preconditioner,
                    const Given& right_hand_side, const GmresOptions& options, Vector solution) {
    GmresResult result;
    solution.setZero();
    const double scale = right_hand_side.norm();
    if (scale == 0.0) {
      result.converged = true;
      return result;
    }
    n_ = right_hand_side.size();
    while (result.iterations < options.max_iterations) {
      const int capacity = std::min(options.restart, options.max_iterations - result.iterations);
      reserve(capacity);
      auto change = change_.head(n_);
      if (result.iterations == 0) {
        begin(right_hand_side);
      } else {
        matrix(solution, change);
        change = right_hand_side - change;
        begin(change);
      }
      bool growing = true;
      while (growing && size_ < capacity && residual_norm() > options.tolerance * scale) {
        preconditioner(basis_.col(size_).head(n_), change);
        matrix(change, basis_.col(size_ + 1).head(n_));
        growing = extend();
        ++result.iterations;
      }
      combine();
      preconditioner(basis_.col(size_).head(n_), change);
      solution += change;
      result.residual = residual_norm() / scale;
      result.converged = result.residual <= options.tolerance;
      if (result.converged || !growing) return result;
    }
    return result;
  }

 private:
  void reserve(int capacity) {
    if (basis_.rows() < n_ || basis_.cols() < capacity + 1) {
      basis_.resize(std::max(n_, basis_.rows()),
                    std::max<Eigen::Index>(capacity + 1, basis_.cols()));
      change_.resize(basis_.rows());
    }
    if (triangle_.cols() >= capacity) return;
    triangle_.resize(capacity + 1, capacity);
    projected_.resize(capacity + 1);
    correction_.resize(capacity + 1);
    rotations_.reserve(static_cast<std::size_t>(capacity));
  }

  /// One Arnoldi cycle: an orthonormal basis of the Krylov space of A M, the Hessenberg matrix,
  /// made triangular by Givens rotations as it grows, and the residual.
  void begin(const Given& residual) {
    size_ = 0;
    rotations_.clear();
    projected_.setZero();
    projected_[0] = residual.norm();
    basis_.col(0).head(n_) = residual / projected_[0];
  }

  double residual_norm() const { return std::abs(projected_[size_]); }

  /// Adds A M times the last basis vector, stored in the next column. False when the space is
  /// exhausted.
  bool extend() {
    const Eigen::Index k = size_++;
    const auto known = basis_.topLeftCorner(n_, k + 1);
    auto image = basis_.col(k + 1).head(n_);
    auto h = triangle_.col(k).head(k + 1);
    const double before = image.norm();
    h.noalias() = known.transpose() * image;
    image.noalias() -= known * h;
    // Classical Gram-Schmidt keeps orthogonality when repeated after heavy cancellation.
    if (image.norm() < 0.1 * before) {
      auto correction = correction_.head(k + 1);
      correction.noalias() = known.transpose() * image;
      image.noalias() -= known * correction;
      h += correction;
    }
    const double norm = image.norm();
    triangle_(k + 1, k) = norm;
    rotate(k);
    if (!(norm > 1e-14 * before)) return false;
    image /= norm;
    return true;
  }

  void rotate(Eigen::Index k) {
    auto column = triangle_.col(k);
    for (Eigen::Index i = 0; i < k; ++i)
      column.applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[k], column[k + 1]);
    column.applyOnTheLeft(k, k + 1, rotation.adjoint());
    projected_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations_.push_back(rotation);
  }

  /// The combination of the basis with the smallest residual, in the column after the basis.
  void combine() {
    auto y = correction_.head(size_);
    y = projected_.head(size_);
    triangle_.topLeftCorner(size_, size_).triangularView<Eigen::Upper>().solveInPlace(y);
    basis_.col(size_).head(n_).noalias() = basis_.topLeftCorner(n_, size_) * y;
  }

  Eigen::Index n_ = 0;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd basis_, triangle_;
  Eigen::VectorXd projected_, correction_, change_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
};

}  // namespace rollfem::contact
