// SPDX-License-Identifier: LGPL-2.1-or-later
// Calls of the library that take time: other Python threads run meanwhile, and progress is told to
// a Python function, whose exceptions end the call.
#pragma once

#include "base/threads.hpp"
#include "bindings/python/bindings.hpp"

#include <atomic>
#include <optional>
#include <unistd.h>
#include <utility>

namespace rollfem::python {

/// Made with the GIL. A daemon thread that takes the GIL again while the interpreter ends would be
/// ended within frames that must not be unwound; it waits for the end of the process instead.
class Returning {
 public:
  void wait_if_too_late() const {
    while (!ending_ && _Py_IsFinalizing() != 0) ::pause();
  }

 private:
  bool ending_ = _Py_IsFinalizing() != 0;  ///< by this thread
};

/// The GIL is free while this object lives.
class FreeGil {
 public:
  FreeGil() : state_(PyEval_SaveThread()) {}
  ~FreeGil() {
    returning_.wait_if_too_late();
    PyEval_RestoreThread(state_);
  }
  FreeGil(const FreeGil&) = delete;
  FreeGil& operator=(const FreeGil&) = delete;

 private:
  Returning returning_;
  PyThreadState* state_;
};

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
    returning_.wait_if_too_late();
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
  Returning returning_;
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
    const FreeGil free;
    const OneBlasThread one_thread;
    const contact::Threads threads(wanted_threads());
    return work(caller.progress());
  } catch (const Ended&) {
    caller.rethrow();
    throw;
  }
}

}  // namespace rollfem::python
