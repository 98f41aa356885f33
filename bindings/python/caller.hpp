// SPDX-License-Identifier: LGPL-2.1-or-later
// Calls of the library that take time: other Python threads run meanwhile, and progress is told to
// a Python function, whose exceptions end the call.
#pragma once

#include "bindings/python/bindings.hpp"
#include "contact/base/threads.hpp"

#include <atomic>
#include <optional>
#include <utility>

namespace rollfem::python {

/// A Python exception on its way through the solver: no std::exception, which some model might take
/// for one of its own.
struct Ended {};

/// Calls back into Python, and remembers what was raised there.
class Caller {
 public:
  explicit Caller(py::object callback) : callback_(std::move(callback)) {}

  Progress progress() {
    return [this](const ProgressEvent& event) { tell(event); };
  }
  /// Throws what was raised. With the GIL.
  void rethrow() {
    if (raised_) throw std::move(*raised_);
  }

 private:
  void tell(const ProgressEvent& event) {
    const py::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!callback_.is_none()) callback_(event);
    } catch (py::error_already_set& error) {
      if (!raised_) raised_.emplace(std::move(error));
      throw Ended();
    }
  }

  py::object callback_;
  std::optional<py::error_already_set> raised_;
};

/// Limits OpenBLAS to one thread while any of these objects lives; afterwards the previous number.
/// The program sets OPENBLAS_NUM_THREADS before loading the library; in Python, numpy has already
/// loaded it with one thread per core. These threads wait actively for each other, which on a busy
/// machine turns seconds into minutes. Does nothing if the user has set that variable or no
/// OpenBLAS is loaded.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

/// Threads of a call: what rollfem.threads has set, at first the caller's alone.
inline std::atomic<int>& wanted_threads() {
  static std::atomic<int> wanted{1};
  return wanted;
}

/// work(progress) without the GIL; `callback`: a Python function or None.
template <class Work>
auto without_gil(py::object callback, const Work& work) {
  Caller caller(std::move(callback));
  try {
    const py::gil_scoped_release free;
    const OneBlasThread one_thread;
    const contact::Threads threads(wanted_threads());
    return work(caller.progress());
  } catch (const Ended&) {
    caller.rethrow();
    throw;
  }
}

}  // namespace rollfem::python
