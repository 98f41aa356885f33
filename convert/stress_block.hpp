// SPDX-License-Identifier: LGPL-2.1-or-later
// Points below the surface from the numbers by which CONTACT states them.
#pragma once

#include "convert/contact_case.hpp"
#include <array>
#include <vector>

namespace rollfem::convert {

/// Of kind ISUBS, 1 to 3, 5 to 7 or 9, with its numbers along x, y and z, over `elements`, MX and
/// MY. Ranges of elements that lack a number are empty.
StressBlock stress_block(int kind, const std::array<std::vector<double>, 3>& given,
                         const std::array<int, 2>& elements);

}  // namespace rollfem::convert
