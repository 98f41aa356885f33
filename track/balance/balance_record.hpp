// SPDX-License-Identifier: LGPL-2.1-or-later
// The result of the balance of one position, as a record for later runs.
#pragma once

#include "track/motion/placed_scenes.hpp"

#include <string>
#include <vector>

namespace rollfem::track {

/// `balanced`: made of the patches `placed` of one position by balanced_position().
std::string record_of_balance(const std::vector<PlacedScene>& placed,
                              std::vector<contact::Scene> balanced);

/// Restores the same scenes, bit for bit. Throws std::runtime_error for a record of other patches.
std::vector<contact::Scene> balance_of_record(const std::vector<PlacedScene>& placed,
                                              const std::string& record);

}  // namespace rollfem::track
