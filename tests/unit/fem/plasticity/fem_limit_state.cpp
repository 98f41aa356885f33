// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/yielding_bodies.hpp"

#include <gtest/gtest.h>

using namespace rollfem;

namespace {

/// A streamline of which xx causes stress and settles, the back stress too, while xz grows for
/// ever: by more, the less xx there is.
constexpr double settled_xx = 2e-3, settled_back = 80.0, modulus = 1e5;

void pass(fem::PlasticState& state) {
  state.strain[0] = settled_xx + 0.9 * (state.strain[0] - settled_xx);
  state.back[1][5] = settled_back + 0.7 * (state.back[1][5] - settled_back);
  state.strain[5] += 1e-3 + settled_xx - state.strain[0];
  state.accumulated += 2e-3;
}

fem::Deviator residual(const fem::PlasticState& state) {
  return {-modulus * state.strain[0], 0.5 * modulus * state.strain[0], 0.0, 0.0, 0.0, 0.0};
}

}  // namespace

TEST(LimitState, IsReachedWhileStrainThatCausesNoStressGrows) {
  fem::LimitState limit;
  std::vector<fem::PlasticState> states(1);
  for (int cycle = 0; cycle < 4; ++cycle) {
    pass(states[0]);
    limit.approach({residual(states[0])}, states);
  }
  EXPECT_NEAR(states[0].strain[0], settled_xx, 1e-9);  // without it 0.34 of it away
  EXPECT_NEAR(states[0].back[1][5], settled_back, 1e-4);
  const double before = states[0].strain[5];
  pass(states[0]);
  EXPECT_NEAR(states[0].strain[5] - before, 1e-3, 1e-9);
}

// A run that is resumed goes on with the same numbers.
TEST(LimitState, GoesOnFromItsRecord) {
  fem::LimitState limit, resumed;
  std::vector<fem::PlasticState> states(1);
  for (int cycle = 0; cycle < 2; ++cycle) {
    pass(states[0]);
    limit.approach({residual(states[0])}, states);
  }
  contact::Record written;
  limit.exchange(written);
  contact::Record read(written.bytes());
  resumed.exchange(read);
  auto others = states;
  pass(states[0]);
  pass(others[0]);
  limit.approach({residual(states[0])}, states);
  resumed.approach({residual(others[0])}, others);
  EXPECT_EQ(states[0].strain, others[0].strain);
  EXPECT_EQ(states[0].back, others[0].back);
}
