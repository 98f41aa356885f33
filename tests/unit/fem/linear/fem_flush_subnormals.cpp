// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers below the normal range: zero within the scope, themselves again after it.
#include "fem/linear/flush_subnormals.hpp"

#include "support/test.hpp"

namespace {

using rollfem::fem::FlushSubnormals;

/// As a processor computes it, not the compiler.
float half_of(float number) {
  volatile float value = number;
  value = value * 0.5F;
  return value;
}

TEST(FemFlushSubnormals, CountAsZeroOnlyWithinTheScope) {
  const float smallest_normal = 1.17549435e-38F;
#ifdef __SSE2__
  {
    const FlushSubnormals flush;
    EXPECT_EQ(half_of(smallest_normal), 0.0F);
    EXPECT_EQ(half_of(4.0F * smallest_normal), 2.0F * smallest_normal);
    { const FlushSubnormals inner; }
    EXPECT_EQ(half_of(smallest_normal), 0.0F) << "an inner scope ends its own alone";
  }
#endif
  EXPECT_GT(half_of(smallest_normal), 0.0F);
}

}  // namespace
