// Values that are allowed and unlikely to be meant: lengths in m, loads in kN, creepages in per
// cent, spins in rad/m. A case with them is solved as it stands, and the user is told.
#pragma once

#include "contact/case/case.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

/// One sentence for each value that looks like a slip of units: file, key, value, why, what to do.
/// The limits and their reasons are in docs/troubleshooting.md.
std::vector<std::string> implausible_values(const Case& input);

}  // namespace rollfem::contact
