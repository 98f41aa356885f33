// Tangential force on a circular Hertz contact at constant normal force (Cattaneo 1938; Mindlin
// 1949; Mindlin and Deresiewicz 1953; Johnson 1985, sections 7.2 and 7.4). Exact for nu = 0, else
// up to a small lateral traction.
#pragma once

#include "contact/scene/geometry.hpp"
#include "halfspace/closed_forms/hertz.hpp"

namespace rollfem::halfspace {

/// Circular contact with friction. Tangential force Q, shift and traction q have the same sign and
/// direction here: those on the body that is pushed along.
class CattaneoMindlin {
 public:
  /// Throws contact::InputError when the patch is not circular or mu is not positive.
  CattaneoMindlin(const HertzContact& contact, const contact::CombinedMaterial& material,
                  double friction);

  /// Radius of the adhesion area under a first loading to Q, mm. |Q| <= mu P here and below, else
  /// contact::InputError.
  double stick_radius(double force) const;
  /// Relative tangential shift of the bodies under a first loading to Q, mm.
  double shift(double force) const;
  /// Traction at distance r from the middle, MPa.
  double traction(double force, double r) const;

  /// The same after loading to `turned` and back to Q, -turned <= Q <= turned.
  double unloading_shift(double turned, double force) const;
  double unloading_traction(double turned, double force, double r) const;

  /// Work lost in one cycle of force between -Q and Q, N mm (Johnson 1985, eq. 7.57).
  double cyclic_loss(double amplitude) const;

 private:
  double used(double force) const;

  HertzContact contact_;
  double friction_;
  double compliance_;  ///< (2 - nu1)/G1 + (2 - nu2)/G2, 1/MPa
};

}  // namespace rollfem::halfspace
