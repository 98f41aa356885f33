// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem cache`: the stored corrections of the model hybrid.
#pragma once

#include <string>

namespace rollfem::app {

/// Lists the stored corrections of the model hybrid, or removes them (`action` "clear") and prints
/// the freed space. Throws contact::InputError if a file cannot be removed.
void cache(const std::string& action);

}  // namespace rollfem::app
