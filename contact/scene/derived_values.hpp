// What `check` prints beyond the keys: relative curvatures and combined constants.
#pragma once

#include "contact/case/case.hpp"

#include <string>

namespace rollfem::contact {

/// Multi-line text, laid out like describe() of contact/case/case_reader.hpp.
std::string derived_values(const Case& input);

}  // namespace rollfem::contact
