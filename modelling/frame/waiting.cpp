// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/frame/waiting.hpp"

#include <algorithm>
#include <chrono>
#include <dlfcn.h>
#include <sched.h>
#include <string_view>
#include <sys/resource.h>
#include <thread>
#include <utility>

/// Replaces the function of the C library. Open MPI calls it all the time while it waits for a
/// message. A process that yields a busy core runs again when the others have had their slices,
/// whenever the message came, so that thousands of messages take minutes beside a build; one that
/// sleeps has its turn at once when it wakes. Naps of a quarter of the time waited so far delay a
/// message by no more than that. On a core that nobody else wants, seen by the lack of preemptions,
/// waking is slower than most messages, and only long waits sleep.
extern "C" int sched_yield() noexcept {
  using namespace std::chrono;
  constexpr microseconds without_nap(50), between_calls(20);
  constexpr milliseconds longest(1), without_nap_alone(5), shared_for(20);
  thread_local steady_clock::time_point begin, last;  // of one wait
  thread_local steady_clock::time_point shared_until;
  thread_local long preemptions = 0;
  const auto now = steady_clock::now();
  if (now - last > between_calls) begin = now;
  if (now - begin > without_nap) {
    rusage used{};
    getrusage(RUSAGE_THREAD, &used);
    if (std::exchange(preemptions, used.ru_nivcsw) != used.ru_nivcsw)
      shared_until = now + shared_for;
    if (now < shared_until || now - begin > without_nap_alone)
      std::this_thread::sleep_for(std::min<nanoseconds>((now - begin) / 4, longest));
  }
  last = steady_clock::now();
  return 0;
}

namespace rollfem::modelling {

std::string library_that_waits() {
  Dl_info found{};
  if (dladdr(reinterpret_cast<const void*>(&library_that_waits), &found) == 0) return {};
  const std::string_view file(found.dli_fname);
  return file.find(".so") == file.npos ? std::string() : std::string(file);
}

}  // namespace rollfem::modelling
