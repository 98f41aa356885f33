// SPDX-License-Identifier: LGPL-2.1-or-later
// Error of a finite-element body in the energy norm, estimated from the difference between the
// recovered stress and the element stress (Zienkiewicz and Zhu 1992, "The superconvergent patch
// recovery and a posteriori error estimates").
#pragma once

#include "fem/stress/stress_recovery.hpp"

namespace rollfem::fem {

struct EnergyError {
  double error = 0.0;  ///< ||u - u_h||_E estimated, sqrt(N mm), ||u||_E^2 = int sigma : eps
  double norm = 0.0;   ///< ||u_h||_E
  double relative() const { return norm > 0.0 ? error / norm : 0.0; }
};

/// Collective. `stress`: StressRecovery::recover of the same displacement.
EnergyError energy_error(const Body& body, const Vector& displacement, const NodalStress& stress);

}  // namespace rollfem::fem
