// SPDX-License-Identifier: LGPL-2.1-or-later
// Hertz's elliptic contact in closed form (Johnson 1985, chapter 4), any aspect ratio.
#pragma once

#include "scene/geometry.hpp"
#include "scene/scene.hpp"

namespace rollfem::halfspace {

/// Elliptic contact of h = A x^2 + B y^2.
struct HertzContact {
  double semi_axis_x = 0.0;   ///< mm
  double semi_axis_y = 0.0;   ///< mm
  double max_pressure = 0.0;  ///< MPa
  double approach = 0.0;      ///< mm
  double normal_force = 0.0;  ///< N
  /// p(x, y), 0 outside the ellipse.
  double pressure(double x, double y) const;
};

/// A, B > 0 in 1/mm, E* in MPa. Throws contact::InputError when A or B is not positive (line
/// contact, for which the approach of two half-spaces is unbounded).
HertzContact hertz_from_force(double A, double B, double contact_modulus, double normal_force);
HertzContact hertz_from_approach(double A, double B, double contact_modulus, double approach);

/// A and B of the bodies.
contact::Curvatures hertz_curvatures(const HertzContact& contact, double contact_modulus);

/// Hertz's contact for the radii (or quadratic undeformed distance), materials and load of a case;
/// or the given pressure. For a line contact semi_axis_y is half its width, and nothing depends on
/// y: pressure() holds on y = 0, the row of elements. Throws contact::InputError when the contact
/// is not elliptic, or the bodies are given point by point.
HertzContact hertz_of_scene(const contact::Scene& scene);

/// A and B of the case; for a given pressure, the A and B of its ellipse. Throws as hertz_of_scene.
contact::Curvatures curvatures_of_scene(const contact::Scene& scene);

/// u_wheel - u_rail in mm, normal component, at any point of the surface: inside the patch
/// approach - h, outside the closed form with the confocal ellipse.
double hertz_displacement(const HertzContact& contact, double contact_modulus, double x, double y);

// Hertz's line contact of endless rollers in closed form (Johnson 1985, section 4.2c).

/// Line contact of h = x^2 / (2 R).
struct LineHertz {
  double half_width = 0.0;    ///< a, mm, along rolling
  double max_pressure = 0.0;  ///< p0, MPa
  /// mm, relative to the surface at the distance `reference` from a line load of the same force: (2
  /// P / (pi E*)) (ln(2 reference / a) + 1/2). For rollers as wide as `reference` it is the
  /// approach of their middles.
  double approach = 0.0;
};

/// Distance to which normal displacements are relative, mm; for distant points, the width.
double reference_of(const contact::LineContact& line);

/// `force_per_length` P in N/mm, R in mm, E* in MPa. Throws contact::InputError when one of them is
/// not positive.
LineHertz line_hertz(double radius, double contact_modulus, double force_per_length,
                     double reference);

/// `approach` in mm; throws also if it is as large as no patch within twice the reference has.
LineHertz line_hertz_from_approach(double radius, double contact_modulus, double approach,
                                   double reference);

/// u_wheel - u_rail in mm, normal component, at x: approach - h in the contact.
double line_displacement(const LineHertz& contact, double contact_modulus, double x);

}  // namespace rollfem::halfspace
