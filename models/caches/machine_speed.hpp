// SPDX-License-Identifier: LGPL-2.1-or-later
// The speed of this machine relative to the reference machine of the predicted run times, measured
// by `rollfem bench` and stored in the user's cache folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rollfem::modelling {

struct MachineSpeed {
  double times = 1.0;  ///< seconds on this machine per predicted second
  std::string made;    ///< UTC, ISO 8601
};

/// The file of this host (home folders may be shared); empty if there is no cache.
std::filesystem::path machine_speed_file();

/// Empty if `rollfem bench` was not run on this host with this version, or if there is no cache.
std::optional<MachineSpeed> machine_speed();

/// Throws contact::InputError when it cannot be written.
void keep_machine_speed(const std::filesystem::path& file, MachineSpeed speed);

}  // namespace rollfem::modelling
