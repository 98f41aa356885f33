// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress of a run on stderr: on a terminal one line that is overwritten and keeps counting
// seconds during long phases; elsewhere one plain line per finished stage (and per slow load
// point).
#pragma once

#include "base/progress.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace rollfem::modelling {

class ProgressDisplay {
 public:
  enum class Mode { silent, plain, terminal };

  explicit ProgressDisplay(Mode mode) : mode_(mode) {}
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// The mode for stderr: terminal or not.
  static Mode mode_of_stderr();

  void show(const contact::ProgressEvent& event);
  /// Erases an unfinished line, before other output.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void write(Clock::time_point now, bool complete);
  void clear_line();
  void tick();

  Mode mode_;
  std::mutex mutex_;  ///< guards everything below
  contact::ProgressEvent event_;
  std::string stage_;  ///< model and stage being timed
  Clock::time_point stage_begin_ = Clock::now();
  std::map<std::string, Clock::time_point> begins_;  ///< of every stage so far
  Clock::time_point last_shown_ = Clock::now();
  bool line_open_ = false;
  bool ended_ = false;
  std::condition_variable end_;
  std::thread ticking_;  ///< on a terminal, started with the first line
};

/// One line without control characters: seconds elapsed in the stage and, if its load points allow
/// an estimate, the remaining seconds.
std::string progress_line(const contact::ProgressEvent& event, double seconds);

}  // namespace rollfem::modelling
