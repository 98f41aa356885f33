// SPDX-License-Identifier: LGPL-2.1-or-later
// Limits OpenBLAS to one thread while a case is solved. The program sets OPENBLAS_NUM_THREADS
// before loading the library; in Python, numpy has already loaded it with one thread per core.
// These threads wait actively for each other, which on a busy machine turns seconds into minutes.
#pragma once

namespace rollfem::python {

/// One thread while any of these objects lives; afterwards the previous number. Does nothing if the
/// user has set OPENBLAS_NUM_THREADS or no OpenBLAS is loaded.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

}  // namespace rollfem::python
