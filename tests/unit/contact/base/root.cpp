// SPDX-License-Identifier: LGPL-2.1-or-later
// Roots between two arguments: known ones, in either order, at a jump, and functions without a
// root.
#include "contact/base/root.hpp"

#include "contact/base/errors.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"
#include <cmath>
#include <limits>
#include <string>

using namespace rollfem;
using contact::bracketed_root;
using rollfem::testing::refusal;

namespace {

TEST(BracketedRoot, FindsKnownRootsToTheToleranceAskedFor) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
    const double least = std::max(tolerance, 1e-15);
    EXPECT_NEAR(bracketed_root([](double x) { return x * x - 2.0; }, 0.0, 2.0, tolerance, "root"),
                std::sqrt(2.0), least);
    EXPECT_NEAR(
        bracketed_root([](double x) { return std::exp(-x) - 1e-4; }, 0.0, 50.0, tolerance, "root"),
        std::log(1e4), 10.0 * least);
    // A triple root, where secants crawl.
    EXPECT_NEAR(
        bracketed_root([](double x) { return std::pow(x - 0.3, 3); }, -1.0, 1.0, tolerance, "root"),
        0.3, least);
  }
}

TEST(BracketedRoot, TakesTheEndsInEitherOrderAndARootAtAnEnd) {
  const auto rising = [](double x) { return x - 0.25; };
  EXPECT_DOUBLE_EQ(bracketed_root(rising, 0.0, 1.0, 0.0, "root"), 0.25);
  EXPECT_DOUBLE_EQ(bracketed_root(rising, 1.0, 0.0, 0.0, "root"), 0.25);
  EXPECT_EQ(bracketed_root(rising, 0.25, 1.0, 0.0, "root"), 0.25);
  EXPECT_EQ(bracketed_root(rising, -1.0, 0.25, 0.0, "root"), 0.25);
}

TEST(BracketedRoot, FindsAJump) {
  const auto jump = [](double x) { return x < 0.7 ? -1.0 : 5.0; };
  EXPECT_NEAR(bracketed_root(jump, 0.0, 100.0, 1e-13, "root"), 0.7, 1e-13);
}

TEST(BracketedRoot, TakesFewEvaluations) {
  int evaluations = 0;
  const auto counted = [&](double x) {
    ++evaluations;
    return std::tanh(3.0 * x) - 0.5;
  };
  EXPECT_NEAR(bracketed_root(counted, -2.0, 3.0, 1e-14, "root"), std::atanh(0.5) / 3.0, 1e-14);
  EXPECT_LE(evaluations, 15);  // halving takes 49
}

std::string failure(const std::function<double(double)>& f) {
  return refusal<contact::SolveError>(
      [&] { bracketed_root(f, 0.0, 1.0, 1e-9, "roll of the wheelset"); });
}

TEST(BracketedRoot, SaysWhatHasNone) {
  EXPECT_EQ(failure([](double x) { return x + 1.0; }),
            "roll of the wheelset: no change of sign between 0 and 1: 1, 2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure([=](double x) { return x < 0.2   ? -1.0
                                           : x > 0.8 ? 1.0
                                                     : nan; }).substr(0, 40),
            "roll of the wheelset: the function is na");
}

}  // namespace
