// How often the error bars of the model halfspace hold: random scenes (tests/support/
// random_scenes.hpp) on 12 to 32 elements across the patch, each against a grid four times finer.
// Prints the table of docs/accuracy.md, and to stderr every scene that has no result. Call:
// benchmark_bar_coverage [rows] SEED FIRST NUMBER [ACROSS ...], e.g. 8 0 1000 12 16 20
// With `rows` every number is printed (error, bar, bar on the fine grid) in place of the table.
#include "tests/support/bar_coverage.hpp"

#include <fmt/format.h>

#include <cstdlib>

using namespace rollfem;

namespace {

void print_table(const testing::BarSamples& samples) {
  fmt::print(
      "| quantity | numbers | held, % | median of bar / error | median of bar on the fine grid / "
      "bar |\n|---|---|---|---|---|\n");
  for (const auto& [name, of_name] : samples) {
    const testing::BarRow row(of_name);
    fmt::print("| `{}` | {} | {:.1f} | {:.1f} | {:.2f} |\n", name, row.count, 100.0 * row.covered,
               row.bar_over_error, row.fine_bar_over_bar);
  }
}

void print_rows(const testing::BarSamples& samples, unsigned number, int across) {
  for (const auto& [name, of_name] : samples)
    for (const testing::BarSample& sample : of_name)
      fmt::print("{} {} {} {:.6g} {:.6g} {:.6g}\n", number, across, name, sample.error, sample.bar,
                 sample.fine_bar);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  const bool rows = count > 1 && std::string(words[1]) == "rows";
  if (rows) {
    --count;
    ++words;
  }
  if (count < 4) {
    fmt::print(stderr, "call: benchmark_bar_coverage [rows] SEED FIRST NUMBER [ACROSS ...]\n");
    return 2;
  }
  const auto whole = [&](int word) { return static_cast<unsigned>(std::atoi(words[word])); };
  std::vector<int> sizes;
  for (int word = 4; word < count; ++word) sizes.push_back(std::atoi(words[word]));
  if (sizes.empty()) sizes = {12, 12, 16, 16, 20, 20, 24, 24, 32};
  testing::RandomScenes scenes(whole(1));
  testing::BarSamples samples;
  int solved = 0;
  for (unsigned number = whole(2); number < whole(2) + whole(3); ++number) {
    try {
      const testing::RandomScene random = scenes.scene(number);
      const int across = scenes.choose(sizes);
      // Stresses on the finest grids take far longer than the contact.
      testing::BarSamples of_scene;
      testing::add_scene(random, across, number % 6 == 0 && across <= 20, of_scene);
      if (rows) print_rows(of_scene, number, across);
      for (const auto& [name, of_name] : of_scene)
        samples[name].insert(samples[name].end(), of_name.begin(), of_name.end());
      ++solved;
    } catch (const std::exception& error) {
      fmt::print(stderr, "scene {}: {}\n", number, error.what());
    }
  }
  if (rows) return 0;
  fmt::print("seed {}, scenes {} to {}, {} solved\n\n", whole(1), whole(2), whole(2) + whole(3) - 1,
             solved);
  print_table(samples);
  return 0;
}
