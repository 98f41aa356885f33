// Two elastic half-planes in plane strain as a compliance: line contact of rollers, on a contact
// grid of one row. Influence coefficients in closed form (the half-space's integrated along y:
// Johnson 1985, eq. 2.30 to 2.33), dense matrices: exact, and quick up to some thousand elements.
#pragma once

#include "contact/scene/geometry.hpp"
#include "contact/solve/compliance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <utility>

namespace rollfem::testing {

/// Aluminium on steel.
inline contact::CombinedMaterial unlike() {
  return contact::combine({70e3, 0.33}, {210e3, 0.28});
}

/// Each component of each element from -1 to 1.
inline contact::SurfaceField random_traction(int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto field = [&] {
    return contact::Field(contact::Field::NullaryExpr(n, [&] { return number(generator); }));
  };
  return {field(), field(), field()};
}

/// Half-planes under tractions that do not change with y. The grid has one row (ny = 1); its dy is
/// the length of roller that forces are for: dy = 1 gives N/mm. u_y is that of antiplane shear.
///
/// A half-plane has no fixed point at infinity: displacements are relative to what a traction
/// causes at the distance `reference` from it, which the approach and shift depend on and nothing
/// else does. It must exceed the length of the grid for A to be positive; 0 takes ten of them.
class LineCompliance : public contact::SolvableCompliance {
 public:
  LineCompliance(const contact::ContactGrid& grid, const contact::CombinedMaterial& material,
                 double reference = 0.0)
      : grid_(grid),
        reference_(reference > 0.0 ? reference : 10.0 * grid.nx * grid.dx),
        scale_(2.0 * (1.0 - material.poisson_ratio) / (M_PI * material.shear_modulus)),
        antiplane_(1.0 / (1.0 - material.poisson_ratio)) {
    plane_ = toeplitz([this](int k) { return influence(k); });
    const double k_over_g = material.difference / material.shear_modulus;
    coupling_ = toeplitz(
        [&](int k) { return -k_over_g * grid.dx * (std::abs(k + 0.5) - std::abs(k - 0.5)); });
    normal_ = std::make_unique<Normal>(grid_, plane_);
    shift_ = std::make_unique<Tangential>(grid_, plane_, antiplane_ * plane_);
    for (const auto order : {contact::UpwindOrder::first, contact::UpwindOrder::second}) {
      const Matrix slope = toeplitz([&](int k) { return difference(k, order); });
      rolling_[order == contact::UpwindOrder::first ? 0 : 1] =
          std::make_unique<Tangential>(grid_, slope, antiplane_ * slope);
    }
  }

  LineCompliance(LineCompliance&&) = delete;  // its operators refer to it

  const contact::ContactGrid& grid() const override { return grid_; }

  /// All components, with the normal-tangential coupling K of unlike materials.
  contact::SurfaceField apply(const contact::SurfaceField& traction) const override {
    return {plane_ * traction.x + coupling_ * traction.n, antiplane_ * (plane_ * traction.y),
            plane_ * traction.n + coupling_.transpose() * traction.x};
  }

  const contact::NormalOperator& normal() const override { return *normal_; }
  const contact::TangentialOperator& shift() const override { return *shift_; }
  const contact::TangentialOperator& rolling(contact::UpwindOrder order) const override {
    return *rolling_[order == contact::UpwindOrder::first ? 0 : 1];
  }

 private:
  using Matrix = Eigen::MatrixXd;

  class Normal : public contact::NormalOperator {
   public:
    Normal(const contact::ContactGrid& grid, const Matrix& a) : grid_(grid), a_(a), inverse_(a) {}
    const contact::ContactGrid& grid() const override { return grid_; }
    contact::Field apply(const contact::Field& pressure) const override { return a_ * pressure; }
    contact::Field precondition(const contact::Field& residual) const override {
      return inverse_.solve(residual);
    }

   private:
    const contact::ContactGrid& grid_;
    const Matrix& a_;
    Eigen::LLT<Matrix> inverse_;
  };

  /// x and y do not act on each other in two dimensions.
  class Tangential : public contact::TangentialOperator {
   public:
    Tangential(const contact::ContactGrid& grid, Matrix xx, Matrix yy)
        : grid_(grid), xx_(std::move(xx)), yy_(std::move(yy)) {}
    const contact::ContactGrid& grid() const override { return grid_; }
    double diagonal() const override { return 0.5 * (xx_(0, 0) + yy_(0, 0)); }
    contact::TangentialField apply(const contact::TangentialField& traction) const override {
      return {xx_ * traction.x, yy_ * traction.y};
    }
    contact::TangentialField precondition(const contact::TangentialField& residual, double r,
                                          double shift) const override {
      const auto [known, is_new] = inverses_.try_emplace({r, shift});
      auto& [x, y] = known->second;
      if (is_new) {
        const Matrix identity = Matrix::Identity(xx_.rows(), xx_.cols());
        x.compute(r * xx_ + shift * identity);
        y.compute(r * yy_ + shift * identity);
      }
      return {x.solve(residual.x), y.solve(residual.y)};
    }

   private:
    const contact::ContactGrid& grid_;
    Matrix xx_, yy_;
    using Factors = Eigen::PartialPivLU<Matrix>;
    mutable std::map<std::pair<double, double>, std::pair<Factors, Factors>> inverses_;
  };

  /// Matrix whose entry (i, j) is kernel(i - j).
  template <class Kernel>
  Matrix toeplitz(Kernel&& kernel) const {
    const int n = grid_.nx;
    Eigen::VectorXd values(2 * n - 1);
    for (int k = 0; k < 2 * n - 1; ++k) values[k] = kernel(k - n + 1);
    Matrix matrix(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) matrix(i, j) = values[i - j + n - 1];
    return matrix;
  }

  /// Integral of -ln|s / reference| from 0 to s.
  double log_integral(double s) const {
    return s == 0.0 ? 0.0 : s - s * std::log(std::abs(s) / reference_);
  }

  /// u_x at k elements ahead of one under unit p_x.
  double influence(int k) const {
    return scale_ * (log_integral((k + 0.5) * grid_.dx) - log_integral((k - 0.5) * grid_.dx));
  }

  double difference(int k, contact::UpwindOrder order) const {
    if (order == contact::UpwindOrder::first) return (influence(k) - influence(k + 1)) / grid_.dx;
    return (3.0 * influence(k) - 4.0 * influence(k + 1) + influence(k + 2)) / (2.0 * grid_.dx);
  }

  contact::ContactGrid grid_;
  double reference_;
  double scale_;
  double antiplane_;  ///< u_y under p_y in units of plane_
  Matrix plane_;      ///< u_x under p_x and u_n under p_n alike
  Matrix coupling_;   ///< u_x under p_n; its transpose is u_n under p_x; 0 for like materials
  std::unique_ptr<Normal> normal_;
  std::unique_ptr<Tangential> shift_;
  std::unique_ptr<Tangential> rolling_[2];
};

}  // namespace rollfem::testing
