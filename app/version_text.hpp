// SPDX-License-Identifier: LGPL-2.1-or-later
// What --version prints.
#pragma once

#include <string>

namespace rollfem::app {

/// Version and commit on the first line, then features and the versions of libraries. Opens the
/// finite-element library, and says why where that fails.
std::string version_text();

}  // namespace rollfem::app
