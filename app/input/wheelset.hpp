// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `wheelset`: rolling radii, contact angles and equivalent conicity of the rigid
// wheelset of a case over its lateral shift; no contact problem is solved.
#pragma once

#include "contact/solve/model.hpp"
#include "postprocess/write/output.hpp"
#include "track/placement/wheelset_pose.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

struct WheelsetRequest {
  std::string case_file;
  std::vector<std::string> changes;  ///< of keys, from --set
  std::string directory;             ///< empty: results/<case file without .toml>_wheelset
  bool json = false;                 ///< print JSON; files are then written only into `directory`
  double reach = 10.0;  ///< largest shift, mm, to the right; the other side is the mirror image
};

/// For a case with several lateral shifts: the position of the rigid wheelset at each of them, and
/// a sweep in small steps up to the largest.
void add_rigid_wheelset(const track::SearchScene& search, postprocess::RunRecord& record);

/// Prints the table, writes wheelset.csv and draws wheelset.svg. Throws contact::InputError if the
/// case has no profiles, contact::SolveError if the wheelset does not stand on the track.
void wheelset(const WheelsetRequest& request, const contact::ModelRegistry& models, bool& undrawn);

}  // namespace rollfem::app
