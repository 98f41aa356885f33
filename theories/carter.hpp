// SPDX-License-Identifier: LGPL-2.1-or-later
// Carter's theory of a tractive roller in closed form (Carter 1926; Johnson 1985, section 8.3), and
// strip by strip over Hertz's ellipse (Haines and Ollerton 1963): the model "carter".
#pragma once

#include "theories/elliptic_patch.hpp"

namespace rollfem::theories {

struct CarterOptions {
  int strips = 200;
};

/// Line contact of like materials under Hertz's pressure.
struct CarterContact {
  double half_width = 0.0;       ///< a, mm
  double max_pressure = 0.0;     ///< p0, MPa
  double friction = 0.0;         ///< mu
  double contact_modulus = 0.0;  ///< E*, MPa; p0 = E* a / (2 R) ties it to the roller

  double force_per_length() const;     ///< P = pi a p0 / 2, N/mm
  double saturation_creepage() const;  ///< 2 mu p0 / E* = mu a / R: full slip beyond
};

/// Steady rolling at a longitudinal creepage. Tractions and forces are those on the wheel.
class CarterSolution {
 public:
  CarterSolution(const CarterContact& contact, double creepage);

  double stick_half_width() const { return stick_; }                    ///< a', mm
  double stick_middle() const { return contact_.half_width - stick_; }  ///< touches x = +a
  double force() const;                                                 ///< F_x, N/mm
  double work() const { return -force() * creepage_; }  ///< of friction, N/mm per mm rolled
  double traction(double x) const;                      ///< p_x, MPa
  double largest_traction() const;  ///< |p_x|, MPa: where slip begins, or in its middle
  double slip(double x) const;      ///< w_x in the contact, 0 in the stick zone

 private:
  double unit_slip(double x) const;

  CarterContact contact_;
  double creepage_;
  double stick_;
};

/// The model "carter": every strip of Hertz's ellipse rolls as a line contact with the strip's
/// length and pressure, with the extra rigid slip of the case. The forces are exact integrals along
/// x and sums over strips across. Exact for a patch much wider than long; the initial slope is that
/// of plane strain. Longitudinal creepage only.
contact::ModelResult run_carter(const contact::Scene& scene, const contact::Progress& progress);
contact::ModelInfo carter_model();

}  // namespace rollfem::theories
