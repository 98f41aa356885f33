// Normal displacement of the half-space surface under two circular pressures in elementary
// functions and complete elliptic integrals (Johnson 1985, sections 3.4 and 3.5). Hertz's ellipse:
// hertz.hpp.
#pragma once

#include "halfspace/closed_forms/hertz.hpp"

namespace rollfem::halfspace {

/// Hertz's circular patch: sum of the normal displacements of both bodies (mm) at distance `radius`
/// from the middle, E* in MPa (eq. 3.41a and 3.42a). Throws contact::InputError when the semi-axes
/// differ.
double hertz_circle_displacement(const HertzContact& contact, double contact_modulus,
                                 double radius);

/// Uniform pressure (MPa) on a circle of radius a, at distance r from its middle (eq. 3.29).
double uniform_circle_displacement(double pressure, double a, double contact_modulus, double r);

}  // namespace rollfem::halfspace
