// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of a computation on several threads: every part once, errors as a loop would give them, no
// more threads than asked for, and pieces that depend on sizes alone.
#include "base/threads.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace rollfem::contact {
namespace {

/// Those that work on parts which last long enough to be shared.
std::set<std::thread::id> threads_at_work() {
  std::mutex mutex;
  std::set<std::thread::id> found;
  for_each_index(64, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::lock_guard<std::mutex> lock(mutex);
    found.insert(std::this_thread::get_id());
  });
  return found;
}

TEST(Threads, DoEveryPartOnceAlsoInsideAPart) {
  for (const int number : {1, 2, 3, 16}) {
    const Threads some(number);
    std::vector<std::atomic<int>> done(60);
    for_each_index(
        6, [&](std::size_t i) { for_each_index(10, [&](std::size_t j) { ++done[10 * i + j]; }); });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << number;
  }
}

TEST(Threads, AreAsManyAsAskedForAndOneIsTheCaller) {
  const Threads sixteen(16);
  EXPECT_EQ(threads(), 16);
  EXPECT_GT(threads_at_work().size(), 1U);
  {
    const Threads alone(1);
    EXPECT_EQ(threads(), 1);
    EXPECT_EQ(threads_at_work(), std::set<std::thread::id>{std::this_thread::get_id()});
  }
  const Threads three(3);
  EXPECT_LE(threads_at_work().size(), 3U);
  for_each_index(8, [](std::size_t) { EXPECT_EQ(threads(), 3); });
}

TEST(Threads, ThrowWhatTheFirstPartThrowsThatFails) {
  for (const int number : {1, 2, 16}) {
    const Threads some(number);
    try {
      for_each_index(40, [](std::size_t k) {
        if (k % 10 == 7) throw std::runtime_error(std::to_string(k));
      });
      ADD_FAILURE() << "no error";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7") << number;
    }
  }
}

TEST(Threads, RoundAsTheCallerDoes) {
  const Threads some(8);
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  std::array<int, 64> mode{};
  for_each_index(mode.size(), [&](std::size_t k) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    mode[k] = std::fegetround();
  });
  std::fesetround(before);
  for (const int found : mode) EXPECT_EQ(found, FE_UPWARD);
}

TEST(Threads, SumPiecesThatDoNotDependOnTheirNumber) {
  std::vector<double> values(10007);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = 1.0 / static_cast<double>(3 * k + 1);
  std::set<std::vector<double>> sums;
  for (const int number : {1, 2, 3, 16}) {
    const Threads some(number);
    std::vector<double> of_piece(11);
    for_each_piece(static_cast<std::ptrdiff_t>(values.size()), 1000, [&](auto begin, auto end) {
      of_piece.at(static_cast<std::size_t>(begin / 1000)) =
          std::accumulate(values.begin() + begin, values.begin() + end, 0.0);
    });
    sums.insert(of_piece);
  }
  EXPECT_EQ(sums.size(), 1U);
  for_each_piece(0, 5, [](auto, auto) { ADD_FAILURE() << "nothing to do"; });
}

}  // namespace
}  // namespace rollfem::contact
