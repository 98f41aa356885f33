// SPDX-License-Identifier: LGPL-2.1-or-later
// Places and forces on the track, in CONTACT's frames and a client's units. Axes x forward, y to
// the right, z down. The track's origin moves with the wheelset.
#pragma once

#include "bindings/contact/problem.hpp"

#include <vector>

namespace rollfem::addon {

/// Of cntc_getcontactlocation; nan: the arc lengths SCP and the deflection of rails on springs.
std::vector<double> location_of(Problem& problem, const Patch& patch);

/// Of cntc_getglobalforces: forces and moments on the output body in four frames.
std::vector<double> global_forces(const Problem& problem, const std::vector<Patch*>& patches);

}  // namespace rollfem::addon
