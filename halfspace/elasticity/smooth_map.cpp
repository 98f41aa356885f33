// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/smooth_map.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

MatrixXd on_grid(const SmoothBox& box, const SmoothBox& within, int degree,
                 const ContactGrid& grid) {
  return polynomials(box, degree, grid.sample([&](double x, double) {
    return std::clamp(x, -within.half_length, within.half_length);
  }),
                     grid.sample([&](double, double y) {
                       return std::clamp(y, within.middle - within.half_width,
                                         within.middle + within.half_width);
                     }));
}

}  // namespace

MatrixXd chebyshev(int degree, const Field& at) {
  MatrixXd values(at.size(), degree + 1);
  values.col(0).setOnes();
  if (degree > 0) values.col(1) = at;
  for (int k = 2; k <= degree; ++k)
    values.col(k) = 2.0 * at.cwiseProduct(values.col(k - 1)) - values.col(k - 2);
  return values;
}

std::vector<std::array<int, 2>> polynomial_powers(int degree) {
  std::vector<std::array<int, 2>> powers;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) powers.push_back({i, j});
  return powers;
}

MatrixXd polynomials(const SmoothBox& box, int degree, const Field& x, const Field& y) {
  const MatrixXd along = chebyshev(degree, x / box.half_length);
  const MatrixXd across = chebyshev(degree, ((y.array() - box.middle) / box.half_width).matrix());
  const auto powers = polynomial_powers(degree);
  MatrixXd values(x.size(), static_cast<Index>(powers.size()));
  for (std::size_t k = 0; k < powers.size(); ++k)
    values.col(static_cast<Index>(k)) =
        along.col(powers[k][0]).cwiseProduct(across.col(powers[k][1]));
  return values;
}

SmoothMapOnGrid::SmoothMapOnGrid(const SmoothMap& map, const ContactGrid& grid)
    : coefficients_(map.coefficients),
      loads_(grid.element_area() * on_grid(map.loads, map.fields, map.load_degree, grid)),
      fields_(on_grid(map.fields, map.fields, map.field_degree, grid)) {}

SurfaceField SmoothMapOnGrid::apply(const SurfaceField& traction) const {
  const Index count = loads_.cols();
  Eigen::VectorXd moments(3 * count);
  moments << loads_.transpose() * traction.x, loads_.transpose() * traction.y,
      loads_.transpose() * traction.n;
  const Eigen::VectorXd result = coefficients_ * moments;
  const Index size = fields_.cols();
  return {fields_ * result.head(size), fields_ * result.segment(size, size),
          fields_ * result.tail(size)};
}

}  // namespace rollfem::halfspace
