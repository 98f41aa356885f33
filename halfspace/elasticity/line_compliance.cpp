#include "halfspace/elasticity/line_compliance.hpp"

#include "contact/base/errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rollfem::halfspace {

using contact::CombinedMaterial;
using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using contact::TangentialField;
using contact::UpwindOrder;

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double pi = 3.14159265358979323846;

/// Dense matrices of more rows would take gigabytes.
constexpr int most_elements = 4000;

/// Integral of -ln|s / reference| from 0 to s.
double log_integral(double s, double reference) {
  return s == 0.0 ? 0.0 : s - s * std::log(std::abs(s) / reference);
}

/// Matrix whose entry (i, j) is kernel(i - j).
template <class Kernel>
MatrixXd toeplitz(int n, Kernel&& kernel) {
  Eigen::VectorXd values(2 * n - 1);
  for (int k = 0; k < 2 * n - 1; ++k) values[k] = kernel(k - n + 1);
  MatrixXd matrix(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) matrix(i, j) = values[i - j + n - 1];
  return matrix;
}

class LineNormal : public contact::NormalOperator {
 public:
  LineNormal(const ContactGrid& grid, const MatrixXd& a) : grid_(grid), a_(a), inverse_(a) {}
  const ContactGrid& grid() const override { return grid_; }
  Field apply(const Field& pressure) const override { return a_ * pressure; }
  Field precondition(const Field& residual) const override { return inverse_.solve(residual); }

 private:
  const ContactGrid& grid_;
  const MatrixXd& a_;
  Eigen::LLT<MatrixXd> inverse_;
};

/// x and y do not act on each other in two dimensions.
class LineTangential : public contact::TangentialOperator {
 public:
  LineTangential(const ContactGrid& grid, MatrixXd xx, MatrixXd yy)
      : grid_(grid), xx_(std::move(xx)), yy_(std::move(yy)) {}
  const ContactGrid& grid() const override { return grid_; }
  double diagonal() const override { return 0.5 * (xx_(0, 0) + yy_(0, 0)); }
  TangentialField apply(const TangentialField& traction) const override {
    return {xx_ * traction.x, yy_ * traction.y};
  }
  TangentialField precondition(const TangentialField& residual, double r,
                               double shift) const override {
    if (r != r_ || shift != shift_) {
      const MatrixXd identity = MatrixXd::Identity(xx_.rows(), xx_.cols());
      inverse_x_.compute(r * xx_ + shift * identity);
      inverse_y_.compute(r * yy_ + shift * identity);
      r_ = r;
      shift_ = shift;
    }
    return {inverse_x_.solve(residual.x), inverse_y_.solve(residual.y)};
  }

 private:
  const ContactGrid& grid_;
  MatrixXd xx_, yy_;
  mutable Eigen::PartialPivLU<MatrixXd> inverse_x_, inverse_y_;
  mutable double r_ = -1.0;
  mutable double shift_ = -1.0;
};

void check_grid(const ContactGrid& grid) {
  if (grid.ny != 1)
    throw contact::InputError(
        fmt::format("line contact: the contact grid has {} rows; allowed: one", grid.ny));
  if (grid.nx < 3 || grid.nx > most_elements)
    throw contact::InputError(fmt::format(
        "line contact: the contact grid has {} elements; allowed: 3 to {}; do: choose larger cells",
        grid.nx, most_elements));
}

}  // namespace

struct LineCompliance::Implementation {
  ContactGrid grid;
  double reference;
  MatrixXd plane;     ///< u_x under p_x and u_n under p_n alike
  MatrixXd coupling;  ///< u_x under p_n; its transpose is u_n under p_x; empty for like materials
  double antiplane;   ///< u_y under p_y in units of `plane`
  mutable std::unique_ptr<LineNormal> normal;
  mutable std::unique_ptr<LineTangential> tangential[3];

  Implementation(const ContactGrid& g, const CombinedMaterial& material, double length)
      : grid(g), reference(length > 0.0 ? length : 10.0 * g.nx * g.dx) {
    scale_ = 2.0 * (1.0 - material.poisson_ratio) / (pi * material.shear_modulus);
    plane = toeplitz(grid.nx, [this](int k) { return influence(k); });
    antiplane = 1.0 / (1.0 - material.poisson_ratio);
    if (material.difference == 0.0) return;
    const double k_over_g = material.difference / material.shear_modulus;
    coupling = toeplitz(grid.nx, [&](int k) {
      return -k_over_g * grid.dx * (std::abs(k + 0.5) - std::abs(k - 0.5));
    });
  }

  /// u_x at k elements ahead of one under unit p_x.
  double influence(int k) const {
    return scale_ * (log_integral((k + 0.5) * grid.dx, reference) -
                     log_integral((k - 0.5) * grid.dx, reference));
  }

  double difference(int k, UpwindOrder order) const {
    if (order == UpwindOrder::first) return (influence(k) - influence(k + 1)) / grid.dx;
    return (3.0 * influence(k) - 4.0 * influence(k + 1) + influence(k + 2)) / (2.0 * grid.dx);
  }

  const LineTangential& kept(int which, const MatrixXd& xx) const {
    tangential[which] = std::make_unique<LineTangential>(grid, xx, antiplane * xx);
    return *tangential[which];
  }

 private:
  double scale_ = 0.0;
};

LineCompliance::LineCompliance(const ContactGrid& grid, const CombinedMaterial& material,
                               double reference) {
  check_grid(grid);
  implementation_ = std::make_unique<Implementation>(grid, material, reference);
}

LineCompliance::~LineCompliance() = default;

const ContactGrid& LineCompliance::grid() const {
  return implementation_->grid;
}

SurfaceField LineCompliance::apply(const SurfaceField& traction) const {
  const Implementation& own = *implementation_;
  SurfaceField u{own.plane * traction.x, own.antiplane * (own.plane * traction.y),
                 own.plane * traction.n};
  if (own.coupling.size() != 0) {
    u.x += own.coupling * traction.n;
    u.n += own.coupling.transpose() * traction.x;
  }
  return u;
}

const contact::NormalOperator& LineCompliance::normal() const {
  const Implementation& own = *implementation_;
  if (!own.normal) own.normal = std::make_unique<LineNormal>(own.grid, own.plane);
  return *own.normal;
}

const contact::TangentialOperator& LineCompliance::shift() const {
  const Implementation& own = *implementation_;
  return own.tangential[0] ? *own.tangential[0] : own.kept(0, own.plane);
}

const contact::TangentialOperator& LineCompliance::rolling(UpwindOrder order) const {
  const Implementation& own = *implementation_;
  const int which = order == UpwindOrder::first ? 1 : 2;
  if (own.tangential[which]) return *own.tangential[which];
  return own.kept(which, toeplitz(own.grid.nx, [&](int k) { return own.difference(k, order); }));
}

}  // namespace rollfem::halfspace
