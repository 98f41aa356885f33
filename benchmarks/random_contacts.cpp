// SPDX-License-Identifier: LGPL-2.1-or-later
// Reliability and speed of solving random contacts (tests/support/random_contact.hpp). Prints one
// row of the table in docs/counts.md for every size, and every contact that is not solved or
// takes many steps. Every grid begins on coarser ones as in the models, or from scratch; friction
// may fall with the slip velocity, at once or with a memory, and layers lie between. Call:
// benchmark_random_contacts [scratch] [falling|memory] SEED FIRST ACROSS:NUMBER ...,
// e.g. 1 0 20:1000 40:300
#include <fmt/format.h>

#include "tests/support/random_contact.hpp"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace rollfem;

constexpr int many_steps = 12;

struct Tally {
  std::vector<int> steps, krylov;
  std::vector<int> outer;  ///< for unlike materials only
  int failed = 0;
  int chatter = 0;  ///< no stable state: no failure
  int beyond = 0;   ///< contacts with more than many_steps

  void add(const testing::RandomOutcome& outcome) {
    steps.push_back(outcome.newton_steps);
    krylov.push_back(outcome.krylov_iterations);
    if (outcome.outer_iterations > 0) outer.push_back(outcome.outer_iterations);
    failed += outcome.solved || outcome.chatters ? 0 : 1;
    chatter += outcome.chatters ? 1 : 0;
    beyond += outcome.newton_steps > many_steps ? 1 : 0;
  }
};

std::string quantiles(std::vector<int> values) {
  if (values.empty()) return "";
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    const auto place = static_cast<std::size_t>(part * static_cast<double>(values.size()));
    return values[std::min(place, values.size() - 1)];
  };
  return fmt::format("{} / {} / {}", at(0.5), at(0.99), values.back());
}

void print_row(const std::string& name, const Tally& tally) {
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, tally.steps.size(), tally.failed,
             tally.chatter, quantiles(tally.steps), tally.beyond, quantiles(tally.krylov),
             quantiles(tally.outer));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  auto start = testing::RandomStart::nested;
  if (count > 1 && std::string(words[1]) == "scratch") {
    start = testing::RandomStart::scratch;
    --count;
    ++words;
  }
  const std::string law = count > 1 ? words[1] : "";
  const bool falls = law == "falling" || law == "memory";
  if (falls) {
    --count;
    ++words;
  }
  if (count < 4) {
    fmt::print(stderr,
               "call: benchmark_random_contacts [scratch] [falling|memory] SEED FIRST "
               "ACROSS:NUMBER ...\n");
    return 2;
  }
  testing::RandomContacts contacts(static_cast<unsigned>(std::atoi(words[1])));
  auto number = static_cast<unsigned>(std::atoi(words[2]));
  fmt::print("seed {}, contacts from {} on, {}\n\n", words[1], number,
             start == testing::RandomStart::nested ? "on coarser grids first" : "from scratch");
  fmt::print(
      "| across | contacts | failures | no stable state | Newton steps: median / 99 % / largest | "
      "above {} | Krylov "
      "iterations: median / 99 % / largest | outer iterations of unlike materials: median / 99 % / "
      "largest |\n|---|---|---|---|---|---|---|---|\n",
      many_steps);
  Tally all;
  for (int word = 3; word < count; ++word) {
    int across = 0;
    int wanted = 0;
    if (std::sscanf(words[word], "%d:%d", &across, &wanted) != 2) {
      fmt::print(stderr, "{}: not of the form ACROSS:NUMBER\n", words[word]);
      return 2;
    }
    Tally tally;
    for (int k = 0; k < wanted; ++k, ++number) {
      const testing::RandomContact contact =
          falls ? contacts.falling_contact(number, across, law == "memory")
                : contacts.contact(number, across);
      const testing::RandomOutcome outcome = testing::run_random(contact, start);
      tally.add(outcome);
      all.add(outcome);
      if (!outcome.solved || outcome.newton_steps > many_steps)
        fmt::print(stderr, "contact {} at {} across, {}: {} steps, {}\n", number, across,
                   testing::name_of(contact.kind), outcome.newton_steps,
                   outcome.solved ? "solved" : outcome.message);
    }
    print_row(std::to_string(across), tally);
  }
  print_row("all", all);
  return all.failed == 0 ? 0 : 1;
}
