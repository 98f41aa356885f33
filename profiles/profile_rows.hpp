// SPDX-License-Identifier: LGPL-2.1-or-later
// A profile as rows for tables and figures.
#pragma once

#include "profiles/profile_curve.hpp"

#include <vector>

namespace rollfem::profiles {

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
