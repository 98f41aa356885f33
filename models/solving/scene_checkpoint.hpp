// SPDX-License-Identifier: LGPL-2.1-or-later
// The checkpoint of one scene of a case with profiles: record names begin with the patch, so that
// patches do not resume from each other's load points.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "contact/scene/patch_geometry.hpp"

#include <optional>
#include <string>

namespace rollfem::modelling {

class SceneCheckpoint : public contact::Checkpoint {
 public:
  /// `folder` may be null: nothing is stored or found. Without a place, names stay unchanged.
  SceneCheckpoint(contact::Checkpoint* folder, const std::optional<contact::ContactPlace>& place);
  std::optional<std::string> find(const std::string& name) override;
  void keep(const std::string& name, const std::string& record) override;

 private:
  contact::Checkpoint* folder_;
  std::string prefix_;
};

}  // namespace rollfem::modelling
