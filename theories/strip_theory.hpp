// SPDX-License-Identifier: LGPL-2.1-or-later
// Strip theory of an elliptic patch (Haines and Ollerton 1963, Kalker 1967): every strip along
// rolling is a line contact with both components of traction. FaStrip takes its adhesion area.
#pragma once

#include "contact/base/material.hpp"
#include "contact/case/case.hpp"
#include "halfspace/closed_forms/hertz.hpp"

namespace rollfem::theories {

/// One strip of half length a. Its traction on the wheel is, in adhesion,
///   m (k r, l r - P r) - m (k, l) r',  r = sqrt(a^2 - x^2),  r' = sqrt((a - d)^2 - (x - d)^2),
/// so that the slip vanishes there, and reaches the bound m r where adhesion ends, x = 2 d - a.
class StripTheory {
 public:
  struct Traction {
    double x = 0.0, y = 0.0;  ///< MPa
  };

  /// `bound` = mu p_0/a of the ellipse, MPa/mm, above 0. `creepage` is that of the strip at y. The
  /// slopes are scaled to the linear theory's C11, C22 and C23, so that F_x and F_y of small
  /// creepages are Kalker's (Sichani, Enblom and Berg 2016, Vehicle System Dynamics 54, 748-764).
  StripTheory(const halfspace::HertzContact& ellipse, const contact::CombinedMaterial& material,
              double bound, const contact::Creepage& creepage, double y);

  /// Whether the strip adheres at x; from the leading edge as far as 2 d - a.
  bool adheres(double x) const { return x > 2.0 * slip_ - half_length_; }
  /// Its mean over an element of that length about x, where the strip adheres: with small creepages
  /// it grows without bound towards the trailing edge.
  Traction traction(double x, double step) const;

 private:
  double bound_;
  double half_length_;        ///< a, mm
  double slip_ = 0.0;         ///< d, half the length of the slip area, mm; infinite: no adhesion
  double across_ = 0.0;       ///< P
  double k_ = 0.0, l_ = 0.0;  ///< of the part that is taken away
};

}  // namespace rollfem::theories
