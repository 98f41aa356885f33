// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs two halves of a computation in parallel where machine and user allow it. Nothing is summed
// across threads: results are bitwise the same with one thread and with two.
#pragma once

#include <future>
#include <string>
#include <utility>

namespace rollfem::contact {

/// How many threads a single solution may use: what OMP_NUM_THREADS says, else the cores that this
/// process may use by its affinity and its control groups; 1 under a SingleThread.
int threads();

/// The cores that control groups leave this process, at least 1; very many without a limit. The
/// folders stand for /proc and /sys/fs/cgroup.
int allowed_cores(const std::string& proc, const std::string& cgroup);

/// As long as one exists solutions of the thread that made it use no other thread: for callers
/// that solve several at once.
class SingleThread {
 public:
  SingleThread();
  ~SingleThread();
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;
};

/// As long as one exists the thread that made it may use so many threads, those of others that
/// wait.
class LentThreads {
 public:
  explicit LentThreads(int count);
  ~LentThreads();
  LentThreads(const LentThreads&) = delete;
  LentThreads& operator=(const LentThreads&) = delete;

 private:
  int before_;
};

/// Both, at once where `at_once` and there are threads. Starting a thread takes some 0.03 ms.
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
