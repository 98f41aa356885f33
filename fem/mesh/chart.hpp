// SPDX-License-Identifier: LGPL-2.1-or-later
// Chart coordinates (s, t, depth) of a body: the manifold on which every mesh node lies, and the
// box that a cell occupies there. Internal to fem/.
#pragma once

#include "fem/mesh/surface_shape.hpp"
#include "scene/contact_surface.hpp"

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria_accessor.h>

#include <array>
#include <memory>

namespace rollfem::fem {

/// Keeps refined nodes on the true surface: new points are means in (s, t, depth).
class SurfaceManifold : public dealii::ChartManifold<3, 3, 3> {
 public:
  explicit SurfaceManifold(const SurfaceShape& shape) : shape_(shape) {}
  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override;
  dealii::Point<3> pull_back(const dealii::Point<3>& place) const override;
  dealii::Point<3> push_forward(const dealii::Point<3>& chart) const override;
  dealii::DerivativeForm<1, 3, 3> push_forward_gradient(
      const dealii::Point<3>& chart) const override;

 private:
  SurfaceShape shape_;
};

/// Circles about the axle of a wheel, straight lines in its section: for the parts of a body
/// outside the chart of its surface.
class AxleManifold : public dealii::ChartManifold<3, 3, 3> {
 public:
  explicit AxleManifold(const SurfaceShape& wheel) : wheel_(wheel) {}
  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override;
  /// Angle about the axle (rad), y and z of the point rotated back to x = 0 (mm).
  dealii::Point<3> pull_back(const dealii::Point<3>& place) const override;
  dealii::Point<3> push_forward(const dealii::Point<3>& chart) const override;

 private:
  SurfaceShape wheel_;
};

/// Extent of a cell in chart coordinates, lower and upper corner.
struct ChartBox {
  dealii::Point<3> lower;
  dealii::Point<3> upper;
};
template <class CellOrFace>
ChartBox chart_box(const SurfaceShape& shape, const CellOrFace& object) {
  ChartBox box;
  box.lower = box.upper = shape.coordinates(object->vertex(0));
  for (unsigned int v = 1; v < object->n_vertices(); ++v) {
    const auto corner = shape.coordinates(object->vertex(v));
    for (unsigned int d = 0; d < 3; ++d) {
      box.lower[d] = std::min(box.lower[d], corner[d]);
      box.upper[d] = std::max(box.upper[d], corner[d]);
    }
  }
  return box;
}

}  // namespace rollfem::fem
