// SPDX-License-Identifier: LGPL-2.1-or-later
// Roots of several falling functions at once: found to the tolerance, and refused without a change
// of sign.
#include "contact/base/errors.hpp"
#include "track/balance/root.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"
#include <cmath>

using rollfem::testing::refusal;
using rollfem::testing::says;
using rollfem::track::falling_roots;
using rollfem::track::RootOptions;

TEST(FallingRoots, AreFoundTogetherAlsoWhereFunctionsSaturate) {
  int calls = 0;
  const auto functions = [&](const std::vector<double>& at) {
    ++calls;
    return std::vector<double>{-std::tanh(at[0] / 1e-3 - 2.0), 0.004 - at[1],
                               -std::atan(at[2] / 1e-5 + 40.0)};
  };
  RootOptions options;
  options.value_tolerance = 1e-9;
  const auto roots = falling_roots(functions, {0.0, 0.0, 0.0}, options, "test");
  EXPECT_NEAR(roots[0], 2e-3, 1e-9);
  EXPECT_NEAR(roots[1], 4e-3, 1e-9);
  EXPECT_NEAR(roots[2], -4e-4, 1e-9);
  EXPECT_LT(calls, 20);
}

TEST(FallingRoots, StartThatIsARootIsKept) {
  const auto roots =
      falling_roots([](const std::vector<double>& at) { return std::vector<double>{0.01 - at[0]}; },
                    {0.01}, {}, "test");
  EXPECT_EQ(roots[0], 0.01);
}

TEST(FallingRoots, NoChangeOfSignIsSaid) {
  const auto one = [](const std::vector<double>&) { return std::vector<double>{1.0}; };
  EXPECT_TRUE(says(refusal<rollfem::contact::SolveError>(
                       [&] { falling_roots(one, {0.0}, {}, "rotation without torque"); }),
                   "rotation without torque: no change of sign"));
}
