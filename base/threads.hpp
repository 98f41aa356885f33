// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a computation side by side, on oneTBB. Every part is computed exactly as alone and put
// into its own place, and nothing is summed across threads: results are the same to the last bit
// for any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace rollfem::contact {

/// The largest number that a caller may ask for.
inline constexpr int most_threads = 1024;

/// Threads that this process may use: OMP_NUM_THREADS if set, otherwise the cores available by
/// affinity and control groups.
int allowed_threads();

/// Cores that control groups allow this process, at least 1; a very large number without a limit.
/// The folders replace /proc and /sys/fs/cgroup.
int allowed_cores(const std::string& proc, const std::string& cgroup);

/// Threads that computations of this thread may use: those of the innermost Threads, or all that
/// are allowed.
int threads();

/// While one exists, computations of the thread that created it use at most this many threads, and
/// no others with 1. The threads themselves start with the first work for them.
class Threads {
 public:
  explicit Threads(int number);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  void* before_;
  std::shared_ptr<void> arena_;  ///< null: this thread alone
};

/// Calls work(0), ... work(count - 1), side by side where threads are available, and returns after
/// the last. If some throw, the exception of the smallest index is thrown, as a loop would. May be
/// nested; parts may not wait for each other. A part costs about 0.005 ms, the first 0.1 ms a
/// thread.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work);

/// Calls work() so that libraries which use oneTBB themselves have these threads and no others.
void within_threads(const std::function<void()>& work);

/// Calls work() so that this thread, while it waits for others, runs no tasks but those of `work`:
/// the caller may hold a lock.
void isolated(const std::function<void()>& work);

/// The same as for_each_index for pieces [begin, end) of a range. Their number depends on `size`
/// and `piece` alone, so that sums over a piece do not depend on the number of threads.
void for_each_piece(std::ptrdiff_t size, std::ptrdiff_t piece,
                    const std::function<void(std::ptrdiff_t, std::ptrdiff_t)>& work);

}  // namespace rollfem::contact
