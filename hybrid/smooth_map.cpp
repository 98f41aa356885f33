// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/smooth_map.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace rollfem::hybrid {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;
using Eigen::Index;
using Eigen::MatrixXd;
using halfspace::SubsurfacePoint;
using halfspace::SubsurfaceState;

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

namespace {

/// Coordinates relative to the box, between -1 and 1 inside.
std::array<double, 3> scaled(const SmoothBox& box, double depth, const SubsurfacePoint& at) {
  return {at.x / box.half_length, (at.y - box.middle) / box.half_width,
          2.0 * at.depth / depth - 1.0};
}

}  // namespace

Index depth_polynomial_count(int degree) {
  return static_cast<Index>((degree + 1) * (degree + 2) * (degree + 3) / 6);
}

Eigen::VectorXd depth_polynomials(const SmoothBox& box, double depth, int degree,
                                  const SubsurfacePoint& at) {
  const auto place = scaled(box, depth, at);
  const Eigen::MatrixXd along =
      chebyshev(degree, Eigen::Vector3d(place.data()).cwiseMax(-1.0).cwiseMin(1.0));
  Eigen::VectorXd values(depth_polynomial_count(degree));
  Index term = 0;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j)
      for (int k = 0; i + j + k <= degree; ++k)
        values[term++] = along(0, i) * along(1, j) * along(2, k);
  return values;
}

SmoothStressOnGrid::SmoothStressOnGrid(const SmoothDepthMap& map, const contact::ContactGrid& grid,
                                       const contact::SurfaceField& traction)
    : fields_(map.fields), depth_(map.depth), degree_(map.field_degree) {
  const Eigen::MatrixXd loads =
      grid.element_area() * polynomials(map.loads, map.load_degree,
                                        grid.sample([](double x, double) { return x; }),
                                        grid.sample([](double, double y) { return y; }));
  const Index count = loads.cols();
  Eigen::VectorXd moments = Eigen::VectorXd::Zero(3 * count);
  if (traction.x.size() > 0) moments.head(count) = loads.transpose() * traction.x;
  if (traction.y.size() > 0) moments.segment(count, count) = loads.transpose() * traction.y;
  moments.tail(count) = loads.transpose() * traction.n;
  const Eigen::VectorXd all = map.coefficients * moments;
  coefficients_ = Eigen::Map<const Eigen::MatrixXd>(all.data(), depth_polynomial_count(degree_),
                                                    smooth_components);
}

void SmoothStressOnGrid::add(const SubsurfacePoint& at, SubsurfaceState& state) const {
  double farthest = 1.0;
  for (const double part : scaled(fields_, depth_, at))
    farthest = std::max(farthest, std::abs(part));
  const Eigen::VectorXd beyond = coefficients_.transpose() *
                                 depth_polynomials(fields_, depth_, degree_, at) /
                                 (farthest * farthest);
  for (int c = 0; c < 3; ++c) state.displacement[static_cast<std::size_t>(c)] += beyond[c];
  for (int c = 0; c < 6; ++c) state.stress[static_cast<std::size_t>(c)] += beyond[3 + c];
}

}  // namespace rollfem::hybrid
