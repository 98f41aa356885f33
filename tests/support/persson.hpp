// SPDX-License-Identifier: LGPL-2.1-or-later
// Persson's conformal contact in closed form: a disc in the hole of an infinite plate, plane
// strain, no friction, like materials, where Hertz's theory has errors of up to 17 %.
#pragma once

#include "support/test.hpp"

namespace rollfem::testing {

/// Persson 1964, "On the stress distribution of cylindrical elastic bodies in contact", as checked
/// against a Fourier solution of disc and plate in reference/benchmarks.md, section 10. The disc of
/// radius R is loaded at its middle by Q per unit length; the hole's radius is R + dR.
struct PerssonContact {
  double half_angle = 0.0;  ///< rad, half of the angle over which the disc touches, < pi

  /// E1* dR / Q with E1* = E / (1 - nu^2) of one body: load and clearance for that angle. Negative
  /// beyond 84.8 degrees: interference.
  double clearance_number() const {
    const double b2 = std::pow(std::tan(half_angle / 2), 2);
    return (2 * (1 - b2 * b2) - std::log1p(b2)) / (M_PI * b2 * (1 + b2));
  }

  /// p R / Q at the angle `phi` from the middle of the contact, 0 where it does not touch.
  double pressure(double phi) const {
    const double b2 = std::pow(std::tan(half_angle / 2), 2);
    const double y2 = std::pow(std::tan(phi / 2), 2);
    if (y2 >= b2) return 0.0;
    const double root = std::sqrt(b2 - y2);
    const double whole = std::sqrt(1 + b2);
    return 2 / (M_PI * whole) * root / (1 + y2) +
           std::log((whole + root) / (whole - root)) / (2 * M_PI * b2 * (1 + b2));
  }
};

}  // namespace rollfem::testing
