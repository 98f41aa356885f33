// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs two halves of a computation in parallel where machine and user allow it. Nothing is summed
// across threads: results are bitwise identical with one and two threads.
#pragma once

#include <future>
#include <string>
#include <utility>

namespace rollfem::contact {

/// Number of threads for a single solution: OMP_NUM_THREADS if set, otherwise the cores available
/// by affinity and control groups; 1 under a SingleThread.
int threads();

/// Cores that control groups allow this process, at least 1; a very large number without a limit.
/// The folders replace /proc and /sys/fs/cgroup.
int allowed_cores(const std::string& proc, const std::string& cgroup);

/// While one exists, solutions on the thread that created it use no other thread: for callers that
/// solve several in parallel.
class SingleThread {
 public:
  SingleThread();
  ~SingleThread();
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;
};

/// While one exists, the thread that created it may use this many threads, taking over those of
/// waiting threads.
class LentThreads {
 public:
  explicit LentThreads(int count);
  ~LentThreads();
  LentThreads(const LentThreads&) = delete;
  LentThreads& operator=(const LentThreads&) = delete;

 private:
  int before_;
};

/// Runs both, in parallel if `at_once` and threads are available. Starting a thread takes about
/// 0.03 ms.
template <class First, class Second>
void both(bool at_once, First&& first, Second&& second) {
  if (!at_once || threads() < 2) {
    first();
    second();
    return;
  }
  auto other = std::async(std::launch::async, std::forward<Second>(second));
  first();
  other.get();
}

}  // namespace rollfem::contact
