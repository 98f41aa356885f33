// SPDX-License-Identifier: LGPL-2.1-or-later
// Roots between two arguments: known ones, in either order, at a jump, and functions without a
// root.
#include "base/root.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"

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
  EXPECT_TRUE(says(failure([](double x) { return x + 1.0; }),
                   "roll of the wheelset: no change of sign between 0 and 1: 1, 2; do: "));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure([=](double x) { return x < 0.2   ? -1.0
                                           : x > 0.8 ? 1.0
                                                     : nan; }).substr(0, 40),
            "roll of the wheelset: the function is na");
}

TEST(RootFrom, IsFoundOnEitherSideAlsoWhereTheFunctionSaturates) {
  int calls = 0;
  const auto root_of = [&](const std::function<double(double)>& f) {
    const auto counted = [&](double x) {
      ++calls;
      const double value = f(x);
      return std::abs(value) < 1e-9 ? 0.0 : value;
    };
    const double at_start = counted(0.0), next = at_start > 0.0 ? 1e-3 : -1e-3;
    return root_from(counted, 0.0, at_start, next, 0.1, 1e-9, "test").value();
  };
  EXPECT_NEAR(root_of([](double x) { return -std::tanh(x / 1e-3 - 2.0); }), 2e-3, 1e-9);
  EXPECT_NEAR(root_of([](double x) { return 0.004 - x; }), 4e-3, 1e-9);
  EXPECT_NEAR(root_of([](double x) { return -std::atan(x / 1e-5 + 40.0); }), -4e-4, 1e-9);
  EXPECT_LT(calls, 45);
}

TEST(RootFrom, StartThatIsARootIsKept) {
  const auto falling = [](double x) { return 0.01 - x; };
  EXPECT_EQ(root_from(falling, 0.01, 0.0, 0.02, 1.0, 1e-9, "test"), 0.01);
}

TEST(RootFrom, IsEmptyWithoutAChangeOfSign) {
  const auto one = [](double) { return 1.0; };
  EXPECT_FALSE(root_from(one, 0.0, 1.0, 1e-3, 0.1, 1e-9, "test"));
}

}  // namespace
