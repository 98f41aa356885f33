// Builds profiles from exact pieces (arcs, lines, polynomials), with knots by arc length so
// dense that the cubics between them represent the formula.
#pragma once

#include "profiles/profile_curve.hpp"

#include <functional>

namespace rollfem::profiles {

/// Point of a piece at a parameter of its own, with derivatives by it.
struct PiecePoint {
  double y = 0.0, z = 0.0;
  double dy = 0.0, dz = 0.0;
};

/// Distance of knots along the profile, mm: a circle of 10 mm is met within 1e-11 mm and its
/// curvature within 2e-6.
constexpr double knot_distance = 0.05;

/// Adds a piece between two of its parameters; its start is the end of what is there already.
void append_piece(ProfileKnots& knots, const std::function<PiecePoint(double)>& piece, double from,
                  double to, double distance = knot_distance);

/// Part of a circle about (`y`, `z`); angles in rad from the direction of -z (upwards), rising to
/// +y: the top of a rail head is at 0. The tangent turns with the angle: (cos, sin). `hollow`: the
/// circle lies above instead, at (y + R sin, z + R cos), and the tangent is (cos, -sin).
void append_arc(ProfileKnots& knots, double y, double z, double radius, double from, double to,
                bool hollow = false);

void append_line(ProfileKnots& knots, double y0, double z0, double y1, double z1);

}  // namespace rollfem::profiles
