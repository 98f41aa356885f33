// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of a profile's points: kinks, at which the curve turns once, and steps, there and back.
#pragma once

#include "profiles/profile_points.hpp"

namespace rollfem::profiles {

/// The least of some values of `smoothing` that explains all kinks and steps, where their number
/// suggests scatter; otherwise 0.
double least_smoothing(const ProfilePoints& points, const contact::ProfileSource& source);

/// Parameters of kinks beyond those that a file may have by default; of points that share one the
/// middle.
std::vector<double> kinks_of(const ProfileCurve& curve);

/// Bridges kinks and steps over `rounding`, or throws PointFault.
void treat_corners(ProfilePoints& points, const contact::ProfileSource& source);

}  // namespace rollfem::profiles
