// SPDX-License-Identifier: LGPL-2.1-or-later
// Turns TOML into keys and values of a case file; private to contact/case.
#pragma once

#include "contact/case/checks/case_checks.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// Every key is known and its value allowed; whether they fit each other is not looked at. `file`
/// stands in messages; `models` are those that may be named, any where it is empty. Throws
/// InputError.
GivenCase read_toml(const std::string& text, const std::string& file,
                    const std::vector<std::string>& models = {});

/// Throws FileError: the file as a whole is wrong.
[[noreturn]] void fail_file(const std::string& file, const std::string& wrong,
                            const std::string& action);

}  // namespace rollfem::contact
