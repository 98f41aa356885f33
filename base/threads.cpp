// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/threads.hpp"

#include "base/available_memory.hpp"
#include "base/errors.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <thread>
#include <utility>
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace rollfem::contact {

namespace {

// ThreadSanitizer does not see how libtbb, which is built without it, hands parts over and waits
// for them, so these calls tell it: what one thread did before release() has happened before what
// another one does after acquire(). A part may read its caller's data only after acquire().
char handed_over;
#ifdef __SANITIZE_THREAD__
void release(void* at) {
  __tsan_release(at);
}
void acquire(void* at) {
  __tsan_acquire(at);
}
#else
void release(void*) {}
void acquire(void*) {}
#endif

/// oneTBB starts no more threads than the machine has cores unless it is asked to.
struct Arena {
  explicit Arena(int the_number) : number(the_number) {
    constexpr auto most_threads = tbb::global_control::max_allowed_parallelism;
    if (number < 2) return;
    most.emplace(most_threads, std::max(static_cast<std::size_t>(number),
                                        tbb::global_control::active_value(most_threads)));
    tasks.emplace(number);
  }
  int number;
  std::optional<tbb::global_control> most;
  std::optional<tbb::task_arena> tasks;  ///< none: this thread alone
};

/// Of computations outside any Threads.
Arena& whole_arena() {
  static Arena arena(allowed_threads());
  return arena;
}

/// The arena of this thread's computations: of the innermost Threads, or of the part that it works
/// on; null: the whole one.
thread_local Arena* here = nullptr;

Arena& arena_here() {
  return here != nullptr ? *here : whole_arena();
}

/// Whether this thread works on a part of a loop.
thread_local bool within_part = false;

/// The threads that take over a part work for its arena.
class Inside {
 public:
  explicit Inside(Arena& arena, bool part = within_part)
      : before_(std::exchange(here, &arena)), part_before_(std::exchange(within_part, part)) {}
  ~Inside() {
    here = before_;
    within_part = part_before_;
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

 private:
  Arena* before_;
  bool part_before_;
};

/// All threads treat subnormal numbers as the one that hands out the parts.
constexpr auto as_this_thread =
    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings;

/// The exception of the smallest index so far; parts beyond it need not start.
class FirstError {
 public:
  bool before(std::size_t index) const { return index_.load() < index; }
  void take(std::size_t index) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (before(index)) return;
    index_ = index;
    error_ = std::current_exception();
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<std::size_t> index_{std::numeric_limits<std::size_t>::max()};
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

int allowed_threads() {
  static const int allowed = [] {
    const char* wanted = std::getenv("OMP_NUM_THREADS");
    const long number = wanted != nullptr ? std::strtol(wanted, nullptr, 10) : 0;
    if (number > most_threads)
      throw InputError(
          fmt::format("OMP_NUM_THREADS = {}; allowed: 1 to {}; do: correct or unset it",
                      printable(wanted), most_threads));
    if (number > 0) return static_cast<int>(number);
    // The first number already includes affinity.
    return std::max(1, std::min(static_cast<int>(std::thread::hardware_concurrency()),
                                allowed_cores("/proc", "/sys/fs/cgroup")));
  }();
  return allowed;
}

int allowed_cores(const std::string& proc, const std::string& cgroup) {
  double share = std::numeric_limits<int>::max();
  for_each_cgroup(proc, cgroup, "cpu", [&](const std::string& group, bool unified) {
    std::ifstream both(group + "/cpu.max");  // "max 100000" where there is no limit
    double quota = 0.0, period = 0.0;
    if (unified && !(both >> quota >> period)) return;
    if (!unified) {
      quota = first_number(group + "/cpu.cfs_quota_us");  // -1 where there is no limit
      period = first_number(group + "/cpu.cfs_period_us");
    }
    if (quota > 0.0 && period > 0.0 && std::isfinite(period))
      share = std::min(share, quota / period);
  });
  return std::max(1, static_cast<int>(std::lround(share)));
}

int threads() {
  return arena_here().number;
}

Threads::Threads(int number) : before_(here) {
  static Arena alone(1);  // so that nothing is allocated
  if (number > 1) arena_ = std::make_shared<Arena>(number);
  here = number > 1 ? static_cast<Arena*>(arena_.get()) : &alone;
}

Threads::~Threads() {
  here = static_cast<Arena*>(before_);
}

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (count < 2 || threads() < 2) {
    for (std::size_t k = 0; k < count; ++k) work(k);
    return;
  }
  Arena& arena = arena_here();
  FirstError error;
  const auto part = [&](std::size_t k) {
    acquire(&handed_over);
    if (error.before(k)) return;
    const Inside inside(arena, true);
    try {
      work(k);
    } catch (...) {
      error.take(k);
    }
    release(&error);
  };
  tbb::task_group_context context(tbb::task_group_context::bound, as_this_thread);
  const bool nested = within_part;
  const auto loop = [&] {
    tbb::parallel_for(std::size_t{0}, count, part, tbb::simple_partitioner(), context);
  };
  // Within a part a thread that waits takes up no other part of the outer loop, whose memory and
  // time would add to this one's. A thread that waits for the outermost loop helps within its
  // parts.
  release(&handed_over);
  arena.tasks->execute([&] {
    if (nested)
      tbb::this_task_arena::isolate(loop);
    else
      loop();
  });
  acquire(&error);
  error.rethrow();
}

void isolated(const std::function<void()>& work) {
  tbb::this_task_arena::isolate(work);
}

void within_threads(const std::function<void()>& work) {
  Arena& arena = arena_here();
  tbb::task_group_context context(tbb::task_group_context::bound, as_this_thread);
  // A task, from which others inherit the treatment of subnormal numbers.
  const auto run = [&] {
    tbb::task_group group(context);
    group.run_and_wait([&] {
      const Inside inside(arena);
      work();
    });
  };
  if (arena.tasks)
    arena.tasks->execute(run);
  else
    tbb::task_arena(1).execute(run);
}

void for_each_piece(std::ptrdiff_t size, std::ptrdiff_t piece,
                    const std::function<void(std::ptrdiff_t, std::ptrdiff_t)>& work) {
  for_each_index(static_cast<std::size_t>((size + piece - 1) / piece), [&](std::size_t k) {
    const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(k) * piece;
    work(begin, std::min(begin + piece, size));
  });
}

}  // namespace rollfem::contact
