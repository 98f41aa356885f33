// SPDX-License-Identifier: LGPL-2.1-or-later
// Finished load points that outlive the run. The models only keep and find records here; the
// program decides where they are (result/files/checkpoint_folder.hpp).
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace rollfem::contact {

class Checkpoint {
 public:
  virtual ~Checkpoint() = default;
  /// Data stored under this name by an earlier run of the same case. Names are file names: letters,
  /// digits, '.', '-'.
  virtual std::optional<std::string> find(const std::string& name) = 0;
  /// Reports a record that find() gave as damaged, because its content does not fit.
  virtual void refuse(const std::string& /*name*/) {}
  /// Never throws: a run must not fail because its checkpoint cannot be written.
  virtual void keep(const std::string& name, const std::string& record) = 0;
};

/// The records of a checkpoint whose names begin with `prefix`: those of one patch, or of one level
/// of a study.
class CheckpointPart : public Checkpoint {
 public:
  /// `whole` may be null: nothing is stored or found.
  CheckpointPart(Checkpoint* whole, std::string prefix)
      : whole_(whole), prefix_(std::move(prefix)) {}
  std::optional<std::string> find(const std::string& name) override {
    return whole_ == nullptr ? std::nullopt : whole_->find(prefix_ + name);
  }
  void refuse(const std::string& name) override {
    if (whole_ != nullptr) whole_->refuse(prefix_ + name);
  }
  void keep(const std::string& name, const std::string& record) override {
    if (whole_ != nullptr) whole_->keep(prefix_ + name, record);
  }

 private:
  Checkpoint* whole_;
  std::string prefix_;
};

}  // namespace rollfem::contact
