#include "contact/base/threads.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace rollfem::contact {

namespace {

thread_local int single_threads = 0;

int allowed_threads() {
  const char* wanted = std::getenv("OMP_NUM_THREADS");
  const int number = wanted != nullptr ? std::atoi(wanted) : 0;
  return number > 0 ? number : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

int threads() {
  static const int allowed = allowed_threads();
  return single_threads > 0 ? 1 : allowed;
}

SingleThread::SingleThread() {
  ++single_threads;
}

SingleThread::~SingleThread() {
  --single_threads;
}

}  // namespace rollfem::contact
