// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/stress/smooth_stress.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using Eigen::Index;

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
  auto stress = state.stress.as_array();
  for (int c = 0; c < 6; ++c) stress[static_cast<std::size_t>(c)] += beyond[3 + c];
  state.stress = contact::Stress::from_array(stress);
}

}  // namespace rollfem::halfspace
