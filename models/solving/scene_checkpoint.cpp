// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/solving/scene_checkpoint.hpp"

#include <fmt/format.h>

namespace rollfem::modelling {

SceneCheckpoint::SceneCheckpoint(contact::Checkpoint* folder,
                                 const std::optional<contact::ContactPlace>& place)
    : folder_(folder) {
  if (place)
    prefix_ =
        fmt::format("{}-{}-{}-", place->left ? "left" : "right", place->position, place->patch);
}

std::optional<std::string> SceneCheckpoint::find(const std::string& name) {
  if (folder_ == nullptr) return std::nullopt;
  return folder_->find(prefix_ + name);
}

void SceneCheckpoint::keep(const std::string& name, const std::string& record) {
  if (folder_ != nullptr) folder_->keep(prefix_ + name, record);
}

}  // namespace rollfem::modelling
