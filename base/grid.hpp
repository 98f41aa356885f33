// SPDX-License-Identifier: LGPL-2.1-or-later
// The contact grid: a rectangle of equal rectangular elements in the contact plane (the potential
// contact area), on which every model has its tractions, and the fields on it.
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace rollfem::contact {

/// One value per contact element, index j * nx + i (x runs fastest).
using Field = Eigen::VectorXd;

/// Tangential vector per element: tractions in MPa or displacement differences in mm, slip without
/// a unit.
struct TangentialField {
  Field x;
  Field y;
};

/// Full vector per element. `n` is the normal component: pressure (MPa, positive in compression)
/// or normal displacement difference (mm, positive when it opens the gap).
struct SurfaceField {
  Field x;
  Field y;
  Field n;
};

/// Shape of a patch that is curved across, per element; both fields empty where it is plane.
struct PatchShape {
  Field stretch;  ///< true area / (dx dy), >= 1
  Field climb;    ///< dz/dy of the contact surface
  /// y of the elements where the grid's own y is the arc length along the surface, with a stretch
  /// of 1; empty: the grid lies in the projection on z = 0.
  Field y{};
};

/// Potential contact area of nx by ny elements of dx by dy mm. x is the rolling direction
/// (material enters at large x), y is lateral; `x_first`, `y_first` is the centre of element (0,0).
///
/// A line contact has one row (ny = 1) of laterally endless elements; dy is the width to which
/// forces refer.
struct ContactGrid {
  int nx = 0;
  int ny = 0;
  double dx = 0.0;
  double dy = 0.0;
  double x_first = 0.0;
  double y_first = 0.0;
  /// mm, > 0: a line contact, whose displacements are relative to the surface displacement at this
  /// distance from a line load, because half-planes have no fixed point at infinity.
  double line_reference = 0.0;

  bool is_line() const { return line_reference > 0.0; }
  int size() const { return nx * ny; }
  int index(int i, int j) const { return j * nx + i; }
  double x(int i) const { return x_first + i * dx; }
  double y(int j) const { return y_first + j * dy; }
  double element_area() const { return dx * dy; }
  /// Longer side of an element, mm; elements of a line contact have no side across.
  double longer_side() const { return is_line() ? dx : std::max(dx, dy); }

  /// Grid of nx by ny elements whose middle is at (x_middle, y_middle).
  static ContactGrid centred(int nx, int ny, double dx, double dy, double x_middle = 0.0,
                             double y_middle = 0.0) {
    return {nx, ny, dx, dy, x_middle - 0.5 * (nx - 1) * dx, y_middle - 0.5 * (ny - 1) * dy};
  }

  /// The grid extended by this many columns and rows of elements on each side; a line contact keeps
  /// one row.
  ContactGrid widened(int columns, int rows) const {
    if (is_line()) rows = 0;
    return {nx + 2 * columns,    ny + 2 * rows, dx, dy, x_first - columns * dx,
            y_first - rows * dy, line_reference};
  }

  /// `function(x, y)` at every element centre.
  template <class Function>
  Field sample(Function&& function) const {
    Field values;
    sample_into(values, function);
    return values;
  }
  /// The same into an existing field.
  template <class Function>
  void sample_into(Field& values, Function&& function) const {
    values.resize(size());
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) values[index(i, j)] = function(x(i), y(j));
  }
};

// The output of a compliance.

/// Response of two rolling bodies to tractions.
struct Response {
  SurfaceField displacement;
  /// Slip beyond the upwind difference of the displacement: on a streamline of radius R a
  /// displacement u_r towards the centre shortens the material by u_r / R along x; where the
  /// surface is tilted across, the turning frame adds a lateral component. Empty for straight
  /// streamlines.
  TangentialField curvature_slip;
};

}  // namespace rollfem::contact
