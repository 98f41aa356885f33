// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that yield in results.h5.
#pragma once

#include "contact/case/case.hpp"
#include "contact/result/yielded_section.hpp"
#include "postprocess/hdf5/hdf5_objects.hpp"

#include <vector>

namespace rollfem::postprocess {

/// The group `yielded` of a load point: the section behind the load; none without such bodies.
void write_yielded(hid_t point, const std::vector<contact::YieldedSection>& bodies);

/// Datasets of the group `case`: residual stress before the first pass, wherever the case has it
/// from; none of bodies without.
void write_stress_before(hid_t group, const contact::Case& input);

}  // namespace rollfem::postprocess
