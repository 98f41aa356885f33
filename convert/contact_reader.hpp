// Reader of CONTACT's input files (E. A. H. Vollebregt, user guide for CONTACT; module 1, wheel and
// rail, and module 3, single contacts). It reads everything, including what has no equivalent here.
#pragma once

#include "convert/contact_case.hpp"
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::convert {

/// All cases up to module number 0 or the end. `name` stands in messages for the file. Throws
/// contact::InputError naming file, line, what was expected and what to do.
std::vector<ContactCase> read_contact_file(std::string_view text, const std::string& name);

}  // namespace rollfem::convert
