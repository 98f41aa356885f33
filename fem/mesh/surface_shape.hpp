// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a body: chart coordinates and points in space, the manifold on which every mesh
// node lies, and the box that a cell occupies in the chart.
#pragma once

#include "base/profile_drop.hpp"
#include "fem/mesh/graded_depth.hpp"
#include "meshes/true_section.hpp"
#include "scene/contact_surface.hpp"

#include <deal.II/base/derivative_form.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>

namespace rollfem::fem {

/// Unit vectors of a surface: along rolling, lateral, normal into the wheel, for both bodies.
using SurfaceFrame = std::array<dealii::Tensor<1, 3>, 3>;

/// A chart of a surface other than wheel and rail, for manually built bodies (a disc in a hole).
/// All three functions are required; their meaning is as in SurfaceShape.
struct ChartFunctions {
  std::function<dealii::Point<3>(const dealii::Point<3>& chart)> place;
  std::function<dealii::Point<3>(const dealii::Point<3>& place)> coordinates;
  std::function<SurfaceFrame(double s, double t)> frame;
};

/// Height z of a surface at s = 0, mm, and its slope dz/dt.
struct SurfaceHeight {
  double value;
  double slope;
};

/// A true profile: the section of wheel or rail of a PatchGeometry.
class ProfileShape {
 public:
  ProfileShape(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel);

  const contact::PatchGeometry& geometry() const { return *geometry_; }
  /// Range in which the surface is a known height over t not steeper than `steepest` (dz/dy, 75
  /// degrees: cells below it, whose sides are along z, have a scaled Jacobian of 0.26). Outside,
  /// the chart continues along the tangent (one to one, but no longer the true surface).
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  static constexpr double steepest = 3.73;
  SurfaceHeight height(double t) const;

 private:
  std::shared_ptr<const contact::PatchGeometry> geometry_;
  const contact::HeightCurve& section_;
  double lower_ = 0.0, upper_ = 0.0;
};

/// Surface coordinates (s, t) = (arc length on the surface along rolling, lateral coordinate y) and
/// depth d below the surface (along z on the rail, towards the axle on the wheel) -> point in
/// space. s points along +x, the contact reference point is (0, 0, 0). For the wheel the material
/// is above (z > 0), for the rail below. A wheel's section is revolved about its axle, which a true
/// profile may tilt in the plane x = 0; for a yawed axle its trace at the contact is used (the yaw
/// itself, below 25 mrad, is in undeformed distance and slip).
struct SurfaceShape {
  bool is_wheel = false;
  /// Height of the axle above the surface, < 0 of a roller below it; infinite for a straight rail.
  double rolling_radius = contact::infinity;
  double transverse_radius = contact::infinity;  ///< > 0 convex, < 0 concave
  /// If given, these define the chart; the radii are ignored.
  std::shared_ptr<const ChartFunctions> functions = nullptr;
  /// If given, the section in place of the transverse circle; the rolling radius applies to t = 0.
  std::shared_ptr<const ProfileShape> profile = nullptr;
  double round_to = contact::usual_round_to;  ///< fraction of the transverse radius
  /// Drop of the transverse circle at t.
  contact::ProfileDrop drop_at(double t) const;
  dealii::Point<3> place(double s, double t, double depth) const;
  /// Inverse of place(): (s, t, depth).
  dealii::Point<3> coordinates(const dealii::Point<3>& place) const;
  /// On the surface at (s, t).
  SurfaceFrame frame(double s, double t) const;
  /// The same at a surface with lateral slope dz/dy = `climb` instead of the body's slope (chart
  /// functions keep their frame).
  SurfaceFrame tilted_frame(double s, double t, double climb) const;
  /// Radius of the surface about the axle at lateral coordinate t, mm, with the sign of the rolling
  /// radius; infinite unless revolved.
  double streamline_radius(double t) const;
  /// Whether this is a wheel or roller of finite radius, whose streamlines are circles.
  bool is_revolved() const;
  /// Range in which the surface can be meshed; infinite except for profiles.
  double lower_t() const;
  double upper_t() const;

  // Without chart functions:
  SurfaceHeight height(double t) const;
  /// Axle of a revolved body; level for all others.
  meshes::AxleTrace axle() const;
  /// A point of the section (y, z at x = 0) after rotation by `angle` about the axle.
  dealii::Point<3> turned_about_axle(double y, double z, double angle) const;
  /// The inverse: angle, y, z.
  dealii::Point<3> turned_to_section(const dealii::Point<3>& place) const;
};

/// Wheel or rail of a patch with true profiles.
SurfaceShape profile_surface(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel);

/// Means in chart coordinates: new nodes of refined meshes.
class MeansInChart : public dealii::ChartManifold<3, 3, 3> {
 public:
  using Map = std::function<dealii::Point<3>(const dealii::Point<3>&)>;
  MeansInChart(Map to_chart, Map to_space)
      : to_chart_(std::move(to_chart)), to_space_(std::move(to_space)) {}
  std::unique_ptr<dealii::Manifold<3, 3>> clone() const override {
    return std::make_unique<MeansInChart>(to_chart_, to_space_);
  }
  dealii::Point<3> pull_back(const dealii::Point<3>& place) const override {
    return to_chart_(place);
  }
  dealii::Point<3> push_forward(const dealii::Point<3>& chart) const override {
    return to_space_(chart);
  }
  /// Central differences, accurate enough for tangents: meshes need none.
  dealii::DerivativeForm<1, 3, 3> push_forward_gradient(
      const dealii::Point<3>& chart) const override;

 private:
  Map to_chart_, to_space_;
};
/// Keeps nodes on the true surface, and in the depths of these rows.
MeansInChart surface_manifold(const SurfaceShape& shape, const GradedDepth& rows = {});
/// Circles about the axle of a wheel, straight lines in its section: for the parts of a body
/// outside the chart of its surface. Coordinates: angle about the axle (rad), y and z of the point
/// rotated back to x = 0 (mm).
MeansInChart axle_manifold(const SurfaceShape& wheel);

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
