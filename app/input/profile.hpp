// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `profile`: a wheel or rail profile as a table on the screen and in a file and
// as a figure, with its curvature as the contact sees it.
#pragma once

#include <string>

namespace rollfem::app {

struct ProfileRequest {
  std::string name;       ///< a built-in profile, a profile file, or a case file (.toml)
  bool wheel = false;     ///< the file is the profile of a wheel
  bool rail = false;      ///< the file is the profile of a rail
  std::string directory;  ///< empty: results/<name without extension>_profile
  bool json = false;      ///< print JSON; files are then written only into `directory`
};

/// Writes profile.csv and profile.svg (of a case wheel.csv, wheel.svg, rail.csv, rail.svg) and
/// prints the table. Throws contact::InputError and then writes nothing.
void profile(const ProfileRequest& request, bool& undrawn);

}  // namespace rollfem::app
