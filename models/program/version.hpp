// SPDX-License-Identifier: LGPL-2.1-or-later
// Version of the program and the commit it was built from.
#pragma once

#include <string>

namespace rollfem::modelling {

std::string version();
/// "unknown" outside of a git checkout; ends in "-dirty" when files were changed.
std::string commit();

}  // namespace rollfem::modelling
