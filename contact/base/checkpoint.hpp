// SPDX-License-Identifier: LGPL-2.1-or-later
// Finished load points that outlive the run. The models only keep and find records here; the
// program decides where they are (postprocess/files/checkpoint_folder.hpp).
#pragma once

#include <optional>
#include <string>

namespace rollfem::contact {

class Checkpoint {
 public:
  virtual ~Checkpoint() = default;
  /// Data stored under this name by an earlier run of the same case. Names are file names: letters,
  /// digits, '.', '-'.
  virtual std::optional<std::string> find(const std::string& name) = 0;
  /// Never throws: a run must not fail because its checkpoint cannot be written.
  virtual void keep(const std::string& name, const std::string& record) = 0;
};

}  // namespace rollfem::contact
