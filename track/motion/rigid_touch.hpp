// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact points of the rigid, unloaded wheels of a wheelset as it moves sideways: the rolling
// radii and contact angles for the conicity (wheelset_motion.hpp).
#pragma once

#include "case/case.hpp"
#include "result/rigid_wheelset.hpp"
#include "track/placement/wheelset_pose.hpp"

#include <optional>
#include <vector>

namespace rollfem::track {

using contact::RigidWheelset;

/// Touching points at the given shifts, without yaw and conicity; roll from the case, otherwise
/// computed. Ends before the first shift at which a wheel leaves its rail or its profile ends.
/// Throws as find_pose at the first shift.
std::vector<RigidWheelset> rigid_touches(const contact::Case& input, const SearchScene& search,
                                         const std::vector<double>& lateral_shifts);

/// Distance of the running circles, mm: 1500 on a gauge of 1435.
double contact_distance(const contact::Track& track);

/// Rows from the middle to `reach` mm, every `step` mm; the other side is the mirror image.
std::vector<RigidWheelset> wheelset_rows(const contact::Case& input, const SearchScene& search,
                                         double reach, double step);

/// At any shift (mm, either side), with the conicity at its amplitude from the radii of `rows`,
/// which begin in the middle; empty where a wheel leaves its rail or its profile ends.
std::optional<RigidWheelset> wheelset_row(const contact::Case& input, const SearchScene& search,
                                          const std::vector<RigidWheelset>& rows, double shift);

}  // namespace rollfem::track
