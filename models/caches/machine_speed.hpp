// SPDX-License-Identifier: LGPL-2.1-or-later
// The speed of this machine relative to the one that run times are predicted for, as measured
// by `rollfem bench` and stored in the user's cache folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rollfem::modelling {

struct MachineSpeed {
  double times = 1.0;  ///< seconds here for a predicted one
  std::string made;    ///< UTC, ISO 8601
};

/// Where it is kept, by host, since homes are shared; empty where there is no cache.
std::filesystem::path machine_speed_file();

/// Nothing where `rollfem bench` was not run on this host with this version, or there is no cache.
std::optional<MachineSpeed> machine_speed();

/// Throws contact::InputError when it cannot be written.
void keep_machine_speed(const std::filesystem::path& file, const MachineSpeed& speed);

}  // namespace rollfem::modelling
