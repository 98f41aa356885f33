// SPDX-License-Identifier: LGPL-2.1-or-later
// Number of allocations by rollfem_solve after its first call, counted by this program's heap.
#include "rollfem/rollfem.h"
#include "support/recorded.hpp"
#include "support/wheel_on_rail.hpp"
#include <atomic>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
constexpr bool counts = false;  // the heap is theirs, or another
#else
constexpr bool counts = true;
#endif

namespace {

std::atomic<long> allocations{0};

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(__GLIBC__)
extern "C" {
void* __libc_malloc(std::size_t size);  // NOLINT(bugprone-reserved-identifier): glibc's own
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
}
#endif

namespace {

long most_of(rollfem_side side) {
  char message[512];
  const Pair pair = make(defaults(side));
  long most = 0;
  struct Place {
    double shift, yaw;
  };
  // From the tread to the flange; on the right at 5 mm in two regions, which have a grid of their
  // own, and at 5.9 mm in two planes that share the load: the first turn takes what is kept.
  for (const bool counted : {false, true})
    for (const auto& [shift, yaw] : {Place{0.0, 0.0},
                                     {1.0, 8e-4},
                                     {2.0, 1.6e-3},
                                     {3.0, 2.4e-3},
                                     {4.0, 3.2e-3},
                                     {5.0, 4e-3},
                                     {5.9, 0.03},
                                     {6.0, 4.8e-3},
                                     {7.0, 5.6e-3},
                                     {8.0, 6.4e-3}}) {
      const double roll = -2.5e-5 * shift * shift;
      const rollfem_state state = {sizeof state, shift, yaw,  roll, 20e3,
                                   30.0,         0.0,   43.5, 50e3, ROLLFEM_VERTICAL_FORCE,
                                   0.0,          0.0};
      auto result = sized<rollfem_result>();
      const long before = allocations;
      EXPECT_EQ(rollfem_solve(pair.get(), &state, &result, message, sizeof message), ROLLFEM_OK)
          << message;
      if (counted) most = std::max(most, allocations - before);
    }
  return most;
}

TEST(CAllocations, OfACallAfterTheFirst) {
  if (!counts) GTEST_SKIP() << "this heap cannot be counted";
  const long most = std::max(most_of(ROLLFEM_LEFT), most_of(ROLLFEM_RIGHT));
  record("allocations", static_cast<double>(most));
  EXPECT_LE(most, 160);
}

}  // namespace
