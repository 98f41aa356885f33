// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel or rail profile as one smooth parametric curve in its profile coordinates: y towards the
// field side (the flange or the gauge face is at smaller y), z down for the rail, outward from the
// axle for the wheel (which is down too at the contact). Cubic pieces, so that the curvature jumps
// only where the profile's curvature does.
#pragma once

#include "scene/height_curve.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rollfem::profiles {

/// Points along a profile, mm.
struct PointRow {
  std::vector<double> y, z;
};

/// A point on a profile.
struct ProfilePoint {
  double y = 0.0;          ///< mm
  double z = 0.0;          ///< mm
  double tangent_y = 1.0;  ///< unit tangent, in the direction of increasing parameter
  double tangent_z = 0.0;
  double curvature = 0.0;  ///< 1/mm, > 0 where the curve turns towards +z (y rising): a rail head
};

/// A knot with derivatives by the parameter, which increases from the gauge or flange side to the
/// field side and is close to the arc length, in mm.
struct ProfileKnot {
  double parameter = 0.0;
  double y = 0.0, z = 0.0;    ///< mm
  double dy = 0.0, dz = 0.0;  ///< by the parameter; right limits at jumps
};

class ProfileCurve {
 public:
  ProfileCurve() = default;
  /// At least two knots with increasing parameters. `rounding`: standard deviation of the points,
  /// mm, where it matters. Throws std::invalid_argument.
  explicit ProfileCurve(std::vector<ProfileKnot> knots, double rounding = 0.0);

  ProfilePoint at(double parameter) const;
  /// y and z over the parameter.
  std::array<contact::CurveValue, 2> by_parameter(double parameter) const;
  double first() const { return knots_.front().parameter; }
  double last() const { return knots_.back().parameter; }
  const std::vector<ProfileKnot>& knots() const { return knots_; }
  double rounding() const { return rounding_; }
  /// Parameter of the point with this y, or of the nearer end; the lowest if several (an undercut
  /// profile).
  double parameter_at(double y) const;

  /// The profile rotated about (0, 0) by the angle (rad, from y to z) and then shifted by (y, z).
  ProfileCurve moved(double angle, double y, double z) const;
  /// The knots with parameters between these, and one beyond each end.
  ProfileCurve part(double from, double to) const;
  /// Mirrored at y = 0; parameters still increase from small to large y.
  ProfileCurve mirrored() const;

 private:
  std::vector<ProfileKnot> knots_;
  double rounding_ = 0.0;
  std::vector<double> highest_y_, lowest_y_;  ///< mm, of the knots up to each
};

/// The deepest place of a row of heights (z down) that has higher places on both sides: the groove
/// between two heads, the tip of a flange.
struct Valley {
  std::size_t bottom = 0;
  std::size_t left = 0, right = 0;  ///< the highest places on its sides
  double depth = 0.0;               ///< mm below the lower one of these; 0: there is no valley
};
Valley deepest_valley(const std::vector<double>& z);

/// The middle one by size, of an even number the upper one.
double median(std::vector<double> values);

/// Parameter of the knot nearest to a point.
double parameter_near(const ProfileCurve& curve, double y, double z);

/// Parameters of the knots and between them, at most `step` apart (mm); knots closer than `least`
/// are skipped, as in a dense measured list.
std::vector<double> dense_parameters(const ProfileCurve& curve, double step, double least = 0.0);

/// Largest slope dz/dy at which a profile is treated as a height over y.
inline constexpr double steepest = 12.0;

/// Height z over y of the part of the curve about `parameter` that is single valued and not steeper
/// than `steepest`. Throws contact::SolveError when it is steeper at `parameter` itself.
contact::HeightCurve height_over_y(const ProfileCurve& curve, double parameter);

// Features of a profile: ends, length, extreme points, radii, joints of its curvature.

/// A point at which the curvature jumps.
struct ProfileJoint {
  double parameter = 0.0;
  ProfilePoint place;             ///< with the curvature on the right
  double curvature_before = 0.0;  ///< 1/mm, on the left
};

struct ProfileFeatures {
  ProfilePoint start, end;
  double length = 0.0;         ///< mm
  ProfilePoint top;            ///< smallest z: the top of a rail's head
  ProfilePoint bottom;         ///< largest z: the tip of a flange
  ProfilePoint sharpest_up;    ///< of the largest curvature > 0 (a head); 0 when there is none
  ProfilePoint sharpest_down;  ///< of the largest curvature < 0; 0 when there is none
  std::vector<ProfileJoint> joints;
  /// y of the profile on the side of small y at 14 mm below the top (rail) or at z = 10 (wheel,
  /// where the flange's thickness is measured, when its tape line is at (0, 0)), mm.
  std::optional<double> gauge_face;
};

ProfileFeatures profile_features(const ProfileCurve& curve, bool wheel);

/// A profile as rows for tables and figures.
struct ProfileRow {
  double s = 0.0;          ///< mm along the profile, from the gauge or flange side
  double y = 0.0;          ///< mm
  double z = 0.0;          ///< mm
  double angle = 0.0;      ///< degrees, of the tangent from y to z
  double curvature = 0.0;  ///< 1/mm, of ProfilePoint
};

/// Every tenth of a millimetre, and two rows at every joint, one for each side.
std::vector<ProfileRow> profile_rows(const ProfileCurve& curve, bool wheel);

/// degrees
double angle_of(const ProfilePoint& place);

}  // namespace rollfem::profiles
