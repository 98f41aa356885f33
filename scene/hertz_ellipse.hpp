// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of Hertz's ellipse, and the load that gives a largest pressure (Johnson 1985, chapter 4).
#pragma once

#include "scene/geometry.hpp"

namespace rollfem::contact {

/// Semi-axes a along rolling, b across. Carlson's symmetric integrals instead of Legendre's K and
/// E: they need no distinction of major and minor axis and lose no digits at the circle. For any k
/// > 0 [Johnson 1985, eqs. 4.26, 4.27]:
///   A = p0/E* (b/a^2) R_D(0, k^2, 1)/3,  B = p0/E* (b/a^2) R_D(0, 1, k^2)/3,
///   approach = p0/E* b R_F(0, k^2, 1).
struct HertzEllipse {
  double k;   ///< b/a
  double rd;  ///< R_D(0, k^2, 1)
  double rf;  ///< R_F(0, k^2, 1)
};

/// A, B > 0 of the undeformed distance.
HertzEllipse hertz_ellipse(double A, double B);

/// Force on an ellipse, or on the width of a line contact, N, whose largest pressure by Hertz is
/// `max_pressure` in MPa. For geometries with a quadratic distance.
double hertz_force(const Geometry& geometry, const CombinedMaterial& material, double max_pressure);

}  // namespace rollfem::contact
