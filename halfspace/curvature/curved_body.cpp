// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/curvature/curved_body.hpp"

#include "base/count.hpp"
#include "base/pi.hpp"
#include "contact/iteration/interpolation.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;

namespace {

using contact::pi;

// The part of CurvedBody that comes from the surface beyond a rectangle around the contact: there
// the strain of the half-space is that of a few point loads, and the integral over the rest of the
// plane is a small symmetric matrix.

class FarSurface {
 public:
  /// `half_length`, `half_width`: mm, of the rectangle around the middle of the grid, covered by
  /// the near part.
  FarSurface(const contact::ContactGrid& grid, const BodySurface& surface, double half_length,
             double half_width);

  /// Adds the displacement (mm) under tractions (MPa).
  void add(const contact::SurfaceField& traction, contact::SurfaceField& displacement) const;

 private:
  contact::ContactGrid grid_;
  Eigen::MatrixXd along_x_;  ///< Lagrange polynomials of the nodes at the columns of the grid
  Eigen::MatrixXd along_y_;  ///< and at its rows
  Eigen::MatrixXd matrix_;   ///< forces at the nodes (x, then y, then n) to displacements
};

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

/// Heights up to this fraction of the shorter side of an element multiply tractions element by
/// element: there u_,z of tractions that alternate between elements stays below their own
/// displacement. The gradients for larger heights are means over corners, which miss alternating
/// tractions.
constexpr double height_in_elements = 0.25;

constexpr double rigid_modulus = std::numeric_limits<double>::infinity();

/// One value per element or inner corner, first index along x.
using Plane = Eigen::ArrayXXd;

/// Sum over the four elements of a corner, each with its sign: `x` for those at larger x, `y` at
/// larger y.
Plane gathered(const Plane& u, double x, double y) {
  const Eigen::Index n = u.rows() - 1, m = u.cols() - 1;
  return x * y * u.bottomRightCorner(n, m) + x * u.bottomLeftCorner(n, m) +
         y * u.topRightCorner(n, m) + u.topLeftCorner(n, m);
}

Plane scattered(const Plane& c, double x, double y) {
  const Eigen::Index n = c.rows(), m = c.cols();
  Plane u = Plane::Zero(n + 1, m + 1);
  u.bottomRightCorner(n, m) += x * y * c;
  u.bottomLeftCorner(n, m) += x * c;
  u.topRightCorner(n, m) += y * c;
  u.topLeftCorner(n, m) += c;
  return u;
}

/// Gradients and means of element values, taken at the corners shared by four elements (one value
/// less in each direction), and the transposes of both, from corners to elements: first-order
/// operators built from them are symmetric on the grid.
struct Corners {
  double dx = 0.0;  ///< mm
  double dy = 0.0;

  Plane along_x(const Plane& u) const { return gathered(u, -1.0, 1.0) * (-0.5 / dx); }
  Plane along_y(const Plane& u) const { return gathered(u, 1.0, -1.0) * (-0.5 / dy); }
  static Plane mean(const Plane& u) { return 0.25 * gathered(u, 1.0, 1.0); }
  Plane from_x(const Plane& m) const { return scattered(m, -1.0, 1.0) * (-0.5 / dx); }
  Plane from_y(const Plane& m) const { return scattered(m, 1.0, -1.0) * (-0.5 / dy); }
  static Plane from_mean(const Plane& m) { return 0.25 * scattered(m, 1.0, 1.0); }
};

/// The grid extended by half its longer side all around.
ContactGrid surroundings(const ContactGrid& grid) {
  const double way = 0.5 * std::max(grid.nx * grid.dx, grid.ny * grid.dy);
  const int columns = contact::count_of(std::ceil(way / grid.dx), "columns beside the contact");
  const int rows = contact::count_of(std::ceil(way / grid.dy), "rows beside the contact");
  return grid.widened(columns, rows);
}

Plane plane_of(const Field& field, const ContactGrid& grid) {
  return Eigen::Map<const Plane>(field.data(), grid.nx, grid.ny);
}

Field field_of(const Plane& plane) {
  return Eigen::Map<const Field>(plane.data(), plane.size());
}

/// Displacements or tractions over the surroundings.
struct Planes {
  Plane x, y, n;
};

}  // namespace

struct CurvedBody::Implementation {
  Implementation(const ContactGrid& the_grid, const BodySurface& surface);

  Planes solve(const Planes& traction) const;
  Planes left_on_surface(const Planes& t, const Planes& u) const;
  Planes carried_to_surface(const Planes& t, const Planes& u) const;
  SurfaceField at_contact(const Planes& planes) const;

  ContactGrid grid;
  ContactGrid wide;
  Corners corners;
  HalfspaceCompliance half;  ///< of this body
  FarSurface far;
  double shear;
  double nu;
  Plane corner_height;  ///< mm, at the corners of `wide`
  Plane low;            ///< mm, at its elements, limited by height_in_elements
  Plane corner_rest;    ///< mm, the remainder of corner_height
  Plane slope_x;
  Plane slope_y;
};

