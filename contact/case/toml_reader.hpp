// From TOML to the keys and values of a case file; private to contact/case.
#pragma once

#include "contact/case/case_checks.hpp"

#include <string>

namespace rollfem::contact {

/// Every key is known and its value allowed; whether they fit each other is not looked at. `file`
/// stands in messages. Throws InputError.
GivenCase read_toml(const std::string& text, const std::string& file);

/// Throws InputError: the file as a whole is wrong.
[[noreturn]] void fail_whole(const std::string& file, const std::string& wrong,
                             const std::string& action);

}  // namespace rollfem::contact
