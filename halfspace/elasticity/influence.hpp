// SPDX-License-Identifier: LGPL-2.1-or-later
// Influence coefficients of the elastic half-space: displacement difference at an element centre
// under unit traction on another element, in closed form (Boussinesq and Cerruti's point loads,
// Johnson 1985 eq. 3.18 and section 3.6, integrated over the rectangle with corner functions).
#pragma once

#include "base/material.hpp"
#include "scene/geometry.hpp"

namespace rollfem::halfspace {

/// Displacement difference (wheel minus rail, mm) per unit traction on the wheel (MPa): first index
/// displacement, second index traction. The whole block is
/// [xx xy xn; xy yy yn; -xn -yn nn]: xn and yn change sign with the offset, so that the matrix over
/// all elements is symmetric. They are proportional to K and vanish for like materials.
struct Influence {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  double nn = 0.0;
  double xn = 0.0;  ///< u_x under pressure: -K/(pi G) times the integral of x/r^2
  double yn = 0.0;  ///< u_y under pressure
};

/// Coefficients for a uniformly loaded rectangle of dx by dy mm, at a point with offset (x, y) mm
/// from its centre. Relative accuracy about 1e-12 at any distance: corner functions near, Gauss
/// quadrature where they would suffer from cancellation.
Influence rectangle_influence(double x, double y, double dx, double dy,
                              const contact::CombinedMaterial& material);

/// The same for a laterally endless element of dx mm in plane strain, relative to the displacement
/// at the distance `reference` (mm) from a line load: the rectangle's coefficient without its
/// constant, in closed form (Johnson 1985, eq. 2.30 to 2.33). `finite`: relative to distant points,
/// in the middle of a load of length L = `reference` (L >> |x|). The integrals along y of 1/R,
/// Y^2/R^3 and X^2/R^3 are 2 ln(L/|x|), 2 ln(L/|x|) - 2 and 2, which leaves nn as it is, adds
/// nu dx to xx/scale and takes it from yy/scale, scale = 2/(pi G).
Influence line_influence(double x, double dx, double reference,
                         const contact::CombinedMaterial& material, bool finite = false);

/// Effect of an element of the grid on the element i columns and j rows farther.
Influence element_influence(const contact::ContactGrid& grid, int i, int j,
                            const contact::CombinedMaterial& material);

// Deflection beside a row of elements along rolling under a semi-elliptic pressure.

/// G(t), the integral over |u| < 1 of sqrt(1 - u^2) / sqrt(u^2 + t^2): at lateral distance s from
/// its middle, a row of half length a with unit pressure in its middle deflects the half-space by
/// G(s / a) / (pi E*) times its width. From a table over ln t, with relative accuracy 1e-3.
double row_deflection(double t);

}  // namespace rollfem::halfspace
