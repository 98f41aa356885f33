// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/cell_shape.hpp"

#include <cmath>

namespace rollfem::fem {

namespace {

/// Lagrange's polynomials with equal distances on [0, 1] at x, and their derivatives.
struct LagrangeLine {
  LagrangeLine(int degree, double x) {
    if (degree == 1) {
      value = {1 - x, x, 0};
      slope = {-1, 1, 0};
    } else {
      value = {(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)};
      slope = {4 * x - 3, 4 - 8 * x, 4 * x - 1};
    }
  }
  std::array<double, 3> value, slope;
};

using LagrangeLines = std::array<LagrangeLine, 3>;

LagrangeLines lagrange_lines(int degree, const dealii::Point<3>& unit) {
  return {LagrangeLine(degree, unit[0]), LagrangeLine(degree, unit[1]),
          LagrangeLine(degree, unit[2])};
}

dealii::Tensor<1, 3> product_gradient(const LagrangeLines& p, int i, int j, int k) {
  dealii::Tensor<1, 3> g;
  g[0] = p[0].slope[i] * p[1].value[j] * p[2].value[k];
  g[1] = p[0].value[i] * p[1].slope[j] * p[2].value[k];
  g[2] = p[0].value[i] * p[1].value[j] * p[2].slope[k];
  return g;
}

std::vector<dealii::Point<3>> quadratic_points() {
  std::vector<dealii::Point<3>> points;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) points.emplace_back(0.5 * i, 0.5 * j, 0.5 * k);
  return points;
}

/// A point this far outside of a cell, in cells, is still its own: rounding.
constexpr double border = 1e-7;

}  // namespace

CellShape::CellShape(const Body& body)
    : degree_(static_cast<int>(body.dofs().get_fe().degree)),
      values_(std::make_unique<dealii::FEValues<3>>(body.mapping(), body.dofs().get_fe(),
                                                    dealii::Quadrature<3>(quadratic_points()),
                                                    dealii::update_quadrature_points)) {
  for (const auto& p : body.dofs().get_fe().base_element(0).get_unit_support_points())
    order_.push_back({static_cast<int>(std::lround(p[0] * degree_)),
                      static_cast<int>(std::lround(p[1] * degree_)),
                      static_cast<int>(std::lround(p[2] * degree_))});
}

void CellShape::reinit(const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  values_->reinit(cell);
  for (unsigned int q = 0; q < places_.size(); ++q) places_[q] = values_->quadrature_point(q);
}

dealii::Tensor<2, 3> CellShape::jacobian(const dealii::Point<3>& unit,
                                         dealii::Point<3>& place) const {
  const LagrangeLines p = lagrange_lines(2, unit);
  dealii::Tensor<2, 3> jacobian;
  place = dealii::Point<3>();
  for (int k = 0, q = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i, ++q) {
        place += p[0].value[i] * p[1].value[j] * p[2].value[k] * places_[q];
        const auto g = product_gradient(p, i, j, k);
        for (unsigned int c = 0; c < 3; ++c) jacobian[c] += places_[q][c] * g;
      }
  return jacobian;
}

std::optional<dealii::Point<3>> CellShape::inside(const dealii::Point<3>& place) const {
  constexpr int most_iterations = 20;
  dealii::Point<3> unit(0.5, 0.5, 0.5), at;
  for (int k = 0; k < most_iterations; ++k) {
    const dealii::Tensor<2, 3> j = jacobian(unit, at);
    const dealii::Tensor<1, 3> step = dealii::invert(j) * (place - at);
    unit += step;
    for (unsigned int d = 0; d < 3; ++d)
      if (!(std::abs(unit[d] - 0.5) < 2.0)) return {};
    if (step.norm() > 1e-12) continue;
    for (unsigned int d = 0; d < 3; ++d)
      if (std::abs(unit[d] - 0.5) > 0.5 + border) return {};
    return unit;
  }
  return {};
}

double CellShape::gradients(const dealii::Point<3>& unit, dealii::Tensor<1, 3>* of_node) const {
  dealii::Point<3> place;
  const dealii::Tensor<2, 3> j = jacobian(unit, place);
  const dealii::Tensor<2, 3> inverse = dealii::transpose(dealii::invert(j));
  const LagrangeLines p = lagrange_lines(degree_, unit);
  for (std::size_t a = 0; a < order_.size(); ++a)
    of_node[a] = inverse * product_gradient(p, order_[a][0], order_[a][1], order_[a][2]);
  return dealii::determinant(j);
}

}  // namespace rollfem::fem
