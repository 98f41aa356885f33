// SPDX-License-Identifier: LGPL-2.1-or-later
// Restarted GMRES with right preconditioning for matrix-free linear systems (Saad & Schultz 1986),
// in memory reused from one system to the next.
#pragma once

#include "base/pieces.hpp"

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
    auto image = basis_.col(k + 1).head(n_);
    auto h = triangle_.col(k).head(k + 1);
    const double before = norm_of(image);
    project(image, h);
    double norm = subtract(h, image);
    // Classical Gram-Schmidt keeps orthogonality when repeated after heavy cancellation.
    if (norm < 0.1 * before) {
      auto correction = correction_.head(k + 1);
      project(image, correction);
      norm = subtract(correction, image);
      h += correction;
    }
    triangle_(k + 1, k) = norm;
    rotate(k);
    if (!(norm > 1e-14 * before)) return false;
    in_pieces(n_,
              [&](Eigen::Index first, Eigen::Index count) { image.segment(first, count) /= norm; });
    return true;
  }

  double norm_of(const Given& vector) const {
    return std::sqrt(sum_in_pieces(n_, [&](Eigen::Index first, Eigen::Index count) {
      return vector.segment(first, count).squaredNorm();
    }));
  }

  /// Products of the basis, as long as `products`, with a vector.
  void project(const Given& vector, Vector products) {
    const Eigen::Index size = products.size();
    if (n_ >= elements_for_threads) in_pieces_.setZero(size, most_pieces);
    in_pieces(n_, [&](Eigen::Index first, Eigen::Index count) {
      const auto part = basis_.block(first, 0, count, size).transpose();
      if (count == n_)
        products.noalias() = part * vector;
      else
        in_pieces_.col(first / piece_of(n_)).noalias() = part * vector.segment(first, count);
    });
    if (n_ >= elements_for_threads) products = in_pieces_.rowwise().sum();
  }

  /// Takes basis vectors times `factors` from a vector; returns its norm.
  double subtract(const Given& factors, Vector vector) {
    return std::sqrt(sum_in_pieces(n_, [&](Eigen::Index first, Eigen::Index count) {
      auto part = vector.segment(first, count);
      part.noalias() -= basis_.block(first, 0, count, factors.size()) * factors;
      return part.squaredNorm();
    }));
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
    in_pieces(n_, [&](Eigen::Index first, Eigen::Index count) {
      basis_.col(size_).segment(first, count).noalias() = basis_.block(first, 0, count, size_) * y;
    });
  }

  Eigen::Index n_ = 0;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd basis_, triangle_;
  Eigen::MatrixXd in_pieces_;  ///< products with the basis
  Eigen::VectorXd projected_, correction_, change_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
};

}  // namespace rollfem::contact
