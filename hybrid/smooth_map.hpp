// SPDX-License-Identifier: LGPL-2.1-or-later
// The smooth part of the difference between a curved, finite body and its half-space, as a map
// between polynomials over the patch: tractions enter by their moments, displacement is a
// polynomial, below the surface also the stress. It is the same on every contact grid and costs
// almost nothing.
#pragma once

#include "base/grid.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/note.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace rollfem::hybrid {

/// Box in which polynomials are scaled to [-1, 1]: x along rolling, y along the common surface of
/// the bodies (arc length), mm.
struct SmoothBox {
  double half_length = 1.0;
  double half_width = 1.0;
  double middle = 0.0;  ///< of y
};

/// T_0 ... T_degree at some places, one column each.
Eigen::MatrixXd chebyshev(int degree, const contact::Field& at);

/// Powers i, j of the Chebyshev polynomials T_i(x) T_j(y) of total degree up to `degree`, in the
/// order of the columns of polynomials().
std::vector<std::array<int, 2>> polynomial_powers(int degree);

/// Their values at points (x, y), one column for each polynomial.
Eigen::MatrixXd polynomials(const SmoothBox& box, int degree, const contact::Field& x,
                            const contact::Field& y);

/// Contribution of one body to u_wheel - u_rail under tractions on the wheel.
struct SmoothMap {
  SmoothBox loads;   ///< of the moments
  SmoothBox fields;  ///< of the displacement (and stress)
  int load_degree = 0;
  int field_degree = 0;
  /// Coefficients (mm) of u_x, then u_y, then u_n, from the moments (N) of p_x, p_y, p_n. Empty:
  /// zero.
  Eigen::MatrixXd coefficients;

  bool empty() const { return coefficients.size() == 0; }
};

/// Difference between one body and its half-space below the surface. Its coefficients are those of
/// the smooth_components in order (mm, MPa).
struct SmoothDepthMap : SmoothMap {
  double depth = 0.0;  ///< mm, depth of the map
};

/// Maps of both bodies.
struct SmoothParts {
  SmoothMap wheel;
  SmoothMap rail;
  SmoothDepthMap wheel_below;
  SmoothDepthMap rail_below;
  bool stresses = false;             ///< the subsurface maps were computed
  long unknowns = 0;                 ///< of the finite elements
  std::vector<contact::Note> notes;  ///< description of the computation
};

/// A map with its polynomials at the elements of a grid whose y runs along the common surface.
/// Beyond the box of the displacement, where polynomials soon exceed all bounds, it has the values
/// of the nearest place in it.
class SmoothMapOnGrid {
 public:
  SmoothMapOnGrid(const SmoothMap& map, const contact::ContactGrid& grid);
  /// Displacement, mm, under tractions in MPa.
  contact::SurfaceField apply(const contact::SurfaceField& traction) const;

 private:
  Eigen::MatrixXd coefficients_;
  Eigen::MatrixXd loads_;  ///< polynomials times the area of an element
  Eigen::MatrixXd fields_;
};

// Displacement and stress below the surface.

/// Displacement along rolling, across and along the normal into the wheel, and the stress xx yy zz
/// xy yz xz along these.
inline constexpr int smooth_components = 9;

/// Values of the polynomials of total degree up to `degree` at a point with a depth from 0 to
/// `depth` mm. Points outside box and depth are moved to the nearest limit.
Eigen::VectorXd depth_polynomials(const SmoothBox& box, double depth, int degree,
                                  const halfspace::SubsurfacePoint& at);
/// Number of polynomials.
Eigen::Index depth_polynomial_count(int degree);

/// Difference between one body and its half-space under the tractions of a grid.
class SmoothStressOnGrid {
 public:
  /// `map` is not empty.
  SmoothStressOnGrid(const SmoothDepthMap& map, const contact::ContactGrid& grid,
                     const contact::SurfaceField& traction);
  /// Adds the difference to the state at a point. Outside the box it fades with the square of the
  /// distance.
  void add(const halfspace::SubsurfacePoint& at, halfspace::SubsurfaceState& state) const;

 private:
  SmoothBox fields_;
  double depth_;
  int degree_;
  Eigen::MatrixXd coefficients_;  ///< a column for each component
};

}  // namespace rollfem::hybrid
