// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction/flat_body.hpp"

#include "fem/trace/far_error.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::hybrid {

using contact::ContactGrid;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

namespace {

/// Elements in a line along rolling.
struct Row {
  double middle;  ///< mm, across
  double width;   ///< mm
  Matrix3d axes;  ///< columns: tangents along rolling and across, normal
  double force;   ///< of traction times area in the plane
};

/// [displacement][traction] in axes of the plane.
Matrix3d block(const halfspace::Influence& h) {
  Matrix3d values;
  values << h.xx, h.xy, h.xn, h.xy, h.yy, h.yn, -h.xn, -h.yn, h.nn;
  return values;
}

/// For a surface with dz/dy = climb.
Matrix3d local_axes(double climb) {
  const double stretch = contact::stretch_of(climb);
  Matrix3d axes;
  axes << 1.0, 0.0, 0.0, 0.0, 1.0 / stretch, -climb / stretch, 0.0, climb / stretch, 1.0 / stretch;
  return axes;
}

/// One row for each element, so that sums run contiguously over the shapes.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds `sign` times the displacement of a half-space in the axes of its rows.
void add_displacement(const ContactGrid& grid, const std::vector<Row>& rows,
                      const contact::CombinedMaterial& material, const RowMajor& shapes,
                      double sign, std::array<RowMajor, 3>& sums) {
  const auto add = [&](const Matrix3d& values, int at, int from) {
    if (shapes.row(from).isZero(0.0)) return;
    for (Index p = 0; p < 3; ++p)
      for (Index u = 0; u < 3; ++u)
        sums[static_cast<std::size_t>(p)].row(u * grid.size() + at) +=
            values(u, p) * shapes.row(from);
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int k = 0; k < grid.ny; ++k)
      for (int apart = 1 - grid.nx; apart < grid.nx; ++apart) {
        const Row &at = rows[static_cast<std::size_t>(j)],
                  &from = rows[static_cast<std::size_t>(k)];
        const Matrix3d values =
            sign * from.force * at.axes.transpose() *
            block(halfspace::rectangle_influence(apart * grid.dx, at.middle - from.middle, grid.dx,
                                                 from.width, material)) *
            from.axes;
        for (int i = std::max(0, apart); i < std::min(grid.nx, grid.nx + apart); ++i)
          add(values, grid.index(i, j), grid.index(i - apart, k));
      }
}

}  // namespace

bool is_half_space(const contact::Scene& scene, bool wheel) {
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (surface.profiles || fem::far_boundary_of(scene) != contact::FarBoundary::point_load)
    return false;
  return wheel ? std::isinf(surface.wheel_transverse_radius) && std::isinf(surface.rolling_radius)
               : std::isinf(surface.rail_transverse_radius) && !surface.rail_is_roller();
}

std::array<MatrixXd, 3> beyond_flat_body(const contact::Scene& scene, bool wheel,
                                         const ContactGrid& grid, const ArcLength& arc,
                                         const MatrixXd& shapes) {
  const contact::Material rigid = contact::rigid_material();
  const contact::CombinedMaterial material =
      wheel ? combine(scene.wheel.material, rigid) : combine(rigid, scene.rail.material);
  const contact::PatchShape shape = contact::patch_shape(scene.geometry.surface, grid);
  std::vector<Row> plane, rolled_out;
  for (int j = 0; j < grid.ny; ++j) {
    const double y = grid.y(j), lower = arc.at(y - 0.5 * grid.dy),
                 upper = arc.at(y + 0.5 * grid.dy);
    const int element = grid.index(0, j);
    plane.push_back({y, grid.dy, local_axes(shape.climb[element]), shape.stretch[element]});
    rolled_out.push_back({0.5 * (lower + upper), upper - lower, Matrix3d::Identity(), 1.0});
  }
  const RowMajor loads = shapes;
  std::array<RowMajor, 3> sums;
  for (RowMajor& sum : sums) sum = RowMajor::Zero(3 * grid.size(), shapes.cols());
  add_displacement(grid, plane, material, loads, 1.0, sums);
  add_displacement(grid, rolled_out, material, loads, -1.0, sums);
  return {sums[0], sums[1], sums[2]};
}

}  // namespace rollfem::hybrid
