// SPDX-License-Identifier: LGPL-2.1-or-later
// Converts TOML into keys and values of a case file; private to case.
#pragma once

#include "case/checks/case_checks.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// Checks that every key is known and its value allowed, not their consistency. `file` is used in
/// messages; with `option` it is a change by --set as typed. Throws InputError.
GivenCase read_toml(const std::string& text, const std::string& file, const KnownNames& known = {},
                    bool option = false);

/// Throws FileError: the file as a whole is wrong.
[[noreturn]] void fail_file(const std::string& file, const std::string& wrong,
                            const std::string& action);

}  // namespace rollfem::contact
