// SPDX-License-Identifier: LGPL-2.1-or-later
// Keeps OpenBLAS to one thread while a case is solved. The program sets OPENBLAS_NUM_THREADS before
// the library is loaded; in Python numpy has loaded it already, with as many threads as there are
// cores. They wait for each other actively, which on a busy machine takes minutes for seconds.
#pragma once

namespace rollfem::python {

/// One thread from the first of these that lives to the end of the last; then as many as before.
/// Does nothing where the user has set OPENBLAS_NUM_THREADS, or no OpenBLAS is loaded.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;
};

}  // namespace rollfem::python
