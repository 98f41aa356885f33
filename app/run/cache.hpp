// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem cache`.
#pragma once

#include <string>

namespace rollfem::app {

/// Lists what the model hybrid has stored, or removes it (`action` "clear") and says what that has
/// freed. Throws contact::InputError when something cannot be removed.
void cache(const std::string& action);

}  // namespace rollfem::app
