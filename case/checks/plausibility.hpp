// SPDX-License-Identifier: LGPL-2.1-or-later
// Warnings about values that are allowed but probably unintended: lengths in m, loads in kN,
// creepages in percent, spins in rad/m. The case is solved unchanged.
#pragma once

#include "case/case.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// One sentence for each value that looks like a unit mistake: file, key, value, reason, remedy.
/// The limits and their reasons are in docs/troubleshooting.md.
std::vector<std::string> implausible_values(const Case& input);

}  // namespace rollfem::contact
