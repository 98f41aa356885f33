// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists of numbers that CONTACT takes by a digit, with their names in its user guide.
#pragma once

#include "convert/contact_case.hpp"
#include <string>
#include <vector>

namespace rollfem::convert {

using Names = std::vector<std::string>;

/// Of a set of friction parameters by digit L; null: there is no such law.
const Names* friction_names(int law);
/// Of these numbers.
FrictionSet friction_set(int law, const double* values);

/// MX, MY and what follows by IPOTCN; null: there is no such potential contact area.
const Names* area_names(int ipotcn);

}  // namespace rollfem::convert
