// SPDX-License-Identifier: LGPL-2.1-or-later
// Tangential force on a circular Hertz contact at constant normal force (Cattaneo 1938; Mindlin
// 1949; Mindlin and Deresiewicz 1953; Johnson 1985, sections 7.2 and 7.4). Exact for nu = 0, else
// up to a small lateral traction.
#pragma once

#include "contact/scene/geometry.hpp"
#include "halfspace/closed_forms/hertz.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// Circular contact with friction. Tangential force Q, |Q| <= mu P, shift and traction q have the
/// same sign and direction here: those on the body that is pushed along.
class CattaneoMindlin {
 public:
  CattaneoMindlin(const halfspace::HertzContact& contact, const contact::CombinedMaterial& material,
                  double friction)
      : contact_(contact),
        friction_(friction),
        compliance_(2.0 * (2.0 - material.poisson_ratio) / material.shear_modulus) {}

  /// Radius of the adhesion area under a first loading to Q, mm.
  double stick_radius(double force) const {
    return contact_.semi_axis_x * std::cbrt(1.0 - used(force));
  }

  /// Relative tangential shift of the bodies under a first loading to Q, mm.
  double shift(double force) const {
    const double scale =
        3.0 * friction_ * contact_.normal_force * compliance_ / (16.0 * contact_.semi_axis_x);
    const double q = used(force);
    // 1 - (1 - q)^(2/3) without cancellation at small forces.
    const double share = q < 1.0 ? -std::expm1(2.0 / 3.0 * std::log1p(-q)) : 1.0;
    return std::copysign(scale * share, force);
  }

  /// Traction at distance r from the middle, MPa.
  double traction(double force, double r) const {
    const double a = contact_.semi_axis_x;
    const double c = stick_radius(force);
    const auto bump = [r](double radius) {
      const double t = r / radius;
      return t < 1.0 ? std::sqrt((1.0 - t) * (1.0 + t)) : 0.0;
    };
    const double value = bump(a) - (c > 0.0 ? c / a * bump(c) : 0.0);
    return std::copysign(friction_ * contact_.max_pressure * value, force);
  }

  /// The same after loading to `turned` and back to Q, -turned <= Q <= turned.
  double unloading_shift(double turned, double force) const {
    return shift(turned) - 2.0 * shift(0.5 * (turned - force));
  }
  double unloading_traction(double turned, double force, double r) const {
    return traction(turned, r) - 2.0 * traction(0.5 * (turned - force), r);
  }

  /// Work lost in one cycle of force between -Q and Q, N mm (Johnson 1985, eq. 7.57).
  double cyclic_loss(double amplitude) const {
    const double q = used(amplitude);
    const double limit = friction_ * contact_.normal_force;
    const double rest = std::cbrt(1.0 - q);
    const double bracket = 1.0 - std::pow(rest, 5) - 5.0 * q / 6.0 * (1.0 + rest * rest);
    return 9.0 * limit * limit * compliance_ / (10.0 * contact_.semi_axis_x) * bracket;
  }

 private:
  /// |Q| / (mu P).
  double used(double force) const {
    return std::min(1.0, std::abs(force) / (friction_ * contact_.normal_force));
  }

  halfspace::HertzContact contact_;
  double friction_;
  double compliance_;  ///< (2 - nu1)/G1 + (2 - nu2)/G2, 1/MPa
};

}  // namespace rollfem::testing
