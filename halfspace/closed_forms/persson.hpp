// Persson's conformal contact in closed form: a disc in the hole of an infinite plate, plane
// strain, no friction, like materials, where Hertz's theory is off by up to 17 %.
#pragma once

namespace rollfem::halfspace {

/// Persson 1964, "On the stress distribution of cylindrical elastic bodies in contact", as checked
/// against a Fourier solution of disc and plate in reference/benchmarks.md, section 10. The disc of
/// radius R is loaded at its middle by Q per unit length; the hole's radius is R + dR.
struct PerssonContact {
  double half_angle = 0.0;  ///< rad, half of the angle over which the disc touches, < pi
  /// E1* dR / Q with E1* = E / (1 - nu^2) of one body: what load and clearance must be for that
  /// angle. Negative beyond 84.8 degrees: interference.
  double clearance_number() const;
  /// p R / Q at the angle `phi` from the middle of the contact, 0 where it does not touch.
  double pressure(double phi) const;
};

}  // namespace rollfem::halfspace
