// SPDX-License-Identifier: LGPL-2.1-or-later
// Places and forces on the track, in CONTACT's frames and a client's units. Axes x forward, y to
// the right, z down. The track's origin moves with the wheelset.
#pragma once

#include "bindings/contact/problem.hpp"

#include <vector>

namespace rollfem::addon {

/// Along a profile from y = 0, mm, in CONTACT's order of its points: y ascends on a rail and
/// descends on a wheel.
double arc_length(const profiles::ProfileCurve& curve, bool wheel, double y);

/// y and z on the track of a point of the wheel's profile, mm.
std::array<double, 2> on_track(const Problem& problem, const Patch& patch, double y, double z);

/// Of cntc_getcontactlocation.
std::vector<double> location_of(Problem& problem, const Patch& patch);

/// Of cntc_getglobalforces: forces and moments on the output body in four frames.
std::vector<double> global_forces(const Problem& problem, const std::vector<Patch*>& patches);

}  // namespace rollfem::addon
