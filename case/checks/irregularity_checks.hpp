// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of flats, polygons, corrugation and dips.
#pragma once

#include "case/checks/case_checks.hpp"

namespace rollfem::contact {

/// Contradictory numbers, and shapes that are steeper than a surface along which a
/// wheel rolls. Throws InputError.
void check_irregularities(const GivenCase& given, const Case& input);

}  // namespace rollfem::contact
