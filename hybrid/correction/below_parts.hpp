// SPDX-License-Identifier: LGPL-2.1-or-later
// The difference between wheel or rail and half-spaces below the surface, computed by finite
// elements like the surface part in smooth_parts.hpp: body minus flattened twin at the same Gauss
// points of the same cells. Those points lie apart in coordinates that follow the surface (cells
// are laid along z, which is not the normal of a steep surface); the exact change of the half-space
// in between is subtracted.
#pragma once

#include "fem/discretisation/body.hpp"
#include "halfspace/stress/cell_stress.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "hybrid/smooth_map.hpp"
#include "scene/below_surface.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace rollfem::hybrid {

/// Uniform loads on rectangles of the rolled-out surface: `shapes` has a row for each rectangle and
/// a column for each traction built from them, MPa along one axis.
struct FlatLoads {
  struct Rectangle {
    double x, y, dx, dy;  ///< mm, middle and sides
  };
  std::vector<Rectangle> rectangles;
  Eigen::MatrixXd shapes;
};

/// Cells in which displacement and stress are evaluated at the Gauss points, where derivatives are
/// most accurate.
class GaussStates {
 public:
  /// The cells with these indices among the active cells of the body, which must outlive this
  /// object.
  GaussStates(const fem::Body& body, const std::vector<unsigned int>& cells);
  const std::vector<dealii::Point<3>>& points() const { return places_; }
  /// A row for each point: u_x u_y u_z, xx yy zz xy yz xz in global axes.
  Eigen::MatrixXd at(const fem::Vector& displacement) const;

 private:
  const fem::Body& body_;
  std::vector<dealii::DoFHandler<3>::active_cell_iterator> cells_;
  std::vector<dealii::Point<3>> places_;
  std::vector<std::vector<dealii::Tensor<1, 3>>> gradients_;  ///< of the nodes' functions
  std::vector<std::vector<double>> values_;
};

class BelowParts {
 public:
  /// `box` and `depth` (mm): region of the map. All arguments must outlive this object. Throws
  /// contact::SolveError where the meshes of body and twin differ.
  BelowParts(const contact::BelowSurface& coordinates, const fem::Body& body, const fem::Body& twin,
             const FlatLoads& loads, const SmoothBox& box, double depth);
  /// Displacement and stress of the body less those of its half-space, one row for each point,
  /// under traction `shape` of the loads along `component`. Sign as on the wheel; the rail has the
  /// opposite sign.
  Eigen::MatrixXd beyond(int component, Eigen::Index shape, const fem::Vector& body,
                         const fem::Vector& twin) const;
  /// Coefficients of the polynomials fitted to these rows, column after column of `beyond`.
  Eigen::VectorXd fitted(const Eigen::MatrixXd& beyond) const;
  /// Depth of the deepest points, mm.
  double depth() const { return depth_; }
  int degree() const;
  /// Number of coefficients.
  Eigen::Index terms() const;

 private:
  void choose_points();
  void add_half_space();
  void prepare_fit();

  const contact::BelowSurface& coordinates_;
  const FlatLoads& loads_;
  SmoothBox box_;
  double depth_;
  contact::Material material_;
  bool wheel_, half_;
  std::unique_ptr<GaussStates> body_, twin_;
  std::vector<Eigen::Index> rows_;  ///< of the points in the box
  std::vector<contact::BelowSurface::Coordinates> at_;
  std::vector<halfspace::SubsurfacePoint> flat_;  ///< of the twin
  /// Half-space solution at the twin's points less that at the body's points: a row for each
  /// component of each point, a column for each load.
  std::array<Eigen::MatrixXd, 3> moved_;
  Eigen::MatrixXd even_, odd_;  ///< polynomials at the points, with those of a mirror image
  Eigen::LDLT<Eigen::MatrixXd> normal_;
};

}  // namespace rollfem::hybrid
