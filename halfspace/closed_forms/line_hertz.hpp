// Hertz's line contact of endless rollers in closed form (Johnson 1985, section 4.2c).
#pragma once

namespace rollfem::halfspace {

/// Line contact of h = x^2 / (2 R).
struct LineHertz {
  double half_width = 0.0;    ///< a, mm, along rolling
  double max_pressure = 0.0;  ///< p0, MPa
  /// mm, relative to the surface at the distance `reference` from a line load of the same force:
  /// (2 P / (pi E*)) (ln(2 reference / a) + 1/2). Of rollers as wide as `reference` it is what
  /// their middles approach each other by.
  double approach = 0.0;
};

/// `force_per_length` P in N/mm, R in mm, E* in MPa. Throws contact::InputError when one of them is
/// not positive.
LineHertz line_hertz(double radius, double contact_modulus, double force_per_length,
                     double reference);

/// u_wheel - u_rail in mm, normal component, at x: approach - h in the contact.
double line_displacement(const LineHertz& contact, double contact_modulus, double x);

}  // namespace rollfem::halfspace
