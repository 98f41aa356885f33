// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/curvature/far_surface.hpp"

#include "contact/base/pi.hpp"
#include "contact/iteration/interpolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

namespace {

using contact::ContactGrid;
using contact::Field;
using contact::pi;

/// Nodes along each side of the contact; the rectangle begins at twice its half length, so that
/// polynomials converge as (2 + sqrt(3))^-n.
constexpr int far_nodes = 7;
constexpr int far_nodes_square = far_nodes * far_nodes;

// Gauss-Legendre on [-1, 1], 8 points (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 8> gauss_points{
    -0.9602898564975363, -0.7966664774136267, -0.5255324099163290, -0.1834346424956498,
    0.1834346424956498,  0.5255324099163290,  0.7966664774136267,  0.9602898564975363};
constexpr std::array<double, 8> gauss_weights{
    0.1012285362903763, 0.2223810344533745, 0.3137066458778873, 0.3626837833783620,
    0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

/// Chebyshev nodes over the elements of a side.
std::array<double, far_nodes> nodes_between(double first, double last) {
  std::array<double, far_nodes> nodes{};
  for (int k = 0; k < far_nodes; ++k)
    nodes[k] = 0.5 * (first + last) - 0.5 * (last - first) * std::cos((k + 0.5) * pi / far_nodes);
  return nodes;
}

Eigen::MatrixXd lagrange(const std::array<double, far_nodes>& nodes, int count, double first,
                         double step) {
  Eigen::MatrixXd values(count, far_nodes);
  for (int i = 0; i < count; ++i) {
    const auto weights = contact::lagrange_weights(nodes, first + i * step);
    values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(weights.data(), far_nodes);
  }
  return values;
}

/// Strains (xx, yy, 2 xy: rows) of the surface at (x, y) from unit forces along x, y, z (columns)
/// at the origin: derivatives of Boussinesq's and Cerruti's displacements (Johnson 1985, 3.2, 3.6).
Eigen::Matrix3d strain_of_point_forces(double x, double y, double shear_modulus, double nu) {
  const double r2 = x * x + y * y, r = std::sqrt(r2), r3 = r2 * r, r5 = r3 * r2;
  const double tangential = 1.0 / (2.0 * pi * shear_modulus);
  const double normal = -(1.0 - 2.0 * nu) / (4.0 * pi * shear_modulus);
  Eigen::Matrix3d strain;
  const double xxx = -(1.0 - nu) * x / r3 + nu * (2.0 * x / r3 - 3.0 * x * x * x / r5);
  const double xx_y = -(1.0 - nu) * y / r3 - 3.0 * nu * x * x * y / r5;
  const double yyy = -(1.0 - nu) * y / r3 + nu * (2.0 * y / r3 - 3.0 * y * y * y / r5);
  const double yy_x = -(1.0 - nu) * x / r3 - 3.0 * nu * x * y * y / r5;
  const double xy_x = nu * (y / r3 - 3.0 * x * x * y / r5);
  const double xy_y = nu * (x / r3 - 3.0 * x * y * y / r5);
  strain.col(0) = tangential * Eigen::Vector3d(xxx, xy_y, xx_y + xy_x);
  strain.col(1) = tangential * Eigen::Vector3d(xy_x, yyy, xy_y + yy_x);
  strain.col(2) =
      normal / r2 *
      Eigen::Vector3d(1.0 - 2.0 * x * x / r2, 1.0 - 2.0 * y * y / r2, -4.0 * x * y / r2);
  return strain;
}

/// Membrane stress of a unit thickness under those strains.
Eigen::Matrix3d membrane_stiffness(double shear_modulus, double nu) {
  const double modulus = 2.0 * shear_modulus / (1.0 - nu);
  Eigen::Matrix3d stiffness;
  stiffness << modulus, nu * modulus, 0.0, nu * modulus, modulus, 0.0, 0.0, 0.0, shear_modulus;
  return stiffness;
}

/// A quadrature point outside the rectangle with its area.
struct FarPlace {
  double x, y, area;
};

/// Gauss quadrature in the angle over each side of the rectangle, and in 1/r from there to the
/// square of half side `extent`.
std::vector<FarPlace> places_beyond(double half_length, double half_width, double extent) {
  const double corner = std::atan2(half_width, half_length);
  const std::array<double, 5> angles{-corner, corner, pi - corner, pi + corner, 2.0 * pi - corner};
  constexpr int parts = 2;  // of each side
  std::vector<FarPlace> places;
  for (int side = 0; side < 4; ++side)
    for (int part = 0; part < parts; ++part)
      for (std::size_t k = 0; k < gauss_points.size(); ++k) {
        const double half = 0.5 * (angles[side + 1] - angles[side]) / parts;
        const double angle = angles[side] + half * (2 * part + 1 + gauss_points[k]);
        const double c = std::cos(angle), s = std::sin(angle);
        const double near = std::max(std::abs(c) / half_length, std::abs(s) / half_width);
        const double far = std::min(near, std::max(std::abs(c), std::abs(s)) / extent);
        for (std::size_t l = 0; l < gauss_points.size(); ++l) {
          const double r = 1.0 / (far + 0.5 * (near - far) * (1.0 + gauss_points[l]));
          const double dr = 0.5 * (near - far) * gauss_weights[l] * r * r;
          places.push_back({r * c, r * s, half * gauss_weights[k] * dr * r});
        }
      }
  return places;
}

}  // namespace

