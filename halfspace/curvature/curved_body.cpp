// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/curvature/curved_body.hpp"

#include "contact/base/count.hpp"
#include "halfspace/curvature/far_surface.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::SurfaceField;

namespace {

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
