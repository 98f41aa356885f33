// SPDX-License-Identifier: LGPL-2.1-or-later
// Work that a study stores for --resume: finished levels and the finished load points of the
// current level, each with its seconds.
#pragma once

#include "contact/base/checkpoint.hpp"
#include "models/fem/fem_library.hpp"
#include "postprocess/files/checkpoint_folder.hpp"
#include "postprocess/study/study.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace rollfem::modelling {

/// Load points of one level. Their records carry the seconds spent on the level so far, so that the
/// cost of a resumed level covers all calls.
class LevelPoints : public contact::Checkpoint {
 public:
  /// `folder` may be null: nothing is stored or found.
  LevelPoints(postprocess::CheckpointFolder* folder, std::string level);
  std::optional<std::string> find(const std::string& name) override;
  void keep(const std::string& name, const std::string& record) override;

  /// Seconds of earlier calls; known after the level is solved.
  double seconds_before() const { return before_; }
  /// Deletes the load points once the whole level is stored.
  void drop();

 private:
  using Clock = std::chrono::steady_clock;
  postprocess::CheckpointFolder* folder_;
  std::string prefix_;
  double before_ = 0.0;
  Clock::time_point begin_ = Clock::now();
};

/// Name of a stored level, from place, model and level as the study shows them.
std::string level_record_name(const std::string& place_key, const postprocess::StudySeries& series,
                              const postprocess::StudyLevel& level);

/// A level finished by an earlier call. With `everywhere` (parallel model) the call is collective
/// and uses the folder of process 0; null: each process for itself.
std::optional<postprocess::StudyLevel> find_level(postprocess::CheckpointFolder* folder,
                                                  const std::string& name,
                                                  const ParallelSession* everywhere);
void keep_level(postprocess::CheckpointFolder* folder, const std::string& name,
                const postprocess::StudyLevel& level);

}  // namespace rollfem::modelling
