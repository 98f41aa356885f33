// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles from tangent arcs and from polynomials, as given in a case.
#pragma once

#include "contact/case/track.hpp"
#include "profiles/profile_curve.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace rollfem::profiles {

/// Arcs tangent to each other, through (0, 0); `name`: file and section for messages. Throws
/// contact::InputError for lists of wrong length or an arc that ends beyond its vertical tangent.
ProfileCurve arc_profile_curve(const contact::ProfileSource& source, bool wheel,
                               const std::string& name);

/// Pieces z(y) that meet in value and slope. Throws contact::InputError.
ProfileCurve polynomial_profile_curve(const contact::ProfileSource& source,
                                      const std::string& name);

// Standard profiles from their analytic definitions: wheel S1002 (EN 13715, UIC 510-2), rails of EN
// 13674-1 and the profiles of the Manchester contact benchmark.

struct BuiltInProfile {
  std::string name;
  bool wheel = false;
  std::string sentence;
  ProfileCurve (*make)() = nullptr;
};

const std::vector<BuiltInProfile>& built_in_profiles();

/// nullptr for an unknown name.
const BuiltInProfile* find_built_in_profile(const std::string& name);

/// Wheel S1002. `smooth`: zone C is moved to its neighbours as a whole, by up to 1.2e-4 mm (within
/// the uncertainty of its printed digits), and the curvature follows the formulas. Otherwise the
/// formulas hold everywhere except within 0.23 mm about y = -35 and 0.31 mm about y = -26, where
/// their steps are blended.
ProfileCurve s1002(bool smooth);

/// Height of S1002 by the formulas of its zones, mm, for -70 <= y <= 60, including the steps at the
/// zone limits: reference for checking the curve. Throws std::out_of_range outside.
double s1002_height(double y);

// Builds profiles from exact pieces (arcs, polynomials), with knots dense enough along the
// arc for the cubics between them to represent the formula.

/// Point of a piece at its local parameter, with derivatives by that parameter.
struct PiecePoint {
  double y = 0.0, z = 0.0;
  double dy = 0.0, dz = 0.0;
};

/// Spacing of knots along the profile, mm: a circle of 10 mm is represented within 1e-11 mm and its
/// curvature within 2e-6.
constexpr double knot_distance = 0.05;

/// Adds a piece between two of its parameters, starting at the end of the previous piece.
void append_piece(ProfileKnots& knots, const std::function<PiecePoint(double)>& piece, double from,
                  double to, double distance = knot_distance);

/// Value and slope at y of a polynomial, lowest power first.
std::array<double, 2> polynomial(const double* coefficients, std::size_t count, double y);

}  // namespace rollfem::profiles
