// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers below the normal range of single precision count as zero while one of these exists.
#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace rollfem::fem {

/// Every product of a smoother spreads a local load by one layer of cells, with values smaller by
/// powers of ten: far away they are below 1e-38, where the processor is about a hundred times
/// slower. Applies to this thread, and only on processors that support it.
class FlushSubnormals {
 public:
#ifdef __SSE2__
  FlushSubnormals() : before_(_mm_getcsr()) {
    constexpr unsigned int results_and_operands = 0x8040;
    _mm_setcsr(before_ | results_and_operands);
  }
  ~FlushSubnormals() {
    _mm_setcsr(before_);
  }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;

 private:
  unsigned int before_;
#endif
};

}  // namespace rollfem::fem
