// Features of a profile: ends, length, extreme points, radii, joints of its curvature.
#pragma once

#include "profiles/profile_curve.hpp"

#include <optional>
#include <vector>

namespace rollfem::profiles {

/// A place at which the curvature jumps.
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

}  // namespace rollfem::profiles