FarSurface::FarSurface(const ContactGrid& grid, const BodySurface& surface, double half_length,
                       double half_width)
    : grid_(grid) {
  const double x_last = grid.x(grid.nx - 1), y_last = grid.y(grid.ny - 1);
  const auto x_nodes = nodes_between(grid.x_first, x_last);
  const auto y_nodes = nodes_between(grid.y_first, y_last);
  along_x_ = lagrange(x_nodes, grid.nx, grid.x_first, grid.dx);
  along_y_ = lagrange(y_nodes, grid.ny, grid.y_first, grid.dy);
  const double shear = contact::shear_modulus(surface.material);
  const double nu = surface.material.poisson_ratio;
  const Eigen::Matrix3d stiffness = membrane_stiffness(shear, nu);
  const double x_middle = 0.5 * (grid.x_first + x_last), y_middle = 0.5 * (grid.y_first + y_last);
  const std::vector<FarPlace> places = places_beyond(half_length, half_width, surface.extent);
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd strain(rows, 3 * far_nodes_square), stress(rows, 3 * far_nodes_square);
  for (std::size_t q = 0; q < places.size(); ++q) {
    const double x = x_middle + places[q].x, y = y_middle + places[q].y;
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(q);
    for (int l = 0; l < far_nodes; ++l)
      for (int k = 0; k < far_nodes; ++k) {
        const Eigen::Matrix3d of_node =
            strain_of_point_forces(x - x_nodes[k], y - y_nodes[l], shear, nu);
        for (int d = 0; d < 3; ++d)
          strain.block<3, 1>(row, d * far_nodes_square + l * far_nodes + k) = of_node.col(d);
      }
    stress.middleRows<3>(row) =
        surface.height(x, y) * places[q].area * stiffness * strain.middleRows<3>(row);
  }
  matrix_ = strain.transpose() * stress;
}

void FarSurface::add(const contact::SurfaceField& traction,
                     contact::SurfaceField& displacement) const {
  using Matrix = Eigen::Map<const Eigen::MatrixXd>;
  Eigen::VectorXd forces(3 * far_nodes_square);
  int d = 0;
  for (const Field* t : {&traction.x, &traction.y, &traction.n})
    Eigen::Map<Eigen::MatrixXd>(forces.data() + far_nodes_square * d++, far_nodes, far_nodes) =
        grid_.element_area() * along_x_.transpose() * Matrix(t->data(), grid_.nx, grid_.ny) *
        along_y_;
  const Eigen::VectorXd moved = matrix_ * forces;
  d = 0;
  for (Field* u : {&displacement.x, &displacement.y, &displacement.n})
    Eigen::Map<Eigen::MatrixXd>(u->data(), grid_.nx, grid_.ny) +=
        along_x_ * Matrix(moved.data() + far_nodes_square * d++, far_nodes, far_nodes) *
        along_y_.transpose();
}

}  // namespace rollfem::halfspace
