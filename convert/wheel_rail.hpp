// SPDX-License-Identifier: LGPL-2.1-or-later
// Module 1: wheel and rail with profiles.
#pragma once

#include "convert/equivalent.hpp"

namespace rollfem::convert {

/// The part of equivalent_of for these cases.
void fill_wheel_rail(const ContactCase& given, const std::string& profile_folder, Equivalent& made);

}  // namespace rollfem::convert
