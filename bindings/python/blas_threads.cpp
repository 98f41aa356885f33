// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/python/caller.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <mutex>

namespace rollfem::python {

namespace {

std::mutex guard;
int alive = 0, before = 0;

/// Whether rollfem may set the number of threads. Checked once, because opening the finite-element
/// library sets the variable too.
bool is_ours() {
  static const bool ours = std::getenv("OPENBLAS_NUM_THREADS") == nullptr;
  return ours;
}

/// Null if no OpenBLAS is loaded. All Debian variants share one name.
template <class Function>
Function of_openblas(const char* name) {
  void* library = dlopen("libopenblas.so.0", RTLD_LAZY | RTLD_NOLOAD);
  if (library == nullptr) return nullptr;
  const auto function = reinterpret_cast<Function>(dlsym(library, name));
  dlclose(library);  // still held by whoever loaded it
  return function;
}

void set_threads(int number) {
  if (const auto set = of_openblas<void (*)(int)>("openblas_set_num_threads")) set(number);
}

}  // namespace

OneBlasThread::OneBlasThread() {
  const std::lock_guard<std::mutex> lock(guard);
  if (!is_ours() || alive++ > 0) return;
  const auto get = of_openblas<int (*)()>("openblas_get_num_threads");
  before = get != nullptr ? get() : 0;
  set_threads(1);
}

OneBlasThread::~OneBlasThread() {
  const std::lock_guard<std::mutex> lock(guard);
  if (is_ours() && --alive == 0 && before > 0) set_threads(before);
}

}  // namespace rollfem::python