CurvedBody::Implementation::Implementation(const ContactGrid& the_grid, const BodySurface& surface)
    : grid(the_grid),
      wide(surroundings(the_grid)),
      corners{the_grid.dx, the_grid.dy},
      half(wide, contact::combine(surface.material, {rigid_modulus, 0.0, 0.0})),
      far(the_grid, surface, 0.5 * (wide.nx - 1) * wide.dx, 0.5 * (wide.ny - 1) * wide.dy),
      shear(contact::shear_modulus(surface.material)),
      nu(surface.material.poisson_ratio) {
  const ContactGrid between{wide.nx - 1,
                            wide.ny - 1,
                            wide.dx,
                            wide.dy,
                            wide.x_first + 0.5 * wide.dx,
                            wide.y_first + 0.5 * wide.dy};
  corner_height = plane_of(between.sample(surface.height), between);
  const double lowest = height_in_elements * std::min(wide.dx, wide.dy);
  low = plane_of(wide.sample(surface.height), wide).max(-lowest).min(lowest);
  corner_rest = corner_height - corner_height.max(-lowest).min(lowest);
  slope_x = plane_of(wide.sample([&](double x, double) { return surface.slope_x(x); }), wide);
  slope_y = plane_of(wide.sample([&](double, double y) { return surface.slope_y(y); }), wide);
}

Planes CurvedBody::Implementation::solve(const Planes& traction) const {
  const SurfaceField u =
      half.apply({field_of(traction.x), field_of(traction.y), field_of(traction.n)});
  return {plane_of(u.x, wide), plane_of(u.y, wide), plane_of(u.n, wide)};
}

/// Additional tractions on the plane for the true surface to have the required ones: -d_b(h
/// sigma_ab) - p s_a along a, d_b(h q_b) + q_a s_a inwards.
Planes CurvedBody::Implementation::left_on_surface(const Planes& t, const Planes& u) const {
  const Plane xx = corners.along_x(u.x), yy = corners.along_y(u.y);
  const double modulus = 2.0 * shear / (1.0 - nu), across = nu / (1.0 - nu);
  const Plane pressure = Corners::mean(t.n);
  const Plane stress_x = corner_height * (modulus * (xx + nu * yy) - across * pressure);
  const Plane stress_y = corner_height * (modulus * (yy + nu * xx) - across * pressure);
  const Plane stress_xy = corner_height * shear * (corners.along_y(u.x) + corners.along_x(u.y));
  // Transposes of the gradients are minus the divergence.
  return {corners.from_x(stress_x) + corners.from_y(stress_xy) - t.n * slope_x,
          corners.from_y(stress_y) + corners.from_x(stress_xy) - t.n * slope_y,
          t.x * slope_x + t.y * slope_y - corners.from_x(corner_height * Corners::mean(t.x)) -
              corners.from_y(corner_height * Corners::mean(t.y))};
}

/// The half-space's displacement transferred from the plane to the surface, h u_,z, in components
/// along its normal and tangents.
Planes CurvedBody::Implementation::carried_to_surface(const Planes& t, const Planes& u) const {
  const Plane dilatation = corners.along_x(u.x) + corners.along_y(u.y);
  const auto spread = [&](const Plane& values) -> Plane {
    return Corners::from_mean(corner_height * values);
  };
  const auto times_height = [&](const Plane& traction) -> Plane {
    return low * traction + Corners::from_mean(corner_rest * Corners::mean(traction));
  };
  const double across = nu / (1.0 - nu);
  const double squeeze = (1.0 - 2.0 * nu) / (2.0 * shear * (1.0 - nu));
  return {
      slope_x * u.n - times_height(t.x) / shear - spread(corners.along_x(u.n)),
      slope_y * u.n - times_height(t.y) / shear - spread(corners.along_y(u.n)),
      -slope_x * u.x - slope_y * u.y - squeeze * times_height(t.n) - across * spread(dilatation)};
}

SurfaceField CurvedBody::Implementation::at_contact(const Planes& planes) const {
  const int columns = (wide.nx - grid.nx) / 2, rows = (wide.ny - grid.ny) / 2;
  const auto cut = [&](const Plane& plane) {
    return field_of(plane.block(columns, rows, grid.nx, grid.ny));
  };
  return {cut(planes.x), cut(planes.y), cut(planes.n)};
}

CurvedBody::CurvedBody(const ContactGrid& grid, const BodySurface& surface)
    : implementation_(std::make_unique<Implementation>(grid, surface)) {}

CurvedBody::~CurvedBody() = default;
CurvedBody::CurvedBody(CurvedBody&&) noexcept = default;

CurvedBody::Displacement CurvedBody::apply(const SurfaceField& traction) const {
  const Implementation& own = *implementation_;
  const int columns = (own.wide.nx - own.grid.nx) / 2, rows = (own.wide.ny - own.grid.ny) / 2;
  const auto widened = [&](const Field& field) {
    Plane plane = Plane::Zero(own.wide.nx, own.wide.ny);
    plane.block(columns, rows, own.grid.nx, own.grid.ny) = plane_of(field, own.grid);
    return plane;
  };
  const Planes t{widened(traction.x), widened(traction.y), widened(traction.n)};
  const Planes u = own.solve(t);
  const Planes again = own.solve(own.left_on_surface(t, u));
  const Planes carried = own.carried_to_surface(t, u);
  Displacement result{own.at_contact(u), own.at_contact({again.x + carried.x, again.y + carried.y,
                                                         again.n + carried.n})};
  own.far.add(traction, result.correction);
  return result;
}

}  // namespace rollfem::halfspace
