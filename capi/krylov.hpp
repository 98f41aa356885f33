// GMRES in memory that is kept, with a preconditioner on the right.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace rollfem::capi {

class Krylov {
 public:
  Krylov(int most_unknowns, int most_steps)
      : basis_(most_unknowns, most_steps + 1),
        directions_(most_unknowns, most_steps),
        triangle_(most_steps + 1, most_steps),
        projected_(most_steps + 1),
        cosine_(most_steps),
        sine_(most_steps) {}

  /// Adds the solution of matrix * x = `right` to within `tolerance` of its norm, or what the steps
  /// there are come to, to `solution`. `matrix(x, y)` and `inverse(x, y)` set y; all vectors have n
  /// values. Returns the steps taken.
  template <class Matrix, class Inverse>
  int solve(const Matrix& matrix, const Inverse& inverse, const Eigen::Ref<Eigen::VectorXd>& right,
            double tolerance, Eigen::Ref<Eigen::VectorXd> solution) {
    const Eigen::Index n = right.size();
    const double scale = right.norm();
    if (!(scale > 0.0)) return 0;
    basis_.col(0).head(n) = right / scale;
    projected_.setZero();
    projected_[0] = scale;
    Eigen::Index size = 0;
    while (size < directions_.cols() && std::abs(projected_[size]) > tolerance * scale) {
      inverse(basis_.col(size).head(n), directions_.col(size).head(n));
      matrix(directions_.col(size).head(n), basis_.col(size + 1).head(n));
      if (!orthogonalise(size++, n)) break;
    }
    for (Eigen::Index k = size - 1; k >= 0; --k) {
      for (Eigen::Index i = k + 1; i < size; ++i) projected_[k] -= triangle_(k, i) * projected_[i];
      projected_[k] /= triangle_(k, k);
      solution += projected_[k] * directions_.col(k).head(n);
    }
    return static_cast<int>(size);
  }

 private:
  /// Column k of the triangle from the new basis vector. False when the space is exhausted.
  bool orthogonalise(Eigen::Index k, Eigen::Index n) {
    auto image = basis_.col(k + 1).head(n);
    const double before = image.norm();
    for (Eigen::Index i = 0; i <= k; ++i) {
      triangle_(i, k) = basis_.col(i).head(n).dot(image);
      image -= triangle_(i, k) * basis_.col(i).head(n);
    }
    const double norm = image.norm();
    for (Eigen::Index i = 0; i < k; ++i) rotate(i, triangle_(i, k), triangle_(i + 1, k));
    const double size = std::hypot(triangle_(k, k), norm);
    if (!(size > 0.0)) return false;
    cosine_[k] = triangle_(k, k) / size;
    sine_[k] = norm / size;
    triangle_(k, k) = size;
    rotate(k, projected_[k], projected_[k + 1]);
    if (!(norm > 1e-14 * before)) return false;
    image /= norm;
    triangle_(k + 1, k) = 0.0;
    return true;
  }

  void rotate(Eigen::Index k, double& upper, double& lower) const {
    const double above = cosine_[k] * upper + sine_[k] * lower;
    lower = cosine_[k] * lower - sine_[k] * upper;
    upper = above;
  }

  Eigen::MatrixXd basis_, directions_, triangle_;
  Eigen::VectorXd projected_, cosine_, sine_;
};

}  // namespace rollfem::capi
