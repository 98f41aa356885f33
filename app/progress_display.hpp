// Progress of a run on stderr: in a terminal one line that is written over, elsewhere one plain
// line for every finished stage (and for slow load points within it).
#pragma once

#include "contact/base/progress.hpp"

#include <chrono>
#include <string>

namespace rollfem::app {

class ProgressDisplay {
 public:
  enum class Mode { silent, plain, terminal };

  explicit ProgressDisplay(Mode mode) : mode_(mode) {}
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// What stderr is.
  static Mode mode_of_stderr();

  void show(const contact::ProgressEvent& event);
  /// Takes an unfinished line away, before other output.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  Mode mode_;
  std::string stage_;  ///< model and stage that the clock runs for
  Clock::time_point stage_begin_ = Clock::now();
  Clock::time_point last_shown_;
  bool line_open_ = false;
};

/// One line, no control characters.
std::string progress_line(const contact::ProgressEvent& event, double seconds);

}  // namespace rollfem::app
