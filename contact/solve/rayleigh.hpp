// Speed of surface waves: what limits the speed at which a load may move over an elastic body.
#pragma once

#include "contact/case/case.hpp"

namespace rollfem::contact {

/// Rolling speeds from this fraction of the Rayleigh speed on are refused: the response to a moving
/// load grows without bound towards it and the stiffness with inertia turns indefinite beyond.
inline constexpr double largest_rayleigh_fraction = 0.9;

/// Rayleigh's wave speed in mm/s, inf for a massless or rigid body. With e = (c/c_s)^2, c_s the
/// speed of shear waves and k = (1 - 2 nu)/(2 (1 - nu)): e^3 - 8 e^2 + (24 - 16 k) e = 16 (1 - k),
/// the root between 0 and 1 (Lord Rayleigh, Proc. London Math. Soc. 17 (1885)).
double rayleigh_speed(const Material& material);

}  // namespace rollfem::contact
