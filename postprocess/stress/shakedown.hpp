// SPDX-License-Identifier: LGPL-2.1-or-later
// The shakedown map of rolling and sliding contact (Johnson 1985, section 9.2; Johnson 1989): load
// factor p0/k, with the yield stress in shear k, against traction coefficient T/N. Below the lower
// boundary nothing yields. Below the upper one residual stresses make later passages elastic; above
// it the material yields at every passage.
//
// The boundaries assume tractions proportional to Hertz's pressure, T/N p (full slip), Poisson's
// ratio 0.3 and von Mises's condition, for a line contact (plane strain) and a circle:
// - elastic: p0 at which the largest von Mises stress is sqrt(3) k. Without friction 3.11 k for the
//   line, 2.79 k for the circle.
// - shakedown: p0 at which the largest |xz| anywhere, the shear on planes parallel to the surface,
//   is k (narrow ellipses: EllipseStress). Residual stress that is uniform along the rolling
//   direction can balance every component except xz (for the line, Melan's theorem then gives
//   exactly this value). Without friction 4.00 k (Johnson 1962) and 4.68 k (Ponter, Hearle &
//   Johnson 1985); where the surface decides, 1/(T/N). Below a circle with friction residual stress
//   balances a part of xz too, so that this boundary is on the safe side (by 20 % at T/N = 0.2,
//   docs/plasticity.md).
#pragma once

#include "contact/result/stress_measures.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Largest p0/k at a traction coefficient.
struct ShakedownLimits {
  double elastic = 0.0;
  double shakedown = 0.0;
};

/// Line contact, from the closed form of the field of a sliding cylinder (McEwen; Johnson 1985,
/// sections 4.2 and 7.1), to 1e-3. `traction_coefficient` >= 0.
ShakedownLimits line_contact_limits(double traction_coefficient);

/// Circular contact, to 2e-3: below the surface from a table computed with the exact integrals of
/// half-space elements (160 across the circle), at the surface from closed forms (Hamilton 1983).
ShakedownLimits point_contact_limits(double traction_coefficient);

/// Stress over p0 on the surface of the circle along y = 0, |x| <= 1 in radii, under pressure p and
/// traction friction times p along +x, z into the material (Hamilton 1983; Johnson 1985, sections
/// 3.4 and 7.1): tension at x = -1, where the surface yields first.
contact::Stress sliding_circle_surface(double x, double friction);

/// Yield stress in shear for a yield strength Y in tension by von Mises's condition: Y / sqrt(3).
double yield_shear_stress(double yield_strength);

/// Surface fatigue index of Ekberg, Kabo & Andersson (2002), T/N - k/p0: positive if the surface is
/// expected to ratchet.
double surface_fatigue_index(double traction_coefficient, double load_factor);

/// "elastic", "elastic shakedown" or "beyond shakedown": where a point lies in the map.
std::string shakedown_region(const ShakedownLimits& limits, double load_factor);

/// The shakedown limit of an elliptic contact from the stress in the plane y = 0 below a sliding
/// Hertz ellipse, under the pressure p0 sqrt(1 - (x/a)^2 - (y/b)^2) and friction times this
/// pressure along x. The smaller one of two bounds: that of the largest xz, and Melan's theorem for
/// two instants of a passage. A fixed residual stress keeps both within the yield surface only if
/// their elastic stresses differ by at most 2 sqrt(3) k (von Mises); without load the stress is 0.
/// The second one decides below patches narrower than b/a = 0.65, at y = 0.
class EllipseStress {
 public:
  /// `ratio`: b/a, semi-axis across over semi-axis along rolling; clamped to 0.1 to 50. Infinite: a
  /// line contact.
  explicit EllipseStress(double ratio);
  double ratio() const { return ratio_; }
  bool is_line() const { return std::isinf(ratio_); }
  /// p0/k above which the material yields at every passage, to 5e-3.
  double shakedown_limit(double friction) const;

 private:
  double ratio_;
  /// On lines along rolling, by the pressure and by the same traction along x.
  std::vector<std::array<contact::Stress, 2>> stress_;
};

}  // namespace rollfem::postprocess
