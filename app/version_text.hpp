// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer to `rollfem --version`.
#pragma once

#include <string>

namespace rollfem::app {

/// What --version prints: version and commit on the first line, then features and the versions of
/// libraries. Opens the finite-element library, and says why where that fails.
std::string version_text();

}  // namespace rollfem::app
