// SPDX-License-Identifier: LGPL-2.1-or-later
// Reader of CONTACT's input files. It reads everything, including features without equivalent here.
// A case includes all data kept from earlier cases.
#pragma once

#include "convert/contact_case.hpp"
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::convert {

/// Reads all cases up to module number 0 or the end. `name` represents the file in messages. Throws
/// contact::InputError with file, line, expected content and advice.
std::vector<ContactCase> read_contact_file(std::string_view text, const std::string& name);

}  // namespace rollfem::convert
