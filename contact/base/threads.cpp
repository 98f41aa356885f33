// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/base/threads.hpp"

#include "contact/base/available_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <thread>
#include <utility>

namespace rollfem::contact {

namespace {

thread_local int single_threads = 0;
thread_local int lent_threads = 0;

int allowed_threads() {
  const char* wanted = std::getenv("OMP_NUM_THREADS");
  const int number = wanted != nullptr ? std::atoi(wanted) : 0;
  if (number > 0) return number;
  // The first number already includes affinity.
  return std::max(1, std::min(static_cast<int>(std::thread::hardware_concurrency()),
                              allowed_cores("/proc", "/sys/fs/cgroup")));
}

}  // namespace

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
  static const int allowed = allowed_threads();
  return single_threads > 0 ? 1 : std::max(allowed, lent_threads);
}

SingleThread::SingleThread() {
  ++single_threads;
}

SingleThread::~SingleThread() {
  --single_threads;
}

LentThreads::LentThreads(int count) : before_(std::exchange(lent_threads, count)) {}

LentThreads::~LentThreads() {
  lent_threads = before_;
}

}  // namespace rollfem::contact
