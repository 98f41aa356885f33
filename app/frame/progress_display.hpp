// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress of a run on stderr: on a terminal one line that is overwritten
// and whose seconds keep counting during long phases; elsewhere one plain
// line per finished stage (and per slow load point).
#pragma once

#include "contact/base/progress.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace rollfem::app {

class ProgressDisplay {
 public:
  enum class Mode { silent, plain, terminal };

  explicit ProgressDisplay(Mode mode) : mode_(mode) {}
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// What stderr is.
  static Mode mode_of_stderr();

  void show(const contact::ProgressEvent& event);
  /// Takes an unfinished line away, before other output.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void write(Clock::time_point now, bool complete);
  void clear_line();
  void tick();

  Mode mode_;
  std::mutex mutex_;  ///< of everything below
  contact::ProgressEvent event_;
  std::string stage_;  ///< model and stage that the clock runs for
  Clock::time_point stage_begin_ = Clock::now();
  std::map<std::string, Clock::time_point> begins_;  ///< of every stage so far
  Clock::time_point last_shown_ = Clock::now();
  bool line_open_ = false;
  bool ended_ = false;
  std::condition_variable end_;
  std::thread ticking_;  ///< in a terminal, from the first line on
};

/// One line, no control characters: with the seconds that the stage has taken, and when that can be
/// told from its load points, those that it will take.
std::string progress_line(const contact::ProgressEvent& event, double seconds);

}  // namespace rollfem::app
