// SPDX-License-Identifier: LGPL-2.1-or-later
// The rigid wheelset of a case beside its results.
#pragma once

#include "result/write/output.hpp"
#include "track/placement/wheelset_pose.hpp"

namespace rollfem::app {

/// For a case with several lateral shifts: the position of the rigid wheelset at each of them, and
/// a sweep in small steps up to the largest.
void add_rigid_wheelset(const track::SearchScene& search, result::RunRecord& record);

}  // namespace rollfem::app
